//! Directions from a point, normals of planes through it, and on which side the ones are of the
//! others.
//!
//! All vectors are integer ones: directions to given points, normals that are the cross product of
//! two directions, and directions that are the cross product of two normals. Nothing deeper is
//! made, so that degrees stay bounded. A [`Direction`] holds floats with a bound on their error at
//! once, and its integers as soon as a sign needs them.
//!
//! # Error analysis
//! Model: u = 2^-53; each float operation is in error by at most u times its result, plus 2^-1075
//! where it underflows. A [`FloatVector`] is a float vector and a bound e on the error of each
//! coordinate. Let A and B be the largest magnitudes of the coordinates of two of them.
//! - A coordinate of the cross product is off by 2(A·e_b + B·e_a + e_a·e_b) because of its
//!   factors; its two products round by u·AB each and their difference by u·2AB(1 + u): less than
//!   8u·AB together.
//! - The dot product is off by 3(A·e_b + B·e_a + e_a·e_b) because of its factors; its products
//!   round by 3u·AB, its sums by (2 + 3)u·AB(1 + 3u): less than 16u·AB together.
//! - The bounds are sums of fewer than ten positive floats and products, in error by less than
//!   20u of their value, which the factor 1 + 2^-40 covers; fewer than twenty underflows are
//!   covered by adding 2^-1022.
//!
//! Integers below 2^53 whose products and sums stay below 2^53 are computed without any error:
//! the bound is then 0, and a zero is a proved zero. Invariant: a bound of 0 stands beside
//! integers only. Vectors of more than 128 bits are scaled down before they become floats, so that
//! nothing overflows; if it did, a value or a bound would be infinite or no number, and no sign
//! given.

use crate::num::{Int, Sign};
use num_traits::ToPrimitive;
use std::cell::OnceCell;
use std::rc::Rc;

/// 2^-53: the relative error of one float operation.
const U: f64 = f64::EPSILON / 2.0;

/// Integers below this in magnitude are floats.
const EXACT: f64 = 9_007_199_254_740_992.0;

/// 1 + 2^-40: more than what rounding takes from a bound.
const SLACK: f64 = 1.0 + 1.0 / 1_099_511_627_776.0;

/// Longer vectors are scaled down to this many bits, which keeps their direction: the normals of
/// given ones are then below 2^257, meets of these below 2^515, their inner products below 2^776,
/// and nothing overflows.
const LONGEST: u64 = 128;

/// A vector in floats, and how far each coordinate may be off.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FloatVector {
    coordinates: [f64; 3],
    /// At most this far is the true coordinate from the float; 0 for integers held exactly.
    error: f64,
}

impl FloatVector {
    /// The vector nearest to an integer vector, or to its part by the power of two that leaves
    /// `LONGEST` bits.
    pub fn nearest(exact: &[Int; 3]) -> FloatVector {
        let bits = exact.iter().map(Int::bits).max().unwrap_or(0);
        let excess = bits.saturating_sub(LONGEST);
        let float = |c: &Int| c.to_f64().unwrap_or(f64::INFINITY);
        let coordinates = match excess {
            0 => exact.each_ref().map(float),
            _ => exact.each_ref().map(|c| float(&(c >> excess))),
        };
        let size = largest(&coordinates);
        // Conversion rounds to nearest, within u, and what was shifted out is below 2^-125 of the
        // size: twice u covers both.
        let error = if size < EXACT { 0.0 } else { 2.0 * U * size * SLACK };
        FloatVector { coordinates, error }
    }

    /// The cross product.
    #[must_use]
    pub fn cross(&self, other: &FloatVector) -> FloatVector {
        let ([a, b], [e, f]) = ([self, other].map(|v| v.coordinates), [self.error, other.error]);
        let minor = |i: usize, j: usize| a[i] * b[j] - a[j] * b[i];
        let coordinates = [minor(1, 2), minor(2, 0), minor(0, 1)];
        let (size, other_size) = (largest(&a), largest(&b));
        let product = size * other_size;
        let exact = e == 0.0 && f == 0.0 && 2.0 * product < EXACT;
        let carried = 2.0 * (size * f + other_size * e + e * f);
        let error = (carried + 8.0 * U * product) * SLACK + f64::MIN_POSITIVE;
        FloatVector { coordinates, error: if exact { 0.0 } else { error } }
    }

    /// The sign of the inner product, where the floats prove it.
    pub fn side(&self, other: &FloatVector) -> Option<Sign> {
        let ([a, b], [e, f]) = ([self, other].map(|v| v.coordinates), [self.error, other.error]);
        let value = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        let (size, other_size) = (largest(&a), largest(&b));
        let product = size * other_size;
        if e == 0.0 && f == 0.0 && 3.0 * product < EXACT {
            return Some(Sign::of(&value));
        }
        let carried = 3.0 * (size * f + other_size * e + e * f);
        let error = (carried + 16.0 * U * product) * SLACK + f64::MIN_POSITIVE;
        if !value.is_finite() {
            None
        } else if value > error {
            Some(Sign::Positive)
        } else if value < -error {
            Some(Sign::Negative)
        } else {
            None
        }
    }
}

/// The largest magnitude of a coordinate; no number where one is none.
fn largest(v: &[f64; 3]) -> f64 {
    // `max` would pass over what is no number.
    let [x, y, z] = v.map(f64::abs);
    if (x + y + z).is_nan() { f64::NAN } else { x.max(y).max(z) }
}

/// A direction from a point, or the normal of a plane through it: an integer vector, of which
/// positive multiples mean the same.
#[derive(Debug)]
pub struct Direction {
    float: FloatVector,
    exact: OnceCell<[Int; 3]>,
    /// What it is the cross product of, where it was not given.
    factors: Option<[Rc<Direction>; 2]>,
}

impl Direction {
    /// This vector.
    pub fn new(exact: [Int; 3]) -> Direction {
        let float = FloatVector::nearest(&exact);
        Direction { float, exact: OnceCell::from(exact), factors: None }
    }

    /// The cross product: the normal of the plane that two directions span, or the direction in
    /// which two planes meet.
    pub fn cross(a: &Rc<Direction>, b: &Rc<Direction>) -> Direction {
        let factors = Some([Rc::clone(a), Rc::clone(b)]);
        Direction { float: a.float.cross(&b.float), exact: OnceCell::new(), factors }
    }

    /// Its integers.
    pub fn exact(&self) -> &[Int; 3] {
        self.exact.get_or_init(|| {
            let [a, b] = self.factors.as_ref().expect("what is not given has factors");
            let (a, b) = (a.exact(), b.exact());
            [(1, 2), (2, 0), (0, 1)].map(|(i, j)| &a[i] * &b[j] - &a[j] * &b[i])
        })
    }

    /// Its floats.
    pub fn float(&self) -> &FloatVector {
        &self.float
    }
}

/// On which side of the plane through the origin with the normal `normal` the direction points.
///
/// Positive: to the side of the normal; zero: along the plane.
///
/// 1. Negating either changes the sign; swapping the two keeps it.
/// 2. Positive scaling of either keeps it.
///
/// Requires: nothing.
///
/// Contract: exact, degree 6, unperturbed
///
/// Source: Teller, Visibility computations in densely occluded polyhedral environments, 1992,
/// equation 8.1. The degree is that of the meet of two planes against a third, each through the
/// origin and two points.
pub fn side_of_direction(normal: &Direction, direction: &Direction) -> Sign {
    side_of_direction_filter(normal, direction)
        .unwrap_or_else(|| side_of_direction_big(normal, direction))
}

/// The float stage of [`side_of_direction`].
pub fn side_of_direction_filter(normal: &Direction, direction: &Direction) -> Option<Sign> {
    normal.float.side(&direction.float)
}

/// [`side_of_direction`] on unbounded integers.
pub fn side_of_direction_big(normal: &Direction, direction: &Direction) -> Sign {
    let (n, d) = (normal.exact(), direction.exact());
    Sign::of(&(&n[0] * &d[0] + &n[1] * &d[1] + &n[2] * &d[2]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn direction(v: [i64; 3]) -> Rc<Direction> {
        Rc::new(Direction::new(v.map(Int::from)))
    }

    #[test]
    fn small_integers_are_decided_in_floats_zero_included() {
        let [a, b, c] = [[3, 1, 4], [1, 5, 9], [2, 6, 5]].map(direction);
        let plane = Rc::new(Direction::cross(&a, &b));
        assert_eq!(side_of_direction_filter(&plane, &a), Some(Sign::Zero));
        let sign = side_of_direction_filter(&plane, &c);
        assert_eq!(sign, Some(side_of_direction_big(&plane, &c)));
        assert_eq!(side_of_direction(&c, &plane), side_of_direction(&plane, &c));
    }

    #[test]
    fn huge_integers_are_decided_exactly() {
        let huge = |x: i64| Int::from(10).pow(400) + x;
        let normal = Direction::new([huge(1), -huge(0), Int::ZERO]);
        let along = Direction::new([1, 1, 0].map(Int::from));
        assert_eq!(side_of_direction_filter(&normal, &along), None);
        assert_eq!(side_of_direction(&normal, &along), Sign::Positive);
    }

    #[test]
    fn the_length_of_a_vector_does_not_matter_to_the_floats() {
        let long = |v: [i64; 3]| Rc::new(Direction::new(v.map(|c| (Int::from(c) << 3000) + 1)));
        let [a, b, c, d] = [[3, 1, 4], [1, 5, 9], [2, 6, 5], [-3, 5, 8]].map(long);
        let planes = [(&a, &b), (&c, &d)].map(|(p, q)| Rc::new(Direction::cross(p, q)));
        let ray = Direction::cross(&planes[0], &planes[1]);
        for (n, v) in [(&*planes[0], &*c), (&planes[1], &a), (&ray, &a), (&ray, &planes[0])] {
            let sign = side_of_direction_big(n, v);
            let expected = (sign != Sign::Zero).then_some(sign);
            assert_eq!(side_of_direction_filter(n, v), expected);
        }
    }

    proptest! {
        #[test]
        fn filter_and_integers_agree_near_zero(
            v in prop::array::uniform4(prop::array::uniform3(-9i64..9)),
            nudge in prop::array::uniform4(prop::array::uniform3(-1i64..2)),
            bits in 0u32..55,
        ) {
            let point = |i: usize| direction([0, 1, 2].map(|k| (v[i][k] << bits) + nudge[i][k]));
            let points = [0, 1, 2, 3].map(point);
            let plane = |i: usize, j: usize| Rc::new(Direction::cross(&points[i], &points[j]));
            let planes = [plane(0, 1), plane(2, 3), plane(0, 3)];
            let ray = Direction::cross(&planes[0], &planes[1]);
            for (n, d) in [(&*planes[0], &*points[2]), (&planes[2], &ray), (&planes[0], &ray)] {
                if let Some(sign) = side_of_direction_filter(n, d) {
                    prop_assert_eq!(sign, side_of_direction_big(n, d));
                }
            }
            prop_assert_eq!(side_of_direction(&planes[0], &ray), Sign::Zero);
        }
    }
}
