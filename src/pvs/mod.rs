//! The potentially visible set of a portal graph, exactly: which pairs of cells see each other.
//!
//! Cell A sees cell B iff some portal sequence between them is open (`docs/semantics.md`). The
//! computation works from both sides (Teller 1992, §8.3; the order of the work is this crate's
//! own): an upper bound for each directed portal of what might be crossed after it (`bounds`), and
//! for each cell a depth-first search of the sequences from it (`search`) that narrows the bound
//! at each step, proves sequences open by a line, and leaves those that it proves not open.
//! Of two cells, the one with the smaller bound is the source, so each pair is settled once and
//! the result is symmetric.
//!
//! The result comes as one [`Row`] a source cell, which do not depend on each other: they can be
//! computed by different processes, kept, and put together by [`assemble`].
//!
//! **Invariants.** The verdicts and lines are a function of the graph and of the options that
//! change results (not of the number of threads, nor of which rows are computed together; only the
//! tallies are); every open pair comes with a line that was checked exactly; no pair is called not
//! open without proof.

mod arena;
mod bits;
mod bounds;
mod decide;
mod grazing;
mod grid;
mod objects;
mod obstacle;
mod part;
pub mod plan;
mod proof;
mod propose;
mod run;
mod search;
mod separators;
mod sightline;
mod sources;
mod tree;

pub use grazing::classify_grazing;
pub use objects::{ObjectSight, assemble_objects, bound_objects, compute_objects, object_sights};
pub use obstacle::{Hindrance, Obstacle};
pub use part::{Part, PartError, PartHeader};
pub use proof::{Found, write_proof};
pub use run::{Explanation, Finished, Options, Shard, compute, explain};
pub use search::{DeadEnd, DeadEnds};
pub use sightline::Sightline;
pub use tree::{StabNode, StabTree, stab_trees};

use crate::report::{Matrix, PairWitness, Verdict, WitnessLine};
use crate::scene::{CellId, PortalGraph};

/// What was found for one source cell: the verdicts of the pairs that it is the source of.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Row {
    /// The source.
    pub source: CellId,
    /// The cells proved open, in ascending order.
    pub open: Vec<OpenPair>,
    /// The cells left undecided by a budget, in ascending order.
    pub undecided: Vec<CellId>,
    /// How the work went.
    pub tally: Tally,
}

/// A cell that the source sees, and how.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OpenPair {
    /// The cell seen.
    pub target: CellId,
    /// The portals crossed on the way, by their numbers in the input.
    pub portals: Vec<u32>,
    /// A line through them.
    pub line: Sightline,
}

impl OpenPair {
    /// The same from the other end: `target` is the cell that the line came from.
    pub fn reversed(mut self, target: CellId) -> OpenPair {
        self.portals.reverse();
        OpenPair { target, portals: self.portals, line: self.line.reversed() }
    }
}

/// Counts of one row's work, or of many.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// Pairs that the upper bound left to be settled.
    pub candidates: u64,
    /// Pairs found not open by the search.
    pub refuted: u64,
    /// Portal sequences visited.
    pub visited: u64,
    /// Sequences left because some of their edges exclude each other.
    pub excluded: u64,
    /// Pairs proved open by the line of a shorter sequence.
    pub inherited: u64,
    /// Pairs proved open by a line found in floats.
    pub proposed: u64,
    /// Exact cones built.
    pub cones: u64,
    /// Pairs proved open by an exact cone.
    pub cone_open: u64,
}

/// The verdicts of all pairs, from the rows of all sources.
///
/// Pairs that no row mentions are not open, so the rows must be complete.
pub fn assemble(graph: &PortalGraph, rows: &[Row]) -> Matrix {
    let mut matrix = Matrix::new(graph.cells.len(), Verdict::NotOpen);
    for cell in 0..graph.cells.len() {
        matrix.set(cell, cell, Verdict::Open);
    }
    for row in rows {
        let source = row.source.0 as usize;
        let open = row.open.iter().map(|pair| (pair.target, Verdict::Open));
        let undecided = row.undecided.iter().map(|&cell| (cell, Verdict::Undecided));
        for (target, verdict) in open.chain(undecided) {
            matrix.set(source, target.0 as usize, verdict);
            matrix.set(target.0 as usize, source, verdict);
        }
    }
    matrix
}

/// The witnesses of all open pairs of different cells, each from the lower cell to the higher, in
/// ascending order.
pub fn witnesses(rows: &[Row]) -> Vec<PairWitness> {
    let mut all: Vec<PairWitness> = rows
        .iter()
        .flat_map(|row| row.open.iter().map(|pair| witness(row.source.0, pair)))
        .collect();
    all.sort_unstable_by_key(|witness| (witness.from, witness.to));
    all
}

fn witness(source: u32, pair: &OpenPair) -> PairWitness {
    let target = pair.target.0;
    let pair = pair.clone();
    let (from, to) = (source.min(target), source.max(target));
    let pair = if source < target { pair } else { pair.reversed(CellId(source)) };
    let line = WitnessLine::Space(pair.line.numbers());
    PairWitness { from, to, portals: pair.portals, line }
}
