//! Whether a portal sequence is open: lines proposed and checked, then the exact cone.
//!
//! In order of cost: the line of the sequence without its last portal; a line found in floats,
//! rounded to small numbers and checked; the exact cone (`stab`), first of the few edges that
//! seem to block each other (if these let no line through, all together do not either), at last
//! of the whole sequence. What is known is kept for each portal of the current path and serves
//! its extensions.

use super::Tally;
use super::arena::{Arena, Directed};
use super::propose::{ConePoint, FrameLine, Proposal, RoughLines, SequenceCone};
use super::sightline::{Ray, Sightline};
use crate::num::Int;
use crate::stab::{EdgeCone, EdgeLines, Frame, Stabber, Witness, six_edges_exclude_lines};

/// Whether a sequence is open.
pub(crate) enum Decision {
    Open(Sightline),
    NotOpen,
}

/// What a few edges of a sequence say.
enum Few {
    NotOpen,
    Open(Ray),
    Undecided,
}

/// With more edges than this, the cone of all is no more work.
const MOST_EDGES: usize = 24;

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
    /// or its last two portals do, which is proved.
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
        let mut possible =
            !matches!(path, [.., before, last] if arena.is_impossible(*before, *last));
        if possible && known.ray.is_none() && !known.point.passes(arena, last) {
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
                if let Some(ray) = self.checked(path, &line) {
                    tally.proposed += 1;
                    return self.open_by(ray);
                }
            }
            Proposal::Blocking(places) => {
                tally.cones += 1;
                match self.decide_by_few(path, places) {
                    Few::NotOpen => return Decision::NotOpen,
                    Few::Open(ray) => {
                        tally.cone_open += 1;
                        return self.open_by(ray);
                    }
                    Few::Undecided => {}
                }
            }
        }
        self.decide_exactly(path, tally)
    }

    /// Notes that the line stabs the path.
    fn open_by(&mut self, ray: Ray) -> Decision {
        let line = ray.sightline();
        self.known.last_mut().expect("the path was extended").ray = Some(ray);
        Decision::Open(line)
    }

    /// The line in small numbers, if it stabs the path.
    fn checked(&self, path: &[Directed], line: &FrameLine) -> Option<Ray> {
        let arena = self.arena;
        let stabbing =
            |line: Sightline| Ray::new(arena, &line).filter(|ray| ray.stabs(arena, path));
        self.cone.roundings(arena, path, line).find_map(stabbing)
    }

    /// Decides by some of the path's edges, at first those at `places` in the cone: if no line is
    /// on the positive side of them, the path is not open, which is proved; else an edge is added
    /// that the lines left do not pass, or there is a line that passes all.
    fn decide_by_few(&self, path: &[Directed], mut places: Vec<usize>) -> Few {
        let (portals, per_world) = self.arena.exact_portals(path);
        let edge = |place: usize| {
            let edge = self.cone.edge(place);
            (&*portals[edge.position], edge.edge)
        };
        let frame = Frame::near(&portals[0].vertices()[0].coordinates, &per_world);
        if let Some(six) = self.cone.six(&places)
            && six_edges_exclude_lines(six.map(edge), &frame)
        {
            return Few::NotOpen;
        }
        let mut cone = EdgeCone::new(frame);
        places.iter().for_each(|&place| cone.push(edge(place)));
        while places.len() <= MOST_EDGES {
            let ends = match cone.lines() {
                EdgeLines::None => return Few::NotOpen,
                EdgeLines::Between(ends) => Some(ends),
                EdgeLines::Lineality => None,
            };
            let lines = RoughLines::new(&cone, ends.as_deref(), &per_world);
            match self.cone.follow(&places, &lines) {
                None => break,
                Some(Ok(line)) => {
                    return self.checked(path, &line).map_or(Few::Undecided, Few::Open);
                }
                Some(Err(place)) => {
                    places.push(place);
                    cone.push(edge(place));
                }
            }
        }
        Few::Undecided
    }

    /// Decides by the exact cone of all.
    fn decide_exactly(&self, path: &[Directed], tally: &mut Tally) -> Decision {
        tally.cones += 1;
        let (portals, per_world) = self.arena.exact_portals(path);
        let mut stabber = Stabber::in_units(&per_world);
        for (i, portal) in portals.iter().enumerate() {
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
