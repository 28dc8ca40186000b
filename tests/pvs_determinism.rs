//! The same bytes on any number of threads, in any number of parts, and after interruptions.

mod support;

use stabline::pvs::{self, Finished, Options, Part, PartHeader, Row, Shard};
use stabline::report::{InputId, Matrix, Progress, PvsReport, Silent, Verdict};
use stabline::scene::{PortalGraph, read_graph};
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering::SeqCst};
use support::graphs::{Family, Graph};
use support::{stabline, stderr};

fn on_threads(threads: usize, work: impl FnOnce() -> Finished + Send) -> Finished {
    rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap().install(work)
}

fn compute(graph: &PortalGraph, options: &Options, done: Vec<Row>) -> Finished {
    pvs::compute(graph, options, done, &|_| {}, &Silent)
}

/// The result's text.
fn text(graph: &PortalGraph, finished: &Finished) -> String {
    assert!(finished.is_complete);
    let report = PvsReport {
        program: PvsReport::this_program(),
        input: InputId::new("graph.prt", b""),
        reading: String::new(),
        grazing_classified: false,
        cells: graph.cells.clone(),
        leaf_to_cell: graph.leaf_to_cell.iter().map(|cell| cell.0).collect(),
        skew_portals: graph.skew_portals,
        matrix: pvs::assemble(graph, &finished.rows),
        witnesses: pvs::witnesses(&finished.rows),
    };
    let mut text = Vec::new();
    report.write(&mut text).unwrap();
    String::from_utf8(text).unwrap()
}

/// Graphs of every family, some of them large enough for the threads to meet.
fn graphs() -> Vec<(String, Graph)> {
    let seeds = Family::ALL.into_iter().flat_map(|family| (0..12).map(move |seed| (family, seed)));
    let named = |(family, seed)| (format!("{family:?} {seed}"), Graph::random(family, seed));
    let mut graphs: Vec<(String, Graph)> = seeds.map(named).collect();
    graphs.push(("houses in a row".to_owned(), houses(6)));
    graphs
}

/// Random groups of rooms, joined in a row by doors between their first rooms.
fn houses(count: u64) -> Graph {
    let mut all = Graph { cells: 0, portals: Vec::new() };
    for seed in 0..count {
        let shift = support::graphs::integer(100 * seed as i64);
        let mut house = Graph::random(Family::Rooms, 1000 + seed)
            .mapped(false, |p| [&p[0] + &shift, p[1].clone(), p[2].clone()]);
        for portal in &mut house.portals {
            portal.cells = portal.cells.map(|cell| cell + all.cells);
        }
        if all.cells > 0 {
            let mut door = house.portals[0].clone();
            let step = support::graphs::integer(50);
            door.polygon = door.polygon.iter().map(|p| p.each_ref().map(|c| c - &step)).collect();
            door.cells = [all.cells - 1, all.cells];
            all.portals.push(door);
        }
        all.portals.extend(house.portals);
        all.cells += house.cells;
    }
    all
}

#[test]
fn threads_and_repetition_change_no_byte() {
    for (name, graph) in graphs() {
        let graph = graph.validated();
        for budget in [None, Some(20)] {
            let options = Options { budget, ..Options::default() };
            let once = text(&graph, &on_threads(1, || compute(&graph, &options, Vec::new())));
            for threads in [1, 2, 3] {
                let again = on_threads(threads, || compute(&graph, &options, Vec::new()));
                assert_eq!(text(&graph, &again), once, "{name}, {threads} threads, {budget:?}");
            }
        }
    }
}

fn header() -> PartHeader {
    let program = PvsReport::this_program();
    PartHeader {
        program,
        input: InputId::new("graph.prt", b""),
        reading: String::new(),
        budget: None,
    }
}

/// Rows through the text of a part.
fn through_text(rows: &[Row], graph: &PortalGraph) -> Vec<Row> {
    let mut text = header().to_line().unwrap();
    rows.iter().for_each(|row| text.push_str(&row.to_line().unwrap()));
    // A row that was being written when the run was killed.
    text.push_str("{\"source\":0,\"open\":[{\"tar");
    Part::read(&text, graph).unwrap().rows
}

#[test]
fn shards_together_are_the_whole() {
    for (name, graph) in graphs() {
        let graph = graph.validated();
        let whole = text(&graph, &compute(&graph, &Options::default(), Vec::new()));
        for count in [2, 3, 50] {
            let mut rows = Vec::new();
            for index in 0..count {
                let shard = Shard { index, count };
                let part = compute(&graph, &Options { shard, ..Options::default() }, Vec::new());
                assert!(part.is_complete, "{name}");
                rows.extend(part.rows);
            }
            assert_eq!(rows.len(), graph.cells.len(), "{name}: each cell in one shard");
            let merged = compute(&graph, &Options::default(), through_text(&rows, &graph));
            assert_eq!(text(&graph, &merged), whole, "{name}, {count} shards");
        }
    }
}

/// Interrupts when it has been asked some number of times since the search began, or at once.
struct Impatient {
    asked: AtomicU64,
    patience: Option<u64>,
    searches: AtomicBool,
}

impl Progress for Impatient {
    fn begin(&self, stage: &str, _total: u64) {
        self.searches.store(stage == "cells", SeqCst);
    }
    fn advance(&self, _steps: u64) {}
    fn is_interrupted(&self) -> bool {
        match self.patience {
            None => true,
            Some(patience) => {
                self.searches.load(SeqCst) && self.asked.fetch_add(1, SeqCst) >= patience
            }
        }
    }
}

#[test]
fn interrupted_and_resumed_is_the_whole() {
    for (name, graph) in graphs() {
        let graph = graph.validated();
        let options = Options::default();
        let whole = text(&graph, &compute(&graph, &options, Vec::new()));
        let mut kept: Vec<Row> = Vec::new();
        let mut runs = 0;
        for patience in std::iter::once(None).chain((0..).map(Some)) {
            let new = Mutex::new(Vec::new());
            let keep = |row: &Row| new.lock().unwrap().push(row.clone());
            let searches = AtomicBool::new(false);
            let progress = Impatient { asked: AtomicU64::new(0), patience, searches };
            let done = through_text(&kept, &graph);
            let finished = on_threads(2, || pvs::compute(&graph, &options, done, &keep, &progress));
            runs += 1;
            kept.extend(new.into_inner().unwrap());
            assert_eq!(finished.rows.len(), kept.len(), "{name}: what is finished is kept");
            if finished.is_complete {
                assert_eq!(text(&graph, &finished), whole, "{name}");
                break;
            }
        }
        assert!(runs > 1, "{name} was never interrupted");
    }
}

#[test]
fn the_command_merges_shards_and_resumes() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    std::fs::write(at.join("g.prt"), houses(3).to_prt()).unwrap();
    let run = |arguments: &[&str]| {
        let output = stabline(at, arguments);
        assert!(output.status.success(), "{arguments:?}: {}", stderr(&output));
    };
    let read = |name: &str| std::fs::read(at.join(name)).unwrap();
    run(&["pvs", "g.prt", "-o", "whole.json", "--npy", "whole.npy", "--threads", "1"]);
    run(&["pvs", "g.prt", "-o", "two.json", "--npy", "two.npy", "--threads", "2"]);
    assert_eq!(read("two.json"), read("whole.json"));
    assert_eq!(read("two.npy"), read("whole.npy"));
    for shard in ["1/3", "2/3", "3/3"] {
        let part = format!("{}.part", &shard[..1]);
        run(&["pvs", "g.prt", "--shard", shard, "-o", &part]);
    }
    run(&["pvs", "g.prt", "--merge", "1.part", "2.part", "3.part", "-o", "merged.json"]);
    assert_eq!(read("merged.json"), read("whole.json"));
    // A folder with what one shard finished, the last line cut short.
    std::fs::create_dir(at.join("kept")).unwrap();
    let mut part = read("2.part");
    part.truncate(part.len() - 7);
    std::fs::write(at.join("kept/part-0000.jsonl"), part).unwrap();
    run(&["pvs", "g.prt", "--resume", "kept", "-o", "resumed.json"]);
    assert_eq!(read("resumed.json"), read("whole.json"));
    // Everything is kept now.
    run(&["pvs", "g.prt", "--resume", "kept", "-o", "again.json"]);
    assert_eq!(read("again.json"), read("whole.json"));
    let graph = read_graph("g.prt", &read("g.prt")).unwrap();
    assert_eq!(graph.portals, houses(3).validated().portals);
    let expected = pvs::assemble(&graph, &compute(&graph, &Options::default(), Vec::new()).rows);
    assert_eq!(read("whole.npy"), expected.to_npy());
    check_counts(&expected);
}

/// The rows of houses tell something: some pairs are open and some are not.
fn check_counts(matrix: &Matrix) {
    let counts = matrix.counts();
    assert!(counts.open > matrix.size() as u64 && counts.not_open > 0, "{counts:?}");
    assert!(!matrix.entries().contains(&Verdict::Undecided));
}
