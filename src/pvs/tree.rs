//! Stab trees: every open portal sequence from a cell, as a tree (Teller and Séquin 1991, §3.3).
//!
//! Each node is a portal crossed into a cell; the way from the root to it is an open sequence that
//! enters no cell twice, and it carries a sightline. The number of nodes has no useful bound.

use super::arena::{Arena, Directed};
use super::bits::Bits;
use super::bounds::Bounds;
use super::decide::{Decider, Decision};
use super::{Sightline, Tally};
use crate::report::Progress;
use crate::scene::{CellId, PortalGraph};
use rayon::prelude::*;

/// The open sequences from one cell.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StabTree {
    /// The cell.
    pub source: CellId,
    /// The nodes, each after its parent, in the order of a depth-first walk.
    pub nodes: Vec<StabNode>,
}

/// An open sequence: that of the parent, and one portal more.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StabNode {
    /// The index of the node of the sequence without its last portal; `None` for one portal.
    pub parent: Option<u32>,
    /// The last portal, by its number in the input.
    pub portal: u32,
    /// The cell that it enters.
    pub cell: CellId,
    /// A line through the whole sequence.
    pub line: Sightline,
}

/// The stab trees of `sources`, in their order; `None` if interrupted.
pub fn stab_trees(
    graph: &PortalGraph,
    sources: &[CellId],
    progress: &dyn Progress,
) -> Option<Vec<StabTree>> {
    let arena = Arena::new(graph);
    progress.begin("upper bound", super::bounds::STAGES);
    let bounds = Bounds::new(&arena, progress)?;
    progress.begin("stab trees", sources.len() as u64);
    sources
        .par_iter()
        .with_max_len(1)
        .map(|&source| {
            let tree = Walk::new(&arena, &bounds, progress).tree(source)?;
            progress.advance(1);
            Some(tree)
        })
        .collect()
}

struct Walk<'a> {
    arena: &'a Arena,
    bounds: &'a Bounds,
    progress: &'a dyn Progress,
    decider: Decider<'a>,
    path: Vec<Directed>,
    crossed: Bits,
    nodes: Vec<StabNode>,
    tally: Tally,
}

impl<'a> Walk<'a> {
    fn new(arena: &'a Arena, bounds: &'a Bounds, progress: &'a dyn Progress) -> Walk<'a> {
        Walk {
            arena,
            bounds,
            progress,
            decider: Decider::new(arena),
            path: Vec::new(),
            crossed: arena.no_cells(),
            nodes: Vec::new(),
            tally: Tally::default(),
        }
    }

    fn tree(mut self, source: CellId) -> Option<StabTree> {
        self.crossed.insert(source.0);
        for &first in self.arena.leaving(source.0) {
            self.visit(first, None)?;
        }
        Some(StabTree { source, nodes: self.nodes })
    }

    /// `None` if interrupted.
    fn visit(&mut self, next: Directed, parent: Option<u32>) -> Option<()> {
        let arena = self.arena;
        let cell = arena.to(next);
        let follows = |&before: &Directed| self.bounds.after(before).has(next);
        if self.crossed.has(cell) || !self.path.iter().all(follows) {
            return Some(());
        }
        if self.progress.is_interrupted() {
            return None;
        }
        self.path.push(next);
        self.crossed.insert(cell);
        if self.decider.extend(&self.path, &mut self.tally) {
            match self.decider.decide(&self.path, &mut self.tally) {
                Decision::NotOpen => {}
                Decision::Open(line) => {
                    let node = self.nodes.len() as u32;
                    let portal = arena.source(next);
                    self.nodes.push(StabNode { parent, portal, cell: CellId(cell), line });
                    for &child in arena.leaving(cell) {
                        self.visit(child, Some(node))?;
                    }
                }
            }
        }
        self.crossed.remove(cell);
        self.path.pop();
        self.decider.truncate(self.path.len());
        Some(())
    }
}
