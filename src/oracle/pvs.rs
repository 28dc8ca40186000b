//! The twin of a whole PVS: all portal sequences, each judged by itself.
//!
//! From each cell every sequence of portals that enters no cell twice is walked; each is decided
//! straight from the definition of open (`docs/semantics.md`): a line strictly right of every
//! edge that crosses consecutive planes strictly in order. The order is asked of every pair of
//! consecutive portals, convex cells or not, so that nothing rests on what convexity implies.
//!
//! The same walk tells the pairs that are open or grazing: there the order is not asked.
//!
//! A sequence that is not open has no open extension, which is what ends the walk; and a reversed
//! sequence is open iff the sequence is, so each pair is walked from its lower cell. Two things
//! only save time: sequences that lead to no cell whose answer is still out are left, and a line
//! of a shorter sequence is taken over if by the same definition it stabs the longer one.
//!
//! Complexity: as many decisions as there are open sequences, times the portals of a cell.

use super::sequence::{LinePoints, Truth, classify, open_in_order};
use crate::geom::{BigPoint3, RationalPoint3};
use crate::num::{Int, Rational};
use num_traits::{Signed, Zero};

/// A planar convex portal with a direction of crossing.
#[derive(Clone, Debug)]
pub struct Gate {
    /// The cell that a line leaves through it.
    pub from: usize,
    /// The cell that a line enters through it.
    pub to: usize,
    /// Its vertices, counter-clockwise as seen from the cell that a line enters.
    pub vertices: Vec<RationalPoint3>,
}

impl Gate {
    /// The same portal, crossed the other way.
    fn reversed(&self) -> Gate {
        let vertices = self.vertices.iter().rev().cloned().collect();
        Gate { from: self.to, to: self.from, vertices }
    }
}

/// What a walk is after.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Aim {
    /// Open sequences.
    Open,
    /// Open or grazing ones: the order is not asked.
    Touched,
}

/// Whether each ordered pair of cells is open, row by row; a cell is open to itself. Each portal
/// is given in one direction and crossed in both.
pub fn open_pairs(cells: usize, portals: &[Gate]) -> Vec<Vec<bool>> {
    pairs(cells, portals, Aim::Open)
}

/// Whether each ordered pair of cells is open or grazing.
pub fn touched_pairs(cells: usize, portals: &[Gate]) -> Vec<Vec<bool>> {
    pairs(cells, portals, Aim::Touched)
}

fn pairs(cells: usize, portals: &[Gate], aim: Aim) -> Vec<Vec<bool>> {
    let crossings: Vec<Gate> =
        portals.iter().flat_map(|portal| [portal.clone(), portal.reversed()]).collect();
    let from_lower: Vec<Vec<bool>> = (0..cells)
        .map(|source| {
            let seen: Vec<bool> = (0..cells).map(|cell| cell <= source).collect();
            let mut walk = Walk { aim, crossings: &crossings, seen, crossed: vec![source] };
            walk.on(source, &mut Vec::new(), None);
            walk.seen
        })
        .collect();
    let joined = |a: usize, b: usize| a == b || from_lower[a.min(b)][a.max(b)];
    (0..cells).map(|a| (0..cells).map(|b| joined(a, b)).collect()).collect()
}

/// A walk over the sequences from one cell.
struct Walk<'a> {
    aim: Aim,
    crossings: &'a [Gate],
    /// The cells found open, and those that are not asked about.
    seen: Vec<bool>,
    /// The cells of the current sequence.
    crossed: Vec<usize>,
}

impl<'a> Walk<'a> {
    /// Goes on from `cell`, which the portals of `path` lead to, open by `line`.
    fn on(&mut self, cell: usize, path: &mut Vec<&'a [RationalPoint3]>, line: Option<&Line>) {
        let crossings = self.crossings;
        for crossing in crossings.iter().filter(|crossing| crossing.from == cell) {
            if self.crossed.contains(&crossing.to) || !self.leads_to_unseen(crossing.to) {
                continue;
            }
            path.push(&crossing.vertices);
            let kept = line.filter(|line| line.stabs(path)).cloned();
            let line = kept.or_else(|| decide(path));
            if line.is_some() || (self.aim == Aim::Touched && touches(path)) {
                self.seen[crossing.to] = true;
                self.crossed.push(crossing.to);
                self.on(crossing.to, path, line.as_ref());
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

fn decide(path: &[&[RationalPoint3]]) -> Option<Line> {
    let (grid, portals) = on_common_grid(path);
    open_in_order(&portals).map(|points| Line::through(&points, &Rational::from(grid)))
}

fn touches(path: &[&[RationalPoint3]]) -> bool {
    match classify(&on_common_grid(path).1) {
        Truth::Open(_) | Truth::Grazing(_) => true,
        Truth::Blocked => false,
    }
}

/// A sequence of polygons on the grid of their lowest common denominator, and that.
pub fn on_common_grid(path: &[&[RationalPoint3]]) -> (Int, Vec<Vec<BigPoint3>>) {
    let grid = RationalPoint3::common_denominator(path.iter().copied().flatten());
    let portal = |portal: &&[RationalPoint3]| portal.iter().map(|v| v.on_grid(&grid)).collect();
    let portals = path.iter().map(portal).collect();
    (grid, portals)
}

/// A point and a direction.
#[derive(Clone)]
struct Line {
    point: [Rational; 3],
    direction: [Rational; 3],
}

impl Line {
    /// The line through two points of a grid, in world units.
    fn through([p, q]: &LinePoints, grid: &Rational) -> Line {
        let rational = |i: usize| (p[i].rational_part(), q[i].rational_part());
        let point = [0, 1, 2].map(|i| rational(i).0 / grid);
        Line { point, direction: [0, 1, 2].map(|i| rational(i).1 - rational(i).0) }
    }

    /// Whether the line crosses every portal inside, forwards, each plane after the one before.
    fn stabs(&self, path: &[&[RationalPoint3]]) -> bool {
        let mut last: Option<Rational> = None;
        path.iter().all(|portal| {
            let Some(at) = self.crossing(portal) else { return false };
            let in_order = last.as_ref().is_none_or(|last| *last < at);
            last = Some(at);
            in_order
        })
    }

    /// The line's parameter where it crosses the inside of the portal forwards.
    fn crossing(&self, portal: &[RationalPoint3]) -> Option<Rational> {
        let arm = |vertex: &RationalPoint3| {
            let coordinates = vertex.coordinates();
            [0, 1, 2].map(|i| &coordinates[i] - &self.point[i])
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
