//! Graphs that no building looks like, and graphs of the plane.

use super::rooms::interval;
use super::{FAMILIES, Family, Parameter, Settings};
use crate::forge::input::{Door, Graph, Input};
use crate::forge::shapes::{across, add, polygon, vector};
use crate::num::Random;
use crate::vectors::Kind;

pub(super) const ROW: Family = Family {
    name: "row",
    kind: Kind::Graph,
    purpose: "cells in a row whose portals are a sequence of another family: consecutive portals in \
              one plane, turned around, in the wrong order",
    from_map: false,
    parameters: &[],
    make: row,
};

pub(super) const WILD: Family = Family {
    name: "wild",
    kind: Kind::Graph,
    purpose: "portals anywhere between any two cells, several between the same two, equal ones: the \
              definition of open does not ask whether space looks like that",
    from_map: false,
    parameters: &[Parameter {
        name: "portals",
        purpose: "the most portals",
        default: 5,
        range: [2, 40],
    }],
    make: wild,
};

pub(super) const FLOOR: Family = Family {
    name: "floor",
    kind: Kind::Graph,
    purpose: "graphs of the plane: axial rooms with doors that share ends, are one unit wide, or \
              fill a wall, and walls that end in a T",
    from_map: false,
    parameters: &[
        Parameter { name: "rooms", purpose: "the most rooms", default: 6, range: [2, 60] },
        Parameter { name: "size", purpose: "the box's sides", default: 6, range: [2, 100_000] },
    ],
    make: floor,
};

fn row(random: &mut Random, _: &Settings) -> Input {
    let in_space = |family: &&Family| family.kind == Kind::Sequence && family.name != "slit";
    let families: Vec<&Family> = FAMILIES.iter().filter(in_space).collect();
    let family = families[random.between(0, families.len() as i64 - 1) as usize];
    let settings = family.settings(&[], None).expect("the defaults are in range");
    let Input::Sequence(portals) = (family.make)(random, &settings) else {
        unreachable!("the family makes sequences")
    };
    let count = portals.len();
    let doors = portals.into_iter().enumerate().map(|(i, polygon)| {
        // Written either way around.
        match random.one_in(2) {
            true => Door { cells: [i, i + 1], polygon },
            false => Door { cells: [i + 1, i], polygon: polygon.into_iter().rev().collect() },
        }
    });
    let doors = doors.collect();
    Input::Graph(Graph { cells: count + 1, doors, from: 0, to: count })
}

fn wild(random: &mut Random, settings: &Settings) -> Input {
    let most = settings.get("portals");
    let count = random.between(2, most);
    let cells = random.between(3, count.max(3)) as usize;
    let mut doors: Vec<Door> = Vec::new();
    for _ in 0..count {
        let from = random.between(0, cells as i64 - 1) as usize;
        let to = (from + random.between(1, cells as i64 - 1) as usize) % cells;
        let y = random.between(0, 3);
        let vertices = match doors.last() {
            // The portal before once more, or moved a little.
            Some(last) if random.one_in(5) => {
                let polygon = last.polygon.clone();
                doors.push(Door { cells: [from, to], polygon });
                continue;
            }
            Some(_) | None => across(random, y, 2),
        };
        let shift = if random.one_in(2) { vector(random, 1) } else { [0; 3] };
        let vertices: Vec<[i64; 3]> = vertices.into_iter().map(|p| add(p, shift)).collect();
        doors.push(Door { cells: [from, to], polygon: polygon(&vertices) });
    }
    let from = random.between(0, cells as i64 - 1) as usize;
    let to = (from + random.between(1, cells as i64 - 1) as usize) % cells;
    Input::Graph(Graph { cells, doors, from, to })
}

fn floor(random: &mut Random, settings: &Settings) -> Input {
    let (size, most) = (settings.get("size"), settings.get("rooms"));
    let mut rooms: Vec<[[i64; 2]; 2]> = vec![[(); 2].map(|()| [0, random.between(2, size)])];
    let wanted = random.between(most.min(3), most) as usize;
    for _ in 0..4 * wanted {
        let index = random.between(0, rooms.len() as i64 - 1) as usize;
        let axis = random.between(0, 1) as usize;
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
            for axis in 0..2 {
                let other = 1 - axis;
                let low = rooms[a][other][0].max(rooms[b][other][0]);
                let high = rooms[a][other][1].min(rooms[b][other][1]);
                if rooms[a][axis][1] != rooms[b][axis][0] || low >= high || random.one_in(4) {
                    continue;
                }
                let cut = if high - low > 1 { random.between(low + 1, high) } else { high };
                for [low, high] in [[low, cut], [cut, high]] {
                    if low < high {
                        let [p, q] = interval(random, [low, high]);
                        let at = |along: i64| {
                            let mut end = [rooms[a][axis][1]; 2];
                            end[other] = along;
                            end
                        };
                        // Crossed towards greater coordinates, the left end first.
                        let ends = if axis == 0 { [at(q), at(p)] } else { [at(p), at(q)] };
                        doors.push(Door { cells: [a, b], polygon: polygon(&ends) });
                    }
                }
            }
        }
    }
    let cell = |random: &mut Random| random.between(0, rooms.len() as i64 - 1) as usize;
    let (from, to) = (cell(random), cell(random));
    Input::Graph(Graph { cells: rooms.len(), doors, from, to })
}
