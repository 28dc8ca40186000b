//! The twin of what an eye sees in a floorplan: a full angular sweep over all opaque segments.
//!
//! Between two neighbouring directions among those of all ends and of all meets of two segments
//! the nearest segment is one and the same: what is seen there is a triangle. There are no cells,
//! no portals and no predicates here, so nothing is shared with what is checked.
//!
//! Complexity: one ray against all n segments for each of the n ends and k meets: O((n + k)·n).

use crate::num::Rational;
use num_traits::{One, Signed, Zero};
use std::cmp::Ordering;

type Point = [Rational; 2];

/// What is seen from a point, between walls: a star polygon.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Star {
    /// The eye.
    pub eye: Point,
    /// The walls' parts that end the view, counter-clockwise; each makes a triangle with the eye.
    pub ends: Vec<[Point; 2]>,
}

/// What is seen from a point strictly inside a box (its corners of least and greatest
/// coordinates) and on no segment, all around or between two directions less than half a turn
/// apart, the right one first.
pub fn star(
    eye: &Point,
    segments: &[[Point; 2]],
    view: &[Point; 2],
    cone: Option<&[Point; 2]>,
) -> Star {
    let [[x0, y0], [x1, y1]] = view.clone();
    let corners = [[&x0, &y0], [&x1, &y0], [&x1, &y1], [&x0, &y1]].map(|c| c.map(Clone::clone));
    let sides = (0..4).map(|i| [corners[i].clone(), corners[(i + 1) % 4].clone()]);
    let walls: Vec<[Point; 2]> = segments.iter().cloned().chain(sides).collect();
    let meets = walls
        .iter()
        .enumerate()
        .flat_map(|(i, one)| walls[..i].iter().filter_map(move |other| meet(one, other)));
    let mut directions: Vec<Point> = walls.iter().flatten().cloned().chain(meets).collect();
    directions = directions.iter().map(|point| minus(point, eye)).collect();
    directions.extend(cone.into_iter().flatten().cloned());
    directions.sort_by(by_angle);
    directions.dedup_by(|a, b| by_angle(a, b) == Ordering::Equal);
    let mut star = Star { eye: eye.clone(), ends: Vec::new() };
    for (i, from) in directions.iter().enumerate() {
        let to = &directions[(i + 1) % directions.len()];
        let between = [&from[0] + &to[0], &from[1] + &to[1]];
        let is_in_cone = |[right, left]: &[Point; 2]| {
            cross(right, &between).is_positive() && cross(&between, left).is_positive()
        };
        if cone.is_some_and(|cone| !is_in_cone(cone)) {
            continue;
        }
        let hits = walls.iter().filter_map(|wall| Some((distance(eye, &between, wall)?, wall)));
        let Some((_, nearest)) = hits.min_by(|(a, _), (b, _)| a.cmp(b)) else { continue };
        star.ends.push([from, to].map(|ray| on_line(eye, ray, nearest)));
    }
    star
}

impl Star {
    /// Twice its area.
    pub fn doubled_area(&self) -> Rational {
        self.ends.iter().map(|[p, q]| cross(&minus(p, &self.eye), &minus(q, &self.eye))).sum()
    }

    /// Twice the area of what it has in common with a convex polygon whose corners run
    /// counter-clockwise.
    pub fn doubled_area_within(&self, polygon: &[Point]) -> Rational {
        let part = |[p, q]: &[Point; 2]| {
            let mut part = vec![self.eye.clone(), p.clone(), q.clone()];
            for (i, a) in polygon.iter().enumerate() {
                part = left_of(part, a, &polygon[(i + 1) % polygon.len()]);
            }
            let after = part.iter().cycle().skip(1);
            part.iter().zip(after).map(|(p, q)| cross(p, q)).sum::<Rational>()
        };
        self.ends.iter().map(part).sum()
    }
}

fn minus(a: &Point, b: &Point) -> Point {
    [&a[0] - &b[0], &a[1] - &b[1]]
}

fn cross(a: &Point, b: &Point) -> Rational {
    &a[0] * &b[1] - &a[1] * &b[0]
}

/// The order of directions counter-clockwise, from that of the x axis on.
fn by_angle(a: &Point, b: &Point) -> Ordering {
    let is_lower = |d: &Point| d[1].is_negative() || (d[1].is_zero() && d[0].is_negative());
    is_lower(a).cmp(&is_lower(b)).then_with(|| Rational::zero().cmp(&cross(a, b)))
}

/// Where two segments that are not parallel meet.
fn meet([a, b]: &[Point; 2], [c, d]: &[Point; 2]) -> Option<Point> {
    let (along, other, apart) = (minus(b, a), minus(d, c), minus(c, a));
    let slope = cross(&along, &other);
    if slope.is_zero() {
        return None;
    }
    let (s, t) = (cross(&apart, &other) / &slope, cross(&apart, &along) / &slope);
    let is_part = |t: &Rational| !t.is_negative() && *t <= Rational::one();
    (is_part(&s) && is_part(&t)).then(|| [0, 1].map(|i| &a[i] + &s * &along[i]))
}

/// How many lengths of `ray` away it meets a segment, which it does not touch at an end.
fn distance(eye: &Point, ray: &Point, [a, b]: &[Point; 2]) -> Option<Rational> {
    let along = minus(b, a);
    let [from, to] = [a, b].map(|end| cross(ray, &minus(end, eye)).signum());
    if (from * to).is_negative() {
        let t = cross(&minus(a, eye), &along) / cross(ray, &along);
        return t.is_positive().then_some(t);
    }
    None
}

/// Where a ray meets a segment's line, which it is not parallel to.
fn on_line(eye: &Point, ray: &Point, [a, b]: &[Point; 2]) -> Point {
    let along = minus(b, a);
    let t = cross(&minus(a, eye), &along) / cross(ray, &along);
    [0, 1].map(|i| &eye[i] + &t * &ray[i])
}

/// The part of a convex polygon to the left of a line.
fn left_of(polygon: Vec<Point>, a: &Point, b: &Point) -> Vec<Point> {
    let along = minus(b, a);
    let heights: Vec<Rational> = polygon.iter().map(|p| cross(&along, &minus(p, a))).collect();
    if heights.iter().all(|height| !height.is_negative()) {
        return polygon;
    }
    let mut part = Vec::new();
    for (i, p) in polygon.iter().enumerate() {
        let next = (i + 1) % polygon.len();
        let (q, from, to) = (&polygon[next], &heights[i], &heights[next]);
        if !from.is_negative() {
            part.push(p.clone());
        }
        if (from.signum() * to.signum()).is_negative() {
            let t = from / (from - to);
            part.push([0, 1].map(|i| &p[i] + &t * (&q[i] - &p[i])));
        }
    }
    part
}
