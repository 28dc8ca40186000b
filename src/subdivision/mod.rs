//! The division of a box into convex cells, each wholly inside or wholly outside the solids.
//!
//! 1. `solids`: every solid becomes a polyhedron; the box is their bounds and a margin.
//! 2. `boundary`: the faces of the solids, less what lies inside or against other solids: the
//!    boundary of the (regularised) union.
//! 3. `tree`: a binary space partition by planes of these faces (Fuchs, Kedem and Naylor, On
//!    visible surface generation by a priori tree structures, 1980; Teller, Visibility
//!    computations in densely occluded polyhedral environments, 1992, section 8.2.1). A cell that
//!    no face enters is a leaf; the faces on its last splitting plane tell its kind.
//!
//! Planes of hints cut only empty leaves, after everything else.
//!
//! Invariants: the leaves tile the box; no vertex is rounded; the tree is a function of the input.
//! Complexity: with n faces, k solids and a tree of t nodes, O(k²) box tests, and O(s·f) signs a
//! node with f faces and s sampled candidates.

mod boundary;
mod choose;
mod inside;
mod locate;
mod solids;
#[cfg(test)]
pub(crate) mod tests;
mod tree;

pub use choose::Options;
pub use solids::{DivisionError, Solid};

use crate::construct::{Bounds, PlaneId, PlaneSet, Polygon, Polyhedron};

/// A binary space partition of a box around solids.
#[derive(Clone, Debug)]
pub struct Subdivision {
    /// The planes of everything below.
    pub planes: PlaneSet,
    /// The box that the leaves tile.
    pub bounds: Bounds,
    /// The inner nodes; a child comes after its parent.
    pub nodes: Vec<Node>,
    /// The leaves.
    pub leaves: Vec<Leaf>,
    /// The tree.
    pub root: Child,
    /// The solids left out, by index, because their planes enclose no volume.
    pub flat: Vec<usize>,
    /// The boundary of the solids, in pieces that look out of them.
    boundary: Vec<Polygon>,
    /// The faces of hints that split.
    hints: Vec<Hint>,
}

/// A cell that is split.
#[derive(Clone, Debug)]
pub struct Node {
    /// What of the splitting plane lies in the cell; its support is the plane.
    pub section: Polygon,
    /// The part on the plane's positive side.
    pub front: Child,
    /// The part on the plane's negative side.
    pub back: Child,
}

/// A node or a leaf, by index.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Child {
    /// An index into [`Subdivision::nodes`].
    Node(u32),
    /// An index into [`Subdivision::leaves`].
    Leaf(LeafId),
}

/// A leaf: its index in [`Subdivision::leaves`].
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct LeafId(pub u32);

impl std::fmt::Debug for LeafId {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "leaf{}", self.0)
    }
}

/// A cell that is not split.
#[derive(Clone, Debug)]
pub struct Leaf {
    /// Whether its inner points are inside the solids; otherwise all are outside.
    pub solid: bool,
    /// The cell.
    pub cell: Polyhedron,
}

/// A face of a hint: a polygon whose plane splits the empty leaves that it enters.
type Hint = Polygon;

/// Divides the space around solids.
///
/// Each solid is the intersection of the negative sides of its planes; so is each hint, with a
/// flag for every plane that says whether its face splits.
///
/// # Errors
/// There is no solid with volume, or one is unbounded, or a normal is zero.
pub fn build(
    solids: &[Solid],
    hints: &[(Solid, Vec<bool>)],
    options: &Options,
) -> Result<Subdivision, DivisionError> {
    let prepared = solids::prepare(solids, hints, options)?;
    let solids::Prepared { planes, bounds, solids, hints, flat } = prepared;
    let boundary = boundary::of_union(&planes, &solids);
    let built = tree::build(&planes, &bounds, boundary.clone(), hints.clone(), false, options);
    let tree::Tree { nodes, leaves, root } = built;
    Ok(Subdivision { planes, bounds, nodes, leaves, root, flat, boundary, hints })
}

impl Subdivision {
    /// The leaf of an id.
    pub fn leaf(&self, id: LeafId) -> &Leaf {
        &self.leaves[id.0 as usize]
    }

    /// The ids of the leaves.
    pub fn leaf_ids(&self) -> impl Iterator<Item = LeafId> + use<> {
        (0..self.leaves.len() as u32).map(LeafId)
    }

    /// Whether a leaf reaches the boundary of the box.
    pub fn touches_bounds(&self, id: LeafId) -> bool {
        let bounds: [PlaneId; 6] = self.bounds.planes();
        self.leaf(id).cell.faces().iter().any(|face| bounds.contains(&face.support()))
    }
}
