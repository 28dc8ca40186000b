//! Stabbing lines of portal sequences, and the lines that meet four lines.
//!
//! [`Stabber`] keeps the cone of a growing sequence of portals in space; its verdict is open (with
//! a rational witness), grazing (with a touching line) or blocked, each of the last two with a
//! certificate. [`hourglass`] does the same for segments in the plane, and [`transversals`]
//! answers four given lines.

mod certificate;
mod closed;
mod cone;
mod engine;
mod extremal;
mod few;
mod grazing;
pub mod hourglass;
mod line;
mod mask;
pub(crate) mod propose;
mod quadric;
mod ring;
mod sequence;
mod stabber;
#[cfg(test)]
mod tests;
pub mod transversals;
mod wedge;
mod witness;

pub use certificate::{Certificate, Condition, Factor, Product, QuadricProof, Term, certificate};
pub use closed::ClosedPortal;
pub use extremal::{EdgeName, ExtremalLine};
pub use few::{EdgeCone, EdgeLines, PortalEdge, Vector6, six_edges_exclude_lines};
pub use grazing::TouchingLine;
pub use line::StabLine;
pub use sequence::{Frame, Portal3, PortalError};
pub use stabber::{ConeShape, Stabber, Verdict, decide_open};
pub use witness::Witness;
