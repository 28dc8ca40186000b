//! Whether a portal sequence is open: lines proposed and checked, then the exact cone.
//!
//! In order of cost: the line of the sequence without its last portal; a line found in floats,
//! rounded to small numbers and checked; the exact cone (`stab`), first of the few portals that
//! seem to block each other (if these let no line through, all together do not either), at last
//! of the whole sequence. What is known is kept for each portal of the current path and serves
//! its extensions.

use super::Tally;
use super::arena::{Arena, Directed};
use super::propose::{ConePoint, Proposal, SequenceCone};
use super::sightline::{Ray, Sightline};
use crate::num::Rational;
use crate::stab::{Witness, decide_open};

/// Whether a sequence is open.
pub(crate) enum Decision {
    Open(Sightline),
    NotOpen,
}

/// What is known of the sequence that ends with a portal of the path.
#[derive(Default)]
struct Known {
    point: ConePoint,
    ray: Option<Ray>,
}

/// Decides the sequences of a search.
pub(crate) struct Decider<'a> {
    arena: &'a Arena,
    known: Vec<Known>,
    cone: SequenceCone,
}

impl<'a> Decider<'a> {
    pub fn new(arena: &'a Arena) -> Decider<'a> {
        Decider { arena, known: Vec::new(), cone: SequenceCone::default() }
    }

    /// Forgets all but the first `length` portals.
    pub fn truncate(&mut self, length: usize) {
        self.known.truncate(length);
    }

    /// Notes that the path has grown by its last portal; `false` if its edges exclude each other,
    /// which is proved.
    pub fn extend(&mut self, path: &[Directed], tally: &mut Tally) -> bool {
        debug_assert_eq!(self.known.len() + 1, path.len(), "a path grows by one portal");
        let (arena, last) = (self.arena, path[path.len() - 1]);
        let before = self.known.last();
        let ray = before.and_then(|before| before.ray.as_ref()).filter(|ray| {
            ray.crosses(arena, last) && ray.keeps_order(arena, path[path.len() - 2], last)
        });
        let mut known = Known {
            point: before.map(|before| before.point.clone()).unwrap_or_default(),
            ray: ray.cloned(),
        };
        let mut possible = true;
        if known.ray.is_none() && !known.point.passes(arena, last) {
            self.cone.set(arena, path);
            if let Err(edges) = self.cone.find_point(&mut known.point)
                && arena.grid().exclude_each_other(&edges)
            {
                tally.excluded += 1;
                possible = false;
            }
        }
        self.known.push(known);
        possible
    }

    /// Decides the path, after [`Decider::extend`] for its last portal.
    pub fn decide(&mut self, path: &[Directed], tally: &mut Tally) -> Decision {
        let arena = self.arena;
        let known = self.known.last_mut().expect("the path was extended");
        if let Some(ray) = &known.ray {
            tally.inherited += 1;
            return Decision::Open(ray.sightline());
        }
        self.cone.set(arena, path);
        let mut members = vec![0, path.len() - 1];
        match self.cone.find_line(&mut known.point) {
            Proposal::Blocking(positions) => members.extend(positions),
            Proposal::Line(line) => {
                let mut rays = self.cone.roundings(arena, path, &line);
                let stabbing =
                    |line: Sightline| Ray::new(arena, &line).filter(|ray| ray.stabs(arena, path));
                if let Some(ray) = rays.find_map(stabbing) {
                    tally.proposed += 1;
                    let line = ray.sightline();
                    known.ray = Some(ray);
                    return Decision::Open(line);
                }
                members = (0..path.len()).collect();
            }
        }
        self.decide_exactly(path, members, tally)
    }

    /// Decides by exact cones: of the `members` of the path, then of more, last of all.
    fn decide_exactly(
        &self,
        path: &[Directed],
        mut members: Vec<usize>,
        tally: &mut Tally,
    ) -> Decision {
        while members.len() < path.len() {
            members.sort_unstable();
            members.dedup();
            let mut part = self.cone.restricted(&members);
            if let Proposal::Line(line) = part.find_line(&mut ConePoint::default()) {
                // These let a line through, it seems; the one it misses most may join them.
                match self.cone.most_missed(&line, &members) {
                    Some(missed) => members.push(missed),
                    None => break,
                }
                continue;
            }
            let subset: Vec<Directed> = members.iter().map(|&i| path[i]).collect();
            tally.cones += 1;
            if self.exact_line(&subset, &[]).is_none() {
                return Decision::NotOpen;
            }
            break;
        }
        let ordered = |pair: &[Directed]| self.arena.needs_order(pair[0], pair[1]);
        let orders: Vec<bool> =
            std::iter::once(false).chain(path.windows(2).map(ordered)).collect();
        tally.cones += 1;
        match self.exact_line(path, &orders) {
            None => Decision::NotOpen,
            Some(line) => {
                tally.cone_open += 1;
                Decision::Open(line)
            }
        }
    }

    /// A line through the portals, exactly, or `None` if there is none.
    fn exact_line(&self, portals: &[Directed], orders: &[bool]) -> Option<Sightline> {
        let (portals, [per_world, unit]) = self.arena.exact_portals(portals);
        let references: Vec<_> = portals.iter().collect();
        let witness = decide_open(&references, orders)?;
        Some(in_world(witness, &Rational::new(unit, per_world)))
    }
}

fn in_world(witness: Witness, unit: &Rational) -> Sightline {
    let points = witness.points.map(|point| point.map(|c| c * unit));
    Sightline::Rational(Box::new(points))
}
