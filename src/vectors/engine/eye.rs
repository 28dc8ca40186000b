//! What an eye sees: cells of a portal graph, or view cells of a scene of geometry.

use super::{EngineError, NAME, ViewCells, ViewCells2, field, index_of};
use crate::eye::plan::{EyePlan, ViewCone};
use crate::eye::{Cull, EyeGraph, EyeWorld, Frustum, Query};
use crate::geom::RationalPoint3;
use crate::num::{Number, Rational};
use crate::scene::plan::{PlanGraph, PlanInput, read_plan};
use crate::scene::world::InputKind;
use crate::scene::{CellId, PortalGraph, read_graph};
use serde_json::Value;

/// The names of what the eye sees.
pub(super) fn seen(input: &Value) -> Result<Vec<String>, EngineError> {
    let scene = field(input, "scene")?;
    let bytes = scene.to_string().into_bytes();
    match InputKind::of(NAME, &bytes)? {
        InputKind::Plan => match read_plan(NAME, &bytes)? {
            PlanInput::Graph(graph) => in_graph(&graph.in_space(), input, true),
            PlanInput::Plan(_) => in_plan(&ViewCells2::of_plane(scene)?, input),
        },
        InputKind::Graph => in_graph(&read_graph(NAME, &bytes)?, input, false),
        _ => in_world(&ViewCells::of_space(scene)?, input),
    }
}

/// Some numbers of a list: integers, or strings.
fn numbers<const N: usize>(
    value: &Value,
    name: &'static str,
) -> Result<[Rational; N], EngineError> {
    let number = |value: &Value| match value {
        Value::String(text) => Number::parse(text).ok(),
        Value::Number(number) => Number::parse(&number.to_string()).ok(),
        _ => None,
    };
    let list = value.as_array().map(|list| list.iter().map(number).collect::<Option<Vec<_>>>());
    let numbers = list.flatten().unwrap_or_default();
    let numbers: Vec<Rational> = numbers.iter().map(Number::to_rational).collect();
    let wrong = || EngineError::input(format!("`{name}`: expected {N} numbers"));
    numbers.try_into().map_err(|_| wrong())
}

fn at<const N: usize>(input: &Value) -> Result<[Rational; N], EngineError> {
    numbers(field(input, "at")?, "at")
}

/// The frustum of an eye in space, if it has one.
fn frustum(input: &Value) -> Result<Option<Frustum>, EngineError> {
    let Some(look) = input.get("look") else { return Ok(None) };
    let up = input.get("up").map_or_else(
        || Ok([0, 0, 1].map(|c| Rational::from(crate::num::Int::from(c)))),
        |up| numbers(up, "up"),
    );
    let tangents = numbers(field(input, "half_tangents")?, "half_tangents")?;
    let frustum = Frustum::new(&numbers(look, "look")?, &up?, &tangents);
    frustum.map(Some).map_err(EngineError::input)
}

/// The view cone of an eye in the plane, if it has one.
fn cone(input: &Value) -> Result<Option<ViewCone>, EngineError> {
    let Some(look) = input.get("look") else { return Ok(None) };
    let [tangent] = numbers(field(input, "half_tangents")?, "half_tangents")?;
    let cone = ViewCone::new(&numbers(look, "look")?, &tangent);
    cone.map(Some).map_err(EngineError::input)
}

/// A graph of the plane is looked at halfway up its portals, which have a height of 1; its cone
/// is not raised, so the plane's graphs are looked at all around.
fn in_graph(
    graph: &PortalGraph,
    input: &Value,
    is_plane: bool,
) -> Result<Vec<String>, EngineError> {
    let (eye, frustum) = match is_plane {
        true if input.get("look").is_some() => {
            return Err(EngineError::input("`look` is for floorplans and for space"));
        }
        true => (RationalPoint3::from(&PlanGraph::halfway_up(at(input)?)), None),
        false => (RationalPoint3::from(&at(input)?), frustum(input)?),
    };
    let cell = match input.get("cell").and_then(Value::as_str) {
        Some(name) => Some(CellId(index_of(graph.cells.iter(), "cell", name)? as u32)),
        None => None,
    };
    let query = Query { eye: &eye, frustum: frustum.as_ref(), cell, regions: false };
    let answer = EyeGraph::new(graph).look(&query, Cull::Exact).map_err(EngineError::input)?;
    Ok(answer.cells.iter().map(|reached| graph.cells[reached.cell.0 as usize].clone()).collect())
}

fn in_world(view: &ViewCells, input: &Value) -> Result<Vec<String>, EngineError> {
    let eye = RationalPoint3::from(&at(input)?);
    let frustum = frustum(input)?;
    let query = Query { eye: &eye, frustum: frustum.as_ref(), cell: None, regions: false };
    let looked = EyeWorld::new(&view.world, &view.cells).look(&query, Cull::Exact);
    let answer = looked.map_err(EngineError::input)?.answer;
    Ok(names(&view.names, &view.of_cell, answer.cells.iter().map(|reached| reached.cell)))
}

fn in_plan(view: &ViewCells2, input: &Value) -> Result<Vec<String>, EngineError> {
    let eyes = EyePlan::new(&view.plan, &view.cells);
    let cone = cone(input)?;
    let place = eyes.place(eyes.grid_point(&at(input)?)).map_err(EngineError::input)?;
    let looked = eyes.view(&place, cone.as_ref());
    let cells = looked.seen_cells(&looked.sequences());
    Ok(names(&view.names, &view.of_cell, cells.into_iter()))
}

/// The view cells that some of the cells are in.
fn names(
    names: &[String],
    of_cell: &[Vec<u32>],
    cells: impl Iterator<Item = CellId>,
) -> Vec<String> {
    let mut seen: Vec<u32> =
        cells.flat_map(|cell| of_cell[cell.0 as usize].iter().copied()).collect();
    seen.sort_unstable();
    seen.dedup();
    seen.into_iter().map(|object| names[object as usize].clone()).collect()
}
