//! The boundary of a divided set: what of its cells' faces has the outside on the other side.

use super::divide::{Cell, Child, Tree};
use crate::construct::{PlaneSet, Polygon, Split};

/// The faces of `cells` as far as they lie against the outside.
///
/// A face lies in the plane of a node above its cell, and what is on its other side is below that
/// node's other child: only there is it pushed down.
pub(super) fn of(planes: &PlaneSet, tree: &Tree, cells: &[Cell]) -> Vec<Polygon> {
    let mut boundary = Vec::new();
    for cell in cells {
        for face in cell.solid.faces() {
            let node = tree.above(cell.parent, face.support()).expect("no cell is at the bounds");
            // The face's normal points to the other side.
            let other = node.children[usize::from(face.support() != node.plane)];
            against_outside(planes, tree, other, face.clone(), &mut boundary);
        }
    }
    boundary
}

/// Pushes a face down the tree, on the side that it points to.
fn against_outside(
    planes: &PlaneSet,
    tree: &Tree,
    child: Child,
    face: Polygon,
    boundary: &mut Vec<Polygon>,
) {
    let mut tasks = vec![(child, face)];
    while let Some((child, face)) = tasks.pop() {
        let node = match child {
            Child::Node(node) => &tree.nodes[node as usize],
            Child::Inside => continue,
            Child::Outside => {
                boundary.push(face);
                continue;
            }
        };
        let [front, back] = node.children;
        match face.split(planes, node.plane) {
            Split::Front => tasks.push((front, face)),
            Split::Back => tasks.push((back, face)),
            Split::On => unreachable!("no plane splits on both sides of itself"),
            Split::Both(positive, negative) => tasks.extend([(front, positive), (back, negative)]),
        }
    }
}
