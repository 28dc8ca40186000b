//! The predicates on four and five lines against the transversals themselves, over Q(√d).

use stabline::geom::{BigLine, Line, Point3};
use stabline::num::{Int, Sign, Surd};
use stabline::oracle::Random;
use stabline::predicates::{
    Budget, TransversalCount, side_of_transversals, side_of_transversals_big, transversal_count,
    transversal_count_big,
};
use stabline::stab::transversals::{IsolatedLine, Transversals, transversals};

fn line(random: &mut Random, reach: i64) -> Line {
    loop {
        let [p, q] = [(); 2].map(|()| [(); 3].map(|()| random.between(-reach, reach)));
        if p != q {
            let point = |[x, y, z]: [i64; 3]| Point3::new(x, y, z).unwrap();
            return Line::through(&point(p), &point(q)).unwrap();
        }
    }
}

fn expected(result: &Transversals) -> TransversalCount {
    let at_infinity = result.at_infinity.iter().map(|line| line.multiplicity);
    let finite = result.isolated.iter().map(|line| line.multiplicity);
    let multiplicities: Vec<u8> = finite.chain(at_infinity).collect();
    match (result.families.is_empty(), multiplicities.as_slice()) {
        (false, _) => TransversalCount::Family,
        (true, []) => TransversalCount::None,
        (true, [2]) => TransversalCount::One,
        (true, [1, 1]) => TransversalCount::Two,
        (true, other) => panic!("multiplicities {other:?}"),
    }
}

/// The grids: everything degenerate, nothing degenerate, and the ends of the fixed widths.
const REACHES: [i64; 7] = [1, 2, 1000, 1 << 20, 1 << 24, 1 << 32, 1 << 38];

#[test]
fn the_count_is_that_of_the_lines_themselves() {
    let mut random = Random::new(3);
    let mut seen = [0; 4];
    for reach in REACHES {
        for _ in 0..if reach <= 2 { 3000 } else { 150 } {
            let lines = [(); 4].map(|()| line(&mut random, reach));
            let big = lines.map(BigLine::from);
            let truth = expected(&transversals(&big));
            let [a, b, c, d] = &lines;
            let budget = Budget::for_bits(u64::BITS - (reach as u64 - 1).leading_zeros());
            for budget in [budget, budget.without_filters(), Budget::FULL] {
                assert_eq!(transversal_count([a, b, c, d], &budget), truth, "{lines:?}");
                assert_eq!(transversal_count([c, a, d, b], &budget), truth, "{lines:?}");
            }
            assert_eq!(transversal_count_big(big), truth, "{lines:?}");
            seen[truth as usize] += 1;
        }
    }
    assert!(seen.iter().all(|&n| n > 20), "{seen:?}");
}

fn surd_side(x: &IsolatedLine, direction: &[Int; 3], moment: &[Int; 3]) -> Surd {
    let term = |a: &Surd, b: &Int| a * &Surd::from(b.clone());
    (0..3).fold(Surd::from(Int::from(0)), |sum, i| {
        &(&sum + &term(&x.direction[i], &moment[i])) + &term(&x.moment[i], &direction[i])
    })
}

#[test]
fn the_fifth_line_is_where_both_transversals_say() {
    let mut random = Random::new(4);
    let mut seen = [0; 3];
    for reach in REACHES {
        for _ in 0..if reach <= 2 { 1500 } else { 60 } {
            let lines = [(); 4].map(|()| line(&mut random, reach));
            let fifth = line(&mut random, reach);
            let [a, b, c, d] = &lines;
            let result = transversals(&lines.map(BigLine::from));
            let budget = Budget::for_bits(u64::BITS - (reach as u64 - 1).leading_zeros());
            let sign = side_of_transversals([a, b, c, d], &fifth, &budget);
            let plain = side_of_transversals([b, d, c, a], &fifth, &budget.without_filters());
            assert_eq!(sign, plain);
            assert_eq!(side_of_transversals([a, b, c, &fifth], d, &Budget::FULL), sign);
            let [e, f, g, h] = lines.map(BigLine::from);
            assert_eq!(side_of_transversals_big([e, f, g, h, fifth.into()]), sign);
            if let [l, m] = result.isolated.as_slice() {
                let fifth = BigLine::from(fifth);
                let [x, y] = [l, m].map(|t| surd_side(t, &fifth.direction, &fifth.moment));
                let across = (0..3).fold(Surd::from(Int::from(0)), |sum, i| {
                    let there = &l.direction[i] * &m.moment[i];
                    let back = &l.moment[i] * &m.direction[i];
                    &(&sum + &there) + &back
                });
                assert_eq!(sign, x.sign() * y.sign() * across.sign(), "{lines:?} {fifth:?}");
                seen[(sign as i8 + 1) as usize] += 1;
            }
        }
    }
    assert!(seen.iter().all(|&n| n > 100), "{seen:?}");
}

#[test]
fn zero_means_that_a_transversal_is_met() {
    // A fifth line equal to one of the four is met by both transversals.
    let mut random = Random::new(8);
    for _ in 0..200 {
        let lines = [(); 4].map(|()| line(&mut random, 1 << 20));
        let [a, b, c, d] = &lines;
        assert_eq!(side_of_transversals([a, b, c, d], b, &Budget::FULL), Sign::Zero);
    }
}
