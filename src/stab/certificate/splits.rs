//! Refuting a part of a cone by an identity, or its halves, as deep as need be.

use super::identity::identity;
use super::part::{Part, Shape};
use super::{QuadricProof, through};
use crate::num::{Int, Sign};
use crate::stab::cone::dot;
use crate::stab::quadric::Vector;
use crate::stab::sequence::Portal3;
use crate::stab::witness::{moved, primitive};
use num_traits::Signed;

/// Planes that are tried before one is taken whose halves need splits of their own.
const MOST_PLANES: usize = 24;

/// A plane that might split a part, with its sides of the part's rays.
struct Plane {
    vector: Vector,
    sides: Vec<Sign>,
}

/// The proof that no line is strictly inside the cone of a sequence.
pub(super) fn refute(part: &Part, portals: &[&Portal3]) -> QuadricProof {
    let shape = part.shape();
    identity(part, &shape).unwrap_or_else(|| split(part, &shape, portals, 0))
}

fn split(part: &Part, shape: &Shape<'_>, portals: &[&Portal3], depth: usize) -> QuadricProof {
    let apart = opposed(shape);
    let lines = vertex_lines(part, shape, portals);
    let polars = polars(part, shape, &apart);
    let separates = |plane: &&Plane| separated(plane, &apart) == apart.len();
    let candidates = lines.iter().chain(&polars).filter(separates).take(MOST_PLANES);
    for plane in candidates {
        let half = |positive: bool| {
            let half = part.half(&plane.vector, depth, positive);
            let shape = half.shape();
            identity(&half, &shape)
        };
        if let Some(positive) = half(true)
            && let Some(negative) = half(false)
        {
            return joined(plane, positive, negative);
        }
    }
    let best = polars.iter().max_by_key(|plane| separated(plane, &apart));
    let best = best.or_else(|| lines.first()).expect("a pointed cone has a plane that splits it");
    let half = |positive: bool| {
        let half = part.half(&best.vector, depth, positive);
        let shape = half.shape();
        identity(&half, &shape).unwrap_or_else(|| split(&half, &shape, portals, depth + 1))
    };
    joined(best, half(true), half(false))
}

fn joined(plane: &Plane, positive: QuadricProof, negative: QuadricProof) -> QuadricProof {
    let plane = plane.vector.clone();
    QuadricProof::Split { plane, positive: Box::new(positive), negative: Box::new(negative) }
}

/// The pairs of rays whose side product has the sign that the form lacks on the part.
fn opposed(shape: &Shape<'_>) -> Vec<[usize; 2]> {
    let pairs = (0..shape.rays.len()).flat_map(|k| (0..k).map(move |l| [k, l]));
    pairs.filter(|&[k, l]| shape.sides[k][l].is_negative()).collect()
}

/// How many of the pairs have their rays on different sides of the plane.
fn separated(plane: &Plane, pairs: &[[usize; 2]]) -> usize {
    let opposite =
        |&&[k, l]: &&[usize; 2]| plane.sides[k] != Sign::Zero && plane.sides[k] == -plane.sides[l];
    pairs.iter().filter(opposite).count()
}

/// The lines through vertices of two portals that have rays on either side.
fn vertex_lines(part: &Part, shape: &Shape<'_>, portals: &[&Portal3]) -> Vec<Plane> {
    let mut vectors: Vec<Vector> = Vec::new();
    for (index, portal) in portals.iter().enumerate() {
        for other in &portals[..index] {
            for p in other.vertices() {
                for q in portal.vertices().iter().filter(|q| *q != p) {
                    vectors.push(primitive(through(&p.coordinates, &q.coordinates)));
                }
            }
        }
    }
    vectors.sort();
    vectors.dedup();
    let plane = |vector: Vector| {
        let (form, _) = part.frame().form(&vector);
        let side = |ray: &Vector| Sign::of(&dot::<Int>(ray, &form));
        Plane { sides: shape.rays.iter().map(side).collect(), vector }
    };
    vectors.into_iter().map(plane).filter(cuts).collect()
}

/// The polars `side(r, x) = 0` of the rays that are opposed to another.
fn polars(part: &Part, shape: &Shape<'_>, apart: &[[usize; 2]]) -> Vec<Plane> {
    let mut rays: Vec<usize> = apart.iter().flatten().copied().collect();
    rays.sort_unstable();
    rays.dedup();
    let polar = |k: usize| {
        let on_grid = part.frame().on_grid(&shape.rays[k]);
        let vector = primitive(moved(&on_grid, part.frame().origin()));
        let side = |l: usize| Sign::of(&shape.sides[k.max(l)][k.min(l)]) * shape.sign;
        Plane { vector, sides: (0..shape.rays.len()).map(side).collect() }
    };
    rays.into_iter().map(polar).filter(cuts).collect()
}

fn cuts(plane: &Plane) -> bool {
    [Sign::Positive, Sign::Negative].iter().all(|sign| plane.sides.contains(sign))
}
