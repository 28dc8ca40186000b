//! Eyes in real levels, where the shared maps are at hand: the culls never miss a cell. Prints how
//! many queries a second each cull answers, and how many cells it has too many.
//!
//! By default a few eyes look into one level's source; with `STABLINE_EYES=300` in the environment,
//! `cargo test --test eye_real -- --nocapture` has that many look into all of them.

mod support;

use stabline::construct::Polygon;
use stabline::eye::{Answer, Cull, EyeGraph, EyeWorld, Frustum, LocateError, Query};
use stabline::geom::RationalPoint3;
use stabline::num::{Int, Rational};
use stabline::oracle::Random;
use stabline::portal::{WorldCells, cells_of_world};
use stabline::scene::{CellId, LevelOptions, PortalGraph, World, read_graph, read_level};
use stabline::subdivision::Options;
use std::time::Instant;
use support::maps;

/// The mean of the vertices of a cell's portals, to a sixteenth, as an editor would put it.
fn inside(graph: &PortalGraph, cell: CellId) -> Option<RationalPoint3> {
    let near = graph.portals.iter().filter(|p| p.from == cell || p.to == cell);
    let vertices: Vec<_> = near
        .flat_map(|portal| &portal.vertices)
        .map(|&vertex| &graph.vertices[vertex as usize])
        .collect();
    let count = Int::from(vertices.len());
    let sixteenths = |v: &RationalPoint3, i: usize| &v.numerators()[i] * 16 / v.denominator();
    let mean = |i: usize| vertices.iter().map(|v| sixteenths(v, i)).sum::<Int>() / &count;
    (!vertices.is_empty()).then(|| RationalPoint3::new([0, 1, 2].map(mean), Int::from(16)))
}

#[test]
fn eyes_in_a_real_level() {
    let Some(maps) = maps() else { return };
    let bytes = std::fs::read(maps.join("lq_e1m2/lq_e1m2.prt")).unwrap();
    let graph = read_graph("lq_e1m2.prt", &bytes).unwrap();
    let eyes = EyeGraph::new(&graph);
    let cells = (0..graph.cells.len() as u32).step_by(3).map(CellId);
    let places: Vec<_> = cells.filter_map(|cell| Some((cell, inside(&graph, cell)?))).collect();
    let run = |cull: Cull| -> Vec<Option<Answer>> {
        let start = Instant::now();
        let look = |(cell, eye): &(CellId, RationalPoint3)| {
            let query = Query { eye, frustum: None, cell: Some(*cell), regions: false };
            match eyes.look(&query, cull) {
                Ok(answer) => Some(answer),
                Err(LocateError::NotInCell { .. }) => None,
                Err(error) => panic!("{cell:?}: {error}"),
            }
        };
        let answers: Vec<_> = places.iter().map(look).collect();
        let found = answers.iter().flatten();
        let (cells, sequences) = found.fold((0, 0), |(cells, sequences), answer| {
            (cells + answer.cells.len(), sequences + answer.sequences)
        });
        let rate = places.len() as f64 / start.elapsed().as_secs_f64();
        println!("{cull:?}: {rate:.0} queries/s, {cells} cells, {sequences} sequences");
        answers
    };
    let exact = run(Cull::Exact);
    let refused = exact.iter().filter(|answer| answer.is_none()).count();
    println!("{} eyes, {refused} not in their cell", places.len());
    for cull in [Cull::Float, Cull::Portals, Cull::Flood] {
        for (one, other) in exact.iter().zip(run(cull)) {
            let (Some(one), Some(other)) = (one, other) else { continue };
            let reached = |cell| other.cells.iter().any(|reached| reached.cell == cell);
            assert!(one.cells.iter().all(|seen| reached(seen.cell)), "{cull:?}");
        }
    }
    assert!(refused * 10 < places.len(), "{refused} eyes are not in their cell");
}

/// A point inside a cell: a mean of its vertices with random weights, to a sixteenth if that is
/// inside the cell as well.
fn random_eye(random: &mut Random, cells: &WorldCells) -> RationalPoint3 {
    let leaf = cells.leaves[random.between(0, cells.leaves.len() as i64 - 1) as usize];
    let faces = cells.subdivision.leaf(leaf).cell.faces();
    let (mut sum, mut weight) = ([0; 3].map(|_| Rational::from(Int::ZERO)), Int::ZERO);
    for vertex in faces.iter().flat_map(Polygon::points) {
        let (share, vertex) = (Int::from(random.between(1, 9)), vertex.coordinates());
        sum = [0, 1, 2].map(|i| &sum[i] + &vertex[i] * &share);
        weight += share;
    }
    let mean = sum.map(|c| c / &weight);
    let rounded = mean.each_ref().map(|c| (c * Int::from(16)).floor() / Int::from(16));
    let rounded = RationalPoint3::from(&rounded);
    if cells.subdivision.locate(&rounded) == [leaf] { rounded } else { RationalPoint3::from(&mean) }
}

/// A right angle wide, towards one of twelve sides.
fn random_frustum(random: &mut Random) -> Frustum {
    let integer = |c: i64| Rational::from(Int::from(c));
    let look = loop {
        let look = [random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)];
        if look[..2] != [0, 0] {
            break look.map(integer);
        }
    };
    Frustum::new(&look, &[0, 0, 1].map(integer), &[integer(1), Rational::new(3.into(), 4.into())])
        .unwrap()
}

/// Eyes with and without frusta in one level.
fn eyes_in(name: &str, world: &World, count: usize) {
    let cells = cells_of_world(world, &Options::default()).unwrap();
    let eyes = EyeWorld::new(world, &cells);
    let mut random = Random::new(5);
    let places: Vec<_> = (0..count).map(|_| random_eye(&mut random, &cells)).collect();
    let frusta: Vec<_> = (0..count).map(|_| random_frustum(&mut random)).collect();
    for (what, with_frustum) in [("around", false), ("right angle", true)] {
        let run = |cull: Cull| -> Vec<Vec<CellId>> {
            let start = Instant::now();
            let look = |(eye, frustum): (&RationalPoint3, &Frustum)| {
                let frustum = with_frustum.then_some(frustum);
                let query = Query { eye, frustum, cell: None, regions: false };
                let answer = eyes.look(&query, cull).unwrap().answer;
                (answer.sequences, answer.cells.iter().map(|reached| reached.cell).collect())
            };
            let answers: Vec<(u64, Vec<_>)> = places.iter().zip(&frusta).map(look).collect();
            let rate = count as f64 / start.elapsed().as_secs_f64();
            let sequences: u64 = answers.iter().map(|answer| answer.0).sum();
            let answers: Vec<_> = answers.into_iter().map(|answer| answer.1).collect();
            let reached: usize = answers.iter().map(Vec::len).sum();
            println!(
                "{name}, {what}: {cull:?}: {rate:.0} queries/s, {reached} cells, {sequences} sequences"
            );
            answers
        };
        let exact = run(Cull::Exact);
        for cull in [Cull::Float, Cull::Portals, Cull::Flood] {
            for (one, other) in exact.iter().zip(run(cull)) {
                assert!(one.iter().all(|cell| other.contains(cell)), "{name}: {cull:?}");
            }
        }
    }
}

#[test]
fn eyes_in_real_sources() {
    let Some(maps) = maps() else { return };
    let count = std::env::var("STABLINE_EYES").ok().and_then(|n| n.parse().ok());
    let all = ["lq_e0m1", "lqdm1", "lqdm6", "lq_e1m2", "lq_e0m8", "lq_e1m5"];
    for name in &all[..if count.is_some() { all.len() } else { 1 }] {
        let bytes = std::fs::read(maps.join(name).join(format!("{name}.map"))).unwrap();
        let level = read_level(name, &bytes, LevelOptions::default()).unwrap();
        eyes_in(name, &World::of_level(&level), count.unwrap_or(20));
    }
}
