//! Numbers in options, read exactly.

use super::exit::Failure;
use crate::geom::RationalPoint3;
use crate::num::{Rational, parse_decimal};

/// The `N` numbers of an option, between commas.
pub(super) fn numbers<const N: usize>(option: &str, text: &str) -> Result<[Rational; N], Failure> {
    let read = |part: &str| {
        parse_decimal(part.trim())
            .map_err(|error| Failure::usage(format!("{option}: `{part}`: {error}")))
    };
    let numbers = text.split(',').map(read).collect::<Result<Vec<_>, _>>()?;
    let count = numbers.len();
    numbers.try_into().map_err(|_| {
        Failure::usage(format!("{option}: expected {N} numbers between commas, got {count}"))
    })
}

/// The point of an option.
pub(super) fn point(option: &str, text: &str) -> Result<RationalPoint3, Failure> {
    Ok(RationalPoint3::from(&numbers(option, text)?))
}
