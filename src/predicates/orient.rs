//! Orientation of points: `orient2d`, `orient3d`.

use super::budget::{Budget, ORIENT2D, ORIENT3D, RESIDUE_BITS};
use super::counters::{Predicate, Stage, record};
use super::ring::{Residue, cross, determinant, difference, dot, each, sign_of_i128};
use crate::geom::{BigPoint2, BigPoint3, Point2, Point3, RationalPoint3};
use crate::num::{Int, Int192, Sign};

/// Whether `a`, `b`, `c` turn left.
///
/// Positive: `c` lies to the left of the directed line from `a` to `b`; zero: the three are
/// collinear. The sign of (b-a) x (c-a).
///
/// 1. Cyclic permutations keep the sign, swaps change it.
/// 2. Translation and positive scaling keep it, mirroring changes it.
///
/// Requires: nothing. There is no float stage: two products of 64-bit integers are as quick.
///
/// Contract: exact, degree 2, unperturbed
///
/// Source: Shewchuk, Adaptive precision floating-point arithmetic and fast robust geometric
/// predicates, 1997, section 4.1 (for the formula).
#[inline]
pub fn orient2d(a: &Point2, b: &Point2, c: &Point2) -> Sign {
    record(Predicate::Orient2d, Stage::Fixed);
    orient2d_exact(a, b, c)
}

/// The fixed-width stage of [`orient2d`]: 2·53 + 3 bits, so that `i128` always does.
#[inline]
pub fn orient2d_exact(a: &Point2, b: &Point2, c: &Point2) -> Sign {
    const { assert!(ORIENT2D.largest_grid(128) >= 53) }
    let ([ax, ay], [bx, by], [cx, cy]) = (a.integers(), b.integers(), c.integers());
    let product = |x: i64, y: i64| i128::from(x) * i128::from(y);
    sign_of_i128(product(bx - ax, cy - ay) - product(by - ay, cx - ax))
}

/// [`orient2d`] on unbounded coordinates.
pub fn orient2d_big(a: &BigPoint2, b: &BigPoint2, c: &BigPoint2) -> Sign {
    record(Predicate::Orient2d, Stage::Big);
    let ([ax, ay], [bx, by], [cx, cy]) = (&a.coordinates, &b.coordinates, &c.coordinates);
    Sign::of(&((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)))
}

/// On which side of the plane of `a`, `b`, `c` the point `d` lies.
///
/// Positive: `d` lies on the side from which `a`, `b`, `c` are seen counter-clockwise; zero: the
/// four are coplanar. The sign of det[b-a, c-a, d-a]. The `robust` crate's has the other sign.
///
/// 1. Even permutations of the four keep the sign, odd ones change it.
/// 2. Translation and positive scaling keep it, mirroring changes it.
/// 3. It is `side_of_lines` of the line ab and the line cd.
///
/// ```text
///        d                 positive: the right hand's
///        |  c              thumb, index and middle finger
///        | /               are b-a, c-a and d-a
///        a-----b
/// ```
///
/// Requires: the points are within the budget.
///
/// Contract: exact, degree 3, unperturbed
///
/// Source: Shewchuk 1997, section 4.1; Brönnimann, Emiris, Pan and Pion, Sign determination in
/// residue number systems, 1999, for deciding small values by their remainders.
#[inline]
pub fn orient3d(a: &Point3, b: &Point3, c: &Point3, d: &Point3, budget: &Budget) -> Sign {
    debug_assert!([a, b, c, d].iter().all(|p| budget.holds(p)), "a point exceeds its budget");
    // On small grids integers are as quick as floats, and exact zeros cost nothing extra.
    if budget.bits() <= MOSTLY_IN_I64 {
        record(Predicate::Orient3d, Stage::Fixed);
        return orient3d_shortest(a, b, c, d);
    }
    if budget.bits() <= MINOR_IN_I64 {
        record(Predicate::Orient3d, Stage::Fixed);
        return orient3d_short(a, b, c, d);
    }
    orient3d_long(a, b, c, d, budget)
}

/// The largest grid on which the value is an `i64` as a rule. Up to one bit less it always is one,
/// being below 2^(3b+6); here only tetrahedra of half the cube's largest may exceed it: with the
/// edge E = 2^(b+1) of the cube the value is at most 2E³ = 2^64.
const MOSTLY_IN_I64: u32 = ORIENT3D.largest_grid(64) + 1;

/// The largest grid on which a minor of differences, below 2^(2b+3), is an `i64`.
const MINOR_IN_I64: u32 = ORIENT2D.largest_grid(64);

/// [`orient3d`] where the value fits 64 bits, or nearly always does.
#[inline(always)]
fn orient3d_shortest(a: &Point3, b: &Point3, c: &Point3, d: &Point3) -> Sign {
    let (q, r, s) = (mirrored(a, b), mirrored(a, c), mirrored(a, d));
    let minors = cross(&r, &q);
    let term = |i: usize| minors[i].checked_mul(s[i]);
    let value = || term(0)?.checked_add(term(1)?)?.checked_add(term(2)?);
    match value() {
        Some(value) => Sign::of(&value),
        None => orient3d_overflown(a, b, c, d),
    }
}

#[cold]
#[inline(never)]
fn orient3d_overflown(a: &Point3, b: &Point3, c: &Point3, d: &Point3) -> Sign {
    orient3d_short(a, b, c, d)
}

/// [`orient3d`] where minors fit 64 bits.
#[inline(always)]
fn orient3d_short(a: &Point3, b: &Point3, c: &Point3, d: &Point3) -> Sign {
    let (b, c, d) = (mirrored(a, b), mirrored(a, c), mirrored(a, d));
    sign_of_i128(dot(&each(cross(&c, &b), i128::from), &each(d, i128::from)))
}

/// The difference p - a with its second coordinate mirrored, which swapping b and c makes up for.
/// Subtracting alternately from left and right keeps the compiler from pairing the subtractions
/// in vector registers, only to take them apart again for the products.
#[inline(always)]
fn mirrored(a: &Point3, p: &Point3) -> [i64; 3] {
    let ([a, b, c], [x, y, z]) = (a.integers(), p.integers());
    [x - a, b - y, z - c]
}

/// [`orient3d`] beyond that. Apart, so that the rest is small enough to be inlined.
#[inline(never)]
fn orient3d_long(a: &Point3, b: &Point3, c: &Point3, d: &Point3, budget: &Budget) -> Sign {
    if budget.filters()
        && let Some(sign) = orient3d_filter(a, b, c, d, budget)
    {
        record(Predicate::Orient3d, Stage::Filter);
        return sign;
    }
    record(Predicate::Orient3d, Stage::Fixed);
    if budget.filters() && budget.bits() <= RESIDUE_BITS {
        let residues = |p: &Point3| each(p.integers(), Residue);
        let (a, b, c, d) = (residues(a), residues(b), residues(c), residues(d));
        return Sign::of(&determinant(&a, &b, &c, &d).0);
    }
    orient3d_exact(a, b, c, d, budget)
}

/// The float stage of [`orient3d`]; the error bound is derived in `budget`.
#[inline]
pub fn orient3d_filter(
    a: &Point3,
    b: &Point3,
    c: &Point3,
    d: &Point3,
    budget: &Budget,
) -> Option<Sign> {
    // Integer differences are exact where float ones might not be, and round once.
    let origin = a.integers();
    let [b, c, d] = each([b, c, d], |p| each(difference(&p.integers(), &origin), |x| x as f64));
    let value = determinant(&[0.0; 3], &b, &c, &d);
    if value > budget.orient3d_error {
        Some(Sign::Positive)
    } else if value < -budget.orient3d_error {
        Some(Sign::Negative)
    } else {
        None
    }
}

/// The fixed-width stage of [`orient3d`], in the narrowest width that the budget allows.
#[inline]
pub fn orient3d_exact(a: &Point3, b: &Point3, c: &Point3, d: &Point3, budget: &Budget) -> Sign {
    if budget.bits() <= MINOR_IN_I64 {
        return orient3d_short(a, b, c, d);
    }
    let origin = a.integers();
    let [b, c, d] = each([b, c, d], |p| each(difference(&p.integers(), &origin), i128::from));
    if budget.bits() <= ORIENT3D.largest_grid(128) {
        return sign_of_i128(determinant(&[0; 3], &b, &c, &d));
    }
    const { assert!(ORIENT3D.largest_grid(192) >= 53) }
    let minors = cross(&b, &c);
    let term = |i: usize| Int192::from(minors[i]).times_i128(d[i]);
    (term(0) + term(1) + term(2)).sign()
}

/// [`orient3d`] on unbounded coordinates.
pub fn orient3d_big(a: &BigPoint3, b: &BigPoint3, c: &BigPoint3, d: &BigPoint3) -> Sign {
    record(Predicate::Orient3d, Stage::Big);
    let [a, b, c, d] = [a, b, c, d].map(|p| &p.coordinates);
    Sign::of(&determinant(a, b, c, d))
}

/// [`orient3d`] on rational coordinates, without a common denominator of all four: each difference
/// is taken times the two denominators that it has, which are positive.
///
/// Contract: exact, degree 3, unperturbed
pub fn orient3d_rational(
    a: &RationalPoint3,
    b: &RationalPoint3,
    c: &RationalPoint3,
    d: &RationalPoint3,
) -> Sign {
    record(Predicate::Orient3d, Stage::Big);
    let arm = |p: &RationalPoint3| -> [Int; 3] {
        std::array::from_fn(|i| {
            &p.numerators()[i] * a.denominator() - &a.numerators()[i] * p.denominator()
        })
    };
    Sign::of(&dot(&cross(&arm(b), &arm(c)), &arm(d)))
}
