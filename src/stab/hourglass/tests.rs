mod chains;

use super::*;
use crate::num::{Int, Rational};
use crate::oracle::{Family, PlaneTruth, Random, classify_2d, sequence_2d};
use num_traits::Signed;

type Segments = Vec<[BigPoint2; 2]>;

fn pushed(segments: &Segments) -> Hourglass {
    let mut hourglass = Hourglass::new();
    for [left, right] in segments {
        hourglass.push_big(left.clone(), right.clone());
    }
    hourglass
}

fn segments(list: &[[[i64; 2]; 2]]) -> Segments {
    let point = |p: [i64; 2]| BigPoint2 { coordinates: p.map(Int::from) };
    list.iter().map(|ends| ends.map(point)).collect()
}

/// The verdict, after its witness, touching line and certificate have been checked.
fn checked(segments: &Segments, label: &str) -> PlaneTruth {
    let hourglass = pushed(segments);
    let verdict = hourglass.verdict();
    match verdict {
        PlaneVerdict::Open(witness) => {
            assert!(hourglass.is_open());
            check_witness(&witness, segments, label);
            PlaneTruth::Open
        }
        PlaneVerdict::Grazing { touching_line, certificate } => {
            assert!(!hourglass.is_open());
            check_certificate(&certificate, segments, label);
            let [p, q] = &touching_line;
            assert_ne!(p, q, "{label}");
            for [left, right] in segments {
                assert_ne!(orient2d_big(p, q, left), Sign::Negative, "{label}");
                assert_ne!(orient2d_big(p, q, right), Sign::Positive, "{label}");
            }
            PlaneTruth::Grazing
        }
        PlaneVerdict::Blocked { certificate } => {
            assert!(!hourglass.is_open());
            check_certificate(&certificate, segments, label);
            PlaneTruth::Blocked
        }
    }
}

fn check_witness(witness: &PlaneWitness, segments: &Segments, label: &str) {
    let [p, q] = &witness.points;
    assert_ne!(p, q, "{label}");
    for ends in segments {
        let [left, right] = [0, 1].map(|i| {
            let [x, y] = ends[i].coordinates.clone().map(Rational::from);
            (&q[0] - &p[0]) * (y - &p[1]) - (&q[1] - &p[1]) * (x - &p[0])
        });
        assert!(left.is_positive() && right.is_negative(), "{label}: {witness:?}");
    }
}

fn check_certificate(certificate: &[EndTerm], segments: &Segments, label: &str) {
    assert!((2..=4).contains(&certificate.len()), "{label}: {certificate:?}");
    let mut sum = [0, 0, 0].map(Int::from);
    for term in certificate {
        assert!(term.weight.is_positive(), "{label}");
        let (index, sign) = match term.end {
            End::Left => (0, 1),
            End::Right => (1, -1),
        };
        let [x, y] = &segments[term.portal][index].coordinates;
        for (s, c) in sum.iter_mut().zip([x, y, &Int::from(1)]) {
            *s += c * &term.weight * sign;
        }
    }
    assert_eq!(sum, [0, 0, 0].map(Int::from), "{label}: {certificate:?}");
}

#[test]
fn the_twin_agrees_on_every_family() {
    let mut counts = [0; 3];
    for family in Family::ALL {
        for seed in 0..800 {
            let segments = sequence_2d(family, seed);
            let label = format!("{family:?} {seed}");
            let truth = checked(&segments, &label);
            assert_eq!(truth, classify_2d(&segments), "{label}");
            counts[truth as usize] += 1;
        }
    }
    // Neither verdict may be rare.
    assert!(counts.iter().all(|&count| count > 500), "{counts:?}");
}

#[test]
fn every_small_sequence_agrees() {
    // Ends on a 3 x 3 grid, where nearly everything is degenerate.
    let mut random = Random::new(5);
    for round in 0..10_000 {
        let count = random.between(1, 6);
        let mut list = Vec::new();
        while list.len() < count as usize {
            let ends = [(); 2].map(|()| [(); 2].map(|()| random.between(0, 2)));
            if ends[0] != ends[1] {
                list.push(ends);
            }
        }
        let segments = segments(&list);
        assert_eq!(checked(&segments, &format!("{list:?}")), classify_2d(&segments), "{round}");
    }
}

#[test]
fn popping_restores_every_prefix() {
    let mut random = Random::new(9);
    for seed in 0..200 {
        let mut hourglass = Hourglass::new();
        let mut stack: Segments = Vec::new();
        let pool: Vec<_> =
            (0..6).flat_map(|k| sequence_2d(Family::Collinear, 31 * seed + k)).collect();
        for _ in 0..40 {
            if !stack.is_empty() && random.one_in(3) {
                stack.pop();
                hourglass.pop();
            } else {
                let segment = pool[random.between(0, pool.len() as i64 - 1) as usize].clone();
                hourglass.push_big(segment[0].clone(), segment[1].clone());
                stack.push(segment);
            }
            let fresh = pushed(&stack);
            assert_eq!(hourglass.depth(), stack.len());
            assert_eq!(hourglass.is_open(), fresh.is_open());
            if !stack.is_empty() {
                assert_eq!(hourglass.verdict(), fresh.verdict());
            }
        }
    }
}

#[test]
fn large_coordinates_give_the_same_answers() {
    let factor = Int::from(10).pow(40);
    for seed in 0..300 {
        let segments = sequence_2d(Family::SharedVertex, seed);
        let large: Segments = segments
            .iter()
            .map(|ends| {
                ends.clone().map(|p| BigPoint2 { coordinates: p.coordinates.map(|c| c * &factor) })
            })
            .collect();
        assert_eq!(checked(&segments, "small"), checked(&large, "large"));
    }
    // Small ends first, then large ones.
    let mut mixed = segments(&[[[-1, 0], [1, 0]], [[-1, 1], [1, 1]]]);
    let far = |x: i64| BigPoint2 { coordinates: [Int::from(x), factor.clone()] };
    mixed.push([far(-1), far(1)]);
    assert_eq!(checked(&mixed, "mixed"), PlaneTruth::Open);
}

#[test]
fn witnesses_are_simple_where_they_can_be() {
    let hourglass = pushed(&segments(&[[[-1, 0], [1, 0]], [[-3, 4], [1, 4]]]));
    let PlaneVerdict::Open(witness) = hourglass.verdict() else { panic!("open") };
    let expected = [[0, 0], [-1, 4]].map(|p| p.map(|c| Rational::from(Int::from(c))));
    assert_eq!(witness.points, expected);
    let mut one = pushed(&segments(&[[[-1, 0], [1, 0]]]));
    let PlaneVerdict::Open(witness) = one.verdict() else { panic!("open") };
    check_witness(&witness, &segments(&[[[-1, 0], [1, 0]]]), "one");
    one.pop();
    assert!(one.is_open());
}
