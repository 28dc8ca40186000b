//! An independent check of witnesses: big rationals only, and nothing of the engine.

use num_traits::{Signed, Zero};
use stabline::num::Rational;
use stabline::report::PairWitness;
use stabline::scene::{Portal, PortalGraph};

pub type Point = [Rational; 3];

/// Why a witness does not show what it should, or that it does: its chain of portals leads from
/// its cell to the other, and its line crosses the inside of each in that direction, in order.
/// (Of a portal that was triangulated, the inside of one of the triangles.)
pub fn check(graph: &PortalGraph, witness: &PairWitness) -> Result<(), String> {
    let [p, q] = witness.line.in_space().each_ref().map(|p| p.each_ref().map(|c| c.to_rational()));
    let direction = minus(&q, &p);
    if direction.iter().all(Zero::is_zero) {
        return Err("the two points are equal".to_owned());
    }
    let mut cell = witness.from;
    let mut last: Option<Rational> = None;
    for &source in &witness.portals {
        let first = graph.portals.partition_point(|portal| portal.source < source);
        let pieces = graph.portals[first..].iter().take_while(|portal| portal.source == source);
        let pieces: Vec<&Portal> = pieces.collect();
        let Some(any) = pieces.first() else { return Err(format!("there is no portal {source}")) };
        let (forwards, next) = if any.from.0 == cell {
            (true, any.to.0)
        } else if any.to.0 == cell {
            (false, any.from.0)
        } else {
            return Err(format!("portal {source} does not leave cell {cell}"));
        };
        let crossings = pieces.iter().filter_map(|piece| {
            let mut polygon: Vec<Point> = graph.corners(piece).map(|v| v.coordinates()).collect();
            if !forwards {
                polygon.reverse();
            }
            crossing(&polygon, &p, &direction)
        });
        let at = crossings.filter(|at| last.as_ref().is_none_or(|last| last < at)).min();
        let Some(at) = at else { return Err(format!("portal {source} is not crossed in order")) };
        (cell, last) = (next, Some(at));
    }
    if cell != witness.to {
        return Err(format!("the chain leads to cell {cell}"));
    }
    Ok(())
}

/// Where the line p + t·d crosses the inside of the polygon towards its right-hand normal.
pub fn crossing(polygon: &[Point], p: &Point, d: &Point) -> Option<Rational> {
    let normal = cross(&minus(&polygon[1], &polygon[0]), &minus(&polygon[2], &polygon[0]));
    let slope = dot(&normal, d);
    if !slope.is_positive() {
        return None;
    }
    let at = dot(&normal, &minus(&polygon[0], p)) / slope;
    let hit = [0, 1, 2].map(|i| &p[i] + &at * &d[i]);
    let is_inside = (0..polygon.len()).all(|i| {
        let edge = minus(&polygon[(i + 1) % polygon.len()], &polygon[i]);
        dot(&cross(&edge, &minus(&hit, &polygon[i])), &normal).is_positive()
    });
    is_inside.then_some(at)
}

pub fn minus(a: &Point, b: &Point) -> Point {
    [0, 1, 2].map(|i| &a[i] - &b[i])
}

pub fn cross(a: &Point, b: &Point) -> Point {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| &a[i] * &b[j] - &a[j] * &b[i])
}

pub fn dot(a: &Point, b: &Point) -> Rational {
    a.iter().zip(b).fold(Rational::zero(), |sum, (a, b)| sum + a * b)
}
