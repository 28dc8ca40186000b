//! Greatest common divisors and exact quotients, to keep the numbers of a cone primitive.
//!
//! The gcd is the binary one (Stein 1967; Knuth 4.5.2, algorithm B): shifts and subtractions, in
//! full width only until both numbers fit into 128 bits. An exact quotient is a product modulo a
//! power of two with the divisor's inverse (Jebelean 1993), which two's complement makes right
//! for every sign.

use super::Wide;

impl<const LIMBS: usize> Wide<LIMBS> {
    /// The greatest common divisor: never negative, and zero only for two zeros.
    ///
    /// Requires: neither is the least number of the width.
    pub fn gcd(&self, other: &Wide<LIMBS>) -> Wide<LIMBS> {
        let (mut a, mut b) = (self.abs(), other.abs());
        if a.is_zero() || b.is_zero() {
            return if a.is_zero() { b } else { a };
        }
        let (twos_a, twos_b) = (a.trailing_zeros(), b.trailing_zeros());
        a = a.shifted_right(twos_a);
        b = b.shifted_right(twos_b);
        // Both odd from here on.
        let odd = loop {
            if let (Some(a), Some(b)) = (a.to_i128(), b.to_i128()) {
                break Wide::from(odd_gcd(a as u128, b as u128) as i128);
            }
            let difference = a - b;
            if difference.is_zero() {
                break a;
            }
            if difference.is_negative() {
                b = -difference;
                b = b.shifted_right(b.trailing_zeros());
            } else {
                a = difference.shifted_right(difference.trailing_zeros());
            }
        };
        odd.shifted_left(twos_a.min(twos_b))
    }

    /// The quotient of a division that leaves no remainder.
    ///
    /// Requires: `divisor` is not zero and divides this number.
    pub fn exact_quotient(&self, divisor: &Wide<LIMBS>) -> Wide<LIMBS> {
        debug_assert!(!divisor.is_zero(), "a division by zero");
        let twos = divisor.trailing_zeros();
        let inverse = divisor.shifted_right(twos).inverse();
        let quotient = self.shifted_right(twos).truncated_times(&inverse);
        debug_assert!(
            quotient.to_int() * divisor.to_int() == self.to_int(),
            "a division leaves a remainder"
        );
        quotient
    }

    /// How many times two divides this number; the width for zero.
    fn trailing_zeros(&self) -> u32 {
        for (i, limb) in self.limbs.iter().enumerate() {
            if *limb != 0 {
                return 64 * i as u32 + limb.trailing_zeros();
            }
        }
        64 * LIMBS as u32
    }

    /// Divided by `2^count` and rounded down; `count` below the width.
    fn shifted_right(&self, count: u32) -> Wide<LIMBS> {
        let (whole, part) = (count as usize / 64, count % 64);
        let limb = |i: usize| self.limbs.get(i).copied().unwrap_or(self.sign_mask());
        let limbs = std::array::from_fn(|i| {
            let pair = u128::from(limb(i + whole + 1)) << 64 | u128::from(limb(i + whole));
            (pair >> part) as u64
        });
        Wide { limbs }
    }

    /// Times `2^count`; `count` below the width, and the result fits.
    fn shifted_left(&self, count: u32) -> Wide<LIMBS> {
        let (whole, part) = (count as usize / 64, count % 64);
        let limb = |i: usize| if i < whole { 0 } else { self.limbs[i - whole] };
        let limbs = std::array::from_fn(|i| {
            let below = if i == 0 { 0 } else { limb(i - 1) };
            let pair = u128::from(limb(i)) << 64 | u128::from(below);
            (pair << part >> 64) as u64
        });
        Wide { limbs }
    }

    /// The product modulo 2^(64·LIMBS).
    fn truncated_times(&self, other: &Wide<LIMBS>) -> Wide<LIMBS> {
        let mut limbs = [0u64; LIMBS];
        for i in 0..LIMBS {
            let mut carry = 0;
            for j in 0..LIMBS - i {
                (limbs[i + j], carry) =
                    super::mul_add(limbs[i + j], self.limbs[i], other.limbs[j], carry);
            }
        }
        Wide { limbs }
    }

    /// The inverse of an odd number modulo 2^(64·LIMBS), by Newton's iteration x(2 - dx), which
    /// doubles the number of right bits: d itself is right to 3 bits, since d² = 1 modulo 8.
    fn inverse(&self) -> Wide<LIMBS> {
        let d = self.limbs[0];
        let mut low = d;
        for _ in 0..5 {
            low = low.wrapping_mul(2u64.wrapping_sub(d.wrapping_mul(low)));
        }
        let two = Wide { limbs: std::array::from_fn(|i| if i == 0 { 2 } else { 0 }) };
        let mut x = Wide { limbs: std::array::from_fn(|i| if i == 0 { low } else { 0 }) };
        let mut right = 1;
        while right < LIMBS {
            x = x.truncated_times(&two.wrapping_sub(&self.truncated_times(&x)));
            right *= 2;
        }
        x
    }
}

/// The gcd of two odd numbers.
fn odd_gcd(mut a: u128, mut b: u128) -> u128 {
    while a >> 64 != 0 || b >> 64 != 0 {
        if a == b {
            return a;
        }
        if a < b {
            (a, b) = (b, a);
        }
        a -= b;
        a >>= a.trailing_zeros();
    }
    let (mut a, mut b) = (a as u64, b as u64);
    while a != b {
        // |a - b| and the smaller one, without a branch.
        let difference = a.abs_diff(b);
        b = a.min(b);
        a = difference >> difference.trailing_zeros();
    }
    u128::from(a)
}
