//! The ranges of the transversals at the corners of the box, where coordinates are largest.

use super::algebra::{Vector, conjugates, opposite, products, side};
use super::exact::{Solution, solve};
use super::*;
use crate::geom::{BigLine, Point3};
use crate::num::Int;
use crate::predicates::budget::{SIDES_OF_EACH, TRANSVERSAL_COUNT};
use crate::predicates::{side_of_transversals, side_of_transversals_big, transversal_count};
use num_traits::Signed;

fn vector(line: &Line) -> Vector<Int> {
    let BigLine { direction: [a, b, c], moment: [d, e, f] } = BigLine::from(*line);
    [a, b, c, d, e, f]
}

/// Lines between corners of the box and points near them, or its edges; `seed` says which.
fn corner_lines<const N: usize>(bits: u32, axial: bool, seed: &mut u64) -> [Line; N] {
    let mut next = |n: u64| {
        *seed =
            seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (*seed >> 33) % n
    };
    let c = 1i64 << bits;
    [(); N].map(|()| {
        let levels = if axial { 2 } else { 4 };
        let mut point = || [(); 3].map(|()| [-c, c, c - 1, 0][next(levels) as usize]);
        let (p, mut q) = (point(), point());
        let axis = next(3) as usize;
        if axial {
            q = p;
        }
        if p == q {
            q[axis] = -p[axis] + i64::from(p[axis] == 0);
        }
        let [p, q] = [p, q].map(|[x, y, z]| Point3::new(x, y, z).unwrap());
        Line::through(&p, &q).unwrap()
    })
}

fn below(values: &[Int], bits: u32) {
    assert!(values.iter().all(|x| x.abs() < Int::from(1) << bits), "{values:?} at {bits} bits");
}

#[test]
fn transversals_of_corner_lines_stay_within_their_ranges() {
    let mut seed = 1;
    let mut seen = [0; 5];
    for bits in [1, 19, 22, 23, 24, 25, 32, 33, 38] {
        for n in 0..400 {
            let lines: [Line; 5] = corner_lines(bits, n % 4 == 0, &mut seed);
            let [a, b, c, d, fifth] = &lines;
            let four = [a, b, c, d];
            let (vectors, passed) = (four.map(vector), vector(fifth));
            let s = products(&vectors);
            let abc = opposite(&s);
            let discriminant = algebra::discriminant(&abc);
            below(
                std::slice::from_ref(&discriminant),
                TRANSVERSAL_COUNT.slope * bits + TRANSVERSAL_COUNT.constant,
            );
            let kind = match solve(&vectors, |x| x) {
                Solution::None => 0,
                Solution::Family => 1,
                Solution::One(line) => {
                    below(&[side(&line, &passed)], 12 * bits + 22);
                    2
                }
                Solution::Two(lines) => {
                    below(&lines.map(|line| side(&line, &passed)), 11 * bits + 17);
                    3
                }
                Solution::Conjugate => {
                    let [h, w] = conjugates(&vectors, &s, &abc, 3);
                    let (x, y) = (side(&h, &passed), side(&w, &passed));
                    let value = &x * &x - &y * &y * discriminant;
                    below(
                        &[x.clone() * &x, value],
                        SIDES_OF_EACH.slope * bits + SIDES_OF_EACH.constant,
                    );
                    4
                }
            };
            seen[kind] += 1;
            let tight = Budget::for_bits(bits);
            let expected = (
                transversal_count(four, &tight),
                FourLines::new(four, &tight).sides_of_each(fifth),
                side_of_transversals_big(lines.map(BigLine::from)),
            );
            for budget in [tight.without_filters(), Budget::FULL] {
                let solved = FourLines::new(four, &budget);
                let found = (
                    transversal_count(four, &budget),
                    solved.sides_of_each(fifth),
                    side_of_transversals(four, fifth, &budget),
                );
                assert_eq!(found, expected, "{lines:?}");
                assert_eq!(solved.count(), expected.0);
            }
        }
    }
    assert!(seen.iter().all(|&n| n > 5), "{seen:?}");
}

#[test]
fn unit_edges_stay_within_their_range() {
    let mut seed = 2;
    for bits in [1, 20, 23] {
        for _ in 0..400 {
            let [a, b, c, d, fifth]: [Line; 5] = corner_lines(bits, true, &mut seed);
            let lines = [a, b, c, d].map(|line| axial(&line).map(Int::from));
            let solution = match solve(&lines, |x| x) {
                Solution::None | Solution::Family => continue,
                Solution::One(line) => vec![line],
                Solution::Two(lines) => lines.to_vec(),
                Solution::Conjugate => panic!("two of any four edges are parallel"),
            };
            let sides: Vec<Int> = solution.iter().map(|line| side(line, &vector(&fifth))).collect();
            below(&sides, 5 * bits + 11);
        }
    }
}
