//! What floats propose: a point of the sequence's cone in R^6 or edges that rule it out, and lines.
//! Nothing here decides: each proposal goes through an exact check (`pvs::confirm`).

mod frame;
mod line;
mod norm;

pub(crate) use frame::{Bivector, Frame, half};
pub(crate) use line::propose_line;
pub(crate) use norm::{Half, NormPoint, Outcome, dot};
