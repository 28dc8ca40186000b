//! Witnesses and determinism on the public maps, which are not part of the project: skipped, with
//! a message, where absent.
//!
//! `STABLINE_MAPS=all` takes all six (default: the first).

mod support;

use stabline::pvs::{self, OpenPair, Options, Row, Shard};
use stabline::report::{Silent, Verdict};
use stabline::scene::{CellId, read_graph};
use support::{maps, witness};

/// What of the rows goes into a result. (How the work went depends on the threads.)
fn findings(rows: &[Row]) -> Vec<(CellId, &[OpenPair])> {
    rows.iter().map(|row| (row.source, row.open.as_slice())).collect()
}

#[test]
fn threads_and_shards_change_no_row_of_a_real_map() {
    let Some(maps) = maps() else { return };
    let graph = read_graph("map", &std::fs::read(maps.join("lq_e0m1/lq_e0m1.prt")).unwrap());
    let graph = graph.unwrap();
    let compute = |threads, shard| {
        let options = Options { shard, ..Options::default() };
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| pvs::compute(&graph, &options, Vec::new(), &|_| {}, &Silent)).rows
    };
    let whole = compute(1, Shard::default());
    for threads in [2, 3] {
        let rows = compute(threads, Shard::default());
        assert!(findings(&rows) == findings(&whole), "{threads} threads");
    }
    let mut parts: Vec<Row> =
        (0..3).flat_map(|index| compute(2, Shard { index, count: 3 })).collect();
    parts.sort_by_key(|row| row.source);
    assert!(findings(&parts) == findings(&whole), "three shards");
}

#[test]
fn every_witness_of_a_real_map_holds() {
    let Some(maps) = maps() else { return };
    let all = ["lq_e0m1", "lqdm1", "lqdm6", "lq_e1m2", "lq_e0m8", "lq_e1m5"];
    let wants_all = std::env::var("STABLINE_MAPS").is_ok_and(|which| which == "all");
    for map in &all[..if wants_all { all.len() } else { 1 }] {
        let bytes = std::fs::read(maps.join(map).join(format!("{map}.prt"))).unwrap();
        let graph = read_graph(map, &bytes).unwrap();
        let start = std::time::Instant::now();
        let finished = pvs::compute(&graph, &Options::default(), Vec::new(), &|_| {}, &Silent);
        let computed = start.elapsed();
        let matrix = pvs::assemble(&graph, &finished.rows);
        let witnesses = pvs::witnesses(&finished.rows);
        for found in &witnesses {
            if let Err(why) = witness::check(&graph, found) {
                panic!("{map}: {} -> {}: {why}", found.from, found.to);
            }
        }
        let counts = matrix.counts();
        assert_eq!(counts.undecided, 0, "{map}");
        let off_diagonal = counts.open - matrix.size() as u64;
        assert_eq!(2 * witnesses.len() as u64, off_diagonal, "{map}");
        let lengths = witnesses.iter().map(|found| found.portals.len());
        println!(
            "{map}: {} witnesses hold, up to {} portals long; computed in {computed:?}, checked \
             in {:?}",
            witnesses.len(),
            lengths.max().unwrap_or(0),
            start.elapsed() - computed,
        );
        assert!(matrix.entries().iter().all(|verdict| *verdict != Verdict::Grazing));
    }
}
