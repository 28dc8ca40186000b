//! A portal graph: convex cells joined by planar convex portals.
//!
//! Invariants: every portal is planar, convex and of positive area, its vertices counter-clockwise
//! as seen from the side of its cell `to`, so that its right-hand normal points from `from` into
//! `to`; every cell id is below the cell count; the two cells of a portal differ.

use crate::geom::BigPoint3;
use crate::num::Int;

/// A cell of a portal graph: its index in the graph.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct CellId(pub u32);

/// A planar portal of a portal graph: its index in [`PortalGraph::portals`].
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct PortalId(pub u32);

impl std::fmt::Debug for CellId {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "cell{}", self.0)
    }
}

impl std::fmt::Debug for PortalId {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "portal{}", self.0)
    }
}

/// A planar convex polygon between two cells.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Portal {
    /// The cell that the polygon's right-hand normal leaves.
    pub from: CellId,
    /// The cell that the polygon's right-hand normal enters.
    pub to: CellId,
    /// Indices into [`PortalGraph::vertices`], three or more, in the order of the file.
    pub vertices: Vec<u32>,
    /// The index of the input's portal that this is, or is a triangle of.
    pub source: u32,
}

/// A validated portal graph.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PortalGraph {
    /// Grid units in one world unit: a vertex's world coordinate is its grid coordinate divided
    /// by this.
    pub denominator: Int,
    /// The distinct vertices, in grid units.
    pub vertices: Vec<BigPoint3>,
    /// The portals, skew ones of the input replaced by the triangles of their fans.
    pub portals: Vec<Portal>,
    /// One name a cell: its number in a `.prt`, its own name in a JSON scene.
    pub cells: Vec<String>,
    /// The cell of each leaf of the input (the identity where the input has no leaves of its own).
    pub leaf_to_cell: Vec<CellId>,
    /// How many portals of the input were not planar and were triangulated.
    pub skew_portals: u32,
}
