//! Parallel portals, huge and tiny coordinates, and portals a unit from grazing.

use super::{Family, PORTALS, Parameter, Settings};
use crate::forge::input::{Input, Point};
use crate::forge::shapes::{
    SQUARE, TRIANGLE, Vector, across, add, cross, lay_out, one_of, polygons, scale, sub, vector,
    whole,
};
use crate::num::{Int, Random, Rational};
use crate::vectors::Kind;

pub(super) const PARALLEL: Family = Family {
    name: "parallel",
    kind: Kind::Sequence,
    purpose: "parallel planes, parallel edges, all of them or all but one: the planes' common line \
              is at infinity",
    from_map: false,
    parameters: &[PORTALS],
    make: parallel,
};

pub(super) const MAGNITUDE: Family = Family {
    name: "magnitude",
    kind: Kind::Sequence,
    purpose: "small portals scaled to huge or tiny coordinates and moved far from the origin, by \
              powers of two and of ten, thirds, and the metres of an inch",
    from_map: false,
    parameters: &[
        PORTALS,
        Parameter {
            name: "bits",
            purpose: "the most bits of a scale or of a distance",
            default: 70,
            range: [1, 1000],
        },
    ],
    make: magnitude,
};

pub(super) const NEAR: Family = Family {
    name: "near",
    kind: Kind::Sequence,
    purpose: "portals that one line touches with an edge or a vertex each, one vertex then moved by \
              a unit: nearly open and nearly blocked",
    from_map: false,
    parameters: &[
        PORTALS,
        Parameter {
            name: "size",
            purpose: "how many units large a portal is, about",
            default: 1000,
            range: [2, 1 << 36],
        },
    ],
    make: near,
};

fn count(random: &mut Random, settings: &Settings) -> i64 {
    let most = settings.get("portals");
    random.between(most.min(2), most)
}

fn parallel(random: &mut Random, settings: &Settings) -> Input {
    let count = count(random, settings);
    let (u, v) = loop {
        let (u, v) = (vector(random, 2), vector(random, 2));
        if cross(u, v)[1] != 0 {
            break (u, v);
        }
    };
    let odd = random.between(0, 2 * count);
    let portals: Vec<Vec<Vector>> = (0..count)
        .map(|index| {
            let origin = add(vector(random, 2), [0, 2 * index, 0]);
            let [i, j] = [(); 2].map(|()| random.between(1, 2));
            let [u, v] = match index == odd {
                true => [u, add(v, [0, one_of(random, &[-1, 1]), 0])],
                false => [scale(u, i), scale(v, j)],
            };
            let corners: &[[i64; 2]] = if random.one_in(3) { &TRIANGLE } else { &SQUARE };
            lay_out([origin, u, v], corners, [0, 1, 0])
        })
        .filter(|portal| cross(sub(portal[1], portal[0]), sub(portal[2], portal[0])) != [0; 3])
        .collect();
    Input::Sequence(polygons(&portals))
}

fn magnitude(random: &mut Random, settings: &Settings) -> Input {
    let count = count(random, settings);
    let portals: Vec<Vec<Vector>> = (0..count).map(|index| across(random, index, 2)).collect();
    let bits = settings.get("bits");
    let power = |random: &mut Random, base: i64, most: i64| {
        Int::from(base).pow(random.between(0, most) as u32)
    };
    let factor = match random.between(0, 5) {
        0 => Rational::from(power(random, 2, bits)),
        1 => Rational::new(Int::from(1), power(random, 2, bits)),
        2 => Rational::new(Int::from(1), power(random, 10, bits / 3)),
        3 => Rational::new(Int::from(127), Int::from(5000)),
        4 => Rational::new(Int::from(1), power(random, 3, bits / 2)),
        // A unit short of a power of two, as the widths of integers end.
        _ => Rational::from(power(random, 2, bits) + Int::from(random.between(0, 2))),
    };
    let far = [(); 3].map(|()| match random.between(0, 3) {
        0 => whole(0),
        1 => Rational::from(power(random, 2, bits)),
        2 => -Rational::from(power(random, 2, bits)) + whole(1),
        _ => Rational::new(Int::from(random.between(-99, 99)), Int::from(100)),
    });
    let input = Input::Sequence(polygons(&portals));
    input.mapped(|p: &Point| (0..3).map(|i| &p[i] * &factor + &far[i]).collect())
}

fn wide_cross(a: Vector, b: Vector) -> [i128; 3] {
    let [a, b] = [a, b].map(|v| v.map(i128::from));
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| a[i] * b[j] - a[j] * b[i])
}

fn wide_dot(a: [i128; 3], b: Vector) -> i128 {
    a.iter().zip(b).map(|(&a, b)| a * i128::from(b)).sum()
}

fn near(random: &mut Random, settings: &Settings) -> Input {
    let most = settings.get("portals");
    let count = random.between(most.min(3), most.max(3));
    let size = settings.get("size");
    let step = vector(random, 2);
    let line = add(scale(step, size), [0, 3 * size, 0]);
    // Half of the time all edges have one direction, their portals on alternate sides of the line:
    // then three of them leave the line no way.
    let common = vector(random, size);
    let across = wide_cross(common, line);
    let is_flat = random.one_in(2) && across != [0; 3];
    let mut portals: Vec<Vec<Vector>> = (0..count)
        .map(|index| {
            loop {
                let on_line = scale(line, index);
                let arm = if is_flat { common } else { vector(random, size) };
                let mut other = vector(random, size);
                let side = wide_dot(across, other);
                if is_flat && (side > 0) != (index % 2 == 0) {
                    other = scale(other, -1);
                }
                let corners = match if is_flat { 1 } else { random.between(0, 2) } {
                    // A vertex on the line.
                    0 => vec![on_line, add(on_line, arm), add(on_line, other)],
                    // An edge across it.
                    1 => vec![sub(on_line, arm), add(on_line, arm), add(on_line, other)],
                    _ => vec![sub(on_line, arm), add(on_line, scale(arm, 2)), add(on_line, other)],
                };
                let normal = wide_cross(sub(corners[1], corners[0]), sub(corners[2], corners[0]));
                match wide_dot(normal, line) {
                    0 => continue,
                    1.. => break corners,
                    _ => break corners.into_iter().rev().collect(),
                }
            }
        })
        .collect();
    if !random.one_in(4) {
        let portal = random.between(0, count - 1) as usize;
        let vertex = random.between(0, 2) as usize;
        let moved = add(portals[portal][vertex], vector(random, 1));
        portals[portal][vertex] = moved;
    }
    portals.retain(|p| wide_cross(sub(p[1], p[0]), sub(p[2], p[0])) != [0; 3]);
    Input::Sequence(polygons(&portals))
}
