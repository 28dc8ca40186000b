//! What an eye sees of random floorplans against a full angular sweep over all walls.

mod support;

use num_traits::{Signed, Zero};
use stabline::eye::plan::{EyePlan, PlanPlaceError};
use stabline::num::Rational;
use stabline::oracle::{Random, star};
use stabline::predicates::PlanPoint;
use stabline::scene::plan::Plan;
use std::collections::BTreeMap;
use support::plans::{self, Kind, Point};

const PLANS: u64 = 12;
const EYES: usize = 5;

/// The corners of a plan's box, in world units.
fn view(plan: &Plan) -> [Point; 2] {
    let grid = Rational::from(plan.grid.clone());
    [0, 2].map(|i| plan.points.get(plan.bounds[i]).coordinates().map(|c| c / &grid))
}

/// Whether a closed segment holds a point.
fn is_on(point: &Point, [a, b]: &[Point; 2]) -> bool {
    let [from, to] = [a, b].map(|end| [&end[0] - &point[0], &end[1] - &point[1]]);
    let turn = &from[0] * &to[1] - &from[1] * &to[0];
    let apart = &from[0] * &to[0] + &from[1] * &to[1];
    turn.is_zero() && !apart.is_positive()
}

/// Looks all around and in a cone from random points; how many eyes had something to see.
fn compare(kind: Kind, seed: u64) -> usize {
    let mut random = Random::new(seed * 64 + kind as u64);
    let walls = plans::walls(kind, &mut random);
    let Some((plan, cells)) = plans::plan(kind, &walls, &mut random) else { return 0 };
    let eyes = EyePlan::new(&plan, &cells);
    let (bounds, grid) = (view(&plan), Rational::from(plan.grid.clone()));
    let mut looked = 0;
    for _ in 0..EYES {
        let eye = plans::eye(kind, &plan, &cells, &mut random);
        let case = format!("{kind:?} {seed} from {} {}", eye[0], eye[1]);
        let place = eyes.place(PlanPoint::from_coordinates(&eye.each_ref().map(|c| c * &grid)));
        let outside = (0..2).any(|i| eye[i] < bounds[0][i] || eye[i] > bounds[1][i]);
        let at_edge = (0..2).any(|i| eye[i] == bounds[0][i] || eye[i] == bounds[1][i]);
        let on_wall = walls.iter().any(|wall| is_on(&eye, wall));
        let place = match place {
            Ok(place) => place,
            Err(PlanPlaceError::OutOfBox) => {
                assert!(outside, "{case}");
                continue;
            }
            Err(PlanPlaceError::OnWall { segment }) => {
                assert!(!outside && is_on(&eye, &walls[segment as usize]), "{case}");
                continue;
            }
            Err(PlanPlaceError::OnEdge) => {
                assert!(!outside && at_edge && !on_wall, "{case}");
                continue;
            }
            Err(PlanPlaceError::NoCell) => panic!("{case}: all of the box is asked about"),
        };
        assert!(!outside && !at_edge && !on_wall, "{case}");
        looked += 1;
        for cone in [None, Some(plans::cone(&mut random))] {
            let view = eyes.view(&place, cone.as_ref());
            let sequences = view.sequences();
            let sides = cone.as_ref().map(|cone| {
                cone.sides().each_ref().map(|side| side.each_ref().map(|c| c.clone().into()))
            });
            let star = star(&eye, &walls, &bounds, sides.as_ref());
            let square = &grid * &grid;
            let area = view.doubled_area(&sequences) / &square;
            assert_eq!(area, star.doubled_area(), "{case}, {cone:?}");
            // And cell by cell, as the areas of two cells may hide each other's faults. With equal
            // sums, cells without a region need no look.
            let mut of_cell: BTreeMap<u32, Rational> = BTreeMap::new();
            for region in view.regions(&sequences) {
                let area = region.doubled_area() / &square;
                assert!(area.is_positive(), "{case}, {cone:?}: {region:?}");
                *of_cell.entry(region.cell.0).or_default() += area;
            }
            for (cell, seen) in of_cell {
                let corner = |&p: &u32| cells.graph.points.get(p).coordinates().map(|c| c / &grid);
                let polygon: Vec<Point> =
                    cells.graph.polygons[cell as usize].iter().map(corner).collect();
                assert_eq!(seen, star.doubled_area_within(&polygon), "{case}, {cone:?}, {cell}");
            }
        }
    }
    looked
}

#[test]
fn wedges_see_what_a_sweep_sees() {
    for kind in Kind::ALL {
        let looked: usize = (0..PLANS).map(|seed| compare(kind, seed)).sum();
        assert!(looked > 20, "{kind:?}: only {looked} eyes");
    }
}
