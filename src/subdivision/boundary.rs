//! The boundary of the union of solids, as polygons that face out of it.
//!
//! Each face of a solid loses what lies inside another one. Where faces of two solids coincide,
//! one of them goes: facing the same way, that of the later solid; facing each other, both, as the
//! union (regularised: the closure of its interior) has no boundary between the two.
//!
//! A face is cut by a solid's planes one after the other, what is outside of one is kept, and
//! what is left at the end was inside; if nothing is left, the face stays whole.

use crate::construct::{Boxed, PlaneSet, Polygon, Polyhedron, Split};

/// The polygons of the boundary of the union of `bodies`.
pub(super) fn of_union(planes: &PlaneSet, bodies: &[Boxed]) -> Vec<Polygon> {
    let neighbours = neighbours(bodies);
    let mut boundary = Vec::new();
    for (own, body) in bodies.iter().enumerate() {
        for face in body.solid.faces() {
            let mut pieces = vec![face.clone()];
            for &other in &neighbours[own] {
                let solid = &bodies[other].solid;
                pieces = subtract(planes, pieces, solid, own < other);
                if pieces.is_empty() {
                    break;
                }
            }
            boundary.append(&mut pieces);
        }
    }
    boundary
}

/// For each body those whose boxes its own touches, in order.
fn neighbours(bodies: &[Boxed]) -> Vec<Vec<usize>> {
    let mut order: Vec<usize> = (0..bodies.len()).collect();
    order.sort_by(|&a, &b| bodies[a].low[0].cmp(&bodies[b].low[0]));
    let mut neighbours = vec![Vec::new(); bodies.len()];
    for (position, &a) in order.iter().enumerate() {
        let later = order[position + 1..].iter();
        for &b in later.take_while(|&&b| bodies[b].low[0] <= bodies[a].high[0]) {
            if bodies[a].may_touch(&bodies[b]) {
                neighbours[a].push(b);
                neighbours[b].push(a);
            }
        }
    }
    neighbours.iter_mut().for_each(|list| list.sort_unstable());
    neighbours
}

/// What of the polygons is outside of a solid; of coincident faces that look the same way the
/// polygons keep theirs if they have priority.
fn subtract(
    planes: &PlaneSet,
    polygons: Vec<Polygon>,
    solid: &Polyhedron,
    priority: bool,
) -> Vec<Polygon> {
    let mut outside = Vec::with_capacity(polygons.len());
    for polygon in polygons {
        let kept = outside.len();
        let mut rest = Some(polygon.clone());
        for face in solid.faces() {
            let Some(inside) = rest.take() else { break };
            rest = match inside.split(planes, face.support()) {
                Split::Front => None,
                Split::Back => Some(inside),
                Split::On if priority && face.support() == polygon.support() => None,
                Split::On => Some(inside),
                Split::Both(front, back) => {
                    outside.push(front);
                    Some(back)
                }
            };
        }
        if rest.is_none() {
            // Nothing of it is inside: it stays in one piece.
            outside.truncate(kept);
            outside.push(polygon);
        }
    }
    outside
}
