//! Inputs of two dimensions: floorplans, divided on the way, and graphs of the plane.

use super::exit::Failure;
use super::files::Input;
use crate::num::parse_decimal;
use crate::portal::plan::{PlanCells, cells_of_plan};
use crate::report::Progress;
use crate::scene::plan::{Plan, PlanGraph, PlanInput, read_plan};
use crate::scene::world::InputKind;
use crate::subdivision::plan::{PlanDivisionError, PlanMethod, PlanTree, divide};
use num_traits::Signed;
use std::fmt::Display;

/// How a floorplan is divided into cells.
#[derive(Clone, Debug, clap::Args)]
#[command(next_help_heading = "Floorplans")]
pub(super) struct PlanArgs {
    /// Divide a floorplan of horizontal and vertical segments by a k-D tree, as Teller and Séquin
    /// do, and not by a BSP tree
    #[arg(long)]
    kd: bool,
    /// A line of the k-D tree splits a cell only if the segments on it are longer in sum than this
    /// (a decimal or ratio), or one of them runs across the cell
    #[arg(long, value_name = "LENGTH", requires = "kd")]
    kd_threshold: Option<String>,
}

impl PlanArgs {
    fn method(&self) -> Result<PlanMethod, Failure> {
        if !self.kd {
            return Ok(PlanMethod::Bsp);
        }
        let text = self.kd_threshold.as_deref().unwrap_or("0");
        let usage =
            |what: &dyn Display| Failure::usage(format!("--kd-threshold: `{text}`: {what}"));
        let threshold = parse_decimal(text).map_err(|error| usage(&error))?;
        if threshold.is_negative() {
            return Err(usage(&"expected a length, at least 0"));
        }
        Ok(PlanMethod::Kd { threshold })
    }

    /// The options that are not the default, as they are written.
    pub(super) fn stated(&self) -> String {
        let threshold = self.kd_threshold.as_ref();
        let threshold = threshold.map(|length| format!("--kd-threshold {}", length.trim()));
        let kd = self.kd.then(|| "--kd".to_owned());
        kd.into_iter().chain(threshold).collect::<Vec<_>>().join(" ")
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
            let divided = divide(&plan, &args.method()?, progress);
            let tree = divided.map_err(|error| match error {
                PlanDivisionError::Interrupted => Failure::Interrupted,
                PlanDivisionError::NotAxial { .. } => {
                    let what = format!("{error}; without --kd a BSP tree divides it");
                    Failure::file(&input.name, what)
                }
            })?;
            report_left_inside(input, &plan, &tree);
            // A stated box may be smaller than the plan; then ways out of it are no leaks.
            let cells = cells_of_plan(&plan, tree, !plan.has_view)
                .map_err(|leak| Failure::file(&input.name, leak))?;
            Ok(Planar::Divided { plan, cells: Box::new(cells) })
        }
    }
}

fn report_repairs(input: &Input, plan: &Plan) {
    let zero_length = plan.repairs.zero_length.iter();
    report_segments(input, "of zero length left out", zero_length.copied().collect());
}

/// Segments that the cells hold in their inside hide nothing.
fn report_left_inside(input: &Input, plan: &Plan, tree: &PlanTree) {
    let left = tree.left_inside.iter().map(|&segment| plan.segments[segment as usize].source);
    report_segments(
        input,
        "left inside of cells by the threshold, where they hide nothing",
        left.collect(),
    );
}

fn report_segments(input: &Input, what: &str, segments: Vec<u32>) {
    if segments.is_empty() {
        return;
    }
    let shown: Vec<String> = segments.iter().take(10).map(u32::to_string).collect();
    let more = if segments.len() > shown.len() { ", …" } else { "" };
    eprintln!("{}: {} segments {what}: {}{more}", input.name, segments.len(), shown.join(", "));
}
