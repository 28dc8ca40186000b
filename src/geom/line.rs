//! Directed lines by their Plücker coordinates.
//!
//! The line through p and q has the coordinates (direction, moment) = (d, m) = (q - p, p x q).
//! Teller's (Visibility computations in densely occluded polyhedral environments, 1992, section
//! 6.1) are π0 … π5 = m_z, -m_y, -d_x, m_x, -d_z, d_y, and his inner product (equation 6.2) is
//! the negative of d·m' + m·d'.

use super::{BigPoint3, Point3};
use crate::num::Int;

/// The largest magnitude of the coordinates of two points whose line [`Line`] holds.
const MAX_COORDINATE: i64 = 1 << 38;

/// A directed line through two points: integer Plücker coordinates, held exactly in floats.
///
/// For points of |coordinate| <= 2^b, b <= 38: |direction| <= 2^(b+1), |moment| <= 2^(2b+1).
///
/// Pairs of floats lie side by side, and aligned, so that one instruction multiplies both.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(16))]
pub struct Line {
    /// Each coordinate twice.
    direction: [[f64; 2]; 3],
    /// The nearest multiple of 2^25, and what remains, at most 2^24 in magnitude.
    moment: [[f64; 2]; 3],
}

/// A directed line with unbounded Plücker coordinates.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct BigLine {
    /// q - p.
    pub direction: [Int; 3],
    /// p x q.
    pub moment: [Int; 3],
}

impl Line {
    /// Moments are split at a multiple of this: 2^25.
    pub const SPLIT: i64 = 1 << 25;

    /// The line from `p` through `q`, or `None` where a coordinate exceeds 2^38 in magnitude
    /// ([`BigLine::through`] has no limit).
    ///
    /// Two equal points give zeros, which every predicate calls a zero.
    pub fn through(p: &Point3, q: &Point3) -> Option<Line> {
        let (p, q) = (p.integers(), q.integers());
        if [p, q].as_flattened().iter().any(|x| x.abs() > MAX_COORDINATE) {
            return None;
        }
        let product = |i: usize, j: usize| i128::from(p[i]) * i128::from(q[j]);
        let split = |i: usize, j: usize| {
            let m = product(i, j) - product(j, i);
            let split = i128::from(Line::SPLIT);
            let low = (m + split / 2).rem_euclid(split) - split / 2;
            [(m - low) as f64, low as f64]
        };
        Some(Line {
            direction: std::array::from_fn(|i| [(q[i] - p[i]) as f64; 2]),
            moment: [split(1, 2), split(2, 0), split(0, 1)],
        })
    }

    /// q - p.
    #[inline]
    pub fn direction(&self) -> [i64; 3] {
        self.direction.map(|[d, _]| d as i64)
    }

    /// p x q.
    #[inline]
    pub fn moment(&self) -> [i128; 3] {
        // The high part has at most 2·38 + 1 bits, the quotient fits an i64.
        let whole = |x: f64| i128::from(x as i64);
        let split = Line::SPLIT;
        self.moment.map(|[high, low]| whole(high / split as f64) * i128::from(split) + whole(low))
    }

    /// The direction in floats, exactly, each coordinate twice.
    #[inline]
    pub fn paired_direction(&self) -> &[[f64; 2]; 3] {
        &self.direction
    }

    /// The moment in floats, exactly: the nearest multiples of 2^25, and what remains.
    #[inline]
    pub fn split_moment(&self) -> &[[f64; 2]; 3] {
        &self.moment
    }

    /// The same line in the other direction.
    pub fn reversed(&self) -> Line {
        Line {
            direction: self.direction.map(|pair| pair.map(|c| -c)),
            moment: self.moment.map(|parts| parts.map(|c| -c)),
        }
    }
}

impl BigLine {
    /// The line from `p` through `q`.
    pub fn through(p: &BigPoint3, q: &BigPoint3) -> BigLine {
        let [p, q] = [&p.coordinates, &q.coordinates];
        let minor = |i: usize, j: usize| &p[i] * &q[j] - &p[j] * &q[i];
        BigLine {
            direction: std::array::from_fn(|i| &q[i] - &p[i]),
            moment: [minor(1, 2), minor(2, 0), minor(0, 1)],
        }
    }
}

impl From<Line> for BigLine {
    fn from(line: Line) -> BigLine {
        BigLine { direction: line.direction().map(Int::from), moment: line.moment().map(Int::from) }
    }
}
