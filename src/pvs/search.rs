//! The depth-first search from one source cell.

use super::arena::{Arena, Directed, Plane, reverse};
use super::bits::Bits;
use super::bounds::{Flood, SharedBounds};
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
    pub nogood: u64,
    pub cones: u64,
    pub cone_portals: u64,
    pub cone_open: u64,
    pub t_cone: f64,
    pub compat: u64,
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
    planes: usize,
}

pub(crate) struct Search<'a> {
    arena: &'a Arena,
    bounds: &'a SharedBounds,
    pub wanted: Bits,
    pub found: Vec<(u32, Vec<Directed>, Line)>,
    path: Vec<Directed>,
    crossed: Bits,
    levels: Vec<Level>,
    halves: Vec<Half>,
    owners: Vec<[u32; 2]>,
    flood: Flood,
    planes: Vec<u32>,
    active: Vec<bool>,
    hints: Hints,
    candidates: Bits,
    goals: Bits,
    nogoods: rustc_hash::FxHashMap<Directed, Vec<Vec<Directed>>>,
    on_path: Bits,
    half_owner: Vec<u8>,
    goal_portals: Bits,
    cache: SeparatorCache,
    pub stats: Stats,
}

impl<'a> Search<'a> {
    pub fn new(arena: &'a Arena, bounds: &'a SharedBounds) -> Self {
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
            active: Vec::new(),
            hints: Hints::default(),
            candidates: arena.no_portals(),
            goals: arena.no_cells(),
            nogoods: Default::default(),
            on_path: arena.no_portals(),
            half_owner: Vec::new(),
            goal_portals: arena.no_portals(),
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
        for b in self.wanted.iter() {
            self.bounds.refute(self.arena, source, b);
        }
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
        self.on_path.remove(last);
        self.crossed.remove(self.arena.to(last));
        let depth = self.path.len();
        for id in self.planes.drain(self.levels[depth].planes..) {
            self.active[id as usize] = false;
        }
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
                planes: 0,
            });
        }
        if self.is_nogood(next) {
            self.stats.nogood += 1;
            self.path.push(next);
            self.crossed.insert(arena.to(next));
            self.on_path.insert(next);
            self.levels[depth].planes = self.planes.len();
            return false;
        }
        self.on_path.insert(next);
        self.path.push(next);
        self.crossed.insert(arena.to(next));
        let t0 = std::time::Instant::now();
        self.levels[depth].planes = self.planes.len();
        let ok = if depth == 0 {
            self.candidates = self.bounds.after(next).snapshot();
            self.sift(next, depth, 0..0)
        } else {
            self.candidates
                .assign_shared_intersection(&self.levels[depth - 1].might, self.bounds.after(next));
            self.sift(next, depth, 0..1) && {
                std::mem::swap(&mut self.candidates, &mut self.flood.reached);
                depth == 1 || self.sift(next, depth, 1..depth)
            }
        };
        if depth == 1 && ok {
            std::mem::swap(&mut self.candidates, &mut self.flood.reached);
        }
        if ok {
            self.aim(depth);
        }
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

    fn sift(&mut self, next: Directed, depth: usize, with: std::ops::Range<usize>) -> bool {
        let arena = self.arena;
        let first_plane = self.planes.len();
        self.hints.clear();
        for i in with {
            for &id in self.cache.get(arena, self.path[i], next) {
                if self.active.len() <= id as usize {
                    self.active.resize(id as usize + 1024, false);
                }
                if !self.active[id as usize] {
                    self.active[id as usize] = true;
                    self.planes.push(id);
                }
            }
        }
        for &id in &self.planes[first_plane..] {
            self.hints.push(self.cache.plane(id));
        }
        self.stats.planes += (self.planes.len() - first_plane) as u64;
        let (hints, cache, planes) = (&self.hints, &self.cache, &self.planes[first_plane..]);
        self.flood.run_hinted(arena, next, &self.candidates, |t| {
            hints.any_behind(arena.center(t), |i| {
                arena.wholly_behind_exact(cache.plane(planes[i]), t)
            })
        });
        self.goals.assign_intersection(&self.flood.entered, &self.wanted);
        let _ = depth;
        !self.goals.is_empty()
    }

    fn aim(&mut self, depth: usize) {
        let arena = self.arena;
        // every portal must be able to lead to a goal
        self.goal_portals.clear();
        for t in self.flood.reached.iter() {
            if self.wanted.has(arena.to(t)) {
                self.goal_portals.insert(t);
            }
        }
        for t in self.flood.reached.clone().iter() {
            if !self.goal_portals.has(t) && !self.bounds.after(t).intersects(&self.goal_portals) {
                self.flood.reached.remove(t);
                self.stats.compat += 1;
            }
        }
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
        self.half_owner.clear();
        for (i, &portal) in self.path.iter().enumerate() {
            let ids = arena.vertices(portal);
            let mut prev = frame.point(arena.point(ids[ids.len() - 1]).floats().into());
            let at = self.halves.len();
            for &v in ids {
                let next = frame.point(arena.point(v).floats().into());
                self.halves.push(half(prev, next));
                self.half_owner.push(i as u8);
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
        let mut members = vec![0, depth];
        if let Outcome::Inside(x) = norm.search(&self.halves, true) {
            match propose_line(&mut self.halves, x) {
                Ok((foot, d)) => {
                    if let Some(line) = self.snap(
                        frame.world_point(foot.into()),
                        frame.world_direction(d.into()),
                        depth,
                    ) {
                        self.levels[depth].norm = norm;
                        self.stats.proposed += 1;
                        self.accept(depth, line);
                        return true;
                    }
                }
                Err(set) => {
                    members.extend(set.iter().map(|&i| self.half_owner[i as usize] as usize));
                }
            }
        }
        self.stats.undecided += 1;
        let t0 = std::time::Instant::now();
        let open = self.decide_exactly(members);
        self.stats.t_cone += t0.elapsed().as_secs_f64();
        if open {
            self.stats.cone_open += 1;
            self.accept(depth, Line { p: [f64::NAN; 3], q: [f64::NAN; 3] });
            self.levels[depth].line = None;
        }
        open
    }

    /// growing subsets of the path
    fn decide_exactly(&mut self, mut members: Vec<usize>) -> bool {
        loop {
            members.sort_unstable();
            members.dedup();
            if members.len() < self.path.len() {
                // floats: does the subset admit a line?
                let halves: Vec<Half> = self
                    .halves
                    .iter()
                    .zip(&self.half_owner)
                    .filter(|(_, o)| members.contains(&(**o as usize)))
                    .map(|(h, _)| *h)
                    .collect();
                let mut sub = halves;
                let mut search = NormPoint::default();
                if let Outcome::Inside(x) = search.search(&sub, true)
                    && let Ok((foot, d)) = propose_line(&mut sub, x)
                {
                    let foot = DVec3::from(foot);
                    let m = foot.cross(d.into());
                    let line: Half = [d[0], d[1], d[2], m.x, m.y, m.z];
                    // the worst violated portal joins
                    let worst = self
                        .halves
                        .iter()
                        .zip(&self.half_owner)
                        .map(|(h, o)| (super::propose::dot(h, &line), *o as usize))
                        .filter(|(_, o)| !members.contains(o))
                        .min_by(|a, b| a.0.total_cmp(&b.0))
                        .unwrap();
                    members.push(worst.1);
                    continue;
                }
            }
            let sub: Vec<Directed> = members.iter().map(|&i| self.path[i]).collect();
            let portals = self.arena.exact_portals(&sub);
            let refs: Vec<_> = portals.iter().collect();
            self.stats.cones += 1;
            self.stats.cone_portals += sub.len() as u64;
            let Some(_witness) = crate::stab::decide_open(&refs, &[]) else {
                let last = *sub.last().unwrap();
                self.nogoods.entry(last).or_default().push(sub[..sub.len() - 1].to_vec());
                return false;
            };
            if members.len() == self.path.len() {
                return true;
            }
            members = (0..self.path.len()).collect();
        }
    }

    fn is_nogood(&self, next: Directed) -> bool {
        self.nogoods
            .get(&next)
            .is_some_and(|list| list.iter().any(|set| set.iter().all(|p| self.on_path.has(*p))))
    }

    fn snap(&self, foot: DVec3, d: DVec3, depth: usize) -> Option<Line> {
        let d = d.normalize();
        let p = foot + d * (DVec3::from(self.arena.center(self.path[0])) - foot).dot(d);
        let q = foot + d * (DVec3::from(self.arena.center(self.path[depth])) - foot).dot(d);
        let q = if (q - p).length() < 64.0 { p + d * 64.0 } else { q };
        for bits in [0, 3, 6, 10, 16, 24, 32, 40] {
            let s = (1u64 << bits) as f64;
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
        let line = FilteredLine::through(
            &Approx3::exact(line.p),
            &Approx3::exact(line.q),
            self.arena.bound(),
        );
        self.arena
            .edges(portal)
            .iter()
            .all(|edge| line.side_of_edge(edge) == Some(crate::num::Sign::Positive))
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

#[derive(Default)]
struct Hints {
    n: [Vec<f64>; 3],
    d: Vec<f64>,
}
impl Hints {
    fn clear(&mut self) {
        for v in &mut self.n {
            v.clear();
        }
        self.d.clear();
    }
    fn push(&mut self, p: &Plane) {
        let (n, d) = p.hint();
        for i in 0..3 {
            self.n[i].push(n[i]);
        }
        self.d.push(d);
    }
    fn any_behind(&self, c: [f64; 3], check: impl Fn(usize) -> bool) -> bool {
        let n = self.d.len();
        let (x, y, z, d) = (&self.n[0][..n], &self.n[1][..n], &self.n[2][..n], &self.d[..n]);
        let mut i = 0;
        while i + 8 <= n {
            let mut least = [0.0f64; 8];
            for k in 0..8 {
                least[k] = x[i + k] * c[0] + y[i + k] * c[1] + z[i + k] * c[2] - d[i + k];
            }
            if least.iter().any(|&v| v <= 0.0) {
                for k in 0..8 {
                    if least[k] <= 0.0 && check(i + k) {
                        return true;
                    }
                }
            }
            i += 8;
        }
        for k in i..n {
            if x[k] * c[0] + y[k] * c[1] + z[k] * c[2] - d[k] <= 0.0 && check(k) {
                return true;
            }
        }
        false
    }
}
