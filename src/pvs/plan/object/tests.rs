use super::super::stab_tree::tests::{flat, walls};
use super::super::tests::{cells, plan};
use super::*;
use crate::num::Rational;
use crate::oracle::{Random, flat_seers};
use crate::report::Silent;

/// Triangles and rectangles among walls of the same grid; their corners lie on walls or halfway.
fn object(random: &mut Random, index: usize) -> PlanObject {
    loop {
        let mut corner = || [(); 2].map(|()| random.between(0, 8));
        let [a, b, c] = [corner(), corner(), corner()];
        let corners = match index % 2 {
            0 => vec![a, b, c],
            _ => vec![a, [b[0], a[1]], b, [a[0], b[1]]],
        };
        let mut polygon: Vec<PlanPoint> = corners
            .iter()
            .map(|[x, y]| PlanPoint::new([(*x).into(), (*y).into(), [2, 3][index / 2 % 2].into()]))
            .collect();
        match turn_of_points(&polygon[0], &polygon[1], &polygon[2]) {
            Sign::Positive => {}
            Sign::Negative => polygon.reverse(),
            // No inside.
            Sign::Zero => continue,
        }
        return PlanObject { name: index.to_string(), polygon };
    }
}

#[test]
fn cells_see_the_objects_that_the_twin_sees() {
    let mut random = Random::new(41);
    let mut counts = [0; 3];
    for round in 0..100 {
        let walls = walls(&mut random, round);
        let graph = cells(&plan(&walls)).graph;
        if graph.cells.len() > 12 {
            continue;
        }
        let objects: Vec<PlanObject> = (0..2).map(|i| object(&mut random, round + i)).collect();
        let crossings = graph.crossings();
        let found = plan_object_sights(&graph, &crossings, &objects, true, &Silent).unwrap();
        check_sights(&graph, &objects, &found);
        for (index, object) in objects.iter().enumerate() {
            let polygon: Vec<_> = object.polygon.iter().map(PlanPoint::coordinates).collect();
            let seers = flat_seers(&flat(&graph), &polygon);
            for (cell, &expected) in seers.iter().enumerate() {
                let is_held = found.held_by[index].contains(&CellId(cell as u32));
                let verdict = found.verdicts[index][cell];
                counts[if is_held { 2 } else { usize::from(expected) }] += 1;
                let label = format!("{cell} and {polygon:?} among {walls:?}");
                assert_eq!(verdict == Verdict::Open, expected, "{label}");
            }
        }
    }
    assert!(counts.iter().all(|&count| count > 60), "{counts:?}");
}

/// Each sight's line crosses its portals from its cell on and then the object's inside, in a cell
/// that holds a part of it.
fn check_sights(graph: &PlanGraph, objects: &[PlanObject], found: &PlanObjectSights) {
    let grid = Rational::from(graph.grid.clone());
    let mut open = found.held_by.iter().map(Vec::len).sum::<usize>();
    for sight in &found.sights {
        open += 1;
        let held_by = &found.held_by[sight.object as usize];
        let [from, to] = sight.line.each_ref().map(|point| {
            PlanPoint::from_coordinates(&point.each_ref().map(|c| c.to_rational() * &grid))
        });
        let side = |point: &PlanPoint| turn_of_points(&from, &to, point);
        let mut cell = sight.cell;
        for &portal in &sight.portals {
            let portal = graph.portals[portal as usize];
            assert!([portal.from, portal.to].contains(&cell));
            let [left, right, next] = match portal.from == cell {
                true => [portal.left, portal.right, portal.to.0],
                false => [portal.right, portal.left, portal.from.0],
            };
            let sides = [left, right].map(|end| side(graph.points.get(end)));
            assert_eq!(sides, [Sign::Positive, Sign::Negative]);
            cell = CellId(next);
        }
        assert!(held_by.contains(&cell) && !held_by.contains(&sight.cell));
        let piece = pieces(graph, objects, sight.object as usize);
        let piece = piece.iter().find(|piece| piece.cell == cell).unwrap();
        let sides: Vec<Sign> = piece.polygon.iter().map(side).collect();
        assert!(sides.contains(&Sign::Positive) && sides.contains(&Sign::Negative));
    }
    let verdicts = found.verdicts.iter().flatten();
    assert_eq!(open, verdicts.filter(|verdict| **verdict == Verdict::Open).count());
    let places: Vec<_> = found.sights.iter().map(|sight| (sight.object, sight.cell)).collect();
    assert!(places.is_sorted());
}
