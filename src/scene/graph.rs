//! A portal graph: convex cells joined by planar convex portals.
//!
//! Invariants: every portal is planar, strictly convex (no vertex on the line through its
//! neighbours) and of positive area, its vertices counter-clockwise
//! as seen from the side of its cell `to`, so that its right-hand normal points from `from` into
//! `to`; every cell id is below the cell count; the two cells of a portal differ.

use crate::geom::{Point3, RationalPoint3};
use crate::num::Int;

/// A cell of a portal graph: its index in the graph.
#[derive(Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
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
    /// The distinct vertices, in world units.
    pub vertices: Vec<RationalPoint3>,
    /// The portals, skew ones of the input replaced by the triangles of their fans.
    pub portals: Vec<Portal>,
    /// One name a cell: its number in a `.prt`, its own name in a JSON scene.
    pub cells: Vec<String>,
    /// The cell of each leaf of the input (the identity where the input has no leaves of its own).
    pub leaf_to_cell: Vec<CellId>,
    /// How many portals of the input were not planar and were triangulated.
    pub skew_portals: u32,
    /// What else of the input was repaired.
    pub repairs: Repairs,
}

/// All vertices of a graph in units of one grid.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SmallGrid {
    /// Grid units in one world unit: the lowest common denominator of the vertices.
    pub denominator: Int,
    /// The vertices, in grid units.
    pub points: Vec<Point3>,
}

/// The largest magnitude of a coordinate on a [`SmallGrid`] is 2^53.
const SMALL_BITS: u64 = 53;

impl PortalGraph {
    /// The vertices of a portal, in its order.
    pub fn corners<'a>(&'a self, portal: &'a Portal) -> impl Iterator<Item = &'a RationalPoint3> {
        portal.vertices.iter().map(|&vertex| &self.vertices[vertex as usize])
    }

    /// The vertices on their common grid, if all coordinates are small there. Files have such a
    /// grid; the meets of a level's planes as a rule have none of any sane size.
    pub fn small_grid(&self) -> Option<SmallGrid> {
        let nonzero =
            |vertex: &&RationalPoint3| vertex.numerators().iter().any(|c| *c != Int::ZERO);
        let coarsest = self.vertices.iter().filter(nonzero).map(|v| v.denominator().bits()).min();
        let mut denominator = Int::from(1);
        for vertex in &self.vertices {
            denominator = vertex.common_with(denominator);
            // A coordinate n/d that is not zero becomes n · denominator/d, which is more than
            // 2^(bits of denominator - 1 - bits of d): too much before the numbers grow long.
            if coarsest.is_some_and(|bits| denominator.bits() > bits + 1 + SMALL_BITS) {
                return None;
            }
        }
        let points = self.vertices.iter().map(|vertex| vertex.on_grid(&denominator).to_small());
        let points = points.collect::<Option<Vec<Point3>>>()?;
        Some(SmallGrid { denominator, points })
    }
}

/// How often each documented repair was made while a graph was read; none changes a planar
/// convex portal as a set of points.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Repairs {
    /// Vertices equal to the one before them, dropped.
    pub repeated_vertices: u32,
    /// Vertices of planar convex portals between their neighbours on one line, dropped.
    pub collinear_vertices: u32,
    /// Planar portals that are not convex, triangulated as skew ones are.
    pub dented_portals: u32,
    /// Triangulated portals whose fan starts from a later vertex, the one from the first not
    /// being a tiling.
    pub moved_fans: u32,
    /// Triangulated portals that no fan tiles, cut up by their ears instead.
    pub clipped_portals: u32,
    /// Triangles of a fan with no area, dropped.
    pub vanished_triangles: u32,
}
