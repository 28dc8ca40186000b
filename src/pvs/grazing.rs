//! Which pairs that are not open are grazing: joined by a sequence that a touching line meets.
//!
//! A touching line need not keep the order of the portals, and may run inside their planes
//! (`docs/semantics.md`), so the search's prunings do not apply as they are. What does hold:
//!
//! - a line that touches a sequence touches every two portals of it, and climbs over the planes
//!   that separate those whose order is certain (`bounds`);
//! - a line that touches a sequence touches every beginning of it.
//!
//! Pairs of cells that the first rule leaves no way between are blocked. For the others the
//! sequences from the one of the two cells that has fewer left are walked depth first, none
//! entering a cell twice. Each keeps its *might-set*: the portals that may follow by the first
//! rule and lie, through cells not crossed yet, on a way to a cell not settled yet. A sequence is
//! left when that is empty or no line touches it, and the walk ends when every cell is settled.
//! The line that touches a sequence is kept for as long as it touches what follows; where it does
//! not, `stab` decides exactly.
//!
//! **Determinism.** A source's walk depends on nothing that other threads do, so a budget of
//! sequences gives the same verdicts on any number of threads.
//!
//! Complexity: per sequence one exact decision at most, in milliseconds; touching lines run along
//! every wall, so the number of sequences can be exponential in the number of coplanar portals.

mod bounds;
mod touching;

use self::bounds::ClosedBounds;
use self::touching::{GridLine, Touching};
use super::arena::{Arena, Directed, Plane, reverse};
use super::bits::Bits;
use super::bounds::Flood;
use super::sources::{Source, share_out};
use crate::report::{Matrix, Progress, ProvedGrazing, Verdict};
use crate::scene::{CellId, PortalGraph};
use rayon::prelude::*;

/// Splits the pairs that are not open into grazing and blocked.
///
/// Visits at most `budget` sequences for each source cell; pairs not settled by then become
/// undecided. A touching line for each grazing pair, once and either way round, in ascending order
/// of the sources; `None`, with the matrix as it was, if interrupted.
pub fn classify_grazing(
    graph: &PortalGraph,
    matrix: &mut Matrix,
    budget: Option<u64>,
    progress: &dyn Progress,
) -> Option<Vec<ProvedGrazing>> {
    let arena = Arena::new(graph);
    progress.begin("grazing bound", bounds::STAGES);
    let bounds = ClosedBounds::new(&arena, progress)?;
    let touching = Touching::new(&arena);
    let sources = plan(&arena, &bounds, matrix);
    progress.begin("grazing pairs", sources.iter().map(Source::work).sum());
    let rows: Option<Vec<Touched>> = sources
        .par_iter()
        .with_max_len(1)
        .map(|source| {
            let row = Walk::new(&arena, &bounds, &touching, budget, progress).from(source);
            progress.advance(source.work());
            row
        })
        .collect();
    let mut lines = Vec::new();
    for (source, row) in sources.iter().zip(rows?) {
        let settled: Vec<_> =
            row.touched.iter().map(|pair| (pair.target.0, Verdict::Grazing)).collect();
        lines.extend(row.touched);
        let left = row.undecided.iter().map(|cell| (cell, Verdict::Undecided));
        for (target, verdict) in settled.into_iter().chain(left) {
            matrix.set(source.cell as usize, target as usize, verdict);
            matrix.set(target as usize, source.cell as usize, verdict);
        }
    }
    Some(lines)
}

/// The pairs that are not open and not blocked by the bound, each with the cell that has fewer of
/// them as its source.
fn plan(arena: &Arena, bounds: &ClosedBounds, known: &Matrix) -> Vec<Source> {
    let mut sources = share_out(arena, |cell| {
        let mut wanted = bounds.cells_from(arena, cell);
        let row = known.row(cell as usize);
        wanted.retain(|target| row[target as usize] == Verdict::NotOpen);
        wanted
    });
    sources.retain(|source| !source.wanted.is_empty());
    sources
}

/// What a source's walk found.
struct Touched {
    touched: Vec<ProvedGrazing>,
    undecided: Bits,
}

/// What belongs to one portal of the current sequence.
struct Level {
    might: Bits,
    line: GridLine,
}

struct Walk<'a> {
    arena: &'a Arena,
    bounds: &'a ClosedBounds,
    touching: &'a Touching<'a>,
    budget: Option<u64>,
    progress: &'a dyn Progress,
    path: Vec<Directed>,
    levels: Vec<Level>,
    crossed: Bits,
    wanted: Bits,
    touched: Vec<ProvedGrazing>,
    visited: u64,
    flood: Flood,
    planes: Vec<Plane>,
}

/// Why a walk ended early.
enum Ended {
    Budget,
    Interrupted,
}

impl<'a> Walk<'a> {
    fn new(
        arena: &'a Arena,
        bounds: &'a ClosedBounds,
        touching: &'a Touching<'a>,
        budget: Option<u64>,
        progress: &'a dyn Progress,
    ) -> Walk<'a> {
        Walk {
            arena,
            bounds,
            touching,
            budget,
            progress,
            path: Vec::new(),
            levels: Vec::new(),
            crossed: arena.no_cells(),
            wanted: arena.no_cells(),
            touched: Vec::new(),
            visited: 0,
            flood: Flood::new(arena),
            planes: Vec::new(),
        }
    }

    /// `None` if interrupted.
    fn from(mut self, source: &Source) -> Option<Touched> {
        self.wanted = source.wanted.clone();
        self.crossed.insert(source.cell);
        let mut ended = Ok(());
        for &first in self.arena.leaving(source.cell) {
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
        if self.wanted.is_empty() {
            return Ok(());
        }
        if self.progress.is_interrupted() {
            return Err(Ended::Interrupted);
        }
        if self.budget.is_some_and(|budget| self.visited >= budget) {
            return Err(Ended::Budget);
        }
        self.visited += 1;
        let cell = self.arena.to(next);
        self.path.push(next);
        self.crossed.insert(cell);
        let might = self.might_set(next);
        let is_wanted = self.wanted.has(cell);
        if (is_wanted || !might.is_empty())
            && let Some(line) = self.touching_line(next)
        {
            if is_wanted {
                self.wanted.remove(cell);
                self.touched.push(self.proved(cell, &line));
            }
            self.levels.push(Level { might, line });
            let ended = self.visit_children(cell);
            self.levels.pop();
            ended?;
        }
        self.crossed.remove(cell);
        self.path.pop();
        Ok(())
    }

    fn visit_children(&mut self, cell: u32) -> Result<(), Ended> {
        let arena = self.arena;
        for &child in arena.leaving(cell) {
            if self.levels.last().is_some_and(|level| level.might.has(child)) {
                self.visit(child)?;
            }
        }
        Ok(())
    }

    /// That a line touches the path, which ends in `target`.
    fn proved(&self, target: u32, line: &GridLine) -> ProvedGrazing {
        let source = self.arena.from(self.path[0]);
        let (rational, root, radicand) = line.in_world();
        ProvedGrazing {
            source: CellId(source),
            target: CellId(target),
            portals: self.path.clone(),
            line: [rational, root],
            radicand,
        }
    }

    /// The portals that might follow the sequence, which now ends with `next`, on a way to a
    /// wanted cell.
    fn might_set(&mut self, next: Directed) -> Bits {
        let (arena, bounds) = (self.arena, self.bounds);
        let mut might = bounds.after(next).clone();
        if let Some(before) = self.levels.last() {
            might.intersect(&before.might);
        }
        self.planes.clear();
        for &before in &self.path[..self.path.len() - 1] {
            bounds.separators(arena, before, next, &mut self.planes);
        }
        let planes = &self.planes;
        let crossed = &self.crossed;
        self.flood.run(arena, next, &might, |portal| {
            crossed.has(arena.to(portal)) || bounds.is_behind(arena, planes, next, portal)
        });
        self.aim(might)
    }

    /// Of the portals that the flood reached, those from which a wanted cell can be reached, and
    /// that can be touched together with a portal into one; in the place of `might`.
    fn aim(&mut self, mut might: Bits) -> Bits {
        let (arena, bounds) = (self.arena, self.bounds);
        might.clear();
        let mut goals = arena.no_portals();
        for portal in self.flood.reached.iter() {
            if self.wanted.has(arena.to(portal)) {
                goals.insert(portal);
            }
        }
        self.flood
            .reached
            .retain(|portal| goals.has(portal) || bounds.after(portal).intersects(&goals));
        let mut entered = arena.no_cells();
        let mut stack: Vec<u32> = Vec::new();
        for goal in goals.iter() {
            if entered.insert(arena.to(goal)) {
                stack.push(arena.to(goal));
            }
        }
        while let Some(cell) = stack.pop() {
            for &leaving in arena.leaving(cell) {
                let entering = reverse(leaving);
                if self.flood.reached.has(entering)
                    && might.insert(entering)
                    && entered.insert(arena.from(entering))
                {
                    stack.push(arena.from(entering));
                }
            }
        }
        might
    }

    /// A line that touches the sequence, which now ends with `next`: the one of the sequence
    /// before, if it does.
    fn touching_line(&self, next: Directed) -> Option<GridLine> {
        let before = self.levels.last().map(|level| &level.line);
        let kept = before.filter(|line| self.touching.touches(line, next));
        kept.cloned().or_else(|| self.touching.line(&self.path))
    }
}
