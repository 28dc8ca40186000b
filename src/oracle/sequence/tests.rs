use super::*;
use crate::oracle::{Family, Random, sequence};

type SurdVector = [Surd; 3];

fn point(p: [i64; 3]) -> BigPoint3 {
    BigPoint3 { coordinates: p.map(Int::from) }
}

fn portals(list: &[&[[i64; 3]]]) -> Vec<Vec<BigPoint3>> {
    list.iter().map(|corners| corners.iter().map(|&p| point(p)).collect()).collect()
}

fn name(truth: &Truth) -> &'static str {
    match truth {
        Truth::Open(_) => "open",
        Truth::Grazing(_) => "grazing",
        Truth::Blocked => "blocked",
    }
}

fn surd_dot(a: &SurdVector, b: &Vector) -> Surd {
    (0..3).fold(Surd::from(Int::zero()), |sum, i| &sum + &(&a[i] * &Surd::from(b[i].clone())))
}

/// The definition, word for word, over Q(√d): sides of the edges and the direct check.
fn check_definition(truth: &Truth, sequence: &[Vec<BigPoint3>]) {
    let (line, strict) = match truth {
        Truth::Open(line) => (line, true),
        Truth::Grazing(line) => (line, false),
        Truth::Blocked => return,
    };
    let [from, to] = line;
    let direction = [0, 1, 2].map(|i| &to[i] - &from[i]);
    assert!(direction.iter().any(|c| !c.is_zero()), "no direction");
    for corners in sequence {
        let portal = Portal::new(corners);
        let along = surd_dot(&direction, &portal.normal).sign();
        let sides: Vec<Sign> = portal
            .edges()
            .map(|e| {
                let moved = [(1, 2), (2, 0), (0, 1)].map(|(i, j)| {
                    let d = |i: usize| Surd::from(e.direction[i].clone());
                    &(&d(i) * &from[j]) - &(&d(j) * &from[i])
                });
                let m = [0, 1, 2].map(|i| &moved[i] + &Surd::from(e.moment[i].clone()));
                (0..3)
                    .fold(Surd::from(Int::zero()), |sum, i| &sum + &(&direction[i] * &m[i]))
                    .sign()
            })
            .collect();
        if strict {
            assert!(sides.iter().all(|s| *s == Sign::Positive), "{sides:?}");
            assert_eq!(along, Sign::Positive);
            continue;
        }
        match along {
            Sign::Negative => panic!("against the portal"),
            Sign::Positive => assert!(sides.iter().all(|s| *s != Sign::Negative), "{sides:?}"),
            Sign::Zero => assert!(sides.iter().all(|s| *s == Sign::Zero), "{sides:?}"),
        }
    }
}

#[test]
fn two_facing_squares_are_open() {
    let sequence = portals(&[
        &[[0, 0, 0], [0, 0, 4], [4, 0, 4], [4, 0, 0]],
        &[[1, 9, 0], [1, 9, 2], [6, 9, 2], [6, 9, 0]],
    ]);
    let truth = classify(&sequence);
    check_definition(&truth, &sequence);
    assert_eq!(name(&truth), "open");
}

#[test]
fn weak_signs_alone_do_not_make_a_sequence_graze() {
    let sequence =
        portals(&[&[[0, 0, 0], [1, 0, 0], [0, 1, 0]], &[[0, 0, 1], [0, 1, 1], [1, 0, 1]]]);
    assert_eq!(name(&classify(&sequence)), "blocked");
}

#[test]
fn two_doors_in_one_wall_graze_within_its_plane() {
    let left: &[[i64; 3]] = &[[0, 0, 0], [0, 0, 2], [1, 0, 2], [1, 0, 0]];
    let right: &[[i64; 3]] = &[[3, 0, 1], [4, 0, 1], [4, 0, 3], [3, 0, 3]];
    let sequence = portals(&[left, right]);
    let truth = classify(&sequence);
    check_definition(&truth, &sequence);
    assert_eq!(name(&truth), "grazing");
}

#[test]
fn a_chicane_grazes() {
    // Right, left and right again of the plane x = 0: only lines in that plane pass.
    let sequence = portals(&[
        &[[0, 0, 0], [0, 0, 2], [2, 0, 2], [2, 0, 0]],
        &[[-2, 1, 0], [-2, 1, 2], [0, 1, 2], [0, 1, 0]],
        &[[0, 2, -1], [0, 2, 1], [2, 2, 1], [2, 2, -1]],
    ]);
    let truth = classify(&sequence);
    check_definition(&truth, &sequence);
    assert_eq!(name(&truth), "grazing");
    let mut apart = sequence;
    for p in &mut apart[2] {
        p.coordinates[0] -= Int::from(1);
    }
    assert_eq!(name(&classify(&apart)), "open");
}

fn reversed(sequence: &[Vec<BigPoint3>]) -> Vec<Vec<BigPoint3>> {
    sequence.iter().rev().map(|p| p.iter().rev().cloned().collect()).collect()
}

/// The image under an affine map of determinant one; it keeps every answer.
fn sheared(sequence: &[Vec<BigPoint3>]) -> Vec<Vec<BigPoint3>> {
    let image = |p: &BigPoint3| {
        let [x, y, z] = &p.coordinates;
        let y = y + x * 2 + 5;
        let z = z - &y * 3;
        BigPoint3 { coordinates: [x + &z - 7, y, z] }
    };
    sequence.iter().map(|p| p.iter().map(image).collect()).collect()
}

#[test]
fn answers_hold_and_do_not_change_under_symmetries() {
    let mut counts = std::collections::BTreeMap::new();
    for family in Family::ALL {
        for seed in 0..40 {
            let sequence = sequence(family, seed);
            let truth = classify(&sequence);
            check_definition(&truth, &sequence);
            *counts.entry((format!("{family:?}"), name(&truth))).or_insert(0) += 1;
            let label = format!("{family:?} {seed}");
            assert_eq!(name(&truth), name(&classify(&reversed(&sequence))), "{label} reversed");
            assert_eq!(name(&truth), name(&classify(&sheared(&sequence))), "{label} sheared");
        }
    }
    println!("{counts:?}");
}

#[test]
fn sampled_lines_never_contradict() {
    for family in Family::ALL {
        for seed in 0..30 {
            let sequence = sequence(family, seed);
            if matches!(classify(&sequence), Truth::Open(_)) {
                continue;
            }
            let edges: Vec<Edge> =
                sequence.iter().flat_map(|c| Portal::new(c).edges().collect::<Vec<_>>()).collect();
            let mut random = Random::new(seed);
            for _ in 0..300 {
                let line = between(&mut random, &sequence[0], sequence.last().unwrap());
                let strict = edges.iter().all(|e| line.side(e) == Sign::Positive);
                assert!(!strict, "{family:?} {seed}");
            }
        }
    }
}

/// A line from a point inside one portal to a point inside another.
fn between(random: &mut Random, first: &[BigPoint3], last: &[BigPoint3]) -> RationalLine {
    let mut inside = |corners: &[BigPoint3]| {
        let mut sum = [0, 0, 0].map(Int::from);
        let mut weight = Int::zero();
        for p in corners {
            let share = Int::from(random.between(1, 20).pow(2));
            sum = add(&sum, &scale(&p.coordinates, &share));
            weight += share;
        }
        (sum, weight)
    };
    let (a, a_weight) = inside(first);
    let (b, b_weight) = inside(last);
    let direction = sub(&scale(&b, &a_weight), &scale(&a, &b_weight));
    RationalLine { base: a, weight: a_weight, direction }
}
