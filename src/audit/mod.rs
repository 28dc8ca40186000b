//! Judging what others say: scores of candidate visibility sets.

pub mod check;
