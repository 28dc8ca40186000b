//! The division of a box into cells in which an expression has one value.
//!
//! Each cell carries the formula that is left of the expression in it: brushes that hold the cell
//! or miss it are replaced by their value there, so a cell's work depends on the brushes that its
//! inside is still undecided about, not on all. Where brushes are spread out, that halves with
//! every split. A cell stays a box by ranks until a plane that is not axial must divide it: until
//! then no sign is asked for, and no polyhedron made.

use super::ends::{Ends, Ranks};
use super::formula::Formula;
use crate::construct::{PlaneId, PlaneSet, Polyhedron};
use std::rc::Rc;

/// A brush with volume.
pub(super) struct Brush {
    pub planes: Vec<PlaneId>,
    pub solid: Polyhedron,
    /// A box around it: itself, if it is one.
    pub around: Ranks,
    pub is_box: bool,
}

/// A tree of splitting planes, whose leaves are inside or outside.
#[derive(Clone, Debug)]
pub struct Tree {
    /// The root.
    pub root: Child,
    /// The inner nodes, each after its parent.
    pub nodes: Vec<Node>,
}

/// An inner node of a [`Tree`].
#[derive(Clone, Debug)]
pub struct Node {
    /// The splitting plane.
    pub plane: PlaneId,
    /// What is on the plane's positive side, and what on its negative side.
    pub children: [Child; 2],
    parent: Option<u32>,
}

/// What is at one side of a splitting plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Child {
    /// An inner node, by number.
    Node(u32),
    /// A leaf of the body.
    Inside,
    /// A leaf that is not of the body.
    Outside,
}

/// A leaf of the body.
pub(super) struct Cell {
    pub solid: Polyhedron,
    /// The node above it; none if it is the whole box.
    pub parent: Option<u32>,
}

impl Tree {
    /// The node of a plane on the way up from a node.
    pub(super) fn above(&self, mut node: Option<u32>, plane: PlaneId) -> Option<&Node> {
        while let Some(index) = node {
            let at = &self.nodes[index as usize];
            if at.plane.undirected() == plane.undirected() {
                return Some(at);
            }
            node = at.parent;
        }
        None
    }
}

/// A part of space: a box, or what planes have left of it.
struct Part {
    around: Ranks,
    /// None while it is the box itself.
    solid: Option<Polyhedron>,
}

/// A part that waits for its turn, and what is undecided above it.
struct Task {
    part: Part,
    formula: Rc<Formula>,
    /// The node above it, and which of its children it is.
    slot: Option<(u32, usize)>,
}

/// What a split costs for each brush that it cuts, in brushes that it fails to tell apart.
const CUT: usize = 4;

/// How many planes of brushes are weighed for a split.
const CANDIDATES: usize = 16;

/// Divides a box until the formula has one value in each cell; brushes without volume are `None`.
pub(super) fn divide(
    planes: &PlaneSet,
    ends: &Ends,
    brushes: &[Option<Brush>],
    formula: Formula,
) -> (Tree, Vec<Cell>) {
    let mut tree = Tree { root: Child::Outside, nodes: Vec::new() };
    let mut cells = Vec::new();
    let whole = Part { around: ends.whole(), solid: None };
    let mut tasks = vec![Task { part: whole, formula: Rc::new(formula), slot: None }];
    while let Some(Task { mut part, formula, slot }) = tasks.pop() {
        let left = formula.simplified(&mut |brush| match &brushes[brush] {
            Some(brush) => holds(planes, brush, &part),
            None => Some(false),
        });
        let parent = slot.map(|(node, _)| node);
        let child = match left {
            Ok(true) => {
                let solid = part.solid.take();
                let solid = solid.unwrap_or_else(|| ends.bounds(&part.around).polyhedron(planes));
                cells.push(Cell { solid, parent });
                Child::Inside
            }
            Ok(false) => Child::Outside,
            Err(formula) => {
                let mut numbers = Vec::new();
                formula.brushes(&mut numbers);
                let open: Vec<&Brush> =
                    numbers.iter().filter_map(|&brush| brushes[brush].as_ref()).collect();
                let formula = Rc::new(formula);
                let Some((plane, sides)) = split(planes, ends, &open, &mut part) else {
                    // A box that no axial plane divides well: brushes are held against it exactly.
                    part.solid = Some(ends.bounds(&part.around).polyhedron(planes));
                    tasks.push(Task { part, formula, slot });
                    continue;
                };
                let node = tree.nodes.len() as u32;
                tree.nodes.push(Node { plane, children: [Child::Outside; 2], parent });
                let [front, back] = sides;
                for (part, side) in [(back, 1), (front, 0)] {
                    tasks.push(Task { part, formula: formula.clone(), slot: Some((node, side)) });
                }
                Child::Node(node)
            }
        };
        match slot {
            Some((node, side)) => tree.nodes[node as usize].children[side] = child,
            None => tree.root = child,
        }
    }
    (tree, cells)
}

/// Whether a brush holds a part or misses it; `None` where it does neither, or where that takes
/// more than boxes to tell and the part is a box.
fn holds(planes: &PlaneSet, brush: &Brush, part: &Part) -> Option<bool> {
    if brush.around.misses(&part.around) {
        return Some(false);
    }
    if brush.is_box && brush.around.holds(&part.around) {
        return Some(true);
    }
    let solid = part.solid.as_ref()?;
    let mut holds = true;
    for &plane in &brush.planes {
        let extent = solid.extent(planes, plane);
        if !extent.back {
            return Some(false);
        }
        holds &= !extent.front;
    }
    holds.then_some(true)
}

/// Splits a part, in front of a plane and behind it; `None` for a box that only planes of brushes
/// divide well.
fn split(
    planes: &PlaneSet,
    ends: &Ends,
    open: &[&Brush],
    part: &mut Part,
) -> Option<(PlaneId, [Part; 2])> {
    let around = part.around;
    match part.solid.take() {
        None => {
            let (axis, rank) = separator(open, &around)?;
            let side = |end: usize| {
                let mut around = around;
                around.0[axis][end] = rank;
                Part { around, solid: None }
            };
            Some((ends.plane(axis, rank), [side(0), side(1)]))
        }
        Some(solid) => {
            let plane = choose(planes, open, &solid);
            let section = solid.section(planes, &ends.bounds(&around), plane);
            let sides = solid.split(planes, &section);
            Some((plane, sides.map(|solid| Part { around, solid: Some(solid) })))
        }
    }
}

/// The axial plane that divides the brushes of a box best.
fn separator(open: &[&Brush], around: &Ranks) -> Option<(usize, u32)> {
    let mut best: Option<(usize, usize, u32)> = None;
    for axis in 0..3 {
        let sorted = |end: usize| {
            let mut ends: Vec<u32> = open.iter().map(|brush| brush.around.0[axis][end]).collect();
            ends.sort_unstable();
            ends
        };
        let (low, high) = (sorted(0), sorted(1));
        let [least, most] = around.0[axis];
        for brush in open {
            for rank in brush.around.0[axis] {
                if rank <= least || most <= rank {
                    continue;
                }
                let back = high.partition_point(|&end| end <= rank);
                let front = low.len() - low.partition_point(|&end| end < rank);
                let cut = open.len() - front - back;
                let score = front.abs_diff(back) + CUT * cut;
                let divides = brush.is_box || (front > 0 && back > 0 && 2 * cut <= open.len());
                if divides && best.is_none_or(|(least, _, _)| score < least) {
                    best = Some((score, axis, rank));
                }
            }
        }
    }
    best.map(|(_, axis, rank)| (axis, rank))
}

/// Of some planes that cross a part, the one that leaves most brushes to one side, evenly.
fn choose(planes: &PlaneSet, open: &[&Brush], part: &Polyhedron) -> PlaneId {
    let crosses = |plane: &PlaneId| {
        let extent = part.extent(planes, *plane);
        extent.front && extent.back
    };
    let step = (2 * open.len()).div_ceil(CANDIDATES);
    let sampled = open.iter().step_by(step);
    let candidates = sampled.flat_map(|brush| brush.planes.iter().copied().filter(crosses).take(2));
    let score = |plane: PlaneId| {
        let (mut front, mut back, mut both) = (0usize, 0usize, 0usize);
        for brush in open {
            let extent = brush.solid.extent(planes, plane);
            match (extent.front, extent.back) {
                (true, true) => both += 1,
                (true, false) => front += 1,
                (false, _) => back += 1,
            }
        }
        front.abs_diff(back) + CUT * both
    };
    candidates
        .min_by_key(|&plane| score(plane))
        .expect("a brush that neither holds nor misses a cell has a plane across it")
}
