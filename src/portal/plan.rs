//! The portals of a floorplan's subdivision, and its adjacency graph.
//!
//! Every edge of a leaf lies on one of the plan's lines. Along each line the edges of the leaves on
//! either side and the segments on it are laid over each other; a portal is a connected part of
//! two leaves' common boundary on which no opaque segment lies (Teller and Séquin 1991, §2.3,
//! §3.1). O(e lg e) for e edges and segments.

mod neighbours;
#[cfg(test)]
mod tests;

use crate::num::Sign;
use crate::predicates::{PlanPoint, compare_coordinates, turn_of_points};
use crate::scene::CellId;
use crate::scene::plan::{Plan, PlanGraph, PlanPortal, PlanSegment};
use crate::subdivision::plan::PlanTree;
use rustc_hash::FxHashMap;
use std::cmp::Ordering;

pub use neighbours::{Neighbour, Neighbours};

/// A piece of a line between two neighbouring points on it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Boundary {
    /// Its ends, in the line's direction.
    pub ends: [u32; 2],
    /// The leaf to its left; none outside of the box.
    pub left: Option<u32>,
    /// The leaf to its right.
    pub right: Option<u32>,
    /// The plan's segments that lie on all of it, by their index.
    pub segments: Vec<u32>,
}

/// The cells of a plan and what joins and parts them.
#[derive(Clone, Debug)]
pub struct PlanCells {
    /// The subdivision.
    pub tree: PlanTree,
    /// The cells and their portals: leaves that can be reached from the plan's marks, or all.
    pub graph: PlanGraph,
    /// The cell of each leaf.
    pub cell_of_leaf: Vec<Option<CellId>>,
    /// Every piece of every line that a leaf borders on, line by line.
    pub boundaries: Vec<Boundary>,
    /// Which segments cross or overlap.
    pub meets: SegmentMeets,
}

/// Segments of a plan that meet in more than an end; each pair once, by index, in ascending order.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct SegmentMeets {
    /// Pairs that cross inside both, and the point where: there both are split.
    pub crossing: Vec<([u32; 2], u32)>,
    /// Pairs on one line that share a piece of it.
    pub overlapping: Vec<[u32; 2]>,
}

/// Why the marks of a plan's inside do not say what is inside.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum MarkError {
    /// A way leads from a mark to the edge of the box.
    #[error("the plan leaks: inside[{0}] reaches the edge of the box")]
    Leak(usize),
    /// A mark lies on something opaque.
    #[error("inside[{mark}] lies on segment {segment}")]
    OnWall {
        /// The mark.
        mark: usize,
        /// The segment, by its number in the input.
        segment: u32,
    },
    /// A mark lies outside of the box, or on its edge.
    #[error("inside[{0}] does not lie inside the box")]
    OutOfBox(usize),
}

impl PlanCells {
    /// The cell that holds a point in its half-open extent, if the point is in the box and in a
    /// cell.
    pub fn locate(&self, point: &PlanPoint) -> Option<CellId> {
        self.cell_of_leaf[self.tree.locate(point) as usize]
    }

    /// Whether a piece of boundary hides what is behind it.
    pub fn is_opaque(&self, plan: &Plan, boundary: &Boundary) -> bool {
        boundary.segments.iter().any(|&segment| plan.segments[segment as usize].is_opaque)
    }
}

/// The cells of a divided plan. With marks of the inside, the leaves that can be reached from
/// them, else all.
///
/// # Errors
/// [`MarkError`]; `closed` says that ways out of the box count as leaks.
pub fn cells_of_plan(plan: &Plan, tree: PlanTree, closed: bool) -> Result<PlanCells, MarkError> {
    let boundaries = boundaries(plan, &tree);
    let is_open = |boundary: &Boundary| {
        !boundary.segments.iter().any(|&segment| plan.segments[segment as usize].is_opaque)
    };
    let reached = reached_leaves(plan, &tree, &boundaries, closed)?;
    let mut cell_of_leaf = vec![None; tree.leaves.len()];
    let mut graph = PlanGraph { grid: plan.grid.clone(), ..PlanGraph::default() };
    for (leaf, _) in reached.iter().enumerate().filter(|(_, reached)| **reached) {
        cell_of_leaf[leaf] = Some(CellId(graph.polygons.len() as u32));
        graph.cells.push(graph.polygons.len().to_string());
        graph.polygons.push(tree.leaves[leaf].polygon.clone());
    }
    let cell = |leaf: Option<u32>| leaf.and_then(|leaf| cell_of_leaf[leaf as usize]);
    for boundary in boundaries.iter().filter(|boundary| is_open(boundary)) {
        let (Some(to), Some(from)) = (cell(boundary.left), cell(boundary.right)) else { continue };
        // Seen by who crosses to the line's left, its direction points to the right.
        let [left, right] = boundary.ends;
        match graph.portals.last_mut() {
            // The piece before it on the same line, between the same cells.
            Some(last) if last.right == left && (last.from, last.to) == (from, to) => {
                last.right = right;
            }
            Some(_) | None => graph.portals.push(PlanPortal { from, to, left, right }),
        }
    }
    graph.points = tree.points.clone();
    let meets = meets(&boundaries);
    Ok(PlanCells { tree, graph, cell_of_leaf, boundaries, meets })
}

/// Which segments meet in more than an end. Linear in the boundaries, and in what is found.
fn meets(boundaries: &[Boundary]) -> SegmentMeets {
    let mut overlapping = Vec::new();
    // The segments that run on through each point at which pieces of their lines meet.
    let mut through: FxHashMap<u32, Vec<u32>> = FxHashMap::default();
    for (index, piece) in boundaries.iter().enumerate() {
        for (i, &second) in piece.segments.iter().enumerate() {
            overlapping.extend(piece.segments[..i].iter().map(|&first| [first, second]));
        }
        let Some(next) = boundaries.get(index + 1) else { continue };
        if piece.ends[1] == next.ends[0] {
            let on = piece.segments.iter().filter(|segment| next.segments.contains(segment));
            through.entry(piece.ends[1]).or_default().extend(on);
        }
    }
    let mut crossing = Vec::new();
    for (point, segments) in through {
        for (i, &second) in segments.iter().enumerate() {
            crossing.extend(
                segments[..i].iter().map(|&first| ([first.min(second), first.max(second)], point)),
            );
        }
    }
    let mut overlapping: Vec<[u32; 2]> =
        overlapping.into_iter().map(|[a, b]: [u32; 2]| [a.min(b), a.max(b)]).collect();
    overlapping.sort_unstable();
    overlapping.dedup();
    // Those of one line run through the same points without crossing there.
    crossing.retain(|(pair, _)| overlapping.binary_search(pair).is_err());
    crossing.sort_unstable();
    crossing.dedup();
    SegmentMeets { crossing, overlapping }
}

/// What lies on one line.
#[derive(Default)]
struct OnLine {
    /// The leaves to its left, each with the ends of its edge in the line's direction.
    left: Vec<(u32, [u32; 2])>,
    /// The leaves to its right.
    right: Vec<(u32, [u32; 2])>,
    /// The segments, likewise.
    segments: Vec<(u32, [u32; 2])>,
}

/// Every piece of every line that a leaf borders on.
fn boundaries(plan: &Plan, tree: &PlanTree) -> Vec<Boundary> {
    let mut on_lines: Vec<OnLine> = Vec::new();
    on_lines.resize_with(tree.lines.len(), OnLine::default);
    for (number, leaf) in tree.leaves.iter().enumerate() {
        for (i, edge) in leaf.edges.iter().enumerate() {
            let ends = [leaf.polygon[i], leaf.polygon[(i + 1) % leaf.polygon.len()]];
            let on_line = &mut on_lines[edge.line as usize];
            // A leaf's boundary runs counter-clockwise, with the leaf to its left.
            match edge.is_left {
                true => on_line.left.push((number as u32, ends)),
                false => on_line.right.push((number as u32, [ends[1], ends[0]])),
            }
        }
    }
    for (index, (segment, &line)) in plan.segments.iter().zip(&tree.segment_lines).enumerate() {
        let [p, q] = segment.ends;
        let is_forward = tree.points.compare_along(tree.lines.through(line), p, q).is_lt();
        let ends = if is_forward { [p, q] } else { [q, p] };
        on_lines[line as usize].segments.push((index as u32, ends));
    }
    let mut boundaries = Vec::new();
    for (line, on_line) in on_lines.iter().enumerate() {
        lay_over(tree, line as u32, on_line, &mut boundaries);
    }
    boundaries
}

/// Cuts what lies on a line at all ends, and tells for each piece what lies there.
fn lay_over(tree: &PlanTree, line: u32, on_line: &OnLine, out: &mut Vec<Boundary>) {
    let OnLine { left, right, segments } = on_line;
    let mut ends: Vec<u32> =
        left.iter().chain(right).chain(segments).flat_map(|(_, ends)| *ends).collect();
    ends.sort_unstable();
    ends.dedup();
    let through = tree.lines.through(line);
    ends.sort_unstable_by(|&p, &q| tree.points.compare_along(through, p, q));
    let ranks: FxHashMap<u32, usize> = ends.iter().enumerate().map(|(i, &p)| (p, i)).collect();
    let pieces = |[p, q]: [u32; 2]| ranks[&p]..ranks[&q];
    let mut all: Vec<Boundary> = ends
        .windows(2)
        .map(|pair| Boundary {
            ends: [pair[0], pair[1]],
            left: None,
            right: None,
            segments: Vec::new(),
        })
        .collect();
    for &(leaf, ends) in left {
        all[pieces(ends)].iter_mut().for_each(|piece| piece.left = Some(leaf));
    }
    for &(leaf, ends) in right {
        all[pieces(ends)].iter_mut().for_each(|piece| piece.right = Some(leaf));
    }
    for &(segment, ends) in segments {
        all[pieces(ends)].iter_mut().for_each(|piece| piece.segments.push(segment));
    }
    // A line runs on through leaves that it does not bound.
    out.extend(all.into_iter().filter(|piece| piece.left.is_some() || piece.right.is_some()));
}

/// Whether a mark lies inside the box, on nothing opaque. Linear in the segments.
fn check_mark(plan: &Plan, mark: usize, point: &PlanPoint) -> Result<(), MarkError> {
    let is_left_of = |i: usize| {
        let [a, b] = [i, (i + 1) % 4].map(|i| plan.points.get(plan.bounds[i]));
        turn_of_points(a, b, point) == Sign::Positive
    };
    if !(0..4).all(is_left_of) {
        return Err(MarkError::OutOfBox(mark));
    }
    let holds = |segment: &&PlanSegment| {
        let [a, b] = segment.ends.map(|end| plan.points.get(end));
        segment.is_opaque
            && turn_of_points(a, b, point) == Sign::Zero
            && [0, 1].into_iter().all(|axis| {
                let (low, high) = match compare_coordinates(axis, a, b) {
                    Ordering::Less | Ordering::Equal => (a, b),
                    Ordering::Greater => (b, a),
                };
                compare_coordinates(axis, low, point).is_le()
                    && compare_coordinates(axis, point, high).is_le()
            })
    };
    match plan.segments.iter().find(holds) {
        Some(segment) => Err(MarkError::OnWall { mark, segment: segment.source }),
        None => Ok(()),
    }
}

/// The leaves that can be reached from the marks; all, where there is none.
fn reached_leaves(
    plan: &Plan,
    tree: &PlanTree,
    boundaries: &[Boundary],
    closed: bool,
) -> Result<Vec<bool>, MarkError> {
    if plan.inside.is_empty() {
        return Ok(vec![true; tree.leaves.len()]);
    }
    let mut beside: Vec<Vec<Option<u32>>> = vec![Vec::new(); tree.leaves.len()];
    for boundary in boundaries {
        let is_opaque = |&segment: &u32| plan.segments[segment as usize].is_opaque;
        if boundary.segments.iter().any(is_opaque) {
            continue;
        }
        for (one, other) in [(boundary.left, boundary.right), (boundary.right, boundary.left)] {
            if let Some(leaf) = one {
                beside[leaf as usize].push(other);
            }
        }
    }
    let mut reached = vec![false; tree.leaves.len()];
    for (mark, point) in plan.inside.iter().enumerate() {
        check_mark(plan, mark, point)?;
        let mut stack = vec![tree.locate(point)];
        while let Some(leaf) = stack.pop() {
            if std::mem::replace(&mut reached[leaf as usize], true) {
                continue;
            }
            for &other in &beside[leaf as usize] {
                match other {
                    Some(other) => stack.push(other),
                    None if closed => return Err(MarkError::Leak(mark)),
                    None => {}
                }
            }
        }
    }
    Ok(reached)
}
