//! Why a sequence is not open, for whoever wants to check it.
//!
//! Where no vector of R^6 is strictly inside all half-spaces, there are non-negative weights, not
//! all zero, with which the vectors of the conditions sum to zero (Gordan 1873), at most seven of
//! them positive (Carathéodory). Otherwise the Klein quadric keeps one weak sign on the cone of the
//! half-spaces, and some multiple of its form is a combination of products of two of them, if need
//! be in parts of the cone (`splits`).

mod gordan;
mod identity;
mod linear;
mod part;
mod splits;

use super::extremal::EdgeName;
use super::line::meet_of_planes;
use super::quadric::Vector;
use super::sequence::{Frame, Portal3};
use crate::geom::vector::{cross, difference};
use crate::num::{Int, Rational};
use num_integer::Integer;
use num_traits::{One, Zero};
use part::Part;

/// Why no line is strictly inside a sequence.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Certificate {
    /// The weighted sum of these conditions' Plücker vectors is zero, so they cannot all be
    /// positive on one vector.
    Gordan(Vec<Term>),
    /// A multiple of the Klein form is a combination of products of the conditions' sides that is
    /// positive where they all are.
    Quadric(QuadricProof),
}

/// Why no line is strictly inside a sequence, or inside a part of R^6 that enclosing splits leave.
///
/// Let x be a vector on the strict side of every condition and on the weak side of every enclosing
/// split. Each variant contradicts Q(x) = d·m = 0. All vectors are whole Plücker vectors in grid
/// units about the grid's origin.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum QuadricProof {
    /// `Σ weight · factor(x) · factor(x) = multiple · Q(x)` for all x of R^6; at least one product
    /// is of two conditions. The numbers have no common factor.
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

/// Why no line is strictly inside a sequence that is not open.
///
/// `orders[i]` asks that portal `i` be crossed after portal `i - 1`; missing entries ask nothing.
/// Numbers are short inside where `unit` is as many grid units as the vertices are multiples of.
///
/// Requires: the sequence is not open.
pub fn certificate(portals: &[&Portal3], orders: &[bool], unit: &Int) -> Certificate {
    if let Some(terms) = gordan::proposed(portals, orders) {
        return Certificate::Gordan(terms);
    }
    let conditions = conditions(portals, orders);
    let frame = Frame::near(&portals[0].vertices()[0].coordinates, unit);
    match Part::whole(&conditions, &frame) {
        None => Certificate::Gordan(gordan::exact(&conditions)),
        Some(part) => Certificate::Quadric(splits::refute(&part, portals)),
    }
}

/// All conditions with their whole vectors, in grid units about the grid's origin.
fn conditions(portals: &[&Portal3], orders: &[bool]) -> Vec<(Condition, Vector)> {
    let mut all = Vec::new();
    for (index, portal) in portals.iter().enumerate() {
        for edge in 0..portal.vertices().len() {
            all.push((
                Condition::Edge(EdgeName { portal: index, edge }),
                edge_vector(portal, edge),
            ));
        }
        if let Some(vector) = order_vector(portals, orders, index) {
            all.push((Condition::Order { portal: index }, vector));
        }
    }
    all
}

/// The vector of an edge, from its first vertex to the next.
fn edge_vector(portal: &Portal3, edge: usize) -> Vector {
    let vertices = portal.vertices();
    through(&vertices[edge].coordinates, &vertices[(edge + 1) % vertices.len()].coordinates)
}

/// (q - p, p × q).
fn through(p: &[Int; 3], q: &[Int; 3]) -> Vector {
    let ([dx, dy, dz], [mx, my, mz]) = (difference(q, p), cross(p, q));
    [dx, dy, dz, mx, my, mz]
}

/// The vector of a portal's order, where it is asked for and the planes differ.
fn order_vector(portals: &[&Portal3], orders: &[bool], index: usize) -> Option<Vector> {
    let asked = index > 0 && orders.get(index).copied().unwrap_or(false);
    let vector = meet_of_planes(portals[index.checked_sub(1)?], portals[index]);
    (asked && vector.iter().any(|c| !c.is_zero())).then_some(vector)
}

/// The numbers, which are not all zero, times a positive factor that makes them integers without
/// a common factor.
fn in_lowest_terms(values: &[Rational]) -> Vec<Int> {
    let common = values.iter().fold(Int::one(), |c, v| c.lcm(v.denom()));
    let whole: Vec<Int> = values.iter().map(|v| v.numer() * (&common / v.denom())).collect();
    let content = whole.iter().fold(Int::zero(), |g, v| g.gcd(v));
    whole.into_iter().map(|v| v / &content).collect()
}
