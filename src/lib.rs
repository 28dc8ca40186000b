//! Exact visibility: what can be seen from where, with a proof for every answer.

pub mod geom;
pub mod num;
pub mod predicates;
pub mod scene;
pub mod stab;
