//! The twin of a whole PVS: all portal sequences, each judged by itself.
//!
//! From each cell every sequence of portals that enters no cell twice is walked; each is decided
//! straight from the definition of open (`docs/semantics.md`): a line strictly right of every
//! edge that crosses consecutive planes strictly in order. The order is asked of every pair of
//! consecutive portals, convex cells or not, so that nothing rests on what convexity implies.
//!
//! A sequence that is not open has no open extension, which is what ends the walk; and a reversed
//! sequence is open iff the sequence is, so each pair is walked from its lower cell. Two things
//! only save time: sequences that lead to no cell whose answer is still out are left, and a line
//! of a shorter sequence is taken over if by the same definition it stabs the longer one.
//!
//! Complexity: as many decisions as there are open sequences, times the portals of a cell.

use super::sequence::{LinePoints, open_in_order};
use crate::geom::BigPoint3;
use crate::num::{Int, Rational};
use crate::scene::PortalGraph;
use num_traits::{Signed, Zero};

/// A portal with a direction of crossing: its vertices, and the cell that it enters.
struct Crossing {
    vertices: Vec<BigPoint3>,
    from: usize,
    to: usize,
}

/// Whether each ordered pair of cells is open, row by row. A cell is open to itself.
pub fn pvs(graph: &PortalGraph) -> Vec<Vec<bool>> {
    let crossings = crossings(graph);
    let cells = graph.cells.len();
    let mut open = vec![vec![false; cells]; cells];
    for source in 0..cells {
        let seen: Vec<bool> = (0..cells).map(|cell| cell <= source).collect();
        let mut walk = Walk { crossings: &crossings, seen, crossed: vec![source] };
        walk.on(source, &mut Vec::new(), None);
        open[source][source] = true;
        for target in source + 1..cells {
            open[source][target] = walk.seen[target];
            open[target][source] = walk.seen[target];
        }
    }
    open
}

fn crossings(graph: &PortalGraph) -> Vec<Crossing> {
    let both = graph.portals.iter().flat_map(|portal| {
        let vertices: Vec<BigPoint3> =
            portal.vertices.iter().map(|&v| graph.vertices[v as usize].clone()).collect();
        let [from, to] = [portal.from.0 as usize, portal.to.0 as usize];
        let reversed = vertices.iter().rev().cloned().collect();
        [Crossing { vertices, from, to }, Crossing { vertices: reversed, from: to, to: from }]
    });
    both.collect()
}

/// A walk over the sequences from one cell.
struct Walk<'a> {
    crossings: &'a [Crossing],
    /// The cells found open, and those that are not asked about.
    seen: Vec<bool>,
    /// The cells of the current sequence.
    crossed: Vec<usize>,
}

impl<'a> Walk<'a> {
    /// Goes on from `cell`, which the portals of `path` lead to, open by `line`.
    fn on(&mut self, cell: usize, path: &mut Vec<&'a [BigPoint3]>, line: Option<&Line>) {
        let crossings = self.crossings;
        for crossing in crossings.iter().filter(|crossing| crossing.from == cell) {
            if self.crossed.contains(&crossing.to) || !self.leads_to_unseen(crossing.to) {
                continue;
            }
            path.push(&crossing.vertices);
            let kept = line.filter(|line| line.stabs(path)).cloned();
            if let Some(line) = kept.or_else(|| decide(path)) {
                self.seen[crossing.to] = true;
                self.crossed.push(crossing.to);
                self.on(crossing.to, path, Some(&line));
                self.crossed.pop();
            }
            path.pop();
        }
    }

    /// Whether portals lead from `cell`, through cells not crossed yet, to one not seen yet.
    fn leads_to_unseen(&self, cell: usize) -> bool {
        let mut reached = vec![cell];
        let mut next = 0;
        while let Some(&cell) = reached.get(next) {
            if !self.seen[cell] {
                return true;
            }
            for crossing in self.crossings.iter().filter(|crossing| crossing.from == cell) {
                if !self.crossed.contains(&crossing.to) && !reached.contains(&crossing.to) {
                    reached.push(crossing.to);
                }
            }
            next += 1;
        }
        false
    }
}

fn decide(path: &[&[BigPoint3]]) -> Option<Line> {
    let portals: Vec<Vec<BigPoint3>> = path.iter().map(|portal| portal.to_vec()).collect();
    open_in_order(&portals).map(|points| Line::through(&points))
}

/// A point and a direction.
#[derive(Clone)]
struct Line {
    point: [Rational; 3],
    direction: [Rational; 3],
}

impl Line {
    fn through([p, q]: &LinePoints) -> Line {
        let rational = |i: usize| (p[i].rational_part(), q[i].rational_part());
        let point = [0, 1, 2].map(|i| rational(i).0.clone());
        Line { point, direction: [0, 1, 2].map(|i| rational(i).1 - rational(i).0) }
    }

    /// Whether the line crosses every portal inside, forwards, each plane after the one before.
    fn stabs(&self, path: &[&[BigPoint3]]) -> bool {
        let mut last: Option<Rational> = None;
        path.iter().all(|portal| {
            let Some(at) = self.crossing(portal) else { return false };
            let in_order = last.as_ref().is_none_or(|last| *last < at);
            last = Some(at);
            in_order
        })
    }

    /// The line's parameter where it crosses the inside of the portal forwards.
    fn crossing(&self, portal: &[BigPoint3]) -> Option<Rational> {
        let arm = |vertex: &BigPoint3| {
            [0, 1, 2].map(|i| Rational::from(vertex.coordinates[i].clone()) - &self.point[i])
        };
        let arms: Vec<[Rational; 3]> = portal.iter().map(arm).collect();
        let zero = || [(); 3].map(|()| Rational::zero());
        // The sum of the vertices' cross products is twice the area vector.
        let mut area = zero();
        for (i, u) in arms.iter().enumerate() {
            let product = cross(u, &arms[(i + 1) % arms.len()]);
            // det[direction, u, v] > 0: the edge passes the line on its right side.
            if !dot(&self.direction, &product).is_positive() {
                return None;
            }
            area = [0, 1, 2].map(|i| &area[i] + &product[i]);
        }
        Some(dot(&area, &arms[0]) / dot(&area, &self.direction))
    }
}

fn cross(a: &[Rational; 3], b: &[Rational; 3]) -> [Rational; 3] {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| &a[i] * &b[j] - &a[j] * &b[i])
}

fn dot(a: &[Rational; 3], b: &[Rational; 3]) -> Rational {
    let zero = Rational::from(Int::zero());
    a.iter().zip(b).fold(zero, |sum, (a, b)| sum + a * b)
}
