//! Eyes in floorplans: culls against each other, walks against fresh queries, laws and errors.

mod support;

use num_traits::{One, Zero};
use stabline::eye::FrustumError;
use stabline::eye::plan::{
    CellSight, EyePlan, PlanCull, PlanPlaceError, PlanWay, ViewCone, Walk, prefetch,
};
use stabline::geom::BigPoint2;
use stabline::num::{Int, Rational};
use stabline::oracle::Random;
use stabline::portal::plan::PlanCells;
use stabline::predicates::PlanPoint;
use stabline::pvs::plan::{Groups, plan_matrix, plan_stab_trees};
use stabline::report::{Silent, Verdict};
use stabline::scene::CellId;
use stabline::scene::plan::{Crossings, Plan, PlanStabNode};
use stabline::stab::hourglass::Hourglass;
use stabline::subdivision::plan::PlanMethod;
use std::collections::BTreeSet;
use support::plans::{self, Kind, Point, ratio};

/// What each cell sees, itself included.
fn sights(cells: &PlanCells) -> Vec<Vec<CellId>> {
    let graph = &cells.graph;
    let count = graph.cells.len();
    let matrix = plan_matrix(graph, &graph.crossings(), &Groups::cells(count), &Silent).unwrap();
    let ids = || (0..count as u32).map(CellId);
    let is_open = |a: CellId, b: CellId| matrix.get(a.0 as usize, b.0 as usize) == Verdict::Open;
    ids().map(|from| ids().filter(|&to| is_open(from, to)).collect()).collect()
}

/// The stab tree of a cell, by a search without any prune.
fn stab_tree(cells: &PlanCells, crossings: &Crossings, source: CellId) -> Vec<PlanStabNode> {
    struct Search<'a> {
        cells: &'a PlanCells,
        crossings: &'a Crossings,
        common: Int,
        hourglass: Hourglass,
        path: Vec<CellId>,
        tree: Vec<PlanStabNode>,
    }
    impl Search<'_> {
        fn end(&self, point: u32) -> BigPoint2 {
            let [x, y, w] = self.cells.graph.points.get(point).numbers();
            let scale = &self.common / w;
            BigPoint2 { coordinates: [x * &scale, y * &scale] }
        }

        fn visit(&mut self, cell: CellId, parent: Option<u32>) {
            self.path.push(cell);
            for way in self.crossings.from(cell) {
                if self.path.contains(&way.to) {
                    continue;
                }
                self.hourglass.push_big(self.end(way.left), self.end(way.right));
                if self.hourglass.is_open() {
                    let vertex = PlanStabNode { parent, portal: way.portal, cell: way.to };
                    self.tree.push(vertex);
                    self.visit(way.to, Some(self.tree.len() as u32 - 1));
                }
                self.hourglass.pop();
            }
            self.path.pop();
        }
    }
    let points = &cells.graph.points;
    let denominators = (0..points.len() as u32).map(|point| points.get(point).numbers()[2].clone());
    let common = denominators.fold(Int::one(), num_integer::lcm);
    let (hourglass, path, tree) = (Hourglass::new(), Vec::new(), Vec::new());
    let mut search = Search { cells, crossings, common, hourglass, path, tree };
    search.visit(source, None);
    search.tree
}

/// The portals of every vertex's sequence.
fn paths(tree: &[PlanStabNode]) -> BTreeSet<Vec<u32>> {
    let mut paths: Vec<Vec<u32>> = Vec::new();
    for vertex in tree {
        let before = vertex.parent.map(|parent| paths[parent as usize].clone());
        let mut path = before.unwrap_or_default();
        path.push(vertex.portal);
        paths.push(path);
    }
    paths.into_iter().collect()
}

fn grid_point(plan: &Plan, point: &Point) -> PlanPoint {
    let grid = Rational::from(plan.grid.clone());
    PlanPoint::from_coordinates(&point.each_ref().map(|c| c * &grid))
}

fn holds(more: &[CellId], less: &[CellId]) -> bool {
    less.iter().all(|cell| more.contains(cell))
}

#[test]
fn each_cull_leaves_what_the_next_one_does() {
    // How often a cull leaves less than the one before, by set and by tree.
    let mut sharper = [0; 6];
    for kind in [Kind::Axial, Kind::Oblique, Kind::Star, Kind::Gaps] {
        for seed in 0..12 {
            let mut random = Random::new(seed * 7 + kind as u64);
            let mut walls = plans::walls(kind, &mut random);
            walls.truncate(7);
            let Some((plan, cells)) = plans::plan(kind, &walls, &mut random) else { continue };
            let (eyes, crossings) = (EyePlan::new(&plan, &cells), cells.graph.crossings());
            let sights = sights(&cells);
            for _ in 0..4 {
                let eye = plans::eye(kind, &plan, &cells, &mut random);
                let Ok(place) = eyes.place(grid_point(&plan, &eye)) else { continue };
                let case = format!("{kind:?} {seed} from {} {}", eye[0], eye[1]);
                let tree = stab_tree(&cells, &crossings, place.cell());
                let [search] =
                    &plan_stab_trees(&cells.graph, &crossings, &[place.cell()], false, &Silent)
                        .unwrap()[..]
                else {
                    unreachable!("one tree for one cell")
                };
                assert_eq!(search.nodes, tree, "{case}");
                let by_set = CellSight::Cells(&sights[place.cell().0 as usize]);
                let by_tree = CellSight::Tree(&tree);
                let around = eyes.view(&place, None);
                for cull in &PlanCull::ALL[..4] {
                    let of_cell = &sights[place.cell().0 as usize];
                    assert_eq!(&around.cull(*cull, by_set), of_cell, "{case}, {cull:?}");
                    assert_eq!(&around.cull(*cull, by_tree), of_cell, "{case}, {cull:?}");
                }
                let cone = plans::cone(&mut random);
                let view = eyes.view(&place, Some(&cone));
                let set = PlanCull::ALL.map(|cull| view.cull(cull, by_set));
                let tree_cells = PlanCull::ALL.map(|cull| view.cull(cull, by_tree));
                for i in 0..5 {
                    assert!(holds(&set[i], &tree_cells[i]), "{case}, {cone:?}, {i}");
                }
                for i in 0..4 {
                    assert!(holds(&set[i], &set[i + 1]), "{case}, {cone:?}, {i}");
                    assert!(holds(&tree_cells[i], &tree_cells[i + 1]), "{case}, {cone:?}, {i}");
                    sharper[i] += usize::from(tree_cells[i].len() > tree_cells[i + 1].len());
                }
                sharper[4] += usize::from(set[2].len() > tree_cells[2].len());
                sharper[5] +=
                    usize::from(around.cull(PlanCull::Exact, by_set).len() < set[0].len());
                // From inside of its cell, the eye sees through sequences of the stab tree only.
                if place.around().len() == 1 {
                    let (sequences, paths) = (around.sequences(), paths(&tree));
                    let seen = sequences.all().iter();
                    assert!(seen.into_iter().all(|s| paths.contains(&sequences.portals(s))));
                }
            }
        }
    }
    for (i, count) in sharper.iter().enumerate().filter(|(i, _)| *i != 4) {
        assert!(*count > 0, "no eye tells cull {i} from the next one: {sharper:?}");
    }
}

#[test]
fn a_walk_sees_what_fresh_eyes_see() {
    let [mut crossed, mut located, mut stayed] = [0; 3];
    for kind in Kind::ALL {
        for seed in 0..6 {
            let mut random = Random::new(seed * 11 + kind as u64);
            let walls = plans::walls(kind, &mut random);
            let Some((plan, cells)) = plans::plan(kind, &walls, &mut random) else { continue };
            let eyes = EyePlan::new(&plan, &cells);
            let mut fetched = Vec::new();
            let mut walk = Walk::new(&eyes, |cell| fetched.push(cell));
            let mut at = plans::eye(kind, &plan, &cells, &mut random);
            let mut seen = BTreeSet::new();
            let mut cells_of_steps = Vec::new();
            let cone = random.one_in(2).then(|| plans::cone(&mut random));
            for _ in 0..25 {
                at = match random.between(1, 4) {
                    1 => plans::eye(kind, &plan, &cells, &mut random),
                    _ => at.map(|c| c + ratio(random.between(-3, 3), 5)),
                };
                let point = grid_point(&plan, &at);
                let fresh = eyes.place(point.clone());
                let step = walk.step(point, cone.as_ref());
                let (fresh, step) = match (fresh, step) {
                    (Ok(fresh), Ok(step)) => (fresh, step),
                    (fresh, step) => {
                        assert_eq!(fresh.unwrap_err(), step.unwrap_err());
                        continue;
                    }
                };
                assert_eq!(walk.place(), Some(&fresh), "{kind:?} {seed}");
                let view = eyes.view(&fresh, cone.as_ref());
                let cells_seen = view.seen_cells(&view.sequences());
                assert_eq!(walk.seen(), cells_seen);
                step.left.iter().for_each(|cell| assert!(seen.remove(cell)));
                step.entered.iter().for_each(|cell| assert!(seen.insert(*cell)));
                assert!(seen.iter().eq(&cells_seen));
                match step.way {
                    PlanWay::Located => located += 1,
                    PlanWay::Crossed(0) => stayed += 1,
                    PlanWay::Crossed(_) => crossed += 1,
                }
                if step.way == PlanWay::Crossed(0) {
                    assert!(!step.is_fetched);
                }
                cells_of_steps.push(fresh.cell());
            }
            drop(walk);
            cells_of_steps.dedup();
            assert_eq!(fetched, cells_of_steps);
        }
    }
    assert!(crossed > 50 && located > 50 && stayed > 50, "{crossed} {located} {stayed}");
}

#[test]
fn prefetch_sets_are_what_neighbours_see_and_the_cell_does_not() {
    let mut new = 0;
    for seed in 0..6 {
        let mut random = Random::new(seed);
        let walls = plans::walls(Kind::Axial, &mut random);
        let Some((_, cells)) = plans::plan(Kind::Axial, &walls, &mut random) else { continue };
        let (crossings, sights) = (cells.graph.crossings(), sights(&cells));
        for cell in (0..cells.graph.cells.len() as u32).map(CellId) {
            let sets = prefetch(&crossings, cell, |of| &sights[of.0 as usize]);
            let neighbours: BTreeSet<_> = crossings.from(cell).iter().map(|way| way.to).collect();
            assert!(sets.iter().map(|set| &set.neighbour).eq(&neighbours));
            for set in sets {
                let own: BTreeSet<_> = sights[cell.0 as usize].iter().collect();
                let theirs: BTreeSet<_> = sights[set.neighbour.0 as usize].iter().collect();
                assert!(theirs.difference(&own).copied().eq(&set.cells));
                new += set.cells.len();
            }
        }
    }
    assert!(new > 0);
}

/// A plan of walls with whole ends in a box of 10 by 10.
fn room(walls: &[[[i64; 2]; 2]]) -> (Plan, PlanCells) {
    let walls: Vec<[Point; 2]> =
        walls.iter().map(|ends| ends.map(|end| end.map(|c| ratio(c, 1)))).collect();
    let view = [[0, 0], [10, 10]].map(|corner| corner.map(|c| ratio(c, 1)));
    plans::divided(&walls, Some(view), &PlanMethod::Bsp)
}

fn area(eyes: &EyePlan, eye: PlanPoint, cone: Option<&ViewCone>) -> Rational {
    let place = eyes.place(eye).unwrap();
    let view = eyes.view(&place, cone);
    view.doubled_area(&view.sequences()) / Int::from(2)
}

#[test]
fn a_door_shows_a_trapezoid() {
    // A wall at x = 5 with a door from y = 4 to 6; the eye is 5 before it, and sees 6 of 10 units
    // of the wall behind, which is another 5 away.
    let (plan, cells) = room(&[[[5, 0], [5, 4]], [[5, 6], [5, 10]]]);
    let eyes = EyePlan::new(&plan, &cells);
    let eye = PlanPoint::integer([Int::from(2), Int::from(5)]);
    // Half-widths of 1 at x = 5 and 1·8/3 at x = 10.
    let behind = (ratio(2, 1) + ratio(16, 3)) * ratio(5, 2);
    assert_eq!(area(&eyes, eye.clone(), None), ratio(50, 1) + &behind);
    // All that is behind is within 45 degrees of the x axis; before it the cone is cut by the wall.
    let cone = ViewCone::new(&[ratio(7, 2), ratio(0, 1)], &ratio(1, 1)).unwrap();
    assert_eq!(area(&eyes, eye.clone(), Some(&cone)), ratio(9, 1) + &behind);
    // In the door it sees all of both rooms, from a cell that is one of several around it.
    let door = PlanPoint::integer([Int::from(5), Int::from(5)]);
    assert_eq!(area(&eyes, door.clone(), None), ratio(100, 1));
    assert!(eyes.place(door).unwrap().around().len() > 1);
}

#[test]
fn quarters_make_the_whole() {
    for kind in Kind::ALL {
        let mut random = Random::new(17 + kind as u64);
        let walls = plans::walls(kind, &mut random);
        let Some((plan, cells)) = plans::plan(kind, &walls, &mut random) else { continue };
        let eyes = EyePlan::new(&plan, &cells);
        for _ in 0..10 {
            let eye = grid_point(&plan, &plans::eye(kind, &plan, &cells, &mut random));
            if eyes.place(eye.clone()).is_err() {
                continue;
            }
            let look = [ratio(random.between(1, 5), 1), ratio(random.between(-5, 5), 3)];
            let quarters = [0, 1, 2, 3].map(|turns| {
                let mut look = look.clone();
                for _ in 0..turns {
                    look = [-&look[1], look[0].clone()];
                }
                let cone = ViewCone::new(&look, &Rational::one()).unwrap();
                area(&eyes, eye.clone(), Some(&cone))
            });
            assert_eq!(quarters.iter().sum::<Rational>(), area(&eyes, eye, None), "{kind:?}");
        }
    }
}

#[test]
fn an_eye_without_a_view_is_told_why() {
    let (plan, cells) = room(&[[[5, 0], [5, 4]], [[5, 6], [5, 10]], [[6, 2], [8, 4]]]);
    let eyes = EyePlan::new(&plan, &cells);
    let place = |x: i64, y: i64| eyes.place(PlanPoint::new([x.into(), y.into(), Int::from(2)]));
    let wall = |segment| Err(PlanPlaceError::OnWall { segment });
    assert_eq!(place(10, 2), wall(0));
    // The ends of walls, and the middle of an oblique one.
    assert_eq!(place(10, 12), wall(1));
    assert_eq!(place(12, 4), wall(2));
    assert_eq!(place(14, 6), wall(2));
    // Where a wall meets the box, and beside it.
    assert_eq!(place(10, 0), wall(0));
    assert_eq!(place(11, 0), Err(PlanPlaceError::OnEdge));
    assert_eq!(place(-1, 3), Err(PlanPlaceError::OutOfBox));
    assert_eq!(place(3, 21), Err(PlanPlaceError::OutOfBox));
    assert!(place(11, 3).is_ok());
    let zero = || [Rational::zero(), Rational::zero()];
    assert_eq!(ViewCone::new(&zero(), &ratio(1, 1)), Err(FrustumError::NoLook));
    let look = [ratio(1, 1), ratio(1, 1)];
    assert_eq!(ViewCone::new(&look, &ratio(0, 1)), Err(FrustumError::NotPositive(ratio(0, 1))));
}
