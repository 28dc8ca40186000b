//! The culls of Teller and Séquin 1991, §4.1, each of which leaves all that the next one does.
//!
//! What the eye's cell sees is given: as a set of cells, or as its stab tree. The paper searches
//! the tree; a search of the adjacency graph that keeps to the set is coarser, as a way through
//! seen cells need not be part of a sightline, and leaves all that the tree does.
//!
//! An eye on a boundary of cells looks from all of them, but the cell whose half-open extent holds
//! it lends its set. Nothing is missing from that set: a sightline from the eye, moved a little,
//! starts in that cell and crosses the others around the eye on its way.

use super::PlanView;
use super::cone::{Wedge, turn};
use crate::num::Sign;
use crate::scene::CellId;
use crate::scene::plan::{PlanPortal, PlanStabNode};

/// How cells that the eye's cell sees are ruled out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PlanCull {
    /// Not at all: cell-to-cell visibility.
    None,
    /// Cells whose inside does not meet the view cone's.
    DisjointCell,
    /// And those that cannot be reached through cells that meet it.
    ConnectedComponent,
    /// And those that cannot be reached through such portals.
    IncidentPortals,
    /// All but the cells that are seen.
    Exact,
}

impl PlanCull {
    /// Every cull, from the coarsest on.
    pub const ALL: [PlanCull; 5] = [
        PlanCull::None,
        PlanCull::DisjointCell,
        PlanCull::ConnectedComponent,
        PlanCull::IncidentPortals,
        PlanCull::Exact,
    ];
}

/// What the eye's cell sees.
#[derive(Clone, Copy, Debug)]
pub enum CellSight<'k> {
    /// The cells.
    Cells(&'k [CellId]),
    /// The nodes of its stab tree, each after its parent.
    Tree(&'k [PlanStabNode]),
}

impl PlanView<'_> {
    /// The cells that a cull leaves, in ascending order.
    ///
    /// Complexity: O(corners of the cells given), and for the culls that search as many portals.
    pub fn cull(&self, cull: PlanCull, sight: CellSight) -> Vec<CellId> {
        let mut cells = match cull {
            PlanCull::None => return self.given(sight),
            PlanCull::DisjointCell => self.given(sight),
            PlanCull::ConnectedComponent => {
                self.reached(sight, |cell, _| self.is_around(cell) || self.meets_cell(cell))
            }
            PlanCull::IncidentPortals => self.reached(sight, |_, portal| self.meets_portal(portal)),
            PlanCull::Exact => return self.seen_cells(&self.sequences()),
        };
        cells.retain(|&cell| self.meets_cell(cell));
        cells
    }

    /// All that the eye's cell sees, itself included.
    fn given(&self, sight: CellSight) -> Vec<CellId> {
        let mut cells = match sight {
            CellSight::Cells(cells) => cells.to_vec(),
            CellSight::Tree(tree) => tree.iter().map(|node| node.cell).collect(),
        };
        cells.push(self.place.cell);
        cells.sort_unstable();
        cells.dedup();
        cells
    }

    /// The cells reached from the eye's through portals into cells that pass.
    fn reached(&self, sight: CellSight, passes: impl Fn(CellId, u32) -> bool) -> Vec<CellId> {
        let given = self.given(sight);
        let mut reached = vec![false; given.len()];
        let index = |cell: CellId| given.binary_search(&cell).ok();
        let start = index(self.place.cell).expect("the eye's cell is among those given");
        reached[start] = true;
        match sight {
            CellSight::Tree(tree) => {
                let mut passed = vec![false; tree.len()];
                for (i, node) in tree.iter().enumerate() {
                    let comes_here = node.parent.is_none_or(|parent| passed[parent as usize]);
                    passed[i] = comes_here && passes(node.cell, node.portal);
                    if let (true, Some(index)) = (passed[i], index(node.cell)) {
                        reached[index] = true;
                    }
                }
            }
            CellSight::Cells(_) => {
                let mut stack = vec![self.place.cell];
                while let Some(cell) = stack.pop() {
                    for way in self.plan.crossings.from(cell) {
                        let Some(index) = index(way.to) else { continue };
                        if !reached[index] && passes(way.to, way.portal) {
                            reached[index] = true;
                            stack.push(way.to);
                        }
                    }
                }
            }
        }
        given.iter().zip(reached).filter_map(|(&cell, reached)| reached.then_some(cell)).collect()
    }

    fn is_around(&self, cell: CellId) -> bool {
        self.place.around.binary_search(&cell).is_ok()
    }

    /// Whether the inside of a cell and that of the view cone have a point in common.
    fn meets_cell(&self, cell: CellId) -> bool {
        let Some(cone) = self.cone() else { return true };
        if self.is_around(cell) {
            return self.meets_own(cell);
        }
        let outline = self.outline(&self.plan.polygon(cell));
        outline.is_some_and(|outline| outline.meet(&self.place.eye, cone).is_some())
    }

    /// Whether a portal meets the inside of the view cone, or holds the eye.
    fn meets_portal(&self, portal: u32) -> bool {
        let Some(cone) = self.cone() else { return true };
        let eye = &self.place.eye;
        let PlanPortal { left, right, .. } = self.plan.cells.graph.portals[portal as usize];
        let [left, right] = [left, right].map(|end| self.plan.point(end));
        match turn(eye, right, left) {
            Sign::Positive => Wedge { right, left }.meet(eye, cone).is_some(),
            Sign::Negative => Wedge { right: left, left: right }.meet(eye, cone).is_some(),
            // Edge-on, or around the eye.
            Sign::Zero => {
                super::place::is_between(left, right, eye)
                    || cone.holds(eye, left)
                    || cone.holds(eye, right)
            }
        }
    }

    /// The directions of the inside of a convex polygon that does not hold the eye.
    fn outline<'p>(&self, polygon: &[&'p crate::predicates::PlanPoint]) -> Option<Wedge<'p>> {
        let eye = &self.place.eye;
        let (mut right, mut left) = (*polygon.first()?, *polygon.first()?);
        for &corner in polygon {
            if turn(eye, right, corner) == Sign::Negative {
                right = corner;
            }
            if turn(eye, left, corner) == Sign::Positive {
                left = corner;
            }
        }
        Wedge::between(eye, right, left)
    }
}
