//! Points, and vertices given by three planes, against a plane.

use super::budget::{Budget, ORIENT2D, SIDE_OF_PLANE};
use super::counters::{Predicate, Stage, record};
use super::meets::{self, side_of_meets_big_value, side_of_meets_exact, side_of_meets_filter};
use super::ring::{cross, dot, sign_of_i128};
use crate::geom::{BigPlane, BigPoint3, Plane, Point3};
use crate::num::{Int192, Sign};

/// On which side of `plane` the point `v` lies.
///
/// Positive: on the side that the normal points to; zero: in the plane. For a plane through a, b
/// and c it equals `orient3d(a, b, c, v)`.
///
/// 1. Flipping the plane changes the sign.
/// 2. Translation and positive scaling of plane and point keep it, mirroring changes it.
///
/// Requires: `v`, and the points that the plane was made of, are within the budget. There is no
/// float stage: three products of 64-bit integers are as quick.
///
/// Contract: exact, degree 3, unperturbed
///
/// Source: the definition of a plane's sides; the range is derived in `budget`.
#[inline]
pub fn side_of_plane(plane: &Plane, v: &Point3, budget: &Budget) -> Sign {
    debug_assert!(budget.holds(v), "a point exceeds its budget");
    debug_assert!(budget.holds_plane(plane), "a plane exceeds its budget");
    record(Predicate::SideOfPlane, Stage::Fixed);
    side_of_plane_exact(plane, v, budget)
}

/// The fixed-width stage of [`side_of_plane`].
#[inline]
pub fn side_of_plane_exact(plane: &Plane, v: &Point3, budget: &Budget) -> Sign {
    if budget.bits() <= SIDE_OF_PLANE.largest_grid(64) {
        let normal = plane.normal().map(|n| n as i64);
        return Sign::of(&(dot(&normal, &v.integers()) - plane.offset() as i64));
    }
    if budget.bits() <= ORIENT2D.largest_grid(64) {
        // Normals, which are minors of differences, fit 64 bits: one instruction a product.
        let normal = plane.normal().map(|n| i128::from(n as i64));
        return sign_of_i128(dot(&normal, &v.integers().map(i128::from)) - plane.offset());
    }
    side_of_long_plane(plane, v)
}

/// The plane is one of 40 bits, the point may have 53: 2·40 + 3 + 53 + 2 bits.
#[inline(never)]
fn side_of_long_plane(plane: &Plane, v: &Point3) -> Sign {
    let v = v.integers().map(i128::from);
    let term = |i: usize| Int192::from(plane.normal()[i]).times_i128(v[i]);
    (term(0) + term(1) + term(2) - Int192::from(plane.offset())).sign()
}

/// [`side_of_plane`] on unbounded coordinates.
pub fn side_of_plane_big(plane: &BigPlane, v: &BigPoint3) -> Sign {
    record(Predicate::SideOfPlane, Stage::Big);
    Sign::of(&(dot(&plane.normal, &v.coordinates) - &plane.offset))
}

/// On which side of `plane` the vertex lies in which three other planes meet; `None` where they
/// do not meet in one point.
///
/// Positive: on the side that the plane's normal points to; zero: all four planes share a point.
///
/// 1. The order and the direction of the three do not matter; flipping `plane` changes the sign.
/// 2. Translation and positive scaling keep it, mirroring changes it if planes are transformed
///    with their sides.
///
/// Requires: the points that the planes were made of are within the budget.
///
/// Contract: exact, degree 9, unperturbed
///
/// Source: Sugihara and Iri, A solid modelling system free from topological inconsistency, 1989
/// (plane-based vertices). With v = V/E for the vertex of the planes 1, 2, 3 (E the determinant
/// of their normals) and 4 for the plane, n4·V - o4·E = -side(meet of 1 and 2, meet of 3 and 4),
/// as multiplying out shows.
pub fn vertex_side_of_plane(vertex: [&Plane; 3], plane: &Plane, budget: &Budget) -> Option<Sign> {
    let [first, second, third] = vertex;
    let all = [first, second, third, plane];
    debug_assert!(all.iter().all(|p| budget.holds_plane(p)), "a plane exceeds its budget");
    if budget.filters()
        && let Some(spanned) = meets::normals_filter(vertex)
        && let Some(side) = side_of_meets_filter([first, second], [third, plane])
    {
        record(Predicate::VertexSideOfPlane, Stage::Filter);
        return Some(-side * spanned);
    }
    record(Predicate::VertexSideOfPlane, Stage::Fixed);
    vertex_side_of_plane_exact(vertex, plane, budget)
}

/// The fixed-width stage of [`vertex_side_of_plane`].
pub fn vertex_side_of_plane_exact(
    vertex: [&Plane; 3],
    plane: &Plane,
    budget: &Budget,
) -> Option<Sign> {
    let [first, second, third] = vertex;
    match meets::normals_exact(vertex) {
        // Two of the planes are parallel, or all three are parallel to a line: no vertex.
        Sign::Zero => None,
        spanned @ (Sign::Negative | Sign::Positive) => {
            Some(-side_of_meets_exact([first, second], [third, plane], budget) * spanned)
        }
    }
}

/// [`vertex_side_of_plane`] on unbounded coordinates.
pub fn vertex_side_of_plane_big(vertex: [&BigPlane; 3], plane: &BigPlane) -> Option<Sign> {
    record(Predicate::VertexSideOfPlane, Stage::Big);
    let [first, second, third] = vertex;
    match Sign::of(&dot(&cross(&first.normal, &second.normal), &third.normal)) {
        // Two of the planes are parallel, or all three are parallel to a line: no vertex.
        Sign::Zero => None,
        spanned @ (Sign::Negative | Sign::Positive) => {
            let side = side_of_meets_big_value([first, second], [third, plane]);
            Some(-Sign::of(&side) * spanned)
        }
    }
}
