//! The wedge search: the sequences of portals through which an eye sees.
//!
//! The directions in which the eye sees through a sequence are a wedge; each portal narrows it, or
//! ends the search (Teller and Séquin 1991, §4.2, figure 10). The paper descends the stab tree of
//! the eye's cell; here the search walks the adjacency graph, and reaches the same: a wedge with an
//! inside holds a line through the eye that crosses all portals strictly inside, so its sequence is
//! in the stab tree; and a sequence in no stab tree has no such line. Nor can it enter a cell
//! twice: cells are convex.
//!
//! The wedges of two sequences, neither of which begins the other, are disjoint, so the search does
//! no more than it finds: O(s·p) turns for s sequences and p portals a cell.

use super::cone::Wedge;
use super::region::{PlanRegion, doubled_area, part_around, part_behind};
use super::{EyePlan, PlanPlace, ViewCone};
use crate::num::{Int, Rational, sum};
use crate::predicates::PlanPoint;
use crate::scene::CellId;

/// A plan as it looks from one place.
pub struct PlanView<'a> {
    pub(super) plan: &'a EyePlan<'a>,
    pub(super) place: &'a PlanPlace,
    /// Points on the right and on the left side of the view cone; none for all around.
    pub(super) sides: Option<[PlanPoint; 2]>,
}

/// A sequence through which the eye sees into a cell.
#[derive(Clone, Copy, Debug)]
pub struct PlanSeen<'a> {
    /// The sequence without its last portal, by its index; none for a first portal.
    pub before: Option<u32>,
    /// The last portal.
    pub portal: u32,
    /// The cell that it enters.
    pub cell: CellId,
    /// The directions.
    wedge: Wedge<'a>,
}

/// The seen sequences of one view, shorter ones first.
#[derive(Clone, Debug, Default)]
pub struct PlanSequences<'a> {
    all: Vec<PlanSeen<'a>>,
}

impl<'a> PlanSequences<'a> {
    /// The sequences, each after the one that it continues; those of one cell's portals
    /// counter-clockwise.
    pub fn all(&self) -> &[PlanSeen<'a>] {
        &self.all
    }

    /// The portals of a sequence, from the eye's cell on.
    pub fn portals(&self, seen: &PlanSeen) -> Vec<u32> {
        let mut portals = vec![seen.portal];
        let mut before = seen.before;
        while let Some(index) = before {
            let seen = &self.all[index as usize];
            portals.push(seen.portal);
            before = seen.before;
        }
        portals.reverse();
        portals
    }
}

impl<'a> PlanView<'a> {
    pub(super) fn new(
        plan: &'a EyePlan<'a>,
        place: &'a PlanPlace,
        cone: Option<&ViewCone>,
    ) -> PlanView<'a> {
        let sides = cone.map(|cone| cone.rays(&place.eye, plan.extent_bits));
        PlanView { plan, place, sides }
    }

    /// The directions of the view cone; none for all around.
    pub(super) fn cone(&self) -> Option<Wedge<'_>> {
        let [right, left] = self.sides.as_ref()?;
        Some(Wedge { right, left })
    }

    /// The sequences through which the eye sees.
    pub fn sequences(&self) -> PlanSequences<'_> {
        let eye = &self.place.eye;
        let ends = |way: &crate::scene::plan::Crossing| [way.right, way.left];
        let mut all: Vec<PlanSeen> = Vec::new();
        for &cell in &self.place.around {
            for way in self.plan.crossings.from(cell) {
                let [right, left] = ends(way).map(|end| self.plan.point(end));
                let through = Wedge::between(eye, right, left);
                let wedge = match (through, self.cone()) {
                    (Some(wedge), Some(cone)) => wedge.meet(eye, cone),
                    (through, _) => through,
                };
                let Some(wedge) = wedge else { continue };
                all.push(PlanSeen { before: None, portal: way.portal, cell: way.to, wedge });
            }
        }
        let mut next = 0;
        while let Some(&PlanSeen { portal, cell, wedge, .. }) = all.get(next) {
            for way in self.plan.crossings.from(cell).iter().filter(|way| way.portal != portal) {
                let [right, left] = ends(way).map(|end| self.plan.point(end));
                let Some(wedge) = wedge.narrowed(eye, right, left) else { continue };
                let before = Some(next as u32);
                all.push(PlanSeen { before, portal: way.portal, cell: way.to, wedge });
            }
            next += 1;
        }
        PlanSequences { all }
    }

    /// A direction strictly inside a sequence's portals and the view cone, in lowest terms.
    pub fn direction(&self, seen: &PlanSeen) -> [Int; 2] {
        seen.wedge.direction(&self.place.eye)
    }

    /// What is seen: of each cell that holds the eye what is in the view cone, then of each
    /// sequence's last cell. No two regions have an inner point in common.
    pub fn regions(&self, sequences: &PlanSequences) -> Vec<PlanRegion> {
        let own = self.place.around.iter().filter_map(|&cell| {
            let polygon = self.own_part(cell)?;
            Some(PlanRegion { cell, portals: Vec::new(), polygon })
        });
        let behind = sequences.all.iter().map(|seen| PlanRegion {
            cell: seen.cell,
            portals: sequences.portals(seen),
            polygon: self.part(seen),
        });
        own.chain(behind).collect()
    }

    /// Twice the area of all that is seen, in square grid units.
    ///
    /// Its denominator may be as long as all regions' together.
    pub fn doubled_area(&self, sequences: &PlanSequences) -> Rational {
        let own = self.place.around.iter().filter_map(|&cell| self.own_part(cell));
        let behind = sequences.all.iter().map(|seen| self.part(seen));
        sum(own.chain(behind).map(|polygon| doubled_area(&polygon)))
    }

    /// What of a closed cell around the eye is in the view cone.
    pub(super) fn own_part(&self, cell: CellId) -> Option<Vec<PlanPoint>> {
        let polygon = self.plan.polygon(cell);
        match self.cone() {
            Some(cone) => part_around(&self.place.eye, cone, &polygon),
            None => Some(polygon.into_iter().cloned().collect()),
        }
    }

    /// Whether the inside of a closed cell around the eye meets the view cone's.
    pub(super) fn meets_own(&self, cell: CellId) -> bool {
        // Around an eye strictly inside there is its cell in all directions.
        self.place.around.len() == 1 || self.own_part(cell).is_some()
    }

    fn part(&self, seen: &PlanSeen) -> Vec<PlanPoint> {
        part_behind(&self.place.eye, seen.wedge, &self.plan.polygon(seen.cell))
    }

    /// The cells that are seen, in ascending order.
    pub fn seen_cells(&self, sequences: &PlanSequences) -> Vec<CellId> {
        let own = self.place.around.iter().copied();
        let own = own.filter(|&cell| self.meets_own(cell));
        let mut cells: Vec<CellId> = own.chain(sequences.all.iter().map(|s| s.cell)).collect();
        cells.sort_unstable();
        cells.dedup();
        cells
    }
}
