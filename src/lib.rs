//! Exact visibility: what can be seen from where, with a proof for every answer.

pub mod audit;
pub mod cli;
pub mod construct;
pub mod csg;
pub mod draw;
pub mod eye;
pub mod forge;
pub mod formats;
pub mod geom;
pub mod motion;
pub mod num;
#[cfg(feature = "oracle")]
pub mod oracle;
pub mod portal;
pub mod predicates;
pub mod pvs;
pub mod report;
pub mod scene;
pub mod stab;
pub mod subdivision;
pub mod vectors;
pub mod verify;

/// Compiles and runs the README's example.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
