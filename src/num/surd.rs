//! Numbers a + b√d, exactly.
//!
//! The lines that meet four lines, and the points where such lines cross a plane, have coordinates
//! a + b√d with rational a, b and one integer d per line: the roots of one quadratic. This module
//! decides signs and comparisons of such numbers with integers only, by squaring: once for one
//! radicand, twice (nested) for two different ones.
//!
//! Canonical form of a [`Surd`]: d > 1 is not a square and b ≠ 0, or d = 0 and b = 0. Squares of
//! the primes below 100 are taken out of d; a larger square factor may remain, so equality is
//! decided by comparison and never by looking at the parts.
//!
//! Cost: a constant number of multiplications of the parts; no loop depends on their size but the
//! integer square root that tells squares from other radicands.

use super::{Int, Rational, Sign};
use num_integer::Integer;
use num_traits::{One, Signed, Zero};
use std::cmp::Ordering;
use std::fmt;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// The primes whose squares the canonical form takes out of a radicand.
const SMALL_PRIMES: [u32; 25] = [
    2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53, 59, 61, 67, 71, 73, 79, 83, 89, 97,
];

/// The sign of a + b√d.
///
/// `Positive` means a + b√d > 0.
/// 1. `sign(-a, -b, d) = -sign(a, b, d)`.
/// 2. `sign(k·a, k·b, d) = sign(a, b, d)` for every k > 0.
/// 3. `sign(a, b·k, d) = sign(a, b, d·k²)` for every k > 0.
///
/// Requires: d >= 0.
///
/// Contract: exact, degree 2 in a and b, unperturbed
///
/// Source: the comparison of quadratic numbers by squaring; its use for extremal stabbing lines is
/// Teller 1992, section 6.3.
///
/// # Panics
/// If d is negative.
pub fn sign_of_surd(a: &Int, b: &Int, d: &Int) -> Sign {
    assert!(!d.is_negative(), "the radicand {d} is negative");
    let rational = int_sign(a);
    let irrational = int_sign(b) * int_sign(d);
    sum_sign(rational, irrational, || Sign::from((a * a).cmp(&(b * b * d))))
}

/// The sign of a + b√d + c√e, with two radicands that need not be related.
///
/// `Positive` means a + b√d + c√e > 0. Two nested squarings: with x = a + b√d and y = c√e of
/// opposite signs, the larger of x² and y² decides, and x² - y² is a number with the one
/// radicand d.
/// 1. `sign(-a, -b, d, -c, e) = -sign(a, b, d, c, e)`.
/// 2. `sign(a, b, d, c, e) = sign(a, c, e, b, d)`.
/// 3. `sign(k·a, k·b, d, k·c, e) = sign(a, b, d, c, e)` for every k > 0.
///
/// Requires: d >= 0 and e >= 0.
///
/// Contract: exact, degree 4 in a, b and c, unperturbed
///
/// Source: as for [`sign_of_surd`].
///
/// # Panics
/// If a radicand is negative.
pub fn sign_of_two_surds(a: &Int, b: &Int, d: &Int, c: &Int, e: &Int) -> Sign {
    assert!(!e.is_negative(), "the radicand {e} is negative");
    let first = sign_of_surd(a, b, d);
    let second = int_sign(c) * int_sign(e);
    sum_sign(first, second, || {
        let rational = a * a + b * b * d - c * c * e;
        let irrational = a * b * 2;
        sign_of_surd(&rational, &irrational, d)
    })
}

/// The sign of x + y from the signs of x and y; `squares` is the sign of x² - y², asked for only
/// where x and y pull in opposite directions.
fn sum_sign(x: Sign, y: Sign, squares: impl FnOnce() -> Sign) -> Sign {
    match x {
        // One term vanishes: the other is the sum. No squaring can be wrong about it.
        Sign::Zero => y,
        Sign::Positive | Sign::Negative => {
            if y == -x {
                // x² = y² here means x = -y: the sum is exactly zero.
                x * squares()
            } else {
                x
            }
        }
    }
}

fn int_sign(value: &Int) -> Sign {
    match value.sign() {
        num_bigint::Sign::Minus => Sign::Negative,
        num_bigint::Sign::NoSign => Sign::Zero,
        num_bigint::Sign::Plus => Sign::Positive,
    }
}

/// The number a + b√d, with rational a and b and an integer d >= 0.
///
/// Arithmetic stays within one field Q(√d): the operands' radicands must agree up to a square, or
/// one operand must be rational. Comparison works between any two of them.
#[derive(Clone)]
pub struct Surd {
    a: Rational,
    /// Invariant: zero exactly where `d` is zero.
    b: Rational,
    /// Invariant: zero, or greater than one and not a square.
    d: Int,
}

impl Surd {
    /// The number a + b√d in canonical form.
    ///
    /// # Panics
    /// If d is negative.
    pub fn new(a: Rational, b: Rational, d: Int) -> Surd {
        assert!(!d.is_negative(), "the radicand {d} is negative");
        if b.is_zero() || d.is_zero() {
            return Surd::from(a);
        }
        let (outside, inside) = without_squares(d);
        let b = b * outside;
        if inside.is_one() { Surd::from(a + b) } else { Surd { a, b, d: inside } }
    }

    /// Both real roots of c0 + c1·x + c2·x², the lesser first: two equal ones for a double root,
    /// `None` where there is no real root.
    ///
    /// # Panics
    /// If c2 is zero: the polynomial is not a quadratic.
    pub fn roots_of_quadratic(c0: &Int, c1: &Int, c2: &Int) -> Option<[Surd; 2]> {
        assert!(!c2.is_zero(), "a quadratic needs a leading coefficient");
        let discriminant: Int = c1 * c1 - c0 * c2 * 4;
        if discriminant.is_negative() {
            return None;
        }
        let twice: Int = c2 * 2;
        let centre = Rational::new(-c1, twice.clone());
        let half = Rational::new(Int::one(), twice.abs());
        let upper = Surd::new(centre, half, discriminant);
        // Not the conjugate: in canonical form a rational number has lost the root's sign.
        let lower = &Surd::from(Rational::new(-c1, c2.clone())) - &upper;
        Some([lower, upper])
    }

    /// The rational part a.
    pub fn rational_part(&self) -> &Rational {
        &self.a
    }

    /// The factor b of the root; zero for a rational number.
    pub fn root_part(&self) -> &Rational {
        &self.b
    }

    /// The radicand d; zero for a rational number.
    pub fn radicand(&self) -> &Int {
        &self.d
    }

    /// Whether the number is rational.
    pub fn is_rational(&self) -> bool {
        self.d.is_zero()
    }

    /// Whether the number is zero.
    pub fn is_zero(&self) -> bool {
        // In canonical form √d is irrational, so a + b√d = 0 only where both parts are.
        self.a.is_zero() && self.b.is_zero()
    }

    /// The number's exact sign.
    pub fn sign(&self) -> Sign {
        let (p, q) = (self.a.numer(), self.a.denom());
        if self.is_rational() {
            return int_sign(p);
        }
        let (r, s) = (self.b.numer(), self.b.denom());
        sign_of_surd(&(p * s), &(r * q), &self.d)
    }

    /// The number a - b√d.
    pub fn conjugate(&self) -> Surd {
        Surd { a: self.a.clone(), b: -&self.b, d: self.d.clone() }
    }

    /// The largest integer that is not above the number.
    pub fn floor(&self) -> Int {
        // (A + B√d) / C with C > 0; and the floor of (A + x) / C is that of (A + floor x) / C.
        let common = self.a.denom().lcm(self.b.denom());
        let a = self.a.numer() * (&common / self.a.denom());
        let b = self.b.numer() * (&common / self.b.denom());
        let root = (&b * &b * &self.d).sqrt();
        // The root of a radicand in canonical form is irrational, so a negative one lies strictly
        // between two integers.
        let whole = if b.is_negative() { -root - 1 } else { root };
        (a + whole).div_floor(&common)
    }

    /// The number nearest in `f64`, for display and for proposals only.
    pub fn approximate(&self) -> f64 {
        // 64 bits below the leading bit of the larger part; cancellation is why the parts are not
        // converted one by one.
        let mut scale = Int::one();
        for _ in 0..64 {
            let scaled = self * &Surd::from(Rational::from(scale.clone()));
            let floor = scaled.floor();
            if floor.bits() >= 64 || self.is_zero() {
                return to_f64(&Rational::new(floor, scale));
            }
            scale <<= 64;
        }
        0.0
    }

    /// A rational strictly between two numbers: of those with the least power of two as their
    /// denominator, the smallest.
    ///
    /// # Panics
    /// If `low` is not below `high`.
    pub fn rational_between(low: &Surd, high: &Surd) -> Rational {
        assert!(low < high, "no number lies between {low} and {high}");
        let mut scale = Int::one();
        loop {
            let scaled = low * &Surd::from(Rational::from(scale.clone()));
            let candidate = Rational::new(scaled.floor() + 1, scale.clone());
            if Surd::from(candidate.clone()) < *high {
                return candidate;
            }
            scale <<= 1;
        }
    }

    /// The same number written with another number's radicand, where they share a field.
    fn in_field_of(&self, d: &Int) -> Option<Rational> {
        if self.is_rational() {
            return Some(Rational::zero());
        }
        if self.d == *d {
            return Some(self.b.clone());
        }
        // b√e = (b·√(d·e) / d)·√d, rational in front of √d only if d·e is a square.
        let product = &self.d * d;
        let root = product.sqrt();
        (&root * &root == product).then(|| &self.b * Rational::new(root, d.clone()))
    }

    /// Whether the two numbers lie in one field Q(√d), so that arithmetic between them is defined.
    pub fn shares_field_with(&self, other: &Surd) -> bool {
        self.is_rational() || other.in_field_of(&self.d).is_some()
    }

    /// `self` and `other` over one radicand: both root parts and the radicand.
    fn common(&self, other: &Surd) -> (Rational, Rational, Int) {
        if self.is_rational() {
            return (Rational::zero(), other.b.clone(), other.d.clone());
        }
        let Some(b) = other.in_field_of(&self.d) else {
            panic!("{self} and {other} lie in different fields")
        };
        (self.b.clone(), b, self.d.clone())
    }

    /// From parts over a radicand that already is canonical.
    fn over(a: Rational, b: Rational, d: Int) -> Surd {
        if b.is_zero() { Surd::from(a) } else { Surd { a, b, d } }
    }
}

/// d = outside² · inside, with every square of a small prime in `outside`; a square d goes there
/// entirely.
fn without_squares(d: Int) -> (Int, Int) {
    let root = d.sqrt();
    if &root * &root == d {
        return (root, Int::one());
    }
    let (mut outside, mut inside) = (Int::one(), d);
    for prime in SMALL_PRIMES {
        let square = prime * prime;
        loop {
            let (quotient, remainder) = inside.div_rem(&Int::from(square));
            if !remainder.is_zero() {
                break;
            }
            inside = quotient;
            outside *= prime;
        }
    }
    (outside, inside)
}

fn to_f64(value: &Rational) -> f64 {
    num_traits::ToPrimitive::to_f64(value).unwrap_or(f64::NAN)
}

impl From<Rational> for Surd {
    fn from(a: Rational) -> Surd {
        Surd { a, b: Rational::zero(), d: Int::zero() }
    }
}

impl From<Int> for Surd {
    fn from(a: Int) -> Surd {
        Surd::from(Rational::from(a))
    }
}

impl Ord for Surd {
    fn cmp(&self, other: &Surd) -> Ordering {
        let a = &self.a - &other.a;
        let common = a.denom().lcm(self.b.denom()).lcm(other.b.denom());
        let whole = |x: &Rational| x.numer() * (&common / x.denom());
        let sign =
            sign_of_two_surds(&whole(&a), &whole(&self.b), &self.d, &-whole(&other.b), &other.d);
        match sign {
            Sign::Negative => Ordering::Less,
            Sign::Zero => Ordering::Equal,
            Sign::Positive => Ordering::Greater,
        }
    }
}

impl PartialOrd for Surd {
    fn partial_cmp(&self, other: &Surd) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Surd {
    fn eq(&self, other: &Surd) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Surd {}

impl Neg for &Surd {
    type Output = Surd;
    fn neg(self) -> Surd {
        Surd { a: -&self.a, b: -&self.b, d: self.d.clone() }
    }
}

/// # Panics
/// If the operands lie in different fields.
impl Add for &Surd {
    type Output = Surd;
    fn add(self, other: &Surd) -> Surd {
        let (b1, b2, d) = self.common(other);
        Surd::over(&self.a + &other.a, b1 + b2, d)
    }
}

/// # Panics
/// If the operands lie in different fields.
impl Sub for &Surd {
    type Output = Surd;
    fn sub(self, other: &Surd) -> Surd {
        let (b1, b2, d) = self.common(other);
        Surd::over(&self.a - &other.a, b1 - b2, d)
    }
}

/// # Panics
/// If the operands lie in different fields.
impl Mul for &Surd {
    type Output = Surd;
    fn mul(self, other: &Surd) -> Surd {
        let (b1, b2, d) = self.common(other);
        let a = &self.a * &other.a + &b1 * &b2 * &d;
        let b = &self.a * b2 + b1 * &other.a;
        Surd::over(a, b, d)
    }
}

/// # Panics
/// If the divisor is zero, or the operands lie in different fields.
impl Div for &Surd {
    type Output = Surd;
    // Division by a + b√d multiplies by the conjugate and divides by the norm.
    #[allow(clippy::suspicious_arithmetic_impl)]
    fn div(self, other: &Surd) -> Surd {
        assert!(!other.is_zero(), "division of {self} by zero");
        let norm = &other.a * &other.a - &other.b * &other.b * &other.d;
        let product = self * &other.conjugate();
        Surd::over(product.a / &norm, product.b / &norm, product.d)
    }
}

impl fmt::Display for Surd {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_rational() {
            return write!(f, "{}", self.a);
        }
        if !self.a.is_zero() {
            write!(f, "{} ", self.a)?;
        }
        let sign = match (self.b.is_negative(), self.a.is_zero()) {
            (true, true) => "-",
            (true, false) => "- ",
            (false, true) => "",
            (false, false) => "+ ",
        };
        let b = self.b.abs();
        if b.is_one() {
            write!(f, "{sign}√{}", self.d)
        } else {
            write!(f, "{sign}{b}·√{}", self.d)
        }
    }
}

impl fmt::Debug for Surd {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

#[cfg(test)]
mod tests;
