//! The planes of one brush: from three points each to those that bound it.
//!
//! Any two planes that cross share a line, and the other half-spaces leave an interval of it. An
//! interval of positive length is (part of) an edge of the brush. A plane holds a face iff two
//! edges on it are not parallel; the brush has volume iff four planes hold faces (if all of it lay
//! in one plane, only that plane's two sides could). It is open iff an interval has no end or no
//! two planes cross. These are the facts on supporting planes of polyhedra in Grünbaum, Convex
//! Polytopes, 1967, chapter 2.
//!
//! Ends of intervals are meets of three planes, and every decision is the side of such a meet
//! against a fourth plane: nothing is rounded. Cubic in the number of faces of the brush at worst;
//! most lines are left by their first few planes.

use super::{BrushFace, LevelWarningKind, NoSolid};
use crate::formats::map::MapBrush;
use crate::geom::vector::{cross, dot};
use crate::geom::{BigPlane, BigPoint3};
use crate::num::{Int, Number, Rational, Sign};
use crate::predicates::{Vertex, VertexPlane, side_of_vertex};
use num_integer::Integer;
use num_traits::{One, Zero};
use rustc_hash::FxHashMap;

/// The faces that bound the brush; `None` where they enclose no solid. What is left out on the way
/// is told to `warn`, with its line.
pub(super) fn faces(
    brush: &MapBrush,
    splits: &[bool],
    warn: &mut impl FnMut(usize, LevelWarningKind),
) -> Option<Vec<BrushFace>> {
    let faces = distinct_faces(brush, splits, warn);
    let planes: Vec<&BigPlane> = faces.iter().map(|(_, face)| &face.plane).collect();
    let holds_face = match bounding(&planes) {
        Ok(holds_face) => holds_face,
        Err(reason) => {
            warn(brush.line, LevelWarningKind::NoSolid(reason));
            return None;
        }
    };
    let mut kept = Vec::with_capacity(faces.len());
    for ((number, face), holds_face) in faces.into_iter().zip(holds_face) {
        if holds_face {
            kept.push(face);
        } else {
            warn(face.line, LevelWarningKind::CutAway { face: number });
        }
    }
    Some(kept)
}

/// The faces with a plane of their own, each with its number in the file.
fn distinct_faces(
    brush: &MapBrush,
    splits: &[bool],
    warn: &mut impl FnMut(usize, LevelWarningKind),
) -> Vec<(usize, BrushFace)> {
    let mut faces: Vec<(usize, BrushFace)> = Vec::with_capacity(brush.faces.len());
    let mut places: FxHashMap<BigPlane, usize> = FxHashMap::default();
    for (number, (face, &splits)) in brush.faces.iter().zip(splits).enumerate() {
        let line = face.line;
        let Some(plane) = outward_plane(&face.points) else {
            warn(line, LevelWarningKind::CollinearPoints { face: number });
            continue;
        };
        if let Some(&place) = places.get(&plane) {
            let (first, kept) = &mut faces[place];
            kept.splits |= splits;
            warn(line, LevelWarningKind::SamePlane { face: number, first: *first });
            continue;
        }
        places.insert(plane.clone(), faces.len());
        faces.push((number, BrushFace { plane, splits, line }));
    }
    faces
}

/// The plane of three points with the least integer coefficients, its normal on the side from which
/// they run clockwise; `None` where they are on one line.
pub(in crate::scene) fn outward_plane(points: &[[Number; 3]; 3]) -> Option<BigPlane> {
    let points = points.each_ref().map(|point| point.each_ref().map(|c| c.to_rational()));
    let common = points.as_flattened().iter().fold(Int::one(), |common, c| common.lcm(c.denom()));
    let scale = |c: Rational| c.numer() * (&common / c.denom());
    let [a, b, c] = points.map(|point| BigPoint3 { coordinates: point.map(scale) });
    // Counter-clockwise is seen from the positive side.
    let BigPlane { normal, offset } = BigPlane::through(&a, &c, &b);
    if normal.iter().all(Zero::is_zero) {
        return None;
    }
    // n·(common x) = offset in world units.
    let normal = normal.map(|n| n * &common);
    let divisor = normal.iter().fold(offset.clone(), |divisor, n| divisor.gcd(n));
    Some(BigPlane { normal: normal.map(|n| n / &divisor), offset: offset / &divisor })
}

/// Which of the half-spaces' planes hold a face of what they enclose.
///
/// Requires: the planes are distinct, their coefficients without a common factor.
pub(in crate::scene) fn bounding(planes: &[&BigPlane]) -> Result<Vec<bool>, NoSolid> {
    if planes.len() < 4 {
        return Err(NoSolid::TooFewPlanes(planes.len()));
    }
    // For each plane another one through an edge on it, and whether a second edge turns off.
    let mut edges: Vec<Option<usize>> = vec![None; planes.len()];
    let mut holds_face = vec![false; planes.len()];
    let mut crossing = false;
    let sides: Vec<VertexPlane> = planes.iter().map(|p| VertexPlane::new((*p).clone())).collect();
    for i in 0..planes.len() {
        for j in i + 1..planes.len() {
            let direction = cross(&planes[i].normal, &planes[j].normal);
            if direction.iter().all(Zero::is_zero) {
                continue;
            }
            crossing = true;
            match interval(planes, &sides, [i, j], &direction) {
                Interval::Point | Interval::Empty => {}
                Interval::Endless => return Err(NoSolid::Open),
                Interval::Edge => {
                    for (this, other) in [(i, j), (j, i)] {
                        let first = *edges[this].get_or_insert(other);
                        // Parallel edges have directions, hence normals, in one plane.
                        holds_face[this] |= along(&direction, planes[first]) != Sign::Zero;
                    }
                }
            }
        }
    }
    if !crossing {
        return Err(NoSolid::Open);
    }
    if holds_face.iter().filter(|holds| **holds).count() < 4 {
        return Err(NoSolid::NoVolume);
    }
    Ok(holds_face)
}

/// What the other half-spaces leave of the line in which two planes meet.
enum Interval {
    Empty,
    Point,
    Edge,
    /// A half-line, or the whole line.
    Endless,
}

/// What is left of the line of `planes[i]` and `planes[j]`, which runs in `direction`.
fn interval(
    planes: &[&BigPlane],
    sides: &[VertexPlane],
    [i, j]: [usize; 2],
    direction: &[Int; 3],
) -> Interval {
    let (mut low, mut high): (Option<usize>, Option<usize>) = (None, None);
    let side = |end: usize, k: usize| {
        let vertex = Vertex::meet([&sides[i], &sides[j], &sides[end]]);
        let vertex =
            vertex.unwrap_or_else(|| unreachable!("an end is where a plane crosses the line"));
        side_of_vertex(&sides[k], &vertex)
    };
    let mut parallel = Vec::new();
    for k in (0..planes.len()).filter(|&k| k != i && k != j) {
        let end = match along(direction, planes[k]) {
            Sign::Negative => &mut low,
            // The plane is parallel to the line, which is on one side of it, or in it.
            Sign::Zero => {
                parallel.push(k);
                continue;
            }
            Sign::Positive => &mut high,
        };
        match end.map(|end| side(end, k)) {
            // The end so far is outside the half-space, which therefore ends the interval earlier.
            None | Some(Sign::Positive) => *end = Some(k),
            // It is inside, or both planes end the interval in one point.
            Some(Sign::Negative | Sign::Zero) => continue,
        }
        if let (Some(low), Some(high)) = (low, high)
            && side(low, high) == Sign::Positive
        {
            return Interval::Empty;
        }
    }
    let outside = |end: usize| parallel.iter().any(|&k| side(end, k) == Sign::Positive);
    match (low, high) {
        (Some(end), _) | (_, Some(end)) if outside(end) => Interval::Empty,
        (Some(low), Some(high)) => match side(low, high) {
            Sign::Negative => Interval::Edge,
            // Both ends are one point, a corner of the brush or its only point.
            Sign::Zero => Interval::Point,
            Sign::Positive => Interval::Empty,
        },
        // Without any end all planes are along one line, so that nothing is closed.
        (None, _) | (_, None) => Interval::Endless,
    }
}

/// Whether one leaves (positive) or enters (negative) the plane's half-space along `direction`;
/// zero: neither, the plane is parallel to it.
fn along(direction: &[Int; 3], plane: &BigPlane) -> Sign {
    Sign::of(&dot(direction, &plane.normal))
}
