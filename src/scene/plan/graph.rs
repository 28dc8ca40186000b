//! Convex cells of the plane, joined by segments.

use crate::num::{Int, Number, Rational};
use crate::predicates::PlanPoints;
use crate::scene::{CellId, PortalGraph, RawGraph, RawPortal};

/// A segment between two cells, crossed from `from` to `to` with `left` on the left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PlanPortal {
    /// The cell that a line leaves which has `left` on its left.
    pub from: CellId,
    /// The cell that it enters.
    pub to: CellId,
    /// One end, by its number in [`PlanGraph::points`].
    pub left: u32,
    /// The other end.
    pub right: u32,
}

/// Cells and portals of the plane.
///
/// Invariants: a portal's ends differ, and so do its cells; a polygon is strictly convex, its
/// corners counter-clockwise; polygons are stated for all cells or for none.
#[derive(Clone, Debug, Default)]
pub struct PlanGraph {
    /// Grid units in one world unit.
    pub grid: Int,
    /// All points, in grid units.
    pub points: PlanPoints,
    /// The names of the cells.
    pub cells: Vec<String>,
    /// The corners of each cell, counter-clockwise, by number; none where the input states a graph
    /// alone.
    pub polygons: Vec<Vec<u32>>,
    /// The portals.
    pub portals: Vec<PlanPortal>,
}

/// One way through a portal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Crossing {
    /// The portal's index in [`PlanGraph::portals`].
    pub portal: u32,
    /// The cell entered.
    pub to: CellId,
    /// The end on the left.
    pub left: u32,
    /// The end on the right.
    pub right: u32,
}

/// The ways out of each cell: the adjacency graph, directed.
#[derive(Clone, Debug, Default)]
pub struct Crossings {
    starts: Vec<u32>,
    all: Vec<Crossing>,
}

impl Crossings {
    /// The ways out of a cell, by ascending number of the portal; where the cell's polygon is
    /// known, counter-clockwise around it, from its first corner on.
    ///
    /// # Panics
    /// If there is no such cell.
    #[inline]
    pub fn from(&self, cell: CellId) -> &[Crossing] {
        let cell = cell.0 as usize;
        &self.all[self.starts[cell] as usize..self.starts[cell + 1] as usize]
    }
}

/// A node of a stab tree: an open sequence, that of the parent and one portal more.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PlanStabNode {
    /// The index of the node of the sequence without its last portal; `None` for one portal.
    pub parent: Option<u32>,
    /// The last portal, by its index in [`PlanGraph::portals`].
    pub portal: u32,
    /// The cell that it enters.
    pub cell: CellId,
}

impl PlanGraph {
    /// Both ways through every portal, by the cell left. O(n lg n).
    pub fn crossings(&self) -> Crossings {
        let mut ways: Vec<(CellId, Crossing)> = Vec::with_capacity(2 * self.portals.len());
        for (number, portal) in self.portals.iter().enumerate() {
            let &PlanPortal { from, to, left, right } = portal;
            let portal = number as u32;
            ways.push((from, Crossing { portal, to, left, right }));
            ways.push((to, Crossing { portal, to: from, left: right, right: left }));
        }
        ways.sort_by_key(|&(cell, _)| cell);
        let mut starts = vec![0; self.cells.len() + 1];
        for (cell, _) in &ways {
            starts[cell.0 as usize + 1] += 1;
        }
        for cell in 1..starts.len() {
            starts[cell] += starts[cell - 1];
        }
        let mut crossings =
            Crossings { starts, all: ways.into_iter().map(|(_, way)| way).collect() };
        for (cell, polygon) in self.polygons.iter().enumerate() {
            let range = crossings.starts[cell] as usize..crossings.starts[cell + 1] as usize;
            self.sort_around(polygon, &mut crossings.all[range]);
        }
        crossings
    }

    /// Sorts ways out of a polygon counter-clockwise, from its first corner on.
    ///
    /// Seen from inside, a way's right end comes first. It lies on the first edge that it is not to
    /// the left of, its own corner included, and along an edge order is that of the line.
    fn sort_around(&self, polygon: &[u32], ways: &mut [Crossing]) {
        let edge_of = |way: &Crossing| {
            let on = |i: usize| {
                let edge = [polygon[i], polygon[(i + 1) % polygon.len()]];
                [way.left, way.right]
                    .iter()
                    .all(|&end| self.points.turn(edge[0], edge[1], end) == crate::num::Sign::Zero)
            };
            (0..polygon.len()).find(|&i| on(i)).expect("a portal lies on an edge of its cell")
        };
        let mut keyed: Vec<(usize, Crossing)> = ways.iter().map(|w| (edge_of(w), *w)).collect();
        keyed.sort_by(|(i, v), (j, w)| {
            i.cmp(j).then_with(|| {
                let edge = [polygon[*i], polygon[(*i + 1) % polygon.len()]];
                self.points.compare_along(edge, v.right, w.right)
            })
        });
        for (way, (_, sorted)) in ways.iter_mut().zip(keyed) {
            *way = sorted;
        }
    }

    /// The graph of the same cells and portals with a height of 1, from z = 0 on, whose portals
    /// are passed by the same lines: a line that passes these, shadowed on the plane, passes those,
    /// and a line of the plane passes these at any height between.
    pub fn in_space(&self) -> PortalGraph {
        let portals = self.portals.iter().map(|portal| {
            let [l, r] = [portal.left, portal.right].map(|end| self.world(end));
            let at = |[x, y]: &[Number; 2], z| [x.clone(), y.clone(), Number::Small(z, 1)];
            RawPortal {
                cells: [portal.from.0, portal.to.0],
                vertices: vec![at(&r, 0), at(&l, 0), at(&l, 1), at(&r, 1)],
                line: None,
            }
        });
        let raw = RawGraph {
            cells: self.cells.clone(),
            portals: portals.collect(),
            leaf_to_cell: (0..self.cells.len() as u32).collect(),
            declared_grid: None,
        };
        PortalGraph::from_raw(raw).expect("rectangles between two cells")
    }

    /// A point of the plane at half the height of the portals of [`PlanGraph::in_space`].
    pub fn halfway_up([x, y]: [Rational; 2]) -> [Rational; 3] {
        [x, y, Rational::new(Int::from(1), Int::from(2))]
    }

    /// A point in world units.
    pub fn world(&self, point: u32) -> [Number; 2] {
        self.points.get(point).coordinates().map(|c| Number::from(c / &self.grid))
    }
}
