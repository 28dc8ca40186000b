//! The sign of an exact number: what every predicate returns.

use std::cmp::Ordering;
use std::ops::{Mul, Neg};

/// The sign of an exact number.
///
/// Its values are those of [`Ordering`], so that one turns into the other for nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Sign {
    /// Less than zero.
    Negative = -1,
    /// Exactly zero: a degeneracy, never a rounding.
    Zero = 0,
    /// Greater than zero.
    Positive = 1,
}

impl Sign {
    /// The sign of `value`, by comparison with the zero of its type.
    #[inline]
    pub fn of<T: PartialOrd + Default>(value: &T) -> Sign {
        let zero = T::default();
        // Comparing the two answers takes no branch, and signs are as unpredictable as coins.
        (*value > zero).cmp(&(*value < zero)).into()
    }
}

impl From<Ordering> for Sign {
    /// `a.cmp(&b)` becomes the sign of `a - b`.
    #[inline]
    fn from(ordering: Ordering) -> Sign {
        match ordering {
            Ordering::Less => Sign::Negative,
            Ordering::Equal => Sign::Zero,
            Ordering::Greater => Sign::Positive,
        }
    }
}

impl Neg for Sign {
    type Output = Sign;
    #[inline]
    fn neg(self) -> Sign {
        match self {
            Sign::Negative => Sign::Positive,
            Sign::Zero => Sign::Zero,
            Sign::Positive => Sign::Negative,
        }
    }
}

impl Mul for Sign {
    type Output = Sign;
    #[inline]
    fn mul(self, other: Sign) -> Sign {
        match self {
            Sign::Negative => -other,
            Sign::Zero => Sign::Zero,
            Sign::Positive => other,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn products_follow_the_rule_of_signs() {
        let all = [(-1, Sign::Negative), (0, Sign::Zero), (1, Sign::Positive)];
        for (x, a) in all {
            assert_eq!(Sign::of(&x), a);
            assert_eq!(-a, Sign::of(&-x));
            for (y, b) in all {
                assert_eq!(a * b, Sign::of(&(x * y)));
            }
        }
    }
}
