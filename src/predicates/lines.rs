//! How one directed line passes another.

use super::budget::{Budget, RESIDUE_BITS, SIDE_OF_LINES, SPLIT_BITS};
use super::counters::{Predicate, Stage, record};
use super::ring::{Residue, Ring, dot, each, sign_of_i128};
use crate::geom::{BigLine, Line};
use crate::num::Sign;

/// The Plücker side of two directed lines.
///
/// Positive: seen against the direction of `x`, `y` turns counter-clockwise about it; zero: they
/// meet or are parallel. For x through p, q and y through r, s it is the sign of
/// d_x·m_y + m_x·d_y = det[q-p, r-p, s-p], so that a line through a polygon's interior, towards
/// where its vertices are seen counter-clockwise from, is positive on every edge.
///
/// 1. Symmetric: side(x, y) = side(y, x).
/// 2. Reversing either line changes the sign; a line has side zero with itself.
/// 3. Translation and positive scaling keep the sign, mirroring changes it.
///
/// ```text
///    .  s       x comes out of the page at the dot; y runs
///       |       upwards on its right, counter-clockwise
///       r       about x: positive
/// ```
///
/// Requires: the points that the lines were made of are within the budget.
///
/// Contract: exact, degree 3, unperturbed
///
/// Source: Teller 1992, section 6.1, equation 6.2 (with the other sign); Brönnimann, Emiris, Pan
/// and Pion 1999 for deciding small values by their remainders.
#[inline]
pub fn side_of_lines(x: &Line, y: &Line, budget: &Budget) -> Sign {
    debug_assert!([x, y].iter().all(|l| budget.holds_line(l)), "a line exceeds its budget");
    if budget.exact_lines {
        record(Predicate::SideOfLines, Stage::Filter);
        return Sign::of(&float_side(x, y));
    }
    side_beyond_floats(x, y, budget)
}

/// The stages for grids too large for exact floats. Apart, so that the rest is small enough to be
/// inlined.
#[inline(never)]
fn side_beyond_floats(x: &Line, y: &Line, budget: &Budget) -> Sign {
    if !budget.filters() {
        record(Predicate::SideOfLines, Stage::Fixed);
        return side_of_lines_exact(x, y);
    }
    if let Some(sign) = side_of_lines_filter(x, y, budget) {
        record(Predicate::SideOfLines, Stage::Filter);
        return sign;
    }
    record(Predicate::SideOfLines, Stage::Fixed);
    if budget.bits() <= RESIDUE_BITS {
        let residues = |line: &Line| each(*line.paired_direction(), |[d, _]| residue(d));
        let (d, e) = (residues(x), residues(y));
        let (m, n) = (moment_residues(x), moment_residues(y));
        return Sign::of(&dot(&d, &n).0.wrapping_add(dot(&m, &e).0));
    }
    side_of_lines_exact(x, y)
}

/// An integer of at most 2^51 in magnitude, held in a float. Adding 3·2^51 aligns its last bit with
/// that of the float's 52-bit fraction, and makes every such sum share one exponent.
#[inline(always)]
fn residue(x: f64) -> Residue {
    const ALIGN: f64 = 6_755_399_441_055_744.0;
    Residue(((x + ALIGN).to_bits() as i64).wrapping_sub(ALIGN.to_bits() as i64))
}

/// The moment modulo 2^64. Up to 35 bits its high part is less than 2^47 times 2^25.
#[inline(always)]
fn moment_residues(line: &Line) -> [Residue; 3] {
    let step = Line::SPLIT as f64;
    each(*line.split_moment(), |[high, low]| {
        residue(high / step).times(&Residue(Line::SPLIT)).plus(&residue(low))
    })
}

/// S_h + S_l, as `budget` names them.
#[inline(always)]
pub(super) fn float_side(x: &Line, y: &Line) -> f64 {
    let [high, low] = plus(
        split_dot(x.paired_direction(), y.split_moment()),
        split_dot(y.paired_direction(), x.split_moment()),
    );
    high + low
}

/// The product of a direction and both parts of a moment.
#[inline(always)]
fn split_dot(d: &[[f64; 2]; 3], m: &[[f64; 2]; 3]) -> [f64; 2] {
    let term = |i: usize| [d[i][0] * m[i][0], d[i][1] * m[i][1]];
    plus(plus(term(0), term(1)), term(2))
}

#[inline(always)]
fn plus(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] + b[0], a[1] + b[1]]
}

/// The float stage of [`side_of_lines`]: exact up to 24 bits, zeros included; beyond, within an
/// error bound. Both are derived in `budget`.
#[inline]
pub fn side_of_lines_filter(x: &Line, y: &Line, budget: &Budget) -> Option<Sign> {
    let value = float_side(x, y);
    let exact = budget.bits() <= SPLIT_BITS;
    (exact || value.abs() > budget.side_of_lines_error).then(|| Sign::of(&value))
}

/// The fixed-width stage of [`side_of_lines`]: 3·38 + 5 bits, so that `i128` always does.
#[inline]
pub fn side_of_lines_exact(x: &Line, y: &Line) -> Sign {
    const { assert!(SIDE_OF_LINES.largest_grid(128) >= 38) }
    let (d, e) = (x.direction().map(i128::from), y.direction().map(i128::from));
    sign_of_i128(dot(&d, &y.moment()) + dot(&x.moment(), &e))
}

/// [`side_of_lines`] on unbounded coordinates.
pub fn side_of_lines_big(x: &BigLine, y: &BigLine) -> Sign {
    record(Predicate::SideOfLines, Stage::Big);
    Sign::of(&(dot(&x.direction, &y.moment) + dot(&x.moment, &y.direction)))
}
