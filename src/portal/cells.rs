//! Chosen leaves and the portals between them, as points: what a portal graph is made of.

use super::Portal;
use crate::geom::RationalPoint3;
use crate::subdivision::{LeafId, Subdivision};

/// Cells and the portals between them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cells {
    /// The leaf of each cell, ascending.
    pub leaves: Vec<LeafId>,
    /// The portals between cells, by `from`, then `to`; those of one pair lie in one plane.
    pub portals: Vec<CellPortal>,
}

/// A portal between two cells.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CellPortal {
    /// The cell that the polygon's right-hand normal leaves: an index into [`Cells::leaves`].
    pub from: u32,
    /// The cell that it enters, from which the vertices are seen counter-clockwise.
    pub to: u32,
    /// The vertices; the polygon is strictly convex.
    pub polygon: Vec<RationalPoint3>,
}

impl Cells {
    /// The empty leaves that `chosen` holds, by leaf, with all portals between two of them.
    ///
    /// # Panics
    /// If `chosen` has not one entry a leaf.
    pub fn of(subdivision: &Subdivision, portals: &[Portal], chosen: &[bool]) -> Cells {
        assert_eq!(chosen.len(), subdivision.leaves.len(), "one entry a leaf");
        let taken = |leaf: &LeafId| chosen[leaf.0 as usize] && !subdivision.leaf(*leaf).solid;
        let leaves: Vec<LeafId> = subdivision.leaf_ids().filter(taken).collect();
        let cell = |leaf: LeafId| leaves.binary_search(&leaf).ok().map(|cell| cell as u32);
        let portals = portals.iter().filter_map(|portal| {
            let (from, to) = (cell(portal.from)?, cell(portal.to)?);
            Some(CellPortal { from, to, polygon: portal.polygon.points() })
        });
        let portals = portals.collect();
        Cells { leaves, portals }
    }
}
