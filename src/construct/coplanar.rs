//! Polygons of points, and what polygons of one plane have in common or not.
//!
//! Everything happens within the plane: a polygon's cuts are planes, and what is beyond one of
//! them is beyond that edge. Supports may be opposed; the edges are the same.

use super::{PlaneId, PlaneSet, Polygon, Split};
use crate::geom::vector::{cross, difference};
use crate::geom::{BigPlane, RationalPoint3};
use crate::num::{Int, Rational, Sign};
use crate::predicates::{orient3d_rational, side_of_point};
use num_integer::Integer;
use num_traits::Signed;

/// Why points make no polygon.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum PolygonError {
    /// Too few.
    #[error("{0} vertices, expected three or more")]
    Few(usize),
    /// A vertex off the plane of the first three that span one.
    #[error("vertex {0} is not in the plane of the others")]
    NotPlanar(usize),
    /// A vertex that turns the wrong way, or not at all.
    #[error("the polygon is not strictly convex at vertex {0}")]
    NotConvex(usize),
}

/// The strictly convex polygon of points in order; nothing of it is rounded.
///
/// Its support is positive where the points run counter-clockwise as seen from. The cut of an edge
/// is the plane through it along the axis that the support's normal is nearest to, which keeps
/// coefficients small.
///
/// # Errors
/// [`PolygonError`] names the first vertex, counted from 0, that is out of order.
pub fn polygon_of_points(
    planes: &mut PlaneSet,
    points: &[RationalPoint3],
) -> Result<Polygon, PolygonError> {
    if points.len() < 3 {
        return Err(PolygonError::Few(points.len()));
    }
    let coordinates: Vec<_> = points.iter().map(RationalPoint3::coordinates).collect();
    let [a, b, c] = [0, 1, 2].map(|i| &coordinates[i]);
    let normal = cross(&difference(b, a), &difference(c, a));
    let support = through(planes, &normal, a).ok_or(PolygonError::NotConvex(1))?;
    let count = points.len();
    for (i, point) in points.iter().enumerate() {
        match side_of_point(planes.get(support), point) {
            // In the plane, as all must be.
            Sign::Zero => {}
            Sign::Negative | Sign::Positive => return Err(PolygonError::NotPlanar(i)),
        }
    }
    let axis = longest(&normal);
    let sign = if normal[axis].is_negative() { Int::from(-1) } else { Int::from(1) };
    let mut cuts = Vec::with_capacity(count);
    for end in 0..count {
        let start = (end + count - 1) % count;
        let d = difference(&coordinates[end], &coordinates[start]);
        let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
        // The edge's direction times the axis: outwards, as the support looks along the axis.
        let mut outward = [0; 3].map(|_| Rational::from(Int::ZERO));
        (outward[i], outward[j]) = (&d[j] * &sign, -&d[i] * &sign);
        let cut = through(planes, &outward, &coordinates[start]);
        let cut = cut.ok_or(PolygonError::NotConvex(end))?;
        for (other, point) in points.iter().enumerate().filter(|(k, _)| *k != start && *k != end) {
            match side_of_point(planes.get(cut), point) {
                Sign::Negative => {}
                // A vertex on the line of another edge is no corner.
                Sign::Zero | Sign::Positive => return Err(PolygonError::NotConvex(other)),
            }
        }
        cuts.push(cut);
    }
    Ok(Polygon::new(planes, support, &cuts))
}

/// The plane of a normal through a point, or `None` where the normal is zero.
fn through(
    planes: &mut PlaneSet,
    normal: &[Rational; 3],
    point: &[Rational; 3],
) -> Option<PlaneId> {
    let offset: Rational = normal.iter().zip(point).map(|(n, c)| n * c).sum();
    let all = || normal.iter().chain([&offset]);
    let common = all().fold(Int::from(1), |common, c| common.lcm(c.denom()));
    let whole = |c: &Rational| c.numer() * (&common / c.denom());
    planes.intern(&BigPlane { normal: normal.each_ref().map(whole), offset: whole(&offset) })
}

/// The axis along which a vector is longest, the first of equals.
fn longest(vector: &[Rational; 3]) -> usize {
    let longer = |a: usize, b: usize| if vector[b].abs() > vector[a].abs() { b } else { a };
    longer(longer(0, 1), 2)
}

/// What of `polygon` is outside of `other`, in convex pieces; whole where nothing is inside.
///
/// Requires: both lie in one plane.
pub fn minus(planes: &PlaneSet, polygon: Polygon, other: &Polygon) -> Vec<Polygon> {
    debug_assert_eq!(polygon.support().undirected(), other.support().undirected());
    let (mut outside, mut rest) = (Vec::new(), polygon.clone());
    for cut in other.cuts() {
        match rest.split(planes, cut) {
            // Nothing of it is inside: it stays in one piece.
            Split::Front => return vec![polygon],
            Split::Back => {}
            Split::On => unreachable!("a cut is not the support"),
            Split::Both(front, back) => {
                outside.push(front);
                rest = back;
            }
        }
    }
    outside
}

/// The union of two polygons that share an edge, where it is convex.
///
/// Requires: both lie in one plane, have the same support and no inner point in common.
fn union(planes: &PlaneSet, a: &Polygon, b: &Polygon) -> Option<Polygon> {
    let (points, others) = (a.points(), b.points());
    let (n, m) = (points.len(), others.len());
    let start = |i: usize, count: usize| (i + count - 1) % count;
    let shares =
        |i: usize, j: usize| points[i] == others[start(j, m)] && points[start(i, n)] == others[j];
    let (i, j) = (0..n).flat_map(|i| (0..m).map(move |j| (i, j))).find(|&(i, j)| shares(i, j))?;
    let (cuts, other_cuts): (Vec<_>, Vec<_>) = (a.cuts().collect(), b.cuts().collect());
    // Round the union: the edges of a after i, then those of b after j. At each of the two ends
    // of the common edge, the next vertex must not be beyond the last edge.
    let turn = |cut: PlaneId, next: &RationalPoint3| side_of_point(planes.get(cut), next);
    let into_b = turn(cuts[start(i, n)], &others[(j + 1) % m]);
    let into_a = turn(other_cuts[start(j, m)], &points[(i + 1) % n]);
    if into_a == Sign::Positive || into_b == Sign::Positive {
        return None;
    }
    // Where the border runs straight on (zero), two edges become one.
    let from_a = (1 + usize::from(into_a == Sign::Zero)..n).map(|k| cuts[(i + k) % n]);
    let from_b = (1 + usize::from(into_b == Sign::Zero)..m).map(|k| other_cuts[(j + k) % m]);
    let all: Vec<PlaneId> = from_a.chain(from_b).collect();
    Some(Polygon::new(planes, a.support(), &all))
}

/// Joins polygons whose union is convex until no two are left; the first in order, first.
///
/// Requires: all lie in one plane, have the same support and no inner points in common.
pub fn merged(planes: &PlaneSet, mut polygons: Vec<Polygon>) -> Vec<Polygon> {
    let mut first = 0;
    while first < polygons.len() {
        let joined = (first + 1..polygons.len())
            .find_map(|second| Some((second, union(planes, &polygons[first], &polygons[second])?)));
        match joined {
            Some((second, whole)) => {
                polygons[first] = whole;
                polygons.remove(second);
                // What is joined may now fit one that it did not fit before.
                first = 0;
            }
            None => first += 1,
        }
    }
    polygons
}

/// The convex hull of one or more polygons.
///
/// Requires: all lie in one plane and have the same support.
///
/// # Panics
/// If there are none.
pub fn hull(planes: &mut PlaneSet, polygons: &[Polygon]) -> Polygon {
    if let [only] = polygons {
        return only.clone();
    }
    let normal = planes.plane(polygons[0].support()).normal.clone().map(Rational::from);
    let axis = longest(&normal);
    let mut points: Vec<_> = polygons.iter().flat_map(Polygon::points).collect();
    points.sort_by_cached_key(|p| {
        let [x, y, z] = p.coordinates();
        [x, y, z]
    });
    points.dedup();
    let mut unit = [0; 3].map(|_| Rational::from(Int::ZERO));
    unit[axis] = Rational::from(Int::from(if normal[axis].is_negative() { -1 } else { 1 }));
    // Whether p, q, r turn to the left as seen from the support's positive side.
    let turns_left = |p: &RationalPoint3, q: &RationalPoint3, r: &RationalPoint3| {
        let base = p.coordinates();
        let above = RationalPoint3::from(&std::array::from_fn(|i| &base[i] + &unit[i]));
        // Collinear points are no corners of the hull.
        orient3d_rational(p, q, r, &above) == Sign::Positive
    };
    // Two chains between the extreme points (Andrew, Another efficient algorithm for convex hulls
    // in two dimensions, 1979). Sorted points of one plane are sorted along a line in it, or, in
    // a plane x = const, along z after y: an order of the shadow too.
    let chain = |points: &mut dyn Iterator<Item = &RationalPoint3>| {
        let mut chain: Vec<RationalPoint3> = Vec::new();
        for point in points {
            while let [.., p, q] = &chain[..]
                && !turns_left(p, q, point)
            {
                chain.pop();
            }
            chain.push(point.clone());
        }
        chain.pop();
        chain
    };
    let mut corners = chain(&mut points.iter());
    corners.extend(chain(&mut points.iter().rev()));
    polygon_of_points(planes, &corners).expect("the corners of a hull are strictly convex")
}
