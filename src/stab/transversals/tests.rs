use super::*;
use crate::geom::BigPoint3;

/// A line by two points.
type Points = [[i64; 3]; 2];

fn line([p, q]: Points) -> BigLine {
    let point = |p: [i64; 3]| BigPoint3 { coordinates: p.map(Int::from) };
    BigLine::through(&point(p), &point(q))
}

fn solve(points: &[Points]) -> Transversals {
    let lines: Vec<BigLine> = points.iter().map(|&p| line(p)).collect();
    let result = transversals(&lines);
    for isolated in &result.isolated {
        assert!(isolated.direction.iter().any(|c| !c.is_zero()));
        assert!(surd_dot(&isolated.direction, &isolated.moment).is_zero());
        for l in &lines {
            let side =
                &times(&isolated.direction, &l.moment) + &times(&isolated.moment, &l.direction);
            assert!(side.is_zero(), "{isolated:?} misses {l:?}");
        }
        check_points(isolated);
    }
    for infinite in &result.at_infinity {
        for l in &lines {
            assert!(times(&infinite.normal, &l.direction).is_zero());
        }
    }
    for family in &result.families {
        for member in members(family) {
            for l in &lines {
                assert!(member.side_product(l).is_zero(), "{family:?}: {member:?} misses {l:?}");
            }
        }
    }
    result
}

fn surd_dot(a: &[Surd; 3], b: &[Surd; 3]) -> Surd {
    (0..3).fold(Surd::from(Int::zero()), |sum, i| &sum + &(&a[i] * &b[i]))
}

fn times(a: &[Surd; 3], b: &[Int; 3]) -> Surd {
    surd_dot(a, &b.clone().map(Surd::from))
}

/// The two points span the line.
fn check_points(isolated: &IsolatedLine) {
    let [p, q] = isolated.points();
    assert_ne!(p, q);
    for x in [&p, &q] {
        for (i, j) in [(0, 1), (1, 2), (2, 0)] {
            let k = 3 - i - j;
            let moment = &(&x[i] * &isolated.direction[j]) - &(&x[j] * &isolated.direction[i]);
            assert_eq!(moment, isolated.moment[k]);
        }
    }
}

/// Some lines of a family, enough to tell it from a smaller one.
fn members(family: &Family) -> Vec<BigLine> {
    let axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 2, 3]].map(|d| d.map(Int::from));
    let through = |center: &ProjectivePoint, direction: &[Int; 3]| {
        let moment = cross(&center.position, direction);
        let direction = direction.clone().map(|c| c * &center.weight);
        BigLine { direction, moment }
    };
    match family {
        Family::Pencil { center, plane } => {
            assert_eq!(dot(&plane.normal, &center.position), &plane.offset * &center.weight);
            axes.iter().map(|v| through(center, &cross(&plane.normal, v))).collect()
        }
        Family::Regulus { lines, .. } => {
            for (i, j) in [(0, 1), (1, 2), (2, 0)] {
                assert!(!lines[i].side_product(&lines[j]).is_zero());
            }
            lines.to_vec()
        }
        Family::Bundle { center } => axes.iter().map(|d| through(center, d)).collect(),
        Family::PlaneField { plane } => {
            let cuts = axes.map(|normal| ProjectivePlane { normal, offset: Int::from(5) });
            cuts.iter().map(|cut| meet_of_planes(plane, cut)).collect()
        }
        Family::Congruence { axes: lines } => {
            let [a, b] = lines.as_ref();
            let far = axes.map(|p| ProjectivePoint { position: p, weight: Int::from(7) });
            let planes = |l: &BigLine, p| join(l, p);
            far.iter()
                .filter_map(|p| Some(meet_of_planes(&planes(a, p)?, &planes(b, p)?)))
                .collect()
        }
        Family::Complex { axis } => {
            let far = axes.map(|p| ProjectivePoint { position: p, weight: Int::from(7) });
            let plane = |p: &ProjectivePoint| join(axis, p);
            let cut = ProjectivePlane { normal: [3, 1, 4].map(Int::from), offset: Int::one() };
            far.iter().filter_map(plane).map(|p| meet_of_planes(&p, &cut)).collect()
        }
    }
}

/// Kinds in short: isolated lines, lines at infinity, names of families.
fn summary(result: &Transversals) -> (usize, usize, usize, Vec<&'static str>) {
    let name = |family: &Family| match family {
        Family::Pencil { .. } => "pencil",
        Family::Regulus { paraboloid: false, .. } => "hyperboloid",
        Family::Regulus { paraboloid: true, .. } => "paraboloid",
        Family::Bundle { .. } => "bundle",
        Family::PlaneField { .. } => "plane",
        Family::Congruence { .. } => "congruence",
        Family::Complex { .. } => "complex",
    };
    let families = result.families.iter().map(name).collect();
    (result.rank, result.isolated.len(), result.at_infinity.len(), families)
}

const X: Points = [[0, 0, 0], [1, 0, 0]];
const Y: Points = [[0, 0, 0], [0, 1, 0]];
const Z: Points = [[0, 0, 0], [0, 0, 1]];

#[test]
fn four_lines_in_general_position_have_none_or_two() {
    // The surface of the first three is x·y = z.
    let ruled = [X, [[0, 1, 0], [1, 1, 1]], [[0, 2, 0], [1, 2, 2]]];
    let two = solve(&[ruled[0], ruled[1], ruled[2], [[0, 0, 2], [1, 1, 2]]]);
    assert_eq!(summary(&two), (4, 2, 0, vec![]));
    assert_eq!(two.isolated[0].points()[1][2].radicand(), &Int::from(2));
    let none = solve(&[ruled[0], ruled[1], ruled[2], [[0, 0, -2], [1, 1, -2]]]);
    assert_eq!(summary(&none), (4, 0, 0, vec![]));
}

#[test]
fn a_tangent_line_is_one_double_root() {
    // The surface of the first three is x·y = z; the fourth touches it at the origin.
    let ruled = [X, [[0, 1, 0], [1, 1, 1]], [[0, 2, 0], [1, 2, 2]]];
    let one = solve(&[ruled[0], ruled[1], ruled[2], [[0, 0, 0], [1, 1, 0]]]);
    assert_eq!(summary(&one), (4, 1, 0, vec![]));
    assert_eq!(one.isolated[0].multiplicity, 2);
}

#[test]
fn lines_at_infinity_are_kept_apart() {
    // x·y = z is cut by a line along z once, and once at infinity.
    let ruled = [X, [[0, 1, 0], [1, 1, 1]], [[0, 2, 0], [1, 2, 2]]];
    let one = solve(&[ruled[0], ruled[1], ruled[2], [[3, 4, 0], [3, 4, 1]]]);
    assert_eq!(summary(&one), (4, 1, 1, vec![]));
    assert_eq!((one.isolated[0].multiplicity, one.at_infinity[0].multiplicity), (1, 1));
    // Four lines parallel to one plane: the plane's line at infinity meets them all.
    let flat = [X, [[0, 0, 1], [0, 1, 1]], [[0, 0, 2], [1, 1, 2]], [[0, 0, 3], [1, -1, 3]]];
    let infinite = solve(&flat);
    assert_eq!(infinite.rank, 4);
    assert_eq!(infinite.at_infinity.len(), 1);
}

#[test]
fn a_regulus_may_lie_on_either_surface() {
    let ruled = [X, [[0, 1, 0], [1, 1, 1]], [[0, 2, 0], [1, 2, 2]], [[0, 5, 0], [1, 5, 5]]];
    assert_eq!(summary(&solve(&ruled)), (3, 0, 0, vec!["paraboloid"]));
    // x² + y² - z² = 1, at (1,0), (0,1), (-1,0), (0,-1).
    let round = [
        [[1, 0, 0], [1, 1, 1]],
        [[0, 1, 0], [-1, 1, 1]],
        [[-1, 0, 0], [-1, -1, 1]],
        [[0, -1, 0], [1, -1, 1]],
    ];
    assert_eq!(summary(&solve(&round)), (3, 0, 0, vec!["hyperboloid"]));
}

#[test]
fn concurrent_and_coplanar_lines_give_pencils() {
    let far = [[3, 4, 5], [4, 4, 6]];
    // Three through one point, the fourth anywhere: a pencil in the plane of point and line.
    assert_eq!(summary(&solve(&[X, Y, Z, far])), (4, 0, 0, vec!["pencil"]));
    // Three in a plane, the fourth cuts it.
    let cross = [[0, 3, 0], [4, 0, 0]];
    assert_eq!(summary(&solve(&[X, Y, cross, far])), (4, 0, 0, vec!["pencil"]));
    // Two coplanar, the others meet their plane in one point.
    let up = [[[2, 5, 0], [3, 5, 1]], [[2, 5, 0], [2, 7, 3]]];
    assert_eq!(summary(&solve(&[X, Y, up[0], up[1]])), (4, 0, 0, vec!["pencil"]));
}

#[test]
fn two_pencils_share_a_line() {
    // Three lines of one pencil, and one that meets their plane elsewhere.
    let dependent = solve(&[X, Y, [[0, 0, 0], [1, 1, 0]], [[5, 1, 2], [6, 1, 3]]]);
    assert_eq!(summary(&dependent), (3, 0, 0, vec!["pencil", "pencil"]));
    // Parallel lines in place of concurrent ones, met at infinity.
    let parallel =
        solve(&[X, [[0, 1, 0], [1, 1, 0]], [[0, 2, 0], [1, 2, 0]], [[1, 1, 1], [2, 3, 4]]]);
    assert_eq!(summary(&parallel), (3, 0, 0, vec!["pencil", "pencil"]));
}

#[test]
fn two_parameter_families_are_told_apart() {
    let through = [[0, 0, 0], [1, 1, 1]];
    assert_eq!(summary(&solve(&[X, Y, Z, through])), (3, 0, 0, vec!["bundle"]));
    let flat = [[[0, 3, 0], [4, 0, 0]], [[0, 7, 0], [4, 0, 0]]];
    assert_eq!(summary(&solve(&[X, Y, flat[0], flat[1]])), (3, 0, 0, vec!["plane"]));
    let parallel = [
        [[0, 0, 0], [0, 0, 1]],
        [[1, 0, 0], [1, 0, 1]],
        [[0, 1, 0], [0, 1, 1]],
        [[5, 7, 0], [5, 7, 1]],
    ];
    let result = solve(&parallel);
    assert_eq!(summary(&result), (3, 0, 0, vec!["bundle"]));
    let [Family::Bundle { center }] = result.families.as_slice() else { panic!("a bundle") };
    assert!(center.weight.is_zero());
    let skew = [X, [[0, 1, 1], [0, 2, 1]]];
    assert_eq!(
        summary(&solve(&[skew[0], skew[1], skew[0], skew[1]])),
        (2, 0, 0, vec!["congruence"])
    );
    assert_eq!(summary(&solve(&[X, Y, Y, X])), (2, 0, 0, vec!["bundle", "plane"]));
    assert_eq!(summary(&solve(&[X, X, X, X])), (1, 0, 0, vec!["complex"]));
}

#[test]
fn pencils_carry_their_point_and_plane() {
    let result = solve(&[X, Y, Z, [[3, 4, 5], [4, 4, 6]]]);
    let [Family::Pencil { center, plane }] = result.families.as_slice() else { panic!("a pencil") };
    assert_eq!((&center.position, &center.weight), (&[0, 0, 0].map(Int::from), &Int::one()));
    assert!(dot(&plane.normal, &[3, 4, 5].map(Int::from)).is_zero());
    assert!(dot(&plane.normal, &[4, 4, 6].map(Int::from)).is_zero());
}

/// On a tiny grid everything happens; each answer is checked against the lines by `solve`, and a
/// motion of space must not change its kind.
#[test]
fn all_small_configurations_are_answered() {
    let mut state = 1u64;
    let mut next = |n: u64| {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        ((state >> 33) % n) as i64
    };
    let mut kinds = std::collections::BTreeSet::new();
    for _ in 0..2_000 {
        let mut lines = Vec::new();
        while lines.len() < 4 {
            let p: Points = [(); 2].map(|()| [(); 3].map(|()| next(3) - 1));
            if p[0] != p[1] {
                lines.push(p);
            }
        }
        let result = solve(&lines);
        let kind = summary(&result);
        let moved: Vec<Points> = lines
            .iter()
            .map(|l| l.map(|[x, y, z]| [x + 2 * y - 3, y - z + 5, z + x + 2 * y]))
            .collect();
        assert_eq!(summary(&solve(&moved)), kind, "{lines:?}");
        kinds.insert(kind);
    }
    assert!(kinds.len() >= 9, "{kinds:?}");
}
