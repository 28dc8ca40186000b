//! The REJECT tables of Doom archives beside the exact answer, as Markdown: a table of all maps,
//! and for each hole, a pair of sectors that see each other though the table says no, a sightline.
//!
//! `cargo run --release --example freedoom_rejects -- freedoom1.wad freedoom2.wad`

#[path = "../tests/support/sightlines.rs"]
mod sightlines;

use sightlines::assert_joins;
use stabline::audit::check::{Policy, Presence, Score, check};
use stabline::formats::wad::{Archive, RejectTable};
use stabline::num::Number;
use stabline::portal::doom::DoomAreas;
use stabline::portal::plan::cells_of_plan;
use stabline::pvs::plan::{Cover, PlanSight, plan_sights};
use stabline::report::{Matrix, Silent};
use stabline::scene::plan::plan_of_map;
use stabline::subdivision::plan::{PlanMethod, divide};
use std::error::Error;
use std::time::Instant;

/// What is told of one map.
struct Row {
    map: String,
    sectors: usize,
    lines: usize,
    leaves: usize,
    open: u64,
    score: Option<Score>,
    oddities: String,
    seconds: f64,
    /// A line for each hole, from the sector of lower number.
    holes: Vec<PlanSight>,
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut rows = Vec::new();
    for path in std::env::args().skip(1) {
        let bytes = std::fs::read(&path).map_err(|error| format!("{path}: {error}"))?;
        let archive = Archive::read(&bytes).map_err(|error| format!("{path}: {error}"))?;
        for name in archive.maps() {
            rows.push(row(&archive, name).map_err(|error| format!("{path}: {error}"))?);
        }
    }
    if rows.is_empty() {
        return Err("expected archives of Doom, FILE.wad …, with maps in them".into());
    }
    print_table(&rows);
    print_holes(&rows);
    Ok(())
}

/// Computes the exact answer for a map and scores its table.
fn row(archive: &Archive<'_>, name: &str) -> Result<Row, Box<dyn Error>> {
    let started = Instant::now();
    let map = archive.map(name)?;
    let doom = plan_of_map(&map)?;
    let tree = divide(&doom.plan, &PlanMethod::default(), &Silent)?;
    let cells = cells_of_plan(&doom.plan, tree, false)?;
    let areas = DoomAreas::of(&doom, &cells);
    let leaves = 0..areas.of_leaf.len() as u32;
    let cover = Cover::new(doom.sectors, leaves.map(|leaf| areas.sectors_of_leaf(leaf)));
    let crossings = cells.graph.crossings();
    // Lines are asked for only where the table rejects a pair.
    let table = RejectTable::read(map.reject.as_deref().unwrap_or_default(), map.sectors).ok();
    let rejects = |from: u32, to: u32| {
        table.as_ref().is_some_and(|table| table.rejects(from as usize, to as usize))
    };
    let wants = |g: u32, h: u32| {
        let (from, to) = (cover.sets_of(g), cover.sets_of(h));
        from.iter().any(|&from| to.iter().any(|&to| rejects(from, to) || rejects(to, from)))
    };
    let found = plan_sights(&cells.graph, &crossings, cover.groups(), &wants, &Silent);
    let (matrix, sights) = found.ok_or("interrupted")?;
    let (matrix, sights) = (cover.matrix(matrix), cover.sights(&cells.graph, sights));
    let seconds = started.elapsed().as_secs_f64();
    let score = table.as_ref().map(|table| score(table, &matrix)).transpose()?;
    let is_hole = |sight: &&PlanSight| {
        let pair = [sight.from as usize, sight.to as usize];
        score.as_ref().is_some_and(|score| score.holes.binary_search(&pair).is_ok())
    };
    let holes: Vec<PlanSight> = sights.iter().filter(is_hole).cloned().collect();
    // Sectors that share an area see each other there; all others by a line that is checked again.
    for sight in holes.iter().filter(|sight| !sight.portals.is_empty()) {
        assert_joins(&map, &doom, &cells, &areas.unclosed(), sight);
    }
    let kinds = areas.oddities.chunk_by(|one, other| one.kind() == other.kind());
    let kinds: Vec<String> =
        kinds.map(|kind| format!("{} {}", kind.len(), kind[0].kind())).collect();
    Ok(Row {
        map: map.name,
        sectors: map.sectors,
        lines: map.linedefs.len(),
        leaves: cells.tree.leaves.len(),
        open: matrix.counts().open,
        score,
        oddities: kinds.join(", "),
        seconds,
        holes,
    })
}

/// Scores the table of a map.
fn score(table: &RejectTable, matrix: &Matrix) -> Result<Score, Box<dyn Error>> {
    let sectors = table.sectors();
    let pairs = (0..sectors).flat_map(|from| (0..sectors).map(move |to| (from, to)));
    let flags = pairs.map(|(from, to)| !table.rejects(from, to)).collect();
    let presence = Presence::from_flags(sectors, flags).ok_or("a square of flags")?;
    Ok(check(matrix, &presence, Policy::Open)?)
}

fn print_table(rows: &[Row]) {
    println!(
        "| map | sectors | lines | leaves | open pairs | holes | waste | oddities | seconds |"
    );
    println!("|---|--:|--:|--:|--:|--:|--:|---|--:|");
    let [mut holes, mut waste, mut maps] = [0; 3];
    for row in rows {
        let Row { map, sectors, lines, leaves, open, oddities, seconds, .. } = row;
        let counts = match &row.score {
            Some(score) => {
                holes += score.holes.len();
                waste += score.waste.len();
                maps += usize::from(!score.holes.is_empty() || !score.waste.is_empty());
                format!("{} | {}", score.holes.len(), score.waste.len())
            }
            None => "no table | ".to_owned(),
        };
        println!(
            "| {map} | {sectors} | {lines} | {leaves} | {open} | {counts} | {oddities} | {seconds:.2} |"
        );
    }
    let seconds: f64 = rows.iter().map(|row| row.seconds).sum();
    println!(
        "\n{} maps, {maps} of them with holes or waste: {holes} holes, {waste} pairs of waste",
        rows.len()
    );
    println!(
        "(ordered pairs of sectors); {seconds:.1} s in all, sightlines of the holes included."
    );
}

fn print_holes(rows: &[Row]) {
    println!(
        "\nHoles: pairs of sectors that the table keeps apart, and a line from the one to the"
    );
    println!("other that meets no wall between them. The reverse pairs are holes as well.\n");
    for row in rows {
        for PlanSight { from, to, line, .. } in &row.holes {
            let [p, q] = line.each_ref().map(|[x, y]| point(x, y));
            println!("- {}: {from} to {to}, from {p} towards {q}", row.map);
        }
    }
}

fn point(x: &Number, y: &Number) -> String {
    format!("({x}, {y})")
}
