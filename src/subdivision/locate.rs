//! Which leaves a point lies in.

use super::{Child, LeafId, Subdivision};
use crate::geom::RationalPoint3;
use crate::num::Sign;
use crate::predicates::side_of_point;

impl Subdivision {
    /// The leaves whose closed cells contain the point, in ascending order: one for a point inside
    /// a cell, all that touch for a point between cells, none outside of the box.
    pub fn locate(&self, point: &RationalPoint3) -> Vec<LeafId> {
        let planes = &self.planes;
        let outside = |plane| match side_of_point(planes.get(plane), point) {
            Sign::Positive => true,
            // A point on the box's boundary belongs to it.
            Sign::Zero | Sign::Negative => false,
        };
        if self.bounds.planes().into_iter().any(outside) {
            return Vec::new();
        }
        let (mut leaves, mut stack) = (Vec::new(), vec![self.root]);
        while let Some(child) = stack.pop() {
            let node = match child {
                Child::Leaf(leaf) => {
                    leaves.push(leaf);
                    continue;
                }
                Child::Node(node) => &self.nodes[node as usize],
            };
            match side_of_point(planes.get(node.section.support()), point) {
                Sign::Positive => stack.push(node.front),
                Sign::Negative => stack.push(node.back),
                // On the plane: the closed cells of both sides may contain it. A leaf that it
                // reaches lies with it on the right side of every plane above, hence contains it.
                Sign::Zero => stack.extend([node.back, node.front]),
            }
        }
        leaves.sort_unstable();
        leaves
    }
}
