//! Scenes: what is asked about, validated, in exact coordinates.

mod graph;

pub use graph::{CellId, Portal, PortalGraph, PortalId};
