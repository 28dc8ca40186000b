use super::*;
use crate::num::{Number, Rational, Sign};
use crate::oracle::{PlaneGate, PlaneTruth, Random, classify_pairs_2d};
use crate::portal::plan::{PlanCells, cells_of_plan};
use crate::pvs::{Options, assemble, compute};
use crate::report::{Matrix, Silent, Verdict};
use crate::scene::CellId;
use crate::scene::plan::{Plan, PlanGraph, PlanPortal, RawPlan, RawSegment};
use crate::subdivision::plan::{PlanMethod, divide};
use num_traits::{Signed, Zero};

pub(super) fn plan(segments: &[[[i64; 2]; 2]]) -> Plan {
    let number = |c: i64| Number::Small(c, 1);
    let segments = segments
        .iter()
        .map(|ends| RawSegment { ends: ends.map(|end| end.map(number)), is_opaque: true });
    Plan::from_raw(&RawPlan { segments: segments.collect(), ..RawPlan::default() }).unwrap()
}

pub(super) fn cells(plan: &Plan) -> PlanCells {
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
    let (matrix, sights) = plan_sights(graph, &crossings, &groups, &|_, _| true, &Silent).unwrap();
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

/// Every simple portal sequence between two cells, each judged by the twin of the hourglass.
fn classified_by_sequences(graph: &PlanGraph) -> Matrix {
    let point = |end: u32| {
        let [x, y, w] = graph.points.get(end).numbers();
        // A common multiple of all denominators that occur here.
        let scale = crate::num::Int::from(720_720u64 * 30_030);
        assert!((&scale % &w).is_zero(), "{w}");
        crate::geom::BigPoint2 { coordinates: [x, y].map(|c| c * (&scale / &w)) }
    };
    let gate = |portal: &PlanPortal| PlaneGate {
        from: portal.from.0 as usize,
        to: portal.to.0 as usize,
        ends: [portal.left, portal.right].map(point),
    };
    let gates: Vec<PlaneGate> = graph.portals.iter().map(gate).collect();
    let mut matrix = Matrix::new(graph.cells.len(), Verdict::NotOpen);
    for (from, row) in classify_pairs_2d(graph.cells.len(), &gates).iter().enumerate() {
        for (to, truth) in row.iter().enumerate() {
            let verdict = match truth {
                PlaneTruth::Open => Verdict::Open,
                PlaneTruth::Grazing => Verdict::Grazing,
                PlaneTruth::Blocked => Verdict::NotOpen,
            };
            matrix.set(from, to, verdict);
        }
    }
    matrix
}

/// That every grazing pair has one line, and that it touches a sequence between the two.
fn check_touches(graph: &PlanGraph, matrix: &Matrix, touches: &[PlanTouch]) {
    let crossings = graph.crossings();
    for touch in touches {
        let [from, to] = touch.groups;
        assert_eq!(matrix.get(from as usize, to as usize), Verdict::Grazing);
        let mut cell = touch.cells[0];
        for way in touch.ways(graph, &crossings) {
            assert!(crossings.from(cell).contains(&way), "a way out of the cell");
            let [left, right] = [way.left, way.right]
                .map(|end| graph.points.turn(touch.line[0], touch.line[1], end));
            assert!(left != Sign::Negative && right != Sign::Positive);
            cell = way.to;
        }
        assert_eq!(cell, touch.cells[1]);
        assert!(
            touch.cells == [CellId(from), CellId(to)] || touch.cells == [CellId(to), CellId(from)]
        );
    }
    assert_eq!(2 * touches.len() as u64, matrix.counts().grazing);
}

#[test]
fn grazing_pairs_are_those_of_all_sequences() {
    let mut random = Random::new(12);
    let mut grazing = 0;
    for round in 0..800 {
        let mut segments = Vec::new();
        let count = random.between(2, if round % 2 == 0 { 7 } else { 5 });
        while segments.len() < count as usize {
            let mut ends = [(); 2].map(|()| [(); 2].map(|()| random.between(0, 4)));
            if round % 2 == 0 {
                let axis = random.between(0, 1) as usize;
                ends[1][axis] = ends[0][axis];
            }
            if ends[0] != ends[1] {
                segments.push(ends);
            }
        }
        let cells = cells(&plan(&segments));
        let graph = &cells.graph;
        if graph.portals.len() > 16 {
            continue;
        }
        let crossings = graph.crossings();
        let groups = Groups::cells(graph.cells.len());
        let mut matrix = plan_matrix(graph, &crossings, &groups, &Silent).unwrap();
        let touches =
            classify_plan_grazing(graph, &crossings, &groups, &mut matrix, &Silent).unwrap();
        assert_eq!(matrix, classified_by_sequences(graph), "{segments:?}");
        check_touches(graph, &matrix, &touches);
        grazing += matrix.counts().grazing;
    }
    assert!(grazing > 50, "{grazing}");
}

#[test]
fn groups_see_what_their_cells_see() {
    let mut random = Random::new(13);
    let mut counts = [0; 2];
    for _ in 0..300 {
        let size = random.between(3, 9);
        let count = random.between(1, 12);
        let segments: Vec<_> = (0..count)
            .map(|_| [(); 2].map(|()| [(); 2].map(|()| random.between(0, size))))
            .filter(|ends| ends[0] != ends[1])
            .collect();
        if segments.is_empty() {
            continue;
        }
        let cells = cells(&plan(&segments));
        let (graph, crossings) = (&cells.graph, cells.graph.crossings());
        let of_cells =
            plan_matrix(graph, &crossings, &Groups::cells(graph.cells.len()), &Silent).unwrap();
        let of_cell: Vec<Option<u32>> = (0..graph.cells.len())
            .map(|_| Some(random.between(0, 4) as u32).filter(|&group| group < 4))
            .collect();
        let groups = Groups::new(4, of_cell.clone());
        let all = |_, _| true;
        let (matrix, sights) = plan_sights(graph, &crossings, &groups, &all, &Silent).unwrap();
        check_sights(graph, &groups, &matrix, &sights);
        let mut expected = Matrix::new(4, Verdict::NotOpen);
        (0..4).for_each(|group| expected.set(group, group, Verdict::Open));
        for (from, g) in of_cell.iter().enumerate() {
            for (to, h) in of_cell.iter().enumerate() {
                if let (Some(g), Some(h)) = (g, h)
                    && of_cells.get(from, to) == Verdict::Open
                {
                    expected.set(*g as usize, *h as usize, Verdict::Open);
                }
            }
        }
        assert_eq!(matrix, expected, "{segments:?} {of_cell:?}");
        counts[0] += matrix.counts().open;
        counts[1] += matrix.counts().not_open;
    }
    assert!(counts.iter().all(|&count| count > 100), "{counts:?}");
}
