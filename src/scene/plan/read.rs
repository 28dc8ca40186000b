//! Reading what lies in the plane from a JSON scene.

use super::{Plan, PlanError, PlanErrorKind, PlanGraph, PlanPortal, RawPlan, RawSegment};
use crate::formats::json::{PlanFile, PlanGraphFile, PlanePoint, SceneKind};
use crate::num::Number;
use crate::predicates::PlanPoints;
use crate::scene::CellId;
use crate::scene::input::{InputError, InputErrorKind};
use rustc_hash::FxHashMap;

/// What a scene of two dimensions states.
#[derive(Clone, Debug)]
pub enum PlanInput {
    /// A floorplan, to be divided.
    Plan(Box<Plan>),
    /// Cells and portals.
    Graph(Box<PlanGraph>),
}

/// Reads a floorplan or a graph of the plane from the bytes of a file called `name`.
///
/// # Errors
/// [`InputError`] names the file, the place and the rule broken.
pub fn read_plan(name: &str, bytes: &[u8]) -> Result<PlanInput, InputError> {
    let error = |kind| InputError { name: name.to_owned(), kind };
    if bytes.is_empty() {
        return Err(error(InputErrorKind::Empty));
    }
    let json = |e| error(InputErrorKind::Json(e));
    match SceneKind::of(bytes).map_err(json)? {
        SceneKind::Plan => {
            let raw = raw_plan(PlanFile::read(bytes).map_err(json)?);
            let plan = Plan::from_raw(&raw);
            let plan = plan.map_err(|e| error(InputErrorKind::Plan(Box::new(e))))?;
            Ok(PlanInput::Plan(Box::new(plan)))
        }
        SceneKind::PlanGraph => {
            let graph = graph_of(PlanGraphFile::read(bytes).map_err(json)?).map_err(error)?;
            Ok(PlanInput::Graph(Box::new(graph)))
        }
        SceneKind::Graph | SceneKind::Geometry => Err(error(InputErrorKind::InSpace)),
    }
}

fn point([x, y]: PlanePoint) -> [Number; 2] {
    [x.0, y.0]
}

fn raw_plan(file: PlanFile) -> RawPlan {
    let segment =
        |is_opaque| move |ends: [PlanePoint; 2]| RawSegment { ends: ends.map(point), is_opaque };
    let opaque = file.segments.into_iter().map(segment(true));
    let object = |(index, object): (usize, crate::formats::json::PlanFileObject)| {
        let name = object.name.unwrap_or_else(|| format!("objects[{index}]"));
        (name, object.polygon.into_iter().map(point).collect())
    };
    RawPlan {
        segments: opaque.chain(file.hints.into_iter().map(segment(false))).collect(),
        view: file.view.map(|view| view.map(point)),
        declared_grid: file.grid.map(|grid| grid.0),
        inside: file.inside.unwrap_or_default().into_iter().map(point).collect(),
        objects: file.objects.into_iter().enumerate().map(object).collect(),
    }
}

fn graph_of(file: PlanGraphFile) -> Result<PlanGraph, InputErrorKind> {
    let mut numbers = FxHashMap::default();
    for (second, name) in file.cells.iter().enumerate() {
        if let Some(first) = numbers.insert(name.clone(), second) {
            return Err(InputErrorKind::CellTwice { name: name.clone(), first, second });
        }
    }
    let ends: Vec<[[Number; 2]; 2]> =
        file.portals.iter().map(|portal| portal.segment.clone().map(point)).collect();
    let broken = |portal: usize, kind| {
        InputErrorKind::Plan(Box::new(PlanError { place: format!("portals[{portal}]"), kind }))
    };
    let grid = file.grid.map(|grid| grid.0);
    let points_of = ends.iter().flatten().enumerate().map(|(i, end)| ("portals", i / 2, end));
    let grid = super::stated::common_grid(grid.as_ref(), points_of)
        .map_err(|e| InputErrorKind::Plan(Box::new(e)))?;
    let scale = super::stated::Scale::of(&grid);
    let mut points = PlanPoints::default();
    let mut portals = Vec::with_capacity(ends.len());
    for (index, (portal, ends)) in file.portals.into_iter().zip(&ends).enumerate() {
        let number = |field, name: String| match numbers.get(&name) {
            Some(&number) => Ok(CellId(number as u32)),
            None => Err(InputErrorKind::UnknownCell { portal: index, field, name }),
        };
        let (from, to) = (number("from", portal.from)?, number("to", portal.to)?);
        if from == to {
            return Err(broken(index, PlanErrorKind::SameCell));
        }
        let [left, right] = ends.each_ref().map(|end| points.insert(scale.point(end)));
        if left == right {
            return Err(broken(index, PlanErrorKind::OneEnd));
        }
        portals.push(PlanPortal { from, to, left, right });
    }
    Ok(PlanGraph { grid, points, cells: file.cells, polygons: Vec::new(), portals })
}
