//! Which pairs that are not open are grazing, in the plane.
//!
//! A sequence that is not open but grazing is met by a line through two distinct ends of its
//! portals (`docs/semantics.md`; a touching line can be turned until it meets a second end). For a
//! fixed line each closed portal is met, or not, and may be crossed in the one direction, the
//! other, or both (where it lies on the line); the sequences that the line meets weakly are the
//! paths along these arcs, and a path with a repeated cell can be cut short. So for every line
//! through two ends the cells that reach each other along its arcs are open or grazing.
//!
//! O(v² c) for v ends and c cells that a line touches, times the portals of a cell; a few thousand
//! ends take a minute. It is done where it is asked for.

use super::around::Around;
use super::groups::Groups;
use crate::num::Sign;
use crate::report::{Matrix, Progress, Verdict};
use crate::scene::CellId;
use crate::scene::plan::{Crossings, PlanGraph};
use rayon::prelude::*;
use rustc_hash::FxHashMap;

/// Makes pairs of groups grazing that are not open in `matrix`, where they are. `None` if
/// interrupted.
///
/// # Panics
/// If the graph states no polygons.
pub fn classify_plan_grazing(
    graph: &PlanGraph,
    crossings: &Crossings,
    groups: &Groups,
    matrix: &mut Matrix,
    progress: &dyn Progress,
) -> Option<()> {
    let around = Around::new(graph, crossings, groups);
    let mut ends: Vec<u32> = graph.portals.iter().flat_map(|p| [p.left, p.right]).collect();
    ends.sort_unstable();
    ends.dedup();
    progress.begin("touching lines", ends.len() as u64);
    let touching = Touching { graph, crossings, groups, around: &around, known: matrix };
    let found: Option<Vec<Vec<[u32; 2]>>> = ends
        .par_iter()
        .enumerate()
        .map(|(index, &end)| {
            let mut pairs = Vec::new();
            for other in touching.directions(end, &ends[index + 1..]) {
                if progress.is_interrupted() {
                    return None;
                }
                touching.along([end, other], &mut pairs);
            }
            pairs.sort_unstable();
            pairs.dedup();
            progress.advance(1);
            Some(pairs)
        })
        .collect();
    for [g, h] in found?.into_iter().flatten() {
        matrix.set(g as usize, h as usize, Verdict::Grazing);
        matrix.set(h as usize, g as usize, Verdict::Grazing);
    }
    Some(())
}

struct Touching<'a> {
    graph: &'a PlanGraph,
    crossings: &'a Crossings,
    groups: &'a Groups,
    around: &'a Around,
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

    /// Adds the pairs of groups, not known to be open, that a line through two ends joins weakly.
    fn along(&self, line: [u32; 2], pairs: &mut Vec<[u32; 2]>) {
        let mut cells: Vec<CellId> = Vec::new();
        let mut numbers: FxHashMap<CellId, usize> = FxHashMap::default();
        let mut add = |cell: CellId, cells: &mut Vec<CellId>| {
            *numbers.entry(cell).or_insert_with(|| {
                cells.push(cell);
                cells.len() - 1
            })
        };
        for wedge in self.around.at(line[0]) {
            add(wedge.cell, &mut cells);
        }
        // The ways that the line passes, or touches, in its direction.
        let mut arcs: Vec<Vec<usize>> = Vec::new();
        let mut next = 0;
        while next < cells.len() {
            let mut own = Vec::new();
            for way in self.crossings.from(cells[next]) {
                let side = |end| self.graph.points.turn(line[0], line[1], end);
                let (left, right) = (side(way.left), side(way.right));
                if left == right && left != Sign::Zero {
                    // The line misses the portal.
                    continue;
                }
                let to = add(way.to, &mut cells);
                // With the left end to its left, or on it, the line passes in its direction; on a
                // portal that lies on it, in either.
                if left != Sign::Negative && right != Sign::Positive {
                    own.push(to);
                }
            }
            arcs.push(own);
            next += 1;
        }
        for start in 0..cells.len() {
            self.reach(start, &cells, &arcs, pairs);
        }
    }

    fn reach(
        &self,
        start: usize,
        cells: &[CellId],
        arcs: &[Vec<usize>],
        pairs: &mut Vec<[u32; 2]>,
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
                if let Some(to) = self.groups.of(cells[to])
                    && to != from
                    && self.known.get(from as usize, to as usize) == Verdict::NotOpen
                {
                    pairs.push([from.min(to), from.max(to)]);
                }
            }
        }
    }
}
