//! Sightlines: exact lines that prove pairs open, and their check.

use super::arena::{Arena, Directed};
use crate::num::{Number, Rational, Sign};
use crate::predicates::filtered::{Approx3, FilteredLine};

/// A directed line through two distinct points, in world coordinates.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Sightline {
    /// Points in units of 2^-bits.
    Dyadic {
        /// The two points, in the line's direction.
        points: [[i64; 3]; 2],
        /// The unit's exponent.
        bits: u32,
    },
    /// Any rational points.
    Rational(Box<[[Rational; 3]; 2]>),
}

/// The largest integer of a dyadic point: all below are floats.
const LARGEST: f64 = 9_007_199_254_740_992.0;

impl Sightline {
    /// The line through two points whose coordinates are integers, in units of 2^-bits; `None` if
    /// a coordinate is no integer below 2^53 or the points are equal.
    pub(crate) fn dyadic(points: [[f64; 3]; 2], bits: u32) -> Option<Sightline> {
        let holds = |c: &f64| c.fract() == 0.0 && c.abs() < LARGEST;
        (points.iter().flatten().all(holds) && points[0] != points[1]).then(|| {
            let points = points.map(|point| point.map(|c| c as i64));
            Sightline::Dyadic { points, bits }
        })
    }

    /// The two points, exact.
    pub fn numbers(&self) -> [[Number; 3]; 2] {
        match self {
            Sightline::Dyadic { points, bits } => {
                points.map(|point| point.map(|c| Number::ratio(c.into(), 1i128 << bits)))
            }
            Sightline::Rational(points) => {
                points.as_ref().clone().map(|point| point.map(Number::from))
            }
        }
    }

    /// The same line in the other direction.
    pub fn reversed(&self) -> Sightline {
        match self {
            Sightline::Dyadic { points: [p, q], bits } => {
                Sightline::Dyadic { points: [*q, *p], bits: *bits }
            }
            Sightline::Rational(points) => {
                let [p, q] = points.as_ref().clone();
                Sightline::Rational(Box::new([q, p]))
            }
        }
    }
}

/// A dyadic line with its filter, to be checked against portals.
#[derive(Clone)]
pub(crate) struct Ray {
    points: [[i64; 3]; 2],
    bits: u32,
    filter: FilteredLine,
}

impl Ray {
    /// `None` for a line that is not dyadic: the filters do not see such thin ones.
    pub fn new(arena: &Arena, line: &Sightline) -> Option<Ray> {
        let Sightline::Dyadic { points, bits } = line else { return None };
        let [p, q] = points.map(|point| Approx3::dyadic(point, *bits));
        let filter = FilteredLine::through(&p, &q, arena.bound());
        Some(Ray { points: *points, bits: *bits, filter })
    }

    pub fn sightline(&self) -> Sightline {
        Sightline::Dyadic { points: self.points, bits: self.bits }
    }

    /// Whether the line crosses the interior of `portal` in its direction.
    pub fn crosses(&self, arena: &Arena, portal: Directed) -> bool {
        arena.edges(portal).iter().enumerate().all(|(index, filter)| {
            let side = self.filter.side_of_edge(filter);
            match side.unwrap_or_else(|| {
                let ids = arena.vertices(portal);
                let edge = [ids[index], ids[(index + 1) % ids.len()]];
                arena.grid().side_of_edge(self.points, self.bits, edge)
            }) {
                Sign::Positive => true,
                // Through the edge itself is grazing, not open.
                Sign::Zero | Sign::Negative => false,
            }
        })
    }

    /// Whether the line crosses the plane of `first` before that of `second`, where that is not
    /// implied by crossing both.
    pub fn keeps_order(&self, arena: &Arena, first: Directed, second: Directed) -> bool {
        if !arena.needs_order(first, second) {
            return true;
        }
        match arena.compare_crossings(self.points, self.bits, [first, second]) {
            Some(Sign::Positive) => true,
            // Both at one point: the order of crossing is not strict.
            Some(Sign::Zero) => false,
            Some(Sign::Negative) | None => false,
        }
    }

    /// Whether the line stabs the whole path, in order.
    pub fn stabs(&self, arena: &Arena, path: &[Directed]) -> bool {
        path.iter().all(|&portal| self.crosses(arena, portal))
            && path.windows(2).all(|pair| self.keeps_order(arena, pair[0], pair[1]))
    }
}
