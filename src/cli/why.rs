//! `stabline why`: what joins two cells, or what blocks them.

mod plan;

use super::exit::{Exit, Failure};
use super::files::{self, Input};
use super::plan::PlanArgs;
use super::progress::{ProgressArgs, Watch};
use super::world::{self, WorldArgs};
use crate::num::Number;
use crate::pvs::{self, DeadEnd, DeadEnds, Explanation, Hindrance, Obstacle, OpenPair};
use crate::scene::{CellId, PortalGraph};
use std::path::PathBuf;

/// Show the portals and the sightline between two cells, or what blocks them
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    /// A portal graph, geometry to be divided into cells, a floorplan, or a Doom level (sectors)
    input: PathBuf,
    /// The cell to look from: its name, or its number
    #[arg(value_name = "A")]
    from: String,
    /// The cell to look at
    #[arg(value_name = "B")]
    to: String,
    #[command(flatten)]
    world: WorldArgs,
    #[command(flatten)]
    plan: PlanArgs,
    /// Print JSON
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    progress: ProgressArgs,
}

pub(super) fn run(args: Args) -> Result<Exit, Failure> {
    args.world.refuse_hulls()?;
    let input = Input::read(&args.input)?;
    if super::plan::is_plan(&input) {
        return plan::run(&args, &input);
    }
    let watch = Watch::new(args.progress.reporter(), None);
    let graph = world::read_graph(&input, &args.world, &watch)?;
    let [from, to] = [&args.from, &args.to].map(|text| files::cell(&graph, &input.name, text));
    let (from, to) = (from?, to?);
    let Some(explanation) = pvs::explain(&graph, from, to, &watch) else {
        return Ok(Exit::Interrupted);
    };
    drop(watch);
    let text = match args.json {
        true => format!("{:#}\n", as_json(&graph, from, to, &explanation)),
        false => as_text(&graph, from, to, &explanation),
    };
    files::print(&text)?;
    Ok(Exit::Done)
}

fn point(point: &[Number; 3]) -> String {
    let [x, y, z] = point;
    format!("({x} {y} {z})")
}

fn as_text(graph: &PortalGraph, from: CellId, to: CellId, explanation: &Explanation) -> String {
    let [a, b] = [from, to].map(|cell| &graph.cells[cell.0 as usize]);
    match explanation {
        Explanation::SameCell => format!("{a} sees itself: open\n"),
        Explanation::Open(OpenPair { portals, line, .. }) => {
            let [p, q] = line.numbers();
            format!(
                "{a} sees {b}: open\nportals   {}\nsightline {} -> {}\n",
                list(portals),
                point(&p),
                point(&q)
            )
        }
        Explanation::OutOfBound(Obstacle::NoWay) => {
            format!("{a} does not see {b}: not open\nno portals lead from {a} to {b}\n")
        }
        Explanation::OutOfBound(Obstacle::Shortest { portals, between, hindrance }) => format!(
            "{a} does not see {b}: not open\nno way from {a} to {b} on which each portal reaches \
             in front of those before it and the separating planes of neighbours\n\
             the shortest: portals {}: {}\n",
            list(portals),
            hindered(*between, *hindrance),
        ),
        Explanation::Refuted(ends) => format!(
            "{a} does not see {b}: not open\nevery portal sequence between them was refuted:\n\
             {:>8}  lead nowhere past the planes that separate their portals\n\
             {:>8}  have edges that exclude each other (Gordan)\n\
             {:>8}  were decided by their exact cones\n{}",
            ends.no_way,
            ends.excluded,
            ends.not_open,
            longest(ends),
        ),
    }
}

fn longest(ends: &DeadEnds) -> String {
    let Some((portals, why)) = &ends.longest else { return String::new() };
    let why = match why {
        DeadEnd::NoWay => "nothing behind it is in front of all separating planes",
        DeadEnd::Excluded => "its edges exclude each other",
        DeadEnd::NotOpen => "no line passes all of its portals",
    };
    format!("the longest: portals {}: {why}\n", list(portals))
}

fn hindered([earlier, later]: [u32; 2], hindrance: Hindrance) -> String {
    match hindrance {
        Hindrance::LaterBehind => {
            format!("no part of portal {later} is in front of portal {earlier}")
        }
        Hindrance::EarlierInFront => {
            format!("no part of portal {earlier} is behind portal {later}")
        }
        Hindrance::NothingBetween => format!(
            "portal {later} cannot follow portal {earlier}: what is between them is behind the \
             planes of portals or of pairs of portals on every way"
        ),
    }
}

fn list(portals: &[u32]) -> String {
    portals.iter().map(u32::to_string).collect::<Vec<_>>().join(" ")
}

fn as_json(
    graph: &PortalGraph,
    from: CellId,
    to: CellId,
    explanation: &Explanation,
) -> serde_json::Value {
    let name = |cell: CellId| &graph.cells[cell.0 as usize];
    let mut value = serde_json::json!({
        "format": "stabline-why/1",
        "from": from.0,
        "to": to.0,
        "names": [name(from), name(to)],
        "verdict": "open",
        "portals": null,
        "line": null,
        "refuted": null,
    });
    match explanation {
        Explanation::SameCell => value["portals"] = serde_json::json!([]),
        Explanation::Open(OpenPair { portals, line, .. }) => {
            let line = line.numbers().map(|point| point.map(|number| number.to_string()));
            value["portals"] = serde_json::json!(portals);
            value["line"] = serde_json::json!(line);
        }
        Explanation::OutOfBound(obstacle) => {
            value["verdict"] = "not open".into();
            value["refuted"] = match obstacle {
                Obstacle::NoWay => serde_json::json!({"by": "graph"}),
                Obstacle::Shortest { portals, between, hindrance } => serde_json::json!({
                    "by": "bound",
                    "shortest": portals,
                    "between": between,
                    "why": hindered(*between, *hindrance),
                }),
            };
        }
        Explanation::Refuted(ends) => {
            value["verdict"] = "not open".into();
            value["refuted"] = serde_json::json!({
                "by": "search",
                "no_way": ends.no_way,
                "excluded": ends.excluded,
                "not_open": ends.not_open,
                "longest": ends.longest.as_ref().map(|(portals, _)| portals),
            });
        }
    }
    value
}
