//! The stabber against the brute-force twin, on every family of sequences.
//!
//! `STABLINE_SEQUENCES=N` sets the number of sequences a family (default 150).

mod support;

use num_traits::Signed;
use stabline::geom::BigPoint3;
use stabline::num::{Int, Rational, Sign, Surd};
use stabline::oracle::{Family, Truth, classify, sequence};
use stabline::stab::{
    Certificate, Portal3, QuadricProof, StabLine, Stabber, Verdict, Witness, decide_open,
};
use support::certificate;

fn count() -> u64 {
    std::env::var("STABLINE_SEQUENCES").ok().and_then(|n| n.parse().ok()).unwrap_or(200)
}

fn validated(portals: &[Vec<BigPoint3>]) -> Vec<Portal3> {
    portals.iter().map(|p| Portal3::new(p).expect("families are valid")).collect()
}

/// Whether the line is strictly right of every edge, from the definition alone.
fn passes(witness: &Witness, portals: &[Vec<BigPoint3>]) -> bool {
    let [a, b] = &witness.points;
    let minus = |p: &[Rational; 3], q: &[Rational; 3]| [0, 1, 2].map(|i| &p[i] - &q[i]);
    let rational = |p: &BigPoint3| p.coordinates.clone().map(Rational::from);
    let d = minus(b, a);
    portals.iter().all(|portal| {
        (0..portal.len()).all(|i| {
            let p = rational(&portal[i]);
            let q = rational(&portal[(i + 1) % portal.len()]);
            let (u, v) = (minus(&p, a), minus(&q, a));
            // det[b-a, p-a, q-a]: the side product of the line and the edge.
            let side = &d[0] * (&u[1] * &v[2] - &u[2] * &v[1])
                + &d[1] * (&u[2] * &v[0] - &u[0] * &v[2])
                + &d[2] * (&u[0] * &v[1] - &u[1] * &v[0]);
            side.is_positive()
        })
    })
}

#[test]
fn open_sequences_are_those_of_the_twin() {
    for family in Family::ALL {
        let mut open = 0;
        for seed in 0..count() {
            let points = sequence(family, seed);
            let portals = validated(&points);
            let refs: Vec<&Portal3> = portals.iter().collect();
            let expected = matches!(classify(&points), Truth::Open(_));
            let witness = decide_open(&refs, &[]);
            assert_eq!(witness.is_some(), expected, "{family:?} {seed}");
            if let Some(witness) = witness {
                open += 1;
                assert!(passes(&witness, &points), "{family:?} {seed}");
            }
        }
        println!("{family:?}: {open} of {} open", count());
    }
}

#[test]
fn the_reversed_sequence_has_the_reversed_witness() {
    for family in Family::ALL {
        for seed in 0..count() {
            let portals = validated(&sequence(family, seed));
            let reversed: Vec<Portal3> = portals.iter().rev().map(Portal3::reversed).collect();
            let there = decide_open(&portals.iter().collect::<Vec<_>>(), &[]);
            let back = decide_open(&reversed.iter().collect::<Vec<_>>(), &[]);
            let back = back.map(|Witness { points: [a, b] }| Witness { points: [b, a] });
            assert_eq!(there, back, "{family:?} {seed}");
        }
    }
}

#[test]
fn wide_coordinates_decide_as_narrow_ones_do() {
    // Scaled by powers of two, a sequence runs through every width up to unbounded integers.
    for family in Family::ALL {
        for seed in 0..count().min(40) {
            let points = sequence(family, seed);
            let narrow = decide_open(&validated(&points).iter().collect::<Vec<_>>(), &[]);
            for bits in [8u32, 16, 24, 32, 64] {
                // An odd shift keeps rows from shrinking again when they are made primitive.
                let scaled: Vec<Vec<BigPoint3>> = points
                    .iter()
                    .map(|portal| {
                        let scale = |c: Int| (c << bits) + 7;
                        let scale = |p: &BigPoint3| BigPoint3 {
                            coordinates: p.coordinates.clone().map(scale),
                        };
                        portal.iter().map(scale).collect()
                    })
                    .collect();
                let wide = decide_open(&validated(&scaled).iter().collect::<Vec<_>>(), &[]);
                assert_eq!(wide.is_some(), narrow.is_some(), "{family:?} {seed} << {bits}");
                assert!(wide.is_none_or(|w| passes(&w, &scaled)), "{family:?} {seed} << {bits}");
            }
        }
    }
}

/// Whether the line meets every closed portal, straight from the definition of grazing.
fn touches(line: &StabLine, portals: &[Vec<BigPoint3>]) -> bool {
    let [a, b] = &line.points;
    let zero = || Surd::from(Int::from(0));
    let minus = |p: &[Surd; 3], q: &[Surd; 3]| [0, 1, 2].map(|i| &p[i] - &q[i]);
    let cross = |p: &[Surd; 3], q: &[Surd; 3]| {
        [(1, 2), (2, 0), (0, 1)].map(|(i, j)| &(&p[i] * &q[j]) - &(&p[j] * &q[i]))
    };
    let dot = |p: &[Surd; 3], q: &[Surd; 3]| (0..3).fold(zero(), |s, i| &s + &(&p[i] * &q[i]));
    let surds = |p: &BigPoint3| p.coordinates.clone().map(Surd::from);
    let d = minus(b, a);
    assert!(d.iter().any(|c| c.sign() != Sign::Zero), "two distinct points");
    portals.iter().all(|portal| {
        let vertices: Vec<[Surd; 3]> = portal.iter().map(surds).collect();
        let arm = |i: usize| minus(&vertices[i], &vertices[0]);
        let normals = (1..vertices.len() - 1).map(|i| cross(&arm(i), &arm(i + 1)));
        let normal =
            normals.fold([zero(), zero(), zero()], |s, n| [0, 1, 2].map(|i| &s[i] + &n[i]));
        let sides: Vec<Sign> = (0..vertices.len())
            .map(|i| {
                let (p, q) = (&vertices[i], &vertices[(i + 1) % vertices.len()]);
                dot(&d, &cross(&minus(p, a), &minus(q, a))).sign()
            })
            .collect();
        match dot(&d, &normal).sign() {
            Sign::Positive => !sides.contains(&Sign::Negative),
            Sign::Negative => false,
            Sign::Zero => {
                let across = cross(&normal, &d);
                let heights: Vec<Sign> =
                    vertices.iter().map(|v| dot(&across, &minus(v, a)).sign()).collect();
                sides.iter().all(|&s| s == Sign::Zero)
                    && !heights.iter().all(|&s| s == Sign::Positive)
                    && !heights.iter().all(|&s| s == Sign::Negative)
            }
        }
    })
}

#[test]
fn verdicts_are_those_of_the_twin() {
    let mut quadrics = 0;
    for family in Family::ALL {
        let mut counts = [0; 3];
        for seed in 0..count() {
            let points = sequence(family, seed);
            let name = format!("{family:?} {seed}");
            let mut stabber = Stabber::new();
            validated(&points).iter().for_each(|portal| stabber.push(portal, false));
            let (verdict, truth) = (stabber.verdict(), classify(&points));
            let certificate = match (&verdict, &truth) {
                (Verdict::Open { witness }, Truth::Open(_)) => {
                    counts[0] += 1;
                    assert!(passes(witness, &points), "{name}");
                    continue;
                }
                (Verdict::Grazing { touching_line, certificate }, Truth::Grazing(_)) => {
                    counts[1] += 1;
                    assert!(touches(touching_line, &points), "{name}");
                    certificate
                }
                (Verdict::Blocked { certificate }, Truth::Blocked) => {
                    counts[2] += 1;
                    certificate
                }
                _ => panic!("{name}: {verdict:?}, but the twin says {truth:?}"),
            };
            if let Err(why) = certificate::check(&points, false, certificate) {
                panic!("{name}: {why}: {certificate:?}");
            }
            quadrics += tampered_are_refused(&points, certificate, &name);
            for extremal in stabber.extremal_lines() {
                assert!(touches(&extremal.line, &points), "{name}: {extremal:?}");
                assert!(extremal.edges.len() >= 4, "{name}: {extremal:?}");
            }
        }
        println!("{family:?}: {counts:?} open, grazing, blocked");
    }
    println!("{quadrics} by the quadric");
    assert!(quadrics > 10, "{quadrics}");
}

/// Changes each weight and each multiple of a quadric certificate by one, which must be noticed;
/// whether it is one.
fn tampered_are_refused(points: &[Vec<BigPoint3>], certificate: &Certificate, name: &str) -> u32 {
    let Certificate::Quadric(QuadricProof::Identity { multiple, products }) = certificate else {
        return 0;
    };
    for at in 0..=products.len() {
        let (mut multiple, mut products) = (multiple.clone(), products.clone());
        match products.get_mut(at) {
            Some(product) => product.weight += 1,
            None => multiple += 1,
        }
        let tampered = Certificate::Quadric(QuadricProof::Identity { multiple, products });
        assert!(certificate::check(points, false, &tampered).is_err(), "{name}: {at}");
    }
    1
}

/// Whether the line crosses each portal's plane strictly before the next one's, planes that are
/// one and the same excepted.
fn crosses_in_order(witness: &Witness, portals: &[Portal3]) -> bool {
    let [a, b] = &witness.points;
    let dot = |n: &[Int; 3], p: &[Rational; 3]| -> Rational { (0..3).map(|i| &p[i] * &n[i]).sum() };
    let d = [0, 1, 2].map(|i| &b[i] - &a[i]);
    let time = |p: &Portal3| {
        (Rational::from(p.offset().clone()) - dot(p.normal(), a)) / dot(p.normal(), &d)
    };
    portals.windows(2).all(|pair| {
        let same = pair[0].normal() == pair[1].normal() && pair[0].offset() == pair[1].offset();
        same || time(&pair[0]) < time(&pair[1])
    })
}

#[test]
fn ordered_witnesses_cross_in_order() {
    for family in Family::ALL {
        let mut closed_by_order = 0;
        for seed in 0..count() {
            let points = sequence(family, seed);
            let name = format!("{family:?} {seed}");
            let portals = validated(&points);
            let refs: Vec<&Portal3> = portals.iter().collect();
            let orders: Vec<bool> = (0..portals.len()).map(|i| i > 0).collect();
            let free = decide_open(&refs, &[]);
            match decide_open(&refs, &orders) {
                Some(witness) => {
                    assert!(passes(&witness, &points), "{name}");
                    assert!(crosses_in_order(&witness, &portals), "{name}");
                    assert!(free.is_some(), "{name}: an order more never opens");
                }
                None => {
                    // No line does, so the one found without the order does not keep it.
                    let kept = free.as_ref().is_some_and(|w| crosses_in_order(w, &portals));
                    assert!(!kept, "{name}");
                    closed_by_order += usize::from(free.is_some());
                    let mut stabber = Stabber::new();
                    portals.iter().enumerate().for_each(|(i, p)| stabber.push(p, i > 0));
                    let verdict = stabber.verdict();
                    if free.is_some() {
                        assert!(matches!(verdict, Verdict::Grazing { .. }), "{name}");
                    }
                }
            }
        }
        println!("{family:?}: {closed_by_order} closed by the order alone");
    }
}
