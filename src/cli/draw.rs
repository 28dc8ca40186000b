//! `stabline draw`: pictures of floorplans, and of what is seen in them.

mod asked;
mod level;
mod sequence;
mod sight;

use super::exit::{Exit, Failure};
use super::files::{self, Input};
use super::plan::{self, PlanArgs, Planar};
use crate::draw::{self, DEFAULT_WIDTH, Floor, LEAST_WIDTH, Sheet, SheetOptions};
use crate::report::Silent;
use asked::{Asked, Cull, What};
use std::path::PathBuf;

/// Draw a floorplan, or what is seen in it, as an SVG
///
/// INPUT is a floorplan or a graph of the plane (`stabline-scene/1`), a Doom level
/// (`FILE.wad:MAP01`), or a sequence of segments (`stabline-sequence/1`). What a picture shows was
/// decided exactly; its places are rounded to a hundredth of its unit.
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    /// What is to be drawn
    input: PathBuf,
    /// Which picture of a plan
    #[arg(long, value_enum, value_name = "WHAT", default_value = "cells")]
    what: What,
    /// The cell or the sector that one looks from: its name, or its number
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
    /// How cells are ruled out for the eye [default: exact]
    #[arg(long, value_enum, value_name = "METHOD")]
    cull: Option<Cull>,
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

pub(super) fn run(args: Args) -> Result<Exit, Failure> {
    let asked = Asked::of(&args)?;
    files::check_outputs([&args.output])?;
    let input = Input::read(&args.input)?;
    let picture = match sequence::is_sequence(&input.bytes) {
        true => sequence::draw(&args, &input)?,
        false => draw_plan(&args, &input, &asked)?,
    };
    files::write(args.output.as_deref(), |out| out.write_all(picture.as_bytes()))?;
    Ok(Exit::Done)
}

fn options(args: &Args, input: &Input, about: &str) -> SheetOptions {
    let title = args.title.clone();
    let title = title.unwrap_or_else(|| format!("{}: {about}", input.file_name()));
    SheetOptions { title, width: args.width }
}

fn draw_plan(args: &Args, input: &Input, asked: &Asked) -> Result<String, Failure> {
    let planar = plan::read(input, &args.plan, &Silent)?;
    let options = options(args, input, asked.about(planar.level().is_some()));
    let (sheet, mut floor) = floor(&planar, &options);
    let cell = |name: &str| files::cell_of(&planar.graph().cells, &input.name, name);
    match (asked, &planar) {
        (Asked::Cells, Planar::Divided { level: Some(level), .. }) => {
            Ok(level::draw_leaves(level, sheet, &mut floor))
        }
        (Asked::Cells, _) => Ok(draw::draw_cells(sheet, &floor)),
        (Asked::Visibility { from }, _) => {
            sight::draw_visibility(&planar, sheet, &floor, cell(from)?)
        }
        (Asked::Splits, Planar::Divided { cells, .. }) => {
            Ok(draw::draw_splits(sheet, &floor, &cells.tree))
        }
        (Asked::StabTree { from, is_alone }, Planar::Divided { cells, .. }) => {
            let tree = sight::stab_tree(&cells.graph, cell(from)?)?;
            let nodes = sight::nodes(&tree);
            Ok(match is_alone {
                true => draw::draw_tree_graph(&cells.graph.cells, &nodes, &options),
                false => draw::draw_stab_tree(sheet, &floor, &nodes),
            })
        }
        (Asked::Eye { eye, cull }, Planar::Divided { plan, cells, .. }) => {
            sight::draw_eye(&input.name, (plan, cells), (sheet, &floor), eye, *cull)
        }
        (Asked::Sectors { from }, Planar::Divided { level: Some(level), .. }) => {
            level::draw_sectors(&input.name, (&planar, level), (sheet, &mut floor), from)
        }
        (Asked::Sectors { .. }, _) => {
            Err(Failure::file(&input.name, "has no sectors; expected a map, FILE.wad:MAP01"))
        }
        (Asked::Splits | Asked::StabTree { .. } | Asked::Eye { .. }, Planar::Graph(_)) => {
            let message = "states cells without a shape, and this picture needs a floorplan";
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
