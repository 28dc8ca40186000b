//! Laws of cell-to-cell visibility in floorplans. What two cells see of each other depends on their
//! places and on what occludes, not on how the rest of the plan is divided.

use stabline::num::{Number, Rational};
use stabline::oracle::Random;
use stabline::portal::plan::cells_of_plan;
use stabline::pvs::plan::{Groups, plan_matrix};
use stabline::report::{Matrix, Silent, Verdict};
use stabline::scene::plan::{Plan, RawPlan, RawSegment};
use stabline::subdivision::plan::{PlanMethod, divide};
use std::collections::BTreeMap;

type Ends = [[i64; 2]; 2];

/// Segments, and whether each occludes.
type Walls = Vec<(Ends, bool)>;

/// A cell by its corners, ascending.
type Corners = Vec<[Rational; 2]>;

fn walls(random: &mut Random, is_axial: bool) -> Walls {
    let count = random.between(2, 12);
    let mut walls = Walls::new();
    while walls.len() < count as usize {
        let mut ends = [(); 2].map(|()| [(); 2].map(|()| random.between(-6, 6)));
        if is_axial {
            let axis = random.between(0, 1) as usize;
            ends[1][axis] = ends[0][axis];
        }
        if ends[0] != ends[1] {
            walls.push((ends, !random.one_in(4)));
        }
    }
    walls
}

fn decide(walls: &Walls, method: &PlanMethod) -> (Vec<Corners>, Matrix) {
    let segment = |(ends, is_opaque): &(Ends, bool)| RawSegment {
        ends: ends.map(|end| end.map(|c| Number::Small(c, 1))),
        is_opaque: *is_opaque,
    };
    let raw = RawPlan { segments: walls.iter().map(segment).collect(), ..RawPlan::default() };
    let plan = Plan::from_raw(&raw).unwrap();
    let tree = divide(&plan, method, &Silent).unwrap();
    let graph = cells_of_plan(&plan, tree, false).unwrap().graph;
    let corners = |polygon: &Vec<u32>| {
        let mut corners: Corners =
            polygon.iter().map(|&p| graph.points.get(p).coordinates()).collect();
        corners.sort();
        corners
    };
    let cells = graph.polygons.iter().map(corners).collect();
    let groups = Groups::cells(graph.cells.len());
    (cells, plan_matrix(&graph, &graph.crossings(), &groups, &Silent).unwrap())
}

/// Compares the verdicts of cells that are in both divisions; returns how many pairs there were.
fn compare_common(
    (cells, matrix): &(Vec<Corners>, Matrix),
    (others, other_matrix): &(Vec<Corners>, Matrix),
    label: &str,
) -> usize {
    let numbers: BTreeMap<&Corners, usize> =
        others.iter().enumerate().map(|(i, corners)| (corners, i)).collect();
    let common: Vec<(usize, usize)> =
        cells.iter().enumerate().filter_map(|(i, c)| Some((i, *numbers.get(c)?))).collect();
    for (from, other_from) in &common {
        for (to, other_to) in &common {
            let verdicts = (matrix.get(*from, *to), other_matrix.get(*other_from, *other_to));
            assert_eq!(verdicts.0, verdicts.1, "{label}: cells {from} and {to}");
        }
    }
    common.len() * common.len()
}

fn mapped(walls: &Walls, map: impl Fn([i64; 2]) -> [i64; 2]) -> Walls {
    walls.iter().map(|(ends, is_opaque)| (ends.map(&map), *is_opaque)).collect()
}

/// The division as it would be without the map.
fn unmapped(
    (cells, matrix): (Vec<Corners>, Matrix),
    map: impl Fn(&[Rational; 2]) -> [Rational; 2],
) -> (Vec<Corners>, Matrix) {
    let back = |corners: Corners| {
        let mut corners: Corners = corners.iter().map(&map).collect();
        corners.sort();
        corners
    };
    (cells.into_iter().map(back).collect(), matrix)
}

#[test]
fn order_and_direction_of_segments_do_not_matter() {
    let mut random = Random::new(31);
    let mut pairs = 0;
    for round in 0..150 {
        let walls = walls(&mut random, round % 2 == 0);
        let answer = decide(&walls, &PlanMethod::Bsp);
        let mut other: Walls = walls.iter().rev().copied().collect();
        other.iter_mut().for_each(|(ends, _)| ends.reverse());
        other.push(other[0]);
        pairs += compare_common(&answer, &decide(&other, &PlanMethod::Bsp), &format!("{walls:?}"));
    }
    assert!(pairs > 5000, "{pairs}");
}

#[test]
fn moving_mirroring_turning_and_scaling_do_not_matter() {
    let mut random = Random::new(32);
    let mut pairs = [0; 4];
    for round in 0..100 {
        let walls = walls(&mut random, round % 2 == 0);
        let label = format!("{walls:?}");
        let answer = decide(&walls, &PlanMethod::Bsp);
        // Far enough away that its coordinates' products need all the digits of the exact stages.
        let far = 1i64 << 50;
        let whole = |n: i64| Rational::from(num_bigint::BigInt::from(n));
        let moved = decide(&mapped(&walls, |[x, y]| [x + far, y - far]), &PlanMethod::Bsp);
        let moved = unmapped(moved, |[x, y]| [x - whole(far), y + whole(far)]);
        assert_eq!(moved, answer, "{label}");
        pairs[0] += compare_common(&answer, &moved, &label);
        let mirrored = decide(&mapped(&walls, |[x, y]| [-x, y]), &PlanMethod::Bsp);
        let mirrored = unmapped(mirrored, |[x, y]| [-x, y.clone()]);
        pairs[1] += compare_common(&answer, &mirrored, &label);
        let turned = decide(&mapped(&walls, |[x, y]| [-y, x]), &PlanMethod::Bsp);
        let turned = unmapped(turned, |[x, y]| [y.clone(), -x]);
        pairs[2] += compare_common(&answer, &turned, &label);
        let scaled = decide(&mapped(&walls, |p| p.map(|c| c * 3_000_017)), &PlanMethod::Bsp);
        let scaled = unmapped(scaled, |p| p.each_ref().map(|c| c / whole(3_000_017)));
        assert_eq!(scaled, answer, "{label}");
        pairs[3] += compare_common(&answer, &scaled, &label);
    }
    assert!(pairs.iter().all(|&pairs| pairs > 2000), "{pairs:?}");
}

#[test]
fn both_trees_give_the_same_answers() {
    let mut random = Random::new(33);
    let mut pairs = 0;
    for _ in 0..150 {
        let walls = walls(&mut random, true);
        let kd = decide(&walls, &PlanMethod::Kd { threshold: Rational::default() });
        pairs += compare_common(&decide(&walls, &PlanMethod::Bsp), &kd, &format!("{walls:?}"));
    }
    assert!(pairs > 2000, "{pairs}");
}

#[test]
fn what_occludes_more_opens_nothing() {
    let mut random = Random::new(34);
    let mut closed = 0;
    for round in 0..150 {
        let mut walls = walls(&mut random, round % 2 == 0);
        let (cells, before) = decide(&walls, &PlanMethod::Bsp);
        let Some(hint) = walls.iter().position(|(_, is_opaque)| !is_opaque) else { continue };
        walls[hint].1 = true;
        let (same_cells, after) = decide(&walls, &PlanMethod::Bsp);
        assert_eq!(cells, same_cells, "what divides is not what occludes");
        for (&was, &is) in before.entries().iter().zip(after.entries()) {
            assert!(is == was || (was, is) == (Verdict::Open, Verdict::NotOpen), "{walls:?}");
            closed += usize::from(is != was);
        }
    }
    assert!(closed > 100, "{closed}");
}
