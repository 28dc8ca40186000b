//! Polygon soup to worlds: all polygons occlude, all empty space is asked about.

use super::geometry::{StatementError, StatementErrorKind};
use super::polygons::{Collector, Source};
use super::snap::Snap;
use super::warning::{Repair, Repairs};
use super::{Inside, Place, World, WorldWarning};
use crate::formats::gltf::GltfFile;
use crate::formats::obj::ObjFile;
use crate::geom::RationalPoint3;
use crate::num::Number;

type Read = Result<(World, Vec<WorldWarning>), StatementError>;

/// The world of the faces of a `.obj`.
pub(super) fn of_obj(file: &ObjFile, snap: Option<u32>) -> Read {
    let point =
        |vertex: &[Number; 3]| RationalPoint3::from(&vertex.each_ref().map(Number::to_rational));
    let vertices: Vec<RationalPoint3> = file.vertices.iter().map(point).collect();
    let faces = file.faces.iter().map(|face| {
        let name = if face.name.is_empty() { "f".to_owned() } else { face.name.clone() };
        let outline = face.corners.iter().map(|&c| vertices[c as usize].clone()).collect();
        (outline, Place { name, line: Some(face.line) })
    });
    world(faces, Repairs::default(), snap)
}

/// The world of the triangles of a glTF file.
pub(super) fn of_gltf(file: &GltfFile, snap: Option<u32>) -> Read {
    let mut repairs = Repairs::default();
    repairs.add(Repair::NoSurface, file.other_primitives, None);
    repairs.add(Repair::Deformed, file.deformed, None);
    let triangles = file.parts.iter().flat_map(|part| {
        let place = Place { name: part.name.clone(), line: None };
        part.triangles.iter().map(move |triangle| {
            let outline = triangle.map(|corner| part.vertices[corner as usize].clone());
            (outline.into(), place.clone())
        })
    });
    world(triangles, repairs, snap)
}

fn world(
    outlines: impl Iterator<Item = (Vec<RationalPoint3>, Place)>,
    mut repairs: Repairs,
    snap: Option<u32>,
) -> Read {
    let mut snap = snap.map(Snap::new);
    let mut collector = Collector::new(Source::Soup, snap.as_mut());
    for (outline, place) in outlines {
        collector.add(&outline, &place, &mut repairs).map_err(|kind| StatementError {
            place: format!("`{}`", place.name.escape_debug()),
            line: place.line,
            kind: StatementErrorKind::Polygon(kind),
        })?;
    }
    let polygons = collector.polygons;
    if polygons.is_empty() {
        let place = "faces".to_owned();
        return Err(StatementError { place, line: None, kind: StatementErrorKind::Nothing });
    }
    let warnings = repairs.into_warnings().chain(snap.map(Snap::warning)).collect();
    let world = World {
        solids: Vec::new(),
        polygons,
        hints: Vec::new(),
        objects: Vec::new(),
        inside: Inside::Everywhere,
        view: None,
    };
    Ok((world, warnings))
}
