//! Decimals and ratios read exactly, however many digits they have.

use super::{Int, Rational};
use num_integer::Integer;
use num_traits::{Pow, Zero};

/// Why a text is not a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum DecimalError {
    /// Not of the form `[+-]digits[.digits][e[+-]digits]` or `p/q`.
    #[error("not a decimal number or a ratio of integers")]
    Malformed,
    /// The ratio's denominator is zero.
    #[error("the denominator is zero")]
    ZeroDenominator,
    /// An exponent beyond ±4096: no coordinate needs it, and its digits would fill the memory.
    #[error("the exponent is larger than 4096")]
    HugeExponent,
}

/// Reads `12`, `-12.125`, `1e-3` or `7/3` exactly.
///
/// # Errors
/// [`DecimalError`] for anything else, `nan`, `inf` and the empty text among it.
pub fn parse_decimal(text: &str) -> Result<Rational, DecimalError> {
    if let Some((numerator, denominator)) = text.split_once('/') {
        let denominator = parse_digits(denominator, false)?;
        if denominator.is_zero() {
            return Err(DecimalError::ZeroDenominator);
        }
        return Ok(Rational::new(parse_digits(numerator, true)?, denominator));
    }
    let (mantissa, exponent) = match text.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, parse_exponent(exponent)?),
        None => (text, 0),
    };
    let (negative, unsigned) = match mantissa.as_bytes().first() {
        Some(b'-') => (true, &mantissa[1..]),
        Some(b'+') => (false, &mantissa[1..]),
        _ => (false, mantissa),
    };
    let (whole, fraction) = unsigned.split_once('.').unwrap_or((unsigned, ""));
    if whole.is_empty() && fraction.is_empty() {
        return Err(DecimalError::Malformed);
    }
    let digits = parse_digits(&format!("0{whole}{fraction}"), false)?;
    let digits = if negative { -digits } else { digits };
    let fraction_digits = i64::try_from(fraction.len()).map_err(|_| DecimalError::HugeExponent)?;
    let scale = exponent - fraction_digits;
    let power = Int::from(10u8).pow(scale.unsigned_abs());
    Ok(if scale < 0 { Rational::new(digits, power) } else { Rational::from(digits * power) })
}

fn parse_exponent(text: &str) -> Result<i64, DecimalError> {
    let value = parse_digits(text.strip_prefix('+').unwrap_or(text), true)?;
    let value = i64::try_from(value).map_err(|_| DecimalError::HugeExponent)?;
    if value.abs() > 4096 {
        return Err(DecimalError::HugeExponent);
    }
    Ok(value)
}

fn parse_digits(text: &str, signed: bool) -> Result<Int, DecimalError> {
    let digits = if signed { text.strip_prefix('-').unwrap_or(text) } else { text };
    if digits.is_empty() || !digits.bytes().all(|b| b.is_ascii_digit()) {
        return Err(DecimalError::Malformed);
    }
    text.parse().map_err(|_| DecimalError::Malformed)
}

/// The finite decimal equal to `value`, if there is one: if no prime but 2 and 5 divides its
/// denominator.
pub fn format_decimal(value: &Rational) -> Option<String> {
    let mut rest = value.denom().clone();
    let mut digits = 0u32;
    for prime in [2, 5] {
        let prime = Int::from(prime);
        let mut power = 0;
        while rest.is_multiple_of(&prime) {
            rest /= &prime;
            power += 1;
        }
        digits = digits.max(power);
    }
    if rest != Int::from(1) {
        return None;
    }
    let power: Int = Int::from(10).pow(digits);
    let scaled = (value * power).to_integer();
    let digits = digits as usize;
    let sign = if scaled < Int::ZERO { "-" } else { "" };
    let text = format!("{:0>width$}", scaled.magnitude(), width = digits + 1);
    let (whole, fraction) = text.split_at(text.len() - digits);
    let point = if digits > 0 { "." } else { "" };
    Some(format!("{sign}{whole}{point}{fraction}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ratio(p: i64, q: i64) -> Rational {
        Rational::new(p.into(), q.into())
    }

    #[test]
    fn decimals_are_read_exactly() {
        assert_eq!(parse_decimal("12"), Ok(ratio(12, 1)));
        assert_eq!(parse_decimal("-12.125"), Ok(ratio(-97, 8)));
        assert_eq!(parse_decimal(".5"), Ok(ratio(1, 2)));
        assert_eq!(parse_decimal("5."), Ok(ratio(5, 1)));
        assert_eq!(parse_decimal("-0.000"), Ok(ratio(0, 1)));
        assert_eq!(parse_decimal("1.5e3"), Ok(ratio(1500, 1)));
        assert_eq!(parse_decimal("25E-2"), Ok(ratio(1, 4)));
        assert_eq!(parse_decimal("-6/4"), Ok(ratio(-3, 2)));
        let long = parse_decimal("0.56285683454726874605620706").unwrap();
        assert_eq!(
            long * Int::from(10).pow(26u32),
            "56285683454726874605620706".parse::<Int>().unwrap().into()
        );
    }

    #[test]
    fn decimals_are_written_exactly_or_not_at_all() {
        for text in ["0", "-0.125", "16.5", "0.000001", "-20", "3.2", "1234567890123456789.5"] {
            assert_eq!(format_decimal(&parse_decimal(text).unwrap()).unwrap(), text);
        }
        assert_eq!(format_decimal(&ratio(1, 3)), None);
        assert_eq!(format_decimal(&ratio(-7, 30)), None);
    }

    #[test]
    fn what_is_not_a_number_is_refused() {
        for text in [
            "", "-", ".", "nan", "inf", "1e", "e5", "1..2", "1.2.3", "0x10", "1 2", "--1", "1/-2",
            "1/", "+-1", "1_0", "-.", "1e1.5",
        ] {
            assert_eq!(parse_decimal(text), Err(DecimalError::Malformed), "{text:?}");
        }
        assert_eq!(parse_decimal("1/0"), Err(DecimalError::ZeroDenominator));
        assert_eq!(parse_decimal("1e99999"), Err(DecimalError::HugeExponent));
        assert_eq!(parse_decimal("1e99999999999999999999999"), Err(DecimalError::HugeExponent));
    }
}
