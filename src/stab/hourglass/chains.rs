//! The two chains of an hourglass, on ends that are known by number.
//!
//! The cyclic list of the ends that bound the cone (see the parent module) starts with the left
//! chain and goes on with the right one. Edge i of it is the extremal line between end i and the
//! next; two edges join the chains, the *late* one of the left chain with the *early* one of the
//! right, and the other way round. A new end leaves of the list one run of ends, between which it
//! goes: those of the edges on whose good side it is, which are consecutive.
//!
//! The run is found from one edge that is kept and one that is not, by binary search between them.
//! Three edges at most have to be looked at to find both, or that there are none: the list is a
//! convex polygon on the sphere of half-spaces, the good edges are those that the new point does
//! not see, and the fan of lines from the list's first end tells where the rest of the polygon
//! lies, seen past that end.
//!
//! **Portals of convex cells** that do not overlap ([`Place::Beyond`]) come in an order that lines
//! keep. Call the cell that was last come into C, and take a line of the closed cone through a new
//! end in C. It touches every portal so far, one after the other, and then is in C until it leaves
//! it: it meets the new end after those of the chains that it touches. (An end of a chain may lie
//! further along a line that runs in its portal; but then the new end would lie inside of that.)
//! So a new left end can only be the last of its chain, next to the edge from the late left end to
//! the early right one: on the good side of that edge it is redundant, and else the other joining
//! edge stays, or nothing is left. There are two exceptions. The other end of the very same portal
//! may come later on a line, which then runs in that portal: such a line is the other joining
//! edge, which stays as a line, but between other ends. And where the new end and the last portal
//! lie on one edge of C, a line in that edge may meet the new end first. No other line through the
//! end passes that portal, so the end cuts off nothing or all, and any edge that does not touch it
//! tells which.
//!
//! In such sequences a chain is a window that loses ends at both sides and gains them at its end.
//! It lies in an array; the one number that a push writes over is kept, and put back by the pop.
//! Elsewhere a chain with a new end in its midst is written anew, behind the array.

use super::window::{Undo, Window};
use crate::num::Sign;
use crate::predicates::{PlanPoints, compare_coordinates};
use std::cmp::Ordering;

/// What the chains ask about the ends of segments, which have numbers.
pub(crate) trait Ends {
    /// Whether three ends turn left.
    fn turn(&self, a: u32, b: u32, c: u32) -> Sign;

    /// An order of all ends that on each line is an order along it.
    fn order(&self, a: u32, b: u32) -> Ordering;
}

impl Ends for PlanPoints {
    #[inline]
    fn turn(&self, a: u32, b: u32, c: u32) -> Sign {
        PlanPoints::turn(self, a, b, c)
    }

    fn order(&self, a: u32, b: u32) -> Ordering {
        let [a, b] = [a, b].map(|end| self.get(end));
        compare_coordinates(0, a, b).then_with(|| compare_coordinates(1, a, b))
    }
}

/// Where the ends of a new segment can be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Place {
    /// Anywhere.
    Anywhere,
    /// In the closed convex cell that all lines through the sequence so far have come into by its
    /// last segment. The segments are portals of cells that do not overlap, one cell after the
    /// other.
    Beyond,
}

/// The side of a line that an end has to be on; also the index of its chain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Side {
    Left = 0,
    Right = 1,
}

use Side::{Left, Right};

/// An end of a segment, with its side.
pub(super) type SidedEnd = (u32, Side);

/// The hourglass of a growing and shrinking sequence.
///
/// Invariants: both chains are empty, or neither is; three consecutive ends of the list are not
/// collinear (where there are three); no end is redundant. While all ends are on one line, the
/// chains are the innermost left and right end.
#[derive(Clone, Debug, Default)]
pub(crate) struct Chains {
    chains: [Window; 2],
    /// The depth at which the cone was closed, and the end that did it.
    closed: Option<(u32, SidedEnd)>,
    undo: Vec<[Undo; 2]>,
}

/// The ends of the list that are kept: from `first` on to `last`, inclusive, around.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Run {
    pub(super) first: usize,
    pub(super) last: usize,
}

/// What a new end does to the cone.
pub(super) enum Cut {
    Redundant,
    Shrunk(Run),
    Closed,
}

/// Edges to begin the search of the run with.
enum Probe {
    Redundant,
    Closed,
    /// One that is kept, and one that is not.
    Edges {
        good: usize,
        bad: usize,
    },
}

impl Chains {
    /// How many segments are in the sequence.
    pub fn depth(&self) -> usize {
        self.undo.len()
    }

    /// Whether some line strictly separates left and right ends.
    #[inline]
    pub fn is_open(&self) -> bool {
        self.closed.is_none()
    }

    /// The end that closed the cone.
    pub fn closed_by(&self) -> Option<SidedEnd> {
        self.closed.map(|(_, end)| end)
    }

    /// The ends of one chain, in the order in which lines pass them; before the cone was closed.
    pub fn chain(&self, side: Side) -> &[u32] {
        self.chains[side as usize].ends()
    }

    /// Appends a segment; whether the sequence is open.
    ///
    /// O(log k) turns for k ends on the chains; where ends come in no order, O(k) copies more.
    pub fn push(&mut self, ends: &impl Ends, left: u32, right: u32, place: Place) -> bool {
        let mut undo = [self.chains[0].undo(), self.chains[1].undo()];
        if self.chains[0].len() == 0 {
            self.chains[0].insert(0, left, 0, &mut undo[0]);
            self.chains[1].insert(0, right, 0, &mut undo[1]);
        } else if self.closed.is_none() {
            for end in [(left, Left), (right, Right)] {
                match self.cut(ends, end, place) {
                    Cut::Redundant => {}
                    Cut::Shrunk(run) => self.replace(run, end, &mut undo),
                    Cut::Closed => {
                        self.closed = Some((self.undo.len() as u32, end));
                        break;
                    }
                }
            }
        }
        self.undo.push(undo);
        self.closed.is_none()
    }

    /// Takes the last segment away: O(1).
    ///
    /// # Panics
    /// If the sequence is empty.
    pub fn pop(&mut self) {
        let Some(undo) = self.undo.pop() else { panic!("pop from an empty sequence") };
        for (chain, undo) in self.chains.iter_mut().zip(&undo) {
            chain.restore(undo);
        }
        if self.closed.is_some_and(|(depth, _)| depth as usize == self.undo.len()) {
            self.closed = None;
        }
    }

    pub(super) fn len(&self) -> usize {
        self.chains[0].len() + self.chains[1].len()
    }

    /// End `i` of the list, which goes around once at most.
    #[inline]
    pub(super) fn at(&self, i: usize) -> SidedEnd {
        let [left, right] = &self.chains;
        let i = if i >= self.len() { i - self.len() } else { i };
        if i < left.len() { (left.at(i), Left) } else { (right.at(i - left.len()), Right) }
    }

    /// det(±a, ±b, ±c), each end as (x, y, 1) with the sign of its side, a and b by their places.
    #[inline]
    fn sign(&self, ends: &impl Ends, a: usize, b: usize, (c, c_side): SidedEnd) -> Sign {
        let ((a, a_side), (b, b_side)) = (self.at(a), self.at(b));
        let turn = ends.turn(a, b, c);
        if (a_side as u8 ^ b_side as u8 ^ c_side as u8) == 0 { turn } else { -turn }
    }

    /// The sign of an end on edge `i`.
    #[inline]
    pub(super) fn edge(&self, ends: &impl Ends, i: usize, new: SidedEnd) -> Sign {
        self.sign(ends, i, i + 1, new)
    }

    pub(super) fn cut(&self, ends: &impl Ends, new: SidedEnd, place: Place) -> Cut {
        if self.len() == 2 {
            return self.cut_pair(ends, new);
        }
        let probe = match place {
            Place::Anywhere => self.probe(ends, new),
            Place::Beyond => self.probe_beyond(ends, new),
        };
        match probe {
            Probe::Redundant => Cut::Redundant,
            Probe::Closed => Cut::Closed,
            Probe::Edges { good, bad } => Cut::Shrunk(self.run(ends, new, good, bad)),
        }
    }

    /// The cut where all ends so far are on one line.
    fn cut_pair(&self, ends: &impl Ends, new: SidedEnd) -> Cut {
        match self.sign(ends, 0, 1, new) {
            Sign::Positive => Cut::Shrunk(Run { first: 0, last: 1 }),
            Sign::Negative => Cut::Shrunk(Run { first: 1, last: 0 }),
            // And so is this one.
            Sign::Zero => {
                let (end, side) = new;
                let (same, other) = (self.at(side as usize).0, self.at(1 - side as usize).0);
                let outward = ends.order(other, same);
                if ends.order(other, end) != outward {
                    // At the other side's end, or beyond it: left and right ends overlap.
                    Cut::Closed
                } else if ends.order(end, same) != outward {
                    Cut::Redundant
                } else {
                    let kept = 1 - side as usize;
                    Cut::Shrunk(Run { first: kept, last: kept })
                }
            }
        }
    }

    /// Begins the search where nothing is known of the new end.
    fn probe(&self, ends: &impl Ends, new: SidedEnd) -> Probe {
        let n = self.len();
        let (next, previous) = (self.edge(ends, 0, new), self.edge(ends, n - 1, new));
        let third = match (next, previous) {
            // On a line through the first end and a neighbour: the edge beyond that decides
            // whether it is the neighbour's side, and how far.
            (Sign::Zero, _) => 1,
            (_, Sign::Zero) => n - 2,
            // The first end lies on the way to the polygon, or opposite to the new one: the edge
            // that the line through both meets.
            (Sign::Positive, Sign::Positive) | (Sign::Negative, Sign::Negative) => {
                self.across(ends, new, next)
            }
            (Sign::Positive, Sign::Negative) | (Sign::Negative, Sign::Positive) => 0,
        };
        let signs = [(0, next), (n - 1, previous), (third, self.edge(ends, third, new))];
        let with = |wanted: Sign| signs.iter().find(|(_, sign)| *sign == wanted).map(|(i, _)| *i);
        match (with(Sign::Positive), with(Sign::Negative)) {
            (_, None) => Probe::Redundant,
            (None, Some(_)) => Probe::Closed,
            (Some(good), Some(bad)) => Probe::Edges { good, bad },
        }
    }

    /// The edge that the line through the list's first end and the new one meets; `next` is the
    /// sign on the first edge.
    fn across(&self, ends: &impl Ends, new: SidedEnd, next: Sign) -> usize {
        let (mut low, mut high) = (1, self.len() - 1);
        while high - low > 1 {
            let middle = (low + high) / 2;
            if self.sign(ends, 0, middle, new) == -next {
                high = middle;
            } else {
                low = middle;
            }
        }
        low
    }

    /// Begins the search for an end beyond the others.
    fn probe_beyond(&self, ends: &impl Ends, new: SidedEnd) -> Probe {
        let late = [self.chains[0].len() - 1, self.len() - 1];
        let (bad, far) = (late[new.1 as usize], late[1 - new.1 as usize]);
        let touches = match self.edge(ends, bad, new) {
            Sign::Positive => return Probe::Redundant,
            Sign::Zero => true,
            Sign::Negative => false,
        };
        match (touches, self.edge(ends, far, new)) {
            (true, Sign::Positive) => Probe::Redundant,
            (false, Sign::Positive) => Probe::Edges { good: far, bad },
            (_, Sign::Negative) => Probe::Closed,
            // At the one end of a chain: it is that end, or the same point on the other side.
            (true, Sign::Zero) => {
                let other = (0..self.len()).find(|&i| i != bad && i != far).unwrap_or(bad);
                match self.edge(ends, other, new) {
                    Sign::Positive | Sign::Zero => Probe::Redundant,
                    Sign::Negative => Probe::Closed,
                }
            }
            // A line in the portal itself. The edge before it is of the other chain, if that has
            // one, or else the bad one.
            (false, Sign::Zero) => {
                let good = far.checked_sub(1).unwrap_or(bad);
                match self.edge(ends, good, new) {
                    Sign::Positive => Probe::Edges { good, bad },
                    Sign::Negative | Sign::Zero => Probe::Closed,
                }
            }
        }
    }

    /// The run of ends whose edges are kept. An edge through the new end (zero) is not: it would
    /// make two neighbours of the new end collinear with it.
    fn run(&self, ends: &impl Ends, new: SidedEnd, good: usize, bad: usize) -> Run {
        let n = self.len();
        let around = |i: usize| if i >= n { i - n } else { i };
        let search = |limit: usize, place: &dyn Fn(usize) -> usize| {
            let (mut kept, mut lost) = (0, limit);
            while lost - kept > 1 {
                let middle = (kept + lost) / 2;
                match self.edge(ends, place(middle), new) {
                    Sign::Positive => kept = middle,
                    Sign::Zero | Sign::Negative => lost = middle,
                }
            }
            kept
        };
        let after = search(around(bad + n - good), &|k| around(good + k));
        let before = search(around(good + n - bad), &|k| around(good + n - k));
        Run { first: around(good + n - before), last: around(good + after + 1) }
    }

    /// Leaves a run of the list, and puts the new end behind it.
    fn replace(&mut self, Run { first, last }: Run, (end, side): SidedEnd, undo: &mut [Undo; 2]) {
        let left = self.chains[0].len();
        let (own, other) = (side as usize, 1 - side as usize);
        // The place within one chain, if it is there.
        let within = |chain: usize, i: usize| match chain {
            0 => (i < left).then_some(i),
            _ => i.checked_sub(left),
        };
        let before = within(own, last).map_or(0, |i| i + 1);
        let after = within(own, first).map_or(0, |i| self.chains[own].len() - i);
        let rest = &mut self.chains[other];
        let until = within(other, last).map_or(rest.len(), |i| i + 1);
        rest.keep(within(other, first).unwrap_or(0)..until);
        self.chains[own].insert(before, end, after, &mut undo[own]);
    }
}
