//! Polynomials with integer coefficients, of the low degrees that the twins need.

use crate::num::{Int, Surd};
use num_traits::Zero;

/// The coefficients, constant first; the last one is not zero. Empty for the zero polynomial.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Polynomial(Vec<Int>);

impl Polynomial {
    pub(super) fn linear(constant: Int, slope: Int) -> Polynomial {
        Polynomial(vec![constant, slope]).trimmed()
    }

    fn trimmed(mut self) -> Polynomial {
        while self.0.last().is_some_and(Zero::is_zero) {
            self.0.pop();
        }
        self
    }

    pub(super) fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    pub(super) fn minus(&self, other: &Polynomial) -> Polynomial {
        self.combine(other, |a, b| a - b)
    }

    pub(super) fn plus(&self, other: &Polynomial) -> Polynomial {
        self.combine(other, |a, b| a + b)
    }

    fn combine(&self, other: &Polynomial, operation: fn(Int, Int) -> Int) -> Polynomial {
        let length = self.0.len().max(other.0.len());
        let at = |p: &Polynomial, i: usize| p.0.get(i).cloned().unwrap_or_default();
        Polynomial((0..length).map(|i| operation(at(self, i), at(other, i))).collect()).trimmed()
    }

    pub(super) fn times(&self, other: &Polynomial) -> Polynomial {
        if self.is_zero() || other.is_zero() {
            return Polynomial(Vec::new());
        }
        let mut product = vec![Int::zero(); self.0.len() + other.0.len() - 1];
        for (i, a) in self.0.iter().enumerate() {
            for (j, b) in other.0.iter().enumerate() {
                product[i + j] += a * b;
            }
        }
        Polynomial(product).trimmed()
    }

    /// Whether the polynomial vanishes at a number.
    pub(super) fn vanishes_at(&self, x: &Surd) -> bool {
        let mut value = Surd::from(Int::zero());
        for coefficient in self.0.iter().rev() {
            value = &(&value * x) + &Surd::from(coefficient.clone());
        }
        value.is_zero()
    }

    /// The real roots, in ascending order.
    ///
    /// # Panics
    /// If the polynomial is zero or of degree three or more.
    pub(super) fn roots(&self) -> Vec<Surd> {
        match self.0.as_slice() {
            [_] => Vec::new(),
            [c0, c1] => vec![Surd::from(crate::num::Rational::new(-c0, c1.clone()))],
            [c0, c1, c2] => {
                Surd::roots_of_quadratic(c0, c1, c2).map_or_else(Vec::new, |roots| roots.to_vec())
            }
            _ => panic!("roots are known for degrees 0 to 2, not for {self:?}"),
        }
    }
}
