//! Views as a report: world units, and names for cells.

use super::region::doubled_area;
use super::{CellSight, EyePlan, PlanCull, PlanStep, PlanView, PlanWay, ViewCone};
use crate::num::{Int, Rational, sum};
use crate::predicates::PlanPoint;
use crate::report::{
    EyeCone, EyePlanCell, EyePlanRegion, EyePlanSeen, EyePlanStep, EyePlanView, EyeRatio,
};
use crate::scene::CellId;
use rustc_hash::FxHashMap;

impl PlanCull {
    /// What reports call it.
    pub fn name(self) -> &'static str {
        match self {
            PlanCull::None => "none",
            PlanCull::DisjointCell => "disjoint",
            PlanCull::ConnectedComponent => "component",
            PlanCull::IncidentPortals => "portals",
            PlanCull::Exact => "exact",
        }
    }
}

impl ViewCone {
    /// The report of the cone.
    pub fn report(&self) -> EyeCone {
        EyeCone {
            look: self.look().each_ref().map(Into::into),
            half_tangent: self.half_tangent().into(),
            sides: self.sides().each_ref().map(|side| side.each_ref().map(Into::into)),
        }
    }
}

impl EyePlan<'_> {
    /// The area of these cells, in square world units.
    pub fn area_of_cells(&self, cells: impl IntoIterator<Item = CellId>) -> Rational {
        let doubled = |cell: CellId| {
            let corners = self.polygon(cell).into_iter().cloned().collect::<Vec<_>>();
            doubled_area(&corners)
        };
        self.area(&sum(cells.into_iter().map(doubled)))
    }

    /// The area of all cells, in square world units.
    pub fn whole_area(&self) -> Rational {
        self.area_of_cells((0..self.cells.graph.cells.len() as u32).map(CellId))
    }

    /// The report of a step.
    pub fn report_step(&self, step: &PlanStep) -> EyePlanStep {
        let names = |cells: &[CellId]| cells.iter().map(|&cell| self.name(cell)).collect();
        EyePlanStep {
            portals: match step.way {
                PlanWay::Located => None,
                PlanWay::Crossed(portals) => Some(portals),
            },
            entered: names(&step.entered),
            left: names(&step.left),
        }
    }

    /// Half of it, in square world units.
    fn area(&self, doubled: &Rational) -> Rational {
        let grid = &self.cells.graph.grid;
        doubled / (grid * grid * Int::from(2))
    }

    fn world(&self, point: &PlanPoint) -> [EyeRatio; 2] {
        point.coordinates().map(|c| (&(c / &self.cells.graph.grid)).into())
    }

    fn name(&self, cell: CellId) -> String {
        self.cells.graph.cells[cell.0 as usize].clone()
    }
}

impl PlanView<'_> {
    /// The report of what a cull leaves, given what the eye's cell sees (which the exact one does
    /// not need), and with `regions` of what is seen of each cell.
    pub fn report(&self, cull: PlanCull, sight: CellSight, regions: bool) -> EyePlanView {
        let (cells, found, seen) = match cull {
            PlanCull::Exact => self.report_exact(regions),
            coarser => {
                let found = self.cull(coarser, sight);
                let cell = |&cell| EyePlanCell {
                    cell: self.plan.name(cell),
                    portals: None,
                    direction: None,
                };
                (found.iter().map(cell).collect(), found, None)
            }
        };
        EyePlanView {
            eye: self.plan.world(&self.place.eye),
            cell: self.plan.name(self.place.cell),
            around: self.place.around.iter().map(|&cell| self.plan.name(cell)).collect(),
            step: None,
            cells,
            cells_area: (&self.plan.area_of_cells(found)).into(),
            seen,
        }
    }

    fn report_exact(&self, regions: bool) -> (Vec<EyePlanCell>, Vec<CellId>, Option<EyePlanSeen>) {
        let sequences = self.sequences();
        let found = self.seen_cells(&sequences);
        // Shorter sequences come first; none leads back into a cell that holds the eye.
        let mut shortest = FxHashMap::default();
        for seen in sequences.all() {
            shortest.entry(seen.cell).or_insert(seen);
        }
        let cell = |&cell: &CellId| {
            let first = shortest.get(&cell).copied();
            EyePlanCell {
                cell: self.plan.name(cell),
                portals: Some(first.map(|seen| sequences.portals(seen)).unwrap_or_default()),
                direction: first.map(|seen| self.direction(seen).each_ref().map(Into::into)),
            }
        };
        let parts = self.regions(&sequences);
        let areas: Vec<Rational> =
            parts.iter().map(|part| self.plan.area(&part.doubled_area())).collect();
        let region = |(part, area): (&super::PlanRegion, &Rational)| EyePlanRegion {
            cell: self.plan.name(part.cell),
            portals: part.portals.clone(),
            area: area.into(),
            polygon: part.polygon.iter().map(|corner| self.plan.world(corner)).collect(),
        };
        let seen = EyePlanSeen {
            sequences: sequences.all().len() as u64,
            regions: regions.then(|| parts.iter().zip(&areas).map(region).collect()),
            area: (&sum(areas)).into(),
        };
        (found.iter().map(cell).collect(), found, Some(seen))
    }
}
