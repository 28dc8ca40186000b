//! A portal graph whose cells hold objects.
//!
//! An object is a box that never hides anything; a cell sees it if an open set of sightlines from
//! inside the cell enters its interior (`docs/semantics.md`). So an object is one more cell of the
//! graph, which lines enter and do not leave, and its portals are the parts of its faces that lie
//! in the cells, crossed from the outside.

use super::{CellId, PortalGraph};

/// A portal graph with objects.
///
/// Invariants: the cells are exactly convex; a portal with an object on one side has a cell on the
/// other, lies in the closed cell, and enters the object.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ObjectGraph {
    /// The cells and the portals between them, then the objects and the portals into them.
    pub graph: PortalGraph,
    /// How many of the graph's cells are cells; those that follow are objects.
    pub cells: u32,
    /// For each object the cells whose inside meets its inside, in ascending order.
    pub held_by: Vec<Vec<CellId>>,
}

impl ObjectGraph {
    /// The number of objects.
    pub fn objects(&self) -> u32 {
        self.held_by.len() as u32
    }

    /// The cell that stands for an object.
    pub fn cell_of(&self, object: u32) -> CellId {
        CellId(self.cells + object)
    }
}
