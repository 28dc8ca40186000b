//! Pictures of what a cell or an eye sees.

use super::super::exit::Failure;
use super::super::numbers::numbers;
use super::super::plan::Planar;
use super::super::pvs::plan::{Wants, sights};
use super::Args;
use super::asked::Cull;
use crate::draw::{self, EyeDrawing, Floor, Sheet, Sightline, TreeNode};
use crate::eye::plan::{CellSight, EyePlan, ViewCone};
use crate::num::Rational;
use crate::portal::plan::PlanCells;
use crate::pvs::plan::{PlanStabTree, plan_stab_trees};
use crate::report::{Silent, Verdict, WitnessLine};
use crate::scene::CellId;
use crate::scene::plan::{Plan, PlanGraph, PlanStabNode};
use std::iter;

/// Draws a cell, the cells that it sees, and a line to each.
pub(super) fn draw_visibility(
    planar: &Planar,
    sheet: Sheet,
    floor: &Floor,
    from: CellId,
) -> Result<String, Failure> {
    let graph = planar.graph();
    let wants = Wants { witnesses: true, grazing: false };
    let found = sights(planar, None, wants, &Silent).ok_or(Failure::Interrupted)?;
    let sees = |cell: &CellId| found.matrix.get(from.0 as usize, cell.0 as usize) == Verdict::Open;
    let visible: Vec<CellId> = floor.cells().filter(sees).collect();
    let mut lines = Vec::new();
    for witness in &found.witnesses {
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

/// An eye as the options state it.
#[derive(Debug)]
pub(super) struct Eye {
    at: [Rational; 2],
    cone: Option<ViewCone>,
}

impl Eye {
    /// The eye of the options, if they state one.
    pub(super) fn of(args: &Args) -> Result<Option<Eye>, Failure> {
        let Some(at) = &args.at else { return Ok(None) };
        let at = numbers("--at", at)?;
        let cone = match (&args.look, &args.half_tangent) {
            (Some(look), Some(tangent)) => {
                let [tangent] = numbers("--half-tangent", tangent)?;
                let cone = ViewCone::new(&numbers("--look", look)?, &tangent);
                Some(cone.map_err(|error| Failure::usage(format!("--look: {error}")))?)
            }
            _ => None,
        };
        Ok(Some(Eye { at, cone }))
    }
}

/// Draws what an eye sees of a plan, and which cells a cull leaves.
pub(super) fn draw_eye(
    file: &str,
    (plan, cells): (&Plan, &PlanCells),
    (sheet, floor): (Sheet, &Floor),
    eye: &Eye,
    cull: Cull,
) -> Result<String, Failure> {
    let prepared = EyePlan::new(plan, cells);
    let place =
        prepared.place(prepared.grid_point(&eye.at)).map_err(|error| Failure::file(file, error))?;
    let tree = stab_tree(&cells.graph, place.cell())?;
    let view = prepared.view(&place, eye.cone.as_ref());
    let left = view.cull(cull.method(), CellSight::Tree(&tree.nodes));
    let regions = view.regions(&view.sequences());
    let drawing = EyeDrawing {
        cone: eye
            .cone
            .as_ref()
            .map(|cone| cone.sides().clone().map(|side| side.map(Rational::from))),
        visible: tree.cells(),
        left,
        regions: regions.into_iter().map(|region| region.polygon).collect(),
        cull: cull.method().name(),
    };
    Ok(draw::draw_eye(sheet, floor, place.eye(), &drawing))
}

/// The stab tree of a cell.
pub(super) fn stab_tree(graph: &PlanGraph, from: CellId) -> Result<PlanStabTree, Failure> {
    let trees = plan_stab_trees(graph, &graph.crossings(), &[from], false, &Silent);
    trees.and_then(|mut trees| trees.pop()).ok_or(Failure::Interrupted)
}

/// The nodes of a stab tree as they are drawn: its root comes first.
pub(super) fn nodes(tree: &PlanStabTree) -> Vec<TreeNode> {
    let root = TreeNode { cell: tree.source, before: None };
    let node = |node: &PlanStabNode| {
        let parent = node.parent.map_or(0, |parent| parent + 1);
        TreeNode { cell: node.cell, before: Some((parent, node.portal)) }
    };
    iter::once(root).chain(tree.nodes.iter().map(node)).collect()
}
