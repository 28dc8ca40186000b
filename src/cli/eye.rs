//! `stabline eye`: what one point sees through the portals.

use super::exit::{Exit, Failure};
use super::files::{self, Input};
use super::world::{self, WorldArgs};
use crate::eye::{Cull, EyeGraph, Frustum, Lens, LocateError, Query, half_tangent};
use crate::geom::RationalPoint3;
use crate::num::{Int, Rational, parse_decimal};
use crate::report::InputId;
use num_integer::Integer;
use std::path::PathBuf;

/// Compute what an eye sees through the portals: cells, and the seen parts of portals
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    /// A portal graph, or geometry to be divided into cells
    input: PathBuf,
    /// Where the eye is: three decimals or ratios
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true)]
    at: String,
    /// The direction of view; all around without
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true)]
    look: Option<String>,
    /// The direction that is up [default: 0,0,1]
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, requires = "look")]
    up: Option<String>,
    /// The tangents of half the horizontal and half the vertical angle of view
    #[arg(long, value_name = "H,V", requires = "look", conflicts_with = "fov")]
    half_tangents: Option<String>,
    /// The horizontal and the vertical angle of view in degrees
    #[arg(long, value_name = "H,V", requires = "look")]
    fov: Option<String>,
    /// How cells are ruled out
    #[arg(long, value_enum, value_name = "METHOD", default_value = "exact")]
    cull: Method,
    /// The cell that the eye is in, where the portals do not tell: its name, or its number
    #[arg(long, value_name = "C")]
    cell: Option<String>,
    /// Give the seen part of each sequence's last portal
    #[arg(long)]
    regions: bool,
    #[command(flatten)]
    world: WorldArgs,
    /// Print JSON (`stabline-eye/1`)
    #[arg(long)]
    json: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Method {
    /// The cells that are seen, decided exactly
    Exact,
    /// Clip the frustum in floats; never misses a cell
    Float,
    /// Through portals before the eye and in the frustum, each judged alone
    Portals,
    /// All cells joined to the eye's by portals
    Flood,
}

impl Method {
    fn cull(self) -> (Cull, &'static str) {
        match self {
            Method::Exact => (Cull::Exact, "exact"),
            Method::Float => (Cull::Float, "float"),
            Method::Portals => (Cull::Portals, "portals"),
            Method::Flood => (Cull::Flood, "flood"),
        }
    }
}

pub(super) fn run(args: Args) -> Result<Exit, Failure> {
    let eye = point(&numbers("--at", &args.at)?);
    let lens = lens(&args)?;
    if args.regions && args.cull != Method::Exact {
        return Err(Failure::usage("--regions needs the exact cull"));
    }
    let input = Input::read(&args.input)?;
    let graph = world::read_graph(&input, args.world)?;
    let cell = args.cell.as_ref().map(|text| files::cell(&graph, &input.name, text)).transpose()?;
    let frustum = lens.as_ref().map(|lens| &lens.frustum);
    let query = Query { eye: &eye, frustum, cell, regions: args.regions };
    let (cull, name) = args.cull.cull();
    let answer = EyeGraph::new(&graph).look(&query, cull).map_err(|error| match error {
        LocateError::Nowhere => Failure::file(&input.name, error),
        LocateError::Ambiguous { .. } => Failure::usage(format!("{error} with --cell")),
        LocateError::NotInCell { .. } => Failure::usage(error),
    })?;
    let id = InputId::new(&input.file_name(), &input.bytes);
    let report = answer.report(&graph, id, &eye, lens.as_ref(), (name, args.regions));
    let text = if args.json { report.to_json() } else { report.to_text() };
    files::print(&text).map(|()| Exit::Done)
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

/// The `N` numbers of an option, read exactly.
fn numbers<const N: usize>(option: &str, text: &str) -> Result<[Rational; N], Failure> {
    let read = |part: &str| {
        parse_decimal(part.trim())
            .map_err(|error| Failure::usage(format!("{option}: `{part}`: {error}")))
    };
    let numbers = text.split(',').map(read).collect::<Result<Vec<_>, _>>()?;
    let count = numbers.len();
    numbers.try_into().map_err(|_| {
        Failure::usage(format!("{option}: expected {N} numbers between commas, got {count}"))
    })
}

fn point(coordinates: &[Rational; 3]) -> RationalPoint3 {
    let common = coordinates.iter().fold(Int::from(1), |c, x| c.lcm(x.denom()));
    let numerators = coordinates.each_ref().map(|c| c.numer() * (&common / c.denom()));
    RationalPoint3::new(numerators, common)
}
