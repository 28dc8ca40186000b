//! Parts put in another order, doubled, split, shrunk, removed and added.

use crate::forge::input::{Door, Input, Polygon};
use crate::forge::shapes::{one_of, polygon, whole};
use crate::num::{Int, Random, Rational};

fn shuffle<T>(random: &mut Random, list: &mut [T]) {
    for i in (1..list.len()).rev() {
        list.swap(i, random.between(0, i as i64) as usize);
    }
}

fn any_index(random: &mut Random, count: usize) -> Option<usize> {
    (count > 0).then(|| random.between(0, count as i64 - 1) as usize)
}

/// The parts in any order: a bare sequence is judged by its sides alone.
pub(super) fn permuted(input: &Input, random: &mut Random) -> Vec<Input> {
    let mut input = input.clone();
    match &mut input {
        Input::Sequence(polygons) | Input::Lines(polygons) => shuffle(random, polygons),
        Input::Graph(graph) => shuffle(random, &mut graph.doors),
        Input::Scene(scene) => {
            shuffle(random, &mut scene.polygons);
            shuffle(random, &mut scene.brushes);
        }
    }
    vec![input]
}

/// Polygons that start at another vertex.
pub(super) fn rotated(input: &Input, random: &mut Random) -> Vec<Input> {
    let mut input = input.clone();
    for polygon in input.polygons_mut().into_iter().filter(|polygon| polygon.len() > 2) {
        let start = random.between(0, polygon.len() as i64 - 1) as usize;
        polygon.rotate_left(start);
    }
    vec![input]
}

/// The way back: portals in the other order and crossed the other way; from and to exchanged.
pub(super) fn reversed(input: &Input, _: &mut Random) -> Vec<Input> {
    let mut input = input.clone();
    match &mut input {
        Input::Sequence(polygons) => {
            polygons.reverse();
            polygons.iter_mut().for_each(|polygon| polygon.reverse());
        }
        Input::Lines(lines) => lines.iter_mut().for_each(|line| line.reverse()),
        Input::Graph(graph) => std::mem::swap(&mut graph.from, &mut graph.to),
        Input::Scene(scene) => std::mem::swap(&mut scene.from, &mut scene.to),
    }
    vec![input]
}

/// One part twice.
pub(super) fn doubled(input: &Input, random: &mut Random) -> Vec<Input> {
    let mut input = input.clone();
    match &mut input {
        Input::Sequence(list) | Input::Lines(list) => list.extend_from_within(..1),
        Input::Graph(graph) => {
            let Some(index) = any_index(random, graph.doors.len()) else { return Vec::new() };
            graph.doors.push(graph.doors[index].clone());
        }
        Input::Scene(scene) => {
            scene.polygons.extend(scene.polygons.first().cloned());
            scene.brushes.extend(scene.brushes.last().cloned());
        }
    }
    vec![input]
}

/// Each line by two other points of it.
pub(super) fn slid(input: &Input, random: &mut Random) -> Vec<Input> {
    let mut input = input.clone();
    for line in input.polygons_mut() {
        let [s, t] = one_of(random, &[[-1, 2], [1, 0], [3, 1], [0, -5]]).map(whole);
        let at = |k: &Rational| -> Vec<Rational> {
            line[0].iter().zip(&line[1]).map(|(p, q)| p + (q - p) * k).collect()
        };
        *line = vec![at(&s), at(&t)];
    }
    vec![input]
}

/// The two halves of a polygon, by a diagonal, or from a vertex to the middle of a side; of a
/// segment, by its middle.
fn halves(whole: &Polygon, random: &mut Random) -> [Polygon; 2] {
    let middle = |p: &[Rational], q: &[Rational]| -> Vec<Rational> {
        p.iter().zip(q).map(|(p, q)| (p + q) / Rational::from(Int::from(2))).collect()
    };
    match whole.as_slice() {
        [left, right] => {
            let middle = middle(left, right);
            [vec![left.clone(), middle.clone()], vec![middle, right.clone()]]
        }
        vertices => {
            let start = random.between(0, vertices.len() as i64 - 1) as usize;
            let mut ring = vertices.to_vec();
            ring.rotate_left(start);
            if ring.len() == 3 {
                ring.insert(2, middle(&ring[1], &ring[2]));
            }
            [ring[..3].to_vec(), [&ring[2..], &ring[..1]].concat()]
        }
    }
}

/// Whether two halves are polygons: a vertex in a straight side may leave one without area.
fn have_area(halves: &[Polygon; 2]) -> bool {
    halves.iter().all(|half| {
        let planar = |p: &[Rational], q: &[Rational], r: &[Rational], i: usize, j: usize| {
            (&q[i] - &p[i]) * (&r[j] - &p[j]) == (&q[j] - &p[j]) * (&r[i] - &p[i])
        };
        half.len() == 2
            || half.windows(3).any(|w| {
                [(0, 1), (0, 2), (1, 2)].iter().any(|&(i, j)| !planar(&w[0], &w[1], &w[2], i, j))
            })
    })
}

/// One portal, or one occluder, as two that share an edge. Of a sequence, one with each half.
pub(super) fn split(input: &Input, random: &mut Random) -> Vec<Input> {
    let count = match input {
        Input::Scene(scene) => scene.polygons.len(),
        Input::Sequence(_) | Input::Lines(_) | Input::Graph(_) => input.polygons().len(),
    };
    let Some(index) = any_index(random, count) else { return Vec::new() };
    let halves = halves(input.polygons()[index], random);
    if !have_area(&halves) {
        return Vec::new();
    }
    let mut input = input.clone();
    match &mut input {
        Input::Sequence(polygons) => {
            return halves
                .map(|half| {
                    let mut polygons = polygons.clone();
                    polygons[index] = half;
                    Input::Sequence(polygons)
                })
                .to_vec();
        }
        Input::Lines(_) => return Vec::new(),
        Input::Graph(graph) => {
            let [one, other] = halves;
            let cells = graph.doors[index].cells;
            graph.doors[index].polygon = one;
            graph.doors.push(Door { cells, polygon: other });
        }
        Input::Scene(scene) => {
            let [one, other] = halves;
            scene.polygons[index] = one;
            scene.polygons.push(other);
        }
    }
    vec![input]
}

/// One part less, if one is left.
pub(super) fn removed(input: &Input, random: &mut Random) -> Vec<Input> {
    let mut input = input.clone();
    match &mut input {
        Input::Sequence(list) if list.len() > 1 => {
            list.remove(random.between(0, list.len() as i64 - 1) as usize);
        }
        Input::Graph(graph) if !graph.doors.is_empty() => {
            graph.doors.remove(random.between(0, graph.doors.len() as i64 - 1) as usize);
        }
        Input::Scene(scene) if scene.polygons.len() + scene.brushes.len() > 1 => {
            let count = scene.polygons.len();
            let index = random.between(0, (count + scene.brushes.len()) as i64 - 1) as usize;
            match index < count {
                true => drop(scene.polygons.remove(index)),
                false => drop(scene.brushes.remove(index - count)),
            }
        }
        Input::Sequence(_) | Input::Lines(_) | Input::Graph(_) | Input::Scene(_) => {
            return Vec::new();
        }
    }
    vec![input]
}

/// One occluder more, between the regions.
pub(super) fn occluder_added(input: &Input, random: &mut Random) -> Vec<Input> {
    let mut result = input.clone();
    let Input::Scene(scene) = &mut result else { return Vec::new() };
    let at = |random: &mut Random, high| random.between(1, high);
    let (x, y, size) = (at(random, 5), at(random, 4), at(random, 3));
    scene.polygons.push(if input.dimension() == 2 {
        polygon(&[[x, y], [x, y + size]])
    } else {
        let z = random.between(-1, 2);
        polygon(&[[x, y, z], [x, y + size, z], [x, y, z + size]])
    });
    vec![result]
}

/// One portal as a part of itself: two of its corners and the middle towards the third.
pub(super) fn shrunk(input: &Input, random: &mut Random) -> Vec<Input> {
    let Some(index) = any_index(random, input.polygons().len()) else { return Vec::new() };
    let halves = halves(input.polygons()[index], random);
    if !have_area(&halves) {
        return Vec::new();
    }
    let mut input = input.clone();
    *input.polygons_mut()[index] = one_of(random, &halves);
    vec![input]
}
