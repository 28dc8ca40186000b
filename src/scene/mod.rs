//! Scenes: what is asked about, validated, in exact coordinates.
//!
//! [`read_graph`] makes a validated [`PortalGraph`] of a file's bytes; past it there are no errors
//! of input. [`CellOrder`] tells which pairs of portals need the order of crossing as a condition
//! of its own. [`read_level`] makes the solids of a [`Level`] of a level's source; a [`World`] is
//! what any input of geometry puts into space, and [`read_world`] reads it.

mod build;
mod graph;
mod input;
pub mod level;
mod objects;
mod order;
pub mod plan;
mod polygon;
#[cfg(test)]
mod tests;
pub mod world;

pub use build::{RawGraph, RawPortal, SceneError, SceneErrorKind};
pub use graph::{CellId, Portal, PortalGraph, PortalId, Repairs, SmallGrid};
pub use input::{InputError, InputErrorKind, read_graph};
pub use level::{Level, LevelOptions, read_level};
pub use objects::ObjectGraph;
pub use order::CellOrder;
pub use world::{World, WorldOptions, read_world};
