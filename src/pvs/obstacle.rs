//! Why the upper bound has no way between two cells: what fails on the shortest way.
//!
//! The bound is a statement about all ways; for a reader the shortest one, found breadth first, is
//! shown with the first portal that cannot follow an earlier one, and why it cannot. As the bound
//! leaves out the target, the last portal at least cannot follow the first.

use super::arena::{Arena, Directed};
use super::bounds::Bounds;
use crate::num::Sign;
use std::collections::VecDeque;

/// What is between two cells that the bound keeps apart.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Obstacle {
    /// No portals lead from the one to the other.
    NoWay,
    /// Portals do, but no line passes them.
    Shortest {
        /// The portals of the shortest way, by their numbers in the input.
        portals: Vec<u32>,
        /// Two of them, of which the second cannot follow the first.
        between: [u32; 2],
        /// Why it cannot.
        hindrance: Hindrance,
    },
}

/// Why a portal cannot be crossed after another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Hindrance {
    /// No part of the later portal is in front of the plane of the earlier.
    LaterBehind,
    /// No part of the earlier portal is behind the plane of the later.
    EarlierInFront,
    /// Everything between them is behind the plane of a portal on the way, or behind the planes
    /// that separate two portals on it.
    NothingBetween,
}

/// What is between the cells `from` and `to`, of which the bound has no way from one to the other.
pub(super) fn find(arena: &Arena, bounds: &Bounds, from: u32, to: u32) -> Obstacle {
    let Some(way) = shortest_way(arena, from, to) else { return Obstacle::NoWay };
    let pairs = (0..way.len()).flat_map(|later| (0..later).map(move |earlier| [earlier, later]));
    let closed = pairs.map(|pair| pair.map(|place| way[place])).find(|&[earlier, later]| {
        let after = |&a: &Directed| pieces(arena, later).any(|b| bounds.after(a).has(b));
        !pieces(arena, earlier).any(|a| after(&a))
    });
    let [earlier, later] = closed.expect("the bound keeps the cells apart");
    Obstacle::Shortest {
        portals: way.iter().map(|&portal| arena.source(portal)).collect(),
        between: [arena.source(earlier), arena.source(later)],
        hindrance: hindrance(arena, earlier, later),
    }
}

/// The fewest portals that lead from one cell to the other; of several ways, the one whose portals
/// come first.
fn shortest_way(arena: &Arena, from: u32, to: u32) -> Option<Vec<Directed>> {
    let mut entered_by: Vec<Option<Directed>> = vec![None; arena.cells() as usize];
    let mut queue = VecDeque::from([from]);
    while let Some(cell) = queue.pop_front() {
        for &portal in arena.leaving(cell) {
            let next = arena.to(portal);
            if next != from && entered_by[next as usize].is_none() {
                entered_by[next as usize] = Some(portal);
                queue.push_back(next);
            }
        }
    }
    let before = |portal: &Directed| entered_by[arena.from(*portal) as usize];
    let mut way: Vec<Directed> = std::iter::successors(entered_by[to as usize], before).collect();
    way.reverse();
    (!way.is_empty()).then_some(way)
}

/// The triangles of the same portal of the input, crossed in the same direction; itself, if it is
/// whole.
fn pieces(arena: &Arena, portal: Directed) -> impl Iterator<Item = Directed> + '_ {
    let siblings = arena.leaving(arena.from(portal)).iter().copied();
    siblings.filter(move |&other| arena.source(other) == arena.source(portal))
}

fn hindrance(arena: &Arena, earlier: Directed, later: Directed) -> Hindrance {
    // Whether no vertex of one is on this side of a plane of the other.
    let none = |planes: Directed, vertices: Directed, side: Sign| {
        pieces(arena, planes).all(|plane| {
            let plane = arena.plane_of(plane);
            pieces(arena, vertices)
                .flat_map(|piece| arena.vertices(piece))
                .all(|&vertex| arena.side(plane, vertex) != side)
        })
    };
    if none(earlier, later, Sign::Positive) {
        Hindrance::LaterBehind
    } else if none(later, earlier, Sign::Negative) {
        Hindrance::EarlierInFront
    } else {
        Hindrance::NothingBetween
    }
}
