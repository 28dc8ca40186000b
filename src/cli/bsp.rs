//! `stabline bsp`: geometry divided into cells and portals.

mod plan;
mod show;

use super::exit::{Exit, Failure};
use super::files::{self, Input};
use super::numbers::point;
use super::plan::PlanArgs;
use super::progress::{ProgressArgs, Stopwatch};
use super::world::{self, WorldArgs};
use crate::formats::prt::{self, PrtWriteError};
use crate::num::Rational;
use crate::portal::{self, WorldCells, WorldError, divide_world, occluders_of};
use crate::report::{BspChecked, BspReport, BspStage, EyeRatio, InputId, Progress};
use crate::scene::World;
use crate::scene::world::Inside;
use crate::subdivision::{DivisionError, Options, PortalShape};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Divide the space around geometry into convex cells and the portals between them
///
/// INPUT is a level's source (`.map`), a JSON scene with geometry, polygons (`.obj`, `.gltf`,
/// `.glb`), a floorplan in JSON, or a Doom level (`FILE.wad:MAP01`). A world
/// that leaks ends with code 3; `--pts` keeps the way out.
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
    /// Write the cells as polyhedra, and the portals (`stabline-cells/1`; of a floorplan as
    /// polygons, `stabline-plan/1`)
    #[arg(long, value_name = "OUT.json")]
    cells: Option<PathBuf>,
    /// Where the level leaks, write the way from an entity to the outside as a line of points
    #[arg(long, value_name = "OUT.pts")]
    pts: Option<PathBuf>,
    /// Print cells and faces in the order of painting for an eye, farthest first, instead of the
    /// summary
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, conflicts_with = "json")]
    painter: Option<String>,
    /// Check the division's laws: volumes, kinds of leaves, portals, random points
    #[arg(long)]
    check: bool,
    /// Tell how long each stage took
    #[arg(long)]
    stats: bool,
    #[command(flatten)]
    world: WorldArgs,
    #[command(flatten)]
    plan: PlanArgs,
    /// Print JSON (`stabline-bsp/1`; of a floorplan `stabline-plan/1`)
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    progress: ProgressArgs,
}

/// How many random points `--check` locates.
const SAMPLES: usize = 200;

pub(super) fn run(args: Args) -> Result<Exit, Failure> {
    let options = args.world.division.options()?;
    let eye = args.painter.as_ref().map(|text| point("--painter", text)).transpose()?;
    files::check_outputs([&args.pts])?;
    let writes_to_stdout = files::check_outputs([&args.prt, &args.cells])?;
    let input = Input::read(&args.input)?;
    if super::plan::is_plan(&input) {
        return plan::run(&args, &input, writes_to_stdout);
    }
    let stopwatch = Stopwatch::new(args.progress.reporter());
    stopwatch.begin("read", 0);
    let (world, warnings) = world::read_all(&input, &args.world)?;
    for warning in &warnings {
        eprintln!("{}: {warning}", input.name);
    }
    let warnings = warnings.iter().map(ToString::to_string).collect();
    let cells = match divide_world(&world, &options, &stopwatch) {
        Ok(cells) => cells,
        Err(WorldError::Division(DivisionError::Interrupted)) => return Ok(Exit::Interrupted),
        Err(error) => {
            if let (WorldError::Leak { leak, .. }, Some(path)) = (&error, &args.pts) {
                files::write(Some(path), |out| show::write_points(&leak.path, out))?;
            }
            return Err(Failure::file(&input.name, error));
        }
    };
    let checked = match args.check {
        true => Some(check(&input, &world, &cells, &options, &stopwatch)?),
        false => None,
    };
    let stages = stopwatch.stages().into_iter();
    let stages = stages.map(|(stage, microseconds)| BspStage { stage, microseconds });
    let mut report = summary(&input, &world, &cells, warnings);
    report.portal_shape = args.world.division.shape().1;
    report.conservative = options.portals == PortalShape::Hull;
    report.checked = checked;
    report.stages = if args.stats { stages.collect() } else { Vec::new() };
    if let Some(path) = &args.prt {
        let largest = write_portals(path, &cells, args.snap)?;
        report.displacement = args.snap.map(|_| EyeRatio::from(&largest));
    }
    if let Some(path) = &args.cells {
        let id = InputId::new(&input.file_name(), &input.bytes);
        files::write(Some(path), |out| show::cells(id, &cells).write(out))?;
    }
    let text = match (eye, args.json) {
        (Some(eye), _) => show::painting(&world, &cells, &eye),
        (None, true) => report.to_json(),
        (None, false) => report.to_text(),
    };
    if !writes_to_stdout {
        files::print(&text)?;
    }
    Ok(Exit::Done)
}

/// Writes a portal file; how far a coordinate was moved at most.
fn write_portals(path: &Path, cells: &WorldCells, snap: Option<u32>) -> Result<Rational, Failure> {
    let (portals, largest) = show::portals(&cells.graph, snap);
    let count = cells.graph.cells.len() as u32;
    let written = |out: &mut dyn Write| match prt::write(count, &portals, out) {
        Ok(()) => Ok(()),
        Err(PrtWriteError::Io(error)) => Err(error),
        Err(error @ PrtWriteError::NoDecimal { .. }) => Err(io::Error::other(error)),
    };
    files::write(Some(path), written)?;
    Ok(largest)
}

/// Checks the laws; one that does not hold is an error of this program.
fn check(
    input: &Input,
    world: &World,
    cells: &WorldCells,
    options: &Options,
    progress: &dyn Progress,
) -> Result<BspChecked, Failure> {
    progress.begin("check", 0);
    let occluders = occluders_of(world);
    let filled = world.inside != Inside::Everywhere;
    let hulls = options.portals == PortalShape::Hull;
    let checked = cells.subdivision.check(&occluders, filled, SAMPLES, 1);
    let checked = checked.map_err(|violation| Failure::file(&input.name, violation))?;
    portal::check(&cells.subdivision, &cells.shared, &occluders, hulls)
        .map_err(|violation| Failure::file(&input.name, violation))?;
    Ok(BspChecked {
        leaves: checked.leaves,
        portals: cells.shared.len(),
        points_inside: checked.inside,
        points_between: checked.between,
    })
}

fn summary(input: &Input, world: &World, cells: &WorldCells, warnings: Vec<String>) -> BspReport {
    let leaves = &cells.subdivision.leaves;
    let InputId { name, blake3 } = InputId::new(&input.file_name(), &input.bytes);
    let place = |&mark: &usize| world.marks()[mark].place.to_string();
    BspReport {
        format: BspReport::FORMAT,
        input: name,
        blake3,
        solids: world.solids.len(),
        polygons: world.polygons.len(),
        hints: world.hints.len(),
        objects: world.objects.len(),
        marks: world.marks().len(),
        warnings,
        leaves: leaves.len(),
        solid_leaves: leaves.iter().filter(|leaf| leaf.solid).count(),
        cells: cells.graph.cells.len(),
        portals: cells.graph.portals.len(),
        portal_shape: "merged",
        conservative: false,
        buried_marks: cells.buried.iter().map(place).collect(),
        displacement: None,
        checked: None,
        stages: Vec::new(),
    }
}
