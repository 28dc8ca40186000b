//! Points on the unit circle at fractions of a turn, without floats.

use crate::num::{Int, Rational};
use num_traits::{One, Zero};

/// Binary digits behind the point.
const DIGITS: usize = 128;

/// π, rounded to 45 decimals.
const PI: &str = "3141592653589793238462643383279502884197169399";
const PI_DECIMALS: u32 = 45;

/// The cosine and the sine of `k/n` of a turn: within 2^-100, exact where they are rational, and
/// exactly symmetric under the symmetries of the square.
///
/// Requires: n > 0.
pub(super) fn on_circle(k: u32, n: u32) -> [Rational; 2] {
    let (k, n) = (u64::from(k % n), u64::from(n));
    // Eighths of a turn; even ones go up from their first ray, odd ones down from their last.
    let eighth = 8 * k / n;
    let (up, whole) = (8 * k - eighth * n, 8 * n);
    let (near, far) = in_first_eighth(if eighth % 2 == 0 { up } else { n - up }, whole);
    let [x, y] = match eighth {
        0 => [near, far],
        1 => [far, near],
        2 => [-far, near],
        3 => [-near, far],
        4 => [-near, -far],
        5 => [-far, -near],
        6 => [far, -near],
        _ => [near, -far],
    };
    [x, y]
}

/// The cosine and the sine of `k/n` of a turn, an eighth at most.
fn in_first_eighth(k: u64, n: u64) -> (Rational, Rational) {
    let one = || Int::one() << DIGITS;
    let power = Int::from(10).pow(PI_DECIMALS);
    let pi: Int = PI.parse().expect("digits");
    let angle = ((pi * 2 * k) << DIGITS) / (power * n);
    // The terms x^i / i! of the exponential series; each is within a unit or two of the last
    // digit, there are fewer than forty, and the digits of π are good for 2^-145.
    let (mut sums, mut term, mut i) = ([Int::zero(), Int::zero()], one(), 0u32);
    while !term.is_zero() {
        let sum = &mut sums[i as usize % 2];
        match i % 4 {
            0 | 1 => *sum += &term,
            _ => *sum -= &term,
        }
        i += 1;
        term = ((term * &angle) >> DIGITS) / i;
    }
    let [cosine, sine] = sums.map(|sum| Rational::new(sum, one()));
    if 12 * k == n {
        // The only rational one (Niven) but for those of no angle, which the series has exactly.
        return (cosine, Rational::new(Int::one(), Int::from(2)));
    }
    // At an eighth they are equal.
    if 8 * k == n { (cosine.clone(), cosine) } else { (cosine, sine) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_are_on_the_circle_and_known_ones_exact() {
        let small = Rational::new(Int::one(), Int::one() << 100);
        for n in [3, 4, 5, 7, 8, 12, 24, 100, 256] {
            let points: Vec<_> = (0..n).map(|k| on_circle(k, n)).collect();
            for [x, y] in &points {
                let off = x * x + y * y - Int::one();
                assert!(off < small && -off < small, "{n}");
            }
            assert_eq!(points[0], [1, 0].map(|c| Rational::from(Int::from(c))));
            // The sum of a regular polygon's vertices is the centre.
            for axis in 0..2 {
                let sum: Rational = points.iter().map(|p| &p[axis]).sum();
                assert!(sum < &small * Int::from(n) && -sum < &small * Int::from(n), "{n}");
            }
        }
        let half = Rational::new(Int::one(), Int::from(2));
        assert_eq!(on_circle(1, 12)[1], half);
        assert_eq!(on_circle(2, 6)[0], -&half);
        assert_eq!(on_circle(1, 6)[0], half);
        assert_eq!(on_circle(3, 4), [0, -1].map(|c| Rational::from(Int::from(c))));
    }

    #[test]
    fn the_circle_has_the_symmetries_of_the_square() {
        for n in [8, 20, 32] {
            for k in 0..n {
                let [x, y] = on_circle(k, n);
                assert_eq!(on_circle((k + n / 4) % n, n), [-&y, x.clone()]);
                assert_eq!(on_circle((n - k) % n, n), [x, -y]);
            }
        }
    }
}
