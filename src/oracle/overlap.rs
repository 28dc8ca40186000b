//! The twin for a moving box: a linear program in space and time, by all its vertices.
//!
//! The points (x, t) with x in a convex body and in the box at the time t are a polytope of four
//! dimensions. The box's inside meets the body's inside (a polygon: the polygon) at some times iff
//! the polytope has its full dimension (one less for a polygon), and then just between the least
//! and the greatest t of its vertices. Cost for n half-spaces: n^4 systems of four equations.

use crate::geom::{BigPlane, RationalPoint3};
use crate::num::{Int, Rational};
use num_traits::{Signed, Zero};

/// The half-space a·(x, t) <= b.
type Row = [Int; 5];

/// A vertex, over its last coordinate, which is positive.
type Vertex = [Int; 5];

/// When the inside of a box, carried from one point to another and given by its corners as seen
/// from the point, meets a body, the intersection of the negative sides of planes, before and
/// after these times included: an open interval. A body of which the planes include one in both
/// directions is a polygon.
///
/// # Panics
/// If the points are equal or the body is unbounded.
pub fn overlap(
    body: &[BigPlane],
    from: &RationalPoint3,
    to: &RationalPoint3,
    corners: &[RationalPoint3; 2],
) -> Option<[Rational; 2]> {
    assert!(from != to, "a box that rests overlaps always or never");
    let rows = rows(body, from, to, corners);
    let vertices = vertices(&rows);
    let opposite = |p: &BigPlane, q: &BigPlane| {
        p.offset == -&q.offset && (0..3).all(|i| p.normal[i] == -&q.normal[i])
    };
    let flat = body.iter().any(|p| body.iter().any(|q| opposite(p, q)));
    if rank(&vertices) < if flat { 4 } else { 5 } {
        return None;
    }
    let times = || vertices.iter().map(|v| Rational::new(v[3].clone(), v[4].clone()));
    Some([times().min()?, times().max()?])
}

fn rows(
    body: &[BigPlane],
    from: &RationalPoint3,
    to: &RationalPoint3,
    corners: &[RationalPoint3; 2],
) -> Vec<Row> {
    let grid = RationalPoint3::common_denominator([from, to, &corners[0], &corners[1]]);
    let [from, to, low, high] =
        [from, to, &corners[0], &corners[1]].map(|point| point.on_grid(&grid).coordinates);
    let mut rows: Vec<Row> = body
        .iter()
        .map(|BigPlane { normal: [a, b, c], offset }| {
            [a.clone(), b.clone(), c.clone(), Int::zero(), offset.clone()]
        })
        .collect();
    for axis in 0..3 {
        // x - from - t (to - from) <= high, and >= low.
        let mut row: Row = std::array::from_fn(|_| Int::zero());
        row[axis] = grid.clone();
        row[3] = &from[axis] - &to[axis];
        row[4] = &from[axis] + &high[axis];
        let mut other = row.clone().map(|c| -c);
        other[4] = -(&from[axis] + &low[axis]);
        rows.extend([row, other]);
    }
    rows
}

fn vertices(rows: &[Row]) -> Vec<Vertex> {
    let mut found = Vec::new();
    let count = rows.len();
    for a in 0..count {
        for b in 0..a {
            for c in 0..b {
                for d in 0..c {
                    let Some(vertex) = meet([&rows[a], &rows[b], &rows[c], &rows[d]]) else {
                        continue;
                    };
                    let holds = |row: &Row| {
                        (0..4).map(|i| &row[i] * &vertex[i]).sum::<Int>() <= &row[4] * &vertex[4]
                    };
                    if rows.iter().all(holds) {
                        found.push(vertex);
                    }
                }
            }
        }
    }
    found
}

/// The point of four equations, by elimination without fractions (Bareiss 1968).
fn meet(rows: [&Row; 4]) -> Option<Vertex> {
    let mut m = rows.map(Row::clone);
    let mut last = Int::from(1);
    for k in 0..4 {
        let pivot = (k..4).find(|&i| !m[i][k].is_zero())?;
        m.swap(k, pivot);
        let row = m[k].clone();
        for (_, other) in m.iter_mut().enumerate().filter(|(i, _)| *i != k) {
            let factor = other[k].clone();
            for (entry, of_row) in other.iter_mut().zip(&row) {
                *entry = (&*entry * &row[k] - of_row * &factor) / &last;
            }
        }
        last = m[k][k].clone();
    }
    let sign = last.signum();
    let scaled = |i: usize| &m[i][4] * &sign;
    Some([scaled(0), scaled(1), scaled(2), scaled(3), last.abs()])
}

/// The rank of the vertices' homogeneous coordinates: one more than the dimension of their hull.
fn rank(vertices: &[Vertex]) -> usize {
    let mut basis: Vec<Vertex> = Vec::new();
    for vertex in vertices {
        let mut rest = vertex.clone();
        for row in &basis {
            let at = row.iter().position(|c| !c.is_zero()).expect("a row of the basis");
            if !rest[at].is_zero() {
                let (p, q) = (row[at].clone(), rest[at].clone());
                rest = std::array::from_fn(|j| &rest[j] * &p - &row[j] * &q);
            }
        }
        if rest.iter().any(|c| !c.is_zero()) {
            basis.push(rest);
        }
    }
    basis.len()
}
