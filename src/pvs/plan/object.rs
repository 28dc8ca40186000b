//! Which cells of a plan see its objects and regions: convex polygons with rational corners.
//!
//! A cell sees a polygon iff some segment from a point of the open cell to a point inside the
//! polygon is free. The polygon falls into its pieces, one a cell whose inside it meets; those
//! cells see it. Any other cell does iff a line from it comes, through portals, into a cell with a
//! piece and enters the piece there, through one of its edges; an edge on the boundary of the cell
//! counts as far as it lies in a portal, and the hourglass of both, which are collinear, says how
//! far that is. A line reversed is a line: so from each edge of each piece, as from a portal into
//! the piece's cell, the open sequences are walked that lead away from it (`stab_tree`).
//!
//! The walk asks nothing about the order of ends, as a piece's edge may lie in a portal.
//!
//! Complexity: for each polygon O(e) for the e edges of all cells, and the stab trees of its
//! pieces' edges.

use super::stab_tree::Walk;
use super::witness;
use crate::num::{Number, Sign};
use crate::predicates::{PlanPoint, PlanPoints, compare_coordinates, turn_of_points};
use crate::report::{Progress, Verdict};
use crate::scene::CellId;
use crate::scene::plan::{Crossing, Crossings, PlanGraph, PlanObject};
use crate::stab::hourglass::chains::{Ends, Place};
use rayon::prelude::*;
use std::cmp::Ordering;

/// A cell that sees an object, and a line that shows it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlanObjectSight {
    /// The object, by index.
    pub object: u32,
    /// The cell, which has no part of the object in it.
    pub cell: CellId,
    /// The portals that a line from the cell crosses before it enters the object, in this order.
    pub portals: Vec<u32>,
    /// Two distinct points of the line, in its direction, in world units.
    pub line: [[Number; 2]; 2],
}

/// Which cells see which objects.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlanObjectSights {
    /// For each object the cells whose insides it meets, ascending.
    pub held_by: Vec<Vec<CellId>>,
    /// For each object the verdict of every cell: open or not open.
    pub verdicts: Vec<Vec<Verdict>>,
    /// By object, then by cell; none where they were not asked for.
    pub sights: Vec<PlanObjectSight>,
}

/// The points of a graph, and more behind them.
struct MorePoints<'a> {
    table: &'a PlanPoints,
    more: &'a [PlanPoint],
}

impl MorePoints<'_> {
    fn get(&self, number: u32) -> &PlanPoint {
        let known = self.table.len() as u32;
        if number < known { self.table.get(number) } else { &self.more[(number - known) as usize] }
    }
}

impl Ends for MorePoints<'_> {
    fn turn(&self, a: u32, b: u32, c: u32) -> Sign {
        if a.max(b).max(c) < self.table.len() as u32 {
            return self.table.turn(a, b, c);
        }
        turn_of_points(self.get(a), self.get(b), self.get(c))
    }

    fn order(&self, a: u32, b: u32) -> Ordering {
        let (a, b) = (self.get(a), self.get(b));
        compare_coordinates(0, a, b).then_with(|| compare_coordinates(1, a, b))
    }
}

/// The part of an object in one cell.
struct Piece {
    object: u32,
    cell: CellId,
    /// Its corners, counter-clockwise.
    polygon: Vec<PlanPoint>,
}

/// The ways on which a cell was first met from an edge of a piece, that edge being the first.
type Met = (CellId, Vec<Crossing>);

/// Which cells see which objects; `None` if interrupted.
///
/// Runs on rayon's current thread pool; the result does not depend on it.
///
/// # Panics
/// If the graph states no polygons.
pub fn plan_object_sights(
    graph: &PlanGraph,
    crossings: &Crossings,
    objects: &[PlanObject],
    wants_lines: bool,
    progress: &dyn Progress,
) -> Option<PlanObjectSights> {
    assert!(graph.polygons.len() == graph.cells.len(), "a graph without its cells' polygons");
    let pieces: Vec<Piece> =
        (0..objects.len()).into_par_iter().flat_map_iter(|i| pieces(graph, objects, i)).collect();
    let mut found = PlanObjectSights {
        held_by: vec![Vec::new(); objects.len()],
        verdicts: vec![vec![Verdict::NotOpen; graph.cells.len()]; objects.len()],
        sights: Vec::new(),
    };
    for piece in &pieces {
        found.held_by[piece.object as usize].push(piece.cell);
        found.verdicts[piece.object as usize][piece.cell.0 as usize] = Verdict::Open;
    }
    progress.begin("objects", pieces.len() as u64);
    let met: Option<Vec<Vec<Met>>> = pieces
        .par_iter()
        .map(|piece| {
            let met = met_from(graph, crossings, piece, wants_lines, progress)?;
            progress.advance(1);
            Some(met)
        })
        .collect();
    let mut shown: Vec<(&Piece, Met)> = Vec::new();
    for (piece, met) in pieces.iter().zip(met?) {
        for (cell, ways) in met {
            let verdict = &mut found.verdicts[piece.object as usize][cell.0 as usize];
            if *verdict == Verdict::NotOpen {
                *verdict = Verdict::Open;
                shown.push((piece, (cell, ways)));
            }
        }
    }
    if wants_lines {
        shown.sort_by_key(|(piece, (cell, _))| (piece.object, *cell));
        found.sights = shown.par_iter().map(|(piece, met)| sight(graph, piece, met)).collect();
    }
    Some(found)
}

/// The pieces of an object, by ascending cell.
fn pieces(graph: &PlanGraph, objects: &[PlanObject], object: usize) -> Vec<Piece> {
    let piece = |cell: usize| {
        let corners = &graph.polygons[cell];
        let edges = (0..corners.len()).map(|i| [corners[i], corners[(i + 1) % corners.len()]]);
        let mut polygon = objects[object].polygon.clone();
        for [p, q] in edges {
            polygon = left_of(polygon, graph.points.get(p), graph.points.get(q))?;
        }
        Some(Piece { object: object as u32, cell: CellId(cell as u32), polygon })
    };
    (0..graph.cells.len()).filter_map(piece).collect()
}

/// The part of a convex polygon to the left of a line, if it has an inside.
fn left_of(polygon: Vec<PlanPoint>, p: &PlanPoint, q: &PlanPoint) -> Option<Vec<PlanPoint>> {
    let sides: Vec<Sign> = polygon.iter().map(|corner| turn_of_points(p, q, corner)).collect();
    if !sides.contains(&Sign::Positive) {
        return None;
    }
    if !sides.contains(&Sign::Negative) {
        return Some(polygon);
    }
    let mut part = Vec::with_capacity(polygon.len() + 1);
    for (i, corner) in polygon.iter().enumerate() {
        let next = (i + 1) % polygon.len();
        match sides[i] {
            // The line itself bounds the part.
            Sign::Positive | Sign::Zero => part.push(corner.clone()),
            Sign::Negative => {}
        }
        if sides[i] * sides[next] == Sign::Negative {
            part.extend(PlanPoint::meet(corner, &polygon[next], p, q));
        }
    }
    Some(part)
}

/// The cells that lines from inside a piece come to, each with the ways to it, the piece's edge
/// being the first, if they are wanted; `None` if interrupted.
fn met_from(
    graph: &PlanGraph,
    crossings: &Crossings,
    piece: &Piece,
    wants_ways: bool,
    progress: &dyn Progress,
) -> Option<Vec<Met>> {
    let points = MorePoints { table: &graph.points, more: &piece.polygon };
    let mut walk = Walk::new(&points, crossings, graph.cells.len(), Place::Anywhere);
    let (mut met, mut is_met) = (Vec::new(), vec![false; graph.cells.len()]);
    let (first, n) = (graph.points.len() as u32, piece.polygon.len() as u32);
    for corner in 0..n {
        // Who leaves a polygon through an edge has its end, counter-clockwise, to the left.
        let [right, left] = [first + corner, first + (corner + 1) % n];
        let edge = Crossing { portal: u32::MAX, to: piece.cell, left, right };
        walk.from(piece.cell, Some([left, right]), progress, &mut |path| {
            let cell = path[path.len() - 1].to;
            if !std::mem::replace(&mut is_met[cell.0 as usize], true) {
                let ways = if wants_ways { [&[edge], path].concat() } else { Vec::new() };
                met.push((cell, ways));
            }
        })?;
    }
    Some(met)
}

/// The line of a cell that was met, from the cell to the object.
fn sight(graph: &PlanGraph, piece: &Piece, (cell, ways): &Met) -> PlanObjectSight {
    let points = MorePoints { table: &graph.points, more: &piece.polygon };
    let [from, to] = witness::through(&|end| points.get(end), ways).in_world(&graph.grid);
    PlanObjectSight {
        object: piece.object,
        cell: *cell,
        portals: ways[1..].iter().rev().map(|way| way.portal).collect(),
        line: [to, from],
    }
}

#[cfg(test)]
mod tests;
