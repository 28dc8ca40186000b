//! Scenes: both regions split the division as hints, so that each leaf is in a region or out of it,
//! and a region sees what its leaves see.

use super::{Fault, Finding, class_of, holds, raised, refused};
use crate::forge::check::{self, HalfSpace};
use crate::forge::input::{Input, Point, Scene, box_corners, polygons_json, sorted_box};
use crate::num::{Int, Number, Rational, Sign};
use crate::portal::plan::cells_of_plan;
use crate::portal::{WorldCells, cells_of_world};
use crate::pvs;
use crate::pvs::plan::{Groups, PlanSight, classify_plan_grazing, plan_sights};
use crate::report::{Matrix, PairWitness, Silent};
use crate::scene::plan::{PlanGraph, PlanInput, read_plan};
use crate::scene::world::{WorldOptions, read_world};
use crate::subdivision;
use crate::subdivision::plan::{PlanMethod, divide};
use crate::vectors::{Answer, Class};
use serde_json::{Value, json};

/// The class of the two regions.
pub(super) fn find(scene: &Scene, input: &Input) -> Result<Finding, Fault> {
    let mut document = input.document();
    if input.dimension() == 2 {
        let plan = cells_in_plane(scene, &mut document)?;
        return in_plane(scene, &plan);
    }
    let cells = cells_in_space(&mut document)?;
    let options = pvs::Options::default();
    let finished = pvs::compute(&cells.graph, &options, Vec::new(), &|_| {}, &Silent);
    let mut matrix = pvs::assemble(&cells.graph, &finished.rows);
    holds(matrix.asymmetric_pairs() == 0, "the matrix is not symmetric")?;
    let [from, to] = leaves_of(scene, &cells);
    let joins = |pair: &&PairWitness| {
        let [a, b] = [pair.from as usize, pair.to as usize];
        from.contains(&a) && to.contains(&b) || from.contains(&b) && to.contains(&a)
    };
    let witnesses = pvs::witnesses(&finished.rows);
    let lines = witnesses.iter().filter(joins).take(1);
    let lines: Vec<[[Rational; 3]; 2]> = lines
        .map(|w| w.line.in_space().each_ref().map(|p| p.each_ref().map(Number::to_rational)))
        .collect();
    hold_lines(scene, &lines)?;
    if best(&matrix, &from, &to) != Class::Open {
        pvs::classify_grazing(&cells.graph, &mut matrix, None, &Silent);
    }
    Ok(finding(&matrix, &from, &to))
}

/// Holds that along each line the two regions see each other.
fn hold_lines(scene: &Scene, lines: &[[[Rational; 3]; 2]]) -> Result<(), Fault> {
    if lines.is_empty() {
        return Ok(());
    }
    let occluders = occluders_of(scene);
    let [from, to] = regions_of(scene);
    for [p, q] in lines {
        let shown = check::shows([p, q], [&from, &to], &occluders);
        holds(shown, "the sightline does not join the regions")?;
    }
    Ok(())
}

/// What occludes, as convex sets; a segment of the plane as a wall.
pub fn occluders_of(scene: &Scene) -> Vec<Vec<HalfSpace>> {
    let polygons = scene.polygons.iter().map(|p| check::half_spaces_of_polygon(&raised(p)));
    polygons.chain(scene.brushes.iter().map(|p| check::half_spaces_of_hull(p))).collect()
}

/// The two regions, as convex sets; one of the plane as a prism.
pub fn regions_of(scene: &Scene) -> [Vec<HalfSpace>; 2] {
    [&scene.from, &scene.to].map(|region| match region[0].len() {
        3 => check::half_spaces_of_hull(&box_corners(region)),
        _ => check::half_spaces_of_hull(&prism(region)),
    })
}

/// A polygon of the plane with a height of 1.
fn prism(region: &[Point]) -> Vec<Point> {
    let at = |z: i64| {
        let z = Rational::from(Int::from(z));
        region.iter().map(move |p| vec![p[0].clone(), p[1].clone(), z.clone()])
    };
    at(0).chain(at(1)).collect()
}

fn finding(matrix: &Matrix, from: &[usize], to: &[usize]) -> Finding {
    let class = best(matrix, from, to);
    Finding { answer: Answer::Class(class), evidence: format!("{from:?} {to:?} {matrix:?}") }
}

/// The greatest class of a pair of cells.
fn best(matrix: &Matrix, from: &[usize], to: &[usize]) -> Class {
    let pairs = from.iter().flat_map(|&a| to.iter().map(move |&b| (a, b)));
    pairs.map(|(a, b)| class_of(matrix.get(a, b))).max().unwrap_or(Class::Blocked)
}

/// The cells of a scene in space, split by both regions.
fn cells_in_space(document: &mut Value) -> Result<WorldCells, Fault> {
    let hint = |object: &Value| json!({"box": object["box"]});
    let objects = document["objects"].as_array().cloned().unwrap_or_default();
    document["hints"] = objects.iter().map(hint).collect();
    let text = document.to_string();
    let (world, _) =
        read_world("case.json", text.as_bytes(), &WorldOptions::default()).map_err(refused)?;
    cells_of_world(&world, &subdivision::Options::default()).map_err(refused)
}

/// The cells in each of the regions.
fn leaves_of(scene: &Scene, cells: &WorldCells) -> [Vec<usize>; 2] {
    [&scene.from, &scene.to].map(|corners| {
        let corners = sorted_box(corners);
        let within = |&cell: &usize| {
            let point = cells.subdivision.leaf(cells.leaves[cell]).cell.inner_point().coordinates();
            (0..3).all(|i| corners[0][i] < point[i] && point[i] < corners[1][i])
        };
        (0..cells.leaves.len()).filter(within).collect()
    })
}

/// The cells of a floorplan, split by the edges of both regions.
fn cells_in_plane(scene: &Scene, document: &mut Value) -> Result<PlanGraph, Fault> {
    let edge = |region: &[Point], i: usize| {
        vec![region[i].clone(), region[(i + 1) % region.len()].clone()]
    };
    let edges: Vec<Vec<Point>> = [&scene.from, &scene.to]
        .into_iter()
        .flat_map(|region| (0..region.len()).map(move |i| edge(region, i)))
        .collect();
    document["hints"] = polygons_json(&edges);
    let text = document.to_string();
    let PlanInput::Plan(plan) = read_plan("case.json", text.as_bytes()).map_err(refused)? else {
        return Err(refused("no floorplan"));
    };
    let tree = divide(&plan, &PlanMethod::default(), &Silent).map_err(refused)?;
    Ok(cells_of_plan(&plan, tree, false).map_err(refused)?.graph)
}

fn in_plane(scene: &Scene, graph: &PlanGraph) -> Result<Finding, Fault> {
    let crossings = graph.crossings();
    let groups = Groups::cells(graph.cells.len());
    let interrupted = || Fault::Refused("interrupted".to_owned());
    let (mut matrix, sights) =
        plan_sights(graph, &crossings, &groups, &|_, _| true, &Silent).ok_or_else(interrupted)?;
    holds(matrix.asymmetric_pairs() == 0, "the matrix is not symmetric")?;
    let [from, to] = [&scene.from, &scene.to].map(|region| {
        let within = |&cell: &usize| is_within(&middle(graph, cell), region);
        (0..graph.cells.len()).filter(within).collect::<Vec<usize>>()
    });
    let joins = |sight: &&PlanSight| {
        let [a, b] = [sight.from as usize, sight.to as usize];
        from.contains(&a) && to.contains(&b) || from.contains(&b) && to.contains(&a)
    };
    let half = Rational::new(Int::from(1), Int::from(2));
    let lifted = |[x, y]: &[Number; 2]| [x.to_rational(), y.to_rational(), half.clone()];
    let lines: Vec<[[Rational; 3]; 2]> =
        sights.iter().filter(joins).take(1).map(|s| s.line.each_ref().map(lifted)).collect();
    hold_lines(scene, &lines)?;
    if best(&matrix, &from, &to) != Class::Open {
        classify_plan_grazing(graph, &crossings, &groups, &mut matrix, &Silent)
            .ok_or_else(interrupted)?;
    }
    Ok(finding(&matrix, &from, &to))
}

/// The mean of a cell's corners.
fn middle(graph: &PlanGraph, cell: usize) -> Point {
    let corners: Vec<Point> = graph.polygons[cell]
        .iter()
        .map(|&corner| graph.world(corner).iter().map(|c| c.to_rational()).collect())
        .collect();
    let count = Rational::from(Int::from(corners.len()));
    (0..2).map(|i| corners.iter().map(|p| &p[i]).sum::<Rational>() / &count).collect()
}

/// Whether a point is strictly inside a convex polygon, given either way around.
fn is_within(point: &Point, polygon: &[Point]) -> bool {
    let side = |i: usize| {
        let (a, b) = (&polygon[i], &polygon[(i + 1) % polygon.len()]);
        let turn = (&b[0] - &a[0]) * (&point[1] - &a[1]) - (&b[1] - &a[1]) * (&point[0] - &a[0]);
        Sign::of(turn.numer())
    };
    let sides: Vec<Sign> = (0..polygon.len()).map(side).collect();
    [Sign::Positive, Sign::Negative].iter().any(|sign| sides.iter().all(|side| side == sign))
}
