//! Portals and neighbours against what every pair of leaves shares, in rationals.

use super::*;
use crate::num::{Int, Number, Random, Rational};
use crate::report::Silent;
use crate::scene::plan::{RawPlan, RawSegment};
use crate::subdivision::plan::{PlanMethod, divide};
use num_traits::Signed;

type Point = [Rational; 2];

fn cells(segments: &[[[i64; 2]; 2]], method: &PlanMethod) -> (Plan, PlanCells) {
    let number = |c: i64| Number::Small(c, 1);
    let segments = segments.iter().enumerate().map(|(i, ends)| RawSegment {
        ends: ends.map(|end| end.map(number)),
        is_opaque: i % 5 != 3,
    });
    let raw = RawPlan { segments: segments.collect(), ..RawPlan::default() };
    let plan = Plan::from_raw(&raw).unwrap();
    let tree = divide(&plan, method, &Silent).unwrap();
    let cells = cells_of_plan(&plan, tree, false).unwrap();
    (plan, cells)
}

fn turn(a: &Point, b: &Point, c: &Point) -> Rational {
    (&b[0] - &a[0]) * (&c[1] - &a[1]) - (&b[1] - &a[1]) * (&c[0] - &a[0])
}

/// What two segments on one line have in common, if it has length: its ends, ascending.
fn common([a, b]: &[Point; 2], [c, d]: &[Point; 2]) -> Option<[Point; 2]> {
    let zero = Rational::default();
    if turn(a, b, c) != zero || turn(a, b, d) != zero {
        return None;
    }
    let ascending =
        |p: &Point, q: &Point| if p < q { [p.clone(), q.clone()] } else { [q.clone(), p.clone()] };
    let ([a, b], [c, d]) = (ascending(a, b), ascending(c, d));
    let (low, high) = (a.max(c), b.min(d));
    (low < high).then_some([low, high])
}

/// What is left of a piece of a line where others are taken away: maximal, ascending.
fn without(piece: [Point; 2], walls: &[[Point; 2]]) -> Vec<[Point; 2]> {
    let mut left = vec![piece];
    for wall in walls {
        let mut next = Vec::new();
        for [low, high] in left {
            match common(&[low.clone(), high.clone()], wall) {
                None => next.push([low, high]),
                Some([start, end]) => {
                    let parts = [[low, start], [end, high]];
                    next.extend(parts.into_iter().filter(|[p, q]| p < q));
                }
            }
        }
        left = next;
    }
    left
}

/// Compares portals and neighbours with all pairs of edges of all pairs of leaves.
fn check(plan: &Plan, cells: &PlanCells) -> usize {
    let point = |number: u32| cells.tree.points.get(number).coordinates();
    let edges = |leaf: usize| -> Vec<[Point; 2]> {
        let corners = &cells.tree.leaves[leaf].polygon;
        let after = corners.iter().cycle().skip(1);
        corners.iter().zip(after).map(|(&p, &q)| [point(p), point(q)]).collect()
    };
    let opaque = plan.segments.iter().filter(|segment| segment.is_opaque);
    let walls: Vec<[Point; 2]> = opaque.map(|segment| segment.ends.map(point)).collect();
    let neighbours = cells.neighbours();
    let (mut portals, mut found) = (Vec::new(), Vec::new());
    let count = cells.tree.leaves.len();
    for one in 0..count {
        let mut around = Rational::default();
        for other in 0..count {
            let beside = neighbours.of(one as u32).iter();
            let beside = beside.filter(|n| n.leaf == Some(other as u32));
            let pieces: Vec<[Point; 2]> =
                beside.map(|n| cells.boundaries[n.boundary as usize].ends.map(point)).collect();
            let mut shared = Rational::default();
            for a in if one == other { Vec::new() } else { edges(one) } {
                for b in edges(other) {
                    let Some(piece) = common(&a, &b) else { continue };
                    shared += extent(&piece);
                    assert!(pieces.iter().any(|known| common(known, &piece).is_some()));
                    if one < other {
                        let open = without(piece, &walls).into_iter();
                        portals.extend(open.map(|ends| ([one, other], ends)));
                    }
                }
            }
            assert_eq!(shared, pieces.iter().map(extent).sum(), "leaves {one} and {other}");
            around += shared;
        }
        let outside = neighbours.of(one as u32).iter().filter(|n| n.leaf.is_none());
        let outside = outside.map(|n| cells.boundaries[n.boundary as usize].ends.map(point));
        around += outside.map(|ends| extent(&ends)).sum::<Rational>();
        assert_eq!(around, edges(one).iter().map(extent).sum(), "all around leaf {one}");
    }
    for portal in &cells.graph.portals {
        let ends = [point(portal.left), point(portal.right)];
        check_sides(cells, portal, &ends);
        let pair = [portal.from.0 as usize, portal.to.0 as usize];
        let [p, q] = ends;
        found.push((
            [pair[0].min(pair[1]), pair[0].max(pair[1])],
            if p < q { [p, q] } else { [q, p] },
        ));
    }
    portals.sort();
    found.sort();
    assert_eq!(found, portals);
    found.len()
}

/// A measure of pieces of one line that adds up: how far it reaches along the axes.
fn extent([p, q]: &[Point; 2]) -> Rational {
    (&p[0] - &q[0]).abs() + (&p[1] - &q[1]).abs()
}

/// Who crosses a portal from its first cell has its left end on the left.
fn check_sides(cells: &PlanCells, portal: &PlanPortal, [left, right]: &[Point; 2]) {
    for (cell, is_ahead) in [(portal.from, false), (portal.to, true)] {
        let polygon = &cells.graph.polygons[cell.0 as usize];
        let count = Rational::from(Int::from(polygon.len()));
        let corners = polygon.iter().map(|&corner| cells.graph.points.get(corner).coordinates());
        let middle =
            [0, 1].map(|d| corners.clone().map(|c| c[d].clone()).sum::<Rational>() / &count);
        assert_eq!(turn(right, left, &middle).is_negative(), is_ahead);
    }
}

#[test]
fn portals_and_neighbours_are_what_pairs_of_leaves_share() {
    let kd = PlanMethod::Kd { threshold: Rational::default() };
    let mut portals = 0;
    for seed in 0..60 {
        let random = &mut Random::new(seed);
        let reach = [3, 6, 12][seed as usize % 3];
        let is_axial = seed % 2 == 0;
        let mut segments = Vec::new();
        for _ in 0..3 + seed % 7 {
            let [mut p, mut q] = [(); 2].map(|()| [(); 2].map(|()| random.between(0, reach)));
            if is_axial {
                let d = usize::from(random.one_in(2));
                q[d] = p[d];
            }
            if random.one_in(4) {
                (p, q) = (q, p);
            }
            segments.push([p, q]);
        }
        segments.push([[0, 0], [reach, 0]]);
        let (plan, divided) = cells(&segments, &PlanMethod::Bsp);
        portals += check(&plan, &divided);
        if is_axial {
            let (plan, divided) = cells(&segments, &kd);
            portals += check(&plan, &divided);
        }
    }
    assert!(portals > 300, "{portals}");
}
