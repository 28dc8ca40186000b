//! All rows of a graph, or a part of them, on any number of threads.

use super::arena::Arena;
use super::bounds::{self, Bounds, SharedBounds};
use super::obstacle::{self, Obstacle};
use super::search::{DeadEnds, Limits, Search};
use super::sources::{Source, share_out};
use super::{OpenPair, Row, Tally};
use crate::report::Progress;
use crate::scene::{CellId, PortalGraph};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering::Relaxed};

/// What to compute, and within which limits.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Options {
    /// The most portal sequences to visit for one source cell; pairs not settled by then are
    /// undecided.
    pub budget: Option<u64>,
    /// Which of the rows.
    pub shard: Shard,
    /// Leave every side to the exact stage, none to the float filters: much slower, with the same
    /// verdicts (tests compare the two); lines are then found by exact cones only.
    pub without_filters: bool,
}

/// A part of the rows: those of the sources whose place in the order of work is `index` modulo
/// `count`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    /// From 0 to `count - 1`.
    pub index: u32,
    /// At least 1.
    pub count: u32,
}

impl Default for Shard {
    /// All rows.
    fn default() -> Shard {
        Shard { index: 0, count: 1 }
    }
}

/// Why a pair is open or not.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Explanation {
    /// A cell and itself.
    SameCell,
    /// A sightline, from the first cell to the second.
    Open(OpenPair),
    /// The bound has no way from the one cell to the other.
    OutOfBound(Obstacle),
    /// Every sequence that the bound left was refuted.
    Refuted(DeadEnds),
}

/// Explains the pair of cells `from` and `to`; `None` if interrupted.
///
/// # Panics
/// If a cell does not exist.
pub fn explain(
    graph: &PortalGraph,
    from: CellId,
    to: CellId,
    progress: &dyn Progress,
) -> Option<Explanation> {
    let exists = |cell: CellId| (cell.0 as usize) < graph.cells.len();
    assert!(exists(from) && exists(to), "a cell that does not exist");
    if from == to {
        return Some(Explanation::SameCell);
    }
    let arena = Arena::new(graph);
    progress.begin("upper bound", bounds::STAGES);
    let bounds = Bounds::new(&arena, progress)?;
    let sources = share_out(&arena, |cell| bounds.cells_from(&arena, cell));
    // The same source as in the whole computation, so the same sightline.
    let source = sources.iter().find(|source| {
        let has = |a: CellId, b: CellId| source.cell == a.0 && source.wanted.has(b.0);
        has(from, to) || has(to, from)
    });
    let Some(source) = source else {
        return Some(Explanation::OutOfBound(obstacle::find(&arena, &bounds, from.0, to.0)));
    };
    let is_forward = source.cell == from.0;
    let shared = SharedBounds::new(bounds);
    let is_interrupted = || progress.is_interrupted();
    let limits = Limits { budget: None, is_interrupted: &is_interrupted };
    let mut search = Search::new(&arena, &shared, &limits);
    let target = if is_forward { to } else { from };
    // All that the source wants is searched for: what is settled first decides which line settles
    // the pair.
    let row = search.row(source.cell, source.wanted.clone())?;
    let found = row.open.into_iter().find(|pair| pair.target == target);
    let Some(pair) = found else {
        let mut only = arena.no_cells();
        only.insert(target.0);
        search.row(source.cell, only)?;
        let dead_ends = search.dead_ends();
        return Some(Explanation::Refuted(if is_forward {
            dead_ends
        } else {
            dead_ends.reversed()
        }));
    };
    Some(Explanation::Open(if is_forward { pair } else { pair.reversed(CellId(to.0)) }))
}

/// What [`compute`] came to.
#[derive(Clone, Debug, Default)]
pub struct Finished {
    /// The finished rows, those given included, in ascending order of their sources.
    pub rows: Vec<Row>,
    /// Whether all rows that were asked for are among them.
    pub is_complete: bool,
    /// Unordered pairs that the upper bound alone settled as not open.
    pub settled_by_bound: u64,
    /// The counts of all rows.
    pub tally: Tally,
}

/// Computes the rows of `options.shard`, except those `done` already; `keep` is told of each new
/// one as it is finished, from any thread.
///
/// Runs on rayon's current thread pool. An interrupt through `progress` ends it with the rows
/// finished so far.
pub fn compute(
    graph: &PortalGraph,
    options: &Options,
    done: Vec<Row>,
    keep: &(dyn Fn(&Row) + Sync),
    progress: &dyn Progress,
) -> Finished {
    let arena = match options.without_filters {
        false => Arena::new(graph),
        true => Arena::without_filters(graph),
    };
    progress.begin("upper bound", bounds::STAGES);
    let Some(bounds) = Bounds::new(&arena, progress) else {
        return Finished { rows: done, ..Finished::default() };
    };
    let sources = share_out(&arena, |cell| bounds.cells_from(&arena, cell));
    let cells = u64::from(arena.cells());
    let candidates: u64 = sources.iter().map(Source::work).sum();
    let mut finished = Finished {
        settled_by_bound: cells * cells.saturating_sub(1) / 2 - candidates,
        rows: done,
        ..Finished::default()
    };
    let mut is_done = arena.no_cells();
    finished.rows.iter().for_each(|row| {
        is_done.insert(row.source.0);
    });
    let Shard { index, count } = options.shard;
    let todo: Vec<&Source> = sources
        .iter()
        .skip(index as usize)
        .step_by(count as usize)
        .filter(|source| !is_done.has(source.cell))
        .collect();
    let rows = search(&arena, &SharedBounds::new(bounds), &todo, options, keep, progress);
    finished.is_complete = rows.len() == todo.len();
    finished.rows.extend(rows);
    finished.rows.sort_unstable_by_key(|row| row.source);
    finished.rows.iter().for_each(|row| finished.tally.add(&row.tally));
    finished
}

/// The rows of the sources that were finished before an interrupt.
pub(super) fn search(
    arena: &Arena,
    shared: &SharedBounds,
    todo: &[&Source],
    options: &Options,
    keep: &(dyn Fn(&Row) + Sync),
    progress: &dyn Progress,
) -> Vec<Row> {
    let stopped = AtomicBool::new(false);
    let is_interrupted = || {
        let stop = stopped.load(Relaxed) || progress.is_interrupted();
        if stop {
            stopped.store(true, Relaxed);
        }
        stop
    };
    let limits = Limits { budget: options.budget, is_interrupted: &is_interrupted };
    progress.begin("cells", todo.iter().map(|source| source.work()).sum());
    let next = AtomicUsize::new(0);
    // Each thread keeps one search, and what it has learnt, from source to source.
    let of_threads = rayon::broadcast(|_| {
        let mut search = Search::new(arena, shared, &limits);
        let mut rows = Vec::new();
        while let Some(source) = todo.get(next.fetch_add(1, Relaxed)) {
            let Some(row) = search.row(source.cell, source.wanted.clone()) else { break };
            // A budget counts sequences, so what others found must not change their number.
            if options.budget.is_none() {
                for other in search.not_open() {
                    shared.refute(arena, source.cell, other);
                }
            }
            keep(&row);
            progress.advance(source.work());
            rows.push(row);
        }
        rows
    });
    of_threads.into_iter().flatten().collect()
}
