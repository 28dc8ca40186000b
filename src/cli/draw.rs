//! `stabline draw`: pictures of floorplans, and of what is seen in them.

mod sequence;
mod sight;

use super::exit::{Exit, Failure};
use super::files::{self, Input};
use super::plan::{self, PlanArgs, Planar};
use crate::draw::{self, DEFAULT_WIDTH, Floor, LEAST_WIDTH, Sheet, SheetOptions};
use crate::eye::plan::PlanCull;
use crate::report::Silent;
use clap::ValueEnum;
use sight::Eye;
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
    /// Where the eye is: two decimals or ratios
    #[arg(long, value_name = "X,Y", allow_hyphen_values = true)]
    at: Option<String>,
    /// The direction of view; all around without
    #[arg(long, value_name = "X,Y", allow_hyphen_values = true, requires_all = ["at", "half_tangent"])]
    look: Option<String>,
    /// The tangent of half the angle of view
    #[arg(long, value_name = "H", requires = "look")]
    half_tangent: Option<String>,
    /// How cells are ruled out for the eye
    #[arg(long, value_enum, value_name = "METHOD", default_value = "exact")]
    cull: Cull,
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
    /// What the eye `--at` sees, and the cells that `--cull` leaves
    Eye,
    /// The lines that divide a floorplan, in the order of the tree
    Splits,
    /// The stab tree of `--from`, over the plan
    StabTree,
    /// The stab tree of `--from` in layers: cells, and the portals between them
    StabTreeGraph,
    /// The cells that `--from` sees, with a line to each
    Visibility,
}

/// The culls of Teller and Séquin 1991, §4.1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Cull {
    /// What the eye's cell sees
    None,
    /// Of it the cells that meet the view cone
    Disjoint,
    /// Those that are reached through such cells
    Connected,
    /// Those that are reached through portals that meet it
    Portals,
    /// The cells that are seen
    Exact,
}

impl Cull {
    fn method(self) -> PlanCull {
        match self {
            Cull::None => PlanCull::None,
            Cull::Disjoint => PlanCull::DisjointCell,
            Cull::Connected => PlanCull::ConnectedComponent,
            Cull::Portals => PlanCull::IncidentPortals,
            Cull::Exact => PlanCull::Exact,
        }
    }

    fn name(self) -> String {
        let value = self.to_possible_value().expect("no cull is hidden");
        value.get_name().to_owned()
    }
}

pub(super) fn run(args: Args) -> Result<Exit, Failure> {
    let eye = Eye::of(&args)?;
    let needs = [(args.what.looks_from_a_cell(), args.from.is_some(), "--from")];
    let needs = needs.into_iter().chain([(args.what == What::Eye, eye.is_some(), "--at")]);
    for (is_needed, is_there, option) in needs {
        if is_needed != is_there {
            let verb = if is_needed { "needs" } else { "has no use for" };
            let what = args.what.name();
            return Err(Failure::usage(format!("--what {what} {verb} {option}")));
        }
    }
    files::check_outputs([&args.output])?;
    let input = Input::read(&args.input)?;
    let picture = match sequence::is_sequence(&input.bytes) {
        true => sequence::draw(&args, &input)?,
        false => draw_plan(&args, &input, eye.as_ref())?,
    };
    files::write(args.output.as_deref(), |out| out.write_all(picture.as_bytes()))?;
    Ok(Exit::Done)
}

impl What {
    fn looks_from_a_cell(self) -> bool {
        match self {
            What::StabTree | What::StabTreeGraph | What::Visibility => true,
            What::Cells | What::Eye | What::Splits => false,
        }
    }

    fn name(self) -> String {
        let value = self.to_possible_value().expect("no picture is hidden");
        value.get_name().to_owned()
    }

    /// What the title says.
    fn about(self) -> &'static str {
        match self {
            What::Cells => "cells, portals, adjacency graph",
            What::Eye => "eye-to-cell visibility",
            What::Splits => "splits",
            What::StabTree | What::StabTreeGraph => "stab tree",
            What::Visibility => "cell-to-cell visibility",
        }
    }
}

fn options(args: &Args, input: &Input, about: &str) -> SheetOptions {
    let title = args.title.clone();
    let title = title.unwrap_or_else(|| format!("{}: {about}", input.file_name()));
    SheetOptions { title, width: args.width }
}

fn draw_plan(args: &Args, input: &Input, eye: Option<&Eye>) -> Result<String, Failure> {
    let planar = plan::read(input, &args.plan, &Silent)?;
    let cells = &planar.graph().cells;
    let from = args.from.as_ref().map(|name| files::cell_of(cells, &input.name, name));
    let from = from.transpose()?;
    let options = options(args, input, args.what.about());
    let (sheet, floor) = floor(&planar, &options);
    match (args.what, &planar) {
        (What::Cells, _) => Ok(draw::draw_cells(sheet, &floor)),
        (What::Visibility, _) => {
            let from = from.expect("checked with the arguments");
            sight::draw_visibility(&planar, sheet, &floor, from)
        }
        (What::Splits, Planar::Divided { cells, .. }) => {
            Ok(draw::draw_splits(sheet, &floor, &cells.tree))
        }
        (What::Eye, Planar::Divided { plan, cells, .. }) => {
            let eye = eye.expect("checked with the arguments");
            sight::draw_eye(&input.name, (plan, cells), (sheet, &floor), eye, args.cull)
        }
        (What::StabTree | What::StabTreeGraph, Planar::Divided { cells, .. }) => {
            let from = from.expect("checked with the arguments");
            let alone = (args.what == What::StabTreeGraph).then_some(&options);
            sight::draw_tree(&cells.graph, (sheet, &floor), from, alone)
        }
        (What::Splits | What::Eye | What::StabTree | What::StabTreeGraph, Planar::Graph(_)) => {
            let what = args.what.name();
            let message = format!("states cells without a shape; --what {what} needs a floorplan");
            Err(Failure::file(&input.name, message))
        }
    }
}

fn floor(planar: &Planar, options: &SheetOptions) -> (Sheet, Floor) {
    match planar {
        Planar::Divided { plan, cells, .. } => Floor::of_plan(plan, cells, options),
        Planar::Graph(graph) => Floor::of_graph(graph, options),
    }
}
