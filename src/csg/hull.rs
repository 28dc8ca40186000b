//! The convex hull of points in space, by its supporting planes.
//!
//! Incremental: a point outside sees some of the hull's triangles, which give way to triangles
//! from the edges around them. A triangle in whose plane the point lies is not seen; so no new
//! triangle has its corners on one line (an edge around what is seen has a seen triangle, whose
//! plane does not hold the point), and points in the plane of a face extend it by triangles of the
//! same plane. Everything is decided in integers.

use super::brush::BrushError;
use super::expression::Half;
use crate::geom::BigPlane;
use crate::geom::vector::{cross, difference, dot};
use crate::num::{Int, Rational, Sign};
use num_integer::Integer;
use num_traits::Zero;
use std::collections::BTreeSet;

/// A triangle of the hull: its corners by number, counter-clockwise as seen from outside.
struct Triangle {
    corners: [usize; 3],
    plane: BigPlane,
}

/// The convex hull of points, by the half-spaces of its faces. Signs: points times faces.
///
/// # Errors
/// [`BrushError::Flat`] where the points lie in one plane.
pub fn hull(points: &[[Rational; 3]]) -> Result<Vec<Half>, BrushError> {
    let scale = points.iter().flatten().fold(Int::from(1), |lcm, c| lcm.lcm(c.denom()));
    let whole = |c: &Rational| c.numer() * (&scale / c.denom());
    let points: Vec<[Int; 3]> = points.iter().map(|p| p.each_ref().map(whole)).collect();
    let first = first_tetrahedron(&points).ok_or(BrushError::Flat)?;
    let mut triangles: Vec<Triangle> = [[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]]
        .map(|t| triangle(&points, t.map(|i| first[i])))
        .into();
    for number in 0..points.len() {
        add(&points, number, &mut triangles);
    }
    let mut known = BTreeSet::new();
    let halves = triangles.into_iter().filter_map(|Triangle { plane, .. }| {
        let divisor = plane.normal.iter().fold(plane.offset.clone(), |g, c| g.gcd(c));
        let normal = plane.normal.map(|c| c / &divisor);
        let offset = plane.offset / &divisor;
        let is_new = known.insert((normal.clone(), offset.clone()));
        let offset = Rational::new(offset, scale.clone());
        is_new.then(|| Half { normal: normal.map(Rational::from), offset })
    });
    Ok(halves.collect())
}

fn triangle(points: &[[Int; 3]], corners: [usize; 3]) -> Triangle {
    let [a, b, c] = corners.map(|i| &points[i]);
    let normal = cross(&difference(b, a), &difference(c, a));
    let offset = dot(&normal, a);
    Triangle { corners, plane: BigPlane { normal, offset } }
}

fn side(plane: &BigPlane, point: &[Int; 3]) -> Sign {
    Sign::of(&(dot(&plane.normal, point) - &plane.offset))
}

/// Four points that are not in one plane, the fourth behind the triangle of the others.
fn first_tetrahedron(points: &[[Int; 3]]) -> Option<[usize; 4]> {
    let a = 0;
    let b = (1..points.len()).find(|&b| points[b] != points[a])?;
    let spans = |c: &usize| triangle(points, [a, b, *c]).plane.normal.iter().any(|c| !c.is_zero());
    let c = (b + 1..points.len()).find(spans)?;
    let plane = triangle(points, [a, b, c]).plane;
    (0..points.len()).find_map(|d| match side(&plane, &points[d]) {
        Sign::Negative => Some([a, b, c, d]),
        // In the plane of the three.
        Sign::Zero => None,
        Sign::Positive => Some([a, c, b, d]),
    })
}

fn add(points: &[[Int; 3]], number: usize, triangles: &mut Vec<Triangle>) {
    let point = &points[number];
    let is_seen = |triangle: &Triangle| match side(&triangle.plane, point) {
        Sign::Positive => true,
        // In the plane of a face: that face stays.
        Sign::Zero | Sign::Negative => false,
    };
    let mut around = BTreeSet::new();
    triangles.retain(|triangle| {
        if !is_seen(triangle) {
            return true;
        }
        let [a, b, c] = triangle.corners;
        for (from, to) in [(a, b), (b, c), (c, a)] {
            // An edge between two seen triangles is met in both directions.
            if !around.remove(&(to, from)) {
                around.insert((from, to));
            }
        }
        false
    });
    triangles.extend(around.into_iter().map(|(a, b)| triangle(points, [a, b, number])));
}
