use super::*;
use crate::scene::plan::Plan;

fn made(faces: usize, seed: u64, is_general: bool) -> Vec<[[i64; 2]; 2]> {
    let raw = generate_floorplan(&FloorplanOptions { faces, seed, is_general });
    let plan = Plan::from_raw(&raw).unwrap();
    assert!(plan.repairs.zero_length.is_empty());
    let integers = |end: u32| plan.points.get(end).small_integers().unwrap();
    plan.segments.iter().map(|segment| segment.ends.map(integers)).collect()
}

fn is_axial([p, q]: &[[i64; 2]; 2]) -> bool {
    p[0] == q[0] || p[1] == q[1]
}

#[test]
fn as_many_faces_are_made_as_are_asked_for() {
    for faces in [16, 17, 60, 333, 1000, 1001, 8000] {
        for seed in 0..4 {
            assert_eq!(made(faces, seed, false).len(), faces, "seed {seed}");
            assert_eq!(made(faces, seed, true).len(), faces, "seed {seed}");
        }
    }
}

#[test]
fn a_plan_is_a_function_of_its_options() {
    assert_eq!(made(500, 7, false), made(500, 7, false));
    assert_ne!(made(500, 7, false), made(500, 8, false));
}

#[test]
fn general_plans_have_walls_of_many_directions() {
    assert!(made(1000, 1, false).iter().all(is_axial));
    let general = made(1000, 1, true);
    let turned = |[p, q]: &[[i64; 2]; 2]| {
        let [x, y] = [q[0] - p[0], q[1] - p[1]];
        4 * x + 3 * y == 0 || 3 * x == 4 * y
    };
    // A screen may run along an axis by chance; a wall may not, once the whole is turned.
    assert!(!general.iter().any(|ends| is_axial(ends) && turned(ends)));
    assert!(general.iter().filter(|ends| is_axial(ends)).count() < 20);
    let oblique = general.iter().filter(|ends| !turned(ends)).count();
    assert!((150..=200).contains(&oblique), "{oblique}");
}

#[test]
fn axial_walls_meet_in_no_more_than_an_end() {
    // They touch and never cross: each room is divided by walls that end at its sides.
    let walls = made(300, 2, false);
    for (i, a) in walls.iter().enumerate() {
        for b in &walls[..i] {
            let crosses = |d: usize, a: &[[i64; 2]; 2], b: &[[i64; 2]; 2]| {
                let within = |at: i64, ends: &[[i64; 2]; 2], d: usize| {
                    let [p, q] = ends.map(|end| end[d]);
                    p.min(q) < at && at < p.max(q)
                };
                within(a[0][d], b, d) && within(b[0][1 - d], a, 1 - d)
            };
            assert!(!crosses(0, a, b) && !crosses(1, a, b), "{a:?} {b:?}");
        }
    }
}
