//! `stabline draw`: pictures of floorplans and of what is seen in them.

use super::exit::{Exit, Failure};
use super::files::{self, Input};
use crate::draw::{self, DEFAULT_WIDTH, Floor, LEAST_WIDTH, Sheet, SheetOptions};
use crate::portal::plan::{PlanCells, cells_of_plan};
use crate::report::Silent;
use crate::scene::plan::{Plan, PlanGraph, PlanInput, read_plan};
use crate::subdivision::plan::{PlanMethod, divide};
use std::path::PathBuf;

/// Draw a floorplan, or what is seen in it, as an SVG
///
/// INPUT is a floorplan or a graph of the plane (`stabline-scene/1`). Pictures are rounded to a
/// hundredth of their unit; what they show was decided exactly.
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    /// What is to be drawn
    input: PathBuf,
    /// Which picture of it
    #[arg(long, value_enum, value_name = "WHAT", default_value = "cells")]
    what: What,
    /// The picture; standard output without
    #[arg(short, long, value_name = "OUT.svg")]
    output: Option<PathBuf>,
    /// The width of the picture
    #[arg(long, value_name = "UNITS", default_value_t = DEFAULT_WIDTH,
        value_parser = clap::value_parser!(u32).range(i64::from(LEAST_WIDTH)..=20_000))]
    width: u32,
    /// The line above the drawing [default: the input's name and what is drawn]
    #[arg(long)]
    title: Option<String>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum What {
    /// Faces, cells, portals and the adjacency graph
    Cells,
}

pub(super) fn run(args: Args) -> Result<Exit, Failure> {
    files::check_outputs([&args.output])?;
    let input = Input::read(&args.input)?;
    let scene = Scene::read(&input)?;
    let about = match args.what {
        What::Cells => "cells, portals, adjacency graph".to_owned(),
    };
    let title = args.title.unwrap_or_else(|| format!("{}: {about}", input.file_name()));
    let (sheet, floor) = scene.floor(&SheetOptions { title, width: args.width });
    let picture = match args.what {
        What::Cells => draw::draw_cells(sheet, &floor),
    };
    files::write(args.output.as_deref(), |out| out.write_all(picture.as_bytes()))?;
    Ok(Exit::Done)
}

/// What is drawn upon.
enum Scene {
    Plan(Box<(Plan, PlanCells)>),
    Graph(Box<PlanGraph>),
}

impl Scene {
    fn read(input: &Input) -> Result<Scene, Failure> {
        match read_plan(&input.name, &input.bytes)? {
            PlanInput::Graph(graph) => Ok(Scene::Graph(graph)),
            PlanInput::Plan(plan) => {
                let tree = divide(&plan, &PlanMethod::default(), &Silent);
                let tree = tree.ok_or(Failure::Interrupted)?;
                let cells = cells_of_plan(&plan, tree, false)
                    .map_err(|leak| Failure::file(&input.name, leak))?;
                Ok(Scene::Plan(Box::new((*plan, cells))))
            }
        }
    }

    fn floor(&self, options: &SheetOptions) -> (Sheet, Floor) {
        match self {
            Scene::Plan(both) => Floor::of_plan(&both.0, &both.1, options),
            Scene::Graph(graph) => Floor::of_graph(graph, options),
        }
    }
}
