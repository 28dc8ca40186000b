use super::*;
use crate::num::{Number, Rational};
use crate::oracle::Random;
use crate::portal::plan::{PlanCells, cells_of_plan};
use crate::pvs::{Options, assemble, compute};
use crate::report::{Matrix, Silent, Verdict};
use crate::scene::plan::{Plan, PlanGraph, RawPlan, RawSegment};
use crate::subdivision::plan::{PlanMethod, divide};
use num_traits::Signed;

fn plan(segments: &[[[i64; 2]; 2]]) -> Plan {
    let number = |c: i64| Number::Small(c, 1);
    let segments = segments
        .iter()
        .map(|ends| RawSegment { ends: ends.map(|end| end.map(number)), is_opaque: true });
    Plan::from_raw(&RawPlan { segments: segments.collect(), ..RawPlan::default() }).unwrap()
}

fn cells(plan: &Plan) -> PlanCells {
    let tree = divide(plan, &PlanMethod::Bsp, &Silent).unwrap();
    cells_of_plan(plan, tree, false).unwrap()
}

/// By the search of portal sequences in space.
fn matrix_in_space(graph: &PlanGraph) -> Matrix {
    let graph = graph.in_space();
    let found = compute(&graph, &Options::default(), Vec::new(), &|_| {}, &Silent);
    assemble(&graph, &found.rows)
}

fn check_sights(graph: &PlanGraph, groups: &Groups, matrix: &Matrix, sights: &[PlanSight]) {
    let mut open = matrix.size() as u64;
    for PlanSight { from, to, portals, line } in sights {
        open += 2;
        assert_eq!(matrix.get(*from as usize, *to as usize), Verdict::Open);
        let [p, q] = line.each_ref().map(|p| p.each_ref().map(Number::to_rational));
        let side = |end: u32| {
            let [x, y] = graph.world(end).map(|c| c.to_rational());
            let turn: Rational = (&q[0] - &p[0]) * (y - &p[1]) - (&q[1] - &p[1]) * (x - &p[0]);
            turn
        };
        // The chain of cells, in whichever direction the first portal is crossed.
        let first = &graph.portals[portals[0] as usize];
        let mut cell = if side(first.left).is_positive() { first.from } else { first.to };
        assert_eq!(groups.of(cell), Some(*from));
        for &number in portals {
            let portal = &graph.portals[number as usize];
            let is_forward = portal.from == cell;
            assert!(is_forward || portal.to == cell, "a chain of portals");
            let [left, right] = match is_forward {
                true => [portal.left, portal.right],
                false => [portal.right, portal.left],
            };
            assert!(side(left).is_positive() && side(right).is_negative());
            cell = if is_forward { portal.to } else { portal.from };
        }
        assert_eq!(groups.of(cell), Some(*to));
    }
    assert_eq!(open, matrix.counts().open);
}

fn compare(segments: &[[[i64; 2]; 2]]) -> (u64, u64) {
    let plan = plan(segments);
    let cells = cells(&plan);
    let graph = &cells.graph;
    let crossings = graph.crossings();
    let groups = Groups::cells(graph.cells.len());
    let (matrix, sights) = plan_sights(graph, &crossings, &groups, &Silent).unwrap();
    assert_eq!(matrix, plan_matrix(graph, &crossings, &groups, &Silent).unwrap());
    check_sights(graph, &groups, &matrix, &sights);
    let expected = matrix_in_space(graph);
    for from in 0..matrix.size() {
        for to in 0..from {
            let (got, expected) = (matrix.get(from, to), expected.get(from, to));
            assert_eq!(got, expected, "cells {from} and {to} of {segments:?}");
        }
    }
    let counts = matrix.counts();
    (counts.open, counts.not_open)
}

#[test]
fn the_search_in_space_agrees_on_random_plans() {
    let mut random = Random::new(11);
    let mut counts = [0; 2];
    for round in 0..150 {
        let size = random.between(3, 12);
        let count = random.between(1, 14);
        let mut segments = Vec::new();
        while segments.len() < count as usize {
            let mut ends = [(); 2].map(|()| [(); 2].map(|()| random.between(0, size)));
            if round % 2 == 0 {
                // Axial.
                let axis = random.between(0, 1) as usize;
                ends[1][axis] = ends[0][axis];
            }
            if ends[0] != ends[1] {
                segments.push(ends);
            }
        }
        let (open, closed) = compare(&segments);
        counts[0] += open;
        counts[1] += closed;
    }
    assert!(counts.iter().all(|&count| count > 1000), "{counts:?}");
}
