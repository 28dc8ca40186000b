//! Refuting a part of a cone by an identity, or its halves, as deep as need be.
//!
//! A part has no identity where two of its rays are *opposed*: their side product has the sign that
//! the form Q lacks on the part. A plane that may do without further splits has the rays of all
//! such pairs on different sides; there are three kinds of them, smallest numbers first.
//! - Lines through vertices of two portals.
//! - Bisectors: polars of the difference of two opposed rays, scaled to one value of Q. Where Q has
//!   a double root between the two, at z, all of these planes pass through z, as they must: side(z,
//!   ·) vanishes on both rays.
//! - Polars of opposed rays, which pass through z for the same reason.
//!
//! **Termination.** Where Q has one strict sign on the cone but for 0, deep splits halve the angle
//! between the two rays farthest apart, so that parts become narrow: had every part on an endless
//! way down two rays at an angle of at least t, then one ray of each pair would be t/2 away from
//! all that follows, which only finitely many can be. On a narrow part Q is nearly the square of a
//! form, and every such form is a combination with all products of facets in it. Where Q has zeros,
//! which lie on rays and edges of the cone, no proof is known.

use super::identity::{exact_identity, identity};
use super::part::{Part, Shape};
use super::{QuadricProof, through};
use crate::num::{Int, Sign};
use crate::stab::cone::dot;
use crate::stab::quadric::Vector;
use crate::stab::sequence::Portal3;
use crate::stab::witness::{bits, moved, primitive};
use num_traits::Signed;

/// Planes of each kind that are tried before one is taken whose halves need splits of their own.
const MOST_PLANES: usize = 8;

/// From this depth on, parts are made narrow whatever the form is on them.
const DEEP: usize = 6;

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
    let refuted = |plane: Plane| {
        let half = |positive: bool| {
            let half = part.half(&plane.vector, depth, positive);
            let shape = half.shape();
            identity(&half, &shape)
        };
        let positive = half(true)?;
        let negative = half(false)?;
        Some(joined(plane, positive, negative))
    };
    let separating = |planes: Vec<Plane>| {
        let clean = planes.into_iter().filter(|plane| separated(plane, &apart) == apart.len());
        clean.take(MOST_PLANES).find_map(refuted)
    };
    let found = separating(vertex_lines(part, shape, portals))
        .or_else(|| separating(bisectors(part, shape, &apart)))
        .or_else(|| separating(polars(part, shape, &apart)))
        // What floats may have overlooked.
        .or_else(|| exact_identity(part, shape));
    if let Some(proof) = found {
        return proof;
    }
    let bisector = bisectors(part, shape, &apart).into_iter().next().filter(|_| depth < DEEP);
    let plane = bisector.unwrap_or_else(|| halving(part, shape));
    let half = |positive: bool| {
        let half = part.half(&plane.vector, depth, positive);
        let shape = half.shape();
        identity(&half, &shape).unwrap_or_else(|| split(&half, &shape, portals, depth + 1))
    };
    let (positive, negative) = (half(true), half(false));
    joined(plane, positive, negative)
}

fn joined(plane: Plane, positive: QuadricProof, negative: QuadricProof) -> QuadricProof {
    let Plane { vector: plane, .. } = plane;
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
    vectors.into_iter().map(|vector| plane(part, shape, vector)).filter(cuts).collect()
}

/// The polars `side(r, x) = 0` of the rays that are opposed to another.
fn polars(part: &Part, shape: &Shape<'_>, apart: &[[usize; 2]]) -> Vec<Plane> {
    let mut rays: Vec<usize> = apart.iter().flatten().copied().collect();
    rays.sort_unstable();
    rays.dedup();
    rays.into_iter().map(|k| polar(part, shape, &shape.rays[k])).filter(cuts).collect()
}

/// Polars of differences of opposed rays, the most opposed first.
fn bisectors(part: &Part, shape: &Shape<'_>, apart: &[[usize; 2]]) -> Vec<Plane> {
    let mut ranked: Vec<(Int, [usize; 2])> = apart
        .iter()
        .map(|&[k, l]| {
            let along = &shape.sides[k][l];
            // The square of what would be a cosine, on a scale that tells it from most others.
            let square: Int = ((along * along) << 64) / (&shape.sides[k][k] * &shape.sides[l][l]);
            (-square, [k, l])
        })
        .collect();
    ranked.sort();
    ranked.truncate(2 * MOST_PLANES);
    let bisector = |(_, [k, l]): (Int, [usize; 2])| {
        let factors = levelling(&shape.sides[k][k], &shape.sides[l][l]);
        polar(part, shape, &difference([&shape.rays[k], &shape.rays[l]], &factors))
    };
    ranked.into_iter().map(bisector).filter(cuts).collect()
}

/// Small u and v with u² a about v² b, for positive a and b.
fn levelling(a: &Int, b: &Int) -> [Int; 2] {
    let twice = 14 + a.bits() as i64 - b.bits() as i64;
    let (up, down) = ((twice / 2).max(0) as u64, (-twice / 2).max(0) as u64);
    let ratio = ((b << (2 * up)) / (a << (2 * down))).sqrt();
    [ratio << down, Int::from(1) << up]
}

/// The plane in the middle between the two rays that are farthest apart.
fn halving(part: &Part, shape: &Shape<'_>) -> Plane {
    let longest = shape.rays.iter().map(bits).max().unwrap_or(0);
    let levelled = |ray: &Vector| ray.each_ref().map(|c| c << (longest - bits(ray)));
    let rays: Vec<Vector> = shape.rays.iter().map(levelled).collect();
    let product = |k: usize, l: usize| dot::<Int>(&rays[k], &rays[l]);
    let pairs = (0..rays.len()).flat_map(|k| (0..k).map(move |l| [k, l]));
    let squares: Vec<Int> = (0..rays.len()).map(|k| product(k, k)).collect();
    // cos |cos| of the angle, as a fraction.
    let cosine = |&[k, l]: &[usize; 2]| {
        let along = product(k, l);
        (&along * along.abs(), &squares[k] * &squares[l])
    };
    let farthest = pairs.map(|pair| (pair, cosine(&pair)));
    let farthest = farthest.min_by(|(_, (a, b)), (_, (c, d))| (a * d).cmp(&(c * b)));
    let ([k, l], _) = farthest.expect("a pointed cone has six rays or more");
    // With r r, s s and r s the products of the two, D = rr ss - rs rs > 0, the form is D on r and
    // -D on s.
    let along = product(k, l);
    let form = difference([&rays[k], &rays[l]], &[&squares[l] + &along, &squares[k] + &along]);
    let [a, b, c, d, e, f] = form;
    polar(part, shape, &[d, e, f, a, b, c])
}

/// u r - v s.
fn difference([r, s]: [&Vector; 2], [u, v]: &[Int; 2]) -> Vector {
    std::array::from_fn(|i| u * &r[i] - v * &s[i])
}

/// The plane `side(pole, x) = 0` of a vector of the part's frame.
fn polar(part: &Part, shape: &Shape<'_>, pole: &Vector) -> Plane {
    let on_grid = part.frame().on_grid(pole);
    plane(part, shape, primitive(moved(&on_grid, part.frame().origin())))
}

/// The plane `side(x, vector) = 0` of a vector in grid units.
fn plane(part: &Part, shape: &Shape<'_>, vector: Vector) -> Plane {
    let (form, _) = part.frame().form(&vector);
    let side = |ray: &Vector| Sign::of(&dot::<Int>(ray, &form));
    Plane { sides: shape.rays.iter().map(side).collect(), vector }
}

fn cuts(plane: &Plane) -> bool {
    [Sign::Positive, Sign::Negative].iter().all(|sign| plane.sides.contains(sign))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::oracle::{Family, sequence};
    use crate::stab::certificate::conditions;
    use crate::stab::sequence::Frame;

    /// The plane that deep splits fall back to has the two rays that are farthest apart, and so
    /// some ray each, on its sides.
    #[test]
    fn the_halving_plane_cuts_every_part() {
        let mut cut = 0;
        for family in Family::ALL {
            for seed in 0..40 {
                let portals = sequence(family, seed);
                let portals: Vec<Portal3> =
                    portals.iter().map(|points| Portal3::new(points).unwrap()).collect();
                let portals: Vec<&Portal3> = portals.iter().collect();
                let frame = Frame::about(&portals[0].vertices()[0].coordinates);
                let Some(mut part) = Part::whole(&conditions(&portals, &[]), &frame) else {
                    continue;
                };
                for depth in 0..3 {
                    if part.shape().rays.len() < 6 {
                        break;
                    }
                    let plane = halving(&part, &part.shape());
                    assert!(cuts(&plane), "{family:?} {seed}");
                    part = part.half(&plane.vector, depth, seed % 2 == 0);
                    cut += 1;
                }
            }
        }
        assert!(cut > 100, "{cut} parts say little");
    }
}
