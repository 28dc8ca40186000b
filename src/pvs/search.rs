//! The depth-first search for the sightlines of one source cell.
//!
//! The search walks the portal sequences that leave the source, each cell at most once, and keeps
//! for each the *might-set*: the directed portals that a line through the sequence might still
//! cross on its way to a cell that is *wanted* (not yet proved open). A portal leaves the might-set
//! - if the bounds say that it cannot follow the last portal;
//! - if it is wholly behind a plane that separates two portals of the sequence;
//! - if it does not lie on a way, through the rest of the set, to a wanted cell, or cannot be
//!   followed by any portal into one.
//!
//! A sequence whose might-set has no way to a wanted cell is left; so is one whose edges exclude
//! each other (Gordan's alternative, checked exactly). A sequence that enters a wanted cell is
//! decided: a line proved open settles the cell, a sequence proved not open is left. Other
//! sequences go on undecided, which costs less than deciding them all.
//!
//! **Completeness.** Only sequences that are not open, or lead to no wanted cell, are left, and
//! every open sequence to a wanted cell is decided. So what is still wanted at the end is not open.
//!
//! **Determinism.** Children are visited in the order of their numbers, and whether and by which
//! line a sequence is proved open depends on the sequence and the wanted cells before it only. By
//! induction over the visits, every cell is settled by the same line however much or little is
//! pruned: pruning never removes an open sequence to a wanted cell, and the others settle nothing.
//! Threads may therefore share what shrinks the bounds. Only the count of visited sequences
//! depends on it, so a budget on that count does without sharing (`run`).
//!
//! Cost: per visited sequence, the separating planes of two pairs of portals times the might-set;
//! the number of sequences has no useful bound (it is exponential in the worst case).

use super::arena::{Arena, Directed, reverse};
use super::bits::Bits;
use super::bounds::{Flood, SharedBounds};
use super::decide::{Decider, Decision};
use super::propose::PlaneHints;
use super::separators::SeparatorCache;
use super::{OpenPair, Row, Tally};
use crate::scene::CellId;

/// What may end a search early.
pub(crate) struct Limits<'a> {
    /// The most sequences to visit for one source.
    pub budget: Option<u64>,
    /// Whether to give up at once.
    pub is_interrupted: &'a (dyn Fn() -> bool + Sync),
}

/// Why a sequence was left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DeadEnd {
    /// No portal that might follow has a way to a wanted cell.
    NoWay,
    /// Some edges of its portals exclude each other.
    Excluded,
    /// It was decided, and is not open.
    NotOpen,
}

/// The sequences that a search had to leave.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct DeadEnds {
    /// How many were left because nothing that follows leads on.
    pub no_way: u64,
    /// How many were left because edges exclude each other.
    pub excluded: u64,
    /// How many were decided and are not open.
    pub not_open: u64,
    /// A longest one, by the input's numbers of its portals, and why it was left.
    pub longest: Option<(Vec<u32>, DeadEnd)>,
}

impl DeadEnds {
    /// The same as seen from the other end.
    pub fn reversed(mut self) -> DeadEnds {
        if let Some((portals, _)) = &mut self.longest {
            portals.reverse();
        }
        self
    }
}

/// How often, in visited sequences, an interrupt is looked for.
const INTERRUPT_INTERVAL: u64 = 256;

/// Why a search ended before everything was settled.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Ended {
    Not,
    Budget,
    Interrupted,
}

/// What belongs to one portal of the current sequence.
struct Level {
    might: Bits,
    /// Where this level's separating planes begin in `Search::planes`.
    first_plane: usize,
}

/// A search, with the buffers that are reused from source to source.
pub(crate) struct Search<'a> {
    arena: &'a Arena,
    bounds: &'a SharedBounds,
    limits: &'a Limits<'a>,
    wanted: Bits,
    row: Row,
    ended: Ended,
    path: Vec<Directed>,
    /// The cells of the sequence, the source among them.
    crossed: Bits,
    levels: Vec<Level>,
    decider: Decider<'a>,
    flood: Flood,
    separators: SeparatorCache,
    /// The separating planes of the sequence, and whether a plane is among them.
    planes: Vec<u32>,
    is_active: Vec<bool>,
    hints: PlaneHints,
    candidates: Bits,
    goals: Bits,
    goal_portals: Bits,
    goal_words: Vec<(u32, u64)>,
    stack: Vec<u32>,
    dead_ends: DeadEnds,
    longest: Option<(Vec<Directed>, DeadEnd)>,
}

impl<'a> Search<'a> {
    pub fn new(arena: &'a Arena, bounds: &'a SharedBounds, limits: &'a Limits<'a>) -> Search<'a> {
        Search {
            arena,
            bounds,
            limits,
            wanted: arena.no_cells(),
            row: Row::default(),
            ended: Ended::Not,
            path: Vec::new(),
            crossed: arena.no_cells(),
            levels: Vec::new(),
            decider: Decider::new(arena),
            flood: Flood::new(arena),
            separators: SeparatorCache::default(),
            planes: Vec::new(),
            is_active: Vec::new(),
            hints: PlaneHints::default(),
            candidates: arena.no_portals(),
            goals: arena.no_cells(),
            goal_portals: arena.no_portals(),
            goal_words: Vec::new(),
            stack: Vec::new(),
            dead_ends: DeadEnds::default(),
            longest: None,
        }
    }

    /// Settles the `wanted` cells of `source`; `None` if the search was interrupted.
    pub fn row(&mut self, source: u32, wanted: Bits) -> Option<Row> {
        self.separators.trim();
        self.row = Row { source: CellId(source), ..Row::default() };
        self.row.tally.candidates = u64::from(wanted.count());
        self.wanted = wanted;
        self.ended = Ended::Not;
        self.dead_ends = DeadEnds::default();
        self.longest = None;
        self.crossed.insert(source);
        for &first in self.arena.leaving(source) {
            self.visit(first);
        }
        self.crossed.remove(source);
        let left = self.wanted.iter().map(CellId);
        match self.ended {
            Ended::Interrupted => return None,
            Ended::Budget => self.row.undecided = left.collect(),
            Ended::Not => self.row.tally.refuted = left.count() as u64,
        }
        self.row.open.sort_by_key(|pair| pair.target);
        Some(std::mem::take(&mut self.row))
    }

    /// The cells found not open by the last, complete, row.
    pub fn not_open(&self) -> impl Iterator<Item = u32> + '_ {
        self.wanted.iter()
    }

    fn visit(&mut self, next: Directed) {
        if self.is_over() {
            return;
        }
        self.push(next);
        let left = match self.might_reach_wanted(next) {
            false => Some(DeadEnd::NoWay),
            true => self.leave_or_settle(next),
        };
        match left {
            Some(dead_end) => self.note(dead_end),
            None => self.visit_children(next),
        }
        self.pop();
    }

    fn visit_children(&mut self, next: Directed) {
        let arena = self.arena;
        for &child in arena.onward(arena.to(next)) {
            let level = &self.levels[self.path.len() - 1];
            if level.might.has(child) && !self.crossed.has(arena.to(child)) {
                self.visit(child);
            }
        }
    }

    fn note(&mut self, dead_end: DeadEnd) {
        *match dead_end {
            DeadEnd::NoWay => &mut self.dead_ends.no_way,
            DeadEnd::Excluded => &mut self.dead_ends.excluded,
            DeadEnd::NotOpen => &mut self.dead_ends.not_open,
        } += 1;
        if self.longest.as_ref().is_none_or(|(path, _)| path.len() < self.path.len()) {
            self.longest = Some((self.path.clone(), dead_end));
        }
    }

    fn is_over(&mut self) -> bool {
        if self.ended == Ended::Not {
            if self.limits.budget.is_some_and(|budget| self.row.tally.visited >= budget) {
                self.ended = Ended::Budget;
            } else if self.row.tally.visited.is_multiple_of(INTERRUPT_INTERVAL)
                && (self.limits.is_interrupted)()
            {
                self.ended = Ended::Interrupted;
            }
        }
        self.ended != Ended::Not || self.wanted.is_empty()
    }

    fn push(&mut self, next: Directed) {
        self.row.tally.visited += 1;
        let depth = self.path.len();
        if self.levels.len() == depth {
            self.levels.push(Level { might: self.arena.no_portals(), first_plane: 0 });
        }
        self.levels[depth].first_plane = self.planes.len();
        self.path.push(next);
        self.crossed.insert(self.arena.to(next));
    }

    fn pop(&mut self) {
        let Some(last) = self.path.pop() else { return };
        self.crossed.remove(self.arena.to(last));
        for id in self.planes.drain(self.levels[self.path.len()].first_plane..) {
            self.is_active[id as usize] = false;
        }
        self.decider.truncate(self.path.len());
    }

    /// Computes the might-set of the sequence that now ends with `next`; whether it has a way to a
    /// wanted cell. The planes that separate the first portal from `next` are the most telling;
    /// those of the second or the third, by turns, get past the rest. More planes spare a third of
    /// the visits that are left, but cost more than these.
    fn might_reach_wanted(&mut self, next: Directed) -> bool {
        let depth = self.path.len() - 1;
        let after = self.bounds.after(next);
        if depth == 0 {
            self.candidates.assign_shared(after);
            if !self.sift(next, None) {
                return false;
            }
        } else {
            self.candidates.assign_shared_intersection(&self.levels[depth - 1].might, after);
            if !self.sift(next, Some(0)) {
                return false;
            }
            let position = 1 + depth % 2;
            if position < depth {
                std::mem::swap(&mut self.candidates, &mut self.flood.reached);
                if !self.sift(next, Some(position)) {
                    return false;
                }
            }
        }
        self.aim(depth);
        true
    }

    /// Floods the candidates from `next` past the planes that separate it from the portal of the
    /// path at `position`; whether a wanted cell is entered.
    fn sift(&mut self, next: Directed, position: Option<usize>) -> bool {
        let arena = self.arena;
        let first = self.planes.len();
        self.hints.clear();
        if let Some(position) = position {
            for &id in self.separators.get(arena, self.path[position], next) {
                if self.is_active.len() <= id as usize {
                    self.is_active.resize(id as usize + 1024, false);
                }
                // A plane of the sequence so far has had its say when the might-set was made.
                if !std::mem::replace(&mut self.is_active[id as usize], true) {
                    self.planes.push(id);
                }
            }
        }
        let (planes, separators) = (&self.planes[first..], &self.separators);
        for &id in planes {
            self.hints.push(separators.plane(id).filter());
        }
        let hints = &self.hints;
        self.flood.run(arena, next, &self.candidates, |portal| {
            hints.any_behind(arena.outline(portal).center, |index| {
                arena.wholly_behind(separators.plane(planes[index]), portal)
            })
        });
        self.goals.assign_intersection(&self.flood.entered, &self.wanted);
        !self.goals.is_empty()
    }

    /// Keeps in the level's might-set what lies on a way to a wanted cell.
    fn aim(&mut self, depth: usize) {
        let arena = self.arena;
        self.goal_portals.clear();
        for portal in self.flood.reached.iter() {
            if self.wanted.has(arena.to(portal)) {
                self.goal_portals.insert(portal);
            }
        }
        self.goal_portals.words(&mut self.goal_words);
        let (bounds, goal_portals, words) = (self.bounds, &self.goal_portals, &self.goal_words);
        self.flood
            .reached
            .retain(|portal| goal_portals.has(portal) || bounds.after(portal).intersects(words));
        let might = &mut self.levels[depth].might;
        might.clear();
        self.stack.extend(self.goals.iter());
        while let Some(cell) = self.stack.pop() {
            for &leaving in arena.leaving(cell) {
                let entering = reverse(leaving);
                if self.flood.reached.has(entering)
                    && might.insert(entering)
                    && self.goals.insert(arena.from(entering))
                {
                    self.stack.push(arena.from(entering));
                }
            }
        }
    }

    /// Why the sequence that now ends with `next` is left, as far as that has to be known; settles
    /// the cell it enters, if that is wanted and the sequence is open.
    fn leave_or_settle(&mut self, next: Directed) -> Option<DeadEnd> {
        let cell = self.arena.to(next);
        let tally = &mut self.row.tally;
        if !self.decider.extend(&self.path, tally) {
            return Some(DeadEnd::Excluded);
        }
        if !self.wanted.has(cell) {
            return None;
        }
        match self.decider.decide(&self.path, tally) {
            Decision::NotOpen => Some(DeadEnd::NotOpen),
            Decision::Open(line) => {
                self.wanted.remove(cell);
                let portals = self.portals_of(&self.path);
                self.row.open.push(OpenPair { target: CellId(cell), portals, line });
                None
            }
        }
    }

    /// The input's numbers of the portals of a path.
    fn portals_of(&self, path: &[Directed]) -> Vec<u32> {
        path.iter().map(|&portal| self.arena.source(portal)).collect()
    }

    /// What the last row had to leave.
    pub fn dead_ends(&self) -> DeadEnds {
        let longest = self.longest.as_ref();
        let longest = longest.map(|(path, dead_end)| (self.portals_of(path), *dead_end));
        DeadEnds { longest, ..self.dead_ends.clone() }
    }
}

impl Tally {
    /// Adds the counts of another.
    pub fn add(&mut self, other: &Tally) {
        self.candidates += other.candidates;
        self.refuted += other.refuted;
        self.visited += other.visited;
        self.excluded += other.excluded;
        self.inherited += other.inherited;
        self.proposed += other.proposed;
        self.cones += other.cones;
        self.cone_open += other.cone_open;
    }
}
