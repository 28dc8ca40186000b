//! Reading and writing files: portal files into graphs, results to text and back.
//!
//! Inputs are generated, sizes doubling: a hall of rooms in a row, every portal a quad, a half of
//! the coordinates with six decimals.

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use stabline::num::Number;
use stabline::report::{InputId, Matrix, PairWitness, PvsReport, Verdict, WitnessLine};
use stabline::scene::{CellOrder, read_graph};
use std::fmt::Write;
use std::hint::black_box;

/// A PRT1 file of `portals` doors between rooms in a row, every sixth of them skew.
fn portal_file(portals: u32) -> String {
    let mut text = format!("PRT1\n{}\n{portals}\n", portals + 1);
    for door in 0..portals {
        let x = i64::from(door) * 48 - 40_000;
        let bump = f64::from(u32::from(door % 6 == 0)) * 0.000_001 + 0.142_857;
        let (low, high) = (door % 7, door % 11 + 64);
        let _ = writeln!(
            text,
            "4 {door} {} ({x} {low} -16.5 ) ({x} {high}.333333 -16.5 ) ({x} {high}.333333 {} ) \
             ({:.6} {low} 112 ) ",
            door + 1,
            112 + door % 3,
            if door % 6 == 0 { x as f64 + bump } else { x as f64 },
        );
    }
    text
}

/// A result of `cells` cells in which each sees the 2 x 32 nearest.
fn result(cells: usize) -> PvsReport {
    let mut matrix = Matrix::new(cells, Verdict::NotOpen);
    let mut witnesses = Vec::new();
    for from in 0..cells {
        matrix.set(from, from, Verdict::Open);
        for to in from + 1..(from + 33).min(cells) {
            matrix.set(from, to, Verdict::Open);
            matrix.set(to, from, Verdict::Open);
            let coordinate = |axis: usize| {
                Number::ratio(
                    (from * 1_000_003 + to * 17 + axis) as i128 - 700_000_000,
                    4096 - 2 * axis as i128,
                )
            };
            witnesses.push(PairWitness {
                from: from as u32,
                to: to as u32,
                portals: (from as u32..to as u32).collect(),
                line: WitnessLine::Space([[0, 1, 2], [3, 4, 5]].map(|axes| axes.map(coordinate))),
            });
        }
    }
    PvsReport {
        program: PvsReport::this_program(),
        input: InputId::new("bench.prt", b""),
        reading: String::new(),
        grazing_classified: false,
        cells: (0..cells).map(|cell| cell.to_string()).collect(),
        leaf_to_cell: (0..cells as u32).collect(),
        skew_portals: 0,
        matrix,
        witnesses,
    }
}

fn portal_files(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("portal file");
    for portals in [850, 1700, 3400] {
        let text = portal_file(portals);
        group.throughput(Throughput::Bytes(text.len() as u64));
        group.bench_with_input(BenchmarkId::new("read into a graph", portals), &text, |b, text| {
            b.iter(|| read_graph("bench.prt", black_box(text.as_bytes())).unwrap());
        });
        let graph = read_graph("bench.prt", text.as_bytes()).unwrap();
        group.bench_with_input(
            BenchmarkId::new("order of portals", portals),
            &graph,
            |b, graph| {
                b.iter(|| CellOrder::new(black_box(graph)));
            },
        );
    }
    group.finish();
}

fn results(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("result");
    for cells in [400, 800, 1600] {
        let report = result(cells);
        let mut text = Vec::new();
        report.write(&mut text).unwrap();
        group.throughput(Throughput::Bytes(text.len() as u64));
        group.bench_with_input(BenchmarkId::new("write", cells), &report, |b, report| {
            b.iter(|| report.write(&mut std::io::sink()).unwrap());
        });
        group.bench_with_input(BenchmarkId::new("read", cells), &text, |b, text| {
            b.iter(|| PvsReport::read(black_box(text)).unwrap());
        });
    }
    group.finish();
}

criterion_group!(benches, portal_files, results);
criterion_main!(benches);
