//! How one line passes another where both are given as meets of two planes.
//!
//! The meet of the planes n1·x = o1 and n2·x = o2 has the direction n1 x n2 and the moment
//! o2·n1 - o1·n2 (take any point p of it: p x (n1 x n2) = n1(p·n2) - n2(p·n1)). Its Plücker
//! coordinates are never reduced or rounded: bit growth ends here, whatever was built from the
//! planes before (Sugihara and Iri, A solid modelling system free from topological
//! inconsistency, 1989).

use super::budget::{Budget, SIDE_OF_MEETS, U};
use super::counters::{Predicate, Stage, record};
use super::ring::{cross, difference, dot};
use crate::geom::{BigPlane, Plane};
use crate::num::{Int, Int256, Sign, Wide};

/// The Plücker side of two lines, each the meet of two planes and directed along the cross
/// product of their normals.
///
/// Positive: as for [`side_of_lines`](super::side_of_lines); zero: the lines meet or are
/// parallel, or one of the pairs is of parallel planes.
///
/// 1. Symmetric in the two lines; swapping the planes of a line, or flipping one of them, changes
///    the sign.
/// 2. Translation and positive scaling keep it.
///
/// Requires: the points that the planes were made of are within the budget.
///
/// Contract: exact, degree 9, unperturbed
///
/// Source: Stolfi, Oriented projective geometry, 1991 (the meet as the dual of the join); it is
/// the determinant of the four planes' coefficients up to sign.
pub fn side_of_meets(x: [&Plane; 2], y: [&Plane; 2], budget: &Budget) -> Sign {
    let all = [x[0], x[1], y[0], y[1]];
    debug_assert!(all.iter().all(|p| budget.holds_plane(p)), "a plane exceeds its budget");
    if budget.filters()
        && let Some(sign) = side_of_meets_filter(x, y)
    {
        record(Predicate::SideOfMeets, Stage::Filter);
        return sign;
    }
    record(Predicate::SideOfMeets, Stage::Fixed);
    side_of_meets_exact(x, y, budget)
}

/// The float stage of [`side_of_meets`], with a bound from the planes' own magnitudes.
///
/// For plane i let N_i bound the normal's coordinates and O_i the offset, as floats, each in
/// error by u relative. For a meet of planes 1 and 2 let D = N1·N2 and W = O2·N1 + O1·N2.
/// A coordinate of the direction (at most 2D) is in error by 4uD from its factors, 2uD from its
/// products and 2uD from their difference: 9uD with higher orders. One of the moment (at most W)
/// by 2uW, uW and uW: 5uW with higher orders. The side d·m' + m·d' is then off by
/// 3(2·5 + 9)u(DW' + WD') = 57u(DW' + WD') from its factors and 11u(2DW' + 2WD') from the
/// evaluation (see `filtered`): 79u, and 88 with higher orders and the rounding of the bound
/// itself. Values stay below 2^400 and are integers: no overflow, no underflow.
pub fn side_of_meets_filter(x: [&Plane; 2], y: [&Plane; 2]) -> Option<Sign> {
    let (d, m, scale_d, scale_m) = float_meet(x);
    let (e, n, scale_e, scale_n) = float_meet(y);
    let error = 88.0 * U * (scale_d * scale_n + scale_m * scale_e);
    let value = dot(&d, &n) + dot(&m, &e);
    (value.abs() > error).then(|| Sign::of(&value))
}

/// Direction, moment, and their scales D and W.
fn float_meet([first, second]: [&Plane; 2]) -> ([f64; 3], [f64; 3], f64, f64) {
    let ((n1, o1), (n2, o2)) = (first.floats(), second.floats());
    let (max1, max2) = (max_abs(n1), max_abs(n2));
    let moment = difference(&n1.map(|n| o2 * n), &n2.map(|n| o1 * n));
    (cross(n1, n2), moment, max1 * max2, o2.abs() * max1 + o1.abs() * max2)
}

fn max_abs(a: &[f64; 3]) -> f64 {
    a[0].abs().max(a[1].abs()).max(a[2].abs())
}

/// The float stage for the sign of the determinant of three normals: the direction's error 9uD
/// times 3N3, its magnitude 2D times 3uN3, and the last dot product's u(6 + 4 + 6)DN3 make
/// 49u·D·N3; 56 with higher orders.
pub(super) fn normals_filter([first, second, third]: [&Plane; 3]) -> Option<Sign> {
    let (direction, _, scale, _) = float_meet([first, second]);
    let (normal, _) = third.floats();
    let value = dot(&direction, normal);
    (value.abs() > 56.0 * U * scale * max_abs(normal)).then(|| Sign::of(&value))
}

/// The sign of the determinant of three normals: 6b + 12 bits, at most 252.
pub(super) fn normals_exact([first, second, third]: [&Plane; 3]) -> Sign {
    let (direction, normal) = (wide_direction::<4>([first, second]), third.normal());
    let term = |i: usize| direction[i].times_i128(normal[i]);
    (term(0) + term(1) + term(2)).sign()
}

/// The largest grid on which meets of planes have coordinates of an `i128`.
///
/// Normals are twice the area of a triangle in a square, seen along an axis: at most D² =
/// 2^(2b+2). Offsets are determinants of three points: at most 4C³ = 2^(3b+2) (both are affine in
/// every coordinate, so that they are extreme at corners of the box, which a test tries). Moments
/// are then at most 2·2^(2b+2)·2^(3b+2) = 2^(5b+5): 125 bits. Sides are below 2^(9b+19): 235 bits.
const SHORT_MEETS: u32 = 24;

/// The fixed-width stage of [`side_of_meets`]: 128 bits and products in 256 up to the 24 bits of
/// level geometry, 192 and 320 up to the 33 of portal files with six decimals, 256 and 512 up to
/// the 40 that a [`Plane`] holds.
pub fn side_of_meets_exact(x: [&Plane; 2], y: [&Plane; 2], budget: &Budget) -> Sign {
    if budget.bits() <= SHORT_MEETS {
        return short_side(x, y);
    }
    if budget.bits() <= SIDE_OF_MEETS.largest_grid(320) {
        return wide_side::<3, 5>(x, y);
    }
    const { assert!(SIDE_OF_MEETS.largest_grid(512) >= 40) }
    wide_side::<4, 8>(x, y)
}

/// [`side_of_meets_exact`] where meets have coordinates of an `i128`.
fn short_side(x: [&Plane; 2], y: [&Plane; 2]) -> Sign {
    let meet = |[first, second]: [&Plane; 2]| {
        // Normals fit 64 bits: saying so makes one instruction of a product.
        let [n, m] = [first, second].map(|plane| plane.normal().map(|n| i128::from(n as i64)));
        let moment = difference(&n.map(|n| second.offset() * n), &m.map(|m| first.offset() * m));
        (cross(&n, &m), moment)
    };
    let ((d, m), (e, n)) = (meet(x), meet(y));
    let term = |i: usize| Int256::product(d[i], n[i]) + Int256::product(m[i], e[i]);
    (term(0) + term(1) + term(2)).sign()
}

/// Moments and directions in `M` limbs, their products and sums in `R`.
fn wide_side<const M: usize, const R: usize>(x: [&Plane; 2], y: [&Plane; 2]) -> Sign {
    let (d, m) = (wide_direction::<M>(x), wide_moment::<M>(x));
    let (e, n) = (wide_direction::<M>(y), wide_moment::<M>(y));
    let mut value = Wide::<R>::ZERO;
    for i in 0..3 {
        value += d[i].times::<M, R>(&n[i]);
        value += m[i].times::<M, R>(&e[i]);
    }
    value.sign()
}

/// n1 x n2: 4b + 7 bits.
fn wide_direction<const M: usize>([first, second]: [&Plane; 2]) -> [Wide<M>; 3] {
    let (n, m) = (first.normal(), second.normal());
    let minor = |i: usize, j: usize| narrow(n[i], m[j]) - narrow(n[j], m[i]);
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

/// o2·n1 - o1·n2: 5b + 9 bits.
fn wide_moment<const M: usize>([first, second]: [&Plane; 2]) -> [Wide<M>; 3] {
    let (n, m) = (first.normal(), second.normal());
    let coordinate = |i: usize| narrow(second.offset(), n[i]) - narrow(first.offset(), m[i]);
    [coordinate(0), coordinate(1), coordinate(2)]
}

/// A product that is known to fit its width.
fn narrow<const M: usize>(a: i128, b: i128) -> Wide<M> {
    Wide::<2>::from(a).times(&Wide::<2>::from(b))
}

/// [`side_of_meets`] on unbounded coordinates.
pub fn side_of_meets_big(x: [&BigPlane; 2], y: [&BigPlane; 2]) -> Sign {
    record(Predicate::SideOfMeets, Stage::Big);
    Sign::of(&side_of_meets_big_value(x, y))
}

/// The value whose sign [`side_of_meets_big`] is.
pub(super) fn side_of_meets_big_value(x: [&BigPlane; 2], y: [&BigPlane; 2]) -> Int {
    let meet = |[first, second]: [&BigPlane; 2]| {
        let scaled = |plane: &BigPlane, by: &Int| plane.normal.each_ref().map(|n| n * by);
        let moment = difference(&scaled(first, &second.offset), &scaled(second, &first.offset));
        (cross(&first.normal, &second.normal), moment)
    };
    let ((d, m), (e, n)) = (meet(x), meet(y));
    dot(&d, &n) + dot(&m, &e)
}
