use super::*;
use crate::geom::RationalPoint3;
use crate::geom::vector::{cross, determinant, difference, dot};
use crate::num::Sign;
use crate::oracle::Random;
use crate::predicates::side_of_point;
use num_traits::Signed;
use std::collections::{BTreeMap, BTreeSet};

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
    let volume: Rational = body.cells.iter().map(Polyhedron::volume).sum();
    assert_eq!(outward / Int::from(6), volume, "the boundary encloses the cells");
    assert_eq!(body.volume(), volume);
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
    for _ in 0..100 {
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

/// Whether the expression holds a point; `None` where the point is on a brush's plane.
fn holds(expression: &Expression, point: &[Rational; 3]) -> Option<bool> {
    let any = |of: &[Expression]| of.iter().try_fold(false, |any, e| Some(any | holds(e, point)?));
    match expression {
        Expression::Brush(halves) => halves.iter().try_fold(true, |all, half| {
            let at = dot(&half.normal, point);
            (at != half.offset).then_some(all & (at < half.offset))
        }),
        Expression::Union(of) => any(of),
        Expression::Intersection(of) => {
            of.iter().try_fold(true, |all, e| Some(all & holds(e, point)?))
        }
        Expression::Difference(from, of) => Some(holds(from, point)? & !any(of)?),
        Expression::Complement(of) => Some(!holds(of, point)?),
    }
}

/// Where the body's tree has the point; on both sides of a plane through it, which is no brush's,
/// it must have it alike.
fn located(body: &Body, point: &RationalPoint3) -> Child {
    let (mut leaves, mut stack) = (Vec::new(), vec![body.tree.root]);
    while let Some(at) = stack.pop() {
        let Child::Node(node) = at else {
            leaves.push(at);
            continue;
        };
        let node = &body.tree.nodes[node as usize];
        match side_of_point(body.planes.get(node.plane), point) {
            Sign::Positive => stack.push(node.children[0]),
            Sign::Negative => stack.push(node.children[1]),
            Sign::Zero => stack.extend(node.children),
        }
    }
    assert!(leaves.windows(2).all(|pair| pair[0] == pair[1]), "{point:?}");
    leaves[0]
}

#[test]
fn random_points_are_in_the_body_iff_the_expression_holds_them() {
    let mut random = Random::new(34);
    let (mut inside, mut outside) = (0, 0);
    for _ in 0..100 {
        let a = expression(&mut random, 2);
        let body = evaluate(&a).unwrap();
        for _ in 0..40 {
            let point = [(); 3].map(|()| Rational::new(random.between(5, 44).into(), 7.into()));
            let Some(expected) = holds(&a, &point) else { continue };
            let at = RationalPoint3::from(&point);
            assert_eq!(located(&body, &at) == Child::Inside, expected, "{a:?} {at:?}");
            let is_in = |cell: &Polyhedron| {
                let behind = |face: &Polygon| side_of_point(body.planes.get(face.support()), &at);
                cell.faces().iter().all(|face| behind(face) == Sign::Negative)
            };
            let count = body.cells.iter().filter(|cell| is_in(cell)).count();
            assert_eq!(count, usize::from(expected));
            if expected { inside += 1 } else { outside += 1 }
        }
    }
    assert!(inside > 100 && outside > 100, "{inside} {outside}");
}

/// Asserts that two expressions hold the same points, but for their boundaries.
fn assert_same(a: &Expression, b: &Expression) {
    let minus = |a: &Expression, b: &Expression| {
        Expression::Difference(Box::new(a.clone()), vec![b.clone()])
    };
    let apart = evaluate(&Expression::Union(vec![minus(a, b), minus(b, a)])).unwrap();
    assert!(apart.cells.is_empty() && apart.boundary.is_empty(), "{a:?} {b:?}");
}

#[test]
fn union_and_intersection_distribute_over_each_other() {
    let mut random = Random::new(35);
    let any = |of: &[&Expression]| Expression::Union(of.iter().map(|&e| e.clone()).collect());
    let all =
        |of: &[&Expression]| Expression::Intersection(of.iter().map(|&e| e.clone()).collect());
    for _ in 0..60 {
        let [a, b, c] = [(); 3].map(|()| expression(&mut random, 1));
        assert_same(&all(&[&a, &any(&[&b, &c])]), &any(&[&all(&[&a, &b]), &all(&[&a, &c])]));
        assert_same(&any(&[&a, &all(&[&b, &c])]), &all(&[&any(&[&a, &b]), &any(&[&a, &c])]));
    }
}

/// Boxes of a lattice of side 2, so that nearly all faces coincide with others.
fn blocks(random: &mut Random, depth: u32) -> Expression {
    if depth == 0 {
        let low = [(); 3].map(|()| 2 * random.between(0, 2));
        return cuboid(low, low.map(|c| c + 2 * random.between(1, 2)));
    }
    let mut part = || blocks(random, depth - 1);
    let (a, b) = (part(), part());
    match random.between(0, 2) {
        0 => Expression::Union(vec![a, b]),
        1 => Expression::Intersection(vec![a, b]),
        _ => Expression::Difference(Box::new(a), vec![b]),
    }
}

#[test]
fn coincident_faces_neither_join_nor_divide() {
    let mut random = Random::new(36);
    for _ in 0..120 {
        let a = blocks(&mut random, 3);
        let body = evaluate(&a).unwrap();
        assert_closed(&body);
        // The blocks that the expression holds, counted by their centres.
        let is_in = |x: i64, y: i64, z: i64| holds(&a, &[x, y, z].map(rational)).unwrap();
        let centres = || (-1..=11).step_by(2);
        let (mut count, mut faces) = (0, 0);
        for (x, y, z) in centres()
            .flat_map(|x| centres().flat_map(move |y| centres().map(move |z| (x, y, z))))
            .filter(|&(x, y, z)| is_in(x, y, z))
        {
            count += 1;
            let beside = [(2, 0, 0), (-2, 0, 0), (0, 2, 0), (0, -2, 0), (0, 0, 2), (0, 0, -2)];
            let open = |&&(dx, dy, dz): &&(i64, i64, i64)| !is_in(x + dx, y + dy, z + dz);
            faces += beside.iter().filter(open).count();
        }
        assert_eq!(body.volume(), rational(8 * count), "{a:?}");
        assert_eq!(body.surface_area(), Some(rational(4 * faces as i64)), "{a:?}");
    }
}

#[test]
fn isometries_keep_the_surface() {
    let mut random = Random::new(37);
    let fifth = |c: i64| Rational::new(c.into(), 5.into());
    // A rotation by an angle of the triangle 3, 4, 5, and a mirror image of another.
    let turned = [[3, -4, 0], [4, 3, 0], [0, 0, 5]].map(|row| row.map(fifth));
    let mirrored = [[0, 5, 0], [3, 0, 4], [4, 0, -3]].map(|row| row.map(fifth));
    for _ in 0..60 {
        let a = blocks(&mut random, 2);
        let area = evaluate(&a).unwrap().surface_area();
        assert!(area.is_some());
        for matrix in [&turned, &mirrored] {
            let shift = [(); 3].map(|()| fifth(random.between(-9, 9)));
            let map = Transform { matrix: matrix.clone(), shift };
            let image = evaluate(&a.transformed(&map)).unwrap();
            assert_closed(&image);
            assert_eq!(image.surface_area(), area, "{a:?} {map:?}");
            let twice = a.transformed(&map).transformed(&map);
            assert_same(&a.transformed(&map.after(&map)), &twice);
        }
    }
}

/// The hull's planes by all triples of points, for [`hull`].
fn hull_by_triples(points: &[[Rational; 3]]) -> BTreeSet<[Rational; 4]> {
    let mut planes = BTreeSet::new();
    for a in points {
        for b in points {
            for c in points {
                let normal = cross(&difference(b, a), &difference(c, a));
                let offset = dot(&normal, a);
                let is_flat = normal.iter().all(|c| *c == rational(0));
                if !is_flat && points.iter().all(|p| dot(&normal, p) <= offset) {
                    planes.insert(scaled(&Half { normal, offset }));
                }
            }
        }
    }
    planes
}

/// A half-space with its leading coefficient one in magnitude.
fn scaled(half: &Half) -> [Rational; 4] {
    let leading = half.normal.iter().find(|c| **c != rational(0)).unwrap().abs();
    let [a, b, c] = half.normal.each_ref().map(|c| c / &leading);
    [a, b, c, &half.offset / &leading]
}

#[test]
fn hulls_are_those_of_all_triples() {
    let mut random = Random::new(38);
    let mut flat = 0;
    for round in 0..200 {
        // On so small a grid many points coincide, or share lines and planes.
        let size = if round % 2 == 0 { 1 } else { 3 };
        let points: Vec<_> = (0..random.between(1, 12))
            .map(|_| [(); 3].map(|()| Rational::new(random.between(0, size).into(), 3.into())))
            .collect();
        let all = hull_by_triples(&points);
        match hull(&points) {
            Ok(halves) => {
                let planes: BTreeSet<_> = halves.iter().map(scaled).collect();
                assert_eq!(planes.len(), halves.len());
                assert_eq!(planes, all, "{points:?}");
            }
            Err(error) => {
                assert_eq!(error, BrushError::Flat);
                // All in one plane, or on a line.
                assert!(all.len() <= 2, "{points:?}");
                flat += 1;
            }
        }
    }
    assert!(flat > 10);
}

#[test]
fn round_brushes_are_on_their_grid_and_near_their_size() {
    let heights = [rational(0), rational(2)];
    let zero = || rational(0);
    // An octagon at half units around (1/3, 0): offsets 10, and 7 for 7.07.
    let third = Rational::new(1.into(), 3.into());
    let halves = cylinder(&[third.clone(), zero()], &rational(10), &heights, 8, &Int::from(2));
    let eight = evaluate(&Expression::Brush(halves.unwrap())).unwrap();
    assert_eq!(eight.volume(), rational(2 * 2 * 10 * 14));
    let corner = RationalPoint3::from(&[&third + rational(7), rational(-7), zero()]);
    assert!(eight.boundary.iter().any(|face| face.points().contains(&corner)));
    let halves = sphere(&[zero(), zero(), zero()], &rational(10), 16, &Int::from(100));
    let ball = Expression::Brush(halves.unwrap());
    let volume = volume(&ball);
    // Of 4189 a hull of 16 meridians has a little less.
    assert!(volume > rational(3900) && volume < rational(4189), "{volume}");
    let mirror = Transform::identity().matrix.map(|row| row.map(|c| -c));
    assert_same(&ball, &ball.transformed(&Transform { matrix: mirror, ..Transform::identity() }));
    let refused =
        |sides, radius| sphere(&[zero(), zero(), zero()], &rational(radius), sides, &1.into());
    assert_eq!(refused(8, 0), Err(BrushError::Radius));
    assert!(matches!(refused(5, 1), Err(BrushError::Sides { even: true, got: 5, .. })));
}

#[test]
fn pyramids_and_wedges_have_their_volumes() {
    let square = [[0, 0], [0, 3], [3, 3], [3, 0]].map(|p| p.map(rational));
    let of = |halves: Result<Vec<Half>, BrushError>| volume(&Expression::Brush(halves.unwrap()));
    for apex in [4, -2] {
        let pyramid = pyramid(&square, &rational(1), &[rational(7), rational(1), rational(apex)]);
        assert_eq!(of(pyramid), rational(3 * (apex - 1).abs()));
    }
    assert_eq!(of(wedge(&[0, 0, 1].map(rational), &[3, 2, 5].map(rational))), rational(12));
    assert_eq!(of(prism(&square, &[2, 4].map(rational))), rational(18));
    let star = [[0, 0], [2, 0], [0, 2], [1, -1], [2, 2]].map(|p| p.map(rational));
    assert_eq!(prism(&star, &[2, 4].map(rational)), Err(BrushError::NotConvex));
    let line = [[0, 0], [2, 2], [1, 1]].map(|p| p.map(rational));
    assert_eq!(prism(&line, &[2, 4].map(rational)), Err(BrushError::Flat));
}
