//! Known sequences.

use super::*;
use crate::geom::BigPoint3;
use crate::num::{Int, Rational};

pub(super) fn portal(vertices: &[[i64; 3]]) -> Portal3 {
    let points: Vec<_> =
        vertices.iter().map(|v| BigPoint3 { coordinates: v.map(Int::from) }).collect();
    Portal3::new(&points).unwrap()
}

/// A square or rectangle at height z, crossed upwards.
fn window(x: [i64; 2], y: [i64; 2], z: i64) -> Portal3 {
    portal(&[[x[0], y[0], z], [x[1], y[0], z], [x[1], y[1], z], [x[0], y[1], z]])
}

fn open(portals: &[Portal3]) -> Option<Witness> {
    let refs: Vec<&Portal3> = portals.iter().collect();
    let witness = decide_open(&refs, &[]);
    let reversed: Vec<Portal3> = portals.iter().rev().map(Portal3::reversed).collect();
    let refs: Vec<&Portal3> = reversed.iter().collect();
    let mut back = decide_open(&refs, &[]);
    if let Some(line) = &mut back {
        line.points.reverse();
    }
    assert_eq!(witness, back, "the reversed sequence has the reversed witness");
    witness
}

#[test]
fn one_portal_is_open() {
    let w = open(&[window([0, 4], [0, 4], 0)]).unwrap();
    assert_ne!(w.points[0], w.points[1]);
}

#[test]
fn half_wall_is_open() {
    let wall = window([0, 4], [-4, 4], 2);
    let witness = open(&[window([-1, 1], [-1, 1], 0), wall, window([-1, 1], [-1, 1], 4)]);
    assert!(witness.is_some());
}

#[test]
fn windows_out_of_line_are_not_open() {
    let far = window([10, 12], [0, 2], 2);
    assert_eq!(open(&[window([0, 2], [0, 2], 0), far, window([0, 2], [0, 2], 4)]), None);
}

#[test]
fn slits_are_open_down_to_any_width() {
    let half = |v: i64| Int::from(v);
    for digits in 1..=20u32 {
        let unit = Int::from(10).pow(digits);
        let p = |x: Int, y: Int, z: Int| BigPoint3 { coordinates: [x, y, z] };
        // A slit along x at z = 0, one along y at z = 1, a third along the diagonal at z = 2.
        let far: Int = &unit * 8;
        let first = [
            p(-&far, half(0), half(0)),
            p(far.clone(), half(0), half(0)),
            p(far.clone(), half(1), half(0)),
            p(-&far, half(1), half(0)),
        ];
        let z = unit.clone();
        let second = [
            p(half(0), -&far, z.clone()),
            p(half(1), -&far, z.clone()),
            p(half(1), far.clone(), z.clone()),
            p(half(0), far.clone(), z.clone()),
        ];
        let z: Int = &unit * 2;
        let third = [
            p(-&far, -&far, z.clone()),
            p(-&far + 1, -&far, z.clone()),
            p(far.clone() + 1, far.clone(), z.clone()),
            p(far.clone(), far.clone(), z.clone()),
        ];
        let portals: Vec<Portal3> =
            [first, second, third].iter().map(|v| Portal3::new(v).unwrap()).collect();
        assert!(open(&portals).is_some(), "width 1e-{digits}");
    }
}

#[test]
fn weak_signs_alone_are_not_enough() {
    let first = portal(&[[0, 0, 0], [1, 0, 0], [0, 1, 0]]);
    let second = portal(&[[0, 0, 1], [0, 1, 1], [1, 0, 1]]);
    assert_eq!(open(&[first, second]), None);
}

#[test]
fn witnesses_of_integer_sequences_are_small() {
    let one = window([0, 4], [0, 4], 0);
    let two = portal(&[[9, 0, 0], [9, 4, 0], [9, 4, 4], [9, 0, 4]]);
    let w = open(&[one, two]).unwrap();
    for c in w.points.iter().flatten() {
        assert!(c.denom() <= &Int::from(2), "{w:?}");
    }
    assert!(w.points[0][2] < Rational::from(Int::from(4)));
}
