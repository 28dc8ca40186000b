//! `stabline eye`: what one point sees of a portal graph, a world or a floorplan.

mod plan;

use super::exit::{Exit, Failure};
use super::files::{self, Input};
use super::meshes::{self, Writer};
use super::numbers::{numbers, point};
use super::plan::{PlanArgs, is_plan};
use super::world::{self, WorldArgs};
use crate::construct::Polygon;
use crate::eye::{
    Cull, EyeGraph, EyeWorld, Frustum, Lens, LocateError, Query, WorldAnswer, half_tangent,
};
use crate::formats::mesh::{self, MeshGroup};
use crate::geom::RationalPoint3;
use crate::num::Rational;
use crate::report::{EyeReport, InputId, Silent};
use crate::scene::{self, CellId, PortalGraph, PortalId};
use num_traits::ToPrimitive;
use std::iter;
use std::path::{Path, PathBuf};

/// Compute what an eye sees: cells, the seen space or the seen parts of portals, objects
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    /// A portal graph, or geometry to be divided into cells
    input: PathBuf,
    /// Where the eye is: three decimals or ratios, two in a floorplan
    #[arg(long, value_name = "X,Y[,Z]", allow_hyphen_values = true)]
    #[arg(required_unless_present = "path", conflicts_with = "path")]
    at: Option<String>,
    /// Where the eye walks in a floorplan: points with spaces between them
    #[arg(long, value_name = "X,Y X,Y ...", allow_hyphen_values = true)]
    path: Option<String>,
    /// The direction of view; all around without
    #[arg(long, value_name = "X,Y[,Z]", allow_hyphen_values = true)]
    look: Option<String>,
    /// The direction that is up [default: 0,0,1]
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, requires = "look")]
    up: Option<String>,
    /// The tangents of half the horizontal and half the vertical angle of view; one in a floorplan
    #[arg(long, alias = "half-tangent", value_name = "H[,V]")]
    #[arg(requires = "look", conflicts_with = "fov")]
    half_tangents: Option<String>,
    /// The horizontal and the vertical angle of view in degrees; one in a floorplan
    #[arg(long, value_name = "H[,V]", requires = "look")]
    fov: Option<String>,
    /// How cells are ruled out
    #[arg(long, value_enum, value_name = "METHOD", default_value = "exact")]
    cull: Method,
    /// The cell that the eye is in, where the portals do not tell: its name, or its number
    #[arg(long, value_name = "C")]
    cell: Option<String>,
    /// Give what is seen: of each sequence's last portal, or of a level's or floorplan's cells
    #[arg(long, alias = "region")]
    regions: bool,
    /// Give the detail objects of a level that are seen
    #[arg(long)]
    objects: bool,
    /// Write what is seen as a binary glTF, one object a region, in the nearest single floats
    #[arg(long, value_name = "OUT.glb")]
    glb: Option<PathBuf>,
    /// Write what is seen as an OBJ, one object a region
    #[arg(long, value_name = "OUT.obj")]
    obj: Option<PathBuf>,
    #[command(flatten)]
    world: WorldArgs,
    #[command(flatten)]
    plan: PlanArgs,
    /// Print JSON (`stabline-eye/1`; of a floorplan `stabline-eye-plan/1`)
    #[arg(long)]
    json: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Method {
    /// The cells that are seen, decided exactly
    Exact,
    /// Clip the frustum in floats; never misses a cell (not in a floorplan)
    Float,
    /// Through portals in the frustum or cone, each judged alone
    Portals,
    /// All cells joined to the eye's by portals (not in a floorplan)
    Flood,
    /// In a floorplan: through cells that meet the cone
    Component,
    /// In a floorplan: cells that the eye's cell sees and that meet the cone
    Disjoint,
    /// In a floorplan: all cells that the eye's cell sees
    None,
}

impl Method {
    /// The cull of what is in space, and its name.
    fn cull(self) -> Result<(Cull, &'static str), Failure> {
        match self {
            Method::Exact => Ok((Cull::Exact, "exact")),
            Method::Float => Ok((Cull::Float, "float")),
            Method::Portals => Ok((Cull::Portals, "portals")),
            Method::Flood => Ok((Cull::Flood, "flood")),
            Method::Component | Method::Disjoint | Method::None => Err(Failure::usage(
                "--cull component, disjoint and none are for floorplans; in space there are \
                 exact, float, portals and flood",
            )),
        }
    }
}

impl Args {
    /// Whether what is seen is to be made out at all.
    fn needs_regions(&self) -> bool {
        self.regions || self.objects || self.glb.is_some() || self.obj.is_some()
    }
}

/// A report, and what is seen.
type Seen = (EyeReport, Vec<MeshGroup>);

pub(super) fn run(args: Args) -> Result<Exit, Failure> {
    args.world.refuse_hulls()?;
    let writes_to_stdout = files::check_outputs([&args.glb, &args.obj])?;
    let input = Input::read(&args.input)?;
    if is_plan(&input) {
        return plan::run(&args, &input);
    }
    let Some(at) = &args.at else {
        return Err(Failure::usage("--path is for floorplans"));
    };
    let eye = point("--at", at)?;
    let lens = lens(&args)?;
    if args.needs_regions() && args.cull != Method::Exact {
        let message = "--regions, --objects, --glb and --obj need the exact cull";
        return Err(Failure::usage(message));
    }
    let (report, mesh) = match world::is_world(&input) {
        true => of_world(&args, &input, &eye, lens.as_ref())?,
        false => of_graph(&args, &input, &eye, lens.as_ref())?,
    };
    if let Some(path) = &args.glb {
        write_mesh(path, &mesh, mesh::write_glb)?;
    }
    if let Some(path) = &args.obj {
        write_mesh(path, &mesh, mesh::write_obj)?;
    }
    if !writes_to_stdout {
        files::print(&if args.json { report.to_json() } else { report.to_text() })?;
    }
    Ok(Exit::Done)
}

fn write_mesh(path: &Path, groups: &[MeshGroup], write: Writer) -> Result<(), Failure> {
    let moved = meshes::write(path, groups, write)?;
    if moved != Rational::default() {
        let about = moved.to_f64().unwrap_or(f64::INFINITY);
        eprintln!("{}: coordinates moved by {about:.3e} at most", path.display());
    }
    Ok(())
}

fn of_graph(
    args: &Args,
    input: &Input,
    eye: &RationalPoint3,
    lens: Option<&Lens>,
) -> Result<Seen, Failure> {
    if args.objects {
        return Err(Failure::usage("--objects needs a level: a portal graph has none"));
    }
    let graph = scene::read_graph(&input.name, &input.bytes)?;
    let cell = args.cell.as_ref().map(|text| files::cell(&graph, &input.name, text)).transpose()?;
    let frustum = lens.map(|lens| &lens.frustum);
    let query = Query { eye, frustum, cell, regions: args.needs_regions() };
    let (cull, name) = args.cull.cull()?;
    let answer = EyeGraph::new(&graph).look(&query, cull).map_err(|error| match error {
        LocateError::Nowhere => Failure::file(&input.name, error),
        LocateError::Ambiguous { .. } => Failure::usage(format!("{error} with --cell")),
        LocateError::NotInCell { .. } => Failure::usage(error),
    })?;
    let id = InputId::new(&input.file_name(), &input.bytes);
    let report = answer.report(&graph, id, eye, lens, (name, args.regions));
    let groups = answer
        .regions
        .into_iter()
        .map(|region| group(&graph, region.cell, &region.portals, vec![region.polygon]));
    Ok((report, groups.collect()))
}

fn of_world(
    args: &Args,
    input: &Input,
    eye: &RationalPoint3,
    lens: Option<&Lens>,
) -> Result<Seen, Failure> {
    if args.cell.is_some() {
        return Err(Failure::usage("--cell is for portal graphs: a level's tree places every eye"));
    }
    let (world, cells) = world::divided(input, &args.world, &Silent)?;
    let frustum = lens.map(|lens| &lens.frustum);
    let query = Query { eye, frustum, cell: None, regions: args.needs_regions() };
    let (cull, name) = args.cull.cull()?;
    let WorldAnswer { answer, space } = EyeWorld::new(&world, &cells)
        .look(&query, cull)
        .map_err(|error| Failure::file(&input.name, error))?;
    let id = InputId::new(&input.file_name(), &input.bytes);
    let graph = &cells.graph;
    let mut report = answer.report(graph, id, eye, lens, (name, false));
    let Some(mut space) = space else { return Ok((report, Vec::new())) };
    report.space = args.regions.then(|| space.report(graph));
    if args.objects {
        let seen = space.objects(&world.objects);
        report.objects = Some(space.report_objects(graph, &world.objects, &seen));
    }
    let groups = space.regions.iter().map(|region| {
        let faces = region.polyhedron.faces().iter().map(Polygon::points).collect();
        group(graph, region.cell, &region.portals, faces)
    });
    Ok((report, groups.collect()))
}

/// What is seen of a cell through a sequence, by their names.
fn group(
    graph: &PortalGraph,
    cell: CellId,
    portals: &[PortalId],
    polygons: Vec<Vec<RationalPoint3>>,
) -> MeshGroup {
    let mut name = graph.cells[cell.0 as usize].clone();
    for (portal, word) in portals.iter().zip(iter::once(" through").chain(iter::repeat(""))) {
        name.push_str(&format!("{word} {}", graph.portals[portal.0 as usize].source));
    }
    MeshGroup { name, polygons }
}

fn lens(args: &Args) -> Result<Option<Lens>, Failure> {
    let Some(look) = &args.look else { return Ok(None) };
    let look = numbers("--look", look)?;
    let up = numbers("--up", args.up.as_deref().unwrap_or("0,0,1"))?;
    let half_tangents = match (&args.half_tangents, &args.fov) {
        (Some(text), _) => numbers("--half-tangents", text)?,
        (None, Some(text)) => {
            let [h, v] = numbers("--fov", text)?;
            let tangent =
                |angle| half_tangent(&angle).map_err(|e| Failure::usage(format!("--fov: {e}")));
            [tangent(h)?, tangent(v)?]
        }
        (None, None) => return Err(Failure::usage("--look needs --half-tangents or --fov")),
    };
    let frustum = Frustum::new(&look, &up, &half_tangents).map_err(Failure::usage)?;
    Ok(Some(Lens { look, up, half_tangents, frustum }))
}
