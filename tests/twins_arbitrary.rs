//! The engine against its brute-force twins on arbitrary small input, which proptest shrinks; the
//! forge makes the input that is degenerate on purpose.

mod support;

use proptest::prelude::*;
use stabline::forge::{Door, Fault, Graph, Input, accepts, find, portal_graph, pvs_of};
use stabline::geom::{BigPoint2, BigPoint3};
use stabline::num::{Int, Rational};
use stabline::oracle::{
    MeetingLines, PlaneTruth, Truth, classify, classify_2d, meeting_lines, open_pairs,
};
use stabline::report::Verdict;
use stabline::vectors::{Answer, Class, LineCount};
use support::graphs::{gates, integer};

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

/// The engine's class, its evidence held; `None` of input that breaks a rule.
fn found(input: &Input) -> Option<Answer> {
    match find(input) {
        Ok(found) => Some(found.answer),
        Err(Fault::Refused(_)) => None,
        Err(fault) => panic!("{fault}"),
    }
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
        let input = Input::Sequence(triangles.iter().map(rationals).collect());
        prop_assume!(accepts(&input));
        let big = |p: &[i64; 3]| BigPoint3 { coordinates: p.map(Int::from) };
        let portals: Vec<Vec<BigPoint3>> =
            triangles.iter().map(|t| t.iter().map(big).collect()).collect();
        let expected = match classify(&portals) {
            Truth::Open(_) => Class::Open,
            Truth::Grazing(_) => Class::Grazing,
            Truth::Blocked => Class::Blocked,
        };
        prop_assert_eq!(found(&input), Some(Answer::Class(expected)));
    }

    #[test]
    fn gates_in_the_plane(segments in prop::collection::vec(points::<2, 2>(), 1..7)) {
        let input = Input::Sequence(segments.iter().map(rationals).collect());
        prop_assume!(accepts(&input));
        let big = |p: &[i64; 2]| BigPoint2 { coordinates: p.map(Int::from) };
        let gates: Vec<[BigPoint2; 2]> = segments.iter().map(|s| s.each_ref().map(big)).collect();
        let expected = match classify_2d(&gates) {
            PlaneTruth::Open => Class::Open,
            PlaneTruth::Grazing => Class::Grazing,
            PlaneTruth::Blocked => Class::Blocked,
        };
        prop_assert_eq!(found(&input), Some(Answer::Class(expected)));
    }

    #[test]
    fn four_lines(lines in prop::array::uniform4(points::<3, 2>())) {
        let input = Input::Lines(lines.iter().map(rationals).collect());
        prop_assume!(accepts(&input));
        let expected = match meeting_lines(&lines.map(|ends| ends.map(|p| p.map(integer)))) {
            MeetingLines::None => LineCount::None,
            MeetingLines::One => LineCount::One,
            MeetingLines::Two => LineCount::Two,
            MeetingLines::Family => LineCount::Family,
        };
        prop_assert_eq!(found(&input), Some(Answer::Lines(expected)));
    }

    #[test]
    fn portals_between_any_cells(
        doors in prop::collection::vec((0usize..4, 1usize..4, points::<3, 3>()), 1..5),
    ) {
        let door = |(from, step, triangle): &(usize, usize, [[i64; 3]; 3])| Door {
            cells: [*from, (from + step) % 4],
            polygon: rationals(triangle),
        };
        let doors = doors.iter().map(door).collect();
        let graph = Graph { cells: 4, doors, from: 0, to: 1 };
        prop_assume!(portal_graph(&graph).is_ok());
        let (built, matrix, _) = pvs_of(&graph).map_err(|f| TestCaseError::fail(f.to_string()))?;
        let expected = open_pairs(4, &gates(&built));
        for (a, row) in expected.iter().enumerate() {
            for (b, &is_open) in row.iter().enumerate() {
                prop_assert_eq!(matrix.get(a, b) == Verdict::Open, is_open, "cells {} {}", a, b);
            }
        }
    }
}
