//! Eye queries: the walk over portal sequences, and the culls.
//!
//! The culls are those of Teller and Séquin (Visibility preprocessing for interactive walkthroughs,
//! 1991), as far as a graph without cell geometry has them, and Carr's traversal; each reaches all
//! cells that the exact one reaches:
//! - *flood*: the connected component of the eye's cells;
//! - *portals*: through portals in front of the eye and, each on its own, in the frustum;
//! - *float*: the frustum clipped at each portal in floats ([`super::propose`]);
//! - *exact*.

use super::frustum::around;
use super::locate::cells_of_eye;
use super::propose::FloatCone;
use super::view::View;
use super::{Cone, EyeGraph, Frustum, LocateError, Region};
use crate::geom::RationalPoint3;
use crate::num::Int;
use crate::predicates::Direction;
use crate::scene::{CellId, PortalId};
use std::collections::VecDeque;
use std::rc::Rc;

/// How cells are ruled out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cull {
    /// The cells joined to the eye's by portals.
    Flood,
    /// Through portals before the eye and in the frustum, each judged alone.
    Portals,
    /// Clipping in floats; never misses a cell.
    Float,
    /// The cells that are seen.
    Exact,
}

/// A question.
#[derive(Clone, Copy, Debug)]
pub struct Query<'q> {
    /// Where the eye is.
    pub eye: &'q RationalPoint3,
    /// What it looks at; all around it without.
    pub frustum: Option<&'q Frustum>,
    /// The cell that the eye is in, where the portals do not tell; a world's tree always does.
    pub cell: Option<CellId>,
    /// Whether to give what is seen (with [`Cull::Exact`]): of each sequence's last portal, or of
    /// the cells of a world.
    pub regions: bool,
}

/// A cell that is reached.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Reached {
    /// The cell.
    pub cell: CellId,
    /// The shortest sequence of portals to it, of those the first; none for the eye's own cells.
    pub portals: Vec<PortalId>,
    /// A direction strictly inside all these portals and the frustum (with [`Cull::Exact`]).
    pub direction: Option<[Int; 3]>,
}

/// What an eye sees.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Answer {
    /// The cells that the eye belongs to: several where it is in a closed portal.
    pub eye_cells: Vec<CellId>,
    /// The cells reached, in ascending order.
    pub cells: Vec<Reached>,
    /// How many sequences were found to be visible (by the cull's measure; 0 where it does not
    /// look at sequences).
    pub sequences: u64,
    /// The seen part of each sequence's last portal, if asked for.
    pub regions: Vec<Region>,
}

impl EyeGraph<'_> {
    /// Answers a query.
    ///
    /// # Errors
    /// [`LocateError`] where it is not known which cell the eye is in.
    pub fn look(&self, query: &Query, cull: Cull) -> Result<Answer, LocateError> {
        let view = View::new(self, query.eye);
        let sides = sides(query.frustum);
        let starts = cells_of_eye(&view, query.cell)?.into_iter().map(|cell| {
            let limits = sides.iter().cloned().chain(view.planes_at_eye(cell)).collect();
            Start { cell, limits }
        });
        let starts: Vec<Start> = starts.collect();
        let mut regions = Vec::new();
        let mut answer = search(&view, query.frustum, cull, &starts, |cell, portals, cone| {
            if query.regions {
                regions.push(Region::new(&view, portals, cell, cone));
            }
        });
        answer.regions = regions;
        Ok(answer)
    }
}

/// A cell that the eye belongs to.
pub(super) struct Start {
    pub(super) cell: CellId,
    /// The planes that bound every direction from the eye into the cell: those of the frustum, and
    /// of the cell's boundary where the eye lies on it.
    pub(super) limits: Vec<Rc<Direction>>,
}

/// The sides of a frustum, if there is one.
pub(super) fn sides(frustum: Option<&Frustum>) -> Vec<Rc<Direction>> {
    frustum.into_iter().flat_map(Frustum::sides).collect()
}

/// The cells reached from the eye's own; `each` is told of each sequence that is seen exactly, with
/// its directions.
pub(super) fn search(
    view: &View,
    frustum: Option<&Frustum>,
    cull: Cull,
    starts: &[Start],
    mut each: impl FnMut(CellId, &[usize], &Cone),
) -> Answer {
    let mut found = Found { best: vec![None; view.graph.graph.cells.len()], sequences: 0 };
    match cull {
        Cull::Flood => spread(view, starts, &mut found, |_, _| true),
        Cull::Portals => {
            let sides = sides(frustum);
            spread(view, starts, &mut found, |cell, portal| {
                view.leaves(portal, cell) && entered(view, &sides, portal).is_some()
            });
        }
        Cull::Float => {
            for start in starts {
                look_in_floats(view, start, &mut found);
            }
        }
        Cull::Exact => {
            for start in starts {
                look_exactly(view, start, frustum, &mut found, &mut each);
            }
        }
    }
    let reached = found.best.into_iter().zip(0..).filter_map(|(best, cell)| {
        let Best { portals, cone } = best?;
        let portals = portals.iter().map(|&portal| PortalId(portal as u32)).collect();
        let direction = cone.map(|cone| cone.interior());
        Some(Reached { cell: CellId(cell), portals, direction })
    });
    Answer {
        cells: reached.collect(),
        eye_cells: starts.iter().map(|start| start.cell).collect(),
        sequences: found.sequences,
        regions: Vec::new(),
    }
}

/// The best sequence to a cell.
#[derive(Clone)]
struct Best {
    portals: Vec<usize>,
    /// Its directions, by the exact cull.
    cone: Option<Cone>,
}

/// What was found so far.
struct Found {
    best: Vec<Option<Best>>,
    sequences: u64,
}

impl Found {
    /// Notes a sequence, if it is better than what there is.
    fn note(&mut self, cell: CellId, portals: &[usize], cone: Option<&Cone>) {
        self.sequences += u64::from(!portals.is_empty());
        let best = &mut self.best[cell.0 as usize];
        let is_better =
            |best: &Best| (portals.len(), portals) < (best.portals.len(), &best.portals[..]);
        if best.as_ref().is_none_or(is_better) {
            *best = Some(Best { portals: portals.to_vec(), cone: cone.cloned() });
        }
    }
}

/// Reaches cells in breadth, each once, through portals that pass on their own.
fn spread(view: &View, from: &[Start], found: &mut Found, passes: impl Fn(CellId, usize) -> bool) {
    let mut queue: VecDeque<(CellId, Vec<usize>)> =
        from.iter().map(|start| (start.cell, Vec::new())).collect();
    for start in from {
        found.note(start.cell, &[], None);
    }
    while let Some((cell, portals)) = queue.pop_front() {
        for &portal in &view.graph.portals_of[cell.0 as usize] {
            let beyond = view.graph.beyond(portal, cell);
            if found.best[beyond.0 as usize].is_none() && passes(cell, portal) {
                let mut portals = portals.clone();
                portals.push(portal);
                found.note(beyond, &portals, None);
                queue.push_back((beyond, portals));
            }
        }
    }
    found.sequences = 0;
}

/// The directions through one portal within the limits.
fn entered(view: &View, limits: &[Rc<Direction>], portal: usize) -> Option<Cone> {
    let seen = view.seen(portal);
    let mut cone = Cone::over(&seen.rays, &seen.planes);
    limits.iter().all(|plane| cone.clip(plane)).then_some(cone)
}

/// A cone of directions within the limits, where there is one.
fn within(limits: &[Rc<Direction>], frustum: Option<&Frustum>) -> Option<Cone> {
    let candidates = match frustum {
        Some(frustum) => vec![Cone::between(&frustum.sides())],
        None => around().into(),
    };
    let clipped = candidates
        .into_iter()
        .filter_map(|mut cone| limits.iter().all(|plane| cone.clip(plane)).then_some(cone));
    clipped.into_iter().next()
}

fn look_exactly(
    view: &View,
    Start { cell, limits }: &Start,
    frustum: Option<&Frustum>,
    found: &mut Found,
    each: &mut impl FnMut(CellId, &[usize], &Cone),
) {
    // An eye on the cell's boundary may look away from it.
    let Some(start) = within(limits, frustum) else { return };
    found.note(*cell, &[], Some(&start));
    let enter = |before: Option<(&Cone, usize)>, portal: usize| {
        let Some((cone, last)) = before else { return entered(view, limits, portal) };
        let mut cone = cone.clone();
        let seen = view.seen(portal);
        let order = view.order(last, portal);
        seen.planes.iter().chain(&order).all(|plane| cone.clip(plane)).then_some(cone)
    };
    walk(view, *cell, enter, |cell, portals, cone: &Cone| {
        found.note(cell, portals, Some(cone));
        each(cell, portals, cone);
    });
}

fn look_in_floats(view: &View, Start { cell, limits }: &Start, found: &mut Found) {
    found.note(*cell, &[], None);
    let enter = |before: Option<(&FloatCone, usize)>, portal: usize| {
        let seen = view.seen(portal);
        let Some((cone, _)) = before else {
            let mut cone = FloatCone::over(&seen.rays, &seen.planes);
            return limits.iter().all(|plane| cone.clip(plane.float())).then_some(cone);
        };
        let mut cone = cone.clone();
        seen.planes.iter().all(|plane| cone.clip(plane.float())).then_some(cone)
    };
    walk(view, *cell, enter, |cell, portals, _: &FloatCone| found.note(cell, portals, None));
}

/// One cell of a sequence that is being extended.
struct Step<C> {
    cell: CellId,
    /// The cone of the sequence so far, and its last portal; none in the eye's cell.
    before: Option<(C, usize)>,
    /// How many of the cell's portals were tried.
    tried: usize,
}

/// Walks over all sequences from `start` that enter no cell twice and that `enter` lets pass: it is
/// given the cone of a sequence with its last portal, and the next portal.
fn walk<C>(
    view: &View,
    start: CellId,
    enter: impl Fn(Option<(&C, usize)>, usize) -> Option<C>,
    mut reach: impl FnMut(CellId, &[usize], &C),
) {
    let graph = view.graph;
    let mut on_path = vec![false; graph.portals_of.len()];
    on_path[start.0 as usize] = true;
    let mut portals = Vec::new();
    let mut steps: Vec<Step<C>> = vec![Step { cell: start, before: None, tried: 0 }];
    while let Some(step) = steps.last_mut() {
        let cell = step.cell;
        let Some(&portal) = graph.portals_of[cell.0 as usize].get(step.tried) else {
            on_path[cell.0 as usize] = false;
            steps.pop();
            portals.pop();
            continue;
        };
        step.tried += 1;
        let beyond = graph.beyond(portal, cell);
        if on_path[beyond.0 as usize] || !view.leaves(portal, cell) {
            continue;
        }
        let before = step.before.as_ref().map(|(cone, last)| (cone, *last));
        let Some(cone) = enter(before, portal) else { continue };
        portals.push(portal);
        reach(beyond, &portals, &cone);
        on_path[beyond.0 as usize] = true;
        steps.push(Step { cell: beyond, before: Some((cone, portal)), tried: 0 });
    }
}
