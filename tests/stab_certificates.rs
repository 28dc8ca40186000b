//! Certificates of sequences that the quadric shuts, with and without splits, with and without
//! orders: each holds by another argument, and none that was tampered with does.

mod support;

use stabline::geom::BigPoint3;
use stabline::num::Int;
use stabline::oracle::{Family, sequence};
use stabline::stab::{Certificate, Factor, Portal3, QuadricProof, certificate, decide_open};
use support::certificate::check;

/// The certificate of a sequence, checked; `None` where the sequence is open.
fn checked(points: &[Vec<BigPoint3>], ordered: bool, name: &str) -> Option<Certificate> {
    let portals: Vec<Portal3> = points.iter().map(|p| Portal3::new(p).unwrap()).collect();
    let portals: Vec<&Portal3> = portals.iter().collect();
    let orders: Vec<bool> = (0..portals.len()).map(|i| ordered && i > 0).collect();
    if decide_open(&portals, &orders).is_some() {
        return None;
    }
    let certificate = certificate(&portals, &orders, &Int::from(1));
    if let Err(why) = check(points, ordered, &certificate) {
        panic!("{name}: {why}: {certificate:?}");
    }
    Some(certificate)
}

fn splits(proof: &QuadricProof) -> usize {
    match proof {
        QuadricProof::Identity { .. } | QuadricProof::Linear { .. } => 0,
        QuadricProof::Split { positive, negative, .. } => 1 + splits(positive) + splits(negative),
    }
}

/// The proofs that differ from this one in one weight, plane, multiple or half, or lack one
/// product, or name a split that is not there.
fn tampered(proof: &QuadricProof) -> Vec<QuadricProof> {
    let mut all = Vec::new();
    match proof {
        QuadricProof::Identity { multiple, products } => {
            let mut with = |change: &dyn Fn(&mut Int, &mut Vec<_>)| {
                let (mut multiple, mut products) = (multiple.clone(), products.clone());
                change(&mut multiple, &mut products);
                all.push(QuadricProof::Identity { multiple, products });
            };
            with(&|multiple, _| *multiple += 1);
            with(&|multiple, _| *multiple = -&*multiple);
            for at in 0..products.len() {
                with(&|_, products| products[at].weight += 1);
                with(&|_, products| products[at].weight = -&products[at].weight);
                with(&|_, products| products[at].factors[0] = Factor::Split(9));
                with(&|_, products| {
                    products.remove(at);
                });
            }
        }
        QuadricProof::Linear { .. } => {}
        QuadricProof::Split { plane, positive, negative } => {
            let joined = |plane: &[Int; 6], positive: &QuadricProof, negative: &QuadricProof| {
                let (positive, negative) = (positive.clone().into(), negative.clone().into());
                QuadricProof::Split { plane: plane.clone(), positive, negative }
            };
            for at in 0..6 {
                let mut moved = plane.clone();
                moved[at] += 1;
                all.push(joined(&moved, positive, negative));
            }
            all.push(joined(plane, negative, positive));
            all.extend(tampered(positive).iter().map(|half| joined(plane, half, negative)));
            all.extend(tampered(negative).iter().map(|half| joined(plane, positive, half)));
        }
    }
    all
}

fn tampered_are_refused(
    points: &[Vec<BigPoint3>],
    ordered: bool,
    proof: &QuadricProof,
    name: &str,
) {
    for (index, other) in tampered(proof).into_iter().enumerate() {
        let other = Certificate::Quadric(other);
        assert!(check(points, ordered, &other).is_err(), "{name}, change {index}: {other:?}");
    }
}

/// Among them one whose rays are in two groups of sixteen, each ray opposed to all of the other
/// group, so that no vertex line and no polar splits it for good.
#[test]
fn slits_are_split_where_rays_are_opposed() {
    let mut split = 0;
    for seed in 0..250 {
        let name = format!("slit {seed}");
        let points = sequence(Family::Slit, seed);
        if let Some(Certificate::Quadric(proof)) = checked(&points, false, &name)
            && splits(&proof) > 0
        {
            split += 1;
            tampered_are_refused(&points, false, &proof, &name);
        }
    }
    println!("{split} split");
    assert!(split > 2, "{split}");
}

#[test]
fn orders_may_be_factors() {
    let (mut quadrics, mut with_order) = (0, 0);
    for family in Family::ALL {
        for seed in 0..40 {
            let name = format!("{family:?} {seed}");
            let points = sequence(family, seed);
            if let Some(Certificate::Quadric(proof)) = checked(&points, true, &name) {
                quadrics += 1;
                with_order += usize::from(format!("{proof:?}").contains("Order"));
                tampered_are_refused(&points, true, &proof, &name);
            }
        }
    }
    println!("{quadrics} by the quadric, {with_order} with an order");
    assert!(quadrics > 20 && with_order > 0, "{quadrics}, {with_order}");
}

/// In units as coarse as the vertices the proof is the same but for its numbers' names: it holds on
/// the fine grid.
#[test]
fn coarse_units_change_no_proof_of_its_right() {
    let mut quadrics = 0;
    for seed in 0..150 {
        let unit = Int::from(1000);
        let mut points = sequence(Family::Collinear, seed);
        let scale = |p: &mut BigPoint3| p.coordinates.iter_mut().for_each(|c| *c *= &unit);
        points.iter_mut().flatten().for_each(scale);
        let portals: Vec<Portal3> = points.iter().map(|p| Portal3::new(p).unwrap()).collect();
        let portals: Vec<&Portal3> = portals.iter().collect();
        if decide_open(&portals, &[]).is_none() {
            let certificate = certificate(&portals, &[], &unit);
            assert_eq!(check(&points, false, &certificate), Ok(()), "{seed}: {certificate:?}");
            quadrics += usize::from(matches!(certificate, Certificate::Quadric(_)));
        }
    }
    assert!(quadrics > 2, "{quadrics}");
}
