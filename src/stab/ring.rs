//! The arithmetic that the cone is built with: one private trait, so that the same code runs on
//! unbounded and on fixed-width integers.
//!
//! **Ranges.** Let every row have moments (its first three entries) of at most m bits and
//! directions (its last three) of at most d bits. A ray's coordinate is a 5x5 minor of rows and
//! unit vectors, a ray's product with a row a 6x6 determinant; each is a sum of at most 6! = 720
//! products of at most three moments and three directions, so with all its partial sums below
//! 2^(3m + 3d + 9.5). A width of w bits therefore serves while 3m + 3d + 11 <= w. A side product
//! is a sum of six products of two coordinates: below 2^(2w - 2 + 2.6), within 2w bits less one
//! because coordinates, having one row factor less than the determinants, are at least one bit
//! shorter than w - 1. Its square comparison takes 4w bits.

use crate::num::{Int, Sign, Wide};

/// Integers in which the coordinates of rays fit, and the narrower ones of constraints.
pub(super) trait Ring: Clone + std::fmt::Debug {
    /// A coordinate of a constraint.
    type Narrow: Clone + std::fmt::Debug;
    /// The side product of two rays.
    type Product: Clone;

    /// The largest 3m + 3d that the type serves, or `None` where there is no limit.
    const BUDGET: Option<u64>;

    /// The integer as a coordinate of a constraint, where it fits.
    fn narrow(value: &Int) -> Option<Self::Narrow>;
    fn narrow_to_int(value: &Self::Narrow) -> Int;
    fn zero_or_one(one: bool) -> Self::Narrow;
    fn narrow_is_zero(value: &Self::Narrow) -> bool;
    fn zero() -> Self;
    fn one() -> Self;
    fn is_zero(&self) -> bool;
    fn sign(&self) -> Sign;
    fn negated(&self) -> Self;
    /// `self += factor * row`.
    fn add_product(&mut self, factor: &Self, row: &Self::Narrow);
    /// `self -= factor * row`.
    fn subtract_product(&mut self, factor: &Self, row: &Self::Narrow);
    fn to_int(&self) -> Int;
    fn from_int(value: &Int) -> Option<Self>;
    /// d_x · m_y + m_x · d_y.
    fn side(x: &[Self; 6], y: &[Self; 6]) -> Self::Product;
    fn sign_of(product: &Self::Product) -> Sign;
    /// Is rs² > rr · ss?
    fn square_exceeds(rs: &Self::Product, rr: &Self::Product, ss: &Self::Product) -> bool;
}

impl Ring for Int {
    type Narrow = Int;
    type Product = Int;

    const BUDGET: Option<u64> = None;

    fn narrow(value: &Int) -> Option<Int> {
        Some(value.clone())
    }

    fn narrow_to_int(value: &Int) -> Int {
        value.clone()
    }

    fn zero_or_one(one: bool) -> Int {
        Int::from(u8::from(one))
    }

    fn narrow_is_zero(value: &Int) -> bool {
        *value == Int::ZERO
    }

    fn zero() -> Int {
        Int::ZERO
    }

    fn one() -> Int {
        Int::from(1)
    }

    fn is_zero(&self) -> bool {
        *self == Int::ZERO
    }

    fn sign(&self) -> Sign {
        Sign::of(self)
    }

    fn negated(&self) -> Int {
        -self
    }

    fn add_product(&mut self, factor: &Int, row: &Int) {
        if !Ring::is_zero(factor) && !Ring::is_zero(row) {
            *self += factor * row;
        }
    }

    fn subtract_product(&mut self, factor: &Int, row: &Int) {
        if !Ring::is_zero(factor) && !Ring::is_zero(row) {
            *self -= factor * row;
        }
    }

    fn to_int(&self) -> Int {
        self.clone()
    }

    fn from_int(value: &Int) -> Option<Int> {
        Some(value.clone())
    }

    fn side(x: &[Int; 6], y: &[Int; 6]) -> Int {
        (0..6).map(|i| &x[i] * &y[(i + 3) % 6]).sum()
    }

    fn sign_of(product: &Int) -> Sign {
        Sign::of(product)
    }

    fn square_exceeds(rs: &Int, rr: &Int, ss: &Int) -> bool {
        rs * rs > rr * ss
    }
}

impl Ring for i128 {
    type Narrow = i64;
    type Product = Wide<4>;

    const BUDGET: Option<u64> = Some(128 - 11);

    fn narrow(value: &Int) -> Option<i64> {
        value.try_into().ok()
    }

    fn narrow_to_int(value: &i64) -> Int {
        Int::from(*value)
    }

    fn zero_or_one(one: bool) -> i64 {
        i64::from(one)
    }

    fn narrow_is_zero(value: &i64) -> bool {
        *value == 0
    }

    fn zero() -> i128 {
        0
    }

    fn one() -> i128 {
        1
    }

    fn is_zero(&self) -> bool {
        *self == 0
    }

    fn sign(&self) -> Sign {
        Sign::of(self)
    }

    fn negated(&self) -> i128 {
        -self
    }

    fn add_product(&mut self, factor: &i128, row: &i64) {
        *self += factor * i128::from(*row);
    }

    fn subtract_product(&mut self, factor: &i128, row: &i64) {
        *self -= factor * i128::from(*row);
    }

    fn to_int(&self) -> Int {
        Int::from(*self)
    }

    fn from_int(value: &Int) -> Option<i128> {
        value.try_into().ok()
    }

    fn side(x: &[i128; 6], y: &[i128; 6]) -> Wide<4> {
        (0..6).map(|i| Wide::product(x[i], y[(i + 3) % 6])).fold(Wide::ZERO, |sum, term| sum + term)
    }

    fn sign_of(product: &Wide<4>) -> Sign {
        product.sign()
    }

    fn square_exceeds(rs: &Wide<4>, rr: &Wide<4>, ss: &Wide<4>) -> bool {
        rs.times::<4, 8>(rs) > rr.times::<4, 8>(ss)
    }
}

/// A fixed width of `$limbs` limbs, its products twice and four times as wide.
macro_rules! fixed_width {
    ($limbs:literal, $double:literal, $fourfold:literal) => {
        impl Ring for Wide<$limbs> {
            type Narrow = i64;
            type Product = Wide<$double>;

            const BUDGET: Option<u64> = Some(64 * $limbs - 11);

            fn narrow(value: &Int) -> Option<i64> {
                value.try_into().ok()
            }

            fn narrow_to_int(value: &i64) -> Int {
                Int::from(*value)
            }

            fn zero_or_one(one: bool) -> i64 {
                i64::from(one)
            }

            fn narrow_is_zero(value: &i64) -> bool {
                *value == 0
            }

            fn zero() -> Self {
                Wide::ZERO
            }

            fn one() -> Self {
                Wide::from(1i64)
            }

            fn is_zero(&self) -> bool {
                Wide::is_zero(self)
            }

            fn sign(&self) -> Sign {
                Wide::sign(self)
            }

            fn negated(&self) -> Self {
                -*self
            }

            fn add_product(&mut self, factor: &Self, row: &i64) {
                *self += factor.times_i64(*row);
            }

            fn subtract_product(&mut self, factor: &Self, row: &i64) {
                *self -= factor.times_i64(*row);
            }

            fn to_int(&self) -> Int {
                Wide::to_int(self)
            }

            fn from_int(value: &Int) -> Option<Self> {
                Wide::from_int(value)
            }

            fn side(x: &[Self; 6], y: &[Self; 6]) -> Wide<$double> {
                (0..6)
                    .map(|i| x[i].times::<$limbs, $double>(&y[(i + 3) % 6]))
                    .fold(Wide::ZERO, |sum, term| sum + term)
            }

            fn sign_of(product: &Wide<$double>) -> Sign {
                product.sign()
            }

            fn square_exceeds(rs: &Wide<$double>, rr: &Wide<$double>, ss: &Wide<$double>) -> bool {
                rs.times::<$double, $fourfold>(rs) > rr.times::<$double, $fourfold>(ss)
            }
        }
    };
}

fixed_width!(3, 6, 12);
fixed_width!(4, 8, 16);
fixed_width!(5, 10, 20);
