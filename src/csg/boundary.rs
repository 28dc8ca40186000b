//! The boundary of a divided set: what of its cells' faces has the outside on the other side.

use super::Tree;
use crate::construct::{PlaneSet, Polygon, Polyhedron, Split};
use crate::geom::vector::dot;
use crate::num::{Int, Rational};
use num_traits::Zero;

/// The faces of `cells` as far as they lie against the outside.
pub(super) fn of(planes: &PlaneSet, tree: &Tree, cells: &[Polyhedron]) -> Vec<Polygon> {
    let mut boundary = Vec::new();
    for face in cells.iter().flat_map(Polyhedron::faces) {
        against_outside(planes, tree, face.clone(), &mut boundary);
    }
    boundary
}

/// Pushes a face down the tree, on the side that it points to.
fn against_outside(planes: &PlaneSet, tree: &Tree, face: Polygon, boundary: &mut Vec<Polygon>) {
    match tree {
        Tree::Outside => boundary.push(face),
        Tree::Inside => {}
        Tree::Split { plane, children } => {
            let [front, back] = children.as_ref();
            match face.split(planes, *plane) {
                Split::Front => against_outside(planes, front, face, boundary),
                Split::Back => against_outside(planes, back, face, boundary),
                Split::On => {
                    let side = if face.support() == *plane { front } else { back };
                    against_outside(planes, side, face, boundary);
                }
                Split::Both(positive, negative) => {
                    against_outside(planes, front, positive, boundary);
                    against_outside(planes, back, negative, boundary);
                }
            }
        }
    }
}

/// A polygon's area, if it is rational.
pub(super) fn area(polygon: &Polygon) -> Option<Rational> {
    let doubled = polygon.doubled_area();
    let square = dot(&doubled, &doubled);
    Some(root(&square)? / Int::from(2))
}

/// The square root of a number that is not negative, if it is rational.
fn root(square: &Rational) -> Option<Rational> {
    let of = |value: &Int| {
        let root = value.sqrt();
        (&root * &root == *value).then_some(root)
    };
    match square.is_zero() {
        true => Some(Rational::zero()),
        false => Some(Rational::new(of(square.numer())?, of(square.denom())?)),
    }
}
