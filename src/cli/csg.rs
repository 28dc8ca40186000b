//! `stabline csg`: a boolean expression of brushes, its boundary, volume and area.

use super::exit::{Exit, Failure};
use super::files::{self, Input};
use super::meshes::{self, Writer};
use crate::construct::Polygon;
use crate::csg::{self, Body, Placed};
use crate::formats::csg::CsgFile;
use crate::formats::mesh::{self, MeshGroup};
use crate::report::{BodyReport, BodyTreeReport, InputId, body_text};
use num_traits::{ToPrimitive, Zero};
use std::path::{Path, PathBuf};

/// Evaluate a boolean expression of convex brushes, exactly
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    /// The expression: `stabline-csg/1`, or `-` for standard input
    input: PathBuf,
    /// Write the boundary and the cells (`stabline-body/1`)
    #[arg(short, long, value_name = "OUT.json")]
    output: Option<PathBuf>,
    /// Write the boundary as OBJ; coordinates without a finite decimal are rounded, which is told
    #[arg(long, value_name = "OUT.obj")]
    obj: Option<PathBuf>,
    /// Write the boundary as binary glTF; coordinates are rounded to single floats, which is told
    #[arg(long, value_name = "OUT.glb")]
    glb: Option<PathBuf>,
    /// Write the tree of splitting planes (`stabline-csg-bsp/1`)
    #[arg(long, value_name = "OUT.json")]
    bsp: Option<PathBuf>,
    /// Print JSON (`stabline-body/1`)
    #[arg(long)]
    json: bool,
}

pub(super) fn run(args: Args) -> Result<Exit, Failure> {
    let outputs = [&args.output, &args.obj, &args.glb, &args.bsp];
    let writes_to_stdout = files::check_outputs(outputs)?;
    let input = Input::read(&args.input)?;
    let file = CsgFile::read(&input.bytes).map_err(|error| Failure::file(&input.name, error))?;
    let placed = Placed::try_from(&file).map_err(|error| Failure::file(&input.name, error))?;
    let body = csg::evaluate(&placed.expression).map_err(|error| match error.brush() {
        Some(brush) => Failure::file(&input.name, format!("{}: {error}", placed.places[brush])),
        None => Failure::file(&input.name, error),
    })?;
    let mut flat = placed.flat;
    flat.extend(body.flat.iter().map(|&brush| placed.places[brush].clone()));
    for place in &flat {
        eprintln!("{}: {place}: the brush has no volume and holds nothing", input.name);
    }
    let brushes = placed.places.len() - body.flat.len();
    let id = || InputId::new(&input.file_name(), &input.bytes);
    let json = || BodyReport::new(id(), &body, brushes, flat.clone()).to_json();
    if let Some(path) = &args.output {
        files::write(Some(path), |out| out.write_all(json().as_bytes()))?;
    }
    if let Some(path) = &args.bsp {
        let tree = BodyTreeReport::new(id(), &body).to_json();
        files::write(Some(path), |out| out.write_all(tree.as_bytes()))?;
    }
    let groups = [group(&input, &body)];
    let mut displacements = String::new();
    for (path, write) in [(&args.obj, mesh::write_obj as Writer), (&args.glb, mesh::write_glb)] {
        if let Some(path) = path {
            displacements.push_str(&write_mesh(path, &groups, write)?);
        }
    }
    if args.json || writes_to_stdout {
        eprint!("{displacements}");
    }
    if !writes_to_stdout {
        let text = || body_text(&input.file_name(), &body, brushes, flat.len()) + &displacements;
        files::print(&if args.json { json() } else { text() })?;
    }
    Ok(Exit::Done)
}

/// Writes a mesh, and says how far its coordinates were moved.
fn write_mesh(path: &Path, groups: &[MeshGroup], write: Writer) -> Result<String, Failure> {
    let largest = meshes::write(path, groups, write)?;
    let name = files::file_name(path);
    Ok(match largest.is_zero() {
        true => format!("{name}: coordinates are exact\n"),
        false => {
            let shown = largest.to_f64().unwrap_or(f64::INFINITY);
            format!("{name}: coordinates moved by at most {shown:.3e}\n")
        }
    })
}

fn group(input: &Input, body: &Body) -> MeshGroup {
    let name = input.file_name();
    let name = name.strip_suffix(".json").unwrap_or(&name).to_owned();
    MeshGroup { name, polygons: body.boundary.iter().map(Polygon::points).collect() }
}
