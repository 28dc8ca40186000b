//! Volume and area of what a boundary encloses.
//!
//! What lies in one plane is summed first: each polygon's doubled area vector is the plane's
//! normal times a ratio, and neither the distance from the origin nor the normal's length, which
//! may be irrational, is asked for more than once.

use crate::construct::{PlaneId, PlaneSet, Polygon};
use crate::geom::vector::dot;
use crate::num::{Int, Rational, sum};
use num_traits::Zero;
use std::collections::BTreeMap;

/// The volume within a closed boundary.
pub(super) fn volume(planes: &PlaneSet, boundary: &[Polygon]) -> Rational {
    // Six times a pyramid over the origin is the doubled area times the distance.
    let pyramids = by_plane(planes, boundary);
    let six = sum(pyramids.into_iter().map(|(plane, ratio)| ratio * &planes.plane(plane).offset));
    six / Int::from(6)
}

/// The area of polygons, if it is rational.
pub(super) fn area(planes: &PlaneSet, boundary: &[Polygon]) -> Option<Rational> {
    let lengths = by_plane(planes, boundary).into_iter().map(|(plane, ratio)| {
        let normal = &planes.plane(plane).normal;
        Some(ratio * root(&dot(normal, normal))?)
    });
    let doubled = sum(lengths.collect::<Option<Vec<_>>>()?);
    Some(doubled / Int::from(2))
}

/// The doubled area of all polygons of a plane over the length of its normal, by plane.
fn by_plane(planes: &PlaneSet, boundary: &[Polygon]) -> BTreeMap<PlaneId, Rational> {
    let mut polygons: BTreeMap<PlaneId, Vec<&Polygon>> = BTreeMap::new();
    for polygon in boundary {
        polygons.entry(polygon.support()).or_default().push(polygon);
    }
    let ratio = |(plane, polygons): (PlaneId, Vec<&Polygon>)| {
        let normal = &planes.plane(plane).normal;
        let axis = (0..3).find(|&i| !normal[i].is_zero()).expect("a normal is not zero");
        let shadow = sum(polygons.into_iter().map(|polygon| polygon.doubled_shadow(axis)));
        (plane, shadow / &normal[axis])
    };
    polygons.into_iter().map(ratio).collect()
}

/// The square root of a number that is not negative, if it is whole.
fn root(square: &Int) -> Option<Int> {
    let root = square.sqrt();
    (&root * &root == *square).then_some(root)
}
