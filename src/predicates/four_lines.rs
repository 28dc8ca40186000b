//! The lines that meet four lines, and how others pass each of them.
//!
//! Four lines in general position meet two common lines, or none. [`FourLines`] is made once for
//! four lines and then tells of any number of others how they pass each transversal. With Plücker
//! vectors the transversals are H ± √D·W, polynomials of the four lines' coordinates
//! (`four_lines::algebra`). Three stages:
//!
//! 1. Floats hold both, with an error bound that is computed once, so that another line costs its
//!    two side products and a comparison.
//! 2. If two of the four lines are coplanar, D is a square and the transversals are rational: one
//!    goes through the point that the two share, one lies in their plane. They are held in
//!    integers of a fixed width. Edges parallel to the axes (any four contain two parallel ones)
//!    are scaled to unit directions and then fit `i128`: they skip the floats, which could not
//!    decide the many zeros of architecture. So are double lines, where D = 0.
//! 3. What is left to decide, of transversals over Q(√D), is decided by squaring unbounded
//!    integers. Such a side is zero only for a line that depends on the four.
//!
//! Invariant: directions and numbers of the transversals do not depend on the stage.
//!
//! Complexity: constant.

mod algebra;
mod exact;
#[cfg(test)]
mod tests;

use super::budget::{Budget, U};
use super::counters::{Predicate, Stage, record};
use super::lines::float_side;
use super::lines4::{TransversalCount, discriminant_filter, side};
use super::ring::each;
use crate::geom::Line;
use crate::num::Sign;
pub(super) use algebra::{PAIRS, Products};
use algebra::{conjugates, opposite};
use exact::{Exact, Solution, axial, solve};
pub(super) use exact::{
    NARROW_BITS, count_axial, count_big, count_degenerate, has_skew_triple, is_axial,
};
use std::cell::OnceCell;

/// How a line passes each of the transversals of four lines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sides {
    /// There is no transversal.
    None,
    /// There is one, a double one.
    One(Sign),
    /// There are two, in their order.
    Two([Sign; 2]),
    /// There are infinitely many.
    Family,
}

/// Four lines and what meets them all.
#[derive(Debug)]
pub struct FourLines<'a> {
    lines: [&'a Line; 4],
    bits: u32,
    /// The float stage, where it found two transversals.
    floats: Option<FloatPair>,
    exact: OnceCell<Exact>,
}

/// Two lines in floats.
#[derive(Clone, Copy, Debug)]
struct FloatPair {
    /// Moments, as multiples of those of the grid.
    moment: [[f64; 2]; 3],
    direction: [[f64; 2]; 3],
    /// The error of a side product is this times the other's largest direction.
    error: f64,
}

impl<'a> FourLines<'a> {
    /// The lines that meet all four.
    ///
    /// Requires: the points that the lines were made of are within the budget.
    pub fn new(lines: [&'a Line; 4], budget: &Budget) -> FourLines<'a> {
        let bits = budget.bits();
        let of = |floats: Option<FloatPair>, exact: Option<Exact>| FourLines {
            lines,
            bits,
            floats,
            exact: exact.map_or_else(OnceCell::new, OnceCell::from),
        };
        if bits <= NARROW_BITS && lines.iter().all(|line| is_axial(line)) {
            let solution = solve(&lines.map(axial), i128::from);
            return of(None, Some(Exact::Narrow(solution)));
        }
        if budget.filters() {
            let s = float_products(lines, budget);
            match discriminant_filter(&s) {
                Some(Sign::Negative) => return of(None, Some(Exact::Narrow(Solution::None))),
                Some(Sign::Positive) => {
                    if let Some(floats) = FloatPair::meeting(lines, &s, budget) {
                        return of(Some(floats), None);
                    }
                }
                // One transversal, a family, or too close to that for floats.
                Some(Sign::Zero) | None => {}
            }
        }
        of(None, Some(Exact::of_lines(lines, bits)))
    }

    /// How a line passes each of the lines that meet the four.
    ///
    /// Positive: [`side_of_lines`](super::side_of_lines) of the transversal and the line is;
    /// zero: they meet or are parallel. Transversals are directed so that the first coordinate of
    /// the direction that is not zero is positive, at infinity that of the moment. Two
    /// transversals L and M come in the order in which det(l1, l2, l3, l4, L, M)·side(L, M) is
    /// positive, for Plücker vectors (direction, moment).
    ///
    /// 1. Even permutations of the four change nothing, odd ones swap the transversals, and so
    ///    does reversing one of the four.
    /// 2. Reversing the fifth line changes the signs; one of the four has the side zero.
    /// 3. The product of both signs and of side(L, M) is that of
    ///    [`side_of_transversals`](super::side_of_transversals).
    ///
    /// Requires: the points that the line was made of are within the budget.
    ///
    /// Contract: exact, degree 26, unperturbed
    ///
    /// Source: Teller 1992, section 6.3, and Hohmeyer and Teller 1999, for the lines themselves.
    #[inline]
    pub fn sides_of_each(&self, line: &Line) -> Sides {
        if let Some(signs) = self.floats.and_then(|floats| floats.sides(line)) {
            record(Predicate::SidesOfEach, Stage::Filter);
            return Sides::Two(signs);
        }
        self.sides_exact(line)
    }

    fn sides_exact(&self, line: &Line) -> Sides {
        let exact = self.exact.get_or_init(|| Exact::of_lines(self.lines, self.bits));
        record(Predicate::SidesOfEach, exact.stage());
        exact.sides(line)
    }

    /// How many lines meet the four.
    pub fn count(&self) -> TransversalCount {
        match self.exact.get() {
            None => TransversalCount::Two,
            Some(exact) => exact.count(),
        }
    }
}

impl FloatPair {
    /// Both transversals of lines that certainly have two, H ± √D·W for f = (0, 0, 0, 1, 0, 0).
    ///
    /// Moments are taken in units of C, so that with ν = max |d| over the lines' directions moments
    /// are at most 2ν (m = p×d), and in error by u relatively; side products are rounded once, at
    /// most κ, and κ <= 12ν². To first order, in units of u:
    ///
    /// a, b, c are at most κ² and in error by 3κ², a-b-c at most 3κ² and in error by 9+2+3 = 14κ²;
    /// with m = |a|+|b|+|c| <= 3κ², D <= m² by 24m² (`discriminant_filter`), its root by
    /// 24m²/√D + √D. The adjugate's entries are at most 3κ³ (on the diagonal 2κ³) and in error by
    /// 20κ³ (10κ³). A coordinate of its product with the directions' x is at most 11κ³ν and in
    /// error by 70κ³ν from the entries, 11κ³ν from products and 33κ³ν from sums: 114κ³ν. Four
    /// products with the lines are at most 88κ³ν², and in error by 912 + 88 + 88 + 264 = 1352κ³ν².
    /// Adding D once (at most 9κ⁴ <= 108κ³ν², in error by 216κ⁴ <= 2592κ³ν²) makes H at most
    /// 196κ³ν², in error by 4140κ³ν². Minors of two lines are at most 8ν² and in error by 24 + 8 =
    /// 32ν²; their products at most 64ν⁴, in error by 576ν⁴; six of them at most 384ν⁴, in error by
    /// 3456 + 1280 = 4736ν⁴: W. So H ± √D·W is at most Λ = 196κ³ν² + 384√D·ν⁴, and in error by
    ///   4140κ³ν² + 4736√D·ν⁴ + (24m²/√D + 2√D)·384ν⁴ + Λ <= 4336κ³ν² + 15104ν⁴·m²/√D,
    /// since √D <= m. The side product with a line of direction at most δ and moment at most 2δ is
    /// then in error by 9δ of that, and by (6 + 9 + 45)Λδ from that line's moment, the products and
    /// the sums: by 50784κ³ν²δ + 158976ν⁴δ·m²/√D. The constants below leave a sixth for the higher
    /// orders and this formula's rounding. Nothing underflows: all are integers over powers of C.
    #[inline(always)]
    fn meeting(lines: [&Line; 4], s: &Products<f64>, budget: &Budget) -> Option<FloatPair> {
        let scale = budget.moment_scale;
        let row = |line: &Line| {
            let [a, b, c] = each(*line.paired_direction(), |[d, _]| d);
            let [d, e, f] = each(*line.split_moment(), |[high, low]| (high + low) * scale);
            [a, b, c, d, e, f]
        };
        let [k, l, m, n] = lines;
        let rows = [row(k), row(l), row(m), row(n)];
        let abc = opposite(s);
        let size = abc[0].abs() + abc[1].abs() + abc[2].abs();
        let d = algebra::discriminant(&abc);
        let root = d.sqrt();
        let [h, w] = conjugates(&rows, s, &abc, 3);
        let nu = largest(rows.iter().flat_map(|row| &row[..3]));
        let kappa = largest(s);
        let nu2 = nu * nu;
        let error = U
            * (60_000.0 * kappa * kappa * kappa * nu2
                + 200_000.0 * nu2 * nu2 * size * (size / root));
        if h[0].abs() <= error {
            return None;
        }
        let turn = if h[0] < 0.0 { -1.0 } else { 1.0 };
        let pair = |i: usize| [turn * (h[i] + root * w[i]), turn * (h[i] - root * w[i])];
        Some(FloatPair {
            moment: [pair(3), pair(4), pair(5)],
            direction: each([pair(0), pair(1), pair(2)], |[x, y]| [x * scale, y * scale]),
            error,
        })
    }

    #[inline(always)]
    fn sides(&self, line: &Line) -> Option<[Sign; 2]> {
        let (direction, moment) = (line.paired_direction(), line.split_moment());
        let reach = direction.iter().fold(0.0f64, |reach, [d, _]| reach.max(d.abs()));
        let term = |i: usize| {
            let m = moment[i][0] + moment[i][1];
            let side = |k: usize| self.moment[i][k] * direction[i][k] + self.direction[i][k] * m;
            [side(0), side(1)]
        };
        let [x, y, z] = [term(0), term(1), term(2)];
        let [first, second] = [x[0] + y[0] + z[0], x[1] + y[1] + z[1]];
        let error = self.error * reach;
        (first.abs() > error && second.abs() > error).then(|| [Sign::of(&first), Sign::of(&second)])
    }
}

fn largest<'a>(numbers: impl IntoIterator<Item = &'a f64>) -> f64 {
    numbers.into_iter().fold(0.0, |largest, x| largest.max(x.abs()))
}

/// The side products of four lines, with moments in units of the grid's size; rounded once.
#[inline(always)]
fn float_products([k, l, m, n]: [&Line; 4], budget: &Budget) -> Products<f64> {
    let product = |x: &Line, y: &Line| {
        budget.moment_scale * if budget.exact_lines { float_side(x, y) } else { side(x, y) as f64 }
    };
    let (kl, km, kn) = (product(k, l), product(k, m), product(k, n));
    [kl, km, kn, product(l, m), product(l, n), product(m, n)]
}
