//! The depth-first search from one source cell.

use super::arena::{Arena, Directed, Plane, reverse};
use super::bits::Bits;
use super::bounds::{Bounds, Flood};
use super::propose::{Bivector, Frame, Half, NormPoint, Outcome, half, propose_line};
use super::separators::SeparatorCache;
use crate::predicates::filtered::{Approx3, FilteredLine};
use glam::DVec3;

#[derive(Clone, Copy, Debug)]
pub(crate) struct Line {
    pub p: [f64; 3],
    pub q: [f64; 3],
}

#[derive(Default, Clone, Debug)]
pub struct Stats {
    pub nodes: u64,
    pub floods: u64,
    pub no_goal: u64,
    pub inherited: u64,
    pub solved: u64,
    pub gordan: u64,
    pub gordan_unproved: u64,
    pub parent_line: u64,
    pub proposed: u64,
    pub undecided: u64,
    pub planes: u64,
    pub open: u64,
    pub t_flood: f64,
    pub t_sep: f64,
    pub t_norm: f64,
    pub t_gordan: f64,
    pub t_line: f64,
    pub support: [u64; 8],
}

struct Level {
    might: Bits,
    norm: NormPoint,
    x: Option<Bivector>,
    line: Option<Line>,
    halves: usize,
}

pub(crate) struct Search<'a> {
    arena: &'a Arena,
    bounds: &'a Bounds,
    pub wanted: Bits,
    pub found: Vec<(u32, Vec<Directed>, Line)>,
    path: Vec<Directed>,
    crossed: Bits,
    levels: Vec<Level>,
    halves: Vec<Half>,
    owners: Vec<[u32; 2]>,
    flood: Flood,
    planes: Vec<Plane>,
    candidates: Bits,
    goals: Bits,
    cache: SeparatorCache,
    pub stats: Stats,
}

impl<'a> Search<'a> {
    pub fn new(arena: &'a Arena, bounds: &'a Bounds) -> Self {
        Search {
            arena,
            bounds,
            wanted: arena.no_cells(),
            found: Vec::new(),
            path: Vec::new(),
            crossed: arena.no_cells(),
            levels: Vec::new(),
            halves: Vec::new(),
            owners: Vec::new(),
            flood: Flood::new(arena),
            planes: Vec::new(),
            candidates: arena.no_portals(),
            goals: arena.no_cells(),
            stats: Stats::default(),
            cache: SeparatorCache::default(),
        }
    }

    pub fn run(&mut self, source: u32) {
        self.crossed.insert(source);
        for &first in self.arena.leaving(source) {
            if self.wanted.is_empty() {
                break;
            }
            if self.enter(first) {
                self.visit();
            }
            self.leave();
        }
        self.crossed.remove(source);
    }

    fn visit(&mut self) {
        let last = *self.path.last().unwrap();
        let arena = self.arena;
        for &next in arena.leaving(arena.to(last)) {
            if self.wanted.is_empty() {
                return;
            }
            if !self.levels[self.path.len() - 1].might.has(next) || self.crossed.has(arena.to(next))
            {
                continue;
            }
            if self.enter(next) {
                self.visit();
            }
            self.leave();
        }
    }

    fn leave(&mut self) {
        let last = self.path.pop().unwrap();
        self.crossed.remove(self.arena.to(last));
        let depth = self.path.len();
        self.owners.truncate(if depth == 0 { 0 } else { self.levels[depth - 1].halves });
    }

    fn enter(&mut self, next: Directed) -> bool {
        self.stats.nodes += 1;
        let arena = self.arena;
        let depth = self.path.len();
        if self.levels.len() <= depth {
            self.levels.push(Level {
                might: arena.no_portals(),
                norm: NormPoint::default(),
                x: None,
                line: None,
                halves: 0,
            });
        }
        self.path.push(next);
        self.crossed.insert(arena.to(next));
        let t0 = std::time::Instant::now();
        self.planes.clear();
        if depth == 0 {
            self.candidates.clear();
            self.candidates.unite(self.bounds.after(next));
        } else {
            self.candidates
                .assign_intersection(&self.levels[depth - 1].might, self.bounds.after(next));
            for i in 0..depth {
                let planes = self.cache.get(arena, self.path[i], next);
                self.planes.extend_from_slice(planes);
            }
        }
        self.stats.t_sep += t0.elapsed().as_secs_f64();
        self.stats.planes += self.planes.len() as u64;
        let t0 = std::time::Instant::now();
        self.stats.floods += 1;
        let ok = self.narrow(next, depth);
        self.stats.t_flood += t0.elapsed().as_secs_f64();
        if !ok {
            self.stats.no_goal += 1;
            return false;
        }
        self.push_halves(next);
        let t0 = std::time::Instant::now();
        let ok = self.feasible(depth);
        self.stats.t_norm += t0.elapsed().as_secs_f64();
        if !ok {
            return false;
        }
        let t0 = std::time::Instant::now();
        let open = if self.wanted.has(arena.to(next)) {
            self.decide(next, depth)
        } else {
            self.levels[depth].line = if depth > 0 {
                self.levels[depth - 1].line.filter(|l| self.confirm_portal(l, next))
            } else {
                None
            };
            true
        };
        self.stats.t_line += t0.elapsed().as_secs_f64();
        open
    }

    fn narrow(&mut self, next: Directed, depth: usize) -> bool {
        let arena = self.arena;
        self.flood.run(arena, next, &self.candidates, &self.planes);
        self.goals.assign_intersection(&self.flood.entered, &self.wanted);
        if self.goals.is_empty() {
            return false;
        }
        // backward
        let might = &mut self.levels[depth].might;
        might.clear();
        let mut stack: Vec<u32> = self.goals.iter().collect();
        while let Some(cell) = stack.pop() {
            for &out in arena.leaving(cell) {
                let into = reverse(out);
                if self.flood.reached.has(into)
                    && might.insert(into)
                    && self.goals.insert(arena.from(into))
                {
                    stack.push(arena.from(into));
                }
            }
        }
        true
    }

    fn push_halves(&mut self, next: Directed) {
        let ids = self.arena.vertices(next);
        for (i, &u) in ids.iter().enumerate() {
            self.owners.push([u, ids[(i + 1) % ids.len()]]);
        }
    }

    fn at(&self, v: u32) -> DVec3 {
        DVec3::from(self.arena.point(v).floats())
    }

    /// the frame and halves of the current path
    fn frame(&mut self) -> Frame {
        let arena = self.arena;
        let (first, last) = (self.path[0], self.path[self.path.len() - 1]);
        let width = arena.radius(first).min(arena.radius(last));
        let frame = Frame::new(arena.center(first).into(), arena.center(last).into(), width);
        self.halves.clear();
        for &portal in &self.path {
            let ids = arena.vertices(portal);
            let mut prev = frame.point(arena.point(ids[ids.len() - 1]).floats().into());
            let at = self.halves.len();
            for &v in ids {
                let next = frame.point(arena.point(v).floats().into());
                self.halves.push(half(prev, next));
                prev = next;
            }
            self.halves[at..].rotate_left(1);
        }
        frame
    }

    fn feasible(&mut self, depth: usize) -> bool {
        let old = if depth == 0 { 0 } else { self.levels[depth - 1].halves };
        let (norm, x) = if depth == 0 {
            (NormPoint::default(), None)
        } else {
            (self.levels[depth - 1].norm.clone(), self.levels[depth - 1].x)
        };
        let inherited = x.filter(|x| {
            self.owners[old..].iter().all(|&[u, v]| x.side(self.at(u), self.at(v)) > 0.0)
        });
        let n = self.owners.len();
        let level = &mut self.levels[depth];
        level.halves = n;
        level.norm = norm;
        level.line = None;
        if let Some(x) = inherited {
            level.x = Some(x);
            self.stats.inherited += 1;
            return true;
        }
        self.stats.solved += 1;
        let frame = self.frame();
        let level = &mut self.levels[depth];
        match level.norm.search(&self.halves, false) {
            Outcome::Inside(x) => {
                level.x = Some(frame.world_bivector(&x));
                true
            }
            Outcome::Excluded(set) => {
                let t0 = std::time::Instant::now();
                let edges: Vec<[u32; 2]> =
                    set.iter().map(|&(i, _)| self.owners[i as usize]).collect();
                let proved = self.arena.excluded(&edges);
                self.stats.t_gordan += t0.elapsed().as_secs_f64();
                self.stats.support[set.len()] += 1;
                if proved {
                    self.stats.gordan += 1;
                    return false;
                }
                self.stats.gordan_unproved += 1;
                level.x = None;
                true
            }
        }
    }

    fn decide(&mut self, next: Directed, depth: usize) -> bool {
        if depth > 0
            && let Some(line) = self.levels[depth - 1].line
            && self.confirm_portal(&line, next)
        {
            self.stats.parent_line += 1;
            self.accept(depth, line);
            return true;
        }
        let mut norm = self.levels[depth].norm.clone();
        let frame = self.frame();
        if let Outcome::Inside(x) = norm.search(&self.halves, true)
            && let Some((foot, d)) = propose_line(&mut self.halves, x)
            && let Some(line) =
                self.snap(frame.world_point(foot.into()), frame.world_direction(d.into()), depth)
        {
            self.levels[depth].norm = norm;
            self.stats.proposed += 1;
            self.accept(depth, line);
            return true;
        }
        self.stats.undecided += 1;
        if std::env::var("DBG").is_ok() {
            eprintln!("U {} {:?}", self.path.len(), self.path);
        }
        false
    }

    fn snap(&self, foot: DVec3, d: DVec3, depth: usize) -> Option<Line> {
        let d = d.normalize();
        let p = foot + d * (DVec3::from(self.arena.center(self.path[0])) - foot).dot(d);
        let q = foot + d * (DVec3::from(self.arena.center(self.path[depth])) - foot).dot(d);
        let q = if (q - p).length() < 64.0 { p + d * 64.0 } else { q };
        for bits in [0, 3, 6, 10, 16, 24] {
            let s = f64::from(1u32 << bits);
            let line = Line {
                p: (p * s).round().to_array().map(|c| c / s),
                q: (q * s).round().to_array().map(|c| c / s),
            };
            if self.path.iter().all(|&portal| self.confirm_portal(&line, portal)) {
                return Some(line);
            }
        }
        None
    }

    fn confirm_portal(&self, line: &Line, portal: Directed) -> bool {
        let ids = self.arena.vertices(portal);
        let line = FilteredLine::through(
            &Approx3::exact(line.p),
            &Approx3::exact(line.q),
            self.arena.bound(),
        );
        (0..ids.len()).all(|i| {
            let edge = FilteredLine::through(
                self.arena.point(ids[i]),
                self.arena.point(ids[(i + 1) % ids.len()]),
                self.arena.bound(),
            );
            line.side_of_edge(&edge) == Some(crate::num::Sign::Positive)
        })
    }

    fn accept(&mut self, depth: usize, line: Line) {
        self.levels[depth].line = Some(line);
        for i in 0..=depth {
            let cell = self.arena.to(self.path[i]);
            if self.wanted.has(cell) {
                self.wanted.remove(cell);
                self.stats.open += 1;
                self.found.push((cell, self.path[..=i].to_vec(), line));
            }
        }
    }
}
