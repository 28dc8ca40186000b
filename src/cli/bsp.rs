//! `stabline bsp`: geometry divided into cells and portals.

use super::exit::{Exit, Failure};
use super::files::{self, Input};
use super::world::{self, WorldArgs};
use crate::formats::prt::{self, PrtPortal, PrtWriteError};
use crate::geom::RationalPoint3;
use crate::num::{Int, Number, Rational};
use crate::portal::{WorldCells, WorldError, cells_of_world};
use crate::scene::world::WorldWarning;
use crate::scene::{PortalGraph, World};
use crate::subdivision::Options;
use num_traits::{Signed, ToPrimitive};
use std::io::{self, Write};
use std::path::PathBuf;

/// Divide the space around geometry into convex cells and the portals between them
///
/// INPUT is a level's source (`.map`), a JSON scene with geometry, or polygons (`.obj`, `.gltf`,
/// `.glb`). A world that leaks ends with code 3; `--pts` keeps the way out.
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    /// The geometry
    input: PathBuf,
    /// Write the portals as a portal file
    #[arg(long, value_name = "OUT.prt")]
    prt: Option<PathBuf>,
    /// Round the portal file's coordinates to this many decimals, where they have no finite
    /// decimal or a longer one; the largest displacement is printed
    #[arg(long, value_name = "DECIMALS", requires = "prt", value_parser = clap::value_parser!(u32).range(0..=18))]
    snap: Option<u32>,
    /// Where the world leaks, write the way from a mark to the outside as a line of points
    #[arg(long, value_name = "OUT.pts")]
    pts: Option<PathBuf>,
    #[command(flatten)]
    world: WorldArgs,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

pub(super) fn run(args: Args) -> Result<Exit, Failure> {
    let input = Input::read(&args.input)?;
    let (world, warnings) = world::read_all(&input, args.world)?;
    for warning in &warnings {
        eprintln!("{}: {warning}", input.name);
    }
    let cells = match cells_of_world(&world, &Options::default()) {
        Ok(cells) => cells,
        Err(error) => {
            if let (WorldError::Leak { leak, .. }, Some(path)) = (&error, &args.pts) {
                files::write(Some(path), |out| write_points(&leak.path, out))?;
            }
            return Err(Failure::file(&input.name, error));
        }
    };
    let mut displacement = None;
    if let Some(path) = &args.prt {
        let (portals, largest) = portals(&cells.graph, args.snap);
        let count = cells.graph.cells.len() as u32;
        let written = |out: &mut dyn Write| match prt::write(count, &portals, out) {
            Ok(()) => Ok(()),
            Err(PrtWriteError::Io(error)) => Err(error),
            Err(error @ PrtWriteError::NoDecimal { .. }) => Err(io::Error::other(error)),
        };
        files::write(Some(path), written)?;
        displacement = args.snap.map(|_| largest);
    }
    let text = match args.json {
        true => {
            format!("{:#}\n", as_json(&input, &warnings, &world, &cells, displacement.as_ref()))
        }
        false => as_text(&input, &warnings, &world, &cells, displacement.as_ref()),
    };
    files::print(&text)?;
    Ok(Exit::Done)
}

/// A point a line, as level editors load it: rounded, as these files hold a few decimals.
fn write_points(path: &[RationalPoint3], out: &mut dyn Write) -> io::Result<()> {
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
fn portals(graph: &PortalGraph, snap: Option<u32>) -> (Vec<PrtPortal>, Rational) {
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

fn as_text(
    input: &Input,
    warnings: &[WorldWarning],
    world: &World,
    cells: &WorldCells,
    displacement: Option<&Rational>,
) -> String {
    let leaves = &cells.subdivision.leaves;
    let mut text = format!(
        "{}: {} solids, {} polygons, {} hints, {} objects, {} marks; {} oddities repaired\n\
         {} leaves of the tree, {} solid\n\
         {} cells inside, {} portals between them\n",
        input.file_name(),
        world.solids.len(),
        world.polygons.len(),
        world.hints.len(),
        world.objects.len(),
        world.marks().len(),
        warnings.len(),
        leaves.len(),
        leaves.iter().filter(|leaf| leaf.solid).count(),
        cells.graph.cells.len(),
        cells.graph.portals.len(),
    );
    for &mark in &cells.buried {
        text.push_str(&format!("{} is inside a solid\n", world.marks()[mark].place));
    }
    if let Some(moved) = displacement {
        text.push_str(&format!("coordinates moved by {moved} at most\n"));
    }
    text
}

fn as_json(
    input: &Input,
    warnings: &[WorldWarning],
    world: &World,
    cells: &WorldCells,
    displacement: Option<&Rational>,
) -> serde_json::Value {
    let leaves = &cells.subdivision.leaves;
    serde_json::json!({
        "format": "stabline-bsp/1",
        "input": input.file_name(),
        "solids": world.solids.len(),
        "polygons": world.polygons.len(),
        "hints": world.hints.len(),
        "objects": world.objects.len(),
        "marks": world.marks().len(),
        "warnings": warnings.iter().map(ToString::to_string).collect::<Vec<_>>(),
        "leaves": leaves.len(),
        "solid_leaves": leaves.iter().filter(|leaf| leaf.solid).count(),
        "cells": cells.graph.cells.len(),
        "portals": cells.graph.portals.len(),
        "buried_marks": cells.buried.iter().map(|&mark| world.marks()[mark].place.to_string()).collect::<Vec<_>>(),
        "displacement": displacement.map(ToString::to_string),
    })
}
