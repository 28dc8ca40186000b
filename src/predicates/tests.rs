//! Every stage against the next, the laws, and the ranges at their extremes.

use super::budget::{
    COMPARE_ALONG_LINE, COMPARE_CROSSINGS, ORIENT2D, ORIENT3D, RANGES, Range, SIDE_OF_LINES,
    SIDE_OF_MEETS, SIDE_OF_PLANE,
};
use super::ring::{cross, determinant, difference, dot};
use super::*;
use crate::geom::{
    BigLine, BigPlane, BigPoint2, BigPoint3, Line, Plane, Point2, Point3, RationalPoint3,
};
use crate::num::{Int, Sign};
use num_traits::Signed;
use proptest::prelude::*;

mod ranges;

/// Repeatable numbers from a seed (Steele, Lea and Flood, SplitMix, 2014).
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn within(&mut self, low: i64, high: i64) -> i64 {
        low + (self.next() % (high - low + 1) as u64) as i64
    }
}

/// How a test's points lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Family {
    /// Anywhere in the box.
    Anywhere,
    /// On five planes per axis: many determinants vanish.
    Aligned,
    /// Each a small combination of the first three, but for one unit.
    NearlyCoplanar,
    /// On the corners, edges and faces of the box.
    Extreme,
}

const FAMILIES: [Family; 4] =
    [Family::Anywhere, Family::Aligned, Family::NearlyCoplanar, Family::Extreme];

/// Grids around every change of stage or width, and the usual ones between.
const GRIDS: [u32; 18] = [3, 10, 16, 17, 19, 20, 24, 25, 26, 29, 30, 31, 33, 34, 35, 36, 39, 40];

fn points<const N: usize>(family: Family, bits: u32, random: &mut Random) -> [Point3; N] {
    let c = 1i64 << bits;
    let levels: [[i64; 5]; 3] = [(); 3].map(|()| [(); 5].map(|()| random.within(-c, c)));
    let mut chosen: Vec<[i64; 3]> = Vec::new();
    for i in 0..N {
        let point = match family {
            Family::Anywhere => [(); 3].map(|()| random.within(-c, c)),
            Family::Aligned => levels.map(|level| level[random.within(0, 4) as usize]),
            Family::Extreme => [(); 3].map(|()| [-c, c, c, 1 - c, 0][random.within(0, 4) as usize]),
            Family::NearlyCoplanar if i < 3 => [(); 3].map(|()| random.within(-(c >> 3), c >> 3)),
            Family::NearlyCoplanar => {
                let [s, t, unit] = [(); 3].map(|()| random.within(-1, 1));
                let [p, q, r] = [chosen[0], chosen[1], chosen[2]];
                let mut point: [i64; 3] =
                    std::array::from_fn(|k| p[k] + s * (q[k] - p[k]) + t * (r[k] - p[k]));
                point[i % 3] += unit;
                point
            }
        };
        chosen.push(point);
    }
    std::array::from_fn(|i| Point3::new(chosen[i][0], chosen[i][1], chosen[i][2]).unwrap())
}

fn big<const N: usize>(points: [Point3; N]) -> [BigPoint3; N] {
    points.map(BigPoint3::from)
}

fn flat(points: [Point3; 3]) -> [Point2; 3] {
    points.map(|p| Point2::new(p.integers()[0], p.integers()[1]).unwrap())
}

fn planes(points: &[Point3; 12]) -> ([Plane; 4], [BigPlane; 4]) {
    let plane = |i: usize| Plane::through(&points[i], &points[i + 1], &points[i + 2]).unwrap();
    let small = [plane(0), plane(3), plane(6), plane(9)];
    (small, small.map(BigPlane::from))
}

/// A filter may leave a sign open but never tell a wrong one.
fn agrees(filter: Option<Sign>, exact: Sign) {
    assert!(filter.is_none_or(|sign| sign == exact), "a filter tells a wrong sign");
}

fn check_points(p: &[Point3; 4], budget: &Budget) {
    let [a, b, c, d] = p;
    let [e, f, g, h] = &big(*p);
    let (off, full) = (budget.without_filters(), Budget::FULL);

    let exact = orient3d_exact(a, b, c, d, budget);
    assert_eq!(exact, orient3d_big(e, f, g, h));
    agrees(orient3d_filter(a, b, c, d, budget), exact);
    for budget in [*budget, off, full, full.without_filters()] {
        assert_eq!(orient3d(a, b, c, d, &budget), exact);
    }

    assert_eq!(side_of_lines_big(&BigLine::through(e, f), &BigLine::through(g, h)), exact);
    if let (Some(x), Some(y)) = (Line::through(a, b), Line::through(c, d)) {
        assert_eq!(BigLine::from(x), BigLine::through(e, f));
        assert_eq!(side_of_lines_exact(&x, &y), exact);
        agrees(side_of_lines_filter(&x, &y, budget), exact);
        for budget in [*budget, off, full, full.without_filters()] {
            assert_eq!(side_of_lines(&x, &y, &budget), exact);
        }
    }

    let [s, t, u] = flat([*a, *b, *c]);
    assert_eq!(
        orient2d(&s, &t, &u),
        orient2d_big(&BigPoint2::from(s), &BigPoint2::from(t), &BigPoint2::from(u))
    );
    assert_eq!(compare_along_line(a, b, c, d), compare_along_line_big(e, f, g, h));

    if let Some(plane) = Plane::through(a, b, c) {
        assert_eq!(side_of_plane(&plane, d, budget), exact);
        assert_eq!(side_of_plane_big(&BigPlane::through(e, f, g), h), exact);
        assert_eq!(BigPlane::from(plane), BigPlane::through(e, f, g));
    }
}

fn check_planes(p: &[Point3; 12], budget: &Budget) {
    let (small, large) = planes(p);
    let ([a, b, c, d], [e, f, g, h]) = (&small, &large);
    let off = budget.without_filters();

    let exact = side_of_meets_exact([a, b], [c, d], budget);
    assert_eq!(exact, side_of_meets_big([e, f], [g, h]));
    agrees(side_of_meets_filter([a, b], [c, d]), exact);
    assert_eq!(side_of_meets([a, b], [c, d], budget), exact);
    assert_eq!(side_of_meets([a, b], [c, d], &off), exact);

    let vertex = vertex_side_of_plane_exact([a, b, c], d, budget);
    assert_eq!(vertex, vertex_side_of_plane_big([e, f, g], h));
    assert_eq!(vertex_side_of_plane([a, b, c], d, budget), vertex);
    assert_eq!(vertex_side_of_plane([a, b, c], d, &off), vertex);

    let [q, r] = &big([p[0], p[1]]);
    let crossings = compare_crossings(&p[0], &p[1], c, d, budget);
    assert_eq!(crossings, compare_crossings_big(q, r, g, h));
}

#[test]
fn signs_follow_the_convention() {
    let point = |x, y, z| Point3::new(x, y, z).unwrap();
    let (o, x, y, z) = (point(0, 0, 0), point(1, 0, 0), point(0, 1, 0), point(0, 0, 1));
    let budget = &Budget::for_bits(4);
    assert_eq!(orient3d(&o, &x, &y, &z, budget), Sign::Positive);
    let floor = Plane::through(&o, &x, &y).unwrap();
    assert_eq!(side_of_plane(&floor, &z, budget), Sign::Positive);
    assert_eq!(side_of_plane(&floor, &y, budget), Sign::Zero);
    let [a, b, c] = &flat([o, x, y]);
    assert_eq!(orient2d(a, b, c), Sign::Positive);

    // A line upwards through a square whose vertices are counter-clockwise seen from above.
    let line = Line::through(&point(0, 0, -3), &point(1, 0, 5)).unwrap();
    let square = [point(-2, -2, 0), point(2, -2, 0), point(2, 2, 0), point(-2, 2, 0)];
    for i in 0..4 {
        let edge = Line::through(&square[i], &square[(i + 1) % 4]).unwrap();
        assert_eq!(side_of_lines(&line, &edge, budget), Sign::Positive);
    }

    // The coordinate planes meet in the origin, which is below z = 1 and in front of x = -1.
    let (side_x, side_y) =
        (Plane::through(&o, &y, &z).unwrap(), Plane::through(&o, &z, &x).unwrap());
    let above = Plane::through(&z, &point(1, 0, 1), &point(0, 1, 1)).unwrap();
    let vertex = [&floor, &side_x, &side_y];
    assert_eq!(vertex_side_of_plane(vertex, &above, budget), Some(Sign::Negative));
    assert_eq!(vertex_side_of_plane([&floor, &above, &side_x], &side_y, budget), None);
    // Both axes leave the origin, so the lines meet.
    assert_eq!(side_of_meets([&side_x, &side_y], [&floor, &side_y], budget), Sign::Zero);

    assert_eq!(compare_along_line(&o, &z, &x, &z), Sign::Positive);
    let upwards = compare_crossings(&point(3, 4, -2), &point(3, 4, 2), &floor, &above, budget);
    assert_eq!(upwards, Some(Sign::Positive));
    assert_eq!(compare_crossings(&o, &x, &floor, &above, budget), None);
}

/// Teller's coordinates (1992, equations 6.1 and 6.2), as `geom::Line` relates them to ours.
#[test]
fn plucker_coordinates_are_tellers_permuted() {
    let teller = |p: [i64; 3], q: [i64; 3]| {
        let [[px, py, pz], [qx, qy, qz]] = [p, q];
        [px * qy - qx * py, px * qz - qx * pz, px - qx, py * qz - qy * pz, pz - qz, qy - py]
    };
    let points: [Point3; 4] = points(Family::Anywhere, 10, &mut Random(7));
    let [p, q, r, s] = points.map(|p| p.integers());
    let (a, b) = (teller(p, q), teller(r, s));
    let [x, y] = [[0, 1], [2, 3]].map(|[i, j]| Line::through(&points[i], &points[j]).unwrap());
    let ([dx, dy, dz], [mx, my, mz]) = (x.direction(), x.moment().map(|m| m as i64));
    assert_eq!(a, [mz, -my, -dx, mx, -dz, dy]);
    let product = a[0] * b[4] + a[1] * b[5] + a[2] * b[3] + a[4] * b[0] + a[5] * b[1] + a[3] * b[2];
    let ours = dot(&x.direction().map(i128::from), &y.moment())
        + dot(&x.moment(), &y.direction().map(i128::from));
    assert_eq!(i128::from(product), -ours);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn every_stage_agrees_with_the_next(seed: u64) {
        let mut random = Random(seed);
        for family in FAMILIES {
            for bits in GRIDS {
                let budget = Budget::for_bits(bits);
                check_points(&points(family, bits, &mut random), &budget);
                check_planes(&points(family, bits, &mut random), &budget);
            }
            for bits in [41, 48, 52, 53] {
                check_points(&points(family, bits, &mut random), &Budget::for_bits(bits));
            }
        }
    }

    #[test]
    fn orientation_obeys_its_laws(seed: u64, grid in 0..GRIDS.len()) {
        let (mut random, bits) = (Random(seed), GRIDS[grid]);
        for family in FAMILIES {
            let p: [Point3; 4] = points(family, bits, &mut random);
            let sign = |p: [&Point3; 4]| orient3d(p[0], p[1], p[2], p[3], &Budget::FULL);
            let [a, b, c, d] = &p;
            let expected = sign([a, b, c, d]);
            for even in [[b, c, a, d], [c, a, b, d], [b, a, d, c], [d, c, b, a], [a, c, d, b]] {
                prop_assert_eq!(sign(even), expected);
            }
            for odd in [[b, a, c, d], [a, c, b, d], [a, b, d, c], [d, b, c, a], [b, c, d, a]] {
                prop_assert_eq!(sign(odd), -expected);
            }
            for movement in movements(&mut random) {
                let [a, b, c, d] = p.map(|p| movement.apply(p));
                prop_assert_eq!(sign([&a, &b, &c, &d]), expected * movement.sense);
                if let (Some(x), Some(y)) = (Line::through(&a, &b), Line::through(&c, &d)) {
                    let side = side_of_lines(&x, &y, &Budget::FULL);
                    prop_assert_eq!(side, expected * movement.sense);
                }
            }
            if let (Some(x), Some(y)) = (Line::through(a, b), Line::through(c, d)) {
                prop_assert_eq!(side_of_lines(&y, &x, &Budget::FULL), expected);
                prop_assert_eq!(side_of_lines(&x.reversed(), &y, &Budget::FULL), -expected);
                prop_assert_eq!(side_of_lines(&x, &x, &Budget::FULL), Sign::Zero);
            }

            let [s, t, u] = &flat([*a, *b, *c]);
            let turn = orient2d(s, t, u);
            prop_assert_eq!([orient2d(t, u, s), orient2d(u, s, t)], [turn; 2]);
            prop_assert_eq!([orient2d(t, s, u), orient2d(s, u, t)], [-turn; 2]);
            // 2D is 3D seen from above: raise one corner of the prism.
            let lift = |[x, y]: [i64; 2]| Point3::new(x, y, 0).unwrap();
            let lifted = [s, t, u].map(|p| lift([p.integers()[0], p.integers()[1]]));
            let above = Point3::new(s.integers()[0], s.integers()[1], 1).unwrap();
            prop_assert_eq!(sign([&lifted[0], &lifted[1], &lifted[2], &above]), turn);
            for movement in movements(&mut random) {
                let [s, t, u] = &flat(lifted.map(|p| movement.apply(p)));
                prop_assert_eq!(orient2d(s, t, u), turn * movement.sense);
            }
        }
    }

    #[test]
    fn planes_obey_their_laws(seed: u64, grid in 0..GRIDS.len()) {
        let (mut random, bits) = (Random(seed), GRIDS[grid].min(36));
        let budget = &Budget::for_bits(40);
        for family in FAMILIES {
            let p: [Point3; 12] = points(family, bits, &mut random);
            let ([a, b, c, d], _) = &planes(&p);
            let side = side_of_meets([a, b], [c, d], budget);
            prop_assert_eq!(side_of_meets([c, d], [a, b], budget), side);
            prop_assert_eq!(side_of_meets([b, a], [c, d], budget), -side);
            prop_assert_eq!(side_of_meets([&a.flipped(), b], [c, d], budget), -side);

            let vertex = vertex_side_of_plane([a, b, c], d, budget);
            for order in [[b, c, a], [b, a, c], [c, b, a]] {
                prop_assert_eq!(vertex_side_of_plane(order, d, budget), vertex);
            }
            prop_assert_eq!(vertex_side_of_plane([&a.flipped(), b, c], d, budget), vertex);
            let flipped = vertex_side_of_plane([a, b, c], &d.flipped(), budget);
            prop_assert_eq!(flipped, vertex.map(|s| -s));

            let along = compare_along_line(&p[0], &p[1], &p[2], &p[3]);
            prop_assert_eq!(compare_along_line(&p[0], &p[1], &p[3], &p[2]), -along);
            prop_assert_eq!(compare_along_line(&p[1], &p[0], &p[2], &p[3]), -along);
            let crossings = compare_crossings(&p[0], &p[1], c, d, budget);
            let negated = crossings.map(|s| -s);
            prop_assert_eq!(compare_crossings(&p[0], &p[1], d, c, budget), negated);
            prop_assert_eq!(compare_crossings(&p[1], &p[0], c, d, budget), negated);
            prop_assert_eq!(compare_crossings(&p[0], &p[1], &c.flipped(), d, budget), crossings);

            for movement in movements(&mut random) {
                let moved = p.map(|p| movement.apply(p));
                let ([e, f, g, h], _) = &planes(&moved);
                let [p, q, first, second] = [0, 1, 2, 3].map(|i| &moved[i]);
                prop_assert_eq!(compare_along_line(p, q, first, second), along);
                prop_assert_eq!(compare_crossings(&moved[0], &moved[1], g, h, budget), crossings);
                // A mirror flips every plane that is made of mirrored points.
                prop_assert_eq!(vertex_side_of_plane([e, f, g], h, budget),
                    vertex.map(|s| s * movement.sense));
                prop_assert_eq!(side_of_meets([e, f], [g, h], budget), side * movement.sense);
            }
        }
    }

    #[test]
    fn orientation_is_the_opposite_of_the_robust_crates(seed: u64) {
        let mut random = Random(seed);
        for family in FAMILIES {
            for bits in [10, 24, 40, 53] {
                let p: [Point3; 4] = points(family, bits, &mut random);
                let [a, b, c, d] = p.map(|p| {
                    let [x, y, z] = p.floats();
                    robust::Coord3D { x, y, z }
                });
                let theirs = Sign::of(&robust::orient3d(a, b, c, d));
                prop_assert_eq!(orient3d(&p[0], &p[1], &p[2], &p[3], &Budget::FULL), -theirs);
                let [s, t, u] = flat([p[0], p[1], p[2]]);
                let [i, j, k] = [s, t, u].map(|p| {
                    let [x, y] = p.floats();
                    robust::Coord { x, y }
                });
                prop_assert_eq!(orient2d(&s, &t, &u), Sign::of(&robust::orient2d(i, j, k)));
            }
        }
    }
}

/// An affine map of the grid into itself: x -> matrix·x + shift.
struct Movement {
    matrix: [[i64; 3]; 3],
    shift: [i64; 3],
    /// What it does to orientation.
    sense: Sign,
}

impl Movement {
    fn apply(&self, p: Point3) -> Point3 {
        let x = p.integers();
        let row = |i: usize| -> i64 {
            self.shift[i] + self.matrix[i].iter().zip(x).map(|(m, x)| m * x).sum::<i64>()
        };
        Point3::new(row(0), row(1), row(2)).unwrap()
    }
}

/// A translation, a scaling, two mirrors and a quarter turn. What was within 36 bits stays within
/// 40, and what was within 40 within 53.
fn movements(random: &mut Random) -> [Movement; 5] {
    let shift = [(); 3].map(|()| random.within(-1000, 1000));
    let s = random.within(1, 7);
    let linear = |matrix, sense| Movement { matrix, shift: [0; 3], sense };
    [
        Movement { shift, ..linear([[1, 0, 0], [0, 1, 0], [0, 0, 1]], Sign::Positive) },
        linear([[s, 0, 0], [0, s, 0], [0, 0, s]], Sign::Positive),
        linear([[-1, 0, 0], [0, 1, 0], [0, 0, 1]], Sign::Negative),
        linear([[0, 1, 0], [1, 0, 0], [0, 0, 1]], Sign::Negative),
        linear([[0, -1, 0], [1, 0, 0], [0, 0, 1]], Sign::Positive),
    ]
}

#[test]
fn rational_points_decide_as_on_a_common_grid() {
    let mut random = Random(7);
    let (mut signs, mut excluded) = ([0; 3], 0);
    for _ in 0..4000 {
        let points: Vec<RationalPoint3> = (0..14)
            .map(|_| {
                let numerators = [(); 3].map(|()| Int::from(random.within(-4, 4)));
                RationalPoint3::new(numerators, Int::from(random.within(1, 3)))
            })
            .collect();
        let grid = RationalPoint3::common_denominator(&points);
        let whole: Vec<BigPoint3> = points.iter().map(|point| point.on_grid(&grid)).collect();
        let sign = orient3d_rational(&points[0], &points[1], &points[2], &points[3]);
        assert_eq!(sign, orient3d_big(&whole[0], &whole[1], &whole[2], &whole[3]));
        signs[match sign {
            Sign::Negative => 0,
            Sign::Zero => 1,
            Sign::Positive => 2,
        }] += 1;
        let lines: Vec<[[Int; 3]; 2]> = whole
            .chunks_exact(2)
            .map(|ends| [0, 1].map(|end| ends[end].coordinates.clone()))
            .collect();
        let excludes =
            gordan::exclude_each_other_rational(points.chunks_exact(2).map(|e| [&e[0], &e[1]]));
        assert_eq!(excludes, gordan::exclude_each_other_exact(&lines));
        excluded += u32::from(excludes);
    }
    assert!(signs.iter().all(|&count| count > 0) && excluded > 0, "{signs:?}, {excluded}");
}
