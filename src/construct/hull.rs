//! The convex hull of points, as planes.

use crate::geom::vector::{cross, dot};
use crate::geom::{BigPlane, BigPoint3, RationalPoint3};
use crate::num::{Int, Sign};
use num_integer::Integer;
use num_traits::Zero;

/// A face in the making: its plane, and the points in it of those added, ascending.
struct Face {
    plane: BigPlane,
    points: Vec<usize>,
}

/// The planes of the faces of the convex hull, outward, their coefficients without a common
/// factor; `None` where all points lie in one plane.
///
/// Points are added one after another: faces that see the new point go, and each edge between one
/// of these and one that does not see it spans a new face with the point (the double description
/// method in its polar form: Motzkin, Raiffa, Thompson and Thrall 1953). A face holds all points
/// in its plane, so that points in faces, on edges and repeated ones need no case of their own:
/// two faces share an edge iff they share two points. With n points and f faces at most on the
/// way, O(n f) signs and O(n f²) comparisons of faces.
pub fn hull(points: &[RationalPoint3]) -> Option<Vec<BigPlane>> {
    let grid = RationalPoint3::common_denominator(points);
    let mut scaled: Vec<BigPoint3> = points.iter().map(|point| point.on_grid(&grid)).collect();
    scaled.sort_unstable();
    scaled.dedup();
    let first = tetrahedron(&scaled)?;
    let mut faces: Vec<Face> = (0..4).map(|apex| start(&scaled, first, apex)).collect();
    for new in (0..scaled.len()).filter(|new| !first.contains(new)) {
        add(&mut faces, &scaled, new);
    }
    let in_world_units = |face: Face| {
        let normal = face.plane.normal.map(|c| c * &grid);
        primitive(BigPlane { normal, offset: face.plane.offset })
    };
    Some(faces.into_iter().map(in_world_units).collect())
}

/// Four points that are not in one plane.
fn tetrahedron(points: &[BigPoint3]) -> Option<[usize; 4]> {
    let from_first = |i: usize| -> [Int; 3] {
        std::array::from_fn(|axis| &points[i].coordinates[axis] - &points[0].coordinates[axis])
    };
    let second = from_first(1.min(points.len().checked_sub(1)?));
    let is_zero = |vector: &[Int; 3]| vector.iter().all(Zero::is_zero);
    let third = (2..points.len()).find(|&i| !is_zero(&cross(&second, &from_first(i))))?;
    let normal = cross(&second, &from_first(third));
    let fourth = (2..points.len()).find(|&i| !dot(&normal, &from_first(i)).is_zero())?;
    Some([0, 1, third, fourth])
}

/// The face of a tetrahedron that is opposite to one of its corners.
fn start(points: &[BigPoint3], corners: [usize; 4], apex: usize) -> Face {
    let mut held: Vec<usize> = (0..4).filter(|&i| i != apex).map(|i| corners[i]).collect();
    held.sort_unstable();
    let plane = BigPlane::through(&points[held[0]], &points[held[1]], &points[held[2]]);
    let plane = match Sign::of(&height(&plane, &points[corners[apex]])) {
        Sign::Negative => plane,
        Sign::Zero => unreachable!("the four points are not in one plane"),
        Sign::Positive => BigPlane { normal: plane.normal.map(|c| -c), offset: -plane.offset },
    };
    Face { plane: primitive(plane), points: held }
}

/// Positive in front of the plane, in proportion to the distance.
fn height(plane: &BigPlane, point: &BigPoint3) -> Int {
    dot(&plane.normal, &point.coordinates) - &plane.offset
}

fn primitive(plane: BigPlane) -> BigPlane {
    let divisor = plane.normal.iter().fold(plane.offset.clone(), |divisor, c| divisor.gcd(c));
    BigPlane { normal: plane.normal.map(|c| c / &divisor), offset: plane.offset / &divisor }
}

fn add(faces: &mut Vec<Face>, points: &[BigPoint3], new: usize) {
    let (mut kept, mut seeing) = (Vec::with_capacity(faces.len() + 2), Vec::new());
    for mut face in faces.drain(..) {
        let height = height(&face.plane, &points[new]);
        match Sign::of(&height) {
            Sign::Negative => kept.push((height, face)),
            Sign::Zero => {
                face.points.push(new);
                face.points.sort_unstable();
                kept.push((height, face));
            }
            Sign::Positive => seeing.push((height, face)),
        }
    }
    for (above, front) in &seeing {
        for (below, back) in kept.iter().filter(|(below, _)| !below.is_zero()) {
            let shared = front.points.iter().filter(|i| back.points.binary_search(i).is_ok());
            let mut points: Vec<usize> = shared.copied().collect();
            if points.len() < 2 {
                continue;
            }
            points.push(new);
            points.sort_unstable();
            // The sum through the new point, with positive weights.
            let sum = |f: &Int, b: &Int| b * above - f * below;
            let (f, b) = (&front.plane, &back.plane);
            let normal = std::array::from_fn(|i| sum(&f.normal[i], &b.normal[i]));
            let plane = primitive(BigPlane { normal, offset: sum(&f.offset, &b.offset) });
            faces.push(Face { plane, points });
        }
    }
    faces.extend(kept.into_iter().map(|(_, face)| face));
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn points(all: &[[i64; 3]], denominator: i64) -> Vec<RationalPoint3> {
        let point = |p: &[i64; 3]| RationalPoint3::new(p.map(Int::from), Int::from(denominator));
        all.iter().map(point).collect()
    }

    fn planes(all: &[[i64; 3]], denominator: i64) -> Option<Vec<([i64; 3], i64)>> {
        let number = |c: &Int| i64::try_from(c).unwrap();
        let plane = |p: &BigPlane| (p.normal.each_ref().map(number), number(&p.offset));
        let mut found: Vec<_> = hull(&points(all, denominator))?.iter().map(plane).collect();
        found.sort_unstable();
        Some(found)
    }

    /// By the definition: planes through three points with no point in front.
    fn twin(all: &[[i64; 3]]) -> Vec<([i64; 3], i64)> {
        let mut found = Vec::new();
        let big = points(all, 1).iter().map(|p| p.on_grid(&Int::from(1))).collect::<Vec<_>>();
        for a in &big {
            for b in &big {
                for c in &big {
                    let plane = BigPlane::through(a, b, c);
                    if plane.normal.iter().all(Zero::is_zero) {
                        continue;
                    }
                    let number = |c: &Int| i64::try_from(c).unwrap();
                    let plane = primitive(plane);
                    let heights: Vec<Int> = big.iter().map(|p| height(&plane, p)).collect();
                    if heights.iter().all(|h| *h <= Int::ZERO) {
                        found.push((plane.normal.each_ref().map(number), number(&plane.offset)));
                    }
                }
            }
        }
        found.sort_unstable();
        found.dedup();
        found
    }

    #[test]
    fn a_box_with_points_everywhere_has_six_planes() {
        let grid = |n: i64| (0..n * n * n).map(move |i| [i % n, i / n % n, i / n / n]);
        let expected = vec![
            ([-1, 0, 0], 0),
            ([0, -1, 0], 0),
            ([0, 0, -1], 0),
            ([0, 0, 1], 1),
            ([0, 1, 0], 1),
            ([1, 0, 0], 1),
        ];
        assert_eq!(planes(&grid(3).collect::<Vec<_>>(), 2), Some(expected.clone()));
        assert_eq!(planes(&grid(2).chain(grid(2)).collect::<Vec<_>>(), 1), Some(expected));
    }

    #[test]
    fn flat_sets_have_no_hull() {
        for flat in [
            &[][..],
            &[[1, 2, 3]],
            &[[1, 2, 3], [1, 2, 3]],
            &[[0, 0, 0], [1, 1, 1], [2, 2, 2], [5, 5, 5]],
            &[[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [7, 5, 0]],
        ] {
            assert_eq!(planes(flat, 1), None, "{flat:?}");
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

        /// On a small grid, where many points share planes and lines.
        #[test]
        fn the_twin_finds_the_same_planes(
            all in prop::collection::vec(prop::array::uniform3(-2i64..3), 0..14),
        ) {
            // A flat set has its plane in both directions, and perhaps none.
            if let Some(found) = planes(&all, 1) {
                prop_assert_eq!(found, twin(&all));
            } else {
                prop_assert!(twin(&all).len() <= 2);
            }
        }
    }
}
