//! What is seen from one vertex, all around: for each direction the cells along it.
//!
//! A wedge of directions enters a cell, is divided among the ways out of it, and what meets none
//! ends at something opaque (or at the box). Wedges of one depth do not overlap, so the work is the
//! number of visible pieces.

use super::around::Wedge;
use crate::num::Sign;
use crate::predicates::PlanPoints;
use crate::scene::CellId;
use crate::scene::plan::{Crossing, Crossings};

/// A cell seen, and the way to it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Node {
    /// The cell seen through; none for a cell at the vertex.
    pub(super) parent: Option<u32>,
    pub(super) cell: CellId,
    /// The way into it, from the parent's cell; none for a cell at the vertex.
    pub(super) way: Option<Crossing>,
    pub(super) depth: u32,
}

/// Directions that see the same cells, up to something opaque.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Leaf {
    /// The last cell.
    pub(super) node: u32,
    /// A point in the first direction.
    pub(super) from: u32,
    /// A point in the last, counter-clockwise from it by less than half a turn.
    pub(super) to: u32,
}

/// The view from one vertex. Kept for its memory from one vertex to the next.
#[derive(Default)]
pub(super) struct View {
    pub(super) nodes: Vec<Node>,
    /// Wedge by wedge, counter-clockwise in each.
    pub(super) leaves: Vec<Leaf>,
    stack: Vec<Task>,
}

enum Task {
    /// A way into a cell, and the directions that pass it.
    Enter { parent: u32, way: Crossing, from: u32, to: u32 },
    /// Directions that end in a cell.
    End(Leaf),
}

impl View {
    /// Looks around from a vertex.
    pub(super) fn look(
        &mut self,
        points: &PlanPoints,
        crossings: &Crossings,
        vertex: u32,
        wedges: &[Wedge],
    ) {
        self.nodes.clear();
        self.leaves.clear();
        for &Wedge { cell, from, to, middle } in wedges {
            let root = self.nodes.len() as u32;
            self.nodes.push(Node { parent: None, cell, way: None, depth: 0 });
            // The ways out that do not touch the vertex, in the order of the polygon from the
            // vertex on: that of the directions.
            let ways = crossings.from(cell);
            let mut ahead: Vec<Crossing> =
                ways.iter().filter(|way| faces(points, vertex, way)).copied().collect();
            rotate_to_first(points, vertex, &mut ahead);
            // Turns are told apart below half a turn.
            if let Some(middle) = middle {
                self.divide_among(points, vertex, root, &[&ahead], middle, to);
                self.divide_among(points, vertex, root, &[&ahead], from, middle);
            } else {
                self.divide_among(points, vertex, root, &[&ahead], from, to);
            }
            while let Some(task) = self.stack.pop() {
                match task {
                    Task::End(leaf) => self.leaves.push(leaf),
                    Task::Enter { parent, way, from, to } => {
                        let number = self.nodes.len() as u32;
                        let depth = self.nodes[parent as usize].depth + 1;
                        let parent = Some(parent);
                        self.nodes.push(Node { parent, cell: way.to, way: Some(way), depth });
                        let ways = crossings.from(way.to);
                        let entry = ways.iter().position(|back| back.portal == way.portal);
                        let entry = entry.expect("a portal leads both ways");
                        let ahead = [&ways[entry + 1..], &ways[..entry]];
                        self.divide_among(points, vertex, number, &ahead, from, to);
                    }
                }
            }
        }
    }

    /// Divides the directions `from` … `to` in a cell among the ways out of it, which come in
    /// counter-clockwise order; the first piece comes to lie on top of the stack.
    fn divide_among(
        &mut self,
        points: &PlanPoints,
        vertex: u32,
        node: u32,
        ahead: &[&[Crossing]],
        from: u32,
        to: u32,
    ) {
        let bottom = self.stack.len();
        let mut last = from;
        for way in ahead.iter().copied().flatten() {
            if points.turn(vertex, last, way.left) != Sign::Positive {
                // It ends before the directions begin, or with them: touched at most.
                continue;
            }
            if points.turn(vertex, way.right, to) != Sign::Positive {
                // It begins where they end, or after.
                break;
            }
            if points.turn(vertex, way.right, way.left) != Sign::Positive {
                // Seen along its own line: no direction crosses it.
                continue;
            }
            let start = match points.turn(vertex, last, way.right) {
                Sign::Positive => {
                    self.stack.push(Task::End(Leaf { node, from: last, to: way.right }));
                    way.right
                }
                // It begins right here, or its part from here on is seen.
                Sign::Zero | Sign::Negative => last,
            };
            let end = match points.turn(vertex, way.left, to) {
                Sign::Positive => way.left,
                // It ends right there, or its part up to there is seen.
                Sign::Zero | Sign::Negative => to,
            };
            self.stack.push(Task::Enter { parent: node, way: *way, from: start, to: end });
            last = end;
        }
        if points.turn(vertex, last, to) == Sign::Positive {
            self.stack.push(Task::End(Leaf { node, from: last, to }));
        }
        self.stack[bottom..].reverse();
    }
}

/// Whether directions from the vertex, which is not behind the way, cross it.
fn faces(points: &PlanPoints, vertex: u32, way: &Crossing) -> bool {
    points.turn(vertex, way.right, way.left) == Sign::Positive
}

/// Rotates ways around a polygon so that they come counter-clockwise as seen from a vertex on its
/// boundary, which none of them touches.
fn rotate_to_first(points: &PlanPoints, vertex: u32, ways: &mut [Crossing]) {
    // The order of the polygon is that of the directions but for the place where it starts.
    let before = |a: &Crossing, b: &Crossing| points.turn(vertex, a.left, b.left) == Sign::Positive;
    let first = (1..ways.len()).find(|&i| !before(&ways[i - 1], &ways[i]));
    ways.rotate_left(first.unwrap_or(0));
}
