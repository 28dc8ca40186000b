//! Inside and outside: what is reached from points, and the shortest way out.

use super::Portal;
use crate::construct::{PlaneId, mean};
use crate::geom::RationalPoint3;
use crate::num::Sign;
use crate::predicates::side_of_point;
use crate::subdivision::{LeafId, Subdivision};
use std::collections::VecDeque;

/// What a flood from points through portals reaches.
#[derive(Clone, Debug)]
pub struct Flood {
    /// For each leaf whether it is reached: empty, and joined to a point by portals.
    pub inside: Vec<bool>,
    /// The points, by index, that lie in no empty leaf: in the solids or outside of the box.
    pub buried: Vec<usize>,
    /// A way from a point to the boundary of the box, if there is one.
    pub leak: Option<Leak>,
}

/// A way out, by as few portals as any.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Leak {
    /// The index of the point where it starts.
    pub start: usize,
    /// The leaves on the way; the last one touches the boundary of the box.
    pub leaves: Vec<LeafId>,
    /// The point, then a point inside of each portal on the way, then one inside the last leaf;
    /// between two points that lie in one face of a leaf, one inside that leaf. Consecutive points
    /// lie in one closed leaf, and their segment meets no occluder but at its ends.
    pub path: Vec<RationalPoint3>,
}

/// Floods the empty leaves from points, through portals.
///
/// A point between leaves starts in all of those that are empty.
pub fn flood(subdivision: &Subdivision, portals: &[Portal], points: &[RationalPoint3]) -> Flood {
    let leaves = subdivision.leaves.len();
    let mut ways: Vec<Vec<u32>> = vec![Vec::new(); leaves];
    for (index, portal) in portals.iter().enumerate() {
        ways[portal.from.0 as usize].push(index as u32);
        ways[portal.to.0 as usize].push(index as u32);
    }
    let mut inside = vec![false; leaves];
    let mut came: Vec<Came> = vec![Came::Point(0); leaves];
    let (mut buried, mut queue) = (Vec::new(), VecDeque::new());
    for (index, point) in points.iter().enumerate() {
        let located = subdivision.locate(point);
        let empty = located.iter().filter(|&&leaf| !subdivision.leaf(leaf).solid);
        let before = buried.len();
        buried.push(index);
        for &leaf in empty {
            buried.truncate(before);
            if !inside[leaf.0 as usize] {
                inside[leaf.0 as usize] = true;
                came[leaf.0 as usize] = Came::Point(index);
                queue.push_back(leaf);
            }
        }
    }
    let mut exit = None;
    while let Some(leaf) = queue.pop_front() {
        if exit.is_none() && subdivision.touches_bounds(leaf) {
            exit = Some(leaf);
        }
        for &way in &ways[leaf.0 as usize] {
            let portal = &portals[way as usize];
            let next = if portal.from == leaf { portal.to } else { portal.from };
            if !inside[next.0 as usize] {
                inside[next.0 as usize] = true;
                came[next.0 as usize] = Came::Portal(way, leaf);
                queue.push_back(next);
            }
        }
    }
    let leak = exit.map(|leaf| trace(subdivision, portals, points, &came, leaf));
    Flood { inside, buried, leak }
}

/// How a leaf was reached first.
#[derive(Clone, Copy)]
enum Came {
    /// It contains this point.
    Point(usize),
    /// Through this portal from this leaf.
    Portal(u32, LeafId),
}

/// The way back from a leaf to the point where it began, turned round.
fn trace(
    subdivision: &Subdivision,
    portals: &[Portal],
    points: &[RationalPoint3],
    came: &[Came],
    exit: LeafId,
) -> Leak {
    let inner = |leaf: LeafId| subdivision.leaf(leaf).cell.inner_point();
    let mut leaves = vec![exit];
    let mut path = vec![inner(exit)];
    let mut leaf = exit;
    // The plane that the last point of the path lies in.
    let mut plane: Option<PlaneId> = None;
    let lies_in = |point: &RationalPoint3, plane| {
        // In the plane of a face, the way along it might run across what lies in it.
        side_of_point(subdivision.planes.get(plane), point) == Sign::Zero
    };
    let start = loop {
        match came[leaf.0 as usize] {
            Came::Point(start) => break start,
            Came::Portal(portal, before) => {
                let polygon = &portals[portal as usize].polygon;
                let next = mean(polygon.points().into_iter());
                if plane.is_some_and(|plane| lies_in(&next, plane)) {
                    path.push(inner(leaf));
                }
                plane = Some(polygon.support());
                path.push(next);
                leaves.push(before);
                leaf = before;
            }
        }
    };
    if plane.is_some_and(|plane| lies_in(&points[start], plane)) {
        path.push(inner(leaf));
    }
    path.push(points[start].clone());
    leaves.reverse();
    path.reverse();
    Leak { start, leaves, path }
}
