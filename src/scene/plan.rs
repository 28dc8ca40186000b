//! Floorplans: what stands in the plane, and the graph of cells and portals made of it.
//!
//! A [`Plan`] is what any two-dimensional input states, its coordinates on one grid, zero-length
//! and repeated segments told apart. A [`PlanGraph`] is the adjacency graph of a plan's
//! subdivision (Teller and Séquin 1991, §2.3), or one that a file states.

mod doom;
mod generate;
mod graph;
mod read;
mod stated;

pub use doom::{AreaClaim, DoomOddity, DoomPlan, LineSides, plan_of_map};
pub use generate::{FloorplanOptions, generate_floorplan};
pub use graph::{Crossing, Crossings, PlanGraph, PlanPortal, PlanStabNode};
pub use read::{PlanInput, read_plan};
pub use stated::{
    Plan, PlanError, PlanErrorKind, PlanObject, PlanRepairs, PlanSegment, RawPlan, RawSegment,
};
