//! `stabline draw`: pictures of floorplans, and of what is seen in them.

use super::exit::{Exit, Failure};
use super::files::{self, Input};
use super::plan::{self, PlanArgs, Planar};
use super::pvs::plan::sights;
use crate::draw::{
    self, DEFAULT_WIDTH, Floor, LEAST_WIDTH, SequenceLine, Sheet, SheetOptions, Sightline,
};
use crate::formats::sequence::{SEQUENCE_FORMAT, SequenceFile, SequencePoints};
use crate::num::Rational;
use crate::predicates::PlanPoint;
use crate::report::{Silent, Verdict, WitnessLine};
use crate::scene::CellId;
use crate::scene::plan::PlanGraph;
use crate::stab::hourglass::PlaneVerdict;
use std::path::PathBuf;

/// Draw a floorplan, or what is seen in it, as an SVG
///
/// INPUT is a floorplan or a graph of the plane (`stabline-scene/1`), or a sequence of segments
/// (`stabline-sequence/1`). What a picture shows was decided exactly; its places are rounded to a
/// hundredth of its unit.
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    /// What is to be drawn
    input: PathBuf,
    /// Which picture of a plan
    #[arg(long, value_enum, value_name = "WHAT", default_value = "cells")]
    what: What,
    /// The cell that one looks from: its name, or its number
    #[arg(long, value_name = "CELL")]
    from: Option<String>,
    /// The picture; standard output without
    #[arg(short, long, value_name = "OUT.svg")]
    output: Option<PathBuf>,
    /// The width of the picture
    #[arg(long, value_name = "UNITS", default_value_t = DEFAULT_WIDTH,
        value_parser = clap::value_parser!(u32).range(i64::from(LEAST_WIDTH)..=20_000))]
    width: u32,
    /// The line above the drawing [default: the input's name, and what is drawn]
    #[arg(long)]
    title: Option<String>,
    #[command(flatten)]
    plan: PlanArgs,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum What {
    /// Faces, cells, portals and the adjacency graph
    Cells,
    /// The lines that divide a floorplan, in the order of the tree
    Splits,
    /// The cells that `--from` sees, with a line to each
    Visibility,
}

impl What {
    /// What the title says.
    fn about(self) -> &'static str {
        match self {
            What::Cells => "cells, portals, adjacency graph",
            What::Splits => "splits",
            What::Visibility => "cell-to-cell visibility",
        }
    }

    fn looks_from_a_cell(self) -> bool {
        match self {
            What::Visibility => true,
            What::Cells | What::Splits => false,
        }
    }
}

pub(super) fn run(args: Args) -> Result<Exit, Failure> {
    if args.what.looks_from_a_cell() != args.from.is_some() {
        return Err(Failure::usage("--from is what a picture of visibility needs, and no other"));
    }
    files::check_outputs([&args.output])?;
    let input = Input::read(&args.input)?;
    let picture = match is_sequence(&input.bytes) {
        true => draw_sequence(&args, &input)?,
        false => draw_plan(&args, &input)?,
    };
    files::write(args.output.as_deref(), |out| out.write_all(picture.as_bytes()))?;
    Ok(Exit::Done)
}

fn options(args: &Args, input: &Input, about: &str) -> SheetOptions {
    let title = args.title.clone();
    let title = title.unwrap_or_else(|| format!("{}: {about}", input.file_name()));
    SheetOptions { title, width: args.width }
}

fn draw_plan(args: &Args, input: &Input) -> Result<String, Failure> {
    let planar = plan::read(input, &args.plan, &Silent)?;
    let graph = planar.graph();
    let from = args.from.as_ref().map(|name| files::cell_of(&graph.cells, &input.name, name));
    let from = from.transpose()?;
    let options = options(args, input, args.what.about());
    let (sheet, floor) = floor(&planar, &options);
    match (args.what, from) {
        (What::Cells, _) => Ok(draw::draw_cells(sheet, &floor)),
        (What::Splits, _) => match &planar {
            Planar::Divided { cells, .. } => Ok(draw::draw_splits(sheet, &floor, &cells.tree)),
            Planar::Graph(_) => {
                Err(Failure::file(&input.name, "states cells, which nothing divides"))
            }
        },
        (What::Visibility, Some(from)) => draw_visibility(&planar, sheet, &floor, from),
        (What::Visibility, None) => unreachable!("checked with the arguments"),
    }
}

fn floor(planar: &Planar, options: &SheetOptions) -> (Sheet, Floor) {
    match planar {
        Planar::Divided { plan, cells } => Floor::of_plan(plan, cells, options),
        Planar::Graph(graph) => Floor::of_graph(graph, options),
    }
}

fn draw_visibility(
    planar: &Planar,
    sheet: Sheet,
    floor: &Floor,
    from: CellId,
) -> Result<String, Failure> {
    let graph = planar.graph();
    let (matrix, witnesses) = sights(planar, true, &Silent).ok_or(Failure::Interrupted)?;
    let sees = |cell: &CellId| matrix.get(from.0 as usize, cell.0 as usize) == Verdict::Open;
    let visible: Vec<CellId> = floor.cells().filter(sees).collect();
    let mut lines = Vec::new();
    for witness in &witnesses {
        let pair = [witness.from, witness.to].map(CellId);
        if pair.contains(&from) {
            let line = on_grid(graph, &witness.line);
            let portals = witness.portals.clone();
            lines.push(Sightline { from: pair[0], to: pair[1], portals, line });
        }
    }
    Ok(draw::draw_visibility(sheet, floor, from, &visible, &lines))
}

/// A line's points in grid units.
fn on_grid(graph: &PlanGraph, line: &WitnessLine) -> [[Rational; 2]; 2] {
    let grid = Rational::from(graph.grid.clone());
    line.points().map(|point| [0, 1].map(|axis| point[axis].to_rational() * &grid))
}

/// Whether the text says that it is a sequence. Who reads it finds what else is wrong with it.
fn is_sequence(bytes: &[u8]) -> bool {
    #[derive(serde::Deserialize)]
    struct Stated {
        format: String,
    }
    serde_json::from_slice(bytes).is_ok_and(|stated: Stated| stated.format == SEQUENCE_FORMAT)
}

fn draw_sequence(args: &Args, input: &Input) -> Result<String, Failure> {
    let wrong = |error: &dyn std::fmt::Display| Failure::file(&input.name, error);
    let file = SequenceFile::read(&input.bytes).map_err(|error| wrong(&error))?;
    let portals = match file.points().map_err(|error| wrong(&error))? {
        SequencePoints::Plane { portals, .. } => portals,
        SequencePoints::Space { .. } => {
            return Err(wrong(&"the sequence lies in space, and pictures in the plane"));
        }
    };
    let ends: Vec<[PlanPoint; 2]> = portals
        .iter()
        .map(|portal| portal.clone().map(|end| PlanPoint::integer(end.coordinates)))
        .collect();
    let hourglass = super::stab::hourglass(portals).map_err(|error| wrong(&error))?;
    let (line, about) = match hourglass.verdict() {
        PlaneVerdict::Open(witness) => (SequenceLine::Stabbing(witness.points), "open"),
        PlaneVerdict::Grazing { touching_line, .. } => {
            let points = touching_line.map(|point| point.coordinates.map(Rational::from));
            (SequenceLine::Touching(points), "grazing")
        }
        PlaneVerdict::Blocked { .. } => (SequenceLine::Blocked, "blocked"),
    };
    Ok(draw::draw_sequence(&ends, &line, &options(args, input, about)))
}
