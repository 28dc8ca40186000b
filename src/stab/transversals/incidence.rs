//! Joins and meets of points, lines and planes in projective space, and pencils of lines.
//!
//! Points (x, w) and planes (n, c) with n·x = c·w are four integers up to a factor; w = 0 is a
//! point at infinity, n = 0 the plane at infinity. The formulas hold for lines at infinity too.

use crate::geom::BigLine;
use crate::geom::vector::{cross, dot};
use crate::num::Int;
use num_integer::Integer;
use num_traits::{Signed, Zero};

/// A point of projective space: `position / weight`, or the direction `position` where the weight
/// is zero. In lowest terms; the weight is not negative, and the first coordinate of a direction
/// that is not zero is positive.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ProjectivePoint {
    /// Coordinates, times the weight.
    pub position: [Int; 3],
    /// Zero for a point at infinity.
    pub weight: Int,
}

/// A plane: the points x with `normal · x = offset`; the plane at infinity where the normal is
/// zero. In lowest terms, the first number that is not zero positive.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ProjectivePlane {
    /// The normal.
    pub normal: [Int; 3],
    /// The offset along the normal.
    pub offset: Int,
}

/// The plane through a line and a point; `None` if the point lies on the line.
pub(super) fn join(line: &BigLine, point: &ProjectivePoint) -> Option<ProjectivePlane> {
    let turned = cross(&line.direction, &point.position);
    let normal = [0, 1, 2].map(|i| &turned[i] + &line.moment[i] * &point.weight);
    let [x, y, z, offset] = normalized(normal, dot(&line.moment, &point.position), false)?;
    Some(ProjectivePlane { normal: [x, y, z], offset })
}

/// The point in which a line and a plane meet; `None` if the line lies in the plane.
pub(super) fn meet(line: &BigLine, plane: &ProjectivePlane) -> Option<ProjectivePoint> {
    let turned = cross(&plane.normal, &line.moment);
    let position = [0, 1, 2].map(|i| &turned[i] + &line.direction[i] * &plane.offset);
    let [x, y, z, weight] = normalized(position, dot(&plane.normal, &line.direction), true)?;
    Some(ProjectivePoint { position: [x, y, z], weight })
}

/// The line in which two distinct planes meet.
pub(super) fn meet_of_planes(a: &ProjectivePlane, b: &ProjectivePlane) -> BigLine {
    let direction = cross(&a.normal, &b.normal);
    let moment = [0, 1, 2].map(|i| &a.normal[i] * &b.offset - &b.normal[i] * &a.offset);
    BigLine { direction, moment }.primitive()
}

/// The common point and the common plane of two distinct coplanar lines.
///
/// # Panics
/// If the lines are one line or skew.
pub(super) fn pencil_of(a: &BigLine, b: &BigLine) -> (ProjectivePoint, ProjectivePlane) {
    assert!(a.side_product(b).is_zero(), "{a:?} and {b:?} are skew");
    // Some coordinate plane misses b in a point off a, and some coordinate point spans with b a
    // plane that does not contain a: otherwise the lines were one.
    let frame = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]].map(|v| v.map(Int::from));
    let plane = frame.iter().find_map(|[x, y, z, w]| {
        let cut = ProjectivePlane { normal: [x.clone(), y.clone(), z.clone()], offset: w.clone() };
        join(a, &meet(b, &cut)?)
    });
    let point = frame.iter().find_map(|[x, y, z, w]| {
        let eye =
            ProjectivePoint { position: [x.clone(), y.clone(), z.clone()], weight: w.clone() };
        meet(a, &join(b, &eye)?)
    });
    let (Some(point), Some(plane)) = (point, plane) else { panic!("{a:?} and {b:?} are one line") };
    (point, plane)
}

/// Four numbers in lowest terms with their sign fixed: by the last one where `last_first` says so
/// and it is not zero, else by the first that is not zero. `None` if all are zero.
fn normalized([x, y, z]: [Int; 3], w: Int, last_first: bool) -> Option<[Int; 4]> {
    let all = [x, y, z, w];
    let divisor = all.iter().fold(Int::zero(), |g, c| g.gcd(c));
    let leading = match &all[3] {
        w if last_first && !w.is_zero() => w,
        _ => all.iter().find(|c| !c.is_zero())?,
    };
    let divisor = if leading.is_negative() { -divisor } else { divisor };
    Some(all.map(|c| c / &divisor))
}
