//! Turning a line around every vertex, and noting who sees whom along it.

use super::around::Around;
use super::groups::Groups;
use super::line::{Chain, TurningLine};
use super::witness;
use crate::num::Number;
use crate::pvs::{OpenPair, Row, Sightline};
use crate::report::{Matrix, Progress, Verdict};
use crate::scene::CellId;
use crate::scene::plan::{Crossings, PlanGraph};
use rayon::prelude::*;
use std::sync::atomic::{AtomicU32, Ordering::Relaxed};

/// An open pair of groups, and a line that shows it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlanSight {
    /// The group that the line starts in.
    pub from: u32,
    /// The one that it ends in, greater than `from`.
    pub to: u32,
    /// The portals that it crosses, in this order.
    pub portals: Vec<u32>,
    /// Two distinct points of it, in its direction, in world units.
    pub line: [[Number; 2]; 2],
}

impl PlanSight {
    /// The same in the graph's [form in space](PlanGraph::in_space), at half the portals' height,
    /// where the groups are cells: the row of this pair alone.
    pub fn in_space(&self) -> Row {
        let raised = |p: &[Number; 2]| PlanGraph::halfway_up(p.each_ref().map(Number::to_rational));
        let line = Sightline::Rational(Box::new(self.line.each_ref().map(raised)));
        let pair = OpenPair { target: CellId(self.to), portals: self.portals.clone(), line };
        Row { source: CellId(self.from), open: vec![pair], ..Row::default() }
    }
}

/// For each pair of groups the least vertex around which they are seen to see each other.
///
/// Which vertex that is does not depend on the order of the work, so threads can share it.
struct Firsts {
    groups: usize,
    of_pair: Vec<AtomicU32>,
}

/// Of a pair that no vertex shows.
const NONE: u32 = u32::MAX;

impl Firsts {
    fn new(groups: usize) -> Firsts {
        let pairs = groups * groups.saturating_sub(1) / 2;
        Firsts { groups, of_pair: (0..pairs).map(|_| AtomicU32::new(NONE)).collect() }
    }

    #[inline]
    fn of(&self, g: u32, h: u32) -> &AtomicU32 {
        let (low, high) = (g.min(h) as usize, g.max(h) as usize);
        &self.of_pair[high * (high - 1) / 2 + low]
    }

    #[inline]
    fn note(&self, g: u32, h: u32, vertex: u32) {
        if g != h {
            let first = self.of(g, h);
            if first.load(Relaxed) > vertex {
                first.fetch_min(vertex, Relaxed);
            }
        }
    }

    fn matrix(&self) -> Matrix {
        let mut matrix = Matrix::new(self.groups, Verdict::NotOpen);
        for high in 0..self.groups {
            matrix.set(high, high, Verdict::Open);
            for low in 0..high {
                if self.of(low as u32, high as u32).load(Relaxed) != NONE {
                    matrix.set(low, high, Verdict::Open);
                    matrix.set(high, low, Verdict::Open);
                }
            }
        }
        matrix
    }
}

/// What the sweep works on.
struct Sweep<'a> {
    graph: &'a PlanGraph,
    crossings: &'a Crossings,
    groups: &'a Groups,
    around: Around,
    vertices: Vec<u32>,
}

impl<'a> Sweep<'a> {
    fn new(graph: &'a PlanGraph, crossings: &'a Crossings, groups: &'a Groups) -> Sweep<'a> {
        assert!(graph.polygons.len() == graph.cells.len(), "a graph without its cells' polygons");
        let around = Around::new(graph, crossings, groups);
        let vertices = around.essential(graph, crossings, groups);
        Sweep { graph, crossings, groups, around, vertices }
    }

    fn line(&self) -> TurningLine<'a> {
        TurningLine::new(self.graph, self.crossings, self.groups)
    }

    /// `None` if interrupted.
    fn firsts(&self, progress: &dyn Progress) -> Option<Firsts> {
        let firsts = Firsts::new(self.groups.count());
        progress.begin("lines around vertices", self.vertices.len() as u64);
        self.vertices
            .par_iter()
            .try_for_each_init(
                || self.line(),
                |line, &vertex| {
                    if progress.is_interrupted() {
                        return None;
                    }
                    line.turn_around(vertex, self.around.at(vertex), &mut |g, h, _| {
                        firsts.note(g, h, vertex);
                    });
                    progress.advance(1);
                    Some(())
                },
            )
            .map(|()| firsts)
    }

    /// The pairs that a vertex is the first of and that are wanted, with their lines, in the order
    /// of the turn.
    fn sights(
        &self,
        line: &mut TurningLine,
        firsts: &Firsts,
        vertex: u32,
        is_wanted: &dyn Fn(u32, u32) -> bool,
    ) -> Vec<PlanSight> {
        let mut sights: Vec<PlanSight> = Vec::new();
        let mut seen = rustc_hash::FxHashSet::default();
        line.turn_around(vertex, self.around.at(vertex), &mut |g, h, chain: &Chain| {
            let is_first = g != h && firsts.of(g, h).load(Relaxed) == vertex;
            if is_first && is_wanted(g.min(h), g.max(h)) && seen.insert((g.min(h), g.max(h))) {
                let ways = chain.ways(g, h, g < h);
                let portals = ways.iter().map(|way| way.portal).collect();
                let line = witness::line(self.graph, &ways);
                sights.push(PlanSight { from: g.min(h), to: g.max(h), portals, line });
            }
        });
        sights
    }
}

/// Which groups see which: every pair open or not open. `None` if interrupted.
///
/// # Panics
/// If the graph states no polygons.
pub fn plan_matrix(
    graph: &PlanGraph,
    crossings: &Crossings,
    groups: &Groups,
    progress: &dyn Progress,
) -> Option<Matrix> {
    Some(Sweep::new(graph, crossings, groups).firsts(progress)?.matrix())
}

/// The same with a line for each open pair that is wanted, the lower group first, in ascending
/// order. `None` if interrupted.
///
/// # Panics
/// If the graph states no polygons.
pub fn plan_sights(
    graph: &PlanGraph,
    crossings: &Crossings,
    groups: &Groups,
    is_wanted: &(dyn Fn(u32, u32) -> bool + Sync),
    progress: &dyn Progress,
) -> Option<(Matrix, Vec<PlanSight>)> {
    let sweep = Sweep::new(graph, crossings, groups);
    let firsts = sweep.firsts(progress)?;
    progress.begin("sightlines", sweep.vertices.len() as u64);
    let sights: Option<Vec<Vec<PlanSight>>> = sweep
        .vertices
        .par_iter()
        .map_init(
            || sweep.line(),
            |line, &vertex| {
                let sights = sweep.sights(line, &firsts, vertex, is_wanted);
                progress.advance(1);
                (!progress.is_interrupted()).then_some(sights)
            },
        )
        .collect();
    let mut sights: Vec<PlanSight> = sights?.into_iter().flatten().collect();
    sights.sort_unstable_by_key(|sight| (sight.from, sight.to));
    Some((firsts.matrix(), sights))
}
