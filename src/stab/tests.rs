//! Known sequences.

use super::cone::Cone;
use super::ring::Ring;
use super::*;
use crate::geom::BigPoint3;
use crate::num::{Int, Int192, Int256, Int320, Rational};

fn portal(vertices: &[[i64; 3]]) -> Portal3 {
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

/// The same random rows of extreme size in two arithmetics.
fn widths_agree<R: Ring>(moment: u32, direction: u32) {
    assert!(R::BUDGET.unwrap() < 3 * u64::from(moment + direction) + 6, "close to the limit");
    assert!(R::BUDGET.unwrap() >= 3 * u64::from(moment + direction), "within the limit");
    let mut state = 1u64;
    let mut coin = || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        state >> 62
    };
    for _ in 0..20 {
        let (mut exact, mut fixed) = (Cone::<Int>::everything(), Cone::<R>::everything());
        for _ in 0..14 {
            let row: [Int; 6] = std::array::from_fn(|i| {
                let largest: Int = (Int::from(1) << if i < 3 { moment } else { direction }) - 1;
                match coin() {
                    0 => -largest,
                    1 => largest,
                    2 => largest - 1,
                    _ => 1 - largest,
                }
            });
            let narrow = row.each_ref().map(|c| R::narrow(c).unwrap());
            assert_eq!(exact.push(&row), fixed.push(&narrow));
            let vectors = |r: &[R; 6]| r.each_ref().map(R::to_int);
            let ints: Vec<[Int; 6]> = fixed.rays().iter().map(|r| vectors(&r.vector)).collect();
            assert!(exact.rays().iter().map(|r| &r.vector).eq(&ints));
            for pair in exact.rays().windows(2).zip(fixed.rays().windows(2)) {
                let ([a, b], [c, d]) = (pair.0, pair.1) else { unreachable!("windows of two") };
                let squares = [Int::side(&a.vector, &a.vector), Int::side(&b.vector, &b.vector)];
                let narrow = [R::side(&c.vector, &c.vector), R::side(&d.vector, &d.vector)];
                let (mixed, fixed) =
                    (Int::side(&a.vector, &b.vector), R::side(&c.vector, &d.vector));
                assert_eq!(Int::sign_of(&mixed), R::sign_of(&fixed));
                assert_eq!(
                    Int::square_exceeds(&mixed, &squares[0], &squares[1]),
                    R::square_exceeds(&fixed, &narrow[0], &narrow[1])
                );
            }
        }
    }
}

#[test]
fn every_width_holds_at_the_limit_of_its_range() {
    widths_agree::<i128>(29, 10);
    widths_agree::<Int192>(45, 15);
    widths_agree::<Int256>(54, 27);
    widths_agree::<Int320>(63, 40);
}
