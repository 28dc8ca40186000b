//! Exact visibility: what can be seen from where, with a proof for every answer.

pub mod geom;
pub mod num;
#[cfg(feature = "oracle")]
pub mod oracle;
pub mod scene;
