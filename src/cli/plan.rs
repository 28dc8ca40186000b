//! Inputs of two dimensions: floorplans, divided on the way, and graphs of the plane.

use super::doom::{self, DoomLevel};
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
    pub(super) fn method(&self) -> PlanMethod {
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
        /// What else it is, if it is a Doom level.
        level: Option<Box<DoomLevel>>,
    },
    /// A graph, as it is stated.
    Graph(Box<PlanGraph>),
}

impl Planar {
    /// What else a Doom level is.
    pub(super) fn level(&self) -> Option<&DoomLevel> {
        match self {
            Planar::Divided { level, .. } => level.as_deref(),
            Planar::Graph(_) => None,
        }
    }

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
    if input.map.is_some() {
        let (plan, cells, level) = doom::read(input, args, progress)?;
        let level = Some(Box::new(level));
        return Ok(Planar::Divided { plan: Box::new(plan), cells: Box::new(cells), level });
    }
    match read_plan(&input.name, &input.bytes)? {
        PlanInput::Graph(graph) => Ok(Planar::Graph(graph)),
        PlanInput::Plan(plan) => {
            let tree = divide(&plan, &args.method(), progress).ok_or(Failure::Interrupted)?;
            // A stated box may be smaller than the plan; then ways out of it are no leaks.
            let cells = cells_of_plan(&plan, tree, !plan.has_view)
                .map_err(|error| Failure::file(&input.name, error))?;
            report_oddities(input, &plan, &cells);
            Ok(Planar::Divided { plan, cells: Box::new(cells), level: None })
        }
    }
}

/// How many oddities of a kind a message lists.
const LISTED: usize = 5;

fn report_oddities(input: &Input, plan: &Plan, cells: &PlanCells) {
    // Segments by their number in the input.
    let name = |&segment: &u32| plan.segments[segment as usize].source;
    let pair = |pair: &[u32; 2]| {
        let [a, b] = pair.each_ref().map(name);
        format!("{a} and {b}")
    };
    let at = |(both, point): &([u32; 2], u32)| {
        let [x, y] = cells.graph.world(*point);
        format!("{} at ({x} {y})", pair(both))
    };
    let listed = [
        (
            "segments of zero length left out",
            plan.repairs.zero_length.iter().map(u32::to_string).collect::<Vec<_>>(),
        ),
        ("pairs of segments overlap", cells.meets.overlapping.iter().map(pair).collect()),
        (
            "pairs of segments cross, and are split there",
            cells.meets.crossing.iter().map(at).collect(),
        ),
    ];
    for (what, all) in listed.iter().filter(|(_, all)| !all.is_empty()) {
        let shown = all.iter().take(LISTED).map(String::as_str).collect::<Vec<_>>().join(", ");
        let more = if all.len() > LISTED { ", …" } else { "" };
        eprintln!("{}: {} {what}: {shown}{more}", input.name, all.len());
    }
}
