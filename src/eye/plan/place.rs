//! Which cells an eye is in.
//!
//! Extents of cells are half-open (Teller and Séquin 1991, §2.3), so that each point of the box is
//! in one cell. An eye on a portal, or on a corner where cells meet without a wall, looks from all
//! closed cells around it nevertheless: into each of them, and through that one's portals. Walls
//! are closed sets: an eye on one, its ends included, sees nothing, which is bad input.

use super::EyePlan;
use super::cone::turn;
use crate::num::Sign;
use crate::predicates::{PlanPoint, compare_coordinates, turn_of_points};
use crate::scene::CellId;
use crate::scene::plan::Crossing;
use std::cmp::Ordering;

/// An eye and its cells.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlanPlace {
    /// The eye, in grid units.
    pub(super) eye: PlanPoint,
    /// The cell whose half-open extent holds it.
    pub(super) cell: CellId,
    /// The cells whose closed polygons hold it, in ascending order.
    pub(super) around: Vec<CellId>,
}

/// Why an eye has no cell to look from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum PlanPlaceError {
    /// It is not even in the box around the plan.
    #[error("the eye is outside of the box around the plan")]
    OutOfBox,
    /// It is on the boundary of that box, where no wall is.
    #[error("the eye is on the edge of the box around the plan, where there is nothing to see")]
    OnEdge,
    /// A wall holds it.
    #[error("the eye is on a wall: segments[{source}]", source = .segment)]
    OnWall {
        /// The first such wall, by its number in the input.
        segment: u32,
    },
    /// It is where the plan does not ask.
    #[error("the eye is in no cell: nothing that marks the inside is joined to it")]
    NoCell,
}

impl PlanPlace {
    /// The eye, in grid units.
    pub fn eye(&self) -> &PlanPoint {
        &self.eye
    }

    /// The cell whose half-open extent holds the eye.
    pub fn cell(&self) -> CellId {
        self.cell
    }

    /// The cells whose closed polygons hold the eye, in ascending order: more than one for an eye
    /// on a portal or on an open corner.
    pub fn around(&self) -> &[CellId] {
        &self.around
    }
}

/// Where a point is with respect to a closed convex polygon.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Inside {
    Strictly,
    OnBoundary,
    Not,
}

impl EyePlan<'_> {
    /// The place of an eye, found from the root of the tree: O(depth), and for an eye on a boundary
    /// what its cells have of corners and portals; with an error, O(segments).
    ///
    /// # Errors
    /// [`PlanPlaceError`] where nothing can be seen from the eye.
    pub fn place(&self, eye: PlanPoint) -> Result<PlanPlace, PlanPlaceError> {
        match self.cells.locate(&eye) {
            Some(cell) => self.place_in(eye, cell),
            None => Err(self.why_not(&eye)),
        }
    }

    /// The place of an eye whose half-open cell is known.
    pub(super) fn place_in(
        &self,
        eye: PlanPoint,
        cell: CellId,
    ) -> Result<PlanPlace, PlanPlaceError> {
        let mut around = vec![cell];
        let mut next = 0;
        while let Some(&cell) = around.get(next) {
            match self.inside(cell, &eye) {
                Inside::Strictly => {}
                Inside::OnBoundary if self.is_open_at(cell, &eye) => {
                    let ways = self.crossings.from(cell).iter();
                    let beyond = ways.filter(|way| self.is_on(way, &eye)).map(|way| way.to);
                    for beyond in beyond {
                        if !around.contains(&beyond) {
                            around.push(beyond);
                        }
                    }
                }
                Inside::OnBoundary | Inside::Not => return Err(self.why_not(&eye)),
            }
            next += 1;
        }
        around.sort_unstable();
        Ok(PlanPlace { eye, cell, around })
    }

    /// Where a point is with respect to a cell.
    pub(super) fn inside(&self, cell: CellId, point: &PlanPoint) -> Inside {
        let mut inside = Inside::Strictly;
        for [a, b] in self.edges(cell) {
            match turn_of_points(a, b, point) {
                Sign::Positive => {}
                // On the edge's line: on the edge unless another one has it outside.
                Sign::Zero => inside = Inside::OnBoundary,
                Sign::Negative => return Inside::Not,
            }
        }
        inside
    }

    /// Whether portals alone bound a cell at a point of its boundary, both ways along it.
    fn is_open_at(&self, cell: CellId, point: &PlanPoint) -> bool {
        let touching: Vec<_> =
            self.crossings.from(cell).iter().filter(|way| self.is_on(way, point)).collect();
        let ends_elsewhere =
            |end: fn(&Crossing) -> u32| touching.iter().any(|way| self.point(end(way)) != point);
        ends_elsewhere(|way| way.left) && ends_elsewhere(|way| way.right)
    }

    /// Whether a point lies on a closed portal.
    fn is_on(&self, way: &Crossing, point: &PlanPoint) -> bool {
        let [p, q] = [way.left, way.right].map(|end| self.point(end));
        turn(point, p, q) == Sign::Zero && is_between(p, q, point)
    }

    /// Why there is nothing to see from a point.
    fn why_not(&self, eye: &PlanPoint) -> PlanPlaceError {
        let side = |i: usize| self.plan.bounds.map(|corner| self.point(corner))[i % 4];
        let sides = [0, 1, 2, 3].map(|i| turn_of_points(side(i), side(i + 1), eye));
        if sides.contains(&Sign::Negative) {
            return PlanPlaceError::OutOfBox;
        }
        let mut walls = self.plan.segments.iter().filter(|segment| segment.is_opaque);
        let wall = walls.find(|segment| {
            let [p, q] = segment.ends.map(|end| self.plan.points.get(end));
            turn_of_points(p, q, eye) == Sign::Zero && is_between(p, q, eye)
        });
        match wall {
            Some(wall) => PlanPlaceError::OnWall { segment: wall.source },
            None if sides.contains(&Sign::Zero) => PlanPlaceError::OnEdge,
            None => PlanPlaceError::NoCell,
        }
    }
}

/// Whether a point on the line through `p` and `q` lies between them, themselves included.
pub(super) fn is_between(p: &PlanPoint, q: &PlanPoint, point: &PlanPoint) -> bool {
    [0, 1].into_iter().all(|axis| {
        let [from, to] = [p, q].map(|end| compare_coordinates(axis, end, point));
        from == Ordering::Equal || from != to
    })
}
