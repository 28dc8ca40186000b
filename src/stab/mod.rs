//! Which lines pass a sequence of portals: the exact verdict, with a witness.

mod certificate;
mod cone;
mod engine;
mod extremal;
mod grazing;
mod line;
mod mask;
mod quadric;
mod ring;
mod sequence;
mod stabber;
#[cfg(test)]
mod tests;
mod wedge;
mod witness;

pub use certificate::{Certificate, Condition, ConeSigns, Term};
pub use extremal::{EdgeName, ExtremalLine};
pub use line::StabLine;
pub use sequence::{Portal3, PortalError};
pub use stabber::{Stabber, Verdict, decide_open};
pub use witness::Witness;
