//! What is said of graphs alone: cells by other numbers, portals written the other way, and a cell
//! in two.

use crate::forge::input::{Door, Graph, Input, Point, Polygon};
use crate::forge::shapes::whole;
use crate::num::{Int, Random, Rational};
use num_traits::Signed;

/// The cells by other numbers.
pub(super) fn renumbered(input: &Input, random: &mut Random) -> Vec<Input> {
    let Input::Graph(graph) = input else { return Vec::new() };
    let mut numbers: Vec<usize> = (0..graph.cells).collect();
    for i in (1..numbers.len()).rev() {
        numbers.swap(i, random.between(0, i as i64) as usize);
    }
    let mut graph = graph.clone();
    for door in &mut graph.doors {
        door.cells = door.cells.map(|cell| numbers[cell]);
    }
    (graph.from, graph.to) = (numbers[graph.from], numbers[graph.to]);
    vec![Input::Graph(graph)]
}

/// Some portals written from their other side.
pub(super) fn written_turned(input: &Input, random: &mut Random) -> Vec<Input> {
    let Input::Graph(graph) = input else { return Vec::new() };
    let mut graph = graph.clone();
    for door in graph.doors.iter_mut().filter(|_| random.one_in(2)) {
        door.cells.reverse();
        door.polygon.reverse();
    }
    vec![Input::Graph(graph)]
}

/// A cell that neither looks nor is looked for, cut in two by a plane across an axis. What lies
/// across the plane is cut as well; what joins the halves is a portal larger than the box around
/// the cell's portals. Not where a portal lies in the plane: it would be crossed in the same point.
pub(super) fn split_cell(input: &Input, random: &mut Random) -> Vec<Input> {
    let Input::Graph(graph) = input else { return Vec::new() };
    let axis = random.between(0, input.dimension() as i64 - 1) as usize;
    let mut cells: Vec<usize> =
        (0..graph.cells).filter(|&cell| cell != graph.from && cell != graph.to).collect();
    if !cells.is_empty() {
        let first = random.between(0, cells.len() as i64 - 1) as usize;
        cells.rotate_left(first);
    }
    let split = cells.into_iter().find_map(|cell| split_at(graph, cell, axis));
    split.map(Input::Graph).into_iter().collect()
}

fn split_at(graph: &Graph, cell: usize, axis: usize) -> Option<Graph> {
    let own: Vec<&Point> =
        graph.doors.iter().filter(|d| d.cells.contains(&cell)).flat_map(|d| &d.polygon).collect();
    let dimension = own.first()?.len();
    let range =
        |k: usize| Some([own.iter().map(|p| &p[k]).min()?, own.iter().map(|p| &p[k]).max()?]);
    let [low, high] = range(axis)?;
    let at = (low + high) / Rational::from(Int::from(2));
    if low == high {
        return None;
    }
    let mut split = Graph { cells: graph.cells + 1, doors: Vec::new(), ..graph.clone() };
    for door in &graph.doors {
        if !door.cells.contains(&cell) {
            split.doors.push(door.clone());
            continue;
        }
        if door.polygon.iter().all(|p| p[axis] == at) {
            return None;
        }
        // The half below keeps the number.
        for (sign, half) in [(-1, cell), (1, graph.cells)] {
            if let Some(polygon) = clipped(&door.polygon, axis, &at, sign) {
                let cells = door.cells.map(|other| if other == cell { half } else { other });
                split.doors.push(Door { cells, polygon });
            }
        }
    }
    let bounds = |k: usize| range(k).map(|[low, high]| [low - whole(1), high + whole(1)]);
    let polygon: Polygon = match dimension {
        2 => {
            let [low, high] = bounds(1 - axis)?;
            let end = |along: Rational| {
                let mut end = vec![at.clone(); 2];
                end[1 - axis] = along;
                end
            };
            // Crossed towards greater coordinates, the left end first.
            if axis == 0 { vec![end(high), end(low)] } else { vec![end(low), end(high)] }
        }
        _ => {
            let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
            let (u, v) = (bounds(i)?, bounds(j)?);
            let corner = |a: usize, b: usize| {
                let mut corner = vec![at.clone(); 3];
                (corner[i], corner[j]) = (u[a].clone(), v[b].clone());
                corner
            };
            vec![corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)]
        }
    };
    split.doors.push(Door { cells: [cell, graph.cells], polygon });
    Some(split)
}

/// The part of a polygon, or of a segment, on one side of a plane across an axis; `None` if it is
/// not more than an edge.
fn clipped(polygon: &Polygon, axis: usize, at: &Rational, sign: i64) -> Option<Polygon> {
    let sign = whole(sign);
    let height = |p: &Point| (&p[axis] - at) * &sign;
    if !polygon.iter().any(|p| height(p).is_positive()) {
        return None;
    }
    let cut = |p: &Point, q: &Point| -> Point {
        let share = height(p) / (height(p) - height(q));
        p.iter().zip(q).map(|(p, q)| p + (q - p) * &share).collect()
    };
    if let [left, right] = polygon.as_slice() {
        let keep = |end: &Point, other: &Point| match height(end).is_negative() {
            true => cut(end, other),
            false => end.clone(),
        };
        return Some(vec![keep(left, right), keep(right, left)]);
    }
    let mut kept: Polygon = Vec::new();
    for (i, p) in polygon.iter().enumerate() {
        let q = &polygon[(i + 1) % polygon.len()];
        if !height(p).is_negative() {
            kept.push(p.clone());
        }
        if (height(p) * height(q)).is_negative() {
            kept.push(cut(p, q));
        }
    }
    Some(kept)
}
