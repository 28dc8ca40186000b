//! The arithmetic that the cone is built with: one private trait, so that the same code runs on
//! unbounded and on fixed-width integers.

use crate::num::{Int, Sign};
use num_bigint::Sign as BigSign;

/// Integers in which the coordinates of rays fit, and the narrower ones of constraints.
pub(super) trait Ring: Clone + std::fmt::Debug {
    /// A coordinate of a constraint.
    type Narrow: Clone + std::fmt::Debug;

    /// The integer as a coordinate of a constraint, where it fits.
    fn narrow(value: &Int) -> Option<Self::Narrow>;
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
}

impl Ring for Int {
    type Narrow = Int;

    fn narrow(value: &Int) -> Option<Int> {
        Some(value.clone())
    }

    fn zero() -> Int {
        Int::ZERO
    }

    fn one() -> Int {
        Int::from(1)
    }

    fn is_zero(&self) -> bool {
        self.magnitude().bits() == 0
    }

    fn sign(&self) -> Sign {
        sign_of(self)
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
}

/// The sign of an unbounded integer.
pub(super) fn sign_of(value: &Int) -> Sign {
    match value.sign() {
        BigSign::Minus => Sign::Negative,
        BigSign::NoSign => Sign::Zero,
        BigSign::Plus => Sign::Positive,
    }
}
