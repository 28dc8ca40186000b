//! Convex polygons on a plane, each edge cut by another plane.
//!
//! Definitions: the edges run counter-clockwise as seen from the positive side of the support;
//! edge i is the meet of the support with cut i and ends at vertex i, the meet of the support with
//! cuts i and i+1. Cuts point outwards.
//!
//! Invariants: three or more edges, strictly convex (no vertex on the line through its
//! neighbours), positive area. Splitting keeps them: a piece is kept only where some vertex lies
//! strictly on its side, and a vertex in the splitting plane stays a vertex with the splitting
//! plane as one of its three.
//!
//! Cost of a split: one sign for each vertex, two new meets.

use super::{PlaneId, PlaneSet};
use crate::geom::RationalPoint3;
use crate::num::{Rational, Sign};
use crate::predicates::{Vertex, side_of_vertex};

/// A convex polygon.
#[derive(Clone, Debug)]
pub struct Polygon {
    support: PlaneId,
    edges: Vec<Edge>,
}

#[derive(Clone, Debug)]
struct Edge {
    cut: PlaneId,
    /// The meet of the support, this cut and the next.
    end: Vertex,
}

/// What a plane makes of a polygon or a polyhedron.
#[derive(Clone, Debug)]
pub enum Split<T> {
    /// All of it is on the positive side or in the plane, but not wholly in the plane.
    Front,
    /// All of it is on the negative side or in the plane, but not wholly in the plane.
    Back,
    /// It lies in the plane.
    On,
    /// The parts on the positive and on the negative side.
    Both(T, T),
}

/// Where the vertices of something convex lie with respect to a plane.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Extent {
    /// Some vertex is strictly on the positive side.
    pub front: bool,
    /// Some vertex is strictly on the negative side.
    pub back: bool,
}

impl Extent {
    /// Adds a vertex's side.
    fn add(&mut self, sign: Sign) {
        match sign {
            Sign::Negative => self.back = true,
            // A vertex in the plane belongs to both closed sides.
            Sign::Zero => {}
            Sign::Positive => self.front = true,
        }
    }
}

impl Polygon {
    /// The polygon of a support and its cuts in order.
    ///
    /// Requires: neighbouring cuts meet the support in the vertices of a strictly convex polygon.
    pub(super) fn new(planes: &PlaneSet, support: PlaneId, cuts: &[PlaneId]) -> Polygon {
        let next = cuts.iter().cycle().skip(1);
        let edges = cuts
            .iter()
            .zip(next)
            .map(|(&cut, &next)| Edge { cut, end: meet(planes, [support, cut, next]) });
        Polygon { support, edges: edges.collect() }
    }

    /// The plane it lies in, positive where its vertices run counter-clockwise as seen from.
    pub fn support(&self) -> PlaneId {
        self.support
    }

    /// The planes that cut it, in order, outwards.
    pub fn cuts(&self) -> impl Iterator<Item = PlaneId> {
        self.edges.iter().map(|edge| edge.cut)
    }

    /// The vertices, counter-clockwise as seen from the positive side of the support.
    pub fn vertices(&self) -> impl Iterator<Item = &Vertex> {
        self.edges.iter().map(|edge| &edge.end)
    }

    /// The vertices in lowest terms.
    pub fn points(&self) -> Vec<RationalPoint3> {
        self.vertices().map(Vertex::point).collect()
    }

    /// Twice its area vector, along the normal of the support: the sum of the cross products of
    /// neighbouring vertices.
    pub fn doubled_area(&self) -> [Rational; 3] {
        [0, 1, 2].map(|axis| self.doubled_shadow(axis))
    }

    /// The coordinate of [`Polygon::doubled_area`] along an axis: twice the area of its shadow.
    pub fn doubled_shadow(&self, axis: usize) -> Rational {
        let points = self.points();
        let grid = RationalPoint3::common_denominator(&points);
        let points: Vec<_> = points.iter().map(|p| p.on_grid(&grid).coordinates).collect();
        let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
        let next = points.iter().cycle().skip(1);
        let shadow = points.iter().zip(next).map(|(p, q)| &p[i] * &q[j] - &p[j] * &q[i]).sum();
        Rational::new(shadow, &grid * &grid)
    }

    /// The same polygon seen from its other side.
    #[must_use]
    pub fn flipped(&self) -> Polygon {
        // Backwards, edge i starts where it ended: vertex i-1 of the old order is its end.
        let count = self.edges.len();
        let edges = (0..count).rev().map(|i| Edge {
            cut: self.edges[i].cut,
            end: self.edges[(i + count - 1) % count].end.clone(),
        });
        Polygon { support: self.support.flipped(), edges: edges.collect() }
    }

    /// On which sides of a plane it has points; neither where it lies in the plane.
    pub fn extent(&self, planes: &PlaneSet, plane: PlaneId) -> Extent {
        let mut extent = Extent::default();
        if self.support.undirected() != plane.undirected() {
            (0..self.edges.len()).for_each(|i| extent.add(self.side(planes, i, plane)));
        }
        extent
    }

    /// Splits it by a plane.
    pub fn split(&self, planes: &PlaneSet, plane: PlaneId) -> Split<Polygon> {
        if self.support.undirected() == plane.undirected() {
            return Split::On;
        }
        let mut extent = Extent::default();
        let side = |i| {
            let side = self.side(planes, i, plane);
            extent.add(side);
            side
        };
        let sides: Vec<Sign> = (0..self.edges.len()).map(side).collect();
        match (extent.front, extent.back) {
            (true, true) => Split::Both(
                self.piece(planes, plane, &sides, Sign::Positive),
                self.piece(planes, plane, &sides, Sign::Negative),
            ),
            (true, false) => Split::Front,
            (false, true) => Split::Back,
            (false, false) => unreachable!("two different planes share a polygon"),
        }
    }

    /// What of it is on the negative side of a plane, or `None` where that has no area; all of it
    /// where it lies in the plane.
    pub fn inside(self, planes: &PlaneSet, plane: PlaneId) -> Option<Polygon> {
        match self.split(planes, plane) {
            Split::Front => None,
            Split::Back | Split::On => Some(self),
            Split::Both(_, back) => Some(back),
        }
    }

    /// The side of vertex i, known without arithmetic where the plane is one of its own.
    #[inline]
    fn side(&self, planes: &PlaneSet, i: usize, plane: PlaneId) -> Sign {
        let next = if i + 1 == self.edges.len() { 0 } else { i + 1 };
        let own = |i: usize| self.edges[i].cut.undirected() == plane.undirected();
        if own(i) || own(next) {
            return Sign::Zero;
        }
        side_of_vertex(planes.get(plane), &self.edges[i].end)
    }

    /// The part on one side of a plane that has vertices strictly on both.
    fn piece(&self, planes: &PlaneSet, plane: PlaneId, sides: &[Sign], keep: Sign) -> Polygon {
        let count = self.edges.len();
        let before = |i: usize| (i + count - 1) % count;
        // By convexity the vertices strictly on the side are consecutive.
        let first = (0..count)
            .find(|&i| sides[i] == keep && sides[before(i)] != keep)
            .expect("the sides change");
        // The point in the plane on edge i, whose vertex `end` is not strictly on this side.
        let crossing = |i: usize, end: usize| match sides[end] {
            Sign::Zero => self.edges[end].end.clone(),
            Sign::Negative | Sign::Positive => {
                meet(planes, [self.support, self.edges[i].cut, plane])
            }
        };
        let entry = crossing(first, before(first));
        let mut edges = Vec::with_capacity(count + 1);
        let mut i = first;
        while sides[i] == keep {
            edges.push(self.edges[i].clone());
            i = (i + 1) % count;
        }
        edges.push(Edge { cut: self.edges[i].cut, end: crossing(i, i) });
        let cut = match keep {
            Sign::Positive => plane.flipped(),
            Sign::Zero | Sign::Negative => plane,
        };
        edges.push(Edge { cut, end: entry });
        Polygon { support: self.support, edges }
    }
}

/// The meet of planes that are known to have one.
fn meet(planes: &PlaneSet, ids: [PlaneId; 3]) -> Vertex {
    Vertex::meet(ids.map(|id| planes.get(id))).expect("an edge crosses the plane in one point")
}
