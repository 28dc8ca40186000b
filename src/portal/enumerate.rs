//! All portals of a subdivision.

use crate::construct::{PlaneSet, Polygon, Split};
use crate::subdivision::{Child, LeafId, Subdivision};

/// What two empty leaves have in common.
#[derive(Clone, Debug)]
pub struct Portal {
    /// The leaf on the negative side of the polygon's support.
    pub from: LeafId,
    /// The leaf on its positive side, from which the vertices are seen counter-clockwise.
    pub to: LeafId,
    /// The common part of the leaves' boundaries.
    pub polygon: Polygon,
}

/// The portals between all empty leaves, ordered by `from`, then `to`; each pair of leaves has at
/// most one.
pub fn enumerate(subdivision: &Subdivision) -> Vec<Portal> {
    let mut portals = Vec::new();
    for node in &subdivision.nodes {
        for (to, polygon) in push(subdivision, node.front, node.section.clone()) {
            for (from, polygon) in push(subdivision, node.back, polygon) {
                portals.push(Portal { from, to, polygon });
            }
        }
    }
    portals.sort_by_key(|portal| (portal.from, portal.to));
    portals
}

/// The pieces of a polygon on a subtree's boundary, by the empty leaf that they touch.
fn push(subdivision: &Subdivision, subtree: Child, polygon: Polygon) -> Vec<(LeafId, Polygon)> {
    let planes: &PlaneSet = &subdivision.planes;
    let (mut pieces, mut stack) = (Vec::new(), vec![(subtree, polygon)]);
    while let Some((child, polygon)) = stack.pop() {
        let node = match child {
            Child::Leaf(leaf) => {
                if !subdivision.leaf(leaf).solid {
                    pieces.push((leaf, polygon));
                }
                continue;
            }
            Child::Node(node) => &subdivision.nodes[node as usize],
        };
        match polygon.split(planes, node.section.support()) {
            Split::Front => stack.push((node.front, polygon)),
            Split::Back => stack.push((node.back, polygon)),
            Split::On => unreachable!("a cell is not split by a plane of its boundary"),
            Split::Both(front, back) => {
                stack.push((node.back, back));
                stack.push((node.front, front));
            }
        }
    }
    pieces
}
