//! Signed integers of a fixed number of 64-bit limbs, for predicates whose range is proved.
//!
//! A predicate on a grid of `b` bits has a sign that an integer of known width decides. `i128`
//! serves the narrow ones; [`Wide`] the rest, without allocation and without a branch on size.
//! Numbers are two's complement, limbs from the least significant up, so that addition,
//! subtraction and truncated multiplication need not look at signs: they are exact in the ring of
//! integers modulo 2^(64·LIMBS), and right as integers whenever the true result lies in
//! [-2^(64·LIMBS-1), 2^(64·LIMBS-1)). That it does is the caller's contract, proved beside each
//! use from the grid's bits, and checked by `debug_assert` in every operation here.
//!
//! Cost: additions O(LIMBS), products O(LIMBS²) limb products; loops of constant length, which
//! the compiler unrolls into `mul`/`adc` chains. Multiplication is the schoolbook one (Knuth,
//! The Art of Computer Programming 2, 4.3.1, algorithm M), truncated.

mod division;
#[cfg(test)]
mod tests;

use super::{Int, Sign};
use num_bigint::Sign as IntSign;
use std::cmp::Ordering;
use std::ops::{Add, AddAssign, Neg, Sub, SubAssign};

/// A signed integer of `64·LIMBS` bits.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub struct Wide<const LIMBS: usize> {
    /// Two's complement, the least significant limb first.
    limbs: [u64; LIMBS],
}

/// A signed integer of 192 bits.
pub type Int192 = Wide<3>;
/// A signed integer of 256 bits.
pub type Int256 = Wide<4>;
/// A signed integer of 320 bits.
pub type Int320 = Wide<5>;
/// A signed integer of 512 bits.
pub type Int512 = Wide<8>;

/// `a + b + carry`, and the carry out.
#[inline(always)]
fn add_carry(a: u64, b: u64, carry: bool) -> (u64, bool) {
    let (sum, first) = a.overflowing_add(b);
    let (sum, second) = sum.overflowing_add(u64::from(carry));
    (sum, first | second)
}

/// `a - b - borrow`, and the borrow out.
#[inline(always)]
fn sub_borrow(a: u64, b: u64, borrow: bool) -> (u64, bool) {
    let (difference, first) = a.overflowing_sub(b);
    let (difference, second) = difference.overflowing_sub(u64::from(borrow));
    (difference, first | second)
}

/// `accumulator + a·b + carry` as (low, high); it cannot overflow 128 bits.
#[inline(always)]
fn mul_add(accumulator: u64, a: u64, b: u64, carry: u64) -> (u64, u64) {
    let sum = u128::from(a) * u128::from(b) + u128::from(accumulator) + u128::from(carry);
    (sum as u64, (sum >> 64) as u64)
}

impl<const LIMBS: usize> Wide<LIMBS> {
    /// Zero.
    pub const ZERO: Wide<LIMBS> = Wide { limbs: [0; LIMBS] };

    /// The exact product of two `i128`, which any width from 256 bits up holds.
    #[inline]
    pub fn product(a: i128, b: i128) -> Wide<LIMBS> {
        const { assert!(LIMBS >= 4, "a product of two i128 needs 256 bits") }
        Wide::<2>::from(a).times(&Wide::<2>::from(b))
    }

    /// The exact product with another number, in as many limbs as the caller says.
    ///
    /// Requires: the product fits into `R` limbs (always so for `R >= LIMBS + B`).
    #[inline]
    pub fn times<const B: usize, const R: usize>(&self, other: &Wide<B>) -> Wide<R> {
        // Read as unsigned, the limbs hold a' = a + [a<0]·2^(64·LIMBS) and b' = b + [b<0]·2^(64·B),
        // and a·b = a'·b' - [a<0]·2^(64·LIMBS)·b' - [b<0]·2^(64·B)·a: the unsigned product and
        // two terms that are taken off by masks instead of branches, the last one sign-extended.
        let mut limbs = [0u64; R];
        for (i, &a) in self.limbs.iter().enumerate() {
            let mut carry = 0;
            for (j, &b) in other.limbs.iter().enumerate() {
                if i + j < R {
                    (limbs[i + j], carry) = mul_add(limbs[i + j], a, b, carry);
                }
            }
            if i + B < R {
                limbs[i + B] = carry;
            }
        }
        subtract_shifted(&mut limbs, &other.limbs, 0, LIMBS, self.sign_mask());
        subtract_shifted(&mut limbs, &self.limbs, self.sign_mask(), B, other.sign_mask());
        let result = Wide { limbs };
        debug_assert!(
            R >= LIMBS + B || result.to_int() == self.to_int() * other.to_int(),
            "a product does not fit its width"
        );
        result
    }

    /// The product with a small factor, in the same width.
    ///
    /// Requires: it fits.
    #[inline]
    pub fn times_i64(&self, factor: i64) -> Wide<LIMBS> {
        self.times(&Wide { limbs: [factor as u64] })
    }

    /// The product with an `i128`, in the same width.
    ///
    /// Requires: it fits.
    #[inline]
    pub fn times_i128(&self, factor: i128) -> Wide<LIMBS> {
        self.times(&Wide::<2>::from(factor))
    }

    /// The product in the same width, or `None` where it does not fit.
    pub fn checked_times<const B: usize>(&self, other: &Wide<B>) -> Option<Wide<LIMBS>> {
        // |a·b| < 2^(bits a + bits b) unless both are the least number of their width, so a sum
        // of at most 64·LIMBS - 2 always fits; the last bits are left to the slow way.
        if self.bits() + other.bits() + 2 <= 64 * LIMBS as u32 {
            return Some(self.times(other));
        }
        Wide::from_int(&(self.to_int() * other.to_int()))
    }

    /// The sum, or `None` where it does not fit.
    #[inline]
    pub fn checked_add(&self, other: &Wide<LIMBS>) -> Option<Wide<LIMBS>> {
        let sum = self.wrapping_add(other);
        // Overflow: both summands have the one sign and the sum has the other.
        let overflow = (self.top() ^ sum.top()) & (other.top() ^ sum.top());
        (overflow >> 63 == 0).then_some(sum)
    }

    /// The difference, or `None` where it does not fit.
    #[inline]
    pub fn checked_sub(&self, other: &Wide<LIMBS>) -> Option<Wide<LIMBS>> {
        let difference = self.wrapping_sub(other);
        let overflow = (self.top() ^ other.top()) & (self.top() ^ difference.top());
        (overflow >> 63 == 0).then_some(difference)
    }

    /// The sign.
    #[inline]
    pub fn sign(&self) -> Sign {
        if self.is_negative() {
            Sign::Negative
        } else if self.is_zero() {
            Sign::Zero
        } else {
            Sign::Positive
        }
    }

    /// Whether this is zero.
    #[inline]
    pub fn is_zero(&self) -> bool {
        self.limbs.iter().fold(0, |all, limb| all | limb) == 0
    }

    /// Whether this is less than zero.
    #[inline]
    pub fn is_negative(&self) -> bool {
        self.top() >> 63 != 0
    }

    /// The magnitude.
    ///
    /// Requires: not the least number of the width.
    #[inline]
    pub fn abs(&self) -> Wide<LIMBS> {
        if self.is_negative() { -*self } else { *self }
    }

    /// The least `n` with -2^n <= self < 2^n: an `n`-bit magnitude; 0 for 0 and -1.
    #[inline]
    pub fn bits(&self) -> u32 {
        let mask = self.sign_mask();
        for i in (0..LIMBS).rev() {
            let limb = self.limbs[i] ^ mask;
            if limb != 0 {
                return 64 * i as u32 + (64 - limb.leading_zeros());
            }
        }
        0
    }

    /// The same number in at least as many limbs.
    #[inline]
    pub fn widen<const M: usize>(&self) -> Wide<M> {
        const { assert!(M >= LIMBS, "widening needs at least as many limbs") }
        self.resize()
    }

    /// The same number in any number of limbs, or `None` where it does not fit.
    #[inline]
    pub fn narrow<const M: usize>(&self) -> Option<Wide<M>> {
        (self.bits() < 64 * M as u32).then(|| self.resize())
    }

    /// The same number as an `i128`, or `None` where it does not fit.
    #[inline]
    pub fn to_i128(&self) -> Option<i128> {
        let Wide { limbs: [low, high] } = self.narrow::<2>()?;
        Some((u128::from(high) << 64 | u128::from(low)) as i128)
    }

    /// The same number, unbounded.
    pub fn to_int(&self) -> Int {
        let bytes: Vec<u8> = self.limbs.iter().flat_map(|limb| limb.to_le_bytes()).collect();
        Int::from_signed_bytes_le(&bytes)
    }

    /// The same number in fixed width, or `None` where it does not fit.
    pub fn from_int(value: &Int) -> Option<Wide<LIMBS>> {
        let mut limbs = [0; LIMBS];
        let mut digits = value.iter_u64_digits();
        for (limb, digit) in limbs.iter_mut().zip(&mut digits) {
            *limb = digit;
        }
        let magnitude = Wide { limbs };
        let negative = value.sign() == IntSign::Minus;
        let result = if negative { Wide::ZERO.wrapping_sub(&magnitude) } else { magnitude };
        // A magnitude from half the range up shows as a wrong sign, but for the least number.
        let fits =
            digits.next().is_none() && (magnitude.is_zero() || result.is_negative() == negative);
        fits.then_some(result)
    }

    #[inline(always)]
    fn top(&self) -> u64 {
        self.limbs[LIMBS - 1]
    }

    /// All ones for a negative number, else zero.
    #[inline(always)]
    fn sign_mask(&self) -> u64 {
        ((self.top() as i64) >> 63) as u64
    }

    /// The lowest `M` limbs of the sign-extended number.
    #[inline(always)]
    fn resize<const M: usize>(&self) -> Wide<M> {
        let mut limbs = [self.sign_mask(); M];
        for (to, from) in limbs.iter_mut().zip(&self.limbs) {
            *to = *from;
        }
        Wide { limbs }
    }

    #[inline(always)]
    fn wrapping_add(&self, other: &Wide<LIMBS>) -> Wide<LIMBS> {
        let mut limbs = [0; LIMBS];
        let mut carry = false;
        for (i, limb) in limbs.iter_mut().enumerate() {
            (*limb, carry) = add_carry(self.limbs[i], other.limbs[i], carry);
        }
        Wide { limbs }
    }

    #[inline(always)]
    fn wrapping_sub(&self, other: &Wide<LIMBS>) -> Wide<LIMBS> {
        let mut limbs = [0; LIMBS];
        let mut borrow = false;
        for (i, limb) in limbs.iter_mut().enumerate() {
            (*limb, borrow) = sub_borrow(self.limbs[i], other.limbs[i], borrow);
        }
        Wide { limbs }
    }
}

/// Takes `amount·2^(64·shift)` off `limbs`, modulo their width, where `mask` is all ones, and
/// nothing where it is zero. Limbs of `amount` beyond its last are `extension`.
#[inline(always)]
fn subtract_shifted(limbs: &mut [u64], amount: &[u64], extension: u64, shift: usize, mask: u64) {
    let mut borrow = false;
    for (i, limb) in limbs.iter_mut().enumerate().skip(shift) {
        let digit = amount.get(i - shift).copied().unwrap_or(extension);
        (*limb, borrow) = sub_borrow(*limb, digit & mask, borrow);
    }
}

impl<const LIMBS: usize> From<i64> for Wide<LIMBS> {
    #[inline]
    fn from(value: i64) -> Wide<LIMBS> {
        Wide { limbs: [value as u64] }.widen()
    }
}

impl<const LIMBS: usize> From<i128> for Wide<LIMBS> {
    #[inline]
    fn from(value: i128) -> Wide<LIMBS> {
        Wide { limbs: [value as u64, (value >> 64) as u64] }.widen()
    }
}

impl<const LIMBS: usize> Add for Wide<LIMBS> {
    type Output = Wide<LIMBS>;
    #[inline]
    fn add(self, other: Wide<LIMBS>) -> Wide<LIMBS> {
        debug_assert!(self.checked_add(&other).is_some(), "a sum does not fit its width");
        self.wrapping_add(&other)
    }
}

impl<const LIMBS: usize> Sub for Wide<LIMBS> {
    type Output = Wide<LIMBS>;
    #[inline]
    fn sub(self, other: Wide<LIMBS>) -> Wide<LIMBS> {
        debug_assert!(self.checked_sub(&other).is_some(), "a difference does not fit its width");
        self.wrapping_sub(&other)
    }
}

impl<const LIMBS: usize> Neg for Wide<LIMBS> {
    type Output = Wide<LIMBS>;
    #[inline]
    fn neg(self) -> Wide<LIMBS> {
        Wide::ZERO - self
    }
}

impl<const LIMBS: usize> AddAssign for Wide<LIMBS> {
    #[inline]
    fn add_assign(&mut self, other: Wide<LIMBS>) {
        *self = *self + other;
    }
}

impl<const LIMBS: usize> SubAssign for Wide<LIMBS> {
    #[inline]
    fn sub_assign(&mut self, other: Wide<LIMBS>) {
        *self = *self - other;
    }
}

impl<const LIMBS: usize> Ord for Wide<LIMBS> {
    #[inline]
    fn cmp(&self, other: &Wide<LIMBS>) -> Ordering {
        // With the sign bit flipped, two's complement orders as unsigned numbers do.
        let key = |wide: &Wide<LIMBS>| wide.top() ^ (1 << 63);
        key(self)
            .cmp(&key(other))
            .then_with(|| self.limbs.iter().rev().cmp(other.limbs.iter().rev()))
    }
}

impl<const LIMBS: usize> PartialOrd for Wide<LIMBS> {
    #[inline]
    fn partial_cmp(&self, other: &Wide<LIMBS>) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl<const LIMBS: usize> Default for Wide<LIMBS> {
    fn default() -> Wide<LIMBS> {
        Wide::ZERO
    }
}

impl<const LIMBS: usize> std::fmt::Display for Wide<LIMBS> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.to_int().fmt(f)
    }
}

impl<const LIMBS: usize> std::fmt::Debug for Wide<LIMBS> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.to_int().fmt(f)
    }
}
