//! View cells: the objects of a scene of geometry, as what its cells make of them.
//!
//! The faces of every object become hints, so that no cell lies on both sides of one; an object is
//! then the union of the cells inside it, and two objects see each other iff two such cells do.

use super::{EngineError, NAME};
use crate::num::Sign;
use crate::portal::plan::{PlanCells, cells_of_plan};
use crate::portal::{WorldCells, cells_of_world};
use crate::predicates::{PlanPoint, turn_of_points};
use crate::report::Silent;
use crate::scene::plan::{Plan, PlanInput, read_plan};
use crate::scene::world::{World, WorldOptions, read_world};
use crate::subdivision::Options;
use crate::subdivision::plan::{PlanMethod, divide};
use serde_json::{Value, json};

/// The same scene with the faces of its objects as hints.
pub fn with_split_view_cells(scene: &Value) -> Value {
    let mut scene = scene.clone();
    let objects = scene.get("objects").and_then(Value::as_array).cloned().unwrap_or_default();
    let mut hints = scene.get("hints").and_then(Value::as_array).cloned().unwrap_or_default();
    for object in &objects {
        if let Some(corners) = object.get("polygon").and_then(Value::as_array) {
            let after = corners.iter().cycle().skip(1);
            hints.extend(corners.iter().zip(after).map(|(a, b)| json!([a, b])));
        } else if let Some(corners) = object.get("box") {
            hints.push(json!({ "box": corners }));
        }
    }
    if let Value::Object(fields) = &mut scene {
        fields.insert("hints".to_owned(), Value::Array(hints));
    }
    scene
}

/// A world's cells, and the view cells that each is in.
pub struct ViewCells {
    /// What stands in space.
    pub world: World,
    /// Its cells.
    pub cells: WorldCells,
    /// The names of the view cells.
    pub names: Vec<String>,
    /// For each cell, the view cells that it is in, by index.
    pub of_cell: Vec<Vec<u32>>,
}

impl ViewCells {
    /// Divides a scene of geometry in space.
    ///
    /// # Errors
    /// [`EngineError::Input`] for a scene that is refused.
    pub fn of_space(scene: &Value) -> Result<ViewCells, EngineError> {
        let bytes = with_split_view_cells(scene).to_string().into_bytes();
        let (world, _) = read_world(NAME, &bytes, &WorldOptions::default())?;
        let cells = cells_of_world(&world, &Options::default()).map_err(EngineError::input)?;
        let names = world.objects.iter().map(|object| object.place.name.clone()).collect();
        let of_leaf = cells.leaves.iter().map(|&leaf| {
            let point = cells.subdivision.leaf(leaf).cell.inner_point().coordinates();
            let holds = |index: &u32| {
                let bounds = &world.objects[*index as usize].bounds;
                (0..3).all(|i| bounds.low[i] < point[i] && point[i] < bounds.high[i])
            };
            (0..world.objects.len() as u32).filter(holds).collect()
        });
        let of_cell = of_leaf.collect();
        Ok(ViewCells { world, cells, names, of_cell })
    }
}

/// A floorplan's cells, and the view cells that each is in.
pub struct ViewCells2 {
    /// What stands in the plane.
    pub plan: Plan,
    /// Its cells.
    pub cells: PlanCells,
    /// The names of the view cells.
    pub names: Vec<String>,
    /// For each cell, the view cells that it is in, by index.
    pub of_cell: Vec<Vec<u32>>,
}

impl ViewCells2 {
    /// Divides a floorplan.
    ///
    /// # Errors
    /// [`EngineError::Input`] for a scene that is refused.
    pub fn of_plane(scene: &Value) -> Result<ViewCells2, EngineError> {
        let bytes = with_split_view_cells(scene).to_string().into_bytes();
        let PlanInput::Plan(plan) = read_plan(NAME, &bytes)? else {
            return Err(EngineError::input("a graph of the plane has no view cells"));
        };
        let tree = divide(&plan, &PlanMethod::Bsp, &Silent).map_err(EngineError::input)?;
        let closed = !plan.has_view;
        let cells = cells_of_plan(&plan, tree, closed).map_err(EngineError::input)?;
        let names = plan.objects.iter().map(|object| object.name.clone()).collect();
        let of_cell = cells.graph.polygons.iter().map(|polygon| {
            let corners: Vec<&PlanPoint> =
                polygon.iter().map(|&corner| cells.graph.points.get(corner)).collect();
            let holds = |index: &u32| is_inside(&plan.objects[*index as usize].polygon, &corners);
            (0..plan.objects.len() as u32).filter(holds).collect()
        });
        let of_cell = of_cell.collect();
        Ok(ViewCells2 { plan: *plan, cells, names, of_cell })
    }
}

/// Whether a convex polygon, which no edge of `outer` cuts, lies in the convex polygon `outer`.
fn is_inside(outer: &[PlanPoint], inner: &[&PlanPoint]) -> bool {
    let after = outer.iter().cycle().skip(1);
    outer.iter().zip(after).all(|(a, b)| {
        inner.iter().all(|corner| match turn_of_points(a, b, corner) {
            Sign::Positive => true,
            // On the boundary: what lies inside may touch it.
            Sign::Zero => true,
            Sign::Negative => false,
        })
    })
}
