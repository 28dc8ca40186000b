//! Conditions of a sequence that seem to exclude each other.

use super::norm::{Half, NormPoint, Outcome, dot};
use crate::geom::vector::{cross, difference};
use crate::num::Int;
use crate::stab::certificate::Condition;
use crate::stab::extremal::EdgeName;
use crate::stab::quadric::Vector;
use crate::stab::sequence::Portal3;
use crate::stab::witness::moved;
use num_traits::ToPrimitive;

/// A column that is shorter than this beside the others is taken for their combination.
const NOTHING: f64 = 1e-12;

/// At most seven conditions that seem to have no common inside; `None` if the sequence seems to
/// have one. `order` gives the vector of a portal's order, if there is one.
pub(in crate::stab) fn excluding(
    portals: &[&Portal3],
    order: &impl Fn(usize) -> Option<Vector>,
) -> Option<Vec<Condition>> {
    let origin = &portals[0].vertices()[0].coordinates;
    let back = origin.each_ref().map(|c| -c);
    let (mut names, mut halves) = (Vec::new(), Vec::new());
    for (index, portal) in portals.iter().enumerate() {
        let near = |v: &[Int; 3]| difference(v, origin).map(|c| c.to_f64().unwrap_or(f64::NAN));
        let points: Vec<[f64; 3]> =
            portal.vertices().iter().map(|v| near(&v.coordinates)).collect();
        for (edge, p) in points.iter().enumerate() {
            let q = &points[(edge + 1) % points.len()];
            let ([dx, dy, dz], [mx, my, mz]) = (difference(q, p), cross(p, q));
            names.push(Condition::Edge(EdgeName { portal: index, edge }));
            halves.push([dx, dy, dz, mx, my, mz]);
        }
        if let Some(vector) = order(index) {
            names.push(Condition::Order { portal: index });
            halves.push(moved(&vector, &back).map(|c| c.to_f64().unwrap_or(f64::NAN)));
        }
    }
    level(&mut halves);
    if halves.iter().flatten().any(|c| !c.is_finite()) {
        return None;
    }
    match NormPoint::default().search(&halves, false) {
        Outcome::Inside(_) => None,
        Outcome::Excluded(indices) => Some(indices.iter().map(|&i| names[i as usize]).collect()),
    }
}

/// Chooses coordinates of R^6 in which the half-spaces point everywhere alike, and makes them of
/// norm one: thin cones grow wide, and dependencies of the half-spaces stay what they are but for
/// positive factors.
fn level(halves: &mut [Half]) {
    halves.iter_mut().for_each(normalise);
    // Gram's and Schmidt's orthogonal columns, twice for full precision.
    for column in 0..6 {
        let length =
            |halves: &[Half]| halves.iter().map(|h| h[column] * h[column]).sum::<f64>().sqrt();
        let whole = length(halves);
        for _ in 0..2 {
            for before in 0..column {
                let along: f64 = halves.iter().map(|h| h[before] * h[column]).sum();
                halves.iter_mut().for_each(|h| h[column] -= along * h[before]);
            }
        }
        let rest = length(halves);
        let factor = if rest > NOTHING * whole { 1.0 / rest } else { 0.0 };
        halves.iter_mut().for_each(|h| h[column] *= factor);
    }
    halves.iter_mut().for_each(normalise);
}

fn normalise(half: &mut Half) {
    let norm = dot(half, half).sqrt();
    half.iter_mut().for_each(|c| *c /= norm);
}
