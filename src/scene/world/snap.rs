//! Rounding of coordinates, where the caller asks for it.

use super::WorldWarning;
use crate::geom::RationalPoint3;
use crate::num::{Int, Number, Rational};
use num_traits::Zero;

/// Rounds coordinates to a number of decimals, and keeps account.
#[derive(Clone, Debug)]
pub(super) struct Snap {
    per_unit: Int,
    count: usize,
    largest: Rational,
}

impl Snap {
    pub fn new(decimals: u32) -> Snap {
        Snap { per_unit: Int::from(10).pow(decimals), count: 0, largest: Rational::zero() }
    }

    pub fn number(&mut self, number: &Number) -> Number {
        let (near, moved) = number.rounded(&self.per_unit);
        if !moved.is_zero() {
            self.count += 1;
            self.largest = std::mem::take(&mut self.largest).max(moved);
        }
        Number::from(near)
    }

    pub fn numbers(&mut self, point: &[Number; 3]) -> [Number; 3] {
        point.each_ref().map(|number| self.number(number))
    }

    pub fn point(&mut self, point: &RationalPoint3) -> RationalPoint3 {
        let rounded = self.numbers(&<[Number; 3]>::from(point));
        RationalPoint3::from(&rounded.map(|number| number.to_rational()))
    }

    pub fn warning(self) -> WorldWarning {
        WorldWarning::Snapped { count: self.count, largest: self.largest }
    }
}
