//! Small polygons for the families: laid out in the lattice of their own plane, so that they are
//! exactly planar and convex whatever the plane.

use super::input::{Point, Polygon};
use crate::num::{Int, Random, Rational};

/// A point with small integer coordinates.
pub(super) type Vector = [i64; 3];

pub(super) fn add(a: Vector, b: Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub(super) fn sub(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub(super) fn scale(a: Vector, k: i64) -> Vector {
    a.map(|c| c * k)
}

pub(super) fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(super) fn dot(a: Vector, b: Vector) -> i64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Any vector with coordinates up to `reach`.
pub(super) fn vector(random: &mut Random, reach: i64) -> Vector {
    [(); 3].map(|()| random.between(-reach, reach))
}

/// One of some values.
pub(super) fn one_of<T: Clone>(random: &mut Random, values: &[T]) -> T {
    values[random.between(0, values.len() as i64 - 1) as usize].clone()
}

/// The corners of the unit square.
pub(super) const SQUARE: [[i64; 2]; 4] = [[0, 0], [1, 0], [1, 1], [0, 1]];

/// The corners of half of it.
pub(super) const TRIANGLE: [[i64; 2]; 3] = [[0, 0], [1, 0], [0, 1]];

/// The points `origin + i·u + j·v`, in the order that makes the normal point along `direction` (in
/// the order given where it points across).
pub(super) fn lay_out(
    [origin, u, v]: [Vector; 3],
    corners: &[[i64; 2]],
    direction: Vector,
) -> Vec<Vector> {
    let place = |&[i, j]: &[i64; 2]| add(origin, add(scale(u, i), scale(v, j)));
    let mut portal: Vec<Vector> = corners.iter().map(place).collect();
    if dot(cross(u, v), direction) < 0 {
        portal.reverse();
    }
    portal
}

/// A triangle or a parallelogram across the y axis near `y`, coordinates within `reach` of there.
pub(super) fn across(random: &mut Random, y: i64, reach: i64) -> Vec<Vector> {
    let [u, v] = loop {
        let [u, v] = [vector(random, reach), vector(random, reach)];
        if cross(u, v)[1] != 0 {
            break [u, v];
        }
    };
    let middle = add(vector(random, 1), [0, y, 0]);
    let corners: &[[i64; 2]] = if random.one_in(2) { &SQUARE } else { &TRIANGLE };
    let origin = sub(middle, add(u, v).map(|c| c / 2));
    lay_out([origin, u, v], corners, [0, 1, 0])
}

/// A whole number.
pub(super) fn whole(value: i64) -> Rational {
    Rational::from(Int::from(value))
}

/// Integer vertices as a polygon.
pub(super) fn polygon<const D: usize>(vertices: &[[i64; D]]) -> Polygon {
    let point = |vertex: &[i64; D]| -> Point { vertex.iter().map(|&c| whole(c)).collect() };
    vertices.iter().map(point).collect()
}

/// Portals of integer vertices.
pub(super) fn polygons<const D: usize>(portals: &[Vec<[i64; D]>]) -> Vec<Polygon> {
    portals.iter().map(|portal| polygon(portal)).collect()
}
