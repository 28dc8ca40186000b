//! What `stabline pvs` tells of a result and of how it came about.

use super::super::plan::Planar;
use super::Args;
use crate::pvs::Finished;
use crate::report::{ObjectsReport, PvsReport};
use crate::scene::{CellOrder, PortalGraph};
use std::io::Write;
use std::time::{Duration, Instant};

/// The time that each stage took.
pub(super) struct Clock {
    started: Instant,
    last: Instant,
    laps: Vec<(&'static str, Duration)>,
}

impl Clock {
    pub(super) fn start() -> Clock {
        let now = Instant::now();
        Clock { started: now, last: now, laps: Vec::new() }
    }

    /// Ends the stage `name`.
    pub(super) fn lap(&mut self, name: &'static str) {
        let now = Instant::now();
        self.laps.push((name, now - self.last));
        self.last = now;
    }
}

/// The summary of a result, as text or as JSON.
pub(super) fn summary(
    graph: &PortalGraph,
    report: &PvsReport,
    objects: Option<&ObjectsReport>,
    finished: &Finished,
    args: &Args,
) -> String {
    let order = CellOrder::new(graph);
    let cells = graph.cells.len() as u64;
    if args.json {
        let shape =
            [graph.portals.len(), graph.skew_portals as usize, order.nonconvex_cells as usize];
        let mut value = common_json(report, shape);
        value["not_open_by_bound"] = (2 * finished.settled_by_bound).into();
        if let Some(objects) = objects {
            value["objects"] = serde_json::json!(objects.counts());
        }
        return format!("{value:#}\n");
    }
    let mut text = format!(
        "{}: {cells} cells, {} portals ({} of the input not planar), {} cells not exactly convex\n",
        report.input.name,
        graph.portals.len(),
        graph.skew_portals,
        order.nonconvex_cells,
    );
    text += &verdicts(report);
    if args.world.division.is_conservative() {
        text += "portals are hulls that may run across occluders: open pairs are an upper bound\n";
    }
    text + &objects.map(super::objects::summary).unwrap_or_default()
}

/// The summary of a floorplan's result, as text or as JSON.
pub(super) fn plan_summary(
    planar: &Planar,
    report: &PvsReport,
    objects: Option<&ObjectsReport>,
    as_json: bool,
) -> String {
    let graph = planar.graph();
    let cells = report.cells.len() as u64;
    if as_json {
        let mut value = common_json(report, [graph.portals.len(), 0, 0]);
        if let Some(level) = planar.level() {
            value["leaves"] = graph.cells.len().into();
            value["oddities"] = level.oddities_as_json();
        }
        if let Some(objects) = objects {
            value["objects"] = serde_json::json!(objects.counts());
        }
        return format!("{value:#}\n");
    }
    let mut text = format!(
        "{}: {cells} cells, {} portals, in the plane\n",
        report.input.name,
        graph.portals.len(),
    );
    if let Some(level) = planar.level() {
        text += &format!("{} sectors in {} leaves\n", level.sectors, graph.cells.len());
    }
    text += &verdicts(report);
    text + &objects.map(super::objects::summary).unwrap_or_default()
}

/// What every summary states, with the counts of portals, of those that are not planar, and of
/// cells that are not exactly convex.
fn common_json(
    report: &PvsReport,
    [portals, skew_portals, nonconvex_cells]: [usize; 3],
) -> serde_json::Value {
    let counts = report.matrix.counts();
    serde_json::json!({
        "format": "stabline-pvs-summary/1",
        "input": {"name": report.input.name, "blake3": report.input.blake3},
        "reading": report.reading,
        "cells": report.cells.len(),
        "portals": portals,
        "skew_portals": skew_portals,
        "nonconvex_cells": nonconvex_cells,
        "counts": {
            "open": counts.open,
            "not_open": counts.not_open,
            "grazing": report.grazing_classified.then_some(counts.grazing),
            "undecided": counts.undecided,
            "diagonal_included": true,
        },
    })
}

/// How many pairs have each verdict, one a line.
fn verdicts(report: &PvsReport) -> String {
    let counts = report.matrix.counts();
    let cells = report.cells.len() as u64;
    let percent = |count: u64| 100.0 * count as f64 / (cells * cells).max(1) as f64;
    let mut text = format!("open       {:>10}  {:5.1} %\n", counts.open, percent(counts.open));
    if report.grazing_classified {
        text += &format!("grazing    {:>10}  {:5.1} %\n", counts.grazing, percent(counts.grazing));
    }
    let rest = if report.grazing_classified { "blocked " } else { "not open" };
    text += &format!("{rest}   {:>10}  {:5.1} %\n", counts.not_open, percent(counts.not_open));
    if counts.undecided > 0 {
        let (undecided, share) = (counts.undecided, percent(counts.undecided));
        text += &format!("undecided  {undecided:>10}  {share:5.1} %\n");
    }
    text + "ordered pairs of cells, each cell with itself included; every open pair has an exact \
            sightline\n"
}

/// Prints to standard error.
pub(super) fn tell(text: &str) {
    // Nothing is left to be told if standard error is closed.
    let _ = std::io::stderr().write_all(text.as_bytes());
}

/// Prints times and peak memory.
pub(super) fn print_times(clock: &Clock) {
    tell(&(times(clock) + &memory()));
}

/// Prints times, peak memory and how pairs were settled.
pub(super) fn print_stats(clock: &Clock, graph: &PortalGraph, finished: &Finished) {
    let tally = &finished.tally;
    let mut text = times(clock);
    text += &format!(
        "pairs of different cells: {} not open by the bound, {} not open by search, \
         {} open by a known line, {} open by a line proposed, {} open by an exact cone\n",
        finished.settled_by_bound, tally.refuted, tally.inherited, tally.proposed, tally.cone_open,
    );
    text += &format!(
        "portal sequences: {} visited, {} excluded by their edges, {} exact cones; {} portals\n",
        tally.visited,
        tally.excluded,
        tally.cones,
        graph.portals.len(),
    );
    text += &memory();
    // Nothing is left to be told if standard error is closed.
    let _ = std::io::stderr().write_all(text.as_bytes());
}

/// The time of each stage, on one line.
fn times(clock: &Clock) -> String {
    let total = clock.started.elapsed().as_secs_f64();
    let mut text = format!("total {total:.3} s");
    for (name, time) in &clock.laps {
        let seconds = time.as_secs_f64();
        text += &format!(", {name} {seconds:.3} s ({:.0} %)", 100.0 * seconds / total);
    }
    text + "\n"
}

fn memory() -> String {
    match peak_memory() {
        Some(peak) => format!("peak memory: {:.1} MiB\n", peak as f64 / f64::from(1 << 20)),
        None => String::new(),
    }
}

/// The most memory that was in use at a time, in bytes, where the system tells.
fn peak_memory() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kibibytes: u64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(kibibytes << 10)
}
