//! What floats propose: lines, points of a sequence's cone, planes and edges worth looking at.
//!
//! Nothing here decides. A proposed line is checked by `sightline`, a set of excluding edges by
//! `predicates::gordan`, a supporting vertex by the signs of the plane through it.

mod cone;
mod frame;
mod line;
mod outline;
mod six;

pub(crate) use cone::{ConePoint, Proposal, RoughLines, SequenceCone};
pub(crate) use line::FrameLine;
pub(crate) use outline::{Outline, PlaneHints, supporting_vertex};
