//! The upper bound: for each directed portal the set of directed portals that a line through it
//! might cross later.
//!
//! A line that crosses portal `p` and later portal `t`, in order, has crossed to the front of
//! `p`'s plane when it meets `t`, and is still behind `t`'s plane when it meets `p`. So `t` can
//! follow `p` only where `t` reaches in front of `p` and `p` reaches behind `t`; and where every
//! portal between them does. The bound is the flood through such portals, made symmetric (`t`
//! can follow `p` iff the reverse of `p` can follow the reverse of `t`), and narrowed by passes in
//! which each flood also has to get past the planes that separate the first two portals of the
//! way (the linearised antipenumbra of Teller 1992, §8.3.5, for two portals).
//!
//! Complexity: `O(p^2)` plane tests for `p` portals, and `O(p · d · m · s)` for a pass, with `d`
//! portals a cell, `m` members of a bound, `s` separating planes of two portals.

use super::arena::{Arena, Directed, reverse};
use super::bits::{Bits, SharedBits};
use super::propose::PlaneHints;
use super::separators::separators;
use crate::report::Progress;
use rayon::prelude::*;

/// For each directed portal, those that might be crossed after it.
pub(crate) struct Bounds {
    after: Vec<Bits>,
}

/// Narrowing passes; the second removes a tenth of what the first does, a third next to nothing.
const PASSES: usize = 2;

/// Stages of the computation, for progress: the flood, and the passes.
pub(crate) const STAGES: u64 = 1 + PASSES as u64;

impl Bounds {
    /// Computes the bounds; `None` if interrupted.
    pub fn new(arena: &Arena, progress: &dyn Progress) -> Option<Bounds> {
        let rows = |row: &(dyn Fn(Directed) -> Bits + Sync)| -> Option<Vec<Bits>> {
            (0..arena.directed())
                .into_par_iter()
                .map(|portal| (!progress.is_interrupted()).then(|| row(portal)))
                .collect()
        };
        let fronts = rows(&|portal| front(arena, portal))?;
        let mut bounds = Bounds::symmetric(rows(&|portal| flood_planes(arena, &fronts, portal))?);
        progress.advance(1);
        for _ in 0..PASSES {
            bounds = Bounds::symmetric(rows(&|portal| bounds.narrowed(arena, portal))?);
            progress.advance(1);
        }
        Some(bounds)
    }

    /// The bounds that hold in both directions: a sequence reversed belongs to the line reversed.
    pub fn symmetric(after: Vec<Bits>) -> Bounds {
        let rows = (0..after.len() as u32).into_par_iter().map(|portal| {
            let mut row = after[portal as usize].clone();
            row.retain(|other| after[reverse(other) as usize].has(reverse(portal)));
            row
        });
        Bounds { after: rows.collect() }
    }

    /// The directed portals that might be crossed after `portal`.
    pub fn after(&self, portal: Directed) -> &Bits {
        &self.after[portal as usize]
    }

    /// The cells that a sequence might enter from `source`.
    pub fn cells_from(&self, arena: &Arena, source: u32) -> Bits {
        let mut cells = arena.no_cells();
        for &first in arena.leaving(source) {
            cells.insert(arena.to(first));
            for next in self.after(first).iter() {
                cells.insert(arena.to(next));
            }
        }
        cells.remove(source);
        cells
    }

    fn narrowed(&self, arena: &Arena, portal: Directed) -> Bits {
        let mut all = arena.no_portals();
        let mut candidates = arena.no_portals();
        let mut planes = Vec::new();
        let mut hints = PlaneHints::default();
        let mut flood = Flood::new(arena);
        for &next in arena.onward(arena.to(portal)) {
            if !self.after(portal).has(next) {
                continue;
            }
            candidates.assign_intersection(self.after(portal), self.after(next));
            planes.clear();
            hints.clear();
            separators(arena, portal, next, &mut planes);
            planes.iter().for_each(|plane| hints.push(plane.filter()));
            flood.run(arena, next, &candidates, |other| {
                hints.any_behind(arena.outline(other).center, |index| {
                    arena.wholly_behind(&planes[index], other)
                })
            });
            all.unite(&flood.reached);
            all.insert(next);
        }
        all
    }
}

/// The (undirected) portals that reach in front of the plane of `portal`.
fn front(arena: &Arena, portal: Directed) -> Bits {
    let plane = arena.plane_of(portal);
    let mut front = Bits::new(arena.directed() as usize / 2);
    for other in 0..arena.directed() / 2 {
        if !arena.wholly_behind(plane, 2 * other) {
            front.insert(other);
        }
    }
    front
}

fn flood_planes(arena: &Arena, fronts: &[Bits], portal: Directed) -> Bits {
    let mut reached = arena.no_portals();
    let mut entered = arena.no_cells();
    let mut stack = vec![arena.to(portal)];
    entered.insert(arena.to(portal));
    let front = &fronts[portal as usize];
    while let Some(cell) = stack.pop() {
        for &next in arena.onward(cell) {
            let can_follow = next / 2 != portal / 2
                && front.has(next / 2)
                && fronts[reverse(next) as usize].has(portal / 2);
            if can_follow && reached.insert(next) && entered.insert(arena.to(next)) {
                stack.push(arena.to(next));
            }
        }
    }
    reached
}

/// A flood through the cells, with its buffers.
pub(crate) struct Flood {
    /// The portals crossed.
    pub reached: Bits,
    /// The cells entered.
    pub entered: Bits,
    stack: Vec<u32>,
}

impl Flood {
    pub fn new(arena: &Arena) -> Flood {
        Flood { reached: arena.no_portals(), entered: arena.no_cells(), stack: Vec::new() }
    }

    /// Crosses, from the cell that `first` enters on, every candidate that is not `behind`.
    pub fn run(
        &mut self,
        arena: &Arena,
        first: Directed,
        candidates: &Bits,
        is_behind: impl Fn(Directed) -> bool,
    ) {
        self.reached.clear();
        self.entered.clear();
        self.entered.insert(arena.to(first));
        self.stack.push(arena.to(first));
        while let Some(cell) = self.stack.pop() {
            for &next in arena.onward(cell) {
                if candidates.has(next) && !is_behind(next) {
                    self.reached.insert(next);
                    if self.entered.insert(arena.to(next)) {
                        self.stack.push(arena.to(next));
                    }
                }
            }
        }
    }
}

/// The bounds as the searches share them: what one refutes, all may leave out.
///
/// Which members are still there when another thread looks is a matter of chance; but they only
/// ever prune what is not open, so no result depends on it (`search` says why).
pub(crate) struct SharedBounds {
    after: Vec<SharedBits>,
}

impl SharedBounds {
    pub fn new(bounds: Bounds) -> SharedBounds {
        SharedBounds { after: bounds.after.into_iter().map(SharedBits::from).collect() }
    }

    /// The directed portals that might be crossed after `portal`.
    pub fn after(&self, portal: Directed) -> &SharedBits {
        &self.after[portal as usize]
    }

    /// Notes that no line runs from cell `a` to cell `b`: none crosses a portal of the one before a
    /// portal of the other, in either direction.
    pub fn refute(&self, arena: &Arena, a: u32, b: u32) {
        for &p in arena.leaving(a) {
            for &q in arena.leaving(b) {
                for (p, q) in [(p, q), (p, reverse(q)), (reverse(p), q), (reverse(p), reverse(q))] {
                    self.after(p).remove(q);
                    self.after(reverse(q)).remove(reverse(p));
                    self.after(q).remove(p);
                    self.after(reverse(p)).remove(reverse(q));
                }
            }
        }
    }
}
