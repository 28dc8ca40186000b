//! An answer as a report: names for cells, the input's numbers for portals.

use super::{Answer, Frustum, Region};
use crate::geom::RationalPoint3;
use crate::num::Rational;
use crate::report::{EyeCell, EyeFrustum, EyeRatio, EyeRegion, EyeReport, InputId};
use crate::scene::{CellId, PortalGraph, PortalId};

/// What a frustum was made of.
#[derive(Clone, Debug)]
pub struct Lens {
    /// The direction of view.
    pub look: [Rational; 3],
    /// The direction that is up.
    pub up: [Rational; 3],
    /// The tangents of half the horizontal and half the vertical angle of view.
    pub half_tangents: [Rational; 2],
    /// What they make.
    pub frustum: Frustum,
}

impl Answer {
    /// The report of this answer, which an eye at `eye` got by the cull of this name.
    pub fn report(
        &self,
        graph: &PortalGraph,
        input: InputId,
        eye: &RationalPoint3,
        lens: Option<&Lens>,
        (cull, regions): (&str, bool),
    ) -> EyeReport {
        let name = |cell: CellId| graph.cells[cell.0 as usize].clone();
        let sources = |portals: &[PortalId]| {
            portals.iter().map(|portal| graph.portals[portal.0 as usize].source).collect()
        };
        let mut report = EyeReport::new(input, point(eye), cull);
        report.eye_cells = self.eye_cells.iter().map(|&cell| name(cell)).collect();
        report.frustum = lens.map(described);
        report.sequences = self.sequences;
        let cells = self.cells.iter().map(|reached| EyeCell {
            cell: name(reached.cell),
            portals: sources(&reached.portals),
            direction: reached.direction.as_ref().map(|v| v.each_ref().map(Into::into)),
        });
        report.cells = cells.collect();
        let region = |region: &Region| EyeRegion {
            cell: name(region.cell),
            portals: sources(&region.portals),
            polygon: region.polygon.iter().map(point).collect(),
            doubled_area_squared: (&region.doubled_area_squared).into(),
        };
        report.regions = regions.then(|| self.regions.iter().map(region).collect());
        report
    }
}

fn described(lens: &Lens) -> EyeFrustum {
    EyeFrustum {
        look: lens.look.each_ref().map(Into::into),
        up: lens.up.each_ref().map(Into::into),
        half_tangents: lens.half_tangents.each_ref().map(Into::into),
        planes: lens.frustum.planes().each_ref().map(|plane| plane.each_ref().map(Into::into)),
        widened: lens.frustum.is_widened(),
    }
}

fn point(point: &RationalPoint3) -> [EyeRatio; 3] {
    let coordinate = |c| Rational::new(c, point.denominator().clone());
    point.numerators().clone().map(|c| (&coordinate(c)).into())
}
