use super::*;
use crate::geom::RationalPoint3;
use crate::geom::vector::determinant;
use crate::oracle::Random;
use std::collections::BTreeMap;

fn rational(value: i64) -> Rational {
    Rational::from(Int::from(value))
}

fn cuboid(low: [i64; 3], high: [i64; 3]) -> Expression {
    Expression::Brush(super::cuboid(&low.map(rational), &high.map(rational)).unwrap())
}

/// A brush on a small grid, where faces coincide and edges meet: a box, or the hull of points.
fn brush(random: &mut Random) -> Expression {
    loop {
        let low = [(); 3].map(|()| random.between(0, 4));
        if random.between(0, 1) == 0 {
            return cuboid(low, low.map(|c| c + random.between(1, 4)));
        }
        let points: Vec<_> =
            (0..5).map(|_| low.map(|c| rational(c + random.between(0, 4)))).collect();
        if let Ok(halves) = hull(&points) {
            return Expression::Brush(halves);
        }
    }
}

fn expression(random: &mut Random, depth: u32) -> Expression {
    if depth == 0 {
        return brush(random);
    }
    let mut part = || expression(random, depth - 1);
    let (a, b) = (part(), part());
    match random.between(0, 2) {
        0 => Expression::Union(vec![a, b]),
        1 => Expression::Intersection(vec![a, b]),
        _ => Expression::Difference(Box::new(a), vec![b]),
    }
}

fn volume(expression: &Expression) -> Rational {
    let body = evaluate(expression).unwrap();
    assert_closed(&body);
    let outward: Rational = body.boundary.iter().map(six_volumes_over_origin).sum();
    let volume = body.volume();
    assert_eq!(outward / Int::from(6), volume, "the boundary encloses the cells");
    volume
}

fn six_volumes_over_origin(face: &Polygon) -> Rational {
    let p: Vec<_> = face.points().iter().map(RationalPoint3::coordinates).collect();
    p[1..].windows(2).map(|pair| determinant([&p[0], &pair[0], &pair[1]])).sum()
}

/// On every line, the edges in one direction cover what those in the other do.
fn assert_closed(body: &Body) {
    type Line = [Rational; 6];
    let mut steps: BTreeMap<Line, BTreeMap<Rational, i64>> = BTreeMap::new();
    for face in &body.boundary {
        let points: Vec<_> = face.points().iter().map(RationalPoint3::coordinates).collect();
        for (i, p) in points.iter().enumerate() {
            let q = &points[(i + 1) % points.len()];
            let mut d: [Rational; 3] = std::array::from_fn(|k| &q[k] - &p[k]);
            let axis = (0..3).find(|&k| d[k] != rational(0)).unwrap();
            let scale = d[axis].clone();
            d = d.map(|c| c / &scale);
            // Where the line meets the plane on which its leading coordinate is zero.
            let foot: [Rational; 3] = std::array::from_fn(|k| &p[k] - &p[axis] * &d[k]);
            let [a, b, c] = d;
            let [x, y, z] = foot;
            let line = steps.entry([a, b, c, x, y, z]).or_default();
            *line.entry(p[axis].clone()).or_default() += 1;
            *line.entry(q[axis].clone()).or_default() -= 1;
        }
    }
    assert!(steps.values().all(|line| line.values().all(|&sum| sum == 0)), "an edge is unmatched");
}

#[test]
fn volumes_of_union_and_intersection_add_up_to_those_of_both() {
    let mut random = Random::new(31);
    for _ in 0..60 {
        let (a, b) = (expression(&mut random, 1), expression(&mut random, 1));
        let both = vec![a.clone(), b.clone()];
        let union = volume(&Expression::Union(both.clone()));
        let intersection = volume(&Expression::Intersection(both));
        let difference = volume(&Expression::Difference(Box::new(a.clone()), vec![b.clone()]));
        assert_eq!(&union + &intersection, volume(&a) + volume(&b), "{a:?} {b:?}");
        assert_eq!(difference + intersection, volume(&a), "{a:?} {b:?}");
    }
}

#[test]
fn de_morgan_absorption_and_nothing() {
    let mut random = Random::new(32);
    let world = || cuboid([-9; 3], [20; 3]);
    let not = |e: Expression| Expression::Complement(Box::new(e));
    for _ in 0..30 {
        let (a, b) = (expression(&mut random, 1), expression(&mut random, 1));
        let neither = Expression::Intersection(vec![world(), not(a.clone()), not(b.clone())]);
        let union = Expression::Union(vec![a.clone(), b.clone()]);
        let de_morgan = Expression::Intersection(vec![world(), not(union.clone())]);
        assert_eq!(volume(&neither), volume(&de_morgan));
        let absorbed = Expression::Intersection(vec![a.clone(), union]);
        let same = Expression::Difference(Box::new(absorbed.clone()), vec![a.clone()]);
        assert_eq!(volume(&absorbed), volume(&a));
        assert_eq!(volume(&same), rational(0));
        assert!(evaluate(&same).unwrap().boundary.is_empty(), "{a:?}");
    }
}

#[test]
fn affine_maps_scale_volumes_by_their_determinant() {
    let mut random = Random::new(33);
    for _ in 0..30 {
        let a = expression(&mut random, 2);
        let entry = |random: &mut Random| Rational::new(random.between(-5, 5).into(), 3.into());
        let matrix = [(); 3].map(|()| [(); 3].map(|()| entry(&mut random)));
        let map = Transform { matrix, shift: [(); 3].map(|()| entry(&mut random)) };
        if map.is_invertible() {
            let scale = map.scale();
            let size = if scale < rational(0) { -scale } else { scale };
            assert_eq!(volume(&a.transformed(&map)), volume(&a) * size, "{a:?} {map:?}");
        }
    }
}

#[test]
fn a_frame_of_boxes_has_the_area_of_its_faces() {
    let frame = Expression::Difference(
        Box::new(cuboid([0; 3], [4, 4, 1])),
        vec![cuboid([1, 1, -1], [3, 3, 2])],
    );
    let body = evaluate(&frame).unwrap();
    assert_eq!(body.volume(), rational(12));
    assert_eq!(body.surface_area(), Some(rational(2 * 12 + 16 + 8)));
}

#[test]
fn what_is_unbounded_or_flat_is_named() {
    let unit = || cuboid([0; 3], [1; 3]);
    let complement = Expression::Complement(Box::new(unit()));
    assert_eq!(evaluate(&complement).unwrap_err(), CsgError::Unbounded);
    let half = Half { normal: [1, 0, 0].map(rational), offset: rational(1) };
    let open = Expression::Union(vec![unit(), Expression::Brush(vec![half])]);
    assert_eq!(evaluate(&open).unwrap_err(), CsgError::UnboundedBrush { brush: 1 });
    let mut halves = super::cuboid(&[2; 3].map(rational), &[3; 3].map(rational)).unwrap();
    halves.push(Half { normal: [0, 0, 1].map(rational), offset: rational(2) });
    let flat = Expression::Union(vec![unit(), Expression::Brush(halves)]);
    assert_eq!(evaluate(&flat).unwrap().flat, [1]);
}
