//! Which of two places comes first along a directed line.

use super::budget::{Budget, COMPARE_ALONG_LINE, COMPARE_CROSSINGS, SIDE_OF_PLANE};
use super::counters::{Predicate, Stage, record};
use super::ring::{difference, dot, sign_of_i128};
use crate::geom::{BigPlane, BigPoint3, Plane, Point3};
use crate::num::{Int, Int256, Sign};

/// Which of `first` and `second` comes first along the direction from `p` to `q`.
///
/// Positive: `first` comes before `second`; zero: they are level (for points of the line: the
/// same point). The sign of (second - first)·(q - p).
///
/// 1. Swapping the two points, or `p` and `q`, changes the sign.
/// 2. Translation, positive scaling and mirroring keep it.
///
/// Requires: nothing. There is no float stage: three products of 64-bit integers are as quick.
///
/// Contract: exact, degree 2, unperturbed
///
/// Source: the projection of one vector on another.
#[inline]
pub fn compare_along_line(p: &Point3, q: &Point3, first: &Point3, second: &Point3) -> Sign {
    record(Predicate::CompareAlongLine, Stage::Fixed);
    compare_along_line_exact(p, q, first, second)
}

/// The fixed-width stage of [`compare_along_line`]: 2·53 + 4 bits, so that `i128` always does.
#[inline]
pub fn compare_along_line_exact(p: &Point3, q: &Point3, first: &Point3, second: &Point3) -> Sign {
    const { assert!(COMPARE_ALONG_LINE.largest_grid(128) >= 53) }
    let d = difference(&q.integers(), &p.integers()).map(i128::from);
    let e = difference(&second.integers(), &first.integers()).map(i128::from);
    sign_of_i128(dot(&d, &e))
}

/// [`compare_along_line`] on unbounded coordinates.
pub fn compare_along_line_big(
    p: &BigPoint3,
    q: &BigPoint3,
    first: &BigPoint3,
    second: &BigPoint3,
) -> Sign {
    record(Predicate::CompareAlongLine, Stage::Big);
    let d = difference(&q.coordinates, &p.coordinates);
    Sign::of(&dot(&d, &difference(&second.coordinates, &first.coordinates)))
}

/// Which of two planes the directed line from `p` to `q` crosses first; `None` where it is
/// parallel to one of them.
///
/// Positive: it crosses `first` before `second`; zero: it crosses both in one point.
///
/// 1. Swapping the planes, or `p` and `q`, changes the sign; flipping a plane keeps it.
/// 2. Translation, positive scaling and mirroring keep it.
///
/// Requires: the points, also those that the planes were made of, are within the budget, at most
/// 40 bits.
///
/// Contract: exact, degree 6, unperturbed
///
/// Source: with d = q - p the line crosses the plane n·x = o at p + t·d, t = (o - n·p)/(n·d); the
/// sign is that of t2 - t1.
pub fn compare_crossings(
    p: &Point3,
    q: &Point3,
    first: &Plane,
    second: &Plane,
    budget: &Budget,
) -> Option<Sign> {
    debug_assert!(budget.holds(p) && budget.holds(q), "a point exceeds its budget");
    let planes = [first, second];
    debug_assert!(planes.iter().all(|p| budget.holds_plane(p)), "a plane exceeds its budget");
    record(Predicate::CompareCrossings, Stage::Fixed);
    compare_crossings_exact(p, q, first, second, budget)
}

/// The fixed-width stage of [`compare_crossings`].
pub fn compare_crossings_exact(
    p: &Point3,
    q: &Point3,
    first: &Plane,
    second: &Plane,
    budget: &Budget,
) -> Option<Sign> {
    // The factors have the range of `side_of_plane`, their products that of the comparison.
    assert!(budget.bits() <= SIDE_OF_PLANE.largest_grid(128), "a budget beyond 40 bits");
    const { assert!(COMPARE_CROSSINGS.largest_grid(256) >= 40) }
    let d = difference(&q.integers(), &p.integers()).map(i128::from);
    let p = p.integers().map(i128::from);
    let crossing =
        |plane: &Plane| (plane.offset() - dot(&plane.normal(), &p), dot(&plane.normal(), &d));
    let ((rise1, run1), (rise2, run2)) = (crossing(first), crossing(second));
    let value = Int256::product(rise2, run1) - Int256::product(rise1, run2);
    order(value.sign(), sign_of_i128(run1), sign_of_i128(run2))
}

/// [`compare_crossings`] on unbounded coordinates.
pub fn compare_crossings_big(
    p: &BigPoint3,
    q: &BigPoint3,
    first: &BigPlane,
    second: &BigPlane,
) -> Option<Sign> {
    record(Predicate::CompareCrossings, Stage::Big);
    let d = difference(&q.coordinates, &p.coordinates);
    let crossing = |plane: &BigPlane| -> (Int, Int) {
        (&plane.offset - dot(&plane.normal, &p.coordinates), dot(&plane.normal, &d))
    };
    let ((rise1, run1), (rise2, run2)) = (crossing(first), crossing(second));
    let value = rise2 * &run1 - rise1 * &run2;
    order(Sign::of(&value), Sign::of(&run1), Sign::of(&run2))
}

/// The sign of t2 - t1 = value/(run1·run2).
fn order(value: Sign, run1: Sign, run2: Sign) -> Option<Sign> {
    match run1 * run2 {
        // Parallel to one of the planes: no crossing to compare.
        Sign::Zero => None,
        runs @ (Sign::Negative | Sign::Positive) => Some(value * runs),
    }
}
