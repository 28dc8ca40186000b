//! One point of a plan, and the predicates on points that stand in no table.

use crate::num::{Int, Rational, Sign, Wide};
use num_integer::Integer;
use num_traits::{One, Signed, ToPrimitive};
use std::cmp::Ordering;

/// A point of the plane with rational coordinates, in grid units.
///
/// Equality and hash are those of the exact point.
#[derive(Clone, Debug)]
pub struct PlanPoint {
    exact: Exact,
    /// Each within [`RELATIVE_ERROR`] of the coordinate, relative to it.
    floats: [f64; 2],
}

/// x, y and their common denominator w > 0, in lowest terms; small wherever that fits.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
enum Exact {
    /// All below [`SMALL`] in magnitude.
    Small([i64; 3]),
    Big(Box<[Int; 3]>),
}

/// The bound of [`Exact::Small`].
const SMALL: i64 = 1 << 61;

/// Of each float of a point. A small coordinate is a quotient of two rounded integers, so it is off
/// by three roundings of 2^-53 and their products; a quotient of unbounded integers is cut to the
/// leading 64 bits of each of them first, which adds two errors of 2^-63 at most.
const RELATIVE_ERROR: f64 = 1.0 / (1u64 << 50) as f64;

impl PartialEq for PlanPoint {
    fn eq(&self, other: &PlanPoint) -> bool {
        self.exact == other.exact
    }
}

impl Eq for PlanPoint {}

impl std::hash::Hash for PlanPoint {
    fn hash<H: std::hash::Hasher>(&self, state: &mut H) {
        self.exact.hash(state);
    }
}

impl PlanPoint {
    /// The point (x, y) / w.
    ///
    /// # Panics
    /// If `w` is zero.
    pub fn new([x, y, w]: [Int; 3]) -> PlanPoint {
        assert!(w != Int::ZERO, "a point at infinity");
        let mut divisor = w.gcd(&x).gcd(&y);
        if w.is_negative() {
            divisor = -divisor;
        }
        let reduced = if divisor.is_one() { [x, y, w] } else { [x, y, w].map(|c| c / &divisor) };
        let small = reduced.each_ref().map(Int::to_i64);
        match small {
            [Some(x), Some(y), Some(w)] if [x, y, w].iter().all(|c| c.abs() < SMALL) => {
                PlanPoint::small([x, y, w])
            }
            _ => PlanPoint {
                floats: [quotient(&reduced[0], &reduced[2]), quotient(&reduced[1], &reduced[2])],
                exact: Exact::Big(Box::new(reduced)),
            },
        }
    }

    /// The point with these coordinates.
    pub fn from_coordinates([x, y]: &[Rational; 2]) -> PlanPoint {
        let w = x.denom().lcm(y.denom());
        PlanPoint::new([x.numer() * (&w / x.denom()), y.numer() * (&w / y.denom()), w])
    }

    /// The point with integer coordinates.
    pub fn integer(coordinates: [Int; 2]) -> PlanPoint {
        let [x, y] = coordinates;
        PlanPoint::new([x, y, Int::from(1)])
    }

    fn small(exact: [i64; 3]) -> PlanPoint {
        let [x, y, w] = exact.map(|c| c as f64);
        PlanPoint { exact: Exact::Small(exact), floats: [x / w, y / w] }
    }

    /// The meet of the lines through `a`, `b` and through `c`, `d`; `None` where they are parallel.
    pub fn meet(a: &PlanPoint, b: &PlanPoint, c: &PlanPoint, d: &PlanPoint) -> Option<PlanPoint> {
        if let (Exact::Small(a), Exact::Small(b), Exact::Small(c), Exact::Small(d)) =
            (&a.exact, &b.exact, &c.exact, &d.exact)
            && let Some(meet) = small_meet([a, b, c, d])
        {
            return meet;
        }
        let line = cross(&a.numbers(), &b.numbers());
        let meet = cross(&line, &cross(&c.numbers(), &d.numbers()));
        (meet[2] != Int::ZERO).then(|| PlanPoint::new(meet))
    }

    /// x, y and their common denominator w > 0, in lowest terms.
    pub fn numbers(&self) -> [Int; 3] {
        match &self.exact {
            Exact::Small(numbers) => numbers.map(Int::from),
            Exact::Big(numbers) => numbers.as_ref().clone(),
        }
    }

    /// The coordinates, in grid units.
    pub fn coordinates(&self) -> [Rational; 2] {
        let [x, y, w] = self.numbers();
        [Rational::new(x, w.clone()), Rational::new(y, w)]
    }

    /// The coordinates to the precision of floats, to propose and to show.
    #[inline]
    pub fn floats(&self) -> [f64; 2] {
        self.floats
    }

    /// The coordinates, if they are integers below 2^61 in magnitude.
    #[inline]
    pub fn small_integers(&self) -> Option<[i64; 2]> {
        match self.exact {
            Exact::Small([x, y, 1]) => Some([x, y]),
            _ => None,
        }
    }
}

/// `Some(None)` for parallel lines, `None` where a number may not fit.
fn small_meet(points: [&[i64; 3]; 4]) -> Option<Option<PlanPoint>> {
    let [a, b, c, d] = points.map(|p| p.map(i128::from));
    let cross = |p: [i128; 3], q: [i128; 3]| -> Option<[i128; 3]> {
        let minor =
            |i: usize, j: usize| p[i].checked_mul(q[j])?.checked_sub(p[j].checked_mul(q[i])?);
        Some([minor(1, 2)?, minor(2, 0)?, minor(0, 1)?])
    };
    let [x, y, w] = cross(cross(a, b)?, cross(c, d)?)?;
    if w == 0 {
        return Some(None);
    }
    let divisor = x.gcd(&y).gcd(&w) * w.signum();
    let small = [x / divisor, y / divisor, w / divisor].map(|c| i64::try_from(c).ok());
    match small {
        [Some(x), Some(y), Some(w)] if x.abs().max(y.abs()).max(w) < SMALL => {
            Some(Some(PlanPoint::small([x, y, w])))
        }
        _ => None,
    }
}

fn cross(p: &[Int; 3], q: &[Int; 3]) -> [Int; 3] {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| &p[i] * &q[j] - &p[j] * &q[i])
}

/// `p / q` in floats, within [`RELATIVE_ERROR`]; infinite or zero beyond their range, which no
/// filter trusts.
fn quotient(p: &Int, q: &Int) -> f64 {
    let leading = |n: &Int| {
        let drop = n.bits().saturating_sub(64);
        let top = (n.magnitude() >> drop).to_u64().unwrap_or(u64::MAX) as f64;
        (if n.is_negative() { -top } else { top }, drop as i64)
    };
    let ((p, p_drop), (q, q_drop)) = (leading(p), leading(q));
    let exponent = (p_drop - q_drop).clamp(-5000, 5000) as i32;
    // In two steps, each within the range of powers.
    p / q * 2f64.powi(exponent / 2) * 2f64.powi(exponent - exponent / 2)
}

/// Whether `a`, `b`, `c` turn left: [`orient2d`](crate::predicates::orient2d) on points of plans.
///
/// Positive: `c` lies to the left of the directed line from `a` to `b`; zero: the three are
/// collinear, or two of them are one.
///
/// 1. Cyclic permutations keep the sign, swaps change it.
/// 2. Translation and positive scaling keep it, mirroring changes it.
///
/// Requires: nothing.
///
/// Contract: exact, degree 3 in x, y, w (8 in the ends of walls where all are meets), unperturbed
///
/// Source: as `orient2d`, in homogeneous coordinates.
pub fn turn_of_points(a: &PlanPoint, b: &PlanPoint, c: &PlanPoint) -> Sign {
    let largest = [a, b, c].iter().flat_map(|p| p.floats).fold(0.0, |m: f64, c| m.max(c.abs()));
    turn_of_points_filter(a, b, c, error_bound(largest)).unwrap_or_else(|| turn_exact(a, b, c))
}

/// The error bound of [`turn_of_points_filter`] where no coordinate exceeds `largest` = M.
///
/// With e = [`RELATIVE_ERROR`] = 2^-50 a coordinate is off by eM, a computed difference of two by
/// 2eM + 2^-53·2M(1 + e) < 2.3eM, and is below 2M(1 + 2e) in magnitude. A product of two is off by
/// less than 2·2M·2.3eM + (2.3eM)² + 2^-53·4.1M² < 9.8eM², their difference by twice that and its
/// own rounding 2^-53·8.3M² < 1.1eM²: below 21eM². 32e = 2^-45 leaves room for the rounding here.
#[inline]
pub(super) fn error_bound(largest: f64) -> f64 {
    32.0 * RELATIVE_ERROR * largest * largest
}

/// The float stage of [`turn_of_points`], with the bound of all coordinates at hand.
///
/// A bound that is no number (from coordinates beyond the range of floats) decides nothing.
#[inline]
pub fn turn_of_points_filter(
    a: &PlanPoint,
    b: &PlanPoint,
    c: &PlanPoint,
    bound: f64,
) -> Option<Sign> {
    turn_filter(a.floats, b.floats, c.floats, bound)
}

/// [`turn_of_points_filter`] on the points' floats.
#[inline(always)]
pub(super) fn turn_filter(
    [ax, ay]: [f64; 2],
    [bx, by]: [f64; 2],
    [cx, cy]: [f64; 2],
    bound: f64,
) -> Option<Sign> {
    let turn = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
    if turn > bound {
        Some(Sign::Positive)
    } else if turn < -bound {
        Some(Sign::Negative)
    } else {
        None
    }
}

/// The exact stages of [`turn_of_points`].
///
/// Small numbers are below 2^61: a minor of two rows is below 2^123, its product with a third
/// number below 2^184, and the sum of three below 2^186, which 192 bits hold. With all three
/// denominators 1 a difference is below 2^62 and the value below 2^125.
#[inline(never)]
pub(super) fn turn_exact(a: &PlanPoint, b: &PlanPoint, c: &PlanPoint) -> Sign {
    match (&a.exact, &b.exact, &c.exact) {
        (Exact::Small([ax, ay, 1]), Exact::Small([bx, by, 1]), Exact::Small([cx, cy, 1])) => {
            let product = |p: i64, q: i64| i128::from(p) * i128::from(q);
            Sign::of(&(product(bx - ax, cy - ay) - product(by - ay, cx - ax)))
        }
        (Exact::Small(a), Exact::Small(b), Exact::Small(c)) => {
            let minor = |i: usize, j: usize| {
                i128::from(a[i]) * i128::from(b[j]) - i128::from(a[j]) * i128::from(b[i])
            };
            let term = |i, j, k: usize| Wide::<3>::from(minor(i, j)).times_i64(c[k]);
            (term(0, 1, 2) + term(1, 2, 0) + term(2, 0, 1)).sign()
        }
        _ => {
            let normal = cross(&a.numbers(), &b.numbers());
            let value: Int = normal.iter().zip(&c.numbers()).map(|(n, c)| n * c).sum();
            Sign::of(&value)
        }
    }
}

/// The order of two points by one coordinate: 0 for x, 1 for y.
///
/// Contract: exact, degree 2 in x, y, w, unperturbed
pub fn compare_coordinates(axis: usize, a: &PlanPoint, b: &PlanPoint) -> Ordering {
    match (&a.exact, &b.exact) {
        (Exact::Small(a), Exact::Small(b)) => {
            let product = |p: i64, q: i64| i128::from(p) * i128::from(q);
            product(a[axis], b[2]).cmp(&product(b[axis], a[2]))
        }
        _ => {
            let (a, b) = (a.numbers(), b.numbers());
            (&a[axis] * &b[2]).cmp(&(&b[axis] * &a[2]))
        }
    }
}
