//! Every decided sign against rationals; exact zeros decided; `None` rare.

use super::*;
use crate::num::{Int, Rational, parse_decimal};
use num_traits::Zero;
use proptest::prelude::*;

/// A point both ways: its floats, and its true coordinates.
#[derive(Clone, Debug)]
struct Both {
    approx: Approx3,
    truth: [Rational; 3],
}

fn exact_point(p: [f64; 3]) -> Both {
    Both { approx: Approx3::exact(p), truth: p.map(|c| Rational::from_float(c).unwrap()) }
}

/// The point of three coordinates in millionths.
fn decimal_point(millionths: [i64; 3]) -> Both {
    let text = millionths.map(|m| format!("{m}e-6"));
    let p: [f64; 3] = std::array::from_fn(|i| text[i].parse().unwrap());
    let truth = text.map(|t| parse_decimal(&t).unwrap());
    Both { approx: Approx3::rounded(p), truth }
}

fn minus(a: &[Rational; 3], b: &[Rational; 3]) -> [Rational; 3] {
    std::array::from_fn(|i| &a[i] - &b[i])
}

fn determinant(a: &[Rational; 3], b: &[Rational; 3], c: &[Rational; 3]) -> Rational {
    let minor = |i: usize, j: usize| &b[i] * &c[j] - &b[j] * &c[i];
    &a[0] * minor(1, 2) + &a[1] * minor(2, 0) + &a[2] * minor(0, 1)
}

fn truth(points: [&Both; 4]) -> Sign {
    let [a, b, c, d] = points.map(|p| &p.truth);
    Sign::of(&determinant(&minus(b, a), &minus(c, a), &minus(d, a)))
}

/// Checks plane and line on four points; how many of the two were decided.
fn check(points: [&Both; 4]) -> u32 {
    let [a, b, c, d] = points.map(|p| p.approx);
    let bound = Bound::of(&[a, b, c, d]);
    let expected = truth(points);
    let plane = FilteredPlane::through(&a, &b, &c, bound);
    let line = FilteredLine::through(&a, &b, bound);
    let edge = FilteredLine::through(&c, &d, bound);
    let mut decided = 0;
    let sides = [plane.side(&d), line.side_of_edge(&edge), edge.side_of_edge(&line)];
    for side in sides.into_iter().flatten() {
        assert_eq!(side, expected, "{points:?}");
        decided += 1;
    }
    assert_eq!(plane.flipped().side(&d), plane.side(&d).map(|s| -s));
    assert_eq!(line.reversed().side_of_edge(&edge), line.side_of_edge(&edge).map(|s| -s));
    decided
}

fn triple(range: std::ops::RangeInclusive<i64>) -> impl Strategy<Value = [i64; 3]> {
    [range.clone(), range.clone(), range]
}

/// Points of every kind: small and large integers, eighths, decimals, dyadics, extremes.
fn any_point() -> impl Strategy<Value = Both> {
    let corner = prop_oneof![Just(-1i64), Just(0), Just(1)];
    prop_oneof![
        triple(-8..=8).prop_map(|c| exact_point(c.map(|c| c as f64))),
        triple(-32768..=32768).prop_map(|c| exact_point(c.map(|c| c as f64))),
        triple(-(1 << 40)..=1 << 40).prop_map(|c| exact_point(c.map(|c| c as f64))),
        [corner.clone(), corner.clone(), corner]
            .prop_map(|c| exact_point(c.map(|c| (c * 32768) as f64))),
        triple(-262144..=262144).prop_map(|c| exact_point(c.map(|c| c as f64 / 8.0))),
        triple(-4_000_000_000..=4_000_000_000).prop_map(decimal_point),
        triple(-3_000_000..=3_000_000).prop_map(decimal_point),
        triple(-100..=100).prop_map(|c| exact_point(c.map(|c| c as f64 / 1048576.0))),
    ]
}

/// `a + (b - a)·i/8 + (c - a)·j/8`: on the plane of the three, but for the rounding.
fn near_plane(a: &Both, b: &Both, c: &Both, i: i64, j: i64) -> Both {
    let eighth = |n: i64| Rational::new(Int::from(n), Int::from(8));
    let (p, q) = (minus(&b.truth, &a.truth), minus(&c.truth, &a.truth));
    let truth: [Rational; 3] =
        std::array::from_fn(|k| &a.truth[k] + &p[k] * eighth(i) + &q[k] * eighth(j));
    let floats = truth.clone().map(|t| nearest(&t));
    Both { approx: Approx3::rounded(floats), truth }
}

/// The nearest float, by its decimal digits: ratios here have denominators 2^i·5^j.
fn nearest(value: &Rational) -> f64 {
    let scaled = value * Rational::from(Int::from(10u8).pow(60));
    assert!(scaled.is_integer(), "the test's ratios are finite decimals");
    format!("{}e-60", scaled.to_integer()).parse().unwrap()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(8000))]

    #[test]
    fn decided_signs_are_right(points in prop::array::uniform4(any_point())) {
        let [a, b, c, d] = &points;
        check([a, b, c, d]);
    }

    #[test]
    fn decided_signs_are_right_near_the_plane(
        points in prop::array::uniform3(any_point()), i in -16i64..=16, j in -16i64..=16,
    ) {
        let [a, b, c] = &points;
        let d = near_plane(a, b, c, i, j);
        // The truth is zero: a decision must say so.
        prop_assert!(truth([a, b, c, &d]).eq(&Sign::Zero));
        check([a, b, c, &d]);
        // One float away from it, the truth is what the rationals say.
        let mut off = d.approx.floats();
        off[0] = off[0].next_up();
        check([a, b, c, &exact_point(off)]);
    }

    #[test]
    fn small_integers_are_always_decided(points in prop::array::uniform4(triple(-32768..=32768))) {
        let [a, b, c, d] = points.map(|p| exact_point(p.map(|c| c as f64)));
        prop_assert_eq!(check([&a, &b, &c, &d]), 3);
        let zero = near_plane(&a, &b, &c, 8, -8);
        let zero = exact_point(zero.approx.floats());
        let bound = Bound::new(32768.0);
        if bound.holds(&zero.approx) {
            let plane = FilteredPlane::through(&a.approx, &b.approx, &c.approx, bound);
            prop_assert_eq!(plane.side(&zero.approx), Some(Sign::Zero));
        }
    }

    #[test]
    fn lines_through_eighths_pass_integer_edges_exactly(
        line in [triple(-131071..=131071), triple(-131071..=131071)],
        edge in [triple(-16383..=16383), triple(-16383..=16383)],
    ) {
        let [p, q] = line.map(|p| exact_point(p.map(|c| c as f64 / 8.0)));
        let [r, s] = edge.map(|p| exact_point(p.map(|c| c as f64)));
        let bound = Bound::new(16383.875);
        let line = FilteredLine::through(&p.approx, &q.approx, bound);
        let edge = FilteredLine::through(&r.approx, &s.approx, bound);
        prop_assert_eq!(line.side_of_edge(&edge), Some(truth([&p, &q, &r, &s])));
        // A shared point is a zero, and decided.
        let touching = FilteredLine::through(&p.approx, &r.approx, bound);
        prop_assert_eq!(touching.side_of_edge(&edge), Some(Sign::Zero));
    }
}

#[test]
fn random_decimals_are_nearly_always_decided() {
    // A linear congruence: the same numbers every run.
    let mut state = 1u64;
    let mut next = || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 33) as i64 % 4_096_000_000 - 2_048_000_000
    };
    let mut decided = 0;
    for _ in 0..2000 {
        let points = [(); 4].map(|()| decimal_point([next(), next(), next()]));
        let [a, b, c, d] = &points;
        decided += check([a, b, c, d]);
    }
    assert_eq!(decided, 6000);
}

#[test]
fn what_lies_outside_the_bound_is_never_decided() {
    let point = |x: f64| Approx3::exact([x, 2.0 * x, 1.0]);
    let small = Bound::new(2.0);
    let (a, b, c) = (point(0.0), point(3.0), Approx3::exact([0.0, 0.0, 2.0]));
    let origin = Approx3::exact([0.0; 3]);
    assert_eq!(FilteredPlane::through(&a, &b, &c, small).side(&origin), None);
    let (good, bad) = (FilteredLine::through(&a, &c, small), FilteredLine::through(&a, &b, small));
    assert_eq!(good.side_of_edge(&bad), None);
    assert_eq!(bad.side_of_edge(&good), None);
    for x in [f64::NAN, f64::INFINITY, 1e100] {
        let points = [point(x), point(1.0), Approx3::exact([0.0, 0.0, x])];
        let bound = Bound::of(&points);
        let [a, b, c] = &points;
        assert_eq!(
            {
                let plane = FilteredPlane::through(a, b, c, bound);
                Held::ALL.map(|t| plane.scale().error(t, bound.b))
            }
            .map(|e| (0.0..1.0).contains(&e)),
            [false; 3]
        );
    }
}

#[test]
fn filters_that_are_switched_off_never_decide() {
    let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let [a, b, c, d] = points.map(Approx3::exact);
    assert_eq!(FilteredPlane::through(&a, &b, &c, Bound::NEVER).side(&d), None);
    assert_eq!(FilteredPlane::through(&a, &a, &a, Bound::NEVER).side(&a), None);
    let line = FilteredLine::through(&a, &b, Bound::NEVER);
    assert_eq!(line.side_of_edge(&FilteredLine::through(&c, &d, Bound::NEVER)), None);
}

#[test]
fn truly_zero_determinants_of_rounded_points_stay_undecided() {
    let third = |n: i64| decimal_point([n * 100_001, n * 7, n * 13_333]);
    let (a, b, c, d) = (third(1), third(2), third(5), third(11));
    assert!(determinant(&a.truth, &b.truth, &c.truth).is_zero());
    assert_eq!(check([&a, &b, &c, &d]), 0);
}
