//! The twin for sequences of segments in the plane, by trying everything.
//!
//! Not open: the hulls of left and right ends meet, which they do (Kirchberger 1903) iff some at
//! most four ends already show it: an end within a closed triangle of the others, or two closed
//! segments that meet. Grazing: some line through two distinct ends, in either direction, is weakly
//! right; a weakly right line can always be moved until it is one of those. O(m^4) for m segments.

use crate::geom::BigPoint2;
use crate::num::{Int, Sign};

/// What is true of a sequence of segments, the most that can be seen last.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum PlaneTruth {
    /// No line meets all closed segments in its direction.
    Blocked,
    /// One does, but none passes strictly between left and right ends.
    Grazing,
    /// Some line passes strictly between left and right ends.
    Open,
}

/// A segment between two cells, with a direction of crossing.
#[derive(Clone, Debug)]
pub struct PlaneGate {
    /// The cell that a line leaves.
    pub from: usize,
    /// The cell that it enters.
    pub to: usize,
    /// The left end, and the right one.
    pub ends: [BigPoint2; 2],
}

/// What is true of each ordered pair of cells, row by row: the best of all sequences that enter no
/// cell twice, each judged by itself and without asking for an order; a cell is open to itself.
/// Each segment is given in one direction and crossed in both. As many decisions as there are
/// sequences that a line touches, times the segments of a cell.
pub fn classify_pairs_2d(cells: usize, gates: &[PlaneGate]) -> Vec<Vec<PlaneTruth>> {
    let reversed = |gate: &PlaneGate| {
        let [left, right] = gate.ends.clone();
        PlaneGate { from: gate.to, to: gate.from, ends: [right, left] }
    };
    let crossings: Vec<PlaneGate> =
        gates.iter().flat_map(|gate| [gate.clone(), reversed(gate)]).collect();
    let row = |source: usize| {
        let mut best = vec![PlaneTruth::Blocked; cells];
        best[source] = PlaneTruth::Open;
        let mut stack: Vec<(Vec<usize>, Vec<[BigPoint2; 2]>)> = vec![(vec![source], Vec::new())];
        while let Some((crossed, segments)) = stack.pop() {
            let leaves = |gate: &&PlaneGate| crossed.last() == Some(&gate.from);
            for gate in crossings.iter().filter(leaves).filter(|g| !crossed.contains(&g.to)) {
                let segments: Vec<_> = segments.iter().chain([&gate.ends]).cloned().collect();
                let truth = classify_2d(&segments);
                if truth != PlaneTruth::Blocked {
                    best[gate.to] = best[gate.to].max(truth);
                    stack.push((crossed.iter().copied().chain([gate.to]).collect(), segments));
                }
            }
        }
        best
    };
    (0..cells).map(row).collect()
}

/// Decides a sequence of segments, each by its left and its right end, which differ.
pub fn classify_2d(segments: &[[BigPoint2; 2]]) -> PlaneTruth {
    let left: Vec<&BigPoint2> = segments.iter().map(|[left, _]| left).collect();
    let right: Vec<&BigPoint2> = segments.iter().map(|[_, right]| right).collect();
    if !hulls_meet(&left, &right) {
        return PlaneTruth::Open;
    }
    let ends: Vec<&BigPoint2> = left.iter().chain(&right).copied().collect();
    let grazes = ends.iter().any(|p| {
        ends.iter().any(|q| {
            p != q
                && left.iter().all(|l| turn(p, q, l) != Sign::Negative)
                && right.iter().all(|r| turn(p, q, r) != Sign::Positive)
        })
    });
    if grazes { PlaneTruth::Grazing } else { PlaneTruth::Blocked }
}

fn hulls_meet(left: &[&BigPoint2], right: &[&BigPoint2]) -> bool {
    in_some_triangle(left, right)
        || in_some_triangle(right, left)
        || some_segments_meet(left, right)
}

fn in_some_triangle(points: &[&BigPoint2], corners: &[&BigPoint2]) -> bool {
    let mut triangles = corners.iter().enumerate().flat_map(|(i, a)| {
        let pairs = corners[..i].iter().enumerate();
        pairs.flat_map(move |(j, b)| corners[..j].iter().map(move |c| [*a, *b, *c]))
    });
    triangles.any(|[a, b, c]| {
        let around = match turn(a, b, c) {
            Sign::Positive => [a, b, c],
            Sign::Negative => [a, c, b],
            // A flat triangle has no inside; its sides are among the segments.
            Sign::Zero => return false,
        };
        let [a, b, c] = around;
        points.iter().any(|p| {
            [(a, b), (b, c), (c, a)].iter().all(|(from, to)| turn(from, to, p) != Sign::Negative)
        })
    })
}

fn some_segments_meet(left: &[&BigPoint2], right: &[&BigPoint2]) -> bool {
    // Each pair once, a point with itself included.
    fn pairs<'a>(ends: &'a [&'a BigPoint2]) -> impl Iterator<Item = [&'a BigPoint2; 2]> {
        (0..ends.len()).flat_map(move |i| (0..=i).map(move |j| [ends[i], ends[j]]))
    }
    pairs(left).any(|[a, b]| pairs(right).any(|[c, d]| segments_meet(a, b, c, d)))
}

/// Whether the closed segments ab and cd meet; a segment may be a point.
fn segments_meet(a: &BigPoint2, b: &BigPoint2, c: &BigPoint2, d: &BigPoint2) -> bool {
    let across = |p, q, r, s| turn(p, q, r) * turn(p, q, s) == Sign::Negative;
    if across(a, b, c, d) && across(c, d, a, b) {
        return true;
    }
    on_segment(a, c, d) || on_segment(b, c, d) || on_segment(c, a, b) || on_segment(d, a, b)
}

fn on_segment(p: &BigPoint2, a: &BigPoint2, b: &BigPoint2) -> bool {
    let between = |i: usize| {
        let [p, a, b] = [p, a, b].map(|point| &point.coordinates[i]);
        a.min(b) <= p && p <= a.max(b)
    };
    turn(a, b, p) == Sign::Zero && between(0) && between(1)
}

fn turn(a: &BigPoint2, b: &BigPoint2, c: &BigPoint2) -> Sign {
    let minus = |p: &BigPoint2| [0, 1].map(|i| &p.coordinates[i] - &a.coordinates[i]);
    let ([ux, uy], [vx, vy]): ([Int; 2], [Int; 2]) = (minus(b), minus(c));
    Sign::of(&(ux * vy - uy * vx))
}
