//! What one point sees of a floorplan, exactly (Teller and Séquin 1991, §4).
//!
//! - *Where it is*: the cell whose half-open extent holds the eye, and the closed cells around it
//!   ([`PlanPlace`]).
//! - *Eye-to-cell*: the sequences of portals through which it sees, all around or in a view cone
//!   ([`PlanView::sequences`]), and the cells that each cull of §4.1 leaves
//!   ([`PlanView::cull`]).
//! - *What it sees*: of each cell the part in the wedge of directions, a convex polygon with
//!   rational corners; areas are exact ([`PlanRegion`]).
//! - *Coherence* (§4.2): an observer who walks keeps what belongs to its cell ([`Walk`]), and the
//!   neighbours' sets can be fetched before it gets there ([`prefetch`]).
//!
//! Everything is decided by which way the eye and two points turn; floats are proved or not used.
//!
//! Only portals and cells count: a segment that a subdivision's threshold left inside of a cell
//! ([`PlanTree::left_inside`](crate::subdivision::plan::PlanTree)) hides nothing.

mod cone;
mod cull;
mod describe;
mod place;
mod region;
mod search;
mod walk;

pub use cone::ViewCone;
pub use cull::{CellSight, PlanCull};
pub use place::{PlanPlace, PlanPlaceError};
pub use region::PlanRegion;
pub use search::{PlanSeen, PlanSequences, PlanView};
pub use walk::{PlanStep, PlanWay, Prefetch, Walk, prefetch};

use crate::num::Rational;
use crate::portal::plan::PlanCells;
use crate::predicates::PlanPoint;
use crate::scene::CellId;
use crate::scene::plan::{Crossings, Plan};

/// A floorplan's cells, prepared for eyes anywhere in it.
pub struct EyePlan<'p> {
    plan: &'p Plan,
    cells: &'p PlanCells,
    crossings: Crossings,
    /// Below 2 to this power are all coordinates, in grid units.
    extent_bits: u64,
}

impl<'p> EyePlan<'p> {
    /// Prepares the cells of a plan: O(n lg n).
    pub fn new(plan: &'p Plan, cells: &'p PlanCells) -> EyePlan<'p> {
        let bits = |&corner: &u32| {
            let [x, y, w] = plan.points.get(corner).numbers();
            (x.bits().max(y.bits()) + 1).saturating_sub(w.bits())
        };
        let extent_bits = plan.bounds.iter().map(bits).max().unwrap_or(0);
        EyePlan { plan, cells, crossings: cells.graph.crossings(), extent_bits }
    }

    /// The plan as it looks from a place, all around or in a cone.
    pub fn view<'a>(&'a self, place: &'a PlanPlace, cone: Option<&ViewCone>) -> PlanView<'a> {
        PlanView::new(self, place, cone)
    }

    /// A point of the plan in grid units, given in world units.
    pub fn grid_point(&self, point: &[Rational; 2]) -> PlanPoint {
        let grid = &self.cells.graph.grid;
        PlanPoint::from_coordinates(&point.each_ref().map(|c| c * grid))
    }

    fn point(&self, number: u32) -> &PlanPoint {
        self.cells.graph.points.get(number)
    }

    /// The corners of a cell, counter-clockwise.
    fn polygon(&self, cell: CellId) -> Vec<&PlanPoint> {
        let corners = &self.cells.graph.polygons[cell.0 as usize];
        corners.iter().map(|&corner| self.point(corner)).collect()
    }

    /// The edges of a cell, counter-clockwise.
    fn edges(&self, cell: CellId) -> impl Iterator<Item = [&PlanPoint; 2]> {
        let corners = &self.cells.graph.polygons[cell.0 as usize];
        let after = corners.iter().cycle().skip(1);
        corners.iter().zip(after).map(|(&a, &b)| [self.point(a), self.point(b)])
    }
}
