//! Why a sequence is not open, for whoever wants to check it.
//!
//! Where no vector of R^6 is strictly inside all half-spaces, there are non-negative weights, not
//! all zero, with which the rows sum to zero (Gordan 1873), at most seven of them positive
//! (Carathéodory). They are found as a basic solution of `Σ λ_k a_k = 0, Σ λ_k = 1` by the simplex
//! method with exact rationals and Bland's rule (1977), which cannot cycle. Otherwise the Klein
//! quadric keeps one weak sign on the cone, and its rays and edges are listed with their signs.

use super::engine::{Engine, Range};
use super::extremal::EdgeName;
use super::quadric::{Vector, quadric, side};
use super::sequence::Portal3;
use super::witness::{moved, primitive};
use crate::num::{Int, Rational, Sign};
use num_integer::Integer;
use num_traits::{One, Signed, Zero};

/// Why no line is strictly inside a sequence.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Certificate {
    /// The weighted sum of these conditions' Plücker vectors is zero, so they cannot all be
    /// positive on one vector.
    Gordan(Vec<Term>),
    /// A multiple of the Klein form is a combination of products of the conditions' sides that is
    /// positive where they all are.
    Quadric(QuadricProof),
    /// The Klein quadric does not take both strict signs on the cone of the half-spaces.
    Cone(ConeSigns),
}

/// Why no line is strictly inside a sequence, or inside a part of R^6 that enclosing splits leave.
///
/// Let x be a vector on the strict side of every condition and on the weak side of every enclosing
/// split. Each variant contradicts Q(x) = d·m = 0. All vectors are whole Plücker vectors in grid
/// units about the grid's origin.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum QuadricProof {
    /// `Σ weight · factor(x) · factor(x) = multiple · Q(x)` for all x of R^6; at least one product is
    /// of two conditions. The numbers have no common factor.
    Identity {
        /// Not zero.
        multiple: Int,
        /// At most 21.
        products: Vec<Product>,
    },
    /// `Σ weight · factor(x) = 0` for all x of R^6; at least one factor is a condition. The weights
    /// are positive and have no common factor.
    Linear {
        /// At most seven.
        terms: Vec<(Factor, Int)>,
    },
    /// Either half of the part has a proof of its own.
    Split {
        /// A vector h (direction, moment), primitive: the halves are side(x, h) >= 0 and <= 0.
        plane: [Int; 6],
        /// The proof where side(x, h) >= 0.
        positive: Box<QuadricProof>,
        /// The proof where side(x, h) <= 0.
        negative: Box<QuadricProof>,
    },
}

/// A weighted product of two linear forms, neither of which is negative.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Product {
    /// The two, which may be one and the same; in ascending order.
    pub factors: [Factor; 2],
    /// Positive.
    pub weight: Int,
}

/// A linear form of R^6.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Factor {
    /// side(x, e) with the vector e of the condition.
    Condition(Condition),
    /// side(x, h) with the plane h of the enclosing split of this depth, the outermost being 0; in
    /// the split's negative part, -side(x, h).
    Split(usize),
}

/// A condition of a sequence, with its weight.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Term {
    /// The condition.
    pub condition: Condition,
    /// Positive; the weights have no common factor.
    pub weight: Int,
}

/// One half-space of a sequence's cone.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Condition {
    /// The line passes this edge on its positive side. The vector is the edge's, from one vertex
    /// to the next.
    Edge(EdgeName),
    /// The line crosses this portal's plane after that of the portal before it. The vector is the
    /// meet of the planes: (n1 × n2, c2 n1 - c1 n2) with primitive normals in grid units.
    Order {
        /// The later portal.
        portal: usize,
    },
}

/// A cone by its generators, with the signs of the Klein quadric.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ConeSigns {
    /// The extreme rays as (direction, moment), primitive, in grid units; and the quadric's sign.
    pub rays: Vec<(Vector, Sign)>,
    /// Pairs of adjacent rays, and the strict sign that the quadric takes somewhere between them:
    /// the same for all; zero where it vanishes on the whole edge.
    pub edges: Vec<([usize; 2], Sign)>,
}

/// Requires: the sequence, with the order of the portals flagged, is not open.
pub(super) fn of_not_open(portals: &[&Portal3], orders: &[bool]) -> Certificate {
    let origin = portals[0].vertices()[0].coordinates.clone();
    let conditions = conditions(portals, orders, &origin);
    let rows: Vec<&Vector> = conditions.iter().map(|(_, row, _)| row).collect();
    match relation(&rows) {
        Some(weights) => Certificate::Gordan(terms(&conditions, &weights)),
        None => Certificate::Cone(cone_signs(&rows, &origin)),
    }
}

/// All half-spaces: what each is, its row, and what the row was divided by.
fn conditions(
    portals: &[&Portal3],
    orders: &[bool],
    origin: &[Int; 3],
) -> Vec<(Condition, Vector, Int)> {
    let mut all = Vec::new();
    for (index, portal) in portals.iter().enumerate() {
        for edge in 0..portal.vertices().len() {
            let name = Condition::Edge(EdgeName { portal: index, edge });
            all.push((name, portal.edge_row(edge, origin), portal.edge_length(edge).clone()));
        }
        let ordered = index > 0 && orders.get(index).copied().unwrap_or(false);
        let order = ordered.then(|| portals[index - 1].order_row(portal, origin)).flatten();
        all.extend(order.map(|(row, content)| (Condition::Order { portal: index }, row, content)));
    }
    all
}

/// The weights for the whole vectors from those for the divided rows.
fn terms(conditions: &[(Condition, Vector, Int)], weights: &[(usize, Rational)]) -> Vec<Term> {
    let whole: Vec<(Condition, Rational)> = weights
        .iter()
        .map(|(index, weight)| {
            let (name, _, divisor) = &conditions[*index];
            (*name, weight / divisor)
        })
        .collect();
    let common = whole.iter().fold(Int::one(), |c, (_, w)| c.lcm(w.denom()));
    let content =
        whole.iter().fold(Int::zero(), |g, (_, w)| g.gcd(&(w.numer() * (&common / w.denom()))));
    let scaled = |w: &Rational| w.numer() * (&common / w.denom()) / &content;
    whole.iter().map(|(name, w)| Term { condition: *name, weight: scaled(w) }).collect()
}

/// Positive weights, by index, with which the rows sum to zero; `None` where there are none.
fn relation(rows: &[&Vector]) -> Option<Vec<(usize, Rational)>> {
    // Row r < 6 of the tableau: Σ λ_k a_k[r] = 0; row 6: Σ λ_k = 1. One artificial variable each,
    // which leaves for good; column `count` is the right side.
    let count = rows.len();
    let mut tableau: Vec<Vec<Rational>> = (0..7)
        .map(|r| {
            let entry = |k: usize| match (r, k < count) {
                (6, _) => Rational::one(),
                (_, true) => Rational::from(rows[k][r].clone()),
                (_, false) => Rational::zero(),
            };
            (0..=count).map(entry).collect()
        })
        .collect();
    let mut basis: Vec<usize> = (0..7).map(|r| count + r).collect();
    let gain = |tableau: &[Vec<Rational>], basis: &[usize], k: usize| -> Rational {
        (0..7).filter(|&r| basis[r] >= count).map(|r| &tableau[r][k]).sum()
    };
    while let Some(k) = (0..count).find(|&k| gain(&tableau, &basis, k).is_positive()) {
        let leaving = (0..7)
            .filter(|&r| tableau[r][k].is_positive())
            .min_by_key(|&r| (&tableau[r][count] / &tableau[r][k], basis[r]))?;
        pivot(&mut tableau, leaving, k);
        basis[leaving] = k;
    }
    if gain(&tableau, &basis, count).is_positive() {
        return None;
    }
    let mut weights: Vec<(usize, Rational)> = (0..7)
        .filter(|&r| basis[r] < count && tableau[r][count].is_positive())
        .map(|r| (basis[r], tableau[r][count].clone()))
        .collect();
    weights.sort_by_key(|(index, _)| *index);
    Some(weights)
}

fn pivot(tableau: &mut [Vec<Rational>], row: usize, column: usize) {
    let divisor = tableau[row][column].clone();
    tableau[row].iter_mut().filter(|c| !c.is_zero()).for_each(|c| *c /= &divisor);
    let pivot_row = tableau[row].clone();
    for (r, line) in tableau.iter_mut().enumerate() {
        let factor = line[column].clone();
        if r != row && !factor.is_zero() {
            for (entry, p) in line.iter_mut().zip(&pivot_row).filter(|(_, p)| !p.is_zero()) {
                *entry -= &factor * p;
            }
        }
    }
}

fn cone_signs(rows: &[&Vector], origin: &[Int; 3]) -> ConeSigns {
    let range = Range::default().with(rows.iter().copied());
    let mut engine = Engine::everything().widened_for(range);
    for row in rows {
        engine.push(row);
    }
    let vectors = engine.rays();
    let whole = |ray: &Vector| (primitive(moved(ray, origin)), Sign::of(&quadric(ray)));
    // Q(u r + v s) = (G_rr u² + 2 G_rs u v + G_ss v²) / 2, of one weak sign: zero everywhere iff
    // all three are.
    let between = |[i, j]: [usize; 2]| {
        let (r, s) = (&vectors[i], &vectors[j]);
        let values = [side(r, r), side(s, s), side(r, s)];
        values.iter().map(Sign::of).find(|&sign| sign != Sign::Zero).unwrap_or(Sign::Zero)
    };
    ConeSigns {
        rays: vectors.iter().map(whole).collect(),
        edges: engine.faces().into_iter().map(|pair| (pair, between(pair))).collect(),
    }
}
