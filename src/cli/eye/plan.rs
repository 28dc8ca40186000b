//! `stabline eye` on floorplans.

use super::super::exit::{Exit, Failure};
use super::super::files::{self, Input};
use super::super::numbers::numbers;
use super::super::plan::{self, Planar};
use super::{Args, Method};
use crate::eye::half_tangent;
use crate::eye::plan::{CellSight, EyePlan, PlanCull, ViewCone, Walk};
use crate::num::Rational;
use crate::predicates::PlanPoint;
use crate::pvs::plan::{Groups, plan_matrix};
use crate::report::{EyePlanReport, InputId, Silent, Verdict};
use crate::scene::CellId;
use crate::scene::plan::PlanGraph;

pub(super) fn run(args: &Args, input: &Input) -> Result<Exit, Failure> {
    refuse_space(args)?;
    let points = points(args)?;
    let cone = cone(args)?;
    let cull = cull(args)?;
    if args.regions && cull != PlanCull::Exact {
        return Err(Failure::usage("--regions needs the exact cull"));
    }
    let Planar::Divided { plan, cells, .. } = plan::read(input, &args.plan, &Silent)? else {
        return Err(Failure::file(
            &input.name,
            "a graph of the plane does not say where its cells \
             end: an eye needs a floorplan",
        ));
    };
    let eyes = EyePlan::new(&plan, &cells);
    let mut walk = Walk::new(&eyes, |_| ());
    let sights = match cull {
        PlanCull::Exact => None,
        _ => Some(Sights::of(&cells.graph)?),
    };
    let id = InputId::new(&input.file_name(), &input.bytes);
    let area = (&eyes.whole_area()).into();
    let lens = cone.as_ref().map(ViewCone::report);
    let mut report = EyePlanReport::new(id, cull.name(), lens, area);
    let grid = Rational::from(plan.grid.clone());
    for point in &points {
        let eye = PlanPoint::from_coordinates(&point.each_ref().map(|c| c * &grid));
        let refused =
            |error| Failure::file(&input.name, format!("({} {}): {error}", point[0], point[1]));
        let step = walk.step(eye, cone.as_ref()).map_err(refused)?;
        let place = walk.place().expect("a walk that has made a step is somewhere");
        let known = sights.as_ref().map(|sights| sights.of_cell(place.cell())).unwrap_or_default();
        let view = eyes.view(place, cone.as_ref());
        let mut view = view.report(cull, CellSight::Cells(&known), args.regions);
        view.step = args.path.is_some().then(|| eyes.report_step(&step));
        report.views.push(view);
    }
    files::print(&if args.json { report.to_json() } else { report.to_text() })?;
    Ok(Exit::Done)
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
        Failure::Input(_) | Failure::Interrupted => failure,
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

/// What each cell sees.
struct Sights(crate::report::Matrix);

impl Sights {
    fn of(graph: &PlanGraph) -> Result<Sights, Failure> {
        let groups = Groups::cells(graph.cells.len());
        let matrix = plan_matrix(graph, &graph.crossings(), &groups, &Silent);
        matrix.map(Sights).ok_or(Failure::Interrupted)
    }

    fn of_cell(&self, cell: CellId) -> Vec<CellId> {
        let sees = |&to: &usize| self.0.get(cell.0 as usize, to) == Verdict::Open;
        (0..self.0.size()).filter(sees).map(|to| CellId(to as u32)).collect()
    }
}
