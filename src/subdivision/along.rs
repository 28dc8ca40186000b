//! What lies along polygons: the leaves that they look into, the neighbours of a leaf, and the
//! faces that bound each leaf.

use super::{Child, Face, LeafId, Subdivision};
use crate::construct::{PlaneId, Polygon, Split};

/// A leaf on the other side of a part of a leaf's boundary.
#[derive(Clone, Debug)]
pub struct Neighbour {
    /// The leaf, solid or empty.
    pub leaf: LeafId,
    /// What the two boundaries share, as seen from the neighbour: its support looks into it.
    pub shared: Polygon,
}

/// A part of an occluder in a leaf's boundary.
#[derive(Clone, Debug)]
pub struct LeafFace {
    /// The node whose plane it lies in.
    pub node: u32,
    /// The face: an index into the node's.
    pub face: u32,
    /// The part that bounds the leaf; its support looks into the leaf.
    pub polygon: Polygon,
}

impl Subdivision {
    /// The pieces of a polygon in a subtree's cell, each with the leaf that its support looks
    /// into: the one that has it in its interior or, of two leaves with the piece in their common
    /// boundary, that on the support's positive side.
    ///
    /// Cost: a split for each node that a piece reaches.
    pub fn looking_into(&self, subtree: Child, polygon: Polygon) -> Vec<(LeafId, Polygon)> {
        let (mut pieces, mut stack) = (Vec::new(), vec![(subtree, polygon)]);
        while let Some((child, polygon)) = stack.pop() {
            let node = match child {
                Child::Leaf(leaf) => {
                    pieces.push((leaf, polygon));
                    continue;
                }
                Child::Node(node) => &self.nodes[node as usize],
            };
            match polygon.split(&self.planes, node.section.support()) {
                Split::Front => stack.push((node.front, polygon)),
                Split::Back => stack.push((node.back, polygon)),
                Split::On if polygon.support() == node.section.support() => {
                    stack.push((node.front, polygon));
                }
                Split::On => stack.push((node.back, polygon)),
                Split::Both(front, back) => {
                    stack.push((node.back, back));
                    stack.push((node.front, front));
                }
            }
        }
        pieces
    }

    /// The leaves that share a polygon with this one, whatever lies in it; by the faces of the
    /// cell, each pair of leaves once (Teller 1992, section 8.2.4).
    ///
    /// Cost: for each face of the cell the nodes on the way to its neighbours.
    pub fn neighbours(&self, leaf: LeafId) -> Vec<Neighbour> {
        let ends: [PlaneId; 6] = self.bounds.planes();
        let faces = self.leaf(leaf).cell.faces().iter();
        let inner = faces.filter(|face| !ends.contains(&face.support()));
        let beyond = inner.flat_map(|face| self.looking_into(self.root, face.clone()));
        beyond.map(|(leaf, shared)| Neighbour { leaf, shared }).collect()
    }

    /// For each leaf the parts of occluders that bound it, in the order of the nodes: the tree with
    /// convex sets at its leaves (Carr 2004), beside that with polygons at its nodes. Solid leaves
    /// have none.
    pub fn faces_of_leaves(&self) -> Vec<Vec<LeafFace>> {
        let mut of_leaves = vec![Vec::new(); self.leaves.len()];
        for (number, node) in (0..).zip(&self.nodes) {
            for (index, Face { polygon, thin, .. }) in (0..).zip(&node.faces) {
                let mut looks = vec![polygon.clone()];
                if *thin {
                    looks.push(polygon.flipped());
                }
                for look in looks {
                    let to_front = look.support() == node.section.support();
                    let subtree = if to_front { node.front } else { node.back };
                    for (leaf, polygon) in self.looking_into(subtree, look) {
                        let part = LeafFace { node: number, face: index, polygon };
                        of_leaves[leaf.0 as usize].push(part);
                    }
                }
            }
        }
        of_leaves
    }
}
