//! The way of a box: the first body that its inside would enter.
//!
//! Bodies are looked for near the cells that a flood reaches from the cells of the box's middle,
//! through portals whose axial boxes the moving box touches, each portal taken at the moment of the
//! first touch or of entering its cell, whichever is later. The flood ends at the first contact.
//!
//! **Nothing is missed.** Let T be the first contact with any body of the world, and W the union of
//! the open boxes at all times up to T: open, connected, and without a common point with solids
//! (a solid that an open set meets, it meets in its inside) or polygons. W is covered by closed
//! cells and unreached empty leaves. Edges of leaves, and edges of polygons, have codimension two,
//! so W without them is still connected, and two leaves that W passes between there share a piece
//! of a face within W, free of polygons: a portal, which the box touches by the time T. So the
//! leaves that meet W are joined by such portals to those of the box's middle, and the flood
//! reaches all of them; being joined to a cell by portals, they are cells. A body B that is
//! entered at T has a point in common with the closed box then, hence with the closure of W, and
//! (the leaves being finitely many) with a closed cell that meets W: B is near that cell. If the
//! box overlaps something at the start, the same holds for the part of the open box around its
//! middle that is free, whose boundary within the open box lies in a body that it overlaps.

use super::path::{Moment, Path};
use super::point::stay;
use super::{Hit, Move, MoveError, Obstacle, Space, Walk};
use crate::geom::{AxialBox, RationalPoint3};
use crate::num::{Int, Rational};
use rustc_hash::FxHashSet;
use std::cmp::{Ordering, Reverse};
use std::collections::BinaryHeap;

impl Space<'_> {
    pub(super) fn walk_box(&self, motion: &Move, body: &AxialBox) -> Result<Walk, MoveError> {
        let path = Path::of_box(&motion.from, &motion.to, body);
        let middle = |point: &RationalPoint3| {
            let point = point.coordinates();
            let half = |i: usize| (&body.low[i] + &body.high[i]) / Int::from(2);
            RationalPoint3::from(&[0, 1, 2].map(|i| &point[i] + half(i)))
        };
        let (start, end) = (middle(&motion.from), middle(&motion.to));
        let entries = self.entries(&start, &Path::of_point(&start, &end))?;
        let (last, hits) = self.first_hits(&path, &start)?;
        // Inside the box, the middle gets at least as far.
        debug_assert!(entries.iter().any(|(_, span)| span.high >= last));
        let stays = entries.iter().filter(|(_, span)| span.low <= last);
        let stays = stays.map(|entry| stay(entry, &last)).collect();
        Ok(Walk { time: Rational::from(&last), point: path.at(&last), hits, stays })
    }

    /// When the box, whose middle starts at a point in a cell, first touches what it would enter,
    /// and what that is; the end and nothing where it enters nothing.
    fn first_hits(
        &self,
        path: &Path,
        start: &RationalPoint3,
    ) -> Result<(Moment, Vec<Hit>), MoveError> {
        let (mut last, mut hit) = (Moment::end(), Vec::new());
        let (mut tried, mut flooded) = (FxHashSet::default(), FxHashSet::default());
        let mut queue: BinaryHeap<_> =
            self.locate(start).into_iter().map(|cell| Reverse((Moment::start(), cell))).collect();
        while let Some(Reverse((moment, id))) = queue.pop() {
            if moment > last {
                break;
            }
            if !flooded.insert(id) {
                continue;
            }
            let cell = &self.cells[id.0 as usize];
            for &near in cell.near.iter().filter(|&&near| tried.insert(near)) {
                let Some(first) = self.enters(path, near)? else { continue };
                match first.cmp(&last) {
                    Ordering::Less => (last, hit) = (first, vec![near]),
                    Ordering::Equal => hit.push(near),
                    Ordering::Greater => {}
                }
            }
            for gate in cell.gates.iter().map(|&gate| &self.gates[gate as usize]) {
                let beyond = gate.beyond(id);
                if flooded.contains(&beyond) {
                    continue;
                }
                if let Some(span) = path.within(&gate.around) {
                    queue.push(Reverse((span.low.max(moment.clone()), beyond)));
                }
            }
        }
        hit.sort_unstable();
        let hits = hit.into_iter().flat_map(|body| {
            let body = &self.bodies[body as usize];
            let sides = body.sides.iter().filter(|side| path.enters(&side.plane, &last));
            sides.map(|side| Hit::new(body.obstacle, &side.plane, side.touch)).collect::<Vec<_>>()
        });
        let hits = hits.collect();
        Ok((last, hits))
    }

    /// When the box begins to overlap a body, if it does before the end.
    ///
    /// # Errors
    /// It overlaps the body from the start.
    fn enters(&self, path: &Path, body: u32) -> Result<Option<Moment>, MoveError> {
        let body = &self.bodies[body as usize];
        let Some(span) = path.overlap(body.half_spaces()) else { return Ok(None) };
        if span.low == Moment::start() && !body.half_spaces().any(|p| path.enters(p, &span.low)) {
            return Err(MoveError::Overlap { obstacle: body.obstacle });
        }
        Ok(Some(span.low))
    }

    /// When the box begins to overlap each obstacle of the world that it ever does, each on its
    /// own, without any portals.
    ///
    /// # Errors
    /// It overlaps one from the start, or has no volume.
    pub fn overlaps(&self, motion: &Move) -> Result<Vec<(Rational, Obstacle)>, MoveError> {
        let Some(body) = motion.body.as_ref().filter(|body| body.has_volume()) else {
            return Err(MoveError::NoVolume);
        };
        let path = Path::of_box(&motion.from, &motion.to, body);
        let mut overlaps = Vec::new();
        for (body, index) in self.bodies.iter().zip(0u32..) {
            if let Some(first) = self.enters(&path, index)? {
                overlaps.push((Rational::from(&first), body.obstacle));
            }
        }
        Ok(overlaps)
    }
}
