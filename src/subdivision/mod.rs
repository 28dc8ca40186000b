//! The division of a box into convex cells, each wholly inside or wholly outside the solids.
//!
//! 1. `prepare`: every solid becomes a polyhedron, every thin polygon a polygon of planes; the box
//!    is what the input states as its view, or their bounds and a margin.
//! 2. `boundary`: the faces of the solids, less what lies inside or against other solids: the
//!    boundary of the (regularised) union; and the thin polygons, less what lies in solids.
//! 3. `tree`: a binary space partition by planes of these faces (Fuchs, Kedem and Naylor, On
//!    visible surface generation by a priori tree structures, 1980; Teller, Visibility
//!    computations in densely occluded polyhedral environments, 1992, section 8.2.1). A cell that
//!    no face enters is a leaf; the faces on its last splitting plane tell its kind.
//! 4. `refine`: empty leaves that are too large or too long, where that is asked for.
//!
//! Planes of hints cut only empty leaves, after all faces.
//!
//! Both ways of storing polygons (Carr, 2004) are there: each node keeps the faces in its plane,
//! for the order of painting, and [`Subdivision::faces_of_leaves`] gives each leaf those that
//! bound it.
//!
//! Invariants: the leaves tile the box; no vertex is rounded; the tree is a function of the input.
//! [`Subdivision::check`] checks them. Complexity: with n faces and a tree of t nodes, O(n log n)
//! box tests where boxes are small beside the whole, and O(s·f) signs a node with f faces and s
//! sampled candidates.

mod along;
mod boundary;
mod check;
mod choose;
mod inside;
mod locate;
mod options;
mod painter;
pub mod plan;
mod prepare;
mod refine;
#[cfg(test)]
pub(crate) mod tests;
mod touching;
mod tree;

pub use along::{LeafFace, Neighbour};
pub use check::{Checked, Violation};
pub use options::{Options, PortalShape, Weights};
pub use painter::Painted;
pub use prepare::DivisionError;

use crate::construct::{Bounds, PlaneId, PlaneSet, Polygon, Polyhedron};
use crate::geom::{AxialBox, BigPlane, RationalPoint3};
use crate::report::Progress;

/// The intersection of the negative sides of planes.
pub type Solid = Vec<BigPlane>;

/// What space is divided around, in world units.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Occluders {
    /// Convex solids. They may overlap, touch, and be without volume.
    pub solids: Vec<Solid>,
    /// Planar, strictly convex polygons that occlude from both sides. They may cross and overlap
    /// each other and the solids.
    pub polygons: Vec<Vec<RationalPoint3>>,
    /// What splits empty cells.
    pub hints: Vec<Hint>,
    /// The box to divide; all that is outside of it is left out. Without it the box is that of
    /// all solids and polygons, and a margin.
    pub view: Option<AxialBox>,
}

/// A solid some of whose faces split empty cells.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Hint {
    /// The planes, outward.
    pub planes: Solid,
    /// For each plane whether its face splits.
    pub splits: Vec<bool>,
}

/// A piece of what occludes or splits.
#[derive(Clone, Debug)]
pub struct Face {
    /// The polygon. That of a solid looks out of it.
    pub polygon: Polygon,
    /// What it is a piece of.
    pub source: Source,
    /// Whether both of its sides are empty; otherwise the side that it looks away from is solid.
    pub thin: bool,
}

/// Where a face comes from, by index into [`Occluders`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Source {
    /// A solid.
    Solid(u32),
    /// A polygon.
    Polygon(u32),
    /// A hint.
    Hint(u32),
}

/// A binary space partition of a box around occluders.
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
    /// What occludes, in pieces: the boundary of the solids, and polygons outside of them.
    faces: Vec<Face>,
    /// The faces of hints that split.
    hints: Vec<Face>,
}

/// A cell that is split.
#[derive(Clone, Debug)]
pub struct Node {
    /// What of the splitting plane lies in the cell; its support is the plane.
    pub section: Polygon,
    /// What of the occluders lies in the section.
    pub faces: Vec<Face>,
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

/// Divides a box around occluders.
///
/// # Errors
/// [`DivisionError`]: an input that is no solid or polygon, nothing to divide, an interruption.
pub fn build(
    occluders: &Occluders,
    options: &Options,
    progress: &dyn Progress,
) -> Result<Subdivision, DivisionError> {
    let prepare::Prepared { planes, bounds, bodies, sheets, hints, flat } =
        prepare::prepare(occluders, options)?;
    let faces = boundary::of_occluders(&planes, &bounds, &bodies, sheets, progress)?;
    // Solids without a boundary in the box fill it: a boundary of one would be a face.
    let solid = faces.is_empty() && !bodies.is_empty();
    let input = tree::Input { faces, hints, solid };
    Subdivision::of_faces(planes, bounds, input, flat, options, progress)
}

impl Subdivision {
    /// The division of a box by faces.
    fn of_faces(
        planes: PlaneSet,
        bounds: Bounds,
        input: tree::Input,
        flat: Vec<usize>,
        options: &Options,
        progress: &dyn Progress,
    ) -> Result<Subdivision, DivisionError> {
        let (faces, hints) = (input.faces.clone(), input.hints.clone());
        let built = tree::build(&planes, &bounds, input, options, progress)?;
        let tree::Tree { nodes, leaves, root } = built;
        let mut all = Subdivision { planes, bounds, nodes, leaves, root, flat, faces, hints };
        all.split_free_cells(options, progress)?;
        Ok(all)
    }

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
