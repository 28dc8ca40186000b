//! What occludes: the boundary of the union of solids, as polygons that face out of it, and what
//! of the thin polygons is outside of all solids.
//!
//! Each face of a solid loses what lies inside another one. Where faces of two solids coincide,
//! one of them goes: facing the same way, that of the later solid; facing each other, both, as the
//! union (regularised: the closure of its interior) has no boundary between the two. A thin
//! polygon loses what lies in a closed solid, whose faces occlude there anyway.
//!
//! A face is cut by a solid's planes one after the other, what is outside of one is kept, and
//! what is left at the end was inside; if nothing is left, the face stays whole.

use super::prepare::Body;
use super::touching::Boxes;
use super::{DivisionError, Face, Source};
use crate::construct::{Bounds, IntegerBox, PlaneId, PlaneSet, Polygon, Polyhedron, Split};
use crate::report::Progress;

/// The boundary of the union of `bodies` inside the box, and of `sheets` what is outside of it.
pub(super) fn of_occluders(
    planes: &PlaneSet,
    bounds: &Bounds,
    bodies: &[Body],
    sheets: Vec<Face>,
    progress: &dyn Progress,
) -> Result<Vec<Face>, DivisionError> {
    progress.begin("faces", (bodies.len() + sheets.len()) as u64);
    let boxes = Boxes::new(bodies.iter().map(|body| &body.around));
    let ends: [PlaneId; 6] = bounds.planes();
    let mut boundary = Vec::new();
    for (own, body) in bodies.iter().enumerate() {
        if progress.is_interrupted() {
            return Err(DivisionError::Interrupted);
        }
        let neighbours = boxes.touching(&body.around);
        let source = Source::Solid(body.index);
        // The box ends a solid that reaches past it, but is no wall.
        for face in body.solid.faces().iter().filter(|face| !ends.contains(&face.support())) {
            let mut pieces = vec![face.clone()];
            for &other in neighbours.iter().filter(|&&other| other != own) {
                pieces = subtract(planes, pieces, &bodies[other].solid, own < other);
            }
            boundary.extend(pieces.into_iter().map(|polygon| Face {
                polygon,
                source,
                thin: false,
            }));
        }
        progress.advance(1);
    }
    for sheet in sheets {
        if progress.is_interrupted() {
            return Err(DivisionError::Interrupted);
        }
        let around = IntegerBox::around(&sheet.polygon.points()).expect("it has vertices");
        let mut pieces = vec![sheet.polygon];
        for other in boxes.touching(&around) {
            pieces = subtract(planes, pieces, &bodies[other].solid, false);
        }
        let face = |polygon| Face { polygon, source: sheet.source, thin: true };
        boundary.extend(pieces.into_iter().map(face));
        progress.advance(1);
    }
    Ok(boundary)
}

/// What of the polygons is outside of a solid; of coincident faces that look the same way the
/// polygons keep theirs if they have priority.
fn subtract(
    planes: &PlaneSet,
    polygons: Vec<Polygon>,
    solid: &Polyhedron,
    priority: bool,
) -> Vec<Polygon> {
    let mut outside = Vec::with_capacity(polygons.len());
    for polygon in polygons {
        let kept = outside.len();
        let mut rest = Some(polygon.clone());
        for face in solid.faces() {
            let Some(inside) = rest.take() else { break };
            rest = match inside.split(planes, face.support()) {
                Split::Front => None,
                Split::Back => Some(inside),
                Split::On if priority && face.support() == polygon.support() => None,
                Split::On => Some(inside),
                Split::Both(front, back) => {
                    outside.push(front);
                    Some(back)
                }
            };
        }
        if rest.is_none() {
            // Nothing of it is inside: it stays in one piece.
            outside.truncate(kept);
            outside.push(polygon);
        }
    }
    outside
}
