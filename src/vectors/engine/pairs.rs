//! Pairs of cells: of a portal graph, or of a scene of geometry.

use super::{EngineError, NAME, ViewCells, ViewCells2, index_of};
use crate::pvs::plan::{Cover, Groups, classify_plan_grazing, plan_matrix};
use crate::pvs::{self, Options};
use crate::report::{Matrix, Silent, Verdict};
use crate::scene::plan::{PlanGraph, PlanInput, read_plan};
use crate::scene::world::InputKind;
use crate::scene::{PortalGraph, read_graph};
use crate::vectors::Class;
use serde_json::Value;

/// The verdict on two cells of a portal graph, in space or in the plane.
pub(super) fn of_graph(scene: &Value, ends: [&str; 2]) -> Result<Class, EngineError> {
    let bytes = scene.to_string().into_bytes();
    match InputKind::of(NAME, &bytes)? {
        InputKind::Plan => match read_plan(NAME, &bytes)? {
            PlanInput::Graph(graph) => of_plan_graph(&graph, ends),
            PlanInput::Plan(_) => Err(EngineError::input("expected a portal graph")),
        },
        _ => of_space_graph(&read_graph(NAME, &bytes)?, ends),
    }
}

fn pair(cells: &[String], [from, to]: [&str; 2]) -> Result<[usize; 2], EngineError> {
    Ok([index_of(cells.iter(), "from", from)?, index_of(cells.iter(), "to", to)?])
}

fn of_space_graph(graph: &PortalGraph, ends: [&str; 2]) -> Result<Class, EngineError> {
    let [from, to] = pair(&graph.cells, ends)?;
    let mut matrix = open_pairs(graph);
    if matrix.get(from, to) == Verdict::NotOpen {
        pvs::classify_grazing(graph, &mut matrix, None, &Silent);
    }
    Ok(class(matrix.get(from, to)))
}

fn open_pairs(graph: &PortalGraph) -> Matrix {
    let done = pvs::compute(graph, &Options::default(), Vec::new(), &|_| {}, &Silent);
    pvs::assemble(graph, &done.rows)
}

/// Without a budget nothing is undecided.
fn class(verdict: Verdict) -> Class {
    match verdict {
        Verdict::Open | Verdict::Undecided => Class::Open,
        Verdict::Grazing => Class::Grazing,
        Verdict::NotOpen => Class::Blocked,
    }
}

/// A stated graph of the plane is searched as portals with a height of 1. Lines that touch are
/// not: in space they may stand upright.
fn of_plan_graph(graph: &PlanGraph, ends: [&str; 2]) -> Result<Class, EngineError> {
    let [from, to] = pair(&graph.cells, ends)?;
    let mut matrix = open_pairs(&graph.in_space());
    if matrix.get(from, to) == Verdict::NotOpen {
        let groups = Groups::cells(graph.cells.len());
        classify_plan_grazing(graph, &graph.crossings(), &groups, &mut matrix, &Silent);
    }
    Ok(class(matrix.get(from, to)))
}

/// The verdict on two view cells of a scene of geometry, in space or in the plane.
pub(super) fn of_scene(scene: &Value, ends: [&str; 2]) -> Result<Class, EngineError> {
    match InputKind::of(NAME, &scene.to_string().into_bytes())? {
        InputKind::Plan => of_plan(&ViewCells2::of_plane(scene)?, ends),
        _ => of_world(&ViewCells::of_space(scene)?, ends),
    }
}

fn of_plan(view: &ViewCells2, ends: [&str; 2]) -> Result<Class, EngineError> {
    let [from, to] = pair(&view.names, ends)?;
    let graph = &view.cells.graph;
    let crossings = graph.crossings();
    let cover = Cover::new(view.names.len(), view.of_cell.iter().map(Vec::as_slice));
    let uninterrupted = "nothing interrupts in silence";
    let mut matrix = plan_matrix(graph, &crossings, cover.groups(), &Silent).expect(uninterrupted);
    classify_plan_grazing(graph, &crossings, cover.groups(), &mut matrix, &Silent)
        .expect(uninterrupted);
    Ok(class(cover.matrix(matrix).get(from, to)))
}

fn of_world(view: &ViewCells, ends: [&str; 2]) -> Result<Class, EngineError> {
    let [from, to] = pair(&view.names, ends)?;
    let graph = &view.cells.graph;
    let inside = |object: usize| {
        let is_in = move |(_, of): &(usize, &Vec<u32>)| of.contains(&(object as u32));
        view.of_cell.iter().enumerate().filter(is_in).map(|(cell, _)| cell)
    };
    let best = |matrix: &Matrix| {
        let pairs = inside(from).flat_map(|a| inside(to).map(move |b| (a, b)));
        pairs.map(|(a, b)| class(matrix.get(a, b))).max().unwrap_or(Class::Blocked)
    };
    let mut matrix = open_pairs(graph);
    if best(&matrix) != Class::Open {
        pvs::classify_grazing(graph, &mut matrix, None, &Silent);
    }
    Ok(best(&matrix))
}
