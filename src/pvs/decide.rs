//! Whether a portal sequence is open: lines proposed and checked, then the exact cone.
//!
//! In order of cost: the line of the sequence without its last portal; a line found in floats,
//! rounded to small numbers and checked; the exact cone (`stab`), first of the few edges that
//! seem to block each other (if these let no line through, all together do not either), at last
//! of the whole sequence. What is known is kept for each portal of the current path and serves
//! its extensions.

use super::Tally;
use super::arena::{Arena, Directed};
use super::propose::{ConePoint, Proposal, SequenceCone};
use super::sightline::{Ray, Sightline};
use crate::num::Int;
use crate::stab::{Stabber, Witness, edges_exclude_lines};

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
        let mut proposal = self.cone.find_line(&mut known.point);
        if let Proposal::Blocking(places) = proposal {
            proposal = self.cone.close(places);
        }
        match proposal {
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
            }
            Proposal::Blocking(places) => {
                tally.cones += 1;
                if self.exclude_lines(path, &places) {
                    return Decision::NotOpen;
                }
            }
        }
        self.decide_exactly(path, tally)
    }

    /// Whether some of the path's edges, given by their places in the cone, let no line through,
    /// which is proved.
    fn exclude_lines(&self, path: &[Directed], places: &[usize]) -> bool {
        let edges: Vec<_> = places.iter().map(|&place| self.cone.edge(place)).collect();
        let portals: Vec<Directed> = edges.iter().map(|edge| path[edge.position]).collect();
        let (portals, _) = self.arena.exact_portals(&portals);
        let edges: Vec<_> =
            portals.into_iter().zip(&edges).map(|(portal, edge)| (portal, edge.edge)).collect();
        edges_exclude_lines(&edges)
    }

    /// Decides by the exact cone of all.
    fn decide_exactly(&self, path: &[Directed], tally: &mut Tally) -> Decision {
        tally.cones += 1;
        let (portals, per_world) = self.arena.exact_portals(path);
        let mut stabber = Stabber::new();
        for (i, portal) in portals.into_iter().enumerate() {
            stabber.push(portal, i > 0 && self.arena.needs_order(path[i - 1], path[i]));
        }
        match stabber.witness() {
            None => Decision::NotOpen,
            Some(line) => {
                tally.cone_open += 1;
                Decision::Open(in_world(line, &per_world))
            }
        }
    }
}

fn in_world(witness: Witness, per_world: &Int) -> Sightline {
    let points = witness.points.map(|point| point.map(|c| c / per_world));
    Sightline::Rational(Box::new(points))
}
