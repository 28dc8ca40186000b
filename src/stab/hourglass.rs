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
//! redundant.
//!
//! Complexity: with h ends on the hourglass, a push is O(log h) orientation tests and a pop is O(1)
//! (`chains`). A verdict other than open is O(m) for m segments, O(m²) where a left and a right end
//! coincide.

mod answer;
pub(crate) mod chains;
mod window;

pub use answer::{End, EndTerm, PlaneVerdict, PlaneWitness};

use crate::geom::{BigPoint2, Point2};
use crate::num::Sign;
use crate::predicates::{orient2d, orient2d_big};
use chains::{Chains, Place, Side};
use std::cmp::Ordering;

/// A growing and shrinking sequence of segments.
#[derive(Clone, Debug, Default)]
pub struct Hourglass {
    ends: Ends,
    chains: Chains,
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

impl Hourglass {
    /// The empty sequence.
    pub fn new() -> Hourglass {
        Hourglass::default()
    }

    /// How many segments are in the sequence.
    pub fn depth(&self) -> usize {
        self.chains.depth()
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
        self.chains.pop();
        let ends = 2 * self.chains.depth();
        match &mut self.ends {
            Ends::Small(points) => points.truncate(ends),
            Ends::Big(points) => points.truncate(ends),
        }
    }

    /// Whether some line strictly separates left and right ends; true for the empty sequence.
    pub fn is_open(&self) -> bool {
        self.chains.is_open()
    }

    /// Cuts the cone with the half-spaces of the two ends that were added last.
    fn advance(&mut self) {
        let left = 2 * self.chains.depth() as u32;
        self.chains.push(&self.ends, left, left + 1, Place::Anywhere);
    }

    /// The ends that bound the cone, as the module's text describes the list, with the one that
    /// was pushed last at its end; of a sequence that is not open, before the end that closed it.
    fn list(&self) -> Vec<u32> {
        let [left, right] = [Side::Left, Side::Right].map(|side| self.chains.chain(side));
        let mut list = [left, right].concat();
        let newest = list.iter().enumerate().max_by_key(|(_, end)| **end).map_or(0, |(i, _)| i);
        if list.len() > 2 {
            list.rotate_left(newest + 1);
        }
        list
    }

    fn point(&self, end: u32) -> BigPoint2 {
        match &self.ends {
            Ends::Small(points) => points[end as usize].into(),
            Ends::Big(points) => points[end as usize].clone(),
        }
    }
}

impl chains::Ends for Ends {
    fn turn(&self, a: u32, b: u32, c: u32) -> Sign {
        let [a, b, c] = [a, b, c].map(|end| end as usize);
        match self {
            Ends::Small(points) => orient2d(&points[a], &points[b], &points[c]),
            Ends::Big(points) => orient2d_big(&points[a], &points[b], &points[c]),
        }
    }

    /// From left to right and, on one vertical, upwards.
    fn order(&self, a: u32, b: u32) -> Ordering {
        let (a, b) = (a as usize, b as usize);
        match self {
            Ends::Small(points) => points[a].integers().cmp(&points[b].integers()),
            Ends::Big(points) => points[a].cmp(&points[b]),
        }
    }
}

/// Whether the end with this number is a left one.
fn is_left(end: u32) -> bool {
    end.is_multiple_of(2)
}

#[cfg(test)]
mod tests;
