//! Which lines pass a sequence of portals: the exact verdict, with a witness.

mod cone;
mod engine;
pub mod hourglass;
mod mask;
mod quadric;
mod ring;
mod sequence;
mod stabber;
#[cfg(test)]
mod tests;
pub mod transversals;
mod wedge;
mod witness;

pub use sequence::{Portal3, PortalError};
pub use stabber::{Stabber, decide_open};
pub use witness::Witness;
