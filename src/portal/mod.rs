//! Portals between the leaves of a subdivision, what of them is inside, and leaks.
//!
//! A node's section is pushed down both of its subtrees and cut by their planes; what arrives in
//! an empty leaf on either side, less the thin polygons in the plane, becomes portals (Teller
//! 1992, section 8.2.5; Carr 2004, chapter 4). Cells are convex and a pair of leaves is separated
//! by exactly one node, so all portals of two leaves lie in one plane; where no thin polygon lies
//! between them they have one at most.

mod cells;
mod check;
pub mod doom;
mod enumerate;
mod flood;
pub mod plan;
mod population;
#[cfg(test)]
mod tests;
mod world;

pub use cells::{CellPortal, Cells};
pub use check::{PortalViolation, check};
pub use enumerate::{Portal, enumerate};
pub use flood::{Flood, Leak, flood};
pub use population::{Entry, Piece, Population};
pub use world::{WorldCells, WorldError, cells_of_world, divide_world, occluders_of};
