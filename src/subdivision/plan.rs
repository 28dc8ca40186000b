//! Subdivisions of a floorplan: a binary tree of lines, whose leaves are convex cells.
//!
//! There are two ways to choose the lines: that of the k-D tree for axial segments (Teller and
//! Séquin 1991, §2.3; `kd`), and that of a BSP tree for segments of any direction (`choose`). Both
//! yield a [`PlanTree`], so that point location, neighbours, portals and everything after them are
//! the same. Segments that cross are split at the meet of their lines on the way, exactly.
//!
//! Invariants: the leaves tile the box; no segment of the plan meets a leaf's inside, but those
//! that a threshold left in it, which [`PlanTree::left_inside`] lists.

mod axial;
mod build;
mod choose;
mod kd;
mod lines;
#[cfg(test)]
mod tests;

use crate::num::Sign;
use crate::predicates::{PlanPoint, PlanPoints, turn_of_points};

pub use axial::{AxialFace, Extents, FaceClass, classify};
pub use build::divide;
pub use choose::PlanMethod;
pub use lines::PlanLines;

/// Why a plan was not divided.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum PlanDivisionError {
    /// The work was told to stop.
    #[error("interrupted")]
    Interrupted,
    /// The k-D tree was asked for, and a segment is neither horizontal nor vertical.
    #[error("segments[{segment}]: not parallel to an axis, as a k-D tree needs it")]
    NotAxial {
        /// Its number in the input.
        segment: u32,
    },
}

/// A child of a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Branch {
    /// Divided further, by its number in [`PlanTree::nodes`].
    Node(u32),
    /// A leaf, by its number in [`PlanTree::leaves`].
    Leaf(u32),
}

/// A node: space on both sides of a directed line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PlanNode {
    /// Its line, by its number in [`PlanTree::lines`].
    pub line: u32,
    /// What lies to its left, the line itself included (extents are half-open, §2.3).
    pub left: Branch,
    /// What lies to its right.
    pub right: Branch,
}

/// The line of a leaf's edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EdgeLine {
    /// By its number in [`PlanTree::lines`].
    pub line: u32,
    /// Whether the leaf lies to the left of the line as it is directed.
    pub is_left: bool,
}

/// A leaf: a convex cell.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlanLeaf {
    /// Its corners, counter-clockwise, strictly convex.
    pub polygon: Vec<u32>,
    /// For each corner the line of the edge to the next one.
    pub edges: Vec<EdgeLine>,
}

/// A subdivision of a plan's box.
#[derive(Clone, Debug)]
pub struct PlanTree {
    /// All points: those of the plan, by the same numbers, and the meets of lines.
    pub points: PlanPoints,
    /// The lines of the plan's segments and of its box.
    pub lines: PlanLines,
    /// The inner nodes.
    pub nodes: Vec<PlanNode>,
    /// The leaves, in the tree's order, left before right.
    pub leaves: Vec<PlanLeaf>,
    /// The top.
    pub root: Branch,
    /// The line of each of the plan's segments.
    pub segment_lines: Vec<u32>,
    /// The plan's segments, by their index, that meet the inside of a leaf.
    pub left_inside: Vec<u32>,
}

impl PlanTree {
    /// The leaf whose half-open extent holds a point of the box: O(depth).
    pub fn locate(&self, point: &PlanPoint) -> u32 {
        let mut branch = self.root;
        loop {
            match branch {
                Branch::Leaf(leaf) => return leaf,
                Branch::Node(node) => {
                    let node = &self.nodes[node as usize];
                    let [a, b] = self.lines.through(node.line).map(|end| self.points.get(end));
                    branch = match turn_of_points(a, b, point) {
                        // On the line: extents are half-open, and the left one holds it.
                        Sign::Positive | Sign::Zero => node.left,
                        Sign::Negative => node.right,
                    };
                }
            }
        }
    }

    /// The length of the longest way from the top to a leaf.
    pub fn depth(&self) -> usize {
        let mut deepest = 0;
        let mut stack = vec![(self.root, 0)];
        while let Some((branch, depth)) = stack.pop() {
            deepest = deepest.max(depth);
            if let Branch::Node(node) = branch {
                let node = &self.nodes[node as usize];
                stack.extend([(node.left, depth + 1), (node.right, depth + 1)]);
            }
        }
        deepest
    }
}
