//! The tree: cells split by planes of the faces in them until none is left.
//!
//! Faces are the boundary of the solids, so a cell without faces inside is uniform. It is the
//! child of a node whose plane holds at least one face, and reaches all of the plane's section:
//! the cell is outside if that face looks into it, and inside otherwise. No point is ever
//! classified.

use super::{Child, Hint, Leaf, LeafId, Node, Options, choose};
use crate::construct::{Bounds, PlaneId, PlaneSet, Polygon, Polyhedron, Split};

pub(super) struct Tree {
    pub nodes: Vec<Node>,
    pub leaves: Vec<Leaf>,
    pub root: Child,
}

/// A cell yet to be split.
struct Work {
    cell: Polyhedron,
    faces: Vec<Polygon>,
    hints: Vec<Hint>,
    /// Whether the cell is solid if it has no faces.
    solid: bool,
    /// The node whose child it is, and whether on the positive side.
    parent: Option<(u32, bool)>,
}

/// Splits the box, which is solid or empty as `solid` says where there are no faces at all.
pub(super) fn build(
    planes: &PlaneSet,
    bounds: &Bounds,
    faces: Vec<Polygon>,
    hints: Vec<Hint>,
    solid: bool,
    options: &Options,
) -> Tree {
    let (mut nodes, mut leaves): (Vec<Node>, Vec<Leaf>) = (Vec::new(), Vec::new());
    // Overwritten once the first cell is known to be a node or a leaf.
    let mut root = Child::Leaf(LeafId(0));
    let cell = bounds.polyhedron(planes);
    // A stack and not recursion: a bad input may make a deep tree.
    let mut stack = vec![Work { cell, faces, hints, solid, parent: None }];
    while let Some(work) = stack.pop() {
        let parent = work.parent;
        let child = match splitting_plane(planes, &work, options) {
            None => {
                leaves.push(Leaf { solid: work.solid, cell: work.cell });
                Child::Leaf(LeafId(leaves.len() as u32 - 1))
            }
            Some(plane) => {
                let index = nodes.len() as u32;
                let section = work.cell.section(planes, bounds, plane);
                let [front, back] = halves(planes, work, &section, index);
                stack.push(back);
                stack.push(front);
                let unknown = Child::Leaf(LeafId(u32::MAX));
                nodes.push(Node { section, front: unknown, back: unknown });
                Child::Node(index)
            }
        };
        match parent {
            None => root = child,
            Some((parent, true)) => nodes[parent as usize].front = child,
            Some((parent, false)) => nodes[parent as usize].back = child,
        }
    }
    Tree { nodes, leaves, root }
}

/// The plane to split a cell by, or `None` for a leaf.
fn splitting_plane(planes: &PlaneSet, work: &Work, options: &Options) -> Option<PlaneId> {
    if !work.faces.is_empty() {
        Some(choose::plane(planes, &work.faces, options))
    } else if !work.solid && !work.hints.is_empty() {
        Some(choose::plane(planes, &work.hints, options))
    } else {
        None
    }
}

/// The two parts of a cell.
fn halves(planes: &PlaneSet, work: Work, section: &Polygon, index: u32) -> [Work; 2] {
    let plane = section.support();
    let sides = distribute(planes, work.faces, plane);
    let hints = distribute(planes, work.hints, plane);
    // A face looks out of the solid behind it. Without a face in the plane both parts are as the
    // whole, which then has no faces at all.
    let looks_front = |face: &Polygon| face.support() == plane;
    let (solid_front, solid_back) = match sides.on.first().map(looks_front) {
        None => (work.solid, work.solid),
        Some(front) => (!front, front),
    };
    let agree = || sides.on.windows(2).all(|pair| looks_front(&pair[0]) == looks_front(&pair[1]));
    let mixed = !sides.front.is_empty() && !sides.back.is_empty();
    debug_assert!(mixed || agree(), "a cell without faces has both kinds of points");
    let [front, back] = work.cell.split(planes, section);
    [
        Work {
            cell: front,
            faces: sides.front,
            hints: hints.front,
            solid: solid_front,
            parent: Some((index, true)),
        },
        Work {
            cell: back,
            faces: sides.back,
            hints: hints.back,
            solid: solid_back,
            parent: Some((index, false)),
        },
    ]
}

/// Polygons by their side of a plane.
struct Sides {
    front: Vec<Polygon>,
    back: Vec<Polygon>,
    on: Vec<Polygon>,
}

fn distribute(planes: &PlaneSet, polygons: Vec<Polygon>, plane: PlaneId) -> Sides {
    let mut sides = Sides { front: Vec::new(), back: Vec::new(), on: Vec::new() };
    for polygon in polygons {
        match polygon.split(planes, plane) {
            Split::Front => sides.front.push(polygon),
            Split::Back => sides.back.push(polygon),
            Split::On => sides.on.push(polygon),
            Split::Both(front, back) => {
                sides.front.push(front);
                sides.back.push(back);
            }
        }
    }
    sides
}
