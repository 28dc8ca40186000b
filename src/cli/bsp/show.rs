//! What `stabline bsp` makes of cells: portal files, polyhedra, the order of painting.

use crate::formats::prt::PrtPortal;
use crate::geom::RationalPoint3;
use crate::num::{Int, Number, Rational};
use crate::portal::WorldCells;
use crate::report::{CellShape, CellsReport, EyeRatio, InputId, PortalPolygon};
use crate::scene::{PortalGraph, World};
use crate::subdivision::{Painted, Source};
use num_traits::{Signed, ToPrimitive};
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::io::{self, Write};

/// A point a line, as level editors load it: rounded, as these files hold a few decimals.
pub(super) fn write_points(path: &[RationalPoint3], out: &mut dyn Write) -> io::Result<()> {
    for point in path {
        let [x, y, z] = <[Number; 3]>::from(point).map(|c| {
            let thousandths = (c.to_rational() * Int::from(1000)).round().to_integer();
            let sign = if thousandths < Int::ZERO { "-" } else { "" };
            let size = thousandths.abs();
            format!("{sign}{}.{:03}", &size / 1000, (&size % 1000u32).to_u32().unwrap_or(0))
        });
        writeln!(out, "{x} {y} {z}")?;
    }
    Ok(())
}

/// The graph's portals for a portal file, and how far a coordinate was moved at most.
pub(super) fn portals(graph: &PortalGraph, snap: Option<u32>) -> (Vec<PrtPortal>, Rational) {
    let mut largest = Rational::from(Int::ZERO);
    let mut kept = |coordinate: Number| match snap {
        None => coordinate,
        Some(decimals) => {
            let (snapped, moved) = coordinate.rounded(&Int::from(10).pow(decimals));
            if moved > largest {
                largest = moved;
            }
            Number::from(snapped)
        }
    };
    let portals = graph
        .portals
        .iter()
        .map(|portal| PrtPortal {
            line: 0,
            cells: [portal.from.0, portal.to.0],
            vertices: portal
                .vertices
                .iter()
                .map(|&v| <[Number; 3]>::from(&graph.vertices[v as usize]).map(&mut kept))
                .collect(),
        })
        .collect();
    (portals, largest)
}

/// The cells as polyhedra.
pub(super) fn cells(id: InputId, cells: &WorldCells) -> CellsReport {
    let shape = |leaf| {
        let cell = &cells.subdivision.leaf(leaf).cell;
        let mut numbers: BTreeMap<[Rational; 3], u32> = BTreeMap::new();
        let points = || cell.faces().iter().flat_map(|face| face.points());
        points().for_each(|point| {
            numbers.insert(point.coordinates(), 0);
        });
        // By their coordinates, so that equal cells are equal text.
        numbers.values_mut().zip(0..).for_each(|(number, next)| *number = next);
        let of_face = |points: Vec<RationalPoint3>| {
            points.iter().map(|point| numbers[&point.coordinates()]).collect()
        };
        CellShape {
            volume: EyeRatio::from(&cell.volume()),
            vertices: numbers.keys().map(|point| point.each_ref().map(EyeRatio::from)).collect(),
            faces: cell.faces().iter().map(|face| of_face(face.points())).collect(),
        }
    };
    let portals = cells.graph.portals.iter().map(|portal| {
        let vertex = |&v: &u32| {
            let point = cells.graph.vertices[v as usize].coordinates();
            point.each_ref().map(EyeRatio::from)
        };
        let vertices = portal.vertices.iter().map(vertex).collect();
        PortalPolygon { from: portal.from.0, to: portal.to.0, vertices }
    });
    let shapes = cells.leaves.iter().map(|&leaf| shape(leaf)).collect();
    CellsReport::new(id, shapes, portals.collect())
}

/// The order of painting for an eye, farthest first: a line for each cell and each face.
pub(super) fn painting(world: &World, cells: &WorldCells, eye: &RationalPoint3) -> String {
    let subdivision = &cells.subdivision;
    let mut text = String::new();
    for painted in subdivision.back_to_front(eye) {
        let line = match painted {
            Painted::Leaf(leaf) => match cells.leaves.binary_search(&leaf) {
                Ok(cell) => format!("cell {cell}"),
                Err(_) => continue,
            },
            Painted::Face { node, face } => {
                let face = &subdivision.nodes[node as usize].faces[face as usize];
                let points: Vec<String> = face
                    .polygon
                    .points()
                    .iter()
                    .map(|point| {
                        let [x, y, z] = point.coordinates();
                        format!("({x} {y} {z})")
                    })
                    .collect();
                let source = match face.source {
                    Source::Solid(i) => format!("solid {i} {}", world.solids[i as usize].place),
                    Source::Polygon(i) => {
                        format!("polygon {i} {}", world.polygons[i as usize].place)
                    }
                    Source::Hint(i) => format!("hint {i}"),
                };
                format!("face of {source}: {}", points.join(" "))
            }
        };
        let _ = writeln!(text, "{line}");
    }
    text
}
