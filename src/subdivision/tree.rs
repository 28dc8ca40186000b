//! The tree: cells split by planes of the faces in them until none is left.
//!
//! Faces are the boundary of the solids, and thin polygons outside of the solids. A cell without
//! faces of solids inside is uniform, and it is the child of a node whose plane holds at least
//! one face, of a solid or thin, that reaches it. Near a thin polygon both sides are empty; near a
//! solid's face the side it looks to is empty and the other one solid. So the faces on the last
//! plane tell the kind of a leaf, and no point is ever classified.

use super::{Child, DivisionError, Face, Leaf, LeafId, Node, Options, choose};
use crate::construct::{Bounds, PlaneId, PlaneSet, Polygon, Polyhedron, Split};
use crate::report::Progress;

/// Progress is told in these: the whole box; each part has its share by its faces.
const WHOLE: u64 = 1 << 20;

pub(super) struct Tree {
    pub nodes: Vec<Node>,
    pub leaves: Vec<Leaf>,
    pub root: Child,
}

/// What there is to divide a box by.
pub(super) struct Input {
    /// What occludes.
    pub faces: Vec<Face>,
    /// What splits empty cells afterwards.
    pub hints: Vec<Face>,
    /// Whether the box is solid if there are no faces.
    pub solid: bool,
}

/// A cell yet to be split.
struct Work {
    cell: Polyhedron,
    faces: Vec<Face>,
    hints: Vec<Face>,
    /// Whether the cell is solid if it has no faces.
    solid: bool,
    /// Whether the round of obscuration still goes on.
    obscuration: bool,
    /// The node whose child it is, and whether on the positive side.
    parent: Option<(u32, bool)>,
    /// Its share of the work.
    share: u64,
}

/// Splits the box.
pub(super) fn build(
    planes: &PlaneSet,
    bounds: &Bounds,
    Input { faces, hints, solid }: Input,
    options: &Options,
    progress: &dyn Progress,
) -> Result<Tree, DivisionError> {
    progress.begin("tree", WHOLE);
    let (mut nodes, mut leaves): (Vec<Node>, Vec<Leaf>) = (Vec::new(), Vec::new());
    // Overwritten once the first cell is known to be a node or a leaf.
    let mut root = Child::Leaf(LeafId(0));
    let (cell, obscuration) = (bounds.polyhedron(planes), options.obscuration.is_some());
    // A stack and not recursion: a bad input may make a deep tree.
    let mut stack =
        vec![Work { cell, faces, hints, solid, obscuration, parent: None, share: WHOLE }];
    while let Some(mut work) = stack.pop() {
        if progress.is_interrupted() {
            return Err(DivisionError::Interrupted);
        }
        let parent = work.parent;
        let child = match splitting_plane(planes, bounds, &mut work, options) {
            None => {
                progress.advance(work.share);
                leaves.push(Leaf { solid: work.solid, cell: work.cell });
                Child::Leaf(LeafId(leaves.len() as u32 - 1))
            }
            Some(plane) => {
                let index = nodes.len() as u32;
                let section = work.cell.section(planes, bounds, plane);
                let ([front, back], faces) = halves(planes, work, &section, index);
                stack.push(back);
                stack.push(front);
                let unknown = Child::Leaf(LeafId(u32::MAX));
                nodes.push(Node { section, faces, front: unknown, back: unknown });
                Child::Node(index)
            }
        };
        match parent {
            None => root = child,
            Some((parent, true)) => nodes[parent as usize].front = child,
            Some((parent, false)) => nodes[parent as usize].back = child,
        }
    }
    Ok(Tree { nodes, leaves, root })
}

/// The plane to split a cell by, or `None` for a leaf.
fn splitting_plane(
    planes: &PlaneSet,
    bounds: &Bounds,
    work: &mut Work,
    options: &Options,
) -> Option<PlaneId> {
    if work.faces.is_empty() {
        let split = !work.solid && !work.hints.is_empty();
        return split.then(|| choose::by_score(planes, &work.hints, options));
    }
    if let (true, Some(least)) = (work.obscuration, &options.obscuration) {
        let (cell, samples) = (&work.cell, options.samples);
        let found = choose::by_obscuration(planes, bounds, cell, &work.faces, least, samples);
        if found.is_some() {
            return found;
        }
        work.obscuration = false;
    }
    Some(choose::by_score(planes, &work.faces, options))
}

/// The two parts of a cell, and the occluding faces in the plane between them.
fn halves(planes: &PlaneSet, work: Work, section: &Polygon, index: u32) -> ([Work; 2], Vec<Face>) {
    let plane = section.support();
    let [faces_front, faces_back, on] = distribute(planes, work.faces, plane);
    let [hints_front, hints_back, _] = distribute(planes, work.hints, plane);
    // Which sides of the plane are solid next to a face. Without a face in the plane both parts
    // are as the whole, which then has no faces at all.
    let kinds = |face: &Face| {
        let looks_front = face.polygon.support() == plane;
        (!face.thin && !looks_front, !face.thin && looks_front)
    };
    let (solid_front, solid_back) = on.first().map_or((work.solid, work.solid), kinds);
    let uniform = |faces: &[Face], solid: bool, side: fn((bool, bool)) -> bool| {
        !faces.iter().all(|face| face.thin) || on.iter().all(|face| side(kinds(face)) == solid)
    };
    debug_assert!(
        uniform(&faces_front, solid_front, |kinds| kinds.0)
            && uniform(&faces_back, solid_back, |kinds| kinds.1),
        "a cell without faces of solids has both kinds of points"
    );
    let total = (faces_front.len() + faces_back.len()).max(1) as u64;
    let share = work.share * faces_front.len() as u64 / total;
    let [front, back] = work.cell.split(planes, section);
    let front = Work {
        cell: front,
        faces: faces_front,
        hints: hints_front,
        solid: solid_front,
        obscuration: work.obscuration,
        parent: Some((index, true)),
        share,
    };
    let back = Work {
        cell: back,
        faces: faces_back,
        hints: hints_back,
        solid: solid_back,
        obscuration: work.obscuration,
        parent: Some((index, false)),
        share: work.share - share,
    };
    ([front, back], on)
}

/// Faces by their side of a plane: in front, behind, in it.
fn distribute(planes: &PlaneSet, faces: Vec<Face>, plane: PlaneId) -> [Vec<Face>; 3] {
    let [mut front, mut back, mut on] = [Vec::new(), Vec::new(), Vec::new()];
    for face in faces {
        match face.polygon.split(planes, plane) {
            Split::Front => front.push(face),
            Split::Back => back.push(face),
            Split::On => on.push(face),
            Split::Both(positive, negative) => {
                front.push(Face { polygon: positive, ..face });
                back.push(Face { polygon: negative, ..face });
            }
        }
    }
    [front, back, on]
}
