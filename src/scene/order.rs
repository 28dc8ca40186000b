//! Which pairs of portals need the order of crossing as a condition of its own.
//!
//! A line that crosses portal p into a cell and portal q out of it, each in its direction, meets
//! them in this order without further ado if q lies on the inner side of p's plane or on it, or
//! p on the inner side of q's plane or on it. In an exactly convex cell both hold for every pair;
//! rounded files break it by a hair here and there (semantics, fact 4). Quadratic in the number
//! of portals of a cell, summed over the cells.
//!
//! **Two portals that share both of their cells**, say A and B, as the triangles of one skew
//! portal do, never follow each other in a sequence that counts: crossing p from A to B and then q
//! can only lead back to A, where the sequence was before. Such a loop adds nothing: a line that
//! crosses … o, p, q, r … in order crosses o before r, so it crosses … o, r … in order too. The
//! searches therefore enter no cell twice, the pair is never asked for, and it counts as implied.
//!
//! **Two portals of one plane** that are crossed the same way, into the cell and out of it, are met
//! at one point and not one after the other: no line crosses them in order. (A cell between them
//! would have no inside there; only graphs that describe no space have such pairs.)

use super::polygon::{cross, difference, dot};
use super::{PortalGraph, PortalId};
use num_traits::Signed;

/// The pairs of portals of one cell whose order is not implied, and the count of cells that are
/// not exactly convex.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct CellOrder {
    /// Cells of which some portal has a vertex strictly on the outer side of another's plane.
    pub nonconvex_cells: u32,
    /// Each pair with the lower id first, in ascending order.
    pairs: Vec<[PortalId; 2]>,
    /// Pairs of one plane that are crossed the same way, listed like the others.
    flush: Vec<[PortalId; 2]>,
}

impl CellOrder {
    /// Examines every cell of `graph`.
    pub fn new(graph: &PortalGraph) -> CellOrder {
        match small_vertices(graph) {
            Some(vertices) => examine(graph, &vertices),
            None => {
                let vertices = graph.vertices.iter().map(|vertex| Vertex {
                    numerators: vertex.numerators().clone(),
                    denominator: vertex.denominator().clone(),
                });
                examine(graph, &vertices.collect::<Vec<_>>())
            }
        }
    }

    /// Whether a line through `p` and `q` in their directions, the one into and the other out of
    /// the cell that they share, crosses them in this order whatever else it does. Two portals
    /// that share both their cells count as implied: no sequence without a repeated cell has both.
    pub fn is_implied(&self, p: PortalId, q: PortalId) -> bool {
        self.pairs.binary_search(&[p.min(q), p.max(q)]).is_err()
    }

    /// Whether `p` and `q`, the one crossed into the cell that they share and the other out of it,
    /// are met at one point by every line, so that none crosses the one before the other.
    pub fn is_impossible(&self, p: PortalId, q: PortalId) -> bool {
        self.flush.binary_search(&[p.min(q), p.max(q)]).is_ok()
    }

    /// The pairs whose order is not implied, the lower id first, in ascending order.
    pub fn pairs(&self) -> &[[PortalId; 2]] {
        &self.pairs
    }
}

/// A vertex in homogeneous coordinates, the last of them positive.
struct Vertex<T> {
    numerators: [T; 3],
    denominator: T,
}

/// The vertices in units of their common grid, if 128 bits suffice: the limit of `build`, whose
/// comment derives it, in the form that suits a point. (The denominators are 1 then.)
fn small_vertices(graph: &PortalGraph) -> Option<Vec<Vertex<i128>>> {
    let small = graph.small_grid()?.points.into_iter().map(|point| {
        let integers = point.integers();
        integers
            .iter()
            .all(|c| c.abs() < 1 << 39)
            .then(|| Vertex { numerators: integers.map(i128::from), denominator: 1 })
    });
    small.collect()
}

/// A portal's plane: `normal · v` against `offset` times the denominator of `v`.
struct Plane<T> {
    normal: [T; 3],
    offset: T,
}

fn plane<T: Signed + Clone>(vertices: &[Vertex<T>], corners: &[u32]) -> Plane<T> {
    let [a, b, c] = [0, 1, 2].map(|i| &vertices[corners[i] as usize]);
    // The difference p - a, times both denominators.
    let arm = |p: &Vertex<T>| {
        let scaled = |v: &Vertex<T>, by: &T| v.numerators.clone().map(|c| c * by.clone());
        difference(&scaled(p, &a.denominator), &scaled(a, &p.denominator))
    };
    let normal = cross(&arm(b), &arm(c));
    let offset = dot(&normal, &a.numerators);
    Plane { normal: normal.map(|c| c * a.denominator.clone()), offset }
}

fn examine<T: Signed + Clone + PartialOrd>(
    graph: &PortalGraph,
    vertices: &[Vertex<T>],
) -> CellOrder {
    let planes: Vec<Plane<T>> =
        graph.portals.iter().map(|portal| plane(vertices, &portal.vertices)).collect();
    let mut portals_of_cell = vec![Vec::new(); graph.cells.len()];
    for (index, portal) in graph.portals.iter().enumerate() {
        portals_of_cell[portal.from.0 as usize].push((index, false));
        portals_of_cell[portal.to.0 as usize].push((index, true));
    }
    // Whether portal q has no vertex strictly on the outer side of portal p's plane, where p's
    // normal points inwards or outwards.
    let is_inside = |(p, inwards): (usize, bool), q: usize| {
        let Plane { normal, offset } = &planes[p];
        graph.portals[q].vertices.iter().all(|&vertex| {
            let vertex = &vertices[vertex as usize];
            let value = dot(normal, &vertex.numerators);
            let offset = offset.clone() * vertex.denominator.clone();
            if inwards { value >= offset } else { value <= offset }
        })
    };
    // Whether two portals that are inside each other are of one plane and crossed the same way.
    let is_flush = |p: (usize, bool), q: (usize, bool)| {
        is_inside((p.0, !p.1), q.0) && {
            let parallel = planes[p.0].normal.iter().zip(&planes[q.0].normal);
            let agree = parallel.into_iter().any(|(a, b)| !a.is_zero() && a.signum() == b.signum());
            agree == (p.1 != q.1)
        }
    };
    let mut order = CellOrder::default();
    for portals in &portals_of_cell {
        let mut convex = true;
        for (i, &p) in portals.iter().enumerate() {
            for &q in &portals[..i] {
                let (p_holds_q, q_holds_p) = (is_inside(p, q.0), is_inside(q, p.0));
                convex &= p_holds_q && q_holds_p;
                if !p_holds_q && !q_holds_p && !share_both_cells(graph, p.0, q.0) {
                    order.pairs.push([PortalId(q.0 as u32), PortalId(p.0 as u32)]);
                }
                if p_holds_q && q_holds_p && is_flush(p, q) {
                    order.flush.push([PortalId(q.0 as u32), PortalId(p.0 as u32)]);
                }
            }
        }
        order.nonconvex_cells += u32::from(!convex);
    }
    order.pairs.sort_unstable();
    order.flush.sort_unstable();
    order
}

fn share_both_cells(graph: &PortalGraph, p: usize, q: usize) -> bool {
    let (p, q) = (&graph.portals[p], &graph.portals[q]);
    let unordered =
        |portal: &super::Portal| (portal.from.min(portal.to), portal.from.max(portal.to));
    unordered(p) == unordered(q)
}
