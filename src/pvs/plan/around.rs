//! The cells around each vertex.

use super::groups::Groups;
use crate::num::Sign;
use crate::scene::CellId;
use crate::scene::plan::{Crossings, PlanGraph};

/// What of a cell is seen of from a point of its boundary: the directions between two of its
/// points, counter-clockwise, half a turn at most.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Wedge {
    pub(super) cell: CellId,
    pub(super) from: u32,
    pub(super) to: u32,
    /// For half a turn a point in a direction between.
    pub(super) middle: Option<u32>,
}

/// The cells around all vertices.
pub(super) struct Around {
    starts: Vec<u32>,
    wedges: Vec<Wedge>,
}

impl Around {
    /// The wedges at every corner and every end of a portal of the cells that a way leads to from
    /// one that is asked about.
    pub(super) fn new(graph: &PlanGraph, crossings: &Crossings, groups: &Groups) -> Around {
        let mut all: Vec<(u32, Wedge)> = Vec::new();
        let is_reached = reached(graph, crossings, groups);
        for (number, polygon) in graph.polygons.iter().enumerate() {
            let cell = CellId(number as u32);
            if !is_reached[number] {
                continue;
            }
            let n = polygon.len();
            for k in 0..n {
                let (from, to) = (polygon[(k + 1) % n], polygon[(k + n - 1) % n]);
                all.push((polygon[k], Wedge { cell, from, to, middle: None }));
            }
            for crossing in crossings.from(cell) {
                for end in [crossing.right, crossing.left] {
                    if polygon.contains(&end) {
                        continue;
                    }
                    // Inside an edge: half a turn, from the edge's end to its start.
                    let [from, to] = edge_through(graph, polygon, end);
                    let is_off =
                        |&&corner: &&u32| graph.points.turn(from, to, corner) != Sign::Zero;
                    let middle = polygon.iter().find(is_off).copied();
                    all.push((end, Wedge { cell, from, to, middle }));
                }
            }
        }
        all.sort_unstable_by_key(|(vertex, wedge)| (*vertex, wedge.cell));
        all.dedup();
        let mut starts = vec![0; graph.points.len() + 1];
        for (vertex, _) in &all {
            starts[*vertex as usize + 1] += 1;
        }
        for vertex in 1..starts.len() {
            starts[vertex] += starts[vertex - 1];
        }
        Around { starts, wedges: all.into_iter().map(|(_, wedge)| wedge).collect() }
    }

    /// The wedges at a vertex, by ascending cell.
    pub(super) fn at(&self, vertex: u32) -> &[Wedge] {
        let vertex = vertex as usize;
        &self.wedges[self.starts[vertex] as usize..self.starts[vertex + 1] as usize]
    }

    /// The vertices at which lines may stop joining two groups: all around which a wall ends or
    /// turns, or the boundary between two groups does.
    pub(super) fn essential(
        &self,
        graph: &PlanGraph,
        crossings: &Crossings,
        groups: &Groups,
    ) -> Vec<u32> {
        let vertices = 0..graph.points.len() as u32;
        vertices.filter(|&v| self.is_essential(graph, crossings, groups, v)).collect()
    }

    /// Whether what parts groups at a vertex is anything but nothing, or one straight line with the
    /// same group all along each side of it.
    fn is_essential(
        &self,
        graph: &PlanGraph,
        crossings: &Crossings,
        groups: &Groups,
        vertex: u32,
    ) -> bool {
        let wedges = self.at(vertex);
        if groups.are_cells {
            return !wedges.is_empty();
        }
        // The directions in which a wall or the boundary of a group goes off. What lies to the left
        // and to the right of one runs on to the next.
        let mut parting: Vec<(u32, bool)> = Vec::new();
        for wedge in wedges {
            let own = groups.of(wedge.cell);
            let ways = crossings.from(wedge.cell);
            match ways.iter().find(|way| way.right == vertex) {
                Some(way) if groups.of(way.to) == own => {}
                Some(_) => parting.push((wedge.from, false)),
                None => parting.push((wedge.from, true)),
            }
            if !ways.iter().any(|way| way.left == vertex) {
                parting.push((wedge.to, true));
            }
        }
        // A wall between two cells is there from either side.
        let mut distinct: Vec<(u32, bool)> = Vec::new();
        for (point, is_wall) in parting {
            let is_same = |&(other, _): &(u32, bool)| {
                graph.points.turn(point, vertex, other) == Sign::Zero
                    && !self.faces_away(graph, vertex, point, other)
            };
            if !distinct.iter().any(is_same) {
                distinct.push((point, is_wall));
            }
        }
        match distinct[..] {
            [] => false,
            [(p, is_wall), (q, is_other_wall)] => {
                let is_straight = graph.points.turn(p, vertex, q) == Sign::Zero
                    && self.faces_away(graph, vertex, p, q);
                !(is_straight && is_wall == is_other_wall)
            }
            _ => true,
        }
    }

    /// Whether `p` and `q`, collinear with `vertex`, lie on either side of it.
    fn faces_away(&self, graph: &PlanGraph, vertex: u32, p: u32, q: u32) -> bool {
        let along = |a, b| graph.points.compare_along([p, vertex], a, b);
        along(vertex, q).is_lt()
    }
}

/// Which cells a way leads to from one that is in a group.
fn reached(graph: &PlanGraph, crossings: &Crossings, groups: &Groups) -> Vec<bool> {
    let cells = (0..graph.cells.len() as u32).map(CellId);
    let mut stack: Vec<CellId> = cells.filter(|&cell| groups.of(cell).is_some()).collect();
    let mut reached = vec![false; graph.cells.len()];
    stack.iter().for_each(|cell| reached[cell.0 as usize] = true);
    while let Some(cell) = stack.pop() {
        for way in crossings.from(cell) {
            if !std::mem::replace(&mut reached[way.to.0 as usize], true) {
                stack.push(way.to);
            }
        }
    }
    reached
}

/// The edge of a polygon that holds a point of its boundary which is no corner, from its end to
/// its start.
fn edge_through(graph: &PlanGraph, polygon: &[u32], point: u32) -> [u32; 2] {
    let n = polygon.len();
    let edges = (0..n).map(|k| [polygon[(k + 1) % n], polygon[k]]);
    let mut holding = edges.filter(|&[a, b]| graph.points.turn(a, b, point) == Sign::Zero);
    holding.next().expect("a portal's end lies on an edge of its cell")
}
