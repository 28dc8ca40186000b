//! The division of a box into cells in which an expression has one value.
//!
//! Each cell carries the formula that is left of the expression in it: brushes that hold the cell
//! or miss it are replaced by their value there, so a cell's work depends on the brushes that its
//! inside is still undecided about, not on all. Where brushes are spread out, that halves with
//! every split.

use super::formula::Formula;
use crate::construct::{Bounds, PlaneId, PlaneSet, Polyhedron};

/// A brush with volume.
pub(super) struct Brush {
    pub planes: Vec<PlaneId>,
    pub solid: Polyhedron,
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

/// A part of the box that waits for its turn.
struct Task {
    cell: Polyhedron,
    formula: Formula,
    /// The node above it, and which of its children it is.
    slot: Option<(u32, usize)>,
}

/// How many planes are weighed for a split.
const CANDIDATES: usize = 16;

/// Divides a box until the formula has one value in each cell; brushes without volume are `None`.
pub(super) fn divide(
    planes: &PlaneSet,
    bounds: &Bounds,
    brushes: &[Option<Brush>],
    formula: Formula,
) -> (Tree, Vec<Cell>) {
    let mut tree = Tree { root: Child::Outside, nodes: Vec::new() };
    let mut cells = Vec::new();
    let mut tasks = vec![Task { cell: bounds.polyhedron(planes), formula, slot: None }];
    while let Some(Task { cell, formula, slot }) = tasks.pop() {
        let left = formula.simplified(&mut |brush| match &brushes[brush] {
            Some(brush) => holds(planes, brush, &cell),
            None => Some(false),
        });
        let parent = slot.map(|(node, _)| node);
        let child = match left {
            Ok(true) => {
                cells.push(Cell { solid: cell, parent });
                Child::Inside
            }
            Ok(false) => Child::Outside,
            Err(formula) => {
                let node = tree.nodes.len() as u32;
                let plane = choose(planes, brushes, &cell, &formula);
                let section = cell.section(planes, bounds, plane);
                let [front, back] = cell.split(planes, &section);
                let leaves = [Child::Outside; 2];
                tree.nodes.push(Node { plane, children: leaves, parent });
                let task = |cell, side| {
                    let formula = formula.clone();
                    Task { cell, formula, slot: Some((node, side)) }
                };
                tasks.extend([task(back, 1), task(front, 0)]);
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

/// Whether a brush holds a cell or misses it; `None` where it does neither.
fn holds(planes: &PlaneSet, brush: &Brush, cell: &Polyhedron) -> Option<bool> {
    let mut holds = true;
    for &plane in &brush.planes {
        let extent = cell.extent(planes, plane);
        if !extent.back {
            return Some(false);
        }
        holds &= !extent.front;
    }
    holds.then_some(true)
}

/// Of some planes that cross the cell, the one that leaves most brushes to one side, evenly.
fn choose(
    planes: &PlaneSet,
    brushes: &[Option<Brush>],
    cell: &Polyhedron,
    formula: &Formula,
) -> PlaneId {
    let mut numbers = Vec::new();
    formula.brushes(&mut numbers);
    let open: Vec<&Brush> = numbers.iter().filter_map(|&brush| brushes[brush].as_ref()).collect();
    let crosses = |plane: &PlaneId| {
        let extent = cell.extent(planes, *plane);
        extent.front && extent.back
    };
    let step = (2 * open.len()).div_ceil(CANDIDATES);
    let sampled = open.iter().step_by(step);
    let candidates = sampled.flat_map(|brush| brush.planes.iter().copied().filter(crosses).take(2));
    let score = |plane: PlaneId| {
        let (mut front, mut back, mut both) = (0usize, 0usize, 0usize);
        for brush in &open {
            let extent = brush.solid.extent(planes, plane);
            match (extent.front, extent.back) {
                (true, true) => both += 1,
                (true, false) => front += 1,
                (false, _) => back += 1,
            }
        }
        front.abs_diff(back) + 2 * both
    };
    candidates
        .min_by_key(|&plane| score(plane))
        .expect("a brush that neither holds nor misses a cell has a plane across it")
}
