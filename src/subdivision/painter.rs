//! The painter's order: everything that is nearer to an eye comes later.
//!
//! At each node all of the side away from the eye is painted, then the faces in the node's plane,
//! then the eye's side (Fuchs, Kedem and Naylor, On visible surface generation by a priori tree
//! structures, 1980): no segment from the eye passes from the eye's side to the other and back.
//! For an eye in the plane the order is immaterial: a segment from it to a point on one side meets
//! neither the other side nor, but for the eye itself, the plane; and what lies in the plane is
//! seen edge-on and covers nothing.

use super::{Child, LeafId, Subdivision};
use crate::geom::RationalPoint3;
use crate::num::Sign;
use crate::predicates::side_of_point;

/// What is painted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Painted {
    /// A leaf, with what is in it.
    Leaf(LeafId),
    /// A face of a node's plane.
    Face {
        /// The node, by index.
        node: u32,
        /// An index into the node's faces.
        face: u32,
    },
}

impl Subdivision {
    /// All leaves and all occluding faces, such that for a segment from the eye what it meets
    /// nearer to the eye comes later. Faces of one node are in one plane, and in any order.
    ///
    /// Cost: one sign a node.
    pub fn back_to_front(&self, eye: &RationalPoint3) -> Vec<Painted> {
        enum Step {
            Below(Child),
            Faces(u32),
        }
        let mut order = Vec::with_capacity(self.leaves.len());
        let mut stack = vec![Step::Below(self.root)];
        while let Some(step) = stack.pop() {
            let number = match step {
                Step::Faces(node) => {
                    let count = self.nodes[node as usize].faces.len() as u32;
                    order.extend((0..count).map(|face| Painted::Face { node, face }));
                    continue;
                }
                Step::Below(Child::Leaf(leaf)) => {
                    order.push(Painted::Leaf(leaf));
                    continue;
                }
                Step::Below(Child::Node(node)) => node,
            };
            let node = &self.nodes[number as usize];
            let plane = self.planes.get(node.section.support());
            let (near, far) = match side_of_point(plane, eye) {
                Sign::Positive => (node.front, node.back),
                Sign::Negative => (node.back, node.front),
                // The plane is seen edge-on: either order will do.
                Sign::Zero => (node.front, node.back),
            };
            stack.extend([Step::Below(near), Step::Faces(number), Step::Below(far)]);
        }
        order
    }
}
