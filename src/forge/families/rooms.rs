//! Graphs of rooms: a box cut by axial planes, with doors in the walls.

use super::{Family, Parameter, Settings};
use crate::forge::input::{Door, Graph, Input};
use crate::forge::shapes::polygon;
use crate::num::Random;
use crate::vectors::Kind;

pub(super) const ROOMS: Family = Family {
    name: "rooms",
    kind: Kind::Graph,
    purpose: "axial rooms with doors: several in one wall, sharing edges and corners, one unit \
              wide, triangles, T-junctions where walls meet",
    from_map: false,
    parameters: &[
        Parameter { name: "rooms", purpose: "the most rooms", default: 6, range: [2, 60] },
        Parameter { name: "size", purpose: "the box's sides", default: 6, range: [2, 100_000] },
    ],
    make: rooms,
};

/// Which coordinates a room spans.
type Room = [[i64; 2]; 3];

fn rooms(random: &mut Random, settings: &Settings) -> Input {
    let size = settings.get("size");
    let mut rooms: Vec<Room> = vec![[(); 3].map(|()| [0, random.between(2, size)])];
    let most = settings.get("rooms");
    let wanted = random.between(most.min(3), most) as usize;
    for _ in 0..4 * wanted {
        let index = random.between(0, rooms.len() as i64 - 1) as usize;
        let axis = random.between(0, 2) as usize;
        let [low, high] = rooms[index][axis];
        if rooms.len() < wanted && high - low >= 2 {
            let cut = random.between(low + 1, high - 1);
            let mut other = rooms[index];
            rooms[index][axis][1] = cut;
            other[axis][0] = cut;
            rooms.push(other);
        }
    }
    let mut doors = Vec::new();
    for a in 0..rooms.len() {
        for b in 0..rooms.len() {
            for axis in 0..3 {
                if rooms[a][axis][1] == rooms[b][axis][0] {
                    doors_between(random, [a, b], [&rooms[a], &rooms[b]], axis, &mut doors);
                }
            }
        }
    }
    let cell = |random: &mut Random| random.between(0, rooms.len() as i64 - 1) as usize;
    let (from, to) = (cell(random), cell(random));
    Input::Graph(Graph { cells: rooms.len(), doors, from, to })
}

/// Doors in the wall between two rooms, the second of which follows the first along `axis`.
fn doors_between(
    random: &mut Random,
    cells: [usize; 2],
    rooms: [&Room; 2],
    axis: usize,
    doors: &mut Vec<Door>,
) {
    let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
    let common =
        |k: usize| [rooms[0][k][0].max(rooms[1][k][0]), rooms[0][k][1].min(rooms[1][k][1])];
    let ([u0, u1], [v0, v1]) = (common(i), common(j));
    if u0 >= u1 || v0 >= v1 || random.one_in(3) {
        return;
    }
    // Two doors lie on either side of a cut, and often touch there.
    let cut = if u1 - u0 >= 2 && random.one_in(3) { random.between(u0 + 1, u1 - 1) } else { u1 };
    for [low, high] in [[u0, cut], [cut, u1]] {
        if low == high {
            continue;
        }
        let ([a, b], [c, d]) = (interval(random, [low, high]), interval(random, [v0, v1]));
        let corner = |u: i64, v: i64| {
            let mut p = [rooms[0][axis][1]; 3];
            p[i] = u;
            p[j] = v;
            p
        };
        let mut vertices = vec![corner(a, c), corner(b, c), corner(b, d), corner(a, d)];
        if random.one_in(6) {
            vertices.remove(random.between(0, 3) as usize);
        }
        doors.push(Door { cells, polygon: polygon(&vertices) });
    }
}

/// A part of an interval: rarely all of it, mostly one unit of it.
pub(super) fn interval(random: &mut Random, [low, high]: [i64; 2]) -> [i64; 2] {
    match random.between(0, 7) {
        0 => [low, high],
        1..6 => {
            let at = random.between(low, high - 1);
            [at, at + 1]
        }
        _ => {
            let a = random.between(low, high - 1);
            [a, random.between(a + 1, high.min(a + 3))]
        }
    }
}
