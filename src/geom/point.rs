//! Points of a scene's grid, in grid units.
//!
//! Two ranges: [`Point2`] and [`Point3`] hold integers up to 2^53 in magnitude, as every level of
//! a game does, so that each is also a float exactly; [`BigPoint2`] and [`BigPoint3`] hold any
//! integers. The small ones are kept as integers, because the predicates on points decide in
//! integers at once (`docs/predicates.md` says why: a float stage does not pay there).

use crate::num::Int;
use num_traits::ToPrimitive;

/// The largest magnitude of a coordinate of [`Point2`] and [`Point3`]: every integer up to here
/// is an `f64`.
const MAX_COORDINATE: i64 = 1 << 53;

fn coordinate(value: i64) -> Option<i64> {
    (value.unsigned_abs() <= MAX_COORDINATE.unsigned_abs()).then_some(value)
}

/// A point of the plane: integers of magnitude up to 2^53.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Point2 {
    /// Invariant: at most 2^53 in magnitude.
    coordinates: [i64; 2],
}

/// A point of space: integers of magnitude up to 2^53.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Point3 {
    /// Invariant: at most 2^53 in magnitude.
    coordinates: [i64; 3],
}

impl Point2 {
    /// The point `(x, y)`, or `None` where a coordinate exceeds 2^53 in magnitude.
    pub fn new(x: i64, y: i64) -> Option<Point2> {
        Some(Point2 { coordinates: [coordinate(x)?, coordinate(y)?] })
    }

    /// The coordinates as floats, which hold them exactly.
    #[inline]
    pub fn floats(&self) -> [f64; 2] {
        self.coordinates.map(|c| c as f64)
    }

    /// The coordinates as integers.
    #[inline]
    pub fn integers(&self) -> [i64; 2] {
        self.coordinates
    }
}

impl Point3 {
    /// The point `(x, y, z)`, or `None` where a coordinate exceeds 2^53 in magnitude.
    pub fn new(x: i64, y: i64, z: i64) -> Option<Point3> {
        Some(Point3 { coordinates: [coordinate(x)?, coordinate(y)?, coordinate(z)?] })
    }

    /// The coordinates as floats, which hold them exactly.
    #[inline]
    pub fn floats(&self) -> [f64; 3] {
        self.coordinates.map(|c| c as f64)
    }

    /// The coordinates as integers.
    #[inline]
    pub fn integers(&self) -> [i64; 3] {
        self.coordinates
    }
}

/// A point of the plane with unbounded integer coordinates.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct BigPoint2 {
    /// x and y.
    pub coordinates: [Int; 2],
}

/// A point of space with unbounded integer coordinates.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct BigPoint3 {
    /// x, y and z.
    pub coordinates: [Int; 3],
}

impl BigPoint2 {
    /// The same point with small coordinates, where they fit.
    pub fn to_small(&self) -> Option<Point2> {
        let [x, y] = &self.coordinates;
        Point2::new(x.to_i64()?, y.to_i64()?)
    }
}

impl BigPoint3 {
    /// The same point with small coordinates, where they fit.
    pub fn to_small(&self) -> Option<Point3> {
        let [x, y, z] = &self.coordinates;
        Point3::new(x.to_i64()?, y.to_i64()?, z.to_i64()?)
    }
}

impl From<Point2> for BigPoint2 {
    fn from(point: Point2) -> BigPoint2 {
        BigPoint2 { coordinates: point.integers().map(Int::from) }
    }
}

impl From<Point3> for BigPoint3 {
    fn from(point: Point3) -> BigPoint3 {
        BigPoint3 { coordinates: point.integers().map(Int::from) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_hold_every_integer_up_to_the_limit() {
        for c in [0, 1, -1, MAX_COORDINATE - 1, MAX_COORDINATE, -MAX_COORDINATE] {
            let point = Point3::new(c, -c, 0).unwrap();
            assert_eq!(point.integers(), [c, -c, 0]);
            assert_eq!(BigPoint3::from(point).to_small(), Some(point));
        }
        assert_eq!(Point3::new(MAX_COORDINATE + 1, 0, 0), None);
        assert_eq!(Point2::new(0, i64::MIN + 1), None);
    }
}
