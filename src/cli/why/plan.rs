//! `stabline why` on floorplans: the line around a vertex, or the shortest way and why no line
//! passes it.

use super::super::exit::{Exit, Failure};
use super::super::files::{self, Input};
use super::super::plan::{self, Planar};
use super::super::progress::Watch;
use super::{Args, list};
use crate::num::Number;
use crate::pvs::plan::{Cover, PlanSight, plan_sights};
use crate::scene::CellId;
use crate::scene::plan::{Crossing, Crossings, PlanGraph};
use std::collections::VecDeque;

/// What is true of a pair.
enum Answer {
    Same,
    Open(PlanSight),
    /// With the shortest chain of portals between the two, if there is any.
    NotOpen(Option<Vec<u32>>),
}

pub(super) fn run(args: &Args, input: &Input) -> Result<Exit, Failure> {
    let watch = Watch::new(args.progress.reporter(), None);
    let planar = plan::read(input, &args.plan, &watch)?;
    let Planar::Divided { cells, level, .. } = &planar else {
        return Err(Failure::usage(format!(
            "{}: the graph states no polygons of its cells; expected a floorplan",
            input.name
        )));
    };
    let graph = &cells.graph;
    let (cover, names) = match level {
        Some(level) => (level.cover(), (0..level.sectors).map(|s| s.to_string()).collect()),
        None => (Cover::cells(graph.cells.len()), graph.cells.clone()),
    };
    let number = |text: &str| number_of(&names, &input.name, text);
    let (from, to) = (number(&args.from)?, number(&args.to)?);
    let crossings = graph.crossings();
    let answer = if from == to {
        Answer::Same
    } else {
        let pair = [from.min(to), from.max(to)];
        let is_wanted = |g, h| cover.tells_of([g, h], pair);
        let found = plan_sights(graph, &crossings, cover.groups(), &is_wanted, &watch);
        let Some((_, sights)) = found else { return Ok(Exit::Interrupted) };
        let sights = cover.sights(graph, sights);
        match sights.into_iter().find(|sight| [sight.from, sight.to] == pair) {
            Some(sight) => Answer::Open(turned(sight, from)),
            None => Answer::NotOpen(shortest(graph, &crossings, &cover, from, to)),
        }
    };
    drop(watch);
    let [a, b] = [from, to].map(|cell| names[cell as usize].as_str());
    let text = match args.json {
        true => format!("{:#}\n", as_json([from, to], [a, b], &answer)),
        false => as_text(a, b, &answer),
    };
    files::print(&text)?;
    Ok(Exit::Done)
}

fn number_of(names: &[String], file: &str, text: &str) -> Result<u32, Failure> {
    match names.iter().position(|name| name == text) {
        Some(index) => Ok(index as u32),
        None => Err(Failure::usage(format!(
            "no cell {text:?} in {file}, expected a number below {}",
            names.len()
        ))),
    }
}

/// The sight in the direction from `from`.
fn turned(mut sight: PlanSight, from: u32) -> PlanSight {
    if sight.from != from {
        std::mem::swap(&mut sight.from, &mut sight.to);
        sight.portals.reverse();
        sight.line.reverse();
    }
    sight
}

/// The fewest portals from a cell of `from` to a cell of `to`.
fn shortest(
    graph: &PlanGraph,
    crossings: &Crossings,
    cover: &Cover,
    from: u32,
    to: u32,
) -> Option<Vec<u32>> {
    let holds = |cell: CellId, set: u32| {
        cover.groups().of(cell).is_some_and(|group| cover.tells_of([group; 2], [set; 2]))
    };
    let cells = (0..graph.cells.len() as u32).map(CellId);
    let mut queue: VecDeque<CellId> = cells.filter(|&cell| holds(cell, from)).collect();
    let mut way_to: Vec<Option<(CellId, Crossing)>> = vec![None; graph.cells.len()];
    let mut reached = vec![false; graph.cells.len()];
    queue.iter().for_each(|cell| reached[cell.0 as usize] = true);
    while let Some(cell) = queue.pop_front() {
        if holds(cell, to) {
            let mut portals = Vec::new();
            let mut at = cell;
            while let Some((before, way)) = way_to[at.0 as usize] {
                portals.push(way.portal);
                at = before;
            }
            portals.reverse();
            return Some(portals);
        }
        for way in crossings.from(cell) {
            if !std::mem::replace(&mut reached[way.to.0 as usize], true) {
                way_to[way.to.0 as usize] = Some((cell, *way));
                queue.push_back(way.to);
            }
        }
    }
    None
}

fn point([x, y]: &[Number; 2]) -> String {
    format!("({x} {y})")
}

fn as_text(a: &str, b: &str, answer: &Answer) -> String {
    match answer {
        Answer::Same => format!("{a} sees itself: open\n"),
        Answer::Open(PlanSight { portals, line: [p, q], .. }) => format!(
            "{a} sees {b}: open\nportals   {}\nsightline {} -> {}\n",
            list(portals),
            point(p),
            point(q)
        ),
        Answer::NotOpen(None) => {
            format!("{a} does not see {b}: not open\nno portals lead from {a} to {b}\n")
        }
        Answer::NotOpen(Some(portals)) => format!(
            "{a} does not see {b}: not open\nno line past any vertex joins them\n\
             the shortest way: portals {}\n",
            list(portals)
        ),
    }
}

fn as_json(pair: [u32; 2], names: [&str; 2], answer: &Answer) -> serde_json::Value {
    let mut value = serde_json::json!({
        "format": "stabline-why/1",
        "from": pair[0],
        "to": pair[1],
        "names": names,
        "verdict": "open",
        "portals": null,
        "line": null,
        "refuted": null,
    });
    match answer {
        Answer::Same => value["portals"] = serde_json::json!([]),
        Answer::Open(PlanSight { portals, line, .. }) => {
            let line = line.each_ref().map(|point| point.each_ref().map(Number::to_string));
            value["portals"] = serde_json::json!(portals);
            value["line"] = serde_json::json!(line);
        }
        Answer::NotOpen(shortest) => {
            value["verdict"] = "not open".into();
            value["refuted"] = match shortest {
                None => serde_json::json!({"by": "graph"}),
                Some(portals) => serde_json::json!({"by": "sweep", "shortest": portals}),
            };
        }
    }
    value
}
