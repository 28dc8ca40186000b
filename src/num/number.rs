//! A number as a file states it: a ratio of machine integers while it fits, else unbounded.
//!
//! Files hold tens of thousands of short decimals, and a [`Rational`] costs two allocations and a
//! reduction of big integers each; the small form costs neither.

use super::{DecimalError, Int, Rational, parse_decimal};
use num_integer::Integer;
use num_traits::{Signed, ToPrimitive};

/// A rational number in lowest terms, in one of two sizes.
///
/// Invariants: the denominator is positive, the ratio in lowest terms, and [`Number::Big`] is
/// used only where [`Number::Small`] cannot hold it, so that equal numbers are equal values.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Number {
    /// Numerator and denominator.
    Small(i64, i64),
    /// A ratio that does not fit.
    Big(Box<Rational>),
}

/// 10^18 is the largest power of ten in an `i64`.
const MAX_DIGITS: usize = 18;

impl Number {
    /// Reads what [`parse_decimal`] reads, exactly.
    ///
    /// # Errors
    /// Those of [`parse_decimal`].
    pub fn parse(text: &str) -> Result<Number, DecimalError> {
        match parse_short(text.as_bytes()) {
            Some(number) => Ok(number),
            None => parse_decimal(text).map(Number::from),
        }
    }

    /// The ratio `numerator / denominator` in lowest terms.
    ///
    /// # Panics
    /// If `denominator` is zero.
    pub fn ratio(numerator: i128, denominator: i128) -> Number {
        assert!(denominator != 0, "a ratio with denominator zero");
        // Short of i128::MIN every step fits, and that value goes the long way round.
        if numerator == i128::MIN || denominator == i128::MIN {
            return Rational::new(numerator.into(), denominator.into()).into();
        }
        let divisor = numerator.gcd(&denominator) * denominator.signum();
        let (numerator, denominator) = (numerator / divisor, denominator / divisor);
        match (i64::try_from(numerator), i64::try_from(denominator)) {
            (Ok(numerator), Ok(denominator)) => Number::Small(numerator, denominator),
            _ => Number::Big(Box::new(Rational::new_raw(numerator.into(), denominator.into()))),
        }
    }

    /// The multiple of 1 / `per_unit` next to it, halves away from zero, and how far it is off.
    pub fn rounded(&self, per_unit: &Int) -> (Rational, Rational) {
        let exact = self.to_rational();
        let near = Rational::new((&exact * per_unit).round().to_integer(), per_unit.clone());
        let off = (exact - &near).abs();
        (near, off)
    }

    /// The same number, unbounded.
    pub fn to_rational(&self) -> Rational {
        match self {
            Number::Small(numerator, denominator) => {
                Rational::new_raw(Int::from(*numerator), Int::from(*denominator))
            }
            Number::Big(ratio) => ratio.as_ref().clone(),
        }
    }
}

impl std::fmt::Display for Number {
    /// `p`, or `p/q`.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Number::Small(numerator, 1) => write!(f, "{numerator}"),
            Number::Small(numerator, denominator) => write!(f, "{numerator}/{denominator}"),
            Number::Big(ratio) => write!(f, "{ratio}"),
        }
    }
}

impl From<Int> for Number {
    fn from(integer: Int) -> Number {
        Rational::from(integer).into()
    }
}

impl From<Rational> for Number {
    fn from(ratio: Rational) -> Number {
        match (ratio.numer().to_i64(), ratio.denom().to_i64()) {
            (Some(numerator), Some(denominator)) => Number::Small(numerator, denominator),
            _ => Number::Big(Box::new(ratio)),
        }
    }
}

/// Reads `[+-]digits[.digits]` and `[-]digits/digits` of at most 18 digits each; `None` leaves the
/// text to the general reader.
fn parse_short(text: &[u8]) -> Option<Number> {
    if let Some(slash) = text.iter().position(|&byte| byte == b'/') {
        let (numerator, denominator) = (&text[..slash], &text[slash + 1..]);
        let is_plain = |part: &[u8]| part.iter().all(|byte| !matches!(byte, b'.' | b'+' | b'/'));
        if !is_plain(numerator) || !is_plain(denominator) {
            return None;
        }
        return match (parse_short(numerator)?, parse_short(denominator)?) {
            (Number::Small(numerator, 1), Number::Small(denominator @ 1.., 1)) => {
                let divisor = numerator.gcd(&denominator);
                Some(Number::Small(numerator / divisor, denominator / divisor))
            }
            _ => None,
        };
    }
    let (negative, unsigned) = match text.first()? {
        b'-' => (true, &text[1..]),
        b'+' => (false, &text[1..]),
        _ => (false, text),
    };
    let mut value = 0i64;
    let mut scale = 1i64;
    let mut digits = 0;
    let mut after_point = false;
    for &byte in unsigned {
        match byte {
            b'0'..=b'9' => {
                digits += 1;
                if digits > MAX_DIGITS {
                    return None;
                }
                value = value * 10 + i64::from(byte - b'0');
                if after_point {
                    scale *= 10;
                }
            }
            b'.' if !after_point => after_point = true,
            _ => return None,
        }
    }
    if digits == 0 {
        return None;
    }
    let signed = if negative { -value } else { value };
    if scale == 1 {
        return Some(Number::Small(signed, 1));
    }
    let divisor = value.gcd(&scale);
    Some(Number::Small(signed / divisor, scale / divisor))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounding_tells_how_far_it_moves() {
        let ratio = |p: i64, q: i64| Rational::new(p.into(), q.into());
        let rounded = |text: &str| Number::parse(text).unwrap().rounded(&Int::from(100));
        assert_eq!(rounded("-281.59999"), (ratio(-2816, 10), ratio(1, 100_000)));
        assert_eq!(rounded("0.125"), (ratio(13, 100), ratio(5, 1000)));
        assert_eq!(rounded("7"), (ratio(7, 1), ratio(0, 1)));
    }

    #[test]
    fn ratios_are_in_lowest_terms() {
        assert_eq!(Number::ratio(6, -4), Number::Small(-3, 2));
        assert_eq!(Number::ratio(0, -7), Number::Small(0, 1));
        for (p, q) in [(i128::MIN, 2), (3, i128::MIN), (i128::MAX, 3), (1, i128::from(i64::MIN))] {
            let expected = Rational::new(p.into(), q.into());
            assert_eq!(Number::ratio(p, q), Number::from(expected), "{p}/{q}");
        }
    }

    #[test]
    fn both_sizes_agree_with_the_rational() {
        for text in [
            "0",
            "-0.0",
            "12.125",
            "+7.",
            "-.5",
            "1304.727273",
            "999999999999999999",
            "9999999999999999999",
            "0.56285683454726874605620706",
            "1e-3",
            "7/21",
            "-7/21",
            "0/5",
            "999999999999999999/3",
            "9999999999999999999/3",
            "-123456789012345678.9",
        ] {
            let number = Number::parse(text).unwrap();
            assert_eq!(number.to_rational(), parse_decimal(text).unwrap(), "{text}");
            assert_eq!(number, Number::from(number.to_rational()), "{text}");
        }
        for text in [
            "", "-", ".", "1..2", "nan", "1/0", "--1", "1/-2", "1/2/3", "1/", "/1", "1.0/2",
            "+1/2", "1/+2",
        ] {
            assert_eq!(
                Number::parse(text).unwrap_err(),
                parse_decimal(text).unwrap_err(),
                "{text:?}"
            );
        }
    }
}
