//! Points of a scene's grid, in grid units.
//!
//! Two ranges: [`Point2`] and [`Point3`] hold integers up to 2^53 in magnitude, as every level of
//! a game does, so that each is also a float exactly; [`BigPoint2`] and [`BigPoint3`] hold any
//! integers. The small ones are kept as integers, because the predicates on points decide in
//! integers at once (`docs/predicates.md` says why: a float stage does not pay there).

use crate::num::{Int, Number, Rational};
use num_integer::Integer;
use num_traits::{One, ToPrimitive};

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

/// A point of space with rational coordinates, in lowest terms over one denominator: equal points
/// are equal values.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct RationalPoint3 {
    numerators: [Int; 3],
    denominator: Int,
}

impl RationalPoint3 {
    /// The point `numerators / denominator`.
    ///
    /// # Panics
    /// If the denominator is zero.
    pub fn new(numerators: [Int; 3], denominator: Int) -> RationalPoint3 {
        assert!(denominator != Int::ZERO, "a point at infinity");
        let mut divisor = denominator.clone();
        for numerator in &numerators {
            if divisor.is_one() {
                break;
            }
            divisor = divisor.gcd(numerator);
        }
        if denominator < Int::ZERO {
            divisor = -divisor;
        }
        if divisor.is_one() {
            return RationalPoint3 { numerators, denominator };
        }
        RationalPoint3 {
            numerators: numerators.map(|c| c / &divisor),
            denominator: denominator / &divisor,
        }
    }

    /// Of x, y and z, over [`RationalPoint3::denominator`].
    pub fn numerators(&self) -> &[Int; 3] {
        &self.numerators
    }

    /// The least positive common denominator of x, y and z.
    pub fn denominator(&self) -> &Int {
        &self.denominator
    }

    /// The lowest common denominator of some points, 1 for none.
    pub fn common_denominator<'a>(points: impl IntoIterator<Item = &'a RationalPoint3>) -> Int {
        points.into_iter().fold(Int::from(1), |common, point| point.common_with(common))
    }

    /// The lowest common multiple of the denominator and `common`.
    pub fn common_with(&self, common: Int) -> Int {
        // Mostly equal to one met before, and a remainder costs less than a common divisor.
        if common.is_multiple_of(&self.denominator) {
            common
        } else {
            common.lcm(&self.denominator)
        }
    }

    /// The point in units of `1 / grid`.
    ///
    /// Requires: `grid` is a multiple of the denominator.
    pub fn on_grid(&self, grid: &Int) -> BigPoint3 {
        debug_assert!(grid.is_multiple_of(&self.denominator), "the point is off the grid");
        if *grid == self.denominator {
            return BigPoint3 { coordinates: self.numerators.clone() };
        }
        let scale = grid / &self.denominator;
        BigPoint3 { coordinates: self.numerators.each_ref().map(|c| c * &scale) }
    }

    /// x, y and z, each in lowest terms.
    pub fn coordinates(&self) -> [Rational; 3] {
        match self.denominator.is_one() {
            true => self.numerators.clone().map(Rational::from),
            false => self
                .numerators
                .each_ref()
                .map(|c| Rational::new(c.clone(), self.denominator.clone())),
        }
    }
}

impl From<&RationalPoint3> for [Number; 3] {
    fn from(point: &RationalPoint3) -> [Number; 3] {
        point.coordinates().map(Number::from)
    }
}

impl From<&[Rational; 3]> for RationalPoint3 {
    fn from(coordinates: &[Rational; 3]) -> RationalPoint3 {
        let denominator = coordinates.iter().fold(Int::from(1), |common, c| common.lcm(c.denom()));
        // The lowest common denominator of fractions in lowest terms leaves no common divisor.
        let numerators = coordinates.each_ref().map(|c| c.numer() * (&denominator / c.denom()));
        RationalPoint3 { numerators, denominator }
    }
}

impl From<BigPoint3> for RationalPoint3 {
    fn from(point: BigPoint3) -> RationalPoint3 {
        RationalPoint3 { numerators: point.coordinates, denominator: Int::from(1) }
    }
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
    fn rational_points_are_in_lowest_terms() {
        let point = |n: [i64; 3], d: i64| RationalPoint3::new(n.map(Int::from), Int::from(d));
        assert_eq!(point([2, -4, 6], -2), point([-1, 2, -3], 1));
        assert_eq!(point([3, 0, 1], 6).denominator(), &Int::from(6));
        assert_eq!(point([0, 0, 0], -7).denominator(), &Int::from(1));
        let sixths = point([3, -1, 10], 6);
        assert_eq!(RationalPoint3::from(&sixths.coordinates()), sixths);
        let numbers = <[Number; 3]>::from(&sixths);
        assert_eq!(numbers, [Number::Small(1, 2), Number::Small(-1, 6), Number::Small(5, 3)]);
    }

    #[test]
    fn a_common_grid_holds_every_point() {
        let points = [([1, 2, 3], 4), ([5, 0, -1], 6), ([7, 7, 7], 1)]
            .map(|(n, d): ([i64; 3], i64)| RationalPoint3::new(n.map(Int::from), Int::from(d)));
        let grid = RationalPoint3::common_denominator(&points);
        assert_eq!(grid, Int::from(12));
        for point in &points {
            let scaled = RationalPoint3::new(point.on_grid(&grid).coordinates, grid.clone());
            assert_eq!(&scaled, point);
        }
    }

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
