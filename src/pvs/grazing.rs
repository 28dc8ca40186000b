//! Which pairs that are not open are grazing: joined by a sequence that a touching line meets.
//!
//! A touching line need not keep the order of the portals, and may run inside their planes
//! (`docs/semantics.md`), so none of the search's prunings apply to it. What does hold: a line
//! that touches a sequence touches every beginning of it. So the sequences from each cell are
//! walked, none entering a cell twice, and one that is blocked is not extended.
//!
//! Complexity: an exact verdict a sequence, and touching lines run along every wall; the number of
//! sequences grows exponentially with the number of coplanar portals. For small and middle-sized
//! graphs, or with a budget.

use super::arena::{Arena, Directed};
use super::bits::Bits;
use crate::report::{Matrix, Progress, Verdict};
use crate::scene::PortalGraph;
use crate::stab::{self, Portal3, Stabber};
use rayon::prelude::*;

/// Splits the pairs that are not open into grazing and blocked.
///
/// Visits at most `budget` sequences for each source cell; pairs not settled by then become
/// undecided. `false`, with the matrix as it was, if interrupted.
pub fn classify_grazing(
    graph: &PortalGraph,
    matrix: &mut Matrix,
    budget: Option<u64>,
    progress: &dyn Progress,
) -> bool {
    let arena = Arena::new(graph);
    let all: Vec<Directed> = (0..arena.directed()).collect();
    let (portals, _) = arena.exact_portals(&all);
    progress.begin("grazing pairs", u64::from(arena.cells()));
    let known = &*matrix;
    let rows: Option<Vec<Touched>> = (0..arena.cells())
        .into_par_iter()
        .with_max_len(1)
        .map(|source| {
            let mut wanted = arena.no_cells();
            for target in source + 1..arena.cells() {
                if known.get(source as usize, target as usize) == Verdict::NotOpen {
                    wanted.insert(target);
                }
            }
            let row = Walk::new(&arena, &portals, budget, progress, wanted).from(source);
            progress.advance(1);
            row
        })
        .collect();
    let Some(rows) = rows else { return false };
    for (source, row) in rows.iter().enumerate() {
        let settled = row.touched.iter().map(|cell| (cell, Verdict::Grazing));
        let left = row.undecided.iter().map(|cell| (cell, Verdict::Undecided));
        for (target, verdict) in settled.chain(left) {
            matrix.set(source, target as usize, verdict);
            matrix.set(target as usize, source, verdict);
        }
    }
    true
}

/// What a source's walk found.
struct Touched {
    touched: Bits,
    undecided: Bits,
}

struct Walk<'a> {
    arena: &'a Arena,
    portals: &'a [Portal3],
    budget: Option<u64>,
    progress: &'a dyn Progress,
    stabber: Stabber,
    crossed: Bits,
    wanted: Bits,
    touched: Bits,
    visited: u64,
}

/// Why a walk ended early.
enum Ended {
    Budget,
    Interrupted,
}

impl<'a> Walk<'a> {
    fn new(
        arena: &'a Arena,
        portals: &'a [Portal3],
        budget: Option<u64>,
        progress: &'a dyn Progress,
        wanted: Bits,
    ) -> Walk<'a> {
        Walk {
            arena,
            portals,
            budget,
            progress,
            stabber: Stabber::new(),
            crossed: arena.no_cells(),
            wanted,
            touched: arena.no_cells(),
            visited: 0,
        }
    }

    /// `None` if interrupted.
    fn from(mut self, source: u32) -> Option<Touched> {
        self.crossed.insert(source);
        let mut ended = Ok(());
        for &first in self.arena.leaving(source) {
            ended = ended.and_then(|()| self.visit(first));
        }
        let undecided = match ended {
            Ok(()) => self.arena.no_cells(),
            Err(Ended::Budget) => self.wanted,
            Err(Ended::Interrupted) => return None,
        };
        Some(Touched { touched: self.touched, undecided })
    }

    fn visit(&mut self, next: Directed) -> Result<(), Ended> {
        let arena = self.arena;
        let cell = arena.to(next);
        if self.wanted.is_empty() || self.crossed.has(cell) {
            return Ok(());
        }
        if self.progress.is_interrupted() {
            return Err(Ended::Interrupted);
        }
        if self.budget.is_some_and(|budget| self.visited >= budget) {
            return Err(Ended::Budget);
        }
        self.visited += 1;
        self.stabber.push(&self.portals[next as usize], false);
        self.crossed.insert(cell);
        let touches = match self.stabber.verdict() {
            stab::Verdict::Open { .. } | stab::Verdict::Grazing { .. } => true,
            stab::Verdict::Blocked { .. } => false,
        };
        if touches {
            if self.wanted.has(cell) {
                self.wanted.remove(cell);
                self.touched.insert(cell);
            }
            for &child in arena.leaving(cell) {
                self.visit(child)?;
            }
        }
        self.crossed.remove(cell);
        self.stabber.pop();
        Ok(())
    }
}
