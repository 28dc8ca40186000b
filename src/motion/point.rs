//! The way of a point: when it can first be in each cell.
//!
//! A closed cell holds a straight move for one interval of time, and so does a closed portal. A
//! cell that is entered at the time e can be left through a portal at any time of the portal's
//! interval that is not before e. So the earliest entries are shortest ways in a graph (Dijkstra
//! 1959), and the point gets as far as the latest end of an interval of a cell that it enters.
//! Nothing is special about a move through an edge or a vertex, or within a portal's plane: the
//! point is then in several closed cells or portals at once, and all of them are tried.
//!
//! **What is hit.** At the end T of the way no cell entered goes on in the direction d. On a
//! straight line of directions from a general one inside the cones of these cells to d there is a
//! last one, y, in one of the cones, in the inside of a face with normal n; since y is on the face
//! and d beyond it, n·d > 0. Beyond the face near y there is no other cell, or a portal around y
//! would lead on: so something blocks there, and its closed face contains the point at T. What is
//! hit is therefore found among the bodies that touch the cell, have the face's plane the other way
//! round, and contain the point.

use super::path::{Moment, Path, Span};
use super::{Hit, MoveError, Space, Stay, Walk};
use crate::geom::{BigPlane, RationalPoint3};
use crate::num::Rational;
use crate::scene::CellId;
use rustc_hash::FxHashSet;
use std::cmp::Reverse;
use std::collections::{BTreeSet, BinaryHeap};

/// A cell with the interval from its earliest entry.
pub(super) type Entry = (CellId, Span);

impl Space<'_> {
    pub(super) fn walk_point(
        &self,
        from: &RationalPoint3,
        to: &RationalPoint3,
    ) -> Result<Walk, MoveError> {
        let path = Path::of_point(from, to);
        let entries = self.entries(from, &path)?;
        let last = entries.iter().map(|(_, span)| &span.high).max();
        let last = last.expect("the start is in a cell").clone();
        let hits = if last < Moment::end() { self.walls(&path, &entries, &last) } else { vec![] };
        let stays = entries.iter().map(|entry| stay(entry, &last)).collect();
        Ok(Walk { time: Rational::from(&last), point: path.at(&last), hits, stays })
    }

    /// The cells that a point on the path can be in, in the order of their earliest entries.
    ///
    /// # Errors
    /// The start is in none.
    pub(super) fn entries(
        &self,
        from: &RationalPoint3,
        path: &Path,
    ) -> Result<Vec<Entry>, MoveError> {
        let start = self.locate(from);
        if start.is_empty() {
            return Err(MoveError::Nowhere {
                point: Box::new(from.clone()),
                solid: self.solid_at(from),
            });
        }
        let mut queue: BinaryHeap<_> =
            start.into_iter().map(|cell| Reverse((Moment::start(), cell))).collect();
        let (mut entries, mut entered) = (Vec::new(), FxHashSet::default());
        while let Some(Reverse((enter, id))) = queue.pop() {
            if !entered.insert(id) {
                continue;
            }
            let cell = &self.cells[id.0 as usize];
            let faces = cell.faces.iter().map(|&face| self.planes.plane(face));
            let inside = path.within(faces).expect("the point is in the cell when it enters");
            for &gate in &cell.gates {
                let gate = &self.gates[gate as usize];
                let beyond = gate.beyond(id);
                if entered.contains(&beyond) {
                    continue;
                }
                let Some(open) = path.within(&gate.polygon) else { continue };
                if open.high >= enter {
                    queue.push(Reverse((open.low.max(enter.clone()), beyond)));
                }
            }
            entries.push((id, Span { low: enter, high: inside.high }));
        }
        Ok(entries)
    }

    /// The obstacles' faces that stop the point at the moment when all entries end.
    fn walls(&self, path: &Path, entries: &[Entry], last: &Moment) -> Vec<Hit> {
        let point = path.at(last);
        let here = Path::of_point(&point, &point);
        let mut walls = BTreeSet::new();
        for (id, _) in entries.iter().filter(|(_, span)| span.high == *last) {
            let cell = &self.cells[id.0 as usize];
            let exits = |face| path.leaves(self.planes.plane(face), last);
            for face in cell.faces.iter().copied().filter(|&face| exits(face)) {
                let wall = face.flipped();
                walls.extend(cell.near.iter().copied().filter_map(|body| {
                    let faces = &self.bodies[body as usize].faces;
                    faces.contains(&wall).then_some((body, wall))
                }));
            }
        }
        let touched = walls
            .into_iter()
            .filter(|&(body, _)| here.within(self.bodies[body as usize].half_spaces()).is_some());
        let hit = |(body, wall): (u32, _)| {
            let body = &self.bodies[body as usize];
            Hit::new(body.obstacle, self.planes.plane(wall), super::Touch::Face)
        };
        touched.map(hit).collect()
    }
}

impl Hit {
    pub(super) fn new(obstacle: super::Obstacle, plane: &BigPlane, touch: super::Touch) -> Hit {
        let normal = super::body::direction(&plane.normal);
        let axis = (0..3).find(|&i| normal[i] != 0.into()).expect("a plane has a normal");
        let divisor = &plane.normal[axis] / &normal[axis];
        let offset = Rational::new(plane.offset.clone(), divisor);
        Hit { obstacle, normal, offset, touch }
    }
}

/// A cell on a way that ends at a moment.
pub(super) fn stay((cell, span): &Entry, last: &Moment) -> Stay {
    let leave = (&span.high).min(last);
    Stay { cell: *cell, enter: (&span.low).into(), leave: leave.into() }
}
