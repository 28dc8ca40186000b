//! What floats propose: conditions that exclude each other, products that sum to the Klein form.
//!
//! Nothing here decides. What is proposed names unknowns of a linear system, which is solved in
//! exact integers and whose solution's signs are looked at.

mod excluding;
mod norm;
mod products;

pub(super) use excluding::excluding;
pub(crate) use norm::{Half, NormPoint, Outcome, dot};
pub(super) use products::{Pairs, basic_products};
