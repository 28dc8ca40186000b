//! The engine against its brute-force twins on arbitrary small input, which proptest shrinks; the
//! forge makes the input that is degenerate on purpose.

mod support;

use proptest::prelude::*;
use stabline::forge::{Door, Fault, Graph, Input, accepts, find, portal_graph, pvs_of, twin};
use stabline::num::Rational;
use stabline::report::Verdict;
use support::graphs::integer;

/// A point with small coordinates.
fn point<const D: usize>() -> impl Strategy<Value = [i64; D]> {
    prop::array::uniform(-4i64..=4)
}

/// So many points.
fn points<const D: usize, const N: usize>() -> impl Strategy<Value = [[i64; D]; N]> {
    prop::array::uniform(point::<D>())
}

fn rationals<const D: usize, const N: usize>(points: &[[i64; D]; N]) -> Vec<Vec<Rational>> {
    points.iter().map(|point| point.iter().map(|&c| integer(c)).collect()).collect()
}

fn door<const D: usize, const N: usize>(from: usize, to: usize, ends: &[[i64; D]; N]) -> Door {
    Door { cells: [from, to], polygon: rationals(ends) }
}

fn failed(fault: Fault) -> TestCaseError {
    TestCaseError::fail(fault.to_string())
}

/// That the engine, its evidence held, says what the twin says, of input that breaks no rule.
fn agree(input: &Input) -> Result<(), TestCaseError> {
    prop_assume!(accepts(input));
    let found = find(input).map_err(failed)?;
    prop_assert_eq!(Some(found.answer), twin::answer(input).map_err(failed)?);
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: std::env::var("STABLINE_CASES").ok().and_then(|n| n.parse().ok()).unwrap_or(500),
        failure_persistence: None,
        max_global_rejects: u32::MAX,
        ..ProptestConfig::default()
    })]

    #[test]
    fn triangles_in_sequence(triangles in prop::collection::vec(points::<3, 3>(), 1..4)) {
        agree(&Input::Sequence(triangles.iter().map(rationals).collect()))?;
    }

    #[test]
    fn gates_in_the_plane(segments in prop::collection::vec(points::<2, 2>(), 1..7)) {
        agree(&Input::Sequence(segments.iter().map(rationals).collect()))?;
    }

    #[test]
    fn four_lines(lines in prop::array::uniform4(points::<3, 2>())) {
        agree(&Input::Lines(lines.iter().map(rationals).collect()))?;
    }

    #[test]
    fn segments_between_any_cells(
        doors in prop::collection::vec((0usize..5, 1usize..5, points::<2, 2>()), 1..7),
    ) {
        let doors = doors.iter().map(|(from, step, ends)| door(*from, (from + step) % 5, ends));
        agree(&Input::Graph(Graph { cells: 5, doors: doors.collect(), from: 0, to: 1 }))?;
    }

    #[test]
    fn portals_between_any_cells(
        doors in prop::collection::vec((0usize..4, 1usize..4, points::<3, 3>()), 1..5),
    ) {
        let doors = doors.iter().map(|(from, step, ends)| door(*from, (from + step) % 4, ends));
        let graph = Graph { cells: 4, doors: doors.collect(), from: 0, to: 1 };
        prop_assume!(portal_graph(&graph).is_ok());
        let (_, matrix, _) = pvs_of(&graph).map_err(failed)?;
        let expected = twin::open_cells(&graph).map_err(failed)?;
        for (a, row) in expected.iter().enumerate() {
            for (b, &is_open) in row.iter().enumerate() {
                prop_assert_eq!(matrix.get(a, b) == Verdict::Open, is_open, "cells {} {}", a, b);
            }
        }
    }
}
