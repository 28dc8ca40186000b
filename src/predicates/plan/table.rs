//! A table of distinct points, to which a plan refers by number.

use super::point::{PlanPoint, compare_coordinates, error_bound, turn_exact, turn_filter};
use crate::num::Sign;
use rustc_hash::FxHashMap;
use std::cmp::Ordering;

/// Distinct points of a plan.
///
/// Invariants: no point is there twice; `bound` is the filter's for all of them; `short` holds all
/// of them or is not there.
#[derive(Clone, Debug)]
pub struct PlanPoints {
    points: Vec<PlanPoint>,
    /// Those of the points, close together in memory.
    floats: Vec<[f64; 2]>,
    numbers: FxHashMap<PlanPoint, u32>,
    /// The points as integers, while all are below [`SHORT`] in magnitude.
    short: Option<Vec<[i64; 2]>>,
    largest: f64,
    bound: f64,
}

/// Below it a difference is below 2^31, and the difference of two products of two below 2^63.
const SHORT: u64 = 1 << 30;

impl Default for PlanPoints {
    fn default() -> PlanPoints {
        PlanPoints {
            points: Vec::new(),
            floats: Vec::new(),
            numbers: FxHashMap::default(),
            short: Some(Vec::new()),
            largest: 0.0,
            bound: 0.0,
        }
    }
}

impl PlanPoints {
    /// The number of a point, which is added if it is new.
    ///
    /// # Panics
    /// If there are 2^32 points.
    pub fn insert(&mut self, point: PlanPoint) -> u32 {
        if let Some(&number) = self.numbers.get(&point) {
            return number;
        }
        let number = u32::try_from(self.points.len()).expect("fewer than 2^32 points");
        let small = point.small_integers();
        match small.filter(|small| small.iter().all(|c| c.unsigned_abs() < SHORT)) {
            Some(small) => self.short.iter_mut().for_each(|short| short.push(small)),
            None => self.short = None,
        }
        self.largest = point.floats().iter().fold(self.largest, |m, c| m.max(c.abs()));
        self.bound = error_bound(self.largest);
        self.numbers.insert(point.clone(), number);
        self.floats.push(point.floats());
        self.points.push(point);
        number
    }

    /// The number of a point, if it is there.
    pub fn find(&self, point: &PlanPoint) -> Option<u32> {
        self.numbers.get(point).copied()
    }

    /// How many points there are.
    pub fn len(&self) -> usize {
        self.points.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.points.is_empty()
    }

    /// A point.
    ///
    /// # Panics
    /// If there is no such point.
    #[inline]
    pub fn get(&self, number: u32) -> &PlanPoint {
        &self.points[number as usize]
    }

    /// Whether `a`, `b`, `c` turn left; [`turn_of_points`](super::turn_of_points) by number.
    ///
    /// Contract: exact, degree 3 in x, y, w, unperturbed
    #[inline]
    pub fn turn(&self, a: u32, b: u32, c: u32) -> Sign {
        let (i, j, k) = (a as usize, b as usize, c as usize);
        if let Some(short) = &self.short {
            let ([ax, ay], [bx, by], [cx, cy]) = (short[i], short[j], short[k]);
            return Sign::of(&((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)));
        }
        match turn_filter(self.floats[i], self.floats[j], self.floats[k], self.bound) {
            Some(sign) => sign,
            None => self.turn_by_exact_stages(a, b, c),
        }
    }

    #[inline(never)]
    fn turn_by_exact_stages(&self, a: u32, b: u32, c: u32) -> Sign {
        if a == b || b == c || a == c {
            return Sign::Zero;
        }
        turn_exact(self.get(a), self.get(b), self.get(c))
    }

    /// Whether a point lies above a vertex, or on its level and to the right: half a turn, in which
    /// each line through the vertex has one direction.
    ///
    /// Contract: exact, degree 2 in x, y, w, unperturbed
    pub fn is_upper(&self, vertex: u32, point: u32) -> bool {
        let [v, p] = [vertex, point].map(|number| self.get(number));
        match compare_coordinates(1, v, p) {
            Ordering::Less => true,
            Ordering::Equal => compare_coordinates(0, v, p) == Ordering::Less,
            Ordering::Greater => false,
        }
    }

    /// The order of the lines through a vertex and two points, each with whether it
    /// [is upper](PlanPoints::is_upper), by their directions in the upper half turn; equal where
    /// they are one line.
    ///
    /// Contract: exact, degree 3 in x, y, w, unperturbed
    pub fn compare_lines(
        &self,
        vertex: u32,
        (p, p_is_upper): (u32, bool),
        (q, q_is_upper): (u32, bool),
    ) -> Ordering {
        let turn = self.turn(vertex, p, q);
        match if p_is_upper == q_is_upper { turn } else { -turn } {
            Sign::Positive => Ordering::Less,
            // One line through both.
            Sign::Zero => Ordering::Equal,
            Sign::Negative => Ordering::Greater,
        }
    }

    /// The order of `v` and `w` along the directed line from `p` to `q`.
    ///
    /// Requires: `p` and `q` are distinct.
    ///
    /// Contract: exact, degree 2 in x, y, w, unperturbed
    pub fn compare_along(&self, [p, q]: [u32; 2], v: u32, w: u32) -> Ordering {
        let [p, q, v, w] = [p, q, v, w].map(|number| self.get(number));
        for axis in [0, 1] {
            match compare_coordinates(axis, p, q) {
                Ordering::Less => return compare_coordinates(axis, v, w),
                Ordering::Greater => return compare_coordinates(axis, w, v),
                // The line is square to this axis.
                Ordering::Equal => {}
            }
        }
        unreachable!("a line through one point")
    }
}
