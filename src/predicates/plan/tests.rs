use super::*;
use crate::num::{Int, Rational, Sign};
use std::cmp::Ordering;

fn ratio(p: i64, q: i64) -> Rational {
    Rational::new(p.into(), q.into())
}

/// The sign by rationals alone.
fn turn_by_rationals(a: &PlanPoint, b: &PlanPoint, c: &PlanPoint) -> Sign {
    let [a, b, c] = [a, b, c].map(PlanPoint::coordinates);
    Sign::from(((&b[0] - &a[0]) * (&c[1] - &a[1])).cmp(&((&b[1] - &a[1]) * (&c[0] - &a[0]))))
}

/// Points of all sizes, many of them collinear.
fn points() -> Vec<PlanPoint> {
    let mut points = Vec::new();
    for (scale, divisor) in [(1, 3), (1 << 20, 7), (1 << 40, 1)] {
        for x in -1..=1 {
            for y in [-2, 0, 1] {
                points.push(PlanPoint::from_coordinates(&[
                    ratio(x * scale, divisor),
                    ratio(y * scale + x, divisor),
                ]));
            }
        }
    }
    let huge = Int::from(10).pow(400);
    for (x, y) in [(1, 1), (-1, 2)] {
        points.push(PlanPoint::integer([&huge * x, &huge * y]));
        points.push(PlanPoint::new([x.into(), y.into(), huge.clone()]));
    }
    points
}

#[test]
fn turns_agree_with_rationals_and_keep_their_laws() {
    let mut table = PlanPoints::default();
    let points = points();
    let numbers: Vec<u32> = points.iter().map(|p| table.insert(p.clone())).collect();
    let mut seen = [0; 3];
    for (a, &i) in points.iter().zip(&numbers) {
        for (b, &j) in points.iter().zip(&numbers) {
            for (c, &k) in points.iter().zip(&numbers) {
                let sign = turn_of_points(a, b, c);
                seen[(sign as i8 + 1) as usize] += 1;
                assert_eq!(sign, turn_by_rationals(a, b, c), "{a:?} {b:?} {c:?}");
                assert_eq!(sign, table.turn(i, j, k));
                assert_eq!(sign, turn_of_points(b, c, a));
                assert_eq!(sign, -turn_of_points(b, a, c));
            }
        }
    }
    assert!(seen.iter().all(|&count| count > 1000), "{seen:?}");
}

#[test]
fn small_tables_answer_alike() {
    let mut table = PlanPoints::default();
    let edge = (1 << 30) - 1;
    let mut points = Vec::new();
    for x in [-edge, -1, 0, 2, edge] {
        for y in [-edge, 0, 1, edge] {
            points.push(PlanPoint::integer([x.into(), y.into()]));
        }
    }
    let numbers: Vec<u32> = points.iter().map(|p| table.insert(p.clone())).collect();
    for (a, &i) in points.iter().zip(&numbers) {
        for (b, &j) in points.iter().zip(&numbers) {
            for (c, &k) in points.iter().zip(&numbers) {
                assert_eq!(table.turn(i, j, k), turn_by_rationals(a, b, c));
            }
        }
    }
}

#[test]
fn meets_lie_on_both_lines() {
    let points = points();
    let mut met = 0;
    for (i, a) in points.iter().enumerate().step_by(2) {
        for b in points.iter().skip(i + 1).step_by(3) {
            for c in points.iter().step_by(5) {
                for d in points.iter().skip(1).step_by(7).filter(|&d| d != c) {
                    let Some(meet) = PlanPoint::meet(a, b, c, d) else {
                        let [a, b, c, d] = [a, b, c, d].map(PlanPoint::coordinates);
                        let cross =
                            (&b[0] - &a[0]) * (&d[1] - &c[1]) - (&b[1] - &a[1]) * (&d[0] - &c[0]);
                        assert_eq!(cross, ratio(0, 1));
                        continue;
                    };
                    met += 1;
                    assert_eq!(turn_by_rationals(a, b, &meet), Sign::Zero);
                    assert_eq!(turn_by_rationals(c, d, &meet), Sign::Zero);
                }
            }
        }
    }
    assert!(met > 1000, "{met}");
}

#[test]
fn order_along_a_line_is_that_of_its_parameter() {
    let mut table = PlanPoints::default();
    let mut on = |x, y, d| table.insert(PlanPoint::new([x, y, d].map(Int::from)));
    let ([p, q], [v, w]) = ([on(0, 0, 1), on(3, 6, 1)], [on(1, 2, 3), on(1, 2, 2)]);
    let (low, high) = (on(5, 1, 7), on(5, 2, 7));
    assert_eq!(table.compare_along([p, q], v, w), Ordering::Less);
    assert_eq!(table.compare_along([q, p], v, w), Ordering::Greater);
    assert_eq!(table.compare_along([q, p], v, v), Ordering::Equal);
    assert_eq!(table.compare_along([low, high], low, high), Ordering::Less);
}
