//! Scenes of polygons, solids and segments, and two regions.

use super::{Family, Parameter, Settings};
use crate::forge::input::{Input, Polygon, Scene, box_corners};
use crate::forge::shapes::{Vector, add, one_of, polygon, scale};
use crate::num::Random;
use crate::vectors::Kind;

const OCCLUDERS: Parameter =
    Parameter { name: "occluders", purpose: "the most occluders", default: 3, range: [1, 20] };

pub(super) const WALLS: Family = Family {
    name: "walls",
    kind: Kind::Scene,
    purpose: "polygons in few planes: coincident, coplanar and overlapping, edge to edge, ending in \
              a T on another, with gaps of one unit, between two boxes",
    from_map: false,
    parameters: &[OCCLUDERS],
    make: walls,
};

pub(super) const BLOCKS: Family = Family {
    name: "blocks",
    kind: Kind::Scene,
    purpose: "solids with coincident faces, touching in an edge or in a corner, one in the other, \
              between two boxes",
    from_map: false,
    parameters: &[Parameter { default: 2, ..OCCLUDERS }],
    make: blocks,
};

pub(super) const PLAN: Family = Family {
    name: "plan",
    kind: Kind::Scene,
    purpose: "segments in the plane that overlap, cross, end on each other, or leave one unit \
              between them, between two regions",
    from_map: false,
    parameters: &[Parameter { default: 5, ..OCCLUDERS }],
    make: plan,
};

/// A box of whole coordinates by two corners.
fn small_box(random: &mut Random, low: Vector, most: i64) -> Polygon {
    let size = [(); 3].map(|()| random.between(1, most));
    polygon(&[low, add(low, size)])
}

/// The two boxes, left and right of what is between x = 1 and x = 5.
fn ends(random: &mut Random) -> [Polygon; 2] {
    let [y, z] = [(); 2].map(|()| random.between(0, 2));
    let from = small_box(random, [-1, y, z], 1);
    let [y, z] = [(); 2].map(|()| random.between(0, 2));
    [from, small_box(random, [6, y, z], 1)]
}

fn walls(random: &mut Random, settings: &Settings) -> Input {
    let [from, to] = ends(random);
    let count = random.between(1, settings.get("occluders"));
    let mut polygons: Vec<Vec<Vector>> = Vec::new();
    for _ in 0..count {
        let fresh = |random: &mut Random| {
            let x = random.between(1, 5);
            let [y, z] = [(); 2].map(|()| random.between(-1, 3));
            let lean = if random.one_in(3) { random.between(-1, 1) } else { 0 };
            let (u, v) = ([lean, random.between(1, 4), 0], [0, 0, random.between(1, 4)]);
            let origin = [x, y, z];
            vec![origin, add(origin, u), add(add(origin, u), v), add(origin, v)]
        };
        let mut next = fresh(random);
        if let Some(last) = polygons.last() {
            let (u, v) = (edge(last, 0), edge(last, 3));
            let v = scale(v, -1);
            match random.between(0, 6) {
                0 => next = last.clone(),
                // Beside it, edge to edge or with a part in common, or over it.
                1 => next = last.iter().map(|&p| add(p, u)).collect(),
                2 => {
                    let step = [0, random.between(0, 1), 1];
                    next = last.iter().map(|&p| add(p, step)).collect();
                }
                3 => next = last.iter().map(|&p| add(p, v)).collect(),
                // A wall that ends on it in a T.
                4 => {
                    let p = last[0];
                    let q = add(p, [one_of(random, &[-2, 2]), random.between(0, 1), 0]);
                    next = vec![p, q, add(q, v), add(p, v)];
                }
                _ => {}
            }
        }
        polygons.push(next);
    }
    for corners in &mut polygons {
        if random.one_in(5) {
            corners.remove(random.between(0, 3) as usize);
        }
    }
    let polygons = polygons.iter().map(|vertices| polygon(vertices)).collect();
    Input::Scene(Scene { polygons, brushes: Vec::new(), from, to })
}

fn edge(polygon: &[Vector], index: usize) -> Vector {
    let (p, q) = (polygon[index % polygon.len()], polygon[(index + 1) % polygon.len()]);
    [q[0] - p[0], q[1] - p[1], q[2] - p[2]]
}

fn blocks(random: &mut Random, settings: &Settings) -> Input {
    let [from, to] = ends(random);
    let count = random.between(1, settings.get("occluders"));
    let mut boxes: Vec<[Vector; 2]> = Vec::new();
    for _ in 0..count {
        let low = [random.between(1, 3), random.between(-2, 2), random.between(-2, 2)];
        let size = [random.between(1, 2), random.between(1, 4), random.between(1, 4)];
        let mut next = [low, add(low, size)];
        if let Some(&[low, high]) = boxes.last() {
            let mut step = [0; 3];
            let axes = random.between(1, 3);
            // Moved by its own size along one axis, two, or all: a face, an edge or a corner
            // shared.
            for axis in 0..axes as usize {
                let axis = (axis + random.between(0, 2) as usize) % 3;
                step[axis] = one_of(random, &[-1, 1]) * (high[axis] - low[axis]);
            }
            step[0] = step[0].clamp(1 - low[0], 5 - high[0]);
            if random.one_in(2) {
                next = [add(low, step), add(high, step)];
            }
        }
        boxes.push(next);
    }
    let brush = |corners: &[Vector; 2], random: &mut Random| {
        let mut points = box_corners(&polygon(corners));
        if random.one_in(4) {
            // A corner cut off.
            points.remove(random.between(0, 7) as usize);
        }
        points
    };
    let brushes = boxes.iter().map(|corners| brush(corners, random)).collect();
    Input::Scene(Scene { polygons: Vec::new(), brushes, from, to })
}

fn plan(random: &mut Random, settings: &Settings) -> Input {
    let region = |random: &mut Random, x: i64| {
        let y = random.between(0, 3);
        let square = [[x, y], [x + 1, y], [x + 1, y + 1], [x, y + 1]];
        polygon(if random.one_in(3) { &square[..3] } else { &square })
    };
    let (from, to) = (region(random, -1), region(random, 6));
    let count = random.between(1, settings.get("occluders"));
    let mut segments: Vec<[[i64; 2]; 2]> = Vec::new();
    while (segments.len() as i64) < count {
        let any = |random: &mut Random| [random.between(1, 5), random.between(-1, 5)];
        let (mut p, mut q) = (any(random), any(random));
        if random.one_in(2) {
            q = [p[0], p[1] + random.between(1, 3)];
        }
        if let Some(&[a, b]) = segments.last() {
            match random.between(0, 6) {
                0 => p = a,
                // On its line, from its end on, or a unit after.
                1 => (p, q) = (b, [2 * b[0] - a[0], 2 * b[1] - a[1]]),
                2 => p = [b[0], b[1] + 1],
                3 => (p, q) = (b, a),
                // From its middle.
                4 => p = [(a[0] + b[0]).div_euclid(2), (a[1] + b[1]).div_euclid(2)],
                _ => {}
            }
        }
        let inside = [p, q].iter().all(|end| (0..=6).contains(&end[0]));
        if p != q && inside {
            segments.push([p, q]);
        }
    }
    let polygons = segments.iter().map(|ends| polygon(ends)).collect();
    Input::Scene(Scene { polygons, brushes: Vec::new(), from, to })
}
