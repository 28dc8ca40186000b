//! Scenes: both regions split the division as hints, so that each leaf is in a region or out of it,
//! and a region sees what its leaves see.

use super::joined::{Joined, best};
use super::{Fault, Finding, holds, raised, refused};
use crate::forge::check::{self, HalfSpace};
use crate::forge::input::{Input, Point, Scene, box_corners, polygons_json, sorted_box};
use crate::num::{Int, Number, Rational, Sign};
use crate::portal::plan::cells_of_plan;
use crate::portal::{WorldCells, cells_of_world};
use crate::pvs;
use crate::pvs::plan::{Groups, PlanSight, PlanTouch, classify_plan_grazing, plan_sights};
use crate::report::{Matrix, PairWitness, Silent};
use crate::scene::plan::{PlanGraph, PlanInput, read_plan};
use crate::scene::world::{WorldOptions, read_world};
use crate::subdivision;
use crate::subdivision::plan::{PlanMethod, divide};
use crate::vectors::{Answer, Class};
use serde_json::{Value, json};

/// Whether the scene is valid.
pub(super) fn accepts(input: &Input) -> bool {
    let text = input.document().to_string();
    match input.dimension() {
        2 => read_plan("case.json", text.as_bytes()).is_ok(),
        _ => read_world("case.json", text.as_bytes(), &WorldOptions::default()).is_ok(),
    }
}

/// The class of the two regions.
pub(super) fn find(scene: &Scene, input: &Input) -> Result<Finding, Fault> {
    let finding = |matrix: &Matrix, from: &[usize], to: &[usize]| Finding {
        answer: Answer::Class(best(matrix, from, to)),
        evidence: format!("{from:?} {to:?} {matrix:?}"),
    };
    match input.dimension() {
        2 => in_plane(scene, input).map(|flat| finding(&flat.matrix, &flat.from, &flat.to)),
        _ => in_space(scene, input).map(|found| finding(&found.matrix, &found.from, &found.to)),
    }
}

/// The cells that the scene was divided into, those of the two regions, and if the two have cells
/// in common, two points in one of them.
pub(super) fn joined_of(scene: &Scene, input: &Input) -> Result<(Joined, Option<Value>), Fault> {
    let text = |p: &Point| p.iter().map(ToString::to_string).collect::<Vec<String>>();
    let ratio = |k: i64| Rational::new(Int::from(k), Int::from(3));
    if input.dimension() == 2 {
        let flat = in_plane(scene, input)?;
        let common = flat.from.iter().find(|cell| flat.to.contains(cell));
        let inner = common.map(|&cell| {
            let corners = corners(&flat.graph, cell);
            let middle = middle(&corners);
            let beside = (0..2).map(|i| &middle[i] + (&corners[0][i] - &middle[i]) * ratio(1));
            json!([text(&middle), text(&beside.collect())])
        });
        return Ok((flat.in_space(), inner));
    }
    let joined = in_space(scene, input)?;
    let is_shared = joined.from.iter().any(|cell| joined.to.contains(cell));
    let inner = is_shared.then(|| {
        let [a, b] = [&scene.from, &scene.to].map(sorted_box);
        let at = |share: Rational| -> Point {
            let within = |i: usize| {
                let (low, high) = ((&a[0][i]).max(&b[0][i]), (&a[1][i]).min(&b[1][i]));
                low + (high - low) * &share
            };
            (0..3).map(within).collect()
        };
        json!([1, 2].map(|k| text(&at(ratio(k)))))
    });
    Ok((joined, inner))
}

fn in_space(scene: &Scene, input: &Input) -> Result<Joined, Fault> {
    let cells = cells_in_space(&mut input.document())?;
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
    let mut grazing = Vec::new();
    if best(&matrix, &from, &to) != Class::Open {
        grazing = pvs::classify_grazing(&cells.graph, &mut matrix, None, &Silent)
            .ok_or_else(|| refused("interrupted"))?;
    }
    Ok(Joined { built: cells.graph, matrix, rows: finished.rows, grazing, from, to })
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

/// A floorplan that was searched and classified, and the cells in the two regions.
struct Flat {
    graph: PlanGraph,
    matrix: Matrix,
    sights: Vec<PlanSight>,
    touches: Vec<PlanTouch>,
    from: Vec<usize>,
    to: Vec<usize>,
}

impl Flat {
    fn in_space(self) -> Joined {
        let crossings = self.graph.crossings();
        Joined {
            built: self.graph.in_space(),
            rows: self.sights.iter().map(PlanSight::in_space).collect(),
            grazing: self.touches.iter().map(|t| t.in_space(&self.graph, &crossings)).collect(),
            matrix: self.matrix,
            from: self.from,
            to: self.to,
        }
    }
}

fn in_plane(scene: &Scene, input: &Input) -> Result<Flat, Fault> {
    let graph = cells_in_plane(scene, &mut input.document())?;
    let crossings = graph.crossings();
    let groups = Groups::cells(graph.cells.len());
    let interrupted = || refused("interrupted");
    let (mut matrix, sights) =
        plan_sights(&graph, &crossings, &groups, &|_, _| true, &Silent).ok_or_else(interrupted)?;
    holds(matrix.asymmetric_pairs() == 0, "the matrix is not symmetric")?;
    let [from, to] = [&scene.from, &scene.to].map(|region| {
        let within = |&cell: &usize| is_within(&middle(&corners(&graph, cell)), region);
        (0..graph.cells.len()).filter(within).collect::<Vec<usize>>()
    });
    let joins = |sight: &&PlanSight| {
        let [a, b] = [sight.from as usize, sight.to as usize];
        from.contains(&a) && to.contains(&b) || from.contains(&b) && to.contains(&a)
    };
    let raised = |p: &[Number; 2]| PlanGraph::halfway_up(p.each_ref().map(Number::to_rational));
    let lines: Vec<[[Rational; 3]; 2]> =
        sights.iter().filter(joins).take(1).map(|s| s.line.each_ref().map(raised)).collect();
    hold_lines(scene, &lines)?;
    let mut touches = Vec::new();
    if best(&matrix, &from, &to) != Class::Open {
        touches = classify_plan_grazing(&graph, &crossings, &groups, &mut matrix, &Silent)
            .ok_or_else(interrupted)?;
    }
    Ok(Flat { graph, matrix, sights, touches, from, to })
}

/// A cell's corners in world units.
fn corners(graph: &PlanGraph, cell: usize) -> Vec<Point> {
    let world = |&corner: &u32| graph.world(corner).iter().map(|c| c.to_rational()).collect();
    graph.polygons[cell].iter().map(world).collect()
}

/// The mean of points of the plane.
fn middle(corners: &[Point]) -> Point {
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
