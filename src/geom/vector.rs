//! Vectors of three exact coordinates: what is not a decision, for every type of number.

use std::array::from_fn;
use std::ops::{Add, Mul, Sub};

/// a - b.
pub fn difference<T>(a: &[T; 3], b: &[T; 3]) -> [T; 3]
where
    for<'a> &'a T: Sub<Output = T>,
{
    from_fn(|i| &a[i] - &b[i])
}

/// a · b.
pub fn dot<T: Add<Output = T>>(a: &[T; 3], b: &[T; 3]) -> T
where
    for<'a> &'a T: Mul<Output = T>,
{
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

/// a × b.
pub fn cross<T: Sub<Output = T>>(a: &[T; 3], b: &[T; 3]) -> [T; 3]
where
    for<'a> &'a T: Mul<Output = T>,
{
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| &a[i] * &b[j] - &a[j] * &b[i])
}

/// The determinant of three rows: six times the volume of the pyramid that they span.
pub fn determinant<T: Add<Output = T> + Sub<Output = T>>([a, b, c]: [&[T; 3]; 3]) -> T
where
    for<'a> &'a T: Mul<Output = T>,
{
    dot(a, &cross(b, c))
}
