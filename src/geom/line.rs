//! Directed lines by their Plücker coordinates.
//!
//! The line through p and q has the coordinates (direction, moment) = (d, m) = (q - p, p x q).
//! Teller's (Visibility computations in densely occluded polyhedral environments, 1992, section
//! 6.1) are π0 … π5 = m_z, -m_y, -d_x, m_x, -d_z, d_y, and his inner product (equation 6.2) is
//! the negative of d·m' + m·d'.

use super::{BigPoint3, Point3};
use crate::num::Int;

/// A directed line through two points: integer Plücker coordinates.
///
/// For points of |coordinate| <= 2^b: |direction| <= 2^(b+1), |moment| <= 2^(2b+1).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// The nearest floats of the direction and of the moment.
    floats: ([f64; 3], [f64; 3]),
    direction: [i64; 3],
    moment: [i128; 3],
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
    /// The line from `p` through `q`. Two equal points give zeros, which every predicate calls a
    /// zero.
    pub fn through(p: &Point3, q: &Point3) -> Line {
        let (p, q) = (p.integers(), q.integers());
        let product = |i: usize, j: usize| i128::from(p[i]) * i128::from(q[j]);
        let minor = |i: usize, j: usize| product(i, j) - product(j, i);
        let moment = [minor(1, 2), minor(2, 0), minor(0, 1)];
        let direction: [i64; 3] = std::array::from_fn(|i| q[i] - p[i]);
        let floats = (direction.map(|d| d as f64), moment.map(|m| m as f64));
        Line { floats, direction, moment }
    }

    /// q - p.
    #[inline]
    pub fn direction(&self) -> [i64; 3] {
        self.direction
    }

    /// p x q.
    #[inline]
    pub fn moment(&self) -> [i128; 3] {
        self.moment
    }

    /// The nearest floats of the direction and of the moment.
    #[inline]
    pub fn floats(&self) -> &([f64; 3], [f64; 3]) {
        &self.floats
    }

    /// The same line in the other direction.
    pub fn reversed(&self) -> Line {
        Line {
            floats: (self.floats.0.map(|c| -c), self.floats.1.map(|c| -c)),
            direction: self.direction.map(|c| -c),
            moment: self.moment.map(|c| -c),
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
        BigLine { direction: line.direction.map(Int::from), moment: line.moment.map(Int::from) }
    }
}
