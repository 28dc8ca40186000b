//! Frame-to-frame coherence (Teller and Séquin 1991, §4.2): an observer who walks.
//!
//! Between two frames an observer seldom leaves its cell, and leaves it through a portal. So the
//! cell is followed along the straight way, and what belongs to it (its stab tree, its visible set,
//! the data of what it may see) is fetched when a cell is entered, and kept while the observer
//! stays in it.

use super::cone::turn;
use super::place::Inside;
use super::{EyePlan, PlanPlace, PlanPlaceError, ViewCone};
use crate::num::Sign;
use crate::predicates::PlanPoint;
use crate::scene::CellId;
use crate::scene::plan::Crossings;

/// How the observer's cell was found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PlanWay {
    /// From the root of the tree: at first, and where the straight way is not clear or ends or
    /// leads through a corner.
    Located,
    /// Along the straight way, through this many portals.
    Crossed(u32),
}

/// What changed with a step.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlanStep {
    /// How the cell was found.
    pub way: PlanWay,
    /// Whether what belongs to the cell had to be fetched.
    pub is_fetched: bool,
    /// Cells that came into view, in ascending order.
    pub entered: Vec<CellId>,
    /// Cells that went out of it.
    pub left: Vec<CellId>,
}

/// An observer in a plan, with what belongs to its cell.
pub struct Walk<'w, K, F: FnMut(CellId) -> K> {
    plan: &'w EyePlan<'w>,
    fetch: F,
    at: Option<PlanPlace>,
    kept: Option<(CellId, K)>,
    seen: Vec<CellId>,
}

impl<'w, K, F: FnMut(CellId) -> K> Walk<'w, K, F> {
    /// An observer who is nowhere yet; `fetch` gets what belongs to a cell.
    pub fn new(plan: &'w EyePlan<'w>, fetch: F) -> Walk<'w, K, F> {
        Walk { plan, fetch, at: None, kept: None, seen: Vec::new() }
    }

    /// Where the observer is.
    pub fn place(&self) -> Option<&PlanPlace> {
        self.at.as_ref()
    }

    /// What belongs to its cell.
    pub fn kept(&self) -> Option<&K> {
        self.kept.as_ref().map(|(_, kept)| kept)
    }

    /// The cells that it sees, in ascending order.
    pub fn seen(&self) -> &[CellId] {
        &self.seen
    }

    /// Moves the observer, who looks all around or into a cone, and tells what changed.
    ///
    /// Complexity: O(portals of the cells crossed), the view, and one fetch in a new cell.
    ///
    /// # Errors
    /// [`PlanPlaceError`] where nothing can be seen from there; the observer stays where it was.
    pub fn step(
        &mut self,
        to: PlanPoint,
        cone: Option<&ViewCone>,
    ) -> Result<PlanStep, PlanPlaceError> {
        let followed = self.at.as_ref().and_then(|from| self.plan.follow(from, &to));
        let (way, place) = match followed {
            Some((cell, crossed)) => (PlanWay::Crossed(crossed), self.plan.place_in(to, cell)?),
            None => (PlanWay::Located, self.plan.place(to)?),
        };
        let view = self.plan.view(&place, cone);
        let seen = view.seen_cells(&view.sequences());
        let is_kept = self.kept.as_ref().is_some_and(|(cell, _)| *cell == place.cell);
        if !is_kept {
            self.kept = Some((place.cell, (self.fetch)(place.cell)));
        }
        let step = PlanStep {
            way,
            is_fetched: !is_kept,
            entered: without(&seen, &self.seen),
            left: without(&self.seen, &seen),
        };
        self.seen = seen;
        self.at = Some(place);
        Ok(step)
    }
}

impl EyePlan<'_> {
    /// The cell at the end of the straight way from a place, and how many portals it crosses;
    /// `None` where the way meets the end of a portal or something else than portals, or ends on a
    /// boundary.
    fn follow(&self, from: &PlanPlace, to: &PlanPoint) -> Option<(CellId, u32)> {
        let eye = &from.eye;
        let (mut cell, mut crossed) = (from.cell, 0);
        loop {
            match self.inside(cell, to) {
                Inside::Strictly => return Some((cell, crossed)),
                Inside::OnBoundary => return None,
                Inside::Not => {}
            }
            // The way leaves by the one edge that it crosses, to the outside.
            let next = self.crossings.from(cell).iter().find(|way| {
                let [left, right] = [way.left, way.right].map(|end| self.point(end));
                turn(eye, to, right) == Sign::Negative
                    && turn(eye, to, left) == Sign::Positive
                    && turn(right, left, to) == Sign::Negative
            })?;
            cell = next.to;
            crossed += 1;
        }
    }
}

/// What a neighbour sees that the cell does not: what to fetch before an observer gets there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Prefetch {
    /// The neighbour.
    pub neighbour: CellId,
    /// The cells, in ascending order.
    pub cells: Vec<CellId>,
}

/// The prefetch sets of a cell, one for each neighbour in ascending order, given what each cell
/// sees in ascending order.
pub fn prefetch<S: AsRef<[CellId]>>(
    crossings: &Crossings,
    cell: CellId,
    sees: impl Fn(CellId) -> S,
) -> Vec<Prefetch> {
    let mut neighbours: Vec<CellId> = crossings.from(cell).iter().map(|way| way.to).collect();
    neighbours.sort_unstable();
    neighbours.dedup();
    let own = sees(cell);
    let new =
        |neighbour| Prefetch { neighbour, cells: without(sees(neighbour).as_ref(), own.as_ref()) };
    neighbours.into_iter().map(new).collect()
}

/// What is in one ascending list and not in the other.
fn without(one: &[CellId], other: &[CellId]) -> Vec<CellId> {
    one.iter().copied().filter(|cell| other.binary_search(cell).is_err()).collect()
}
