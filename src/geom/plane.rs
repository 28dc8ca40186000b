//! Planes by their integer coefficients.

use super::{BigPoint3, Point3};
use crate::num::Int;

/// The largest magnitude of the coordinates of three points whose plane [`Plane`] holds.
const MAX_COORDINATE: i64 = 1 << 40;

/// The plane n·x = offset, with integer coefficients. Its positive side is n·x > offset.
///
/// For points of |coordinate| <= 2^b, b <= 40: |n| < 2^(2b+3), |offset| < 2^(3b+5).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// The nearest floats of the normal and of the offset.
    floats: ([f64; 3], f64),
    normal: [i128; 3],
    offset: i128,
}

/// The plane n·x = offset with unbounded coefficients.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct BigPlane {
    /// A normal, towards the positive side; not reduced.
    pub normal: [Int; 3],
    /// The value of n·x on the plane.
    pub offset: Int,
}

impl Plane {
    /// The plane of three points, positive where they are seen counter-clockwise from; `None`
    /// where a coordinate exceeds 2^40 in magnitude ([`BigPlane::through`] has no limit).
    ///
    /// Collinear points give the normal zero, which every predicate calls a zero.
    pub fn through(a: &Point3, b: &Point3, c: &Point3) -> Option<Plane> {
        let [a, b, c] = [a, b, c].map(Point3::integers);
        if [a, b, c].as_flattened().iter().any(|x| x.abs() > MAX_COORDINATE) {
            return None;
        }
        let p: [i128; 3] = std::array::from_fn(|i| i128::from(b[i] - a[i]));
        let q: [i128; 3] = std::array::from_fn(|i| i128::from(c[i] - a[i]));
        let normal =
            [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];
        let offset = (0..3).map(|i| normal[i] * i128::from(a[i])).sum();
        Some(Plane::new(normal, offset))
    }

    /// The normal, towards the positive side; not reduced.
    #[inline]
    pub fn normal(&self) -> [i128; 3] {
        self.normal
    }

    /// The value of n·x on the plane.
    #[inline]
    pub fn offset(&self) -> i128 {
        self.offset
    }

    /// The same plane, positive on its other side.
    pub fn flipped(&self) -> Plane {
        Plane::new(self.normal.map(|n| -n), -self.offset)
    }

    /// The nearest floats of the normal and of the offset.
    #[inline]
    pub fn floats(&self) -> &([f64; 3], f64) {
        &self.floats
    }

    fn new(normal: [i128; 3], offset: i128) -> Plane {
        Plane { floats: (normal.map(|n| n as f64), offset as f64), normal, offset }
    }
}

impl BigPlane {
    /// The plane of three points, positive where they are seen counter-clockwise from.
    pub fn through(a: &BigPoint3, b: &BigPoint3, c: &BigPoint3) -> BigPlane {
        let [a, b, c] = [&a.coordinates, &b.coordinates, &c.coordinates];
        let p: [Int; 3] = std::array::from_fn(|i| &b[i] - &a[i]);
        let q: [Int; 3] = std::array::from_fn(|i| &c[i] - &a[i]);
        let minor = |i: usize, j: usize| &p[i] * &q[j] - &p[j] * &q[i];
        let normal = [minor(1, 2), minor(2, 0), minor(0, 1)];
        let offset = (0..3).map(|i| &normal[i] * &a[i]).sum();
        BigPlane { normal, offset }
    }
}

impl From<Plane> for BigPlane {
    fn from(plane: Plane) -> BigPlane {
        BigPlane { normal: plane.normal.map(Int::from), offset: plane.offset.into() }
    }
}
