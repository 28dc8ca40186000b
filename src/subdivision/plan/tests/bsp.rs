//! The BSP tree of segments of any direction.

use super::laws::check_laws;
use super::*;

fn check(segments: &[Ends]) -> PlanTree {
    let plan = plan(segments);
    let tree = divide(&plan, &PlanMethod::Bsp, &Silent).unwrap();
    assert!(tree.left_inside.is_empty());
    check_laws(&plan, &tree);
    tree
}

#[test]
fn random_segments_are_divided() {
    let mut meets = 0;
    for seed in 0..48 {
        let random = &mut Random::new(seed);
        let reach = [3, 10, 1000][seed as usize % 3];
        let mut end = || [random.between(0, reach), random.between(0, reach)];
        let mut segments: Vec<Ends> = (0..2 + seed % 14).map(|_| [end(), end()]).collect();
        segments.push([[0, 0], [reach, 1]]);
        let tree = check(&segments);
        let is_meet = |point: u32| tree.points.get(point).small_integers().is_none();
        meets += (0..tree.points.len() as u32).filter(|&point| is_meet(point)).count();
    }
    assert!(meets > 400, "{meets}");
}

#[test]
fn axial_plans_are_divided_as_well() {
    for seed in 0..16 {
        check(&axial(&mut Random::new(seed), 25, 8));
    }
}

#[test]
fn stars_have_one_centre() {
    let mut star: Vec<Ends> = Vec::new();
    for k in -6..=6i64 {
        // From (-20, -k) to (21, k + 1): the middle is (1/2, 1/2).
        star.push([[-20, -k], [21, k + 1]]);
        star.push([[-k, 21], [k + 1, -20]]);
    }
    let tree = check(&star);
    let half = Rational::new(1.into(), 2.into());
    let centre = PlanPoint::from_coordinates(&[half.clone(), half]);
    let centre = tree.points.find(&centre).expect("all lines meet there");
    let around = tree.leaves.iter().filter(|leaf| leaf.polygon.contains(&centre)).count();
    assert_eq!(around, 2 * star.len());
}

#[test]
fn slivers_between_lines_almost_parallel_are_cells() {
    let far = 1 << 28;
    let fan: Vec<Ends> = (0..12).map(|k| [[0, 0], [far, k]]).collect();
    assert_eq!(check(&fan).leaves.len(), 12);
    // They cross within a unit's 2^-28.
    let crossing: Vec<Ends> = (0..8).map(|k| [[0, k], [far, 7 - k]]).collect();
    check(&crossing);
}

#[test]
fn overlapping_and_far_segments_are_divided() {
    let walls = [[[0, 0], [9, 6]], [[3, 2], [12, 8]], [[12, 8], [3, 2]], [[0, 8], [12, 0]]];
    let near = check(&walls);
    let far = walls.map(|ends| ends.map(|[x, y]| [x + (1 << 58), y - (1 << 58)]));
    let away = check(&far);
    assert_eq!(near.leaves.len(), away.leaves.len());
    assert_eq!(near.nodes, away.nodes);
}

#[test]
fn a_plan_without_an_inside_is_one_leaf() {
    let square = [[[0, 0], [4, 0]], [[4, 0], [4, 4]], [[4, 4], [0, 4]], [[0, 4], [0, 0]]];
    assert_eq!(check(&square).leaves.len(), 1);
    assert_eq!(check(&[[[0, 0], [4, 0]]]).leaves.len(), 2);
}
