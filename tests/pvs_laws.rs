//! What must not change the matrix, and what may change it in one direction only.
//!
//! `STABLINE_GRAPHS=N` sets the number of graphs a family (default 15).

mod support;

use num_traits::Zero;
use stabline::num::{Rational, parse_decimal};
use stabline::oracle::Random;
use stabline::pvs::{self, Options};
use stabline::report::{Matrix, Silent, Verdict};
use support::graphs::{Family, Graph, integer};

fn cases() -> impl Iterator<Item = (String, Graph, Random)> {
    let count = std::env::var("STABLINE_GRAPHS").ok().and_then(|n| n.parse().ok()).unwrap_or(15);
    Family::ALL.into_iter().flat_map(move |family| {
        (0..count).map(move |seed: u64| {
            let name = format!("{family:?} {seed}");
            (name, Graph::random(family, 5000 + seed), Random::new(seed))
        })
    })
}

fn matrix_with(graph: &Graph, options: &Options) -> Matrix {
    let graph = graph.validated();
    let finished = pvs::compute(&graph, options, Vec::new(), &|_| {}, &Silent);
    pvs::assemble(&graph, &finished.rows)
}

fn matrix(graph: &Graph) -> Matrix {
    matrix_with(graph, &Options::default())
}

fn shuffled(random: &mut Random, count: usize) -> Vec<usize> {
    let mut order: Vec<usize> = (0..count).collect();
    for i in (1..count).rev() {
        order.swap(i, random.between(0, i as i64) as usize);
    }
    order
}

#[test]
fn names_and_places_of_cells_and_portals_do_not_matter() {
    for (name, graph, mut random) in cases() {
        let expected = matrix(&graph);
        let numbers = shuffled(&mut random, graph.cells as usize);
        let portals = shuffled(&mut random, graph.portals.len());
        let mut other = graph.clone();
        other.portals = portals.iter().map(|&i| graph.portals[i].clone()).collect();
        for portal in &mut other.portals {
            portal.cells = portal.cells.map(|cell| numbers[cell as usize] as u32);
        }
        let permuted = matrix(&other);
        for a in 0..numbers.len() {
            for b in 0..numbers.len() {
                let found = permuted.get(numbers[a], numbers[b]);
                assert_eq!(found, expected.get(a, b), "{name}: {a} -> {b}");
            }
        }
    }
}

#[test]
fn the_direction_in_which_a_portal_is_written_does_not_matter() {
    for (name, graph, mut random) in cases() {
        let mut other = graph.clone();
        for portal in &mut other.portals {
            if random.one_in(2) {
                // A fan has its apex at the first vertex; skew polygons stay the same sets so.
                portal.polygon[1..].reverse();
                portal.cells.reverse();
            }
        }
        assert_eq!(matrix(&other), matrix(&graph), "{name}");
    }
}

#[test]
fn similarities_do_not_matter() {
    let decimal = |text: &str| parse_decimal(text).unwrap();
    for (name, graph, mut random) in cases() {
        let expected = matrix(&graph);
        let place = [(); 3].map(|()| integer(random.between(-9999, 9999)));
        let moved = graph.scaled(&integer(1), &place);
        assert_eq!(matrix(&moved), expected, "{name} moved to {place:?}");
        let axis = random.between(0, 2) as usize;
        let mirrored = graph.mapped(true, |p| {
            let mut p = p.clone();
            p[axis] = -&p[axis];
            p
        });
        // (A mirrored fan from the last vertex would be another set of triangles.)
        if graph.validated().skew_portals == 0 {
            assert_eq!(matrix(&mirrored), expected, "{name} mirrored");
        }
        let turned = graph.mapped(false, |[x, y, z]| [y.clone(), z.clone(), x.clone()]);
        if graph.validated().skew_portals == 0 {
            assert_eq!(matrix(&turned), expected, "{name} turned");
        }
        for scale in ["0.0254", "1/3", "39.37007874", "64"] {
            let none = [(); 3].map(|()| Rational::zero());
            let scaled = graph.scaled(&decimal(scale), &none);
            assert_eq!(matrix(&scaled), expected, "{name} scaled by {scale}");
        }
    }
}

#[test]
fn small_scenes_get_their_lines_from_floats_too() {
    for scale in ["1/1000", "0.0254", "1", "1000"] {
        let mut tally = pvs::Tally::default();
        for seed in 0..20 {
            let none = [(); 3].map(|()| Rational::zero());
            let graph = Graph::random(Family::Rooms, seed);
            let graph = graph.scaled(&parse_decimal(scale).unwrap(), &none).validated();
            let options = Options::default();
            let finished = pvs::compute(&graph, &options, Vec::new(), &|_| {}, &Silent);
            tally.add(&finished.tally);
        }
        println!("scaled by {scale}: {tally:?}");
        assert!(tally.cone_open * 10 < tally.proposed, "scaled by {scale}: {tally:?}");
    }
}

#[test]
fn removing_a_portal_opens_nothing() {
    for (name, graph, mut random) in cases() {
        if graph.portals.is_empty() {
            continue;
        }
        let mut fewer = graph.clone();
        let removed = random.between(0, graph.portals.len() as i64 - 1) as usize;
        fewer.portals.remove(removed);
        let (all, fewer) = (matrix(&graph), matrix(&fewer));
        for (pair, (with, without)) in all.entries().iter().zip(fewer.entries()).enumerate() {
            let opened = *with == Verdict::NotOpen && *without == Verdict::Open;
            assert!(!opened, "{name} without portal {removed}: entry {pair}");
        }
    }
}

#[test]
fn a_budget_bounds_the_truth() {
    let mut undecided = 0;
    for (name, graph, _) in cases() {
        let truth = matrix(&graph);
        for budget in [0, 1, 2, 5, 12, 30] {
            let options = Options { budget: Some(budget), ..Options::default() };
            let bounded = matrix_with(&graph, &options);
            assert_eq!(bounded.asymmetric_pairs(), 0, "{name}");
            for (pair, (&found, &expected)) in
                bounded.entries().iter().zip(truth.entries()).enumerate()
            {
                undecided += u32::from(found == Verdict::Undecided);
                let agrees = found == expected || found == Verdict::Undecided;
                assert!(agrees, "{name} with budget {budget}: entry {pair}");
            }
        }
        let options = Options { budget: Some(1 << 40), ..Options::default() };
        assert_eq!(matrix_with(&graph, &options), truth, "{name} with a budget that suffices");
    }
    assert!(undecided > 0, "no budget was ever used up");
}

#[test]
fn filters_do_not_matter() {
    for (name, graph, _) in cases() {
        let options = Options { without_filters: true, ..Options::default() };
        assert_eq!(matrix_with(&graph, &options), matrix(&graph), "{name}");
    }
}
