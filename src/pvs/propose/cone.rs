//! The cone of a sequence in floats: its half-spaces, a point inside, a line inside.

use super::frame::{Bivector, Frame, half};
use super::line::{FrameLine, line_between, propose_line};
use super::six::agreeing_six;
use crate::num::{Int, Rational};
use crate::pvs::arena::{Arena, Directed};
use crate::pvs::sightline::Sightline;
use crate::stab::propose::{Half, NormPoint, Outcome, dot};
use crate::stab::{EdgeCone, Vector6};
use glam::DVec3;
use num_traits::ToPrimitive;

/// What is known of a path's cone, to go on from when the path is extended.
#[derive(Clone, Default)]
pub(crate) struct ConePoint {
    search: NormPoint,
    /// A point that seems to be strictly inside.
    inside: Option<Bivector>,
}

impl ConePoint {
    /// Whether the known point seems to be on the positive side of all edges of `portal`.
    pub fn passes(&self, arena: &Arena, portal: Directed) -> bool {
        let Some(inside) = &self.inside else { return false };
        let ids = arena.vertices(portal);
        let at = |vertex: u32| DVec3::from(arena.point(vertex).floats());
        let mut before = at(ids[ids.len() - 1]);
        ids.iter().all(|&vertex| {
            let edge = [before, at(vertex)];
            before = edge[1];
            inside.side(edge[0], edge[1]) > 0.0
        })
    }
}

/// A proposed line, or what seems to rule all lines out.
pub(crate) enum Proposal {
    Line(FrameLine),
    /// Half-spaces that together seem to let no line through, by their places in the cone.
    Blocking(Vec<usize>),
}

/// What some half-spaces leave, by points of R^6 in floats: direction and moment about `origin`, in
/// world units.
pub(crate) struct RoughLines {
    /// Strictly inside.
    inside: [DVec3; 2],
    /// On both sides of the quadric.
    ends: Option<[[DVec3; 2]; 2]>,
    origin: DVec3,
}

impl RoughLines {
    /// What `cone` leaves, whose grid has `per_world` units in one of the world; `ends` are its
    /// points on both sides of the quadric, if it has them.
    pub fn new(cone: &EdgeCone, ends: Option<&[Vector6; 2]>, per_world: &Int) -> RoughLines {
        let in_world = |on_grid: &Int| {
            Rational::new(on_grid.clone(), per_world.clone()).to_f64().unwrap_or(f64::NAN)
        };
        let unit = in_world(cone.frame().unit());
        let rough = |vector: &Vector6| {
            let [dx, dy, dz, mx, my, mz] = floats(vector);
            [DVec3::new(dx, dy, dz), DVec3::new(mx, my, mz) * unit]
        };
        let inside = cone.rays().iter().map(rough).fold([DVec3::ZERO; 2], |[d, m], [e, n]| {
            let length = (e.length_squared() + n.length_squared()).sqrt();
            [d + e / length, m + n / length]
        });
        let [x, y, z] = cone.frame().origin().each_ref().map(in_world);
        let origin = DVec3::new(x, y, z);
        RoughLines { inside, ends: ends.map(|ends| ends.each_ref().map(rough)), origin }
    }
}

/// The vector in floats, scaled to about 2^60 where it is longer.
fn floats(vector: &Vector6) -> [f64; 6] {
    let bits = vector.iter().map(Int::bits).max().unwrap_or(0);
    let shift = bits.saturating_sub(60);
    vector.each_ref().map(|c| (c >> shift).to_f64().unwrap_or(0.0))
}

/// The edge of a half-space.
#[derive(Clone, Copy)]
pub(crate) struct EdgeOf {
    /// The portal's position in the path.
    pub position: usize,
    /// Which of the portal's edges.
    pub edge: usize,
    /// Its vertices.
    ends: [u32; 2],
}

/// The half-spaces of the edges of a path's portals, in a frame that suits it.
#[derive(Default)]
pub(crate) struct SequenceCone {
    frame: Frame,
    halves: Vec<Half>,
    edges: Vec<EdgeOf>,
}

impl SequenceCone {
    /// Makes this the cone of `path`.
    pub fn set(&mut self, arena: &Arena, path: &[Directed]) {
        let (first, last) = (arena.outline(path[0]), arena.outline(path[path.len() - 1]));
        self.frame = Frame::new(first.center, last.center, first.radius.min(last.radius));
        self.halves.clear();
        self.edges.clear();
        for (position, &portal) in path.iter().enumerate() {
            let ids = arena.vertices(portal);
            let at = |vertex: u32| self.frame.point(arena.point(vertex).floats().into());
            let first = at(ids[0]);
            let mut start = first;
            for (i, &u) in ids.iter().enumerate() {
                let v = ids[(i + 1) % ids.len()];
                let end = if i + 1 == ids.len() { first } else { at(v) };
                self.halves.push(half(start, end));
                self.edges.push(EdgeOf { position, edge: i, ends: [u, v] });
                start = end;
            }
        }
    }

    /// The edge of a half-space.
    pub fn edge(&self, place: usize) -> EdgeOf {
        self.edges[place]
    }

    /// Completes the `blocking` half-spaces until they seem to let no line through; or a line
    /// that they led to, which seems to be inside all.
    pub fn close(&self, mut blocking: Vec<usize>) -> Proposal {
        if blocking.is_empty() {
            let last = self.edges.last().map_or(0, |edge| edge.position);
            let is_end = |place: &usize| [0, last].contains(&self.edges[*place].position);
            blocking = (0..self.edges.len()).filter(is_end).collect();
        }
        loop {
            blocking.sort_unstable();
            blocking.dedup();
            let mut some: Vec<Half> = blocking.iter().map(|&i| self.halves[i]).collect();
            let Ok(line) = find_line(&mut some, &mut NormPoint::default()) else {
                return Proposal::Blocking(blocking);
            };
            let bivector = line.bivector();
            let sides = self.halves.iter().map(|half| dot(half, &bivector)).enumerate();
            let missed = sides.filter(|(_, side)| *side <= 0.0).min_by(|a, b| a.1.total_cmp(&b.1));
            match missed {
                Some((place, _)) if !blocking.contains(&place) => blocking.push(place),
                Some(_) | None => return Proposal::Line(line),
            }
        }
    }

    /// Six of the half-spaces at `places` of whose pairwise products the Klein form, or its
    /// negative, seems to be a combination with no negative weight.
    pub fn six(&self, places: &[usize]) -> Option<[usize; 6]> {
        let halves: Vec<Half> = places.iter().map(|&place| self.halves[place]).collect();
        let six = agreeing_six(&halves)?;
        Some(six.map(|i| places[i]))
    }

    /// The next half-space to add to those at `places`, which seem to have the `lines`; or a line
    /// that seems to be inside all.
    pub fn follow(&self, places: &[usize], lines: &RoughLines) -> Option<Result<FrameLine, usize>> {
        let frame = |[d, m]: [DVec3; 2]| self.frame.bivector(d, m, lines.origin);
        let inside = frame(lines.inside);
        let line = lines.ends.and_then(|ends| line_between(inside, ends.map(frame)));
        let point = line.map_or(inside, |line| line.bivector());
        let sides = self.halves.iter().map(|half| dot(half, &point)).enumerate();
        let others = sides.filter(|(place, _)| !places.contains(place));
        let (place, least) = others.min_by(|a, b| a.1.total_cmp(&b.1))?;
        Some(line.filter(|_| least > 0.0).ok_or(place))
    }

    /// Looks for a point strictly inside; failing that, the edges that seem to exclude each other.
    pub fn find_point(&self, point: &mut ConePoint) -> Result<(), Vec<[u32; 2]>> {
        match point.search.search(&self.halves, false) {
            Outcome::Inside(x) => {
                point.inside = Some(self.frame.world_bivector(&x));
                Ok(())
            }
            Outcome::Excluded(indices) => {
                point.inside = None;
                Err(indices.iter().map(|&i| self.edges[i as usize].ends).collect())
            }
        }
    }

    /// Looks for a line strictly inside.
    pub fn find_line(&mut self, point: &mut ConePoint) -> Proposal {
        match find_line(&mut self.halves, &mut point.search) {
            Ok(line) => Proposal::Line(line),
            Err(indices) => Proposal::Blocking(indices.iter().map(|&i| i as usize).collect()),
        }
    }

    /// The line by two points near the first and the last portal of `path`, rounded to coarser
    /// and finer grids of world space, the coarsest first.
    pub fn roundings(
        &self,
        arena: &Arena,
        path: &[Directed],
        line: &FrameLine,
    ) -> impl Iterator<Item = Sightline> + use<> {
        let foot = self.frame.world_point(line.foot);
        let direction = self.frame.world_direction(line.direction).normalize();
        let near = |portal: Directed| {
            let center = arena.outline(portal).center;
            foot + direction * (center - foot).dot(direction)
        };
        let (start, end) = (near(path[0]), near(path[path.len() - 1]));
        // Points far apart round to nearly the same line; beyond the bound no filter sees them.
        let far = start + direction * APART.min(arena.bound().largest() / 2.0);
        let ends = [end, far];
        let choices = ROUNDING_BITS.into_iter().flat_map(move |bits| ends.map(|end| (bits, end)));
        choices.filter_map(move |(bits, end)| {
            let scale = (1u64 << bits) as f64;
            let point = |p: DVec3| (p * scale).round().to_array();
            Sightline::dyadic([point(start), point(end)], bits)
        })
    }
}

fn find_line(halves: &mut Vec<Half>, search: &mut NormPoint) -> Result<FrameLine, Vec<u32>> {
    match search.search(halves, true) {
        Outcome::Excluded(indices) => Err(indices),
        Outcome::Inside(x) => propose_line(halves, x),
    }
}

/// World units between the two points of a proposed line, in scenes larger than that, where two
/// points on its portals do not do.
const APART: f64 = 64.0;

/// The grids to try, as powers of 1/2: integers first.
const ROUNDING_BITS: [u32; 9] = [0, 2, 4, 7, 11, 16, 24, 32, 40];
