//! Edges and lines in special position: pencils, reguli, and four lines with less or more
//! transversals than two.

use super::{Family, PORTALS, Parameter, Settings};
use crate::forge::input::Input;
use crate::forge::shapes::{
    SQUARE, TRIANGLE, Vector, add, cross, dot, lay_out, one_of, polygons, scale, sub, vector,
};
use crate::num::Random;
use crate::vectors::Kind;

pub(super) const PENCIL: Family = Family {
    name: "pencil",
    kind: Kind::Sequence,
    purpose: "portals whose planes, or edges, or vertices all meet one line",
    from_map: false,
    parameters: &[PORTALS],
    make: pencil,
};

pub(super) const REGULUS: Family = Family {
    name: "regulus",
    kind: Kind::Sequence,
    purpose: "portals with an edge each on lines of one ruling of z = xy, or a unit beside them: \
              the lines of the other ruling touch all of them",
    from_map: false,
    parameters: &[PORTALS, NEAR],
    make: regulus,
};

const NEAR: Parameter = Parameter {
    name: "near",
    purpose: "one in so many vertices is moved by a unit; 0 moves none",
    default: 4,
    range: [0, 1000],
};

const REACH: Parameter = Parameter {
    name: "reach",
    purpose: "the greatest coordinate",
    default: 3,
    range: [1, 1 << 40],
};

pub(super) const TRANSVERSALS: Family = Family {
    name: "transversals",
    kind: Kind::Transversals,
    purpose: "four lines that are concurrent, coplanar, parallel, equal, of one regulus, tangent to \
              the quadric of the other three, or near to any of these",
    from_map: false,
    parameters: &[REACH],
    make: transversals,
};

/// A point of the line through `p` along `d`.
fn on_line(random: &mut Random, p: Vector, d: Vector) -> Vector {
    add(p, scale(d, random.between(-2, 2)))
}

fn pencil(random: &mut Random, settings: &Settings) -> Input {
    let most = settings.get("portals");
    let count = random.between(most.min(2), most);
    let base = vector(random, 1);
    let axis = loop {
        let axis = vector(random, 2);
        if axis != [0; 3] {
            break axis;
        }
    };
    let how = random.between(0, 3);
    let portals: Vec<Vec<Vector>> = (0..count)
        .map(|_| {
            loop {
                let origin = on_line(random, base, axis);
                let (u, v) = match how {
                    // An edge on the line; a plane through it.
                    0 => (axis, vector(random, 3)),
                    1 => (scale(axis, one_of(random, &[-1, 1, 2])), vector(random, 3)),
                    // A vertex on the line; anything.
                    2 => (vector(random, 3), vector(random, 3)),
                    // The line through the inside.
                    _ => (vector(random, 3), vector(random, 3)),
                };
                let normal = cross(u, v);
                if normal == [0; 3] {
                    continue;
                }
                let origin = if how == 3 { sub(origin, add(u, v)) } else { origin };
                let (u, v) = if how == 3 { (scale(u, 2), scale(v, 2)) } else { (u, v) };
                let corners: &[[i64; 2]] = if random.one_in(2) { &SQUARE } else { &TRIANGLE };
                let along = if dot(normal, axis) == 0 { vector(random, 1) } else { axis };
                break lay_out([origin, u, v], corners, along);
            }
        })
        .collect();
    Input::Sequence(polygons(&portals))
}

/// A point of z = xy.
fn saddle(x: i64, y: i64) -> Vector {
    [x, y, x * y]
}

fn regulus(random: &mut Random, settings: &Settings) -> Input {
    let most = settings.get("portals");
    let count = random.between(most.min(3), most.max(3));
    let near = settings.get("near");
    let portals: Vec<Vec<Vector>> = (0..count)
        .map(|index| {
            loop {
                // An edge on the line y = const of the surface; stabbing lines run about along y.
                let y = 2 * index + random.between(0, 1);
                let x = random.between(-3, 1);
                let [p, q] = [saddle(x, y), saddle(x + random.between(1, 3), y)];
                let third = match random.between(0, 2) {
                    // Above or below the surface, upright.
                    0 => add(p, [0, 0, one_of(random, &[-2, -1, 1, 2])]),
                    // In the plane y = const.
                    1 => add(q, [random.between(-1, 1), 0, one_of(random, &[-3, -1, 1, 3])]),
                    _ => add(p, vector(random, 2)),
                };
                let mut corners = vec![p, q, third];
                if near > 0 {
                    for corner in &mut corners {
                        if random.one_in(near) {
                            *corner = add(*corner, vector(random, 1));
                        }
                    }
                }
                let normal = cross(sub(corners[1], corners[0]), sub(corners[2], corners[0]));
                if normal == [0; 3] {
                    continue;
                }
                if normal[1] < 0 {
                    corners.reverse();
                }
                break corners;
            }
        })
        .collect();
    Input::Sequence(polygons(&portals))
}

fn transversals(random: &mut Random, settings: &Settings) -> Input {
    let reach = settings.get("reach");
    let small = reach.min(1000);
    let how = random.between(0, 7);
    let [p, d, e] = [(); 3].map(|()| {
        loop {
            let any = vector(random, small);
            if any != [0; 3] {
                break any;
            }
        }
    });
    let mut lines: Vec<Vec<Vector>> = Vec::new();
    while lines.len() < 4 {
        let k = lines.len();
        let any = vector(random, reach);
        let few = |random: &mut Random| random.between(-2, 2);
        let [a, b] = match how {
            // Through one point; in one plane; parallel: three or four of them.
            0 if k < 3 || random.one_in(2) => [p, any],
            1 if k < 3 || random.one_in(2) => {
                let point =
                    |random: &mut Random| add(p, add(scale(d, few(random)), scale(e, few(random))));
                [point(random), point(random)]
            }
            2 if k < 3 || random.one_in(2) => [any, add(any, d)],
            // Equal to one before, its points others.
            3 if k > 0 && random.one_in(2) => {
                let line = one_of(random, &lines);
                let step = sub(line[1], line[0]);
                let start = add(line[0], scale(step, few(random)));
                [start, add(start, scale(step, one_of(random, &[-1, 1, 2])))]
            }
            // Of the ruling y = const of z = xy, all four or the first three; and then tangent to
            // it, or a unit beside the tangent.
            4 | 5 if k < 3 => {
                let y = few(random);
                [saddle(few(random), y), saddle(few(random), y)]
            }
            4 => {
                let (x, y) = (few(random), few(random));
                // The tangent plane at (x, y) holds (1, 0, y) and (0, 1, x).
                let (s, t) = (few(random), few(random));
                let along = [s, t, s * y + t * x];
                let off = if random.one_in(3) { vector(random, 1) } else { [0; 3] };
                [add(saddle(x, y), off), add(saddle(x, y), along)]
            }
            5 => {
                let y = few(random);
                let off = if random.one_in(2) { [0, 0, random.between(-1, 1)] } else { [0; 3] };
                [add(saddle(few(random), y), off), saddle(few(random), y)]
            }
            // Parallel to the axes, on few levels.
            6 => {
                let a = [(); 3].map(|()| random.between(-1, 1));
                let mut step = [0; 3];
                step[random.between(0, 2) as usize] = one_of(random, &[-1, 1]);
                [a, add(a, step)]
            }
            _ => [vector(random, reach), any],
        };
        if a != b {
            lines.push(vec![a, b]);
        }
    }
    Input::Lines(polygons(&lines))
}
