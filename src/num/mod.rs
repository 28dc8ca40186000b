//! Numbers: signs, unbounded integers and rationals, and the exact reading of decimals.
//!
//! Everything in this crate is an integer multiple of a scene's grid unit, or a ratio of such
//! multiples. `Int` and `Rational` are the unbounded types used at the borders (input, output,
//! witnesses, oracles) and as the last stage of a predicate; the fixed-width types of this module
//! serve the stages before it.

mod decimal;
mod number;
mod random;
mod sign;
mod sum;
mod surd;
mod wide;

pub use decimal::{DecimalError, format_decimal, parse_decimal};
pub use number::Number;
pub use random::Random;
pub use sign::Sign;
pub use sum::sum;
pub use surd::{Surd, sign_of_surd, sign_of_two_surds};
pub use wide::{Int192, Int256, Int320, Int512, Wide};

/// An unbounded integer.
pub type Int = num_bigint::BigInt;

/// An unbounded rational, always in lowest terms with a positive denominator.
pub type Rational = num_rational::BigRational;
