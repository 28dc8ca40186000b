//! Neighbourhoods of a real map, moved by a unit here and there.

use super::{Family, Parameter, Settings};
use crate::forge::input::{Door, Graph, Input};
use crate::forge::own::portal_graph;
use crate::forge::shapes::one_of;
use crate::num::{Int, Random, Rational};
use crate::scene::PortalGraph;
use crate::vectors::Kind;

pub(super) const PERTURBED: Family = Family {
    name: "perturbed",
    kind: Kind::Graph,
    purpose: "cells around one of a real map, some of their portals or vertices moved by one unit: \
              what rounding and editing do to a level",
    from_map: true,
    parameters: &[
        Parameter { name: "cells", purpose: "the most cells", default: 6, range: [2, 60] },
        Parameter { name: "moves", purpose: "the most moves", default: 4, range: [0, 100] },
        Parameter {
            name: "fraction",
            purpose: "a move is one world unit divided by this",
            default: 1,
            range: [1, 1_000_000_000],
        },
    ],
    make: perturbed,
};

/// The graph in world units, with no pair chosen; skew portals of the input as their triangles.
pub fn graph_of(map: &PortalGraph) -> Graph {
    let doors = map.portals.iter().map(|portal| Door {
        cells: [portal.from, portal.to].map(|cell| cell.0 as usize),
        polygon: map.corners(portal).map(|corner| corner.coordinates().to_vec()).collect(),
    });
    Graph { cells: map.cells.len(), doors: doors.collect(), from: 0, to: 0 }
}

fn perturbed(random: &mut Random, settings: &Settings) -> Input {
    let map = settings.map.as_ref().expect("`Family::settings` asks for a map");
    let mut graph = neighbourhood(random, map, settings.get("cells") as usize);
    let step = Rational::new(Int::from(1), Int::from(settings.get("fraction")));
    for _ in 0..random.between(settings.get("moves").min(1), settings.get("moves")) {
        let moved = moved(random, &graph, &step);
        // A portal without area, or one that is not planar any more, stays as it was.
        if portal_graph(&moved).is_ok_and(|built| built.skew_portals == 0) {
            graph = moved;
        }
    }
    Input::Graph(graph)
}

/// Up to so many cells around a cell that has a portal; a pair of the first and any other.
fn neighbourhood(random: &mut Random, map: &Graph, most: usize) -> Graph {
    let mut cells = vec![one_of(random, &map.doors).cells[0]];
    let mut next = 0;
    while next < cells.len() && cells.len() < most {
        let cell = cells[next];
        for door in map.doors.iter().filter(|door| door.cells.contains(&cell)) {
            let other = door.cells[usize::from(door.cells[0] == cell)];
            // Not always the nearest, so that chains come out as well as stars.
            if cells.len() < most && !cells.contains(&other) && !random.one_in(3) {
                cells.push(other);
            }
        }
        next += 1;
    }
    let number = |cell: usize| cells.iter().position(|&other| other == cell);
    let doors = map.doors.iter().filter_map(|door| {
        let [from, to] = door.cells.map(number);
        Some(Door { cells: [from?, to?], polygon: door.polygon.clone() })
    });
    let to = random.between(0, cells.len() as i64 - 1) as usize;
    Graph { cells: cells.len(), doors: doors.collect(), from: 0, to }
}

/// The graph with a portal, or one vertex of it, moved along an axis; of an axial portal the vertex
/// stays in the plane.
fn moved(random: &mut Random, graph: &Graph, step: &Rational) -> Graph {
    let mut graph = graph.clone();
    if graph.doors.is_empty() {
        return graph;
    }
    let door = random.between(0, graph.doors.len() as i64 - 1) as usize;
    let polygon = &mut graph.doors[door].polygon;
    let step = if random.one_in(2) { step.clone() } else { -step };
    if random.one_in(2) {
        let axis = random.between(0, 2) as usize;
        polygon.iter_mut().for_each(|vertex| vertex[axis] += &step);
        return graph;
    }
    let is_flat = |&axis: &usize| polygon.iter().all(|vertex| vertex[axis] == polygon[0][axis]);
    let along: Vec<usize> = (0..3).filter(|axis| !is_flat(axis)).collect();
    let (axis, vertex) = (one_of(random, &along), random.between(0, polygon.len() as i64 - 1));
    polygon[vertex as usize][axis] += &step;
    graph
}
