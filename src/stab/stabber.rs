//! Pushing and popping portals: the cone of a growing sequence, and its verdict.
//!
//! A search that walks a portal graph depth first pushes the portal that it crosses and pops it
//! when it turns back. Each level keeps its own cone, so a pop costs nothing and a push only the
//! half-spaces of one portal.
//!
//! **Rules** (proved in `docs/formats/stab.md`; the terms are those of `docs/semantics.md`).
//! 1. No point of R^6 is strictly inside all half-spaces: not open.
//! 2. The cone has lineality: the portals' planes share a line, possibly at infinity, along which
//!    the Klein quadric can be reached from any point strictly inside: open.
//! 3. Else open iff the quadric takes both strict signs on the cone's rays and edges; with order
//!    half-spaces, or behind three of their rows.

use super::certificate::{Certificate, certificate};
use super::cone::Push;
use super::engine::{Engine, Range};
use super::extremal::{self, ExtremalLine};
use super::grazing::touching_line;
use super::line::StabLine;
use super::quadric::{BothSigns, Vector, signs_behind_triples};
use super::sequence::{Frame, Portal3};
use super::witness::{self, Interior, Witness};
use crate::num::Int;

/// What is true of a portal sequence (`docs/semantics.md`).
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// A line is strictly inside every portal.
    Open {
        /// Such a line.
        witness: Box<Witness>,
    },
    /// Not open, but a line meets every closed portal in its direction.
    Grazing {
        /// Such a line.
        touching_line: Box<StabLine>,
        /// Why no line is strictly inside.
        certificate: Certificate,
    },
    /// Neither.
    Blocked {
        /// Why no line is strictly inside.
        certificate: Certificate,
    },
}

/// How large a sequence's cone is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ConeShape {
    /// Extreme rays, modulo the lineality space.
    pub rays: usize,
    /// Pairs of adjacent rays.
    pub faces: usize,
    /// Points where the quadric crosses or touches a 2-face's inside.
    pub crossings: usize,
    /// The dimension of the lineality space.
    pub lineality: usize,
    /// The most bits of a ray's coordinate.
    pub bits: u64,
    /// Bytes that the pushed portal's level keeps.
    pub bytes: usize,
}

impl std::fmt::Display for ConeShape {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let ConeShape { rays, faces, crossings, lineality, bits, bytes } = self;
        write!(
            f,
            "{rays} rays, {faces} 2-faces, {crossings} crossings, lineality {lineality}, \
             {bits} bits, {bytes} bytes"
        )
    }
}

/// One pushed portal.
#[derive(Clone, Debug)]
struct Level {
    portal: Portal3,
    ordered: bool,
    cone: Engine,
    /// The range of all rows up to here.
    range: Range,
    /// Some point is strictly inside all half-spaces up to here.
    strict: bool,
}

/// The stabbing lines of a growing portal sequence.
#[derive(Clone, Debug, Default)]
pub struct Stabber {
    levels: Vec<Level>,
    /// About a point near a vertex of the first portal: coordinates are small relative to it.
    frame: Frame,
}

impl Stabber {
    /// The empty sequence, which every line stabs.
    pub fn new() -> Stabber {
        Stabber::default()
    }

    /// The empty sequence of portals whose grid is finer than what they are made of: numbers are
    /// short in multiples of `unit` grid units.
    pub fn in_units(unit: &Int) -> Stabber {
        Stabber { levels: Vec::new(), frame: Frame::near(&Default::default(), unit) }
    }

    /// How many portals are pushed.
    pub fn depth(&self) -> usize {
        self.levels.len()
    }

    /// Appends a portal. With `order`, lines must also cross the portal before it first.
    ///
    /// Two portals in one plane are crossed in one point, so the order asks nothing of them.
    pub fn push(&mut self, portal: &Portal3, order: bool) {
        if self.levels.is_empty() {
            self.frame = Frame::near(&portal.vertices()[0].coordinates, self.frame.unit());
        }
        let last = self.levels.last();
        let before = last.filter(|_| order).map(|level| &level.portal);
        let rows = rows_of(portal, before, &self.frame);
        let range = last.map(|level| level.range).unwrap_or_default();
        let range = range.with(rows.iter().map(|(row, _)| row));
        let mut strict = last.is_none_or(|level| level.strict);
        let mut cone = match last {
            Some(level) if strict => level.cone.widened_for(range),
            // Nothing is asked of the cone of a sequence that cannot be stabbed.
            Some(_) => Engine::everything(),
            None => Engine::everything().widened_for(range),
        };
        for (row, _) in &rows {
            strict = strict && cone.push(row) == Push::Strict;
        }
        self.levels.push(Level { portal: portal.clone(), ordered: order, cone, range, strict });
    }

    /// Takes the last portal off. Does nothing to the empty sequence.
    pub fn pop(&mut self) {
        self.levels.pop();
    }

    /// Is there a line strictly inside every portal (and, where asked, in order)?
    pub fn is_open(&self) -> bool {
        match self.levels.last() {
            None => true,
            Some(level) if !level.strict => false,
            Some(level) => level.cone.has_lineality() || self.signs(&level.cone).found(),
        }
    }

    /// A line strictly inside every portal (and, where asked, crossing them in order), or `None`
    /// where there is none.
    pub fn witness(&self) -> Option<Witness> {
        let Some(level) = self.levels.last() else { return Some(Witness::any()) };
        if !level.strict {
            return None;
        }
        let lineality = level.cone.lineality();
        let signs =
            if lineality.is_empty() { self.signs(&level.cone) } else { BothSigns::default() };
        if lineality.is_empty() && !signs.found() {
            return None;
        }
        let on_grid = |vector: &Vector| self.frame.on_grid(vector);
        let interior = Interior {
            rays: level.cone.rays().iter().map(on_grid).collect(),
            lineality: lineality.iter().map(on_grid).collect(),
            signs: BothSigns {
                positive: signs.positive.as_ref().map(on_grid),
                negative: signs.negative.as_ref().map(on_grid),
            },
            origin: self.frame.origin().clone(),
        };
        Some(witness::find(interior, &self.portals(), &self.orders()))
    }

    /// What is true of the sequence, with a line or a certificate that shows it.
    pub fn verdict(&self) -> Verdict {
        if let Some(witness) = self.witness() {
            return Verdict::Open { witness: Box::new(witness) };
        }
        let (portals, orders) = (self.portals(), self.orders());
        let certificate = certificate(&portals, &orders, self.frame.unit());
        match touching_line(&portals, &orders) {
            Some(line) => Verdict::Grazing { touching_line: Box::new(line), certificate },
            None => Verdict::Blocked { certificate },
        }
    }

    /// The size of the cone of the pushed portals, while something is strictly inside it.
    pub fn shape(&self) -> ConeShape {
        self.levels.last().map(|level| level.cone.shape()).unwrap_or_default()
    }

    /// The extremal stabbing lines of the closed portals, in ascending order.
    pub fn extremal_lines(&self) -> Vec<ExtremalLine> {
        extremal::lines(&self.portals())
    }

    fn portals(&self) -> Vec<&Portal3> {
        self.levels.iter().map(|level| &level.portal).collect()
    }

    fn orders(&self) -> Vec<bool> {
        self.levels.iter().map(|level| level.ordered).collect()
    }

    fn signs(&self, cone: &Engine) -> BothSigns {
        let mut signs = cone.signs();
        if !signs.found() && self.levels.iter().skip(1).any(|level| level.ordered) {
            signs_behind_triples(&mut signs, &cone.ray_sides(), &self.rows());
        }
        signs
    }

    /// Every row of the sequence, and whether it is an order half-space.
    fn rows(&self) -> Vec<(Vector, bool)> {
        let mut before: Option<&Portal3> = None;
        let mut rows = Vec::new();
        for level in &self.levels {
            let previous = before.filter(|_| level.ordered);
            rows.extend(rows_of(&level.portal, previous, &self.frame));
            before = Some(&level.portal);
        }
        rows
    }
}

/// The rows of a portal's edges, and of its order after `before`, with a flag for the latter; each
/// a positive multiple on vectors of the frame.
pub(super) fn rows_of(
    portal: &Portal3,
    before: Option<&Portal3>,
    frame: &Frame,
) -> Vec<(Vector, bool)> {
    let edges = (0..portal.vertices().len()).map(|edge| (portal.edge_row_in(edge, frame), false));
    let order = before.and_then(|before| before.order_row_in(portal, frame));
    edges.chain(order.map(|row| (row, true))).collect()
}

/// Decides a whole sequence: a witness where it is open, `None` where it is not.
///
/// `orders[i]` asks that portal `i` be crossed after portal `i - 1`; missing entries ask nothing.
pub fn decide_open(portals: &[&Portal3], orders: &[bool]) -> Option<Witness> {
    let mut stabber = Stabber::new();
    for (index, portal) in portals.iter().enumerate() {
        stabber.push(portal, orders.get(index).copied().unwrap_or(false));
    }
    stabber.witness()
}
