//! Whether a line or a relation shows what it is said to show: by the definitions of
//! `docs/semantics.md` alone, on rationals, with nothing of the engine.

mod clear;
mod refute;

pub use clear::{
    HalfSpace, half_spaces_of_hull, half_spaces_of_polygon, is_clear, part_within, shows,
};
pub use refute::{Form, Refutation, refutes};

use super::input::{Door, Point, Polygon};
use crate::num::{Int, Rational, Sign, Surd};
use crate::vectors;
use num_traits::{Signed, Zero};

fn minus(a: &[Rational], b: &[Rational]) -> [Rational; 3] {
    [0, 1, 2].map(|i| &a[i] - &b[i])
}

fn cross(a: &[Rational; 3], b: &[Rational; 3]) -> [Rational; 3] {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| &a[i] * &b[j] - &a[j] * &b[i])
}

fn dot(a: &[Rational; 3], b: &[Rational; 3]) -> Rational {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

/// The edges of a polygon; a vertex said twice makes none.
fn edges(polygon: &Polygon) -> impl Iterator<Item = (&Point, &Point)> {
    polygon.iter().zip(polygon.iter().cycle().skip(1)).filter(|(p, q)| p != q)
}

/// Whether the line from one point to another is strictly inside every portal, in its direction:
/// polygons in space, segments in the plane.
pub fn passes<const D: usize>(line: &[[Rational; D]; 2], portals: &[Polygon]) -> bool {
    let line = line.each_ref().map(<[Rational; D]>::as_slice);
    portals.iter().all(|portal| vectors::passes(line, portal))
}

/// Whether the line from `a` to `b`, which differ, meets every closed segment of the plane in its
/// direction: no left end is to its right, and no right end to its left.
pub fn touches_between([a, b]: &[[Rational; 2]; 2], segments: &[Polygon]) -> bool {
    let turn = |p: &Point| (&b[0] - &a[0]) * (&p[1] - &a[1]) - (&b[1] - &a[1]) * (&p[0] - &a[0]);
    let touches = |ends: &Polygon| !turn(&ends[0]).is_negative() && !turn(&ends[1]).is_positive();
    a != b && segments.iter().all(touches)
}

/// Whether the line meets every closed polygon in its direction: the definition of grazing.
pub fn touches(line: &[[Surd; 3]; 2], portals: &[Polygon]) -> bool {
    let [a, b] = line;
    let d = surd_minus(b, a);
    let is_point = d.iter().all(Surd::is_zero);
    !is_point && portals.iter().all(|portal| touches_one(a, &d, portal))
}

fn touches_one(a: &[Surd; 3], d: &[Surd; 3], portal: &Polygon) -> bool {
    let vertices: Vec<[Surd; 3]> =
        portal.iter().map(|p| [0, 1, 2].map(|i| Surd::from(p[i].clone()))).collect();
    let arms: Vec<[Surd; 3]> = vertices.iter().map(|v| surd_minus(v, a)).collect();
    let count = arms.len();
    let sides: Vec<Sign> = (0..count)
        .map(|i| surd_dot(d, &surd_cross(&arms[i], &arms[(i + 1) % count])).sign())
        .collect();
    // The normal of a convex polygon is that of any corner that turns.
    let normal = (1..count - 1)
        .map(|i| {
            let arm = |k: usize| surd_minus(&vertices[k], &vertices[0]);
            surd_cross(&arm(i), &arm(i + 1))
        })
        .find(|normal| !normal.iter().all(Surd::is_zero));
    let Some(normal) = normal else { return false };
    match surd_dot(d, &normal).sign() {
        Sign::Positive => !sides.contains(&Sign::Negative),
        Sign::Negative => false,
        // The line is parallel to the portal's plane: it must run in it, and meet the polygon.
        Sign::Zero => {
            let across = surd_cross(&normal, d);
            let heights: Vec<Sign> = arms.iter().map(|v| surd_dot(&across, v).sign()).collect();
            sides.iter().all(|&side| side == Sign::Zero)
                && !heights.iter().all(|&side| side == Sign::Positive)
                && !heights.iter().all(|&side| side == Sign::Negative)
        }
    }
}

fn surd_minus(a: &[Surd; 3], b: &[Surd; 3]) -> [Surd; 3] {
    [0, 1, 2].map(|i| &a[i] - &b[i])
}

fn surd_cross(a: &[Surd; 3], b: &[Surd; 3]) -> [Surd; 3] {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| &(&a[i] * &b[j]) - &(&a[j] * &b[i]))
}

fn surd_dot(a: &[Surd; 3], b: &[Surd; 3]) -> Surd {
    &(&(&a[0] * &b[0]) + &(&a[1] * &b[1])) + &(&a[2] * &b[2])
}

/// Whether the weighted Plücker vectors of edges, each given by its portal and its number, sum to
/// zero, with weights that are positive and not none.
pub fn edges_cancel(terms: &[(usize, usize, Int)], portals: &[Polygon]) -> bool {
    let mut sum: [Rational; 6] = std::array::from_fn(|_| Rational::zero());
    for (portal, edge, weight) in terms {
        let Some(polygon) = portals.get(*portal).filter(|polygon| *edge < polygon.len()) else {
            return false;
        };
        let (p, q) = (&polygon[*edge], &polygon[(edge + 1) % polygon.len()]);
        let direction = minus(q, p);
        let moment = cross(&[0, 1, 2].map(|i| p[i].clone()), &direction);
        for i in 0..3 {
            sum[i] += &direction[i] * weight;
            sum[i + 3] += &moment[i] * weight;
        }
    }
    !terms.is_empty()
        && terms.iter().all(|(_, _, weight)| weight.is_positive())
        && sum.iter().all(Zero::is_zero)
}

/// Whether the weighted vectors (x, y, 1) of left ends minus those of right ends sum to zero, each
/// end given by its segment and 0 for left or 1 for right.
pub fn ends_cancel(terms: &[(usize, usize, Int)], segments: &[Polygon]) -> bool {
    let mut sum = [(); 3].map(|()| Rational::zero());
    for (segment, end, weight) in terms {
        let Some(p) = segments.get(*segment).and_then(|ends| ends.get(*end)) else { return false };
        let sign = if *end == 0 {
            Rational::from(weight.clone())
        } else {
            -Rational::from(weight.clone())
        };
        sum[0] += &p[0] * &sign;
        sum[1] += &p[1] * &sign;
        sum[2] += sign;
    }
    !terms.is_empty()
        && terms.iter().all(|(_, _, weight)| weight.is_positive())
        && sum.iter().all(Zero::is_zero)
}

/// Whether the line, given by its direction and its moment, meets the line through two points.
pub fn meets([direction, moment]: [&[Surd; 3]; 2], through: &Polygon) -> bool {
    let d = minus(&through[1], &through[0]);
    let m = cross(&[0, 1, 2].map(|i| through[0][i].clone()), &d);
    let surds = |v: &[Rational; 3]| v.each_ref().map(|c| Surd::from(c.clone()));
    (&surd_dot(direction, &surds(&m)) + &surd_dot(moment, &surds(&d))).is_zero()
}

/// Whether a chain of doors, by their numbers, leads from one cell to another, and the line from
/// `a` to `b` crosses the inside of each of them in that direction and in that order.
pub fn leads(
    doors: &[Door],
    chain: &[usize],
    [from, to]: [usize; 2],
    [a, b]: &[[Rational; 3]; 2],
) -> Result<(), String> {
    let d = minus(b, a);
    let mut cell = from;
    let mut last: Option<Rational> = None;
    for &number in chain {
        let Some(door) = doors.get(number) else {
            return Err(format!("there is no portal {number}"));
        };
        let [here, there] = door.cells;
        let mut polygon = door.polygon.clone();
        cell = match cell {
            cell if cell == here => there,
            cell if cell == there => {
                polygon.reverse();
                here
            }
            _ => return Err(format!("portal {number} does not leave cell {cell}")),
        };
        let at = crossing(&polygon, a, &d)
            .filter(|at| last.as_ref().is_none_or(|last| last < at))
            .ok_or_else(|| format!("portal {number} is not crossed in order"))?;
        last = Some(at);
    }
    if cell == to { Ok(()) } else { Err(format!("the chain leads to cell {cell}")) }
}

/// Where the line p + t·d crosses the inside of the polygon towards its right-hand normal.
fn crossing(polygon: &Polygon, p: &[Rational; 3], d: &[Rational; 3]) -> Option<Rational> {
    let mut area = [(); 3].map(|()| Rational::zero());
    for (u, v) in edges(polygon) {
        let product = cross(&minus(u, p), &minus(v, p));
        if !dot(d, &product).is_positive() {
            return None;
        }
        area = [0, 1, 2].map(|i| &area[i] + &product[i]);
    }
    Some(dot(&area, &minus(&polygon[0], p)) / dot(&area, d))
}
