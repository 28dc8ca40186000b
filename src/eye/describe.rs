//! An answer as a report: names for cells, the input's numbers for portals.

use super::{Answer, Frustum, Region, SeenObject, SeenRegion, SeenSpace};
use crate::construct::Polyhedron;
use crate::geom::RationalPoint3;
use crate::num::Rational;
use crate::report::{
    EyeCell, EyeFrustum, EyeObject, EyeRatio, EyeRegion, EyeReport, EyeSpace, EyeSpaceRegion,
    InputId,
};
use crate::scene::world::Object;
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
        let name = |cell| name(graph, cell);
        let sources = |portals: &[PortalId]| sources(graph, portals);
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

impl SeenSpace {
    /// The report of the regions.
    pub fn report(&self, graph: &PortalGraph) -> EyeSpace {
        let region = |region: &SeenRegion| {
            let (vertices, faces) = indexed(&region.polyhedron);
            EyeSpaceRegion {
                cell: name(graph, region.cell),
                portals: sources(graph, &region.portals),
                volume: (&region.polyhedron.volume()).into(),
                vertices: vertices.iter().map(point).collect(),
                faces,
            }
        };
        EyeSpace {
            volume: (&self.volume()).into(),
            regions: self.regions.iter().map(region).collect(),
        }
    }

    /// The report of objects that are seen in this space.
    pub fn report_objects(
        &self,
        graph: &PortalGraph,
        objects: &[Object],
        seen: &[SeenObject],
    ) -> Vec<EyeObject> {
        let object = |seen: &SeenObject| {
            let place = &objects[seen.object].place;
            let region = &self.regions[seen.region];
            EyeObject {
                object: seen.object as u32,
                name: place.name.clone(),
                line: place.line.map(|line| line as u32),
                cell: name(graph, region.cell),
                portals: sources(graph, &region.portals),
                point: point(&seen.point),
            }
        };
        seen.iter().map(object).collect()
    }
}

/// The distinct vertices of a polyhedron, and each face by their indices.
fn indexed(polyhedron: &Polyhedron) -> (Vec<RationalPoint3>, Vec<Vec<u32>>) {
    let mut vertices = Vec::new();
    let mut index = |point: RationalPoint3| match vertices.iter().position(|known| *known == point)
    {
        Some(known) => known as u32,
        None => {
            vertices.push(point);
            vertices.len() as u32 - 1
        }
    };
    let faces = polyhedron.faces().iter();
    let faces = faces.map(|face| face.points().into_iter().map(&mut index).collect()).collect();
    (vertices, faces)
}

fn name(graph: &PortalGraph, cell: CellId) -> String {
    graph.cells[cell.0 as usize].clone()
}

/// The numbers of portals in the input.
fn sources(graph: &PortalGraph, portals: &[PortalId]) -> Vec<u32> {
    portals.iter().map(|portal| graph.portals[portal.0 as usize].source).collect()
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
