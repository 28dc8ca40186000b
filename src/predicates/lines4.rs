//! Four lines and the lines that meet them all: how many, and how a fifth line passes them.
//!
//! Both questions are signs of Gram determinants of the lines under the side product S_ij =
//! side(l_i, l_j), so that no square root occurs. With four lines, a = S12·S34, b = S13·S24 and
//! c = S14·S23, the determinant is D = (a-b-c)² - 4bc; its four-dimensional span T has a
//! two-dimensional complement, and D, up to a positive factor, is minus the discriminant of the
//! quadric there. With a fifth line the 5x5 determinant is, up to a positive factor, the product
//! of its sides of both transversals and of their side of each other (Hohmeyer and Teller 1999
//! compute the lines themselves; the determinants are classical).
//!
//! If two of the lines are coplanar, D is a square: that branch compares two products and needs no
//! wide integers. In architecture two of any four edges are parallel, and scaled to unit directions
//! they need no filter either.

use super::budget::{Budget, SIDE_OF_LINES, SIDE_OF_TRANSVERSALS, TRANSVERSAL_COUNT, U};
use super::counters::{Predicate, Stage, record};
use super::four_lines::{
    NARROW_BITS, PAIRS, Products, count_axial, count_big, count_degenerate, has_skew_triple,
    is_axial,
};
use super::lines::float_side;
use super::ring::{Ring, dot};
use crate::geom::{BigLine, Line};
use crate::num::{Int, Int256, Int320, Int512, Sign, Wide};

/// How many lines meet four given lines, those at infinity included.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TransversalCount {
    /// No line.
    None,
    /// One line, which counts twice: the fourth line is tangent to the surface of the others.
    One,
    /// Two lines.
    Two,
    /// Infinitely many lines.
    Family,
}

/// How many lines meet all four lines.
///
/// Positive: D, and there are `Two`; negative: there is `None`. Where D = 0 the transversals
/// coincide (`One`) or there are infinitely many (`Family`: pencils, reguli and larger families,
/// which `stab::transversals` tells apart). Lines at infinity count: parallel lines meet.
///
/// 1. Permuting or reversing the lines changes nothing.
/// 2. Affine maps of space change nothing.
///
/// Requires: the points that the lines were made of are within the budget.
///
/// Contract: exact, degree 12, unperturbed
///
/// Source: Teller 1992, section 6.3, for the degenerate cases.
#[inline]
pub fn transversal_count(lines: [&Line; 4], budget: &Budget) -> TransversalCount {
    if budget.exact_lines {
        // Written out: the compiler does not unroll it from the table.
        let [k, l, m, n] = lines;
        let (kl, km, kn) = (float_side(k, l), float_side(k, m), float_side(k, n));
        let (lm, ln, mn) = (float_side(l, m), float_side(l, n), float_side(m, n));
        let products = [kl, km, kn, lm, ln, mn];
        if let Some(sign) = discriminant_filter(&products)
            && (sign != Sign::Zero || !has_skew_triple(&products))
        {
            record(Predicate::TransversalCount, Stage::Filter);
            // Constants only, so that no branch has to guess the sign.
            return match sign {
                Sign::Negative => TransversalCount::None,
                // Products are zero only where the true ones are.
                Sign::Zero => TransversalCount::Family,
                Sign::Positive => TransversalCount::Two,
            };
        }
    }
    count_beyond_floats(lines, budget)
}

/// The stages after the float stage on grids of up to 24 bits. Apart, so that the rest is small
/// enough to be inlined.
#[inline(never)]
fn count_beyond_floats(lines: [&Line; 4], budget: &Budget) -> TransversalCount {
    if budget.bits() <= NARROW_BITS && lines.iter().all(|line| is_axial(line)) {
        record(Predicate::TransversalCount, Stage::Fixed);
        return count_axial(lines);
    }
    let products = PAIRS.map(|[i, j]| side(lines[i], lines[j]));
    if budget.filters()
        && !budget.exact_lines
        && let Some(sign) = discriminant_filter(&products.map(|s| s as f64))
    {
        record(Predicate::TransversalCount, Stage::Filter);
        return count(sign, lines, budget);
    }
    record(Predicate::TransversalCount, Stage::Fixed);
    count(discriminant_exact(&products, budget), lines, budget)
}

/// The float stage of [`transversal_count`]: the sign of D if it is sure.
///
/// The six products are the true ones rounded once (`side_of_lines` sums two exact floats on grids
/// of up to 24 bits), zero exactly where those are: in error by a factor 1+u each, so a, b and c by
/// 3u relatively. With m = |a|+|b|+|c| the difference a-b-c is in error by (3+2)um, its square by
/// (2·5+1)um². 4bc <= m² is in error by (2·3+1)um², the last subtraction by 2um²: 20um² in all,
/// and 24 with the higher orders and the rounding of m. On the largest grid D is below 2^480; and
/// m = 0 only where a, b and c are zero, and D with them.
#[inline(always)]
pub(super) fn discriminant_filter(s: &Products<f64>) -> Option<Sign> {
    let (a, b, c) = (s[0] * s[5], s[1] * s[4], s[2] * s[3]);
    let m = a.abs() + b.abs() + c.abs();
    let value = (a - b - c) * (a - b - c) - 4.0 * b * c;
    (value.abs() > 24.0 * U * m * m || m == 0.0).then(|| Sign::of(&value))
}

/// The fixed-width stage: the sign of D.
fn discriminant_exact(s: &Products<i128>, budget: &Budget) -> Sign {
    // 6b + 11 bits for a-b-c, on grids of up to 38 bits.
    let [a, b, c] = [[0, 5], [1, 4], [2, 3]].map(|[i, j]| Int256::product(s[i], s[j]));
    // With one of them zero, D is the square of the others' difference.
    let square = match (a.is_zero(), b.is_zero(), c.is_zero()) {
        (true, _, _) => Some(b != c),
        (_, true, _) => Some(a != c),
        (_, _, true) => Some(a != b),
        (false, false, false) => None,
    };
    match square {
        Some(true) => Sign::Positive,
        Some(false) => Sign::Zero,
        None if budget.bits() <= TRANSVERSAL_COUNT.largest_grid(320) => {
            let difference = a - b - c;
            let square: Int320 = difference.times(&difference);
            (square - b.times::<4, 5>(&c).times_i64(4)).sign()
        }
        None => {
            let difference = a - b - c;
            let square: Int512 = difference.times(&difference);
            (square - b.times::<4, 8>(&c).times_i64(4)).sign()
        }
    }
}

#[inline(always)]
fn count(discriminant: Sign, lines: [&Line; 4], budget: &Budget) -> TransversalCount {
    match discriminant {
        Sign::Negative => TransversalCount::None,
        Sign::Positive => TransversalCount::Two,
        // Degenerate: one line touched twice, or infinitely many.
        Sign::Zero => count_degenerate(lines, budget.bits()),
    }
}

/// [`transversal_count`] on unbounded coordinates.
pub fn transversal_count_big(lines: [BigLine; 4]) -> TransversalCount {
    record(Predicate::TransversalCount, Stage::Big);
    count_big(lines)
}

/// How a fifth line passes both lines that meet four lines.
///
/// Positive: for four lines with two transversals L and M, side(L, e)·side(M, e)·side(L, M) is,
/// which does not depend on how L and M are directed; zero: the fifth line meets a transversal (or
/// all five meet one line, or the four are degenerate).
///
/// 1. Permuting the four lines, and in fact all five, changes nothing; nor does reversing one.
/// 2. Motions keep the sign, mirroring changes it.
///
/// Requires: the points that the lines were made of are within the budget.
///
/// Contract: exact, degree 15, unperturbed
///
/// Source: the Gram determinant of five lines under equation 6.2 of Teller 1992.
pub fn side_of_transversals(lines: [&Line; 4], fifth: &Line, budget: &Budget) -> Sign {
    let [a, b, c, d] = lines;
    let lines = [a, b, c, d, fifth];
    if budget.exact_lines {
        let products = gram(|i, j| float_side(lines[i], lines[j]));
        if let Some(sign) = side_of_transversals_filter(&products) {
            record(Predicate::SideOfTransversals, Stage::Filter);
            return sign;
        }
    }
    side_beyond_floats(lines, budget)
}

/// The stages after the float stage on grids of up to 24 bits.
#[inline(never)]
fn side_beyond_floats(lines: [&Line; 5], budget: &Budget) -> Sign {
    if budget.bits() > SIDE_OF_TRANSVERSALS.largest_grid(512) {
        return side_of_transversals_big(lines.map(|&line| line.into()));
    }
    let products = gram(|i, j| side(lines[i], lines[j]));
    if budget.filters()
        && !budget.exact_lines
        && let Some(sign) = side_of_transversals_filter(&products.map(|row| row.map(|s| s as f64)))
    {
        record(Predicate::SideOfTransversals, Stage::Filter);
        return sign;
    }
    record(Predicate::SideOfTransversals, Stage::Fixed);
    let mut sum = Int512::ZERO;
    for (sign, factors) in terms() {
        let [s, t, u, v, w] = factors.map(|[i, j]| products[i][j]);
        let four: Int512 = Int256::product(s, t).times(&Int256::product(u, v));
        let five = four.times::<2, 8>(&Wide::<2>::from(w));
        if sign { sum += five } else { sum -= five }
    }
    sum.sign()
}

/// The float stage of [`side_of_transversals`].
///
/// Each of the 22 terms has five factors in error by 1+u (as in the count) and four roundings, 9u
/// of its magnitude; their sum adds 21u of the sum of magnitudes: 30u, and 34 with the higher
/// orders and the rounding of that sum. Nothing but zeros sums to the magnitude zero.
#[inline(always)]
fn side_of_transversals_filter(s: &[[f64; 5]; 5]) -> Option<Sign> {
    let (mut sum, mut magnitude) = (0.0, 0.0);
    for (sign, factors) in terms() {
        let term: f64 = factors.iter().map(|&[i, j]| s[i][j]).product();
        sum += if sign { term } else { -term };
        magnitude += term.abs();
    }
    (sum.abs() > 34.0 * U * magnitude || magnitude == 0.0).then(|| Sign::of(&sum))
}

/// [`side_of_transversals`] on unbounded coordinates, the fifth line last.
pub fn side_of_transversals_big(lines: [BigLine; 5]) -> Sign {
    record(Predicate::SideOfTransversals, Stage::Big);
    let products = gram(|i, j| lines[i].side_product(&lines[j]));
    let sum: Int = terms()
        .map(|(sign, factors)| {
            let term: Int = factors.iter().map(|&[i, j]| &products[i][j]).product();
            if sign { term } else { -term }
        })
        .sum();
    Sign::of(&sum)
}

/// Half the determinant of a symmetric 5x5 matrix with a zero diagonal, term by term: permutations
/// without a fixed point are 5-cycles (even) and pairs of a transposition and a 3-cycle (odd), and
/// each term comes twice, with the inverse permutation.
fn terms() -> impl Iterator<Item = (bool, [[usize; 2]; 5])> {
    const CYCLES: [[usize; 4]; 12] = [
        [1, 2, 3, 4],
        [1, 2, 4, 3],
        [1, 3, 2, 4],
        [1, 3, 4, 2],
        [1, 4, 2, 3],
        [1, 4, 3, 2],
        [2, 1, 3, 4],
        [2, 1, 4, 3],
        [2, 3, 1, 4],
        [2, 4, 1, 3],
        [3, 1, 2, 4],
        [3, 2, 1, 4],
    ];
    const SPLITS: [[usize; 5]; 10] = [
        [0, 1, 2, 3, 4],
        [0, 2, 1, 3, 4],
        [0, 3, 1, 2, 4],
        [0, 4, 1, 2, 3],
        [1, 2, 0, 3, 4],
        [1, 3, 0, 2, 4],
        [1, 4, 0, 2, 3],
        [2, 3, 0, 1, 4],
        [2, 4, 0, 1, 3],
        [3, 4, 0, 1, 2],
    ];
    let cycles =
        CYCLES.iter().map(|&[b, c, d, e]| (true, [[0, b], [b, c], [c, d], [d, e], [e, 0]]));
    let splits =
        SPLITS.iter().map(|&[a, b, c, d, e]| (false, [[a, b], [b, a], [c, d], [d, e], [e, c]]));
    cycles.chain(splits)
}

fn gram<T: Clone>(side: impl Fn(usize, usize) -> T) -> [[T; 5]; 5] {
    // The diagonal is never read.
    std::array::from_fn(|i| {
        std::array::from_fn(|j| if i == j { side(0, 1) } else { side(i.min(j), i.max(j)) })
    })
}

/// The side product of two lines, which hold up to 38 bits.
pub(super) fn side(x: &Line, y: &Line) -> i128 {
    const { assert!(SIDE_OF_LINES.largest_grid(128) >= 38) }
    const { assert!(TRANSVERSAL_COUNT.largest_grid(512) >= 38) }
    let (d, e) = (x.direction().map(i128::from), y.direction().map(i128::from));
    dot(&d, &y.moment()).plus(&dot(&x.moment(), &e))
}
