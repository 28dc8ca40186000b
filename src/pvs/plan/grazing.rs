//! Which pairs that are not open are grazing, in the plane.
//!
//! A sequence that is not open but grazing is met by a line through two distinct ends of its
//! portals (`docs/semantics.md`; a touching line can be turned until it meets a second end). For a
//! fixed line each closed portal is met, or not, and may be crossed in the one direction, the
//! other, or both (where it lies on the line); the sequences that the line meets weakly are the
//! paths along these arcs, and a path with a repeated cell can be cut short. So for every line
//! through two ends the cells that reach each other along its arcs are open or grazing.
//!
//! Only portals are asked about: a graph that states no polygons of its cells is classified alike.
//!
//! O(v² c) for v ends and c cells that a line touches, times the portals of a cell; a few thousand
//! ends take a minute. It is done where it is asked for.

use super::groups::Groups;
use crate::geom::BigLine;
use crate::num::{Int, Sign};
use crate::report::{Matrix, Progress, ProvedGrazing, Verdict};
use crate::scene::CellId;
use crate::scene::plan::{Crossing, Crossings, PlanGraph};
use rayon::prelude::*;
use rustc_hash::FxHashMap;

/// A pair of groups that are grazing, and what shows it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PlanTouch {
    /// The groups, the lower first.
    pub groups: [u32; 2],
    /// The line, from one end of a portal to another, by their numbers in [`PlanGraph::points`].
    pub line: [u32; 2],
    /// A cell of one of the groups and a cell of the other, joined by portals that the line
    /// touches on the way from the first to the second.
    pub cells: [CellId; 2],
}

/// Makes pairs of groups grazing that are not open in `matrix`, where they are; one line for each
/// such pair, in ascending order. `None`, with the matrix as it was, if interrupted.
pub fn classify_plan_grazing(
    graph: &PlanGraph,
    crossings: &Crossings,
    groups: &Groups,
    matrix: &mut Matrix,
    progress: &dyn Progress,
) -> Option<Vec<PlanTouch>> {
    let mut ends: Vec<(u32, [CellId; 2])> = graph
        .portals
        .iter()
        .flat_map(|portal| [portal.left, portal.right].map(|end| (end, [portal.from, portal.to])))
        .collect();
    ends.sort_unstable();
    let ends: Vec<&[(u32, [CellId; 2])]> = ends.chunk_by(|(p, _), (q, _)| p == q).collect();
    let points: Vec<u32> = ends.iter().map(|end| end[0].0).collect();
    progress.begin("touching lines", ends.len() as u64);
    let touching = Touching { graph, crossings, groups, known: matrix };
    let found: Option<Vec<Vec<PlanTouch>>> = ends
        .par_iter()
        .enumerate()
        .map(|(index, end)| {
            let mut found = FxHashMap::default();
            for other in touching.directions(points[index], &points[index + 1..]) {
                if progress.is_interrupted() {
                    return None;
                }
                let line = [points[index], other];
                touching.along(line, end.iter().flat_map(|(_, cells)| *cells), &mut found);
            }
            progress.advance(1);
            Some(found.into_values().collect())
        })
        .collect();
    let mut found: Vec<PlanTouch> = found?.into_iter().flatten().collect();
    found.sort_unstable_by_key(|touch| (touch.groups, touch.line));
    found.dedup_by_key(|touch| touch.groups);
    for PlanTouch { groups: [g, h], .. } in &found {
        matrix.set(*g as usize, *h as usize, Verdict::Grazing);
        matrix.set(*h as usize, *g as usize, Verdict::Grazing);
    }
    Some(found)
}

impl PlanTouch {
    /// The sequence from the first cell to the second that the line touches: a shortest one.
    ///
    /// Complexity: linear in the cells that the line touches and their portals.
    ///
    /// # Panics
    /// If the line does not join the cells: it is of another graph.
    pub fn ways(&self, graph: &PlanGraph, crossings: &Crossings) -> Vec<Crossing> {
        let [from, to] = self.cells;
        let mut entered: FxHashMap<CellId, Option<(CellId, Crossing)>> = FxHashMap::default();
        entered.insert(from, None);
        let mut cells = vec![from];
        let mut next = 0;
        while !entered.contains_key(&to) {
            let cell = cells[next];
            for way in crossings.from(cell) {
                if touch(graph, self.line, way) == Touch::Along && !entered.contains_key(&way.to) {
                    entered.insert(way.to, Some((cell, *way)));
                    cells.push(way.to);
                }
            }
            next += 1;
        }
        let mut ways = Vec::new();
        let mut cell = to;
        while let Some((before, way)) = entered[&cell] {
            ways.push(way);
            cell = before;
        }
        ways.reverse();
        ways
    }

    /// The same in the graph's [form in space](PlanGraph::in_space), at half the portals' height.
    ///
    /// Complexity: that of [`PlanTouch::ways`].
    ///
    /// # Panics
    /// As [`PlanTouch::ways`].
    pub fn in_space(&self, graph: &PlanGraph, crossings: &Crossings) -> ProvedGrazing {
        let directed = |way: &Crossing| {
            let portal = &graph.portals[way.portal as usize];
            2 * way.portal + u32::from(way.to == portal.from)
        };
        let raised = |end| PlanGraph::halfway_up(graph.world(end).map(|c| c.to_rational()));
        let points = self.line.map(raised);
        let line = BigLine::through_rational(&points[0], &points[1]).expect("two different ends");
        let ([a, b, c], [d, e, f]) = (line.direction, line.moment);
        ProvedGrazing {
            source: self.cells[0],
            target: self.cells[1],
            portals: self.ways(graph, crossings).iter().map(directed).collect(),
            line: [[a, b, c, d, e, f], [(); 6].map(|()| Int::ZERO)],
            radicand: Int::ZERO,
        }
    }
}

/// How a line meets a portal that is crossed one way.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Touch {
    /// It has a point of the portal, and does not cross it against that way.
    Along,
    /// It crosses it against that way.
    Against,
    /// It misses it.
    Not,
}

fn touch(graph: &PlanGraph, line: [u32; 2], way: &Crossing) -> Touch {
    let side = |end| graph.points.turn(line[0], line[1], end);
    match (side(way.left), side(way.right)) {
        (Sign::Positive, Sign::Positive) | (Sign::Negative, Sign::Negative) => Touch::Not,
        // With the left end to its left, or on it, the line passes in its direction; on a portal
        // that lies on it, in either.
        (Sign::Positive | Sign::Zero, Sign::Negative | Sign::Zero) => Touch::Along,
        (Sign::Negative, Sign::Zero | Sign::Positive) | (Sign::Zero, Sign::Positive) => {
            Touch::Against
        }
    }
}

struct Touching<'a> {
    graph: &'a PlanGraph,
    crossings: &'a Crossings,
    groups: &'a Groups,
    known: &'a Matrix,
}

impl Touching<'_> {
    /// One end for each line through `end` and one of the others.
    fn directions(&self, end: u32, others: &[u32]) -> Vec<u32> {
        let points = &self.graph.points;
        let mut all: Vec<(u32, bool)> =
            others.iter().map(|&point| (point, points.is_upper(end, point))).collect();
        all.sort_by(|p, q| points.compare_lines(end, *p, *q));
        all.dedup_by(|p, q| points.compare_lines(end, *p, *q).is_eq());
        all.into_iter().map(|(point, _)| point).collect()
    }

    /// Adds the pairs of groups, not known to be open, that a line through two ends joins weakly;
    /// of the cells that it touches, those that portals which it touches join with the given ones.
    fn along(
        &self,
        line: [u32; 2],
        given: impl Iterator<Item = CellId>,
        found: &mut FxHashMap<[u32; 2], PlanTouch>,
    ) {
        let mut cells: Vec<CellId> = Vec::new();
        let mut numbers: FxHashMap<CellId, usize> = FxHashMap::default();
        let mut add = |cell: CellId, cells: &mut Vec<CellId>| {
            *numbers.entry(cell).or_insert_with(|| {
                cells.push(cell);
                cells.len() - 1
            })
        };
        for cell in given {
            add(cell, &mut cells);
        }
        let mut arcs: Vec<Vec<usize>> = Vec::new();
        let mut next = 0;
        while next < cells.len() {
            let mut own = Vec::new();
            for way in self.crossings.from(cells[next]) {
                match touch(self.graph, line, way) {
                    Touch::Along => own.push(add(way.to, &mut cells)),
                    // The cell beyond leads here.
                    Touch::Against => {
                        add(way.to, &mut cells);
                    }
                    Touch::Not => {}
                }
            }
            arcs.push(own);
            next += 1;
        }
        for start in 0..cells.len() {
            self.reach(start, &cells, &arcs, |groups, cells| {
                found.entry(groups).or_insert(PlanTouch { groups, line, cells });
            });
        }
    }

    /// Tells of the groups, not known to be open, that arcs lead to from a cell, and of the cells.
    fn reach(
        &self,
        start: usize,
        cells: &[CellId],
        arcs: &[Vec<usize>],
        mut tell: impl FnMut([u32; 2], [CellId; 2]),
    ) {
        let Some(from) = self.groups.of(cells[start]) else { return };
        let mut reached = vec![false; cells.len()];
        reached[start] = true;
        let mut stack = vec![start];
        while let Some(cell) = stack.pop() {
            for &to in &arcs[cell] {
                if std::mem::replace(&mut reached[to], true) {
                    continue;
                }
                stack.push(to);
                if let Some(group) = self.groups.of(cells[to])
                    && group != from
                    && self.known.get(from as usize, group as usize) == Verdict::NotOpen
                {
                    let groups = [from.min(group), from.max(group)];
                    tell(groups, [cells[start], cells[to]]);
                }
            }
        }
    }
}
