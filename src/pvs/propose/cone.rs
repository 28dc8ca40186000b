//! The cone of a sequence in floats: its half-spaces, a point inside, a line inside.

use super::frame::{Bivector, Frame, half};
use super::line::{FrameLine, propose_line};
use super::norm::{Half, NormPoint, Outcome, dot};
use crate::pvs::arena::{Arena, Directed};
use crate::pvs::sightline::Sightline;
use glam::DVec3;

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
    /// Positions in the path of portals that together seem to let no line through.
    Blocking(Vec<usize>),
}

/// The half-spaces of the edges of a path's portals, in a frame that suits it.
#[derive(Default)]
pub(crate) struct SequenceCone {
    frame: Frame,
    halves: Vec<Half>,
    /// The edge of each half-space, and its portal's position in the path.
    edges: Vec<([u32; 2], u32)>,
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
                self.edges.push(([u, v], position as u32));
                start = end;
            }
        }
    }

    /// The cone of some portals of the path only.
    pub fn restricted(&self, members: &[usize]) -> SequenceCone {
        let kept = |i: &usize| members.contains(&(self.edges[*i].1 as usize));
        let indices: Vec<usize> = (0..self.halves.len()).filter(kept).collect();
        SequenceCone {
            frame: self.frame,
            halves: indices.iter().map(|&i| self.halves[i]).collect(),
            edges: indices.iter().map(|&i| self.edges[i]).collect(),
        }
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
                Err(indices.iter().map(|&i| self.edges[i as usize].0).collect())
            }
        }
    }

    /// Looks for a line strictly inside.
    pub fn find_line(&mut self, point: &mut ConePoint) -> Proposal {
        let blocking = match point.search.search(&self.halves, true) {
            Outcome::Excluded(indices) => indices,
            Outcome::Inside(x) => match propose_line(&mut self.halves, x) {
                Ok(line) => return Proposal::Line(line),
                Err(indices) => indices,
            },
        };
        Proposal::Blocking(blocking.iter().map(|&i| self.edges[i as usize].1 as usize).collect())
    }

    /// The position of the portal outside `members` that the line misses most.
    pub fn most_missed(&self, line: &FrameLine, members: &[usize]) -> Option<usize> {
        let bivector = line.bivector();
        let sides = self.halves.iter().zip(&self.edges);
        let sides = sides.map(|(half, &(_, position))| (dot(half, &bivector), position as usize));
        sides
            .filter(|(_, position)| !members.contains(position))
            .min_by(|a, b| a.0.total_cmp(&b.0))
            .map(|(_, position)| position)
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
        let start = near(path[0]);
        let end = near(path[path.len() - 1]);
        // Points far apart round to nearly the same line; beyond the bound no filter sees them.
        let apart = APART.min(arena.bound().largest() / 2.0);
        let end = if end.distance(start) < apart { start + direction * apart } else { end };
        ROUNDING_BITS.into_iter().filter_map(move |bits| {
            let scale = (1u64 << bits) as f64;
            let point = |p: DVec3| (p * scale).round().to_array();
            Sightline::dyadic([point(start), point(end)], bits)
        })
    }
}

/// World units between the two points of a proposed line, at least, in scenes larger than that.
const APART: f64 = 64.0;

/// The grids to try, as powers of 1/2: integers first.
const ROUNDING_BITS: [u32; 9] = [0, 2, 4, 7, 11, 16, 24, 32, 40];
