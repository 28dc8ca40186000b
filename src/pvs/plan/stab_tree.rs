//! Stab trees of the plane: every open portal sequence from a cell (Teller and Séquin 1991, §3.3).
//!
//! The search goes from cell to cell as the paper's does and keeps the hourglass of the portals on
//! its way; a portal that leaves the hourglass open is a node of the tree, and the search goes on
//! from the cell that it enters.
//!
//! No cell is entered twice on one way. Nothing is lost by that: what a line has in common with a
//! convex cell is one segment, so a line through portals leaves each cell once and never comes
//! back, and a sequence that enters a cell again is not open. For the same reason the search could
//! do without: the hourglass would close.
//!
//! Complexity: one push for each portal of each node's cell but the one it was entered by,
//! O(log k) turns each for k ends on the hourglass. The number of nodes has no useful bound; the
//! depth of the search is a vector's length, not the thread's stack.

use super::Ways;
use super::witness::{self, Through};
use crate::num::Number;
use crate::predicates::PlanPoints;
use crate::report::Progress;
use crate::scene::CellId;
use crate::scene::plan::{Crossing, Crossings, PlanGraph, PlanStabNode};
use crate::stab::hourglass::chains::{Chains, Ends, Place};
use rayon::prelude::*;

/// The open sequences from one cell.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlanStabTree {
    /// The cell.
    pub source: CellId,
    /// The nodes, each after its parent, in the order of a depth-first walk that takes the ways
    /// out of a cell in their own order.
    pub nodes: Vec<PlanStabNode>,
    /// For each node two distinct points of a line through its sequence, in its direction and in
    /// world units; empty where lines were not asked for.
    pub lines: Vec<[[Number; 2]; 2]>,
}

/// What a stab tree comes to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PlanTreeSize {
    /// The cell that it is of.
    pub source: CellId,
    /// Its nodes: open sequences of one portal or more.
    pub nodes: u64,
    /// The portals of the longest sequence.
    pub depth: u32,
    /// The cells that it enters: those that the source sees, without itself.
    pub cells: u32,
}

impl PlanStabTree {
    /// The cells that the source sees, ascending, itself among them.
    pub fn cells(&self) -> Vec<CellId> {
        let entered = self.nodes.iter().map(|node| node.cell);
        let mut cells: Vec<CellId> = std::iter::once(self.source).chain(entered).collect();
        cells.sort_unstable();
        cells.dedup();
        cells
    }
}

/// The stab trees of `sources`, in their order; `None` if interrupted.
///
/// Runs on rayon's current thread pool; the result does not depend on it.
///
/// # Panics
/// If the graph states no polygons: then nothing says that its cells are convex.
pub fn plan_stab_trees(
    graph: &PlanGraph,
    crossings: &Crossings,
    sources: &[CellId],
    wants_lines: bool,
    progress: &dyn Progress,
) -> Option<Vec<PlanStabTree>> {
    each_tree(graph, crossings, sources, progress, |walk, source| {
        let mut tree = PlanStabTree { source, nodes: Vec::new(), lines: Vec::new() };
        // The node of each portal on the way, and a line through all up to it.
        let mut way: Vec<u32> = Vec::new();
        let mut lines: Vec<Through> = Vec::new();
        walk.from(source, None, progress, &mut |path| {
            let (last, before) = path.split_last().expect("a portal was crossed");
            way.truncate(before.len());
            let parent = way.last().copied();
            way.push(tree.nodes.len() as u32);
            tree.nodes.push(PlanStabNode { parent, portal: last.portal, cell: last.to });
            if wants_lines {
                lines.truncate(before.len());
                let points = &|end| graph.points.get(end);
                let inherited = lines.last().filter(|line| line.passes(points, last));
                let line = inherited.cloned().unwrap_or_else(|| witness::through(points, path));
                tree.lines.push(line.in_world(&graph.grid));
                lines.push(line);
            }
        })?;
        Some(tree)
    })
}

/// The size of the stab trees of `sources`, in their order, none of which is kept; `None` if
/// interrupted.
///
/// # Panics
/// If the graph states no polygons.
pub fn plan_tree_sizes(
    graph: &PlanGraph,
    crossings: &Crossings,
    sources: &[CellId],
    progress: &dyn Progress,
) -> Option<Vec<PlanTreeSize>> {
    each_tree(graph, crossings, sources, progress, |walk, source| {
        let mut size = PlanTreeSize { source, nodes: 0, depth: 0, cells: 0 };
        let mut entered = vec![false; graph.cells.len()];
        walk.from(source, None, progress, &mut |path| {
            size.nodes += 1;
            size.depth = size.depth.max(path.len() as u32);
            let cell = path[path.len() - 1].to;
            if !std::mem::replace(&mut entered[cell.0 as usize], true) {
                size.cells += 1;
            }
        })?;
        Some(size)
    })
}

fn each_tree<T: Send>(
    graph: &PlanGraph,
    crossings: &Crossings,
    sources: &[CellId],
    progress: &dyn Progress,
    tree: impl Fn(&mut Walk<PlanPoints>, CellId) -> Option<T> + Sync,
) -> Option<Vec<T>> {
    assert!(graph.polygons.len() == graph.cells.len(), "a graph without its cells' polygons");
    progress.begin("stab trees", sources.len() as u64);
    sources
        .par_iter()
        .map_init(
            || Walk::new(&graph.points, crossings, graph.cells.len(), Place::Beyond),
            |walk, &source| {
                let tree = tree(walk, source)?;
                progress.advance(1);
                Some(tree)
            },
        )
        .collect()
}

/// How often, in pushes, an interrupt is looked for.
const INTERRUPT_INTERVAL: u32 = 1 << 10;

/// The search, with the memory that it uses from one source to the next.
pub(super) struct Walk<'a, E> {
    ends: &'a E,
    crossings: &'a Crossings,
    place: Place,
    chains: Chains,
    is_crossed: Vec<bool>,
    path: Vec<Crossing>,
    /// The ways that are left of each cell on the path, the source's first.
    left: Vec<&'a [Crossing]>,
    pushes: u32,
}

impl<'a, E: Ends> Walk<'a, E> {
    pub(super) fn new(
        ends: &'a E,
        crossings: &'a Crossings,
        cells: usize,
        place: Place,
    ) -> Walk<'a, E> {
        Walk {
            ends,
            crossings,
            place,
            chains: Chains::default(),
            is_crossed: vec![false; cells],
            path: Vec::new(),
            left: Vec::new(),
            pushes: 0,
        }
    }

    /// Visits every open sequence from `source`, and where a segment is given as the first of all
    /// sequences, every one that is open behind it. `None` if interrupted.
    pub(super) fn from(
        &mut self,
        source: CellId,
        first: Option<[u32; 2]>,
        progress: &dyn Progress,
        visit: &mut impl FnMut(&Ways),
    ) -> Option<()> {
        if let Some([left, right]) = first {
            self.chains.push(self.ends, left, right, self.place);
        }
        self.is_crossed[source.0 as usize] = true;
        self.left.push(self.crossings.from(source));
        let is_done = self.walk(progress, visit);
        while let Some(way) = self.path.pop() {
            self.chains.pop();
            self.is_crossed[way.to.0 as usize] = false;
        }
        self.left.clear();
        self.is_crossed[source.0 as usize] = false;
        if first.is_some() {
            self.chains.pop();
        }
        is_done
    }

    fn walk(&mut self, progress: &dyn Progress, visit: &mut impl FnMut(&Ways)) -> Option<()> {
        while let Some(ways) = self.left.last_mut() {
            let Some((&way, others)) = ways.split_first() else {
                self.left.pop();
                if let Some(way) = self.path.pop() {
                    self.chains.pop();
                    self.is_crossed[way.to.0 as usize] = false;
                }
                continue;
            };
            *ways = others;
            if self.is_crossed[way.to.0 as usize] {
                continue;
            }
            self.pushes = self.pushes.wrapping_add(1);
            if self.pushes.is_multiple_of(INTERRUPT_INTERVAL) && progress.is_interrupted() {
                return None;
            }
            if !self.chains.push(self.ends, way.left, way.right, self.place) {
                self.chains.pop();
                continue;
            }
            self.is_crossed[way.to.0 as usize] = true;
            self.path.push(way);
            self.left.push(self.crossings.from(way.to));
            visit(&self.path);
        }
        Some(())
    }
}

#[cfg(test)]
pub(super) mod tests;
