//! Closed portals as touching lines are checked against them: every condition is the sign of one
//! row, computed once.
//!
//! A line touches a portal iff it crosses its plane forward with no edge's side negative, or lies
//! in its plane and does not have all vertices strictly on one side. Rows and lines are taken
//! relative to the origin of the grid. Where both are small enough, their product is computed in
//! 128 bits: with entries below 2^r and 2^l, six products sum to less than 2^(r + l + 3).

use super::quadric::Vector;
use super::sequence::Portal3;
use crate::geom::vector::cross;
use crate::num::Int;
use num_traits::ToPrimitive;

/// A vector, and its entries in 128 bits with a bound of their bits, where they fit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Row {
    pub(super) vector: Vector,
    small: Option<([i128; 6], u64)>,
}

impl Row {
    pub(super) fn new(vector: Vector) -> Row {
        let bits = vector.iter().map(Int::bits).max().unwrap_or(0);
        let small = (bits < 124)
            .then(|| (vector.each_ref().map(|c| c.to_i128().expect("below 2^124")), bits));
        Row { vector, small }
    }

    /// The product of two rows in 128 bits, if it is sure to fit.
    pub(super) fn small_product(&self, other: &Row) -> Option<i128> {
        let ((a, r), (b, l)) = (self.small.as_ref()?, other.small.as_ref()?);
        (r + l + 3 <= 127).then(|| a.iter().zip(b).map(|(a, b)| a * b).sum())
    }
}

/// A portal with the rows that say whether a line touches it.
#[derive(Clone, Debug)]
pub struct ClosedPortal {
    pub(super) portal: Portal3,
    /// The line's direction times the normal.
    pub(super) slope: Row,
    /// The sides of the edges.
    pub(super) edges: Vec<Row>,
    /// For a line in the plane, the sides of the vertices.
    pub(super) vertices: Vec<Row>,
}

impl ClosedPortal {
    /// The portal with its boundary.
    pub fn new(portal: &Portal3) -> ClosedPortal {
        let origin = [Int::ZERO, Int::ZERO, Int::ZERO];
        let edge = |edge| Row::new(portal.edge_row(edge, &origin));
        let [a, b, c] = portal.normal();
        let nothing = || Int::ZERO;
        let slope = Row::new([a.clone(), b.clone(), c.clone(), nothing(), nothing(), nothing()]);
        // (n × d)·(v - p) = (v × n)·d + n·m for any point p of the line.
        let vertices = portal.vertices().iter().map(|vertex| {
            let [x, y, z] = cross(&vertex.coordinates, portal.normal());
            Row::new([x, y, z, a.clone(), b.clone(), c.clone()])
        });
        ClosedPortal {
            slope,
            edges: (0..portal.vertices().len()).map(edge).collect(),
            vertices: vertices.collect(),
            portal: portal.clone(),
        }
    }
}
