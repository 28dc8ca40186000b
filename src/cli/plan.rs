//! Inputs of two dimensions: floorplans, divided on the way, and graphs of the plane.

use super::exit::Failure;
use super::files::Input;
use crate::portal::plan::{PlanCells, cells_of_plan};
use crate::report::Progress;
use crate::scene::plan::{Plan, PlanGraph, PlanInput, read_plan};
use crate::scene::world::InputKind;
use crate::subdivision::plan::{PlanMethod, divide};

/// How a floorplan is divided into cells.
#[derive(Clone, Debug, clap::Args)]
pub(super) struct PlanArgs {}

impl PlanArgs {
    fn method(&self) -> PlanMethod {
        PlanMethod::Bsp
    }

    /// The options that are not the default, as they are written.
    pub(super) fn stated(&self) -> String {
        String::new()
    }
}

/// An input of two dimensions, its cells made.
pub(super) enum Planar {
    /// A floorplan.
    Divided {
        /// What it states.
        plan: Box<Plan>,
        /// Its cells.
        cells: Box<PlanCells>,
    },
    /// A graph, as it is stated.
    Graph(Box<PlanGraph>),
}

impl Planar {
    /// Its cells and portals.
    pub(super) fn graph(&self) -> &PlanGraph {
        match self {
            Planar::Divided { cells, .. } => &cells.graph,
            Planar::Graph(graph) => graph,
        }
    }
}

/// Whether the input lies in the plane.
pub(super) fn is_plan(input: &Input) -> bool {
    match InputKind::of(&input.name, &input.bytes) {
        Ok(kind) => kind == InputKind::Plan,
        // Who reads it as something else finds what is wrong with it.
        Err(_) => false,
    }
}

/// Reads an input of two dimensions, and divides it if it is a floorplan.
pub(super) fn read(
    input: &Input,
    args: &PlanArgs,
    progress: &dyn Progress,
) -> Result<Planar, Failure> {
    match read_plan(&input.name, &input.bytes)? {
        PlanInput::Graph(graph) => Ok(Planar::Graph(graph)),
        PlanInput::Plan(plan) => {
            report_repairs(input, &plan);
            let tree = divide(&plan, &args.method(), progress).ok_or(Failure::Interrupted)?;
            // A stated box may be smaller than the plan; then ways out of it are no leaks.
            let cells = cells_of_plan(&plan, tree, !plan.has_view)
                .map_err(|leak| Failure::file(&input.name, leak))?;
            Ok(Planar::Divided { plan, cells: Box::new(cells) })
        }
    }
}

fn report_repairs(input: &Input, plan: &Plan) {
    let zero_length = &plan.repairs.zero_length;
    if !zero_length.is_empty() {
        let shown: Vec<String> = zero_length.iter().take(10).map(u32::to_string).collect();
        let more = if zero_length.len() > shown.len() { ", …" } else { "" };
        eprintln!(
            "{}: {} segments of zero length left out: {}{more}",
            input.name,
            zero_length.len(),
            shown.join(", "),
        );
    }
}
