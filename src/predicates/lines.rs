//! How one directed line passes another.

use super::budget::{Budget, RESIDUE_BITS, SIDE_OF_LINES};
use super::counters::{Predicate, Stage, record};
use super::ring::{Residue, dot, sign_of_i128};
use crate::geom::{BigLine, Line};
use crate::num::{Int192, Sign};

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
    if !budget.filters() {
        record(Predicate::SideOfLines, Stage::Fixed);
        return side_of_lines_exact(x, y, budget);
    }
    if let Some(sign) = side_of_lines_filter(x, y, budget) {
        record(Predicate::SideOfLines, Stage::Filter);
        return sign;
    }
    record(Predicate::SideOfLines, Stage::Fixed);
    if budget.bits() <= RESIDUE_BITS {
        let (d, e) = (x.direction().map(Residue), y.direction().map(Residue));
        let [m, n] = [x, y].map(|line| line.moment().map(|m| Residue(m as i64)));
        return Sign::of(&dot(&d, &n).0.wrapping_add(dot(&m, &e).0));
    }
    side_of_lines_exact(x, y, budget)
}

/// The float stage of [`side_of_lines`]; the error bound is derived in `budget`.
#[inline]
pub fn side_of_lines_filter(x: &Line, y: &Line, budget: &Budget) -> Option<Sign> {
    let ((d, m), (e, n)) = (x.floats(), y.floats());
    let value = dot(d, n) + dot(m, e);
    let error = budget.side_of_lines_error;
    if error == 0.0 || value.abs() > error { Some(Sign::of(&value)) } else { None }
}

/// The fixed-width stage of [`side_of_lines`].
#[inline]
pub fn side_of_lines_exact(x: &Line, y: &Line, budget: &Budget) -> Sign {
    let (d, e) = (x.direction().map(i128::from), y.direction().map(i128::from));
    if budget.bits() <= SIDE_OF_LINES.largest_grid(128) {
        return sign_of_i128(dot(&d, &y.moment()) + dot(&x.moment(), &e));
    }
    const { assert!(SIDE_OF_LINES.largest_grid(192) >= 53) }
    let term = |a: i128, b: i128| Int192::from(a).times_i128(b);
    let mut value = Int192::ZERO;
    for i in 0..3 {
        value += term(y.moment()[i], d[i]) + term(x.moment()[i], e[i]);
    }
    value.sign()
}

/// [`side_of_lines`] on unbounded coordinates.
pub fn side_of_lines_big(x: &BigLine, y: &BigLine) -> Sign {
    record(Predicate::SideOfLines, Stage::Big);
    Sign::of(&(dot(&x.direction, &y.moment) + dot(&x.moment, &y.direction)))
}
