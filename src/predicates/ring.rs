//! The formulas of the predicates, written once for every kind of number.

use crate::num::{Int, Int320, Sign};

/// A number that adds, subtracts and multiplies. The only generic over numbers of this crate.
pub(super) trait Ring: Clone {
    fn plus(&self, other: &Self) -> Self;
    fn minus(&self, other: &Self) -> Self;
    fn times(&self, other: &Self) -> Self;
    fn sign(&self) -> Sign;
}

macro_rules! ring {
    ($($number:ty),*) => {$(
        impl Ring for $number {
            #[inline(always)]
            fn plus(&self, other: &Self) -> Self {
                self + other
            }
            #[inline(always)]
            fn minus(&self, other: &Self) -> Self {
                self - other
            }
            #[inline(always)]
            fn times(&self, other: &Self) -> Self {
                self * other
            }
            #[inline(always)]
            fn sign(&self) -> Sign {
                Sign::of(self)
            }
        }
    )*};
}

ring!(f64, i64, i128, Int);

impl Ring for Int320 {
    #[inline(always)]
    fn plus(&self, other: &Self) -> Self {
        *self + *other
    }
    #[inline(always)]
    fn minus(&self, other: &Self) -> Self {
        *self - *other
    }
    #[inline(always)]
    fn times(&self, other: &Self) -> Self {
        Int320::times(self, other)
    }
    #[inline(always)]
    fn sign(&self) -> Sign {
        Int320::sign(self)
    }
}

/// A number modulo 2^64: right as an integer wherever the true value fits.
#[derive(Clone, Copy)]
pub(super) struct Residue(pub i64);

impl Ring for Residue {
    #[inline(always)]
    fn plus(&self, other: &Self) -> Self {
        Residue(self.0.wrapping_add(other.0))
    }
    #[inline(always)]
    fn minus(&self, other: &Self) -> Self {
        Residue(self.0.wrapping_sub(other.0))
    }
    #[inline(always)]
    fn times(&self, other: &Self) -> Self {
        Residue(self.0.wrapping_mul(other.0))
    }
    #[inline(always)]
    fn sign(&self) -> Sign {
        Sign::of(&self.0)
    }
}

/// `array::map`, but always inlined: where many callers share the library's, it may not be.
#[inline(always)]
pub(super) fn each<T, U>([x, y, z]: [T; 3], f: impl Fn(T) -> U) -> [U; 3] {
    [f(x), f(y), f(z)]
}

/// a - b.
#[inline(always)]
pub(super) fn difference<T: Ring>(a: &[T; 3], b: &[T; 3]) -> [T; 3] {
    [a[0].minus(&b[0]), a[1].minus(&b[1]), a[2].minus(&b[2])]
}

/// a x b.
#[inline(always)]
pub(super) fn cross<T: Ring>(a: &[T; 3], b: &[T; 3]) -> [T; 3] {
    let minor = |i: usize, j: usize| a[i].times(&b[j]).minus(&a[j].times(&b[i]));
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

/// a·b.
#[inline(always)]
pub(super) fn dot<T: Ring>(a: &[T; 3], b: &[T; 3]) -> T {
    a[0].times(&b[0]).plus(&a[1].times(&b[1])).plus(&a[2].times(&b[2]))
}

/// (b-a) x (c-a) · (d-a).
#[inline(always)]
pub(super) fn determinant<T: Ring>(a: &[T; 3], b: &[T; 3], c: &[T; 3], d: &[T; 3]) -> T {
    dot(&cross(&difference(b, a), &difference(c, a)), &difference(d, a))
}

/// The sign of an `i128`, without a branch: its upper half, and whether the lower is zero.
#[inline(always)]
pub(super) fn sign_of_i128(value: i128) -> Sign {
    Sign::of(&((value >> 64) as i64 | i64::from(value as u64 != 0)))
}
