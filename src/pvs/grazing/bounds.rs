//! What touching lines cannot do, by pairs of portals: the upper bound of the grazing pairs.
//!
//! A directed line *touches* portal p at a point x if x lies in the closed polygon and d·n_p >= 0.
//! If it touches p at x and q at y, then d points from x to y, or from y to x, or x = y. In the
//! first case y is in front of p's plane or on it, and x behind q's plane or on it (*forward*); in
//! the second the other way round (*backward*); in the third both hold. So a pair of which neither
//! is possible for any two of its points is touched by no line; and a pair that is forward and not
//! backward, here called *ordered*, is met in its order, in two different points.
//!
//! Let a plane have p in its closed back and q in its closed front, (p, q) be ordered, and (q, r)
//! as well. The line climbs, or keeps its height, from p to q, and so on to r: a portal r strictly
//! behind the plane is not touched (Teller 1992, §8.3.5, for closed portals). Where the order is
//! not known, as between portals whose planes the line may run in, nothing is concluded.
//!
//! The bound of a portal is the flood, from the cell that it enters, through portals that can be
//! touched together with it; narrowed by the planes that separate it from each second portal, and
//! made symmetric. `O(p^2)` plane tests for `p` portals, as for the bound of the open pairs.

use super::super::arena::{Arena, Directed, Plane, reverse};
use super::super::bits::Bits;
use super::super::bounds::{Bounds, Flood};
use super::super::separators::separators;
use crate::num::Sign;
use crate::report::Progress;
use rayon::prelude::*;

/// Stages of the computation, for progress.
pub(super) const STAGES: u64 = 3;

/// Passes of narrowing.
const PASSES: usize = 2;

/// For each directed portal, what a line that touches it may touch as well.
pub(super) struct ClosedBounds {
    /// The portals that it meets later, or at once.
    ordered: Vec<Bits>,
    /// The portals that a sequence may cross later.
    after: Bounds,
}

/// The (undirected) portals with a vertex in front of a portal's plane or on it, and those with
/// one behind it or on it.
struct Sides {
    front: Bits,
    back: Bits,
}

impl ClosedBounds {
    /// Computes the bounds; `None` if interrupted.
    pub(super) fn new(arena: &Arena, progress: &dyn Progress) -> Option<ClosedBounds> {
        let portals = 0..arena.directed();
        let rows = |row: &(dyn Fn(Directed) -> Bits + Sync)| -> Option<Vec<Bits>> {
            let portals = portals.clone().into_par_iter();
            portals.map(|portal| (!progress.is_interrupted()).then(|| row(portal))).collect()
        };
        let sides: Vec<Sides> =
            portals.clone().into_par_iter().map(|portal| sides(arena, portal)).collect();
        // Whether a line can meet p and then q, or both at once.
        let forward = |p: Directed, q: Directed| {
            sides[p as usize].front.has(q / 2) && sides[q as usize].back.has(p / 2)
        };
        let those = |holds: &dyn Fn(Directed) -> bool| {
            let mut those = arena.no_portals();
            portals.clone().filter(|&q| holds(q)).for_each(|q| {
                those.insert(q);
            });
            those
        };
        let ordered = rows(&|p| those(&|q| forward(p, q) && !forward(q, p)))?;
        let together = rows(&|p| those(&|q| forward(p, q) || forward(q, p)))?;
        progress.advance(1);
        let after = rows(&|p| {
            let mut flood = Flood::new(arena);
            let mut candidates = together[p as usize].clone();
            candidates.remove(reverse(p));
            flood.run(arena, p, &candidates, |_| false);
            flood.reached
        })?;
        let mut bounds = ClosedBounds { ordered, after: Bounds::symmetric(after) };
        for _ in 0..PASSES {
            bounds.after = Bounds::symmetric(rows(&|p| bounds.narrowed(arena, p))?);
            progress.advance(1);
        }
        Some(bounds)
    }

    /// The portals that might be touched after `portal`.
    pub(super) fn after(&self, portal: Directed) -> &Bits {
        self.after.after(portal)
    }

    /// The cells that a sequence which a line touches might enter from `source`.
    pub(super) fn cells_from(&self, arena: &Arena, source: u32) -> Bits {
        self.after.cells_from(arena, source)
    }

    /// The planes that separate `first` from `second`, if a touching line climbs over them.
    pub(super) fn separators(
        &self,
        arena: &Arena,
        first: Directed,
        second: Directed,
        planes: &mut Vec<Plane>,
    ) {
        if self.ordered[first as usize].has(second) {
            separators(arena, first, second, planes);
        }
    }

    /// Whether no line that has climbed over one of the `planes` to `last` touches `portal`.
    pub(super) fn is_behind(
        &self,
        arena: &Arena,
        planes: &[Plane],
        last: Directed,
        portal: Directed,
    ) -> bool {
        let strictly_behind = |plane: &Plane| {
            arena.vertices(portal).iter().all(|&v| match arena.side(plane, v) {
                Sign::Negative => true,
                // A vertex on the plane can be touched.
                Sign::Zero | Sign::Positive => false,
            })
        };
        self.ordered[last as usize].has(portal) && planes.iter().any(strictly_behind)
    }

    fn narrowed(&self, arena: &Arena, portal: Directed) -> Bits {
        let mut all = arena.no_portals();
        let mut candidates = arena.no_portals();
        let mut planes = Vec::new();
        let mut flood = Flood::new(arena);
        let mut crossed = arena.no_cells();
        crossed.insert(arena.from(portal));
        crossed.insert(arena.to(portal));
        for &next in arena.leaving(arena.to(portal)) {
            if !self.after(portal).has(next) {
                continue;
            }
            candidates.assign_intersection(self.after(portal), self.after(next));
            planes.clear();
            self.separators(arena, portal, next, &mut planes);
            flood.run(arena, next, &candidates, |other| {
                crossed.has(arena.to(other)) || self.is_behind(arena, &planes, next, other)
            });
            all.unite(&flood.reached);
            all.insert(next);
        }
        all
    }
}

fn sides(arena: &Arena, portal: Directed) -> Sides {
    let plane = arena.plane_of(portal);
    let count = arena.directed() / 2;
    let (mut front, mut back) = (Bits::new(count as usize), Bits::new(count as usize));
    for other in 0..count {
        for &vertex in arena.vertices(2 * other) {
            match arena.side(plane, vertex) {
                Sign::Positive => {
                    front.insert(other);
                }
                Sign::Negative => {
                    back.insert(other);
                }
                // Touching the plane counts for both sides: a line may run within it.
                Sign::Zero => {
                    front.insert(other);
                    back.insert(other);
                }
            }
        }
    }
    Sides { front, back }
}
