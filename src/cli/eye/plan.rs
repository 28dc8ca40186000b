//! `stabline eye` on floorplans.

use super::super::exit::{Exit, Failure};
use super::super::files::{self, Input};
use super::super::numbers::numbers;
use super::super::plan::{self, Planar};
use super::{Args, Method};
use crate::eye::half_tangent;
use crate::eye::plan::{CellSight, EyePlan, PlanCull, PlanPlaceError, ViewCone, Walk};
use crate::num::Rational;
use crate::pvs::plan::plan_stab_trees;
use crate::report::{EyePlanReport, InputId, Silent};
use crate::scene::CellId;
use crate::scene::plan::{Crossings, PlanGraph, PlanStabNode};

pub(super) fn run(args: &Args, input: &Input) -> Result<Exit, Failure> {
    refuse_space(args)?;
    let points = points(args)?;
    let cone = cone(args)?;
    let cull = cull(args)?;
    if args.regions && cull != PlanCull::Exact {
        return Err(Failure::usage("--regions needs the exact cull"));
    }
    let Planar::Divided { plan, cells, level } = plan::read(input, &args.plan, &Silent)? else {
        let what =
            "a graph of the plane does not say where its cells end: an eye needs a floorplan";
        return Err(Failure::file(&input.name, what));
    };
    let eyes = EyePlan::new(&plan, &cells);
    let id = InputId::new(&input.file_name(), &input.bytes);
    let area = (&eyes.whole_area()).into();
    let mut report = EyePlanReport::new(id, cull.name(), cone.as_ref().map(ViewCone::report), area);
    let crossings = cells.graph.crossings();
    // The exact cull does not need the tree.
    let mut walk = Walk::new(&eyes, |cell| match cull {
        PlanCull::Exact => Vec::new(),
        _ => stab_tree(&cells.graph, &crossings, cell),
    });
    for point in &points {
        let eye = eyes.grid_point(point);
        let step = walk.step(eye, cone.as_ref()).map_err(|error| {
            let why = why(&error, level.is_some());
            Failure::file(&input.name, format!("({} {}): {why}", point[0], point[1]))
        })?;
        let place = walk.place().expect("a walk that has made a step is somewhere");
        let tree = walk.kept().map(Vec::as_slice).unwrap_or_default();
        let view = eyes.view(place, cone.as_ref());
        let mut view = view.report(cull, CellSight::Tree(tree), args.regions);
        view.step = args.path.is_some().then(|| eyes.report_step(&step));
        report.views.push(view);
    }
    files::print(&if args.json { report.to_json() } else { report.to_text() })?;
    Ok(Exit::Done)
}

/// Why an eye has no view, in the words of its input.
fn why(error: &PlanPlaceError, is_level: bool) -> String {
    match error {
        PlanPlaceError::OnWall { segment } if is_level => {
            format!("the eye is on a wall: linedef {segment}")
        }
        error => error.to_string(),
    }
}

/// What has no meaning in the plane.
fn refuse_space(args: &Args) -> Result<(), Failure> {
    let world = args.world.stated();
    let stated = [
        (args.up.is_some(), "--up"),
        (args.cell.is_some(), "--cell"),
        (args.objects, "--objects"),
        (args.glb.is_some(), "--glb"),
        (args.obj.is_some(), "--obj"),
        (!world.is_empty(), world.as_str()),
    ];
    match stated.iter().find(|(is_stated, _)| *is_stated) {
        Some((_, option)) => Err(Failure::usage(format!(
            "{option}: the input lies in the plane, where this has no meaning"
        ))),
        None => Ok(()),
    }
}

/// Two numbers of an option, or one.
fn plane<const N: usize>(option: &str, text: &str) -> Result<[Rational; N], Failure> {
    numbers(option, text).map_err(|failure| match failure {
        Failure::Usage(what) => Failure::Usage(format!("{what} (the input lies in the plane)")),
        Failure::Input(_) | Failure::Flaw(_) | Failure::Interrupted => failure,
    })
}

/// The points that the eye looks from.
fn points(args: &Args) -> Result<Vec<[Rational; 2]>, Failure> {
    match (&args.at, &args.path) {
        (Some(at), _) => Ok(vec![plane("--at", at)?]),
        (None, path) => {
            let path = path.as_deref().unwrap_or_default();
            let points: Result<Vec<_>, _> =
                path.split_whitespace().map(|point| plane("--path", point)).collect();
            match points?.as_slice() {
                [] => Err(Failure::usage("--path: expected one or more points, got none")),
                points => Ok(points.to_vec()),
            }
        }
    }
}

fn cone(args: &Args) -> Result<Option<ViewCone>, Failure> {
    let Some(look) = &args.look else { return Ok(None) };
    let look = plane("--look", look)?;
    let [tangent] = match (&args.half_tangents, &args.fov) {
        (Some(text), _) => plane("--half-tangents", text)?,
        (None, Some(text)) => {
            let [angle] = plane("--fov", text)?;
            [half_tangent(&angle).map_err(|error| Failure::usage(format!("--fov: {error}")))?]
        }
        (None, None) => return Err(Failure::usage("--look needs --half-tangents or --fov")),
    };
    ViewCone::new(&look, &tangent).map(Some).map_err(Failure::usage)
}

fn cull(args: &Args) -> Result<PlanCull, Failure> {
    match args.cull {
        Method::Exact => Ok(PlanCull::Exact),
        Method::Portals => Ok(PlanCull::IncidentPortals),
        Method::Component => Ok(PlanCull::ConnectedComponent),
        Method::Disjoint => Ok(PlanCull::DisjointCell),
        Method::None => Ok(PlanCull::None),
        Method::Float | Method::Flood => Err(Failure::usage(
            "--cull float and flood are for space; in a floorplan there are exact, portals, \
             component, disjoint and none",
        )),
    }
}

/// The stab tree of a cell.
fn stab_tree(graph: &PlanGraph, crossings: &Crossings, cell: CellId) -> Vec<PlanStabNode> {
    let trees = plan_stab_trees(graph, crossings, &[cell], false, &Silent);
    let trees = trees.expect("nothing interrupts a search in silence");
    trees.into_iter().flat_map(|tree| tree.nodes).collect()
}
