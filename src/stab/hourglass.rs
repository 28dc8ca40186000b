//! Sequences of segments in the plane: open, grazing or blocked, with push and pop.
//!
//! A directed line a·x + b·y + c = 0 with (a, b) its left normal stabs the sequence iff it is
//! positive on every left end and negative on every right one: each end p is a half-space
//! v·(a, b, c) > 0 with v = ±(x, y, 1). The sequence is open iff the cone of all of them has an
//! interior, which is to say that left and right ends are strictly separable.
//!
//! The cone is kept as the cyclic list of the ends whose half-spaces bound it. Between two
//! neighbours of the list lies one extremal line, the line through both ends, and a new end's side
//! of it is one `orient2d`. Read off the plane, the left ends of the list are the chain of the left
//! hull that faces the right one, the right ends the other chain, and the two extremal lines
//! between a left and a right end cross: the hourglass of the visibility literature (Guibas,
//! Hershberger, Leven, Sharir, Tarjan 1987).
//!
//! ```text
//!     l   l            A push keeps the extremal lines that the new end is on the good side of;
//!      \ l             they are consecutive, and the new end goes between the ends of that run.
//!       X              If none is left, the sequence is not open any more.
//!      / r
//!     r   r
//! ```
//!
//! While all ends are on one line the list is just the innermost left and right ends.
//!
//! Invariants: consecutive triples of the list are not collinear (three ends or more), no end is
//! redundant, and the list of each prefix stays in the arena until its last segment is popped.
//!
//! Complexity: with h ends on the hourglass, a push is at most 2h orientation tests and a pop is
//! O(1). Binary search on the two chains would take O(log h) tests, but h is the size of a hull of
//! the ends, a handful where the number of segments is in the hundreds, and the plain run needs no
//! case for degenerate ends. A verdict other than open is O(m) for m segments, O(m²) where a left
//! and a right end coincide.

mod answer;

pub use answer::{End, EndTerm, PlaneVerdict, PlaneWitness};

use crate::geom::{BigPoint2, Point2};
use crate::num::Sign;
use crate::predicates::{orient2d, orient2d_big};
use std::cmp::Ordering;
use std::ops::Range;

/// A growing and shrinking sequence of segments.
#[derive(Clone, Debug, Default)]
pub struct Hourglass {
    ends: Ends,
    /// The lists of all prefixes, one after the other: indices into `ends`.
    arena: Vec<u32>,
    /// What holds after each push.
    states: Vec<State>,
}

/// The ends pushed so far; number 2i is the left end of segment i, 2i + 1 its right end.
#[derive(Clone, Debug)]
enum Ends {
    /// All coordinates are within ±2^53.
    Small(Vec<Point2>),
    /// Some are not.
    Big(Vec<BigPoint2>),
}

impl Default for Ends {
    fn default() -> Ends {
        Ends::Small(Vec::new())
    }
}

/// What holds after a push.
#[derive(Clone, Debug, PartialEq, Eq)]
enum State {
    /// Open: the ends that bound the cone, a part of the arena.
    Open(Range<usize>),
    /// Not open: the list before the end that closed the cone, and that end.
    Closed(Range<usize>, u32),
}

/// What one more half-space does to a cone.
enum Cut {
    /// Nothing.
    Redundant,
    /// The new list stands at the arena's end.
    Shrunk(Range<usize>),
    /// No interior is left.
    Closed,
}

impl Hourglass {
    /// The empty sequence.
    pub fn new() -> Hourglass {
        Hourglass::default()
    }

    /// How many segments are in the sequence.
    pub fn depth(&self) -> usize {
        self.states.len()
    }

    /// Appends a segment: first the end on the line's left, then the one on its right.
    ///
    /// # Panics
    /// If the ends are one point.
    pub fn push(&mut self, left: Point2, right: Point2) {
        assert!(left != right, "a segment with one end");
        match &mut self.ends {
            Ends::Small(points) => points.extend([left, right]),
            Ends::Big(points) => points.extend([left.into(), right.into()]),
        }
        self.advance();
    }

    /// Appends a segment with unbounded coordinates. One end beyond ±2^53 makes all later tests
    /// slower.
    ///
    /// # Panics
    /// If the ends are one point.
    pub fn push_big(&mut self, left: BigPoint2, right: BigPoint2) {
        if let (Some(left), Some(right)) = (left.to_small(), right.to_small()) {
            self.push(left, right);
            return;
        }
        assert!(left != right, "a segment with one end");
        if let Ends::Small(points) = &self.ends {
            self.ends = Ends::Big(points.iter().map(|&p| p.into()).collect());
        }
        if let Ends::Big(points) = &mut self.ends {
            points.extend([left, right]);
        }
        self.advance();
    }

    /// Takes the last segment away.
    ///
    /// # Panics
    /// If the sequence is empty.
    pub fn pop(&mut self) {
        assert!(self.states.pop().is_some(), "pop from an empty sequence");
        let ends = 2 * self.states.len();
        match &mut self.ends {
            Ends::Small(points) => points.truncate(ends),
            Ends::Big(points) => points.truncate(ends),
        }
        let used = match self.states.last() {
            Some(State::Open(list) | State::Closed(list, _)) => list.end,
            None => 0,
        };
        self.arena.truncate(used);
    }

    /// Whether some line strictly separates left and right ends; true for the empty sequence.
    pub fn is_open(&self) -> bool {
        !matches!(self.states.last(), Some(State::Closed(..)))
    }

    /// The state after the two ends that were pushed last.
    fn advance(&mut self) {
        let right = 2 * self.states.len() as u32 + 1;
        let state = match self.states.last() {
            None => {
                self.arena.extend([right - 1, right]);
                State::Open(0..2)
            }
            Some(State::Open(list)) => self.add_both(list.clone(), right),
            Some(closed) => closed.clone(),
        };
        self.states.push(state);
    }

    fn add_both(&mut self, mut list: Range<usize>, right: u32) -> State {
        for end in [right - 1, right] {
            match self.cut(&list, end) {
                Cut::Redundant => {}
                Cut::Shrunk(shorter) => list = shorter,
                Cut::Closed => return State::Closed(list, end),
            }
        }
        State::Open(list)
    }

    /// Cuts the cone of `list` with the half-space of `end`.
    fn cut(&mut self, list: &Range<usize>, end: u32) -> Cut {
        let at = |i: usize| self.arena[list.start + i % list.len()];
        let n = list.len();
        let mut sides = (0..n).map(|i| self.sign(at(i), at(i + 1), end));
        if n == 2 {
            let (first, second) = (at(0), at(1));
            return match self.sign(first, second, end) {
                Sign::Positive => self.store([first, second, end]),
                Sign::Negative => self.store([second, first, end]),
                // All ends so far are on one line, and so is this one.
                Sign::Zero => self.cut_on_line(first, second, end),
            };
        }
        if sides.all(|side| side != Sign::Negative) {
            // Every extremal line passes on the good side of the end, or touches it.
            return Cut::Redundant;
        }
        let good = |i: usize| self.sign(at(i), at(i + 1), end) == Sign::Positive;
        // An extremal line through the end (zero) is not kept: it would make two neighbours of the
        // new end collinear with it, and a cone with nothing but such lines has no interior.
        let Some(start) = (0..n).find(|&i| good(i) && !good(i + n - 1)) else {
            return Cut::Closed;
        };
        let length = (1..n).find(|&k| !good(start + k)).unwrap_or(n);
        let kept: Vec<u32> = (start..=start + length).map(at).collect();
        self.store(kept.into_iter().chain([end]))
    }

    /// The cut where all ends are on one line; `left` and `right` bound the gap.
    fn cut_on_line(&mut self, left: u32, right: u32, end: u32) -> Cut {
        let (same, other) =
            if is_left(end) == is_left(left) { (left, right) } else { (right, left) };
        let outward = self.order(other, same);
        if self.order(other, end) != outward {
            // At the other side's end, or beyond it: left and right ends overlap.
            return Cut::Closed;
        }
        if self.order(end, same) != outward {
            return Cut::Redundant;
        }
        if is_left(end) == is_left(left) {
            self.store([end, right])
        } else {
            self.store([left, end])
        }
    }

    fn store(&mut self, list: impl IntoIterator<Item = u32>) -> Cut {
        let start = self.arena.len();
        self.arena.extend(list);
        Cut::Shrunk(start..self.arena.len())
    }

    /// The sign of the half-space of `c` on the extremal line between the neighbours `a` and `b`:
    /// det(±a, ±b, ±c), each end as (x, y, 1) with the sign of its side.
    fn sign(&self, a: u32, b: u32, c: u32) -> Sign {
        let turn = self.turn(a, b, c);
        if is_left(a + b + c) { turn } else { -turn }
    }

    fn turn(&self, a: u32, b: u32, c: u32) -> Sign {
        let [a, b, c] = [a, b, c].map(|end| end as usize);
        match &self.ends {
            Ends::Small(points) => orient2d(&points[a], &points[b], &points[c]),
            Ends::Big(points) => orient2d_big(&points[a], &points[b], &points[c]),
        }
    }

    /// The order of two ends from left to right and, on one vertical, upwards: on any line, an
    /// order along it.
    fn order(&self, a: u32, b: u32) -> Ordering {
        let (a, b) = (a as usize, b as usize);
        match &self.ends {
            Ends::Small(points) => points[a].integers().cmp(&points[b].integers()),
            Ends::Big(points) => points[a].cmp(&points[b]),
        }
    }

    fn point(&self, end: u32) -> BigPoint2 {
        match &self.ends {
            Ends::Small(points) => points[end as usize].into(),
            Ends::Big(points) => points[end as usize].clone(),
        }
    }
}

/// Whether the end with this number is a left one; for a sum of numbers, whether an even number of
/// them are right ones.
fn is_left(end: u32) -> bool {
    end.is_multiple_of(2)
}

#[cfg(test)]
mod tests;
