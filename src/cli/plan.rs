//! Inputs of two dimensions: floorplans, divided on the way, and graphs of the plane.

use super::doom::{self, DoomLevel};
use super::exit::Failure;
use super::files::Input;
use crate::num::{Number, Rational};
use crate::portal::plan::{PlanCells, cells_of_plan};
use crate::report::Progress;
use crate::scene::plan::{Plan, PlanGraph, PlanInput, read_plan};
use crate::scene::world::InputKind;
use crate::subdivision::plan::{PlanDivisionError, PlanMethod, PlanTree, divide};
use num_traits::Signed;

/// How a floorplan is divided into cells.
#[derive(Clone, Debug, clap::Args)]
pub(super) struct PlanArgs {
    /// Divide a floorplan of axial segments by a k-D tree instead of a BSP tree
    #[arg(long)]
    kd: bool,
    /// A k-D split that no segment spans a cell along needs a length of segments on it above this
    /// (world units, such as 5/2); segments that are left inside of cells do not occlude
    #[arg(long, value_name = "LENGTH", requires = "kd", value_parser = parse_length)]
    kd_threshold: Option<Rational>,
}

fn parse_length(text: &str) -> Result<Rational, String> {
    match Number::parse(text).map(|number| number.to_rational()) {
        Ok(length) if !length.is_negative() => Ok(length),
        Ok(_) | Err(_) => Err(format!("expected a length such as 5/2, not {text:?}")),
    }
}

impl PlanArgs {
    fn method(&self) -> PlanMethod {
        match self.kd {
            true => PlanMethod::Kd { threshold: self.kd_threshold.clone().unwrap_or_default() },
            false => PlanMethod::Bsp,
        }
    }

    /// Divides a plan into cells.
    pub(super) fn divide(
        &self,
        input: &Input,
        plan: &Plan,
        progress: &dyn Progress,
    ) -> Result<PlanTree, Failure> {
        let tree = divide(plan, &self.method(), progress).map_err(|error| match error {
            PlanDivisionError::Interrupted => Failure::Interrupted,
            PlanDivisionError::NotAxial { .. } => {
                Failure::file(&input.name, format!("{error}; without --kd any segments will do"))
            }
        })?;
        if !tree.left_inside.is_empty() {
            eprintln!(
                "{}: {} segments are left inside of cells, where they do not occlude: what is \
                 open is an upper bound",
                input.name,
                tree.left_inside.len()
            );
        }
        Ok(tree)
    }

    /// The options that are not the default, as they are written.
    pub(super) fn stated(&self) -> String {
        let threshold = self.kd_threshold.as_ref().map(|t| format!(" --kd-threshold {t}"));
        let kd = if self.kd { "--kd" } else { "" };
        format!("{kd}{}", threshold.unwrap_or_default())
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
            let tree = args.divide(input, &plan, progress)?;
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
