//! The boundary of a divided set: what of its cells' faces has the outside on the other side.

use super::Tree;
use crate::construct::{PlaneSet, Polygon, Polyhedron, Split};
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
    let points: Vec<[Rational; 3]> = polygon
        .points()
        .iter()
        .map(|p| {
            p.numerators().each_ref().map(|c| Rational::new(c.clone(), p.denominator().clone()))
        })
        .collect();
    let from_first =
        |p: &[Rational; 3]| -> [Rational; 3] { std::array::from_fn(|i| &p[i] - &points[0][i]) };
    let mut doubled = [(); 3].map(|()| Rational::from(Int::ZERO));
    for pair in points[1..].windows(2) {
        let (a, b) = (from_first(&pair[0]), from_first(&pair[1]));
        for (i, sum) in doubled.iter_mut().enumerate() {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            *sum += &a[j] * &b[k] - &a[k] * &b[j];
        }
    }
    let square: Rational = doubled.iter().map(|c| c * c).sum();
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
