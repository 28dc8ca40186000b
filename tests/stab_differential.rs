//! The stabber against the brute-force twin, on every family of sequences.
//!
//! `STABLINE_SEQUENCES=N` sets the number of sequences a family (default 150).

use num_traits::Signed;
use stabline::geom::BigPoint3;
use stabline::num::{Int, Rational};
use stabline::oracle::{Family, Truth, classify, sequence};
use stabline::stab::{Portal3, Witness, decide_open};

fn count() -> u64 {
    std::env::var("STABLINE_SEQUENCES").ok().and_then(|n| n.parse().ok()).unwrap_or(150)
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
