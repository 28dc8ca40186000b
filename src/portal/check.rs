//! The laws of portals, checked on demand against the leaves and the occluders themselves.

use super::Portal;
use crate::construct::{PlaneId, PlaneSet, Polygon, polygon_of_points};
use crate::geom::RationalPoint3;
use crate::num::Sign;
use crate::predicates::side_of_point;
use crate::subdivision::{LeafId, Occluders, Subdivision};

/// What a portal must not do: an error of this program.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum PortalViolation {
    /// It is no part of a face of one of its leaves that looks to the other.
    #[error("portal {portal} is not in the boundary of {leaf:?}")]
    NotShared {
        /// The portal, by index.
        portal: usize,
        /// The leaf.
        leaf: LeafId,
    },
    /// It runs through a solid.
    #[error("portal {portal} runs through solid {solid}")]
    InSolid {
        /// The portal, by index.
        portal: usize,
        /// The solid, by index.
        solid: usize,
    },
    /// A polygon covers a part of it.
    #[error("polygon {polygon} covers a part of portal {portal}")]
    Covered {
        /// The portal, by index.
        portal: usize,
        /// The polygon, by index.
        polygon: usize,
    },
    /// Two of one pair of leaves overlap.
    #[error("portals {first} and {second} overlap")]
    Overlap {
        /// The first, by index.
        first: usize,
        /// The second.
        second: usize,
    },
}

/// Checks that each portal lies in the boundary of both its leaves, with supports opposed and the
/// leaves on their sides of it; that none has a point inside a solid, an inner point in a polygon
/// that is in its plane, or an inner point of another portal of its pair of leaves.
///
/// Hulls may be covered by polygons and are not held against them (`hulls`).
///
/// Cost: each portal against all occluders.
///
/// # Errors
/// The first law that does not hold.
pub fn check(
    subdivision: &Subdivision,
    portals: &[Portal],
    occluders: &Occluders,
    hulls: bool,
) -> Result<(), PortalViolation> {
    let mut planes = subdivision.planes.clone();
    let solids: Vec<(usize, Vec<PlaneId>)> = (occluders.solids.iter().enumerate())
        .filter(|(index, _)| !subdivision.flat.contains(index))
        .filter_map(|(index, solid)| Some((index, planes.intern_all(solid).ok()?)))
        .collect();
    let polygons: Vec<Option<Polygon>> = (occluders.polygons.iter())
        .map(|corners| polygon_of_points(&mut planes, corners).ok())
        .collect();
    for (number, portal) in portals.iter().enumerate() {
        let Portal { from, to, polygon } = portal;
        let points = polygon.points();
        let support = polygon.support();
        for (leaf, outward) in [(*from, support), (*to, support.flipped())] {
            if !is_in_face(subdivision, leaf, outward, &points) {
                return Err(PortalViolation::NotShared { portal: number, leaf });
            }
        }
        if let Some((solid, _)) = solids.iter().find(|(_, sides)| enters(&planes, polygon, sides)) {
            return Err(PortalViolation::InSolid { portal: number, solid: *solid });
        }
        let covers = |other: &Option<Polygon>| {
            other.as_ref().is_some_and(|other| overlap(&planes, polygon, other))
        };
        if let (false, Some(polygon)) = (hulls, polygons.iter().position(covers)) {
            return Err(PortalViolation::Covered { portal: number, polygon });
        }
        let before = portals[..number].iter().enumerate().rev();
        for (first, other) in before.take_while(|(_, p)| (p.from, p.to) == (*from, *to)) {
            if overlap(&planes, polygon, &other.polygon) {
                return Err(PortalViolation::Overlap { first, second: number });
            }
        }
    }
    Ok(())
}

/// Whether all points lie in the face of a leaf's cell that has this plane.
fn is_in_face(
    subdivision: &Subdivision,
    leaf: LeafId,
    outward: PlaneId,
    points: &[RationalPoint3],
) -> bool {
    let faces = subdivision.leaf(leaf).cell.faces();
    let beyond = |plane, point: &RationalPoint3| {
        match side_of_point(subdivision.planes.get(plane), point) {
            Sign::Positive => true,
            // In the boundary of the closed cell.
            Sign::Zero | Sign::Negative => false,
        }
    };
    faces.iter().any(|face| face.support() == outward)
        && faces.iter().all(|face| !points.iter().any(|point| beyond(face.support(), point)))
}

/// Whether a polygon has points strictly on the negative side of all planes.
fn enters(planes: &PlaneSet, polygon: &Polygon, sides: &[PlaneId]) -> bool {
    // What is behind a plane, or in it, is outside as a whole.
    sides.iter().all(|side| polygon.extent(planes, *side).back)
        && sides.iter().try_fold(polygon.clone(), |p, s| p.inside(planes, *s)).is_some()
}

/// Whether two polygons lie in one plane and have an inner point in common.
fn overlap(planes: &PlaneSet, a: &Polygon, b: &Polygon) -> bool {
    a.support().undirected() == b.support().undirected()
        && b.cuts().all(|cut| a.extent(planes, cut).back)
        && b.cuts().try_fold(a.clone(), |rest, cut| rest.inside(planes, cut)).is_some()
}
