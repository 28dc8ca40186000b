//! Proofs that pairs of cells are not open: for each cell a tree of portal sequences.
//!
//! The verdicts are known, so the trees need no search for lines, and they may lean on each other:
//! a line that crosses the cells c0 … ck in order shows that *every* two of them see each other.
//! So a sequence from a cell to one that it is claimed not to see can only be open if all other
//! pairs of the cells that it crosses are claimed to be seen; a claim that is used this way is
//! about a shorter sequence, hence the claims hold by induction over the number of portals
//! (`docs/formats/proof.md`). What is left to refute are the sequences that step from what is seen
//! to what is not.
//!
//! At each sequence the portals that might still be crossed are flooded, past the planes that
//! separate two portals of the sequence (`separators`). Where that leaves a way to an unseen cell,
//! the tree goes on with the portals on such a way; the portals that the planes cut off, as far as
//! a way would lead through them, are named. A sequence that itself enters an unseen cell, and
//! passes the planes, is refuted by the certificate of its edges.
//!
//! The trees are a function of the graph and the verdicts. Complexity: per sequence one flood
//! through the cells that its cells see; the number of sequences has no useful bound.

use super::arena::{Arena, Directed, Plane, reverse};
use super::bits::Bits;
use super::decide::Decider;
use super::separators::separators;
use super::{OpenPair, Row, Tally};
use crate::geom::{BigLine, RationalPoint3};
use crate::num::{Rational, Sign};
use crate::report::{
    Cut, CutReason, Matrix, Progress, ProofHead, ProofNode, ProofText, ProofTree, ProvedGrazing,
    ProvedOpen, Refutation, Verdict,
};
use crate::scene::{CellId, PortalGraph};
use crate::stab::certificate;
use rayon::prelude::*;
use rustc_hash::FxHashMap;
use std::io::{self, Write};

/// What a proof is of: the verdicts, and what they were found by.
#[derive(Clone, Copy, Debug)]
pub struct Found<'a> {
    /// The verdicts of all pairs.
    pub matrix: &'a Matrix,
    /// The rows of all sources, with the lines of the open pairs.
    pub rows: &'a [Row],
    /// The lines of the grazing pairs, if they were classified.
    pub grazing: &'a [ProvedGrazing],
}

/// Writes the proof of what was found of a graph; `None` if interrupted.
///
/// # Errors
/// The first error of `out`.
pub fn write_proof<W: Write>(
    out: W,
    head: &ProofHead,
    graph: &PortalGraph,
    found: &Found,
    progress: &dyn Progress,
) -> io::Result<Option<W>> {
    let prover = Prover::new(graph, found.matrix);
    let mut text = ProofText::new(out, head, graph, found.matrix);
    for (source, pair) in prover.open_pairs(found.rows) {
        text.open(source, &pair);
    }
    found.grazing.iter().for_each(|pair| text.grazing(pair));
    match prover.prove(progress, |tree| text.tree(&tree)) {
        true => text.finish().map(Some),
        false => Ok(None),
    }
}

/// Which cells each cell is not claimed not to see, and the order of the trees.
struct Prover {
    arena: Arena,
    /// For each cell, those that it sees or might see; itself among them.
    sees: Vec<Bits>,
    order: Vec<u32>,
}

impl Prover {
    /// Prepares the proofs of what `matrix` says is not open.
    fn new(graph: &PortalGraph, matrix: &Matrix) -> Prover {
        let arena = Arena::new(graph);
        let sees: Vec<Bits> = (0..arena.cells())
            .map(|cell| {
                let mut sees = arena.no_cells();
                for (other, verdict) in matrix.row(cell as usize).iter().enumerate() {
                    match verdict {
                        Verdict::Open | Verdict::Undecided => {
                            sees.insert(other as u32);
                        }
                        Verdict::NotOpen | Verdict::Grazing => {}
                    }
                }
                sees
            })
            .collect();
        let mut order: Vec<u32> = (0..arena.cells()).collect();
        order.sort_by_key(|&cell| (sees[cell as usize].count(), cell));
        Prover { arena, sees, order }
    }

    /// The trees of all cells, in an order in which each settles its cell's pairs with the cells
    /// that come later; `keep` is given them in that order. `false` if interrupted.
    fn prove(&self, progress: &dyn Progress, mut keep: impl FnMut(ProofTree)) -> bool {
        progress.begin("proof", self.order.len() as u64);
        let mut targets = Vec::with_capacity(self.order.len());
        let mut earlier = self.arena.no_cells();
        for &source in &self.order {
            let mut wanted = self.arena.no_cells();
            (0..self.arena.cells()).for_each(|cell| {
                wanted.insert(cell);
            });
            wanted.subtract(&self.sees[source as usize]);
            wanted.subtract(&earlier);
            earlier.insert(source);
            targets.push((source, wanted));
        }
        for batch in targets.chunks(BATCH) {
            let trees: Option<Vec<ProofTree>> = batch
                .par_iter()
                .with_max_len(1)
                .map(|(source, wanted)| {
                    let tree = Walk::new(self, progress).tree(*source, wanted.clone());
                    progress.advance(1);
                    tree
                })
                .collect();
            let Some(trees) = trees else { return false };
            trees.into_iter().for_each(&mut keep);
        }
        true
    }

    /// The open pairs of `rows`, each with its source, in ascending order of the lower cell and the
    /// higher.
    fn open_pairs(&self, rows: &[Row]) -> Vec<(CellId, ProvedOpen)> {
        let pairs = rows.iter().flat_map(|row| row.open.iter().map(|pair| (row.source, pair)));
        let mut pairs: Vec<(CellId, &OpenPair)> = pairs.collect();
        pairs.sort_by_key(|(source, pair)| (*source.min(&pair.target), *source.max(&pair.target)));
        let proved =
            |(source, pair): &(CellId, &OpenPair)| (*source, self.open_pair(*source, pair));
        pairs.par_iter().map(proved).collect()
    }

    /// The pair with the planar portals that its line crosses: where the input's portal was
    /// triangulated, the one triangle that it passes inside.
    fn open_pair(&self, source: CellId, pair: &OpenPair) -> ProvedOpen {
        let arena = &self.arena;
        let points = pair.line.numbers().map(|point| point.map(|c| c.to_rational()));
        let mut cell = source.0;
        let portals = pair.portals.iter().map(|&number| {
            let is_piece = |&piece: &Directed| arena.source(piece) == number;
            let pieces: Vec<Directed> =
                arena.leaving(cell).iter().copied().filter(is_piece).collect();
            let is_crossed = |&piece: &Directed| pieces.len() == 1 || self.crosses(&points, piece);
            let crossed = pieces.iter().copied().find(is_crossed);
            let crossed = crossed.expect("a sightline crosses its portals");
            cell = arena.to(crossed);
            crossed
        });
        let portals = portals.collect();
        ProvedOpen {
            target: pair.target,
            portals,
            line: points.each_ref().map(RationalPoint3::from),
        }
    }

    /// Whether the line passes strictly inside a portal, in its direction.
    fn crosses(&self, [p, q]: &[[Rational; 3]; 2], portal: Directed) -> bool {
        let arena = &self.arena;
        let ids = arena.vertices(portal);
        let through = |a: &[Rational; 3], b: &[Rational; 3]| {
            BigLine::through_rational(a, b).expect("two points")
        };
        let line = through(p, q);
        (0..ids.len()).all(|i| {
            let [a, b] =
                [i, (i + 1) % ids.len()].map(|i| arena.grid().vertex(ids[i]).coordinates());
            match Sign::of(&line.side_product(&through(&a, &b))) {
                Sign::Positive => true,
                // Through an edge: the line of an open sequence meets none.
                Sign::Zero | Sign::Negative => false,
            }
        })
    }
}

/// Trees made at a time: enough to keep many threads busy, few enough to be held.
const BATCH: usize = 64;

/// What belongs to one portal of the current sequence, or to none of them yet.
struct Level {
    /// The cells that might be crossed on.
    seen: Bits,
    /// The cells not seen that might be reached.
    targets: Bits,
    /// How many portals were excluded, and listed as cut, before it.
    excluded: usize,
    listed: usize,
}

struct Walk<'a> {
    prover: &'a Prover,
    progress: &'a dyn Progress,
    nodes: Vec<ProofNode>,
    path: Vec<Directed>,
    crossed: Bits,
    levels: Vec<Level>,
    decider: Decider<'a>,
    /// Why a portal is excluded after the sequence, if it is; and the order in which they were.
    reasons: FxHashMap<Directed, CutReason>,
    excluded: Vec<Directed>,
    /// The excluded portals that the nodes of the sequence name.
    listed: Vec<Directed>,
    separators: FxHashMap<(Directed, Directed), Vec<Plane>>,
}

impl<'a> Walk<'a> {
    fn new(prover: &'a Prover, progress: &'a dyn Progress) -> Walk<'a> {
        Walk {
            prover,
            progress,
            nodes: Vec::new(),
            path: Vec::new(),
            crossed: prover.arena.no_cells(),
            levels: Vec::new(),
            decider: Decider::new(&prover.arena),
            reasons: FxHashMap::default(),
            excluded: Vec::new(),
            listed: Vec::new(),
            separators: FxHashMap::default(),
        }
    }

    /// `None` if interrupted.
    fn tree(mut self, source: u32, targets: Bits) -> Option<ProofTree> {
        let mut seen = self.prover.sees[source as usize].clone();
        seen.remove(source);
        self.crossed.insert(source);
        self.levels.push(Level { seen, targets, excluded: 0, listed: 0 });
        self.go_on(source)?;
        Some(ProofTree { source: CellId(source), nodes: self.nodes })
    }

    /// Refutes what might follow the sequence, which enters `cell`: returns its cuts and adds the
    /// nodes below it.
    fn go_on(&mut self, cell: u32) -> Option<Vec<Cut>> {
        let arena = &self.prover.arena;
        let reached = self.flood(cell);
        let leading = self.leading();
        let level = self.levels.last().expect("a level");
        let is_goal = |to: u32| leading.has(to) || level.targets.has(to);
        let children: Vec<Directed> = arena
            .onward(cell)
            .iter()
            .copied()
            .filter(|&next| reached.has(next) && is_goal(arena.to(next)))
            .collect();
        let cuts = self.cuts(cell, &children, &leading);
        for child in children {
            self.visit(child)?;
        }
        Some(cuts)
    }

    fn visit(&mut self, next: Directed) -> Option<()> {
        if self.progress.is_interrupted() {
            return None;
        }
        let (arena, prover) = (&self.prover.arena, self.prover);
        let cell = arena.to(next);
        let above = self.levels.last().expect("a level");
        let is_target = above.targets.has(cell);
        let (mut seen, mut targets) = (above.seen.clone(), above.targets.clone());
        seen.intersect(&prover.sees[cell as usize]);
        seen.remove(cell);
        targets.intersect(&prover.sees[cell as usize]);
        let (excluded, listed) = (self.excluded.len(), self.listed.len());
        self.levels.push(Level { seen, targets, excluded, listed });
        self.path.push(next);
        self.crossed.insert(cell);
        let at = self.nodes.len();
        self.nodes.push(ProofNode {
            depth: self.path.len() as u32,
            portal: next,
            refutation: None,
            cuts: Vec::new(),
        });
        match self.refute(is_target) {
            Some(refutation) => self.nodes[at].refutation = Some(refutation),
            None => self.nodes[at].cuts = self.go_on(cell)?,
        }
        self.crossed.remove(cell);
        self.path.pop();
        self.decider.truncate(self.path.len());
        let level = self.levels.pop().expect("a level");
        for portal in self.excluded.drain(level.excluded..) {
            self.reasons.remove(&portal);
        }
        self.listed.truncate(level.listed);
        Some(())
    }

    /// Why the path is not open, if its edges exclude each other or it enters a cell that is not
    /// seen.
    fn refute(&mut self, is_target: bool) -> Option<Refutation> {
        let arena = &self.prover.arena;
        let possible = self.decider.extend(&self.path, &mut Tally::default());
        if let [.., before, last] = self.path[..]
            && arena.is_impossible(before, last)
        {
            return Some(Refutation::Flush);
        }
        if possible && !is_target {
            return None;
        }
        let (portals, units) = arena.exact_portals(&self.path);
        let orders: Vec<bool> = (0..self.path.len())
            .map(|i| i > 0 && arena.needs_order(self.path[i - 1], self.path[i]))
            .collect();
        let portals: Vec<_> = portals.iter().map(|portal| &**portal).collect();
        let certificate = Box::new(certificate(&portals, &orders, &units));
        Some(Refutation::Certificate { certificate, units })
    }

    /// The portals that a line might cross after the sequence, as far as planes can tell; those
    /// that it cannot are excluded on the way.
    fn flood(&mut self, cell: u32) -> Bits {
        let planes = self.planes();
        let arena = &self.prover.arena;
        let level = self.levels.last().expect("a level");
        let mut reached = arena.no_portals();
        let mut entered = arena.no_cells();
        let mut stack = vec![cell];
        while let Some(from) = stack.pop() {
            for &next in arena.onward(from) {
                let to = arena.to(next);
                let might = (level.seen.has(to) || level.targets.has(to)) && !self.crossed.has(to);
                if !might || reached.has(next) || self.reasons.contains_key(&next) {
                    continue;
                }
                if let Some(reason) = excludes(arena, &self.path, &planes, next) {
                    self.reasons.insert(next, reason);
                    self.excluded.push(next);
                    continue;
                }
                reached.insert(next);
                if level.seen.has(to) && entered.insert(to) {
                    stack.push(to);
                }
            }
        }
        reached
    }

    /// The planes that separate the last portal from those before it.
    fn planes(&mut self) -> Vec<(CutReason, Plane)> {
        let arena = &self.prover.arena;
        let mut planes = Vec::new();
        let Some((&last, before)) = self.path.split_last() else { return planes };
        for (position, &first) in before.iter().enumerate() {
            let found = self.separators.entry((first, last)).or_insert_with(|| {
                let mut found = Vec::new();
                separators(arena, first, last, &mut found);
                found
            });
            let positions = [position as u32, before.len() as u32];
            planes.extend(found.iter().map(|plane| {
                (CutReason::Separated { positions, through: plane.through() }, *plane)
            }));
        }
        planes
    }

    /// The cells from which a way leads to a target through portals that are not excluded.
    fn leading(&self) -> Bits {
        let arena = &self.prover.arena;
        let level = self.levels.last().expect("a level");
        let mut leading = arena.no_cells();
        let mut stack: Vec<u32> = level.targets.iter().collect();
        while let Some(cell) = stack.pop() {
            for &leaving in arena.leaving(cell) {
                let (entering, from) = (reverse(leaving), arena.to(leaving));
                if level.seen.has(from)
                    && !self.crossed.has(from)
                    && !self.reasons.contains_key(&entering)
                    && leading.insert(from)
                {
                    stack.push(from);
                }
            }
        }
        leading
    }

    /// Of the excluded portals those that have to be named, so that no way leads to a target but
    /// through `children`, by their reasons; noted as listed.
    ///
    /// Let a way leave the sequence not through a child. Its last excluded portal leads into a cell
    /// from which a target can be reached, and if there is none, then its first portal leads on to
    /// a target and is a child. So it is enough to name the excluded portals into such cells, and
    /// of them those that can be reached past the named ones.
    fn cuts(&mut self, cell: u32, children: &[Directed], leading: &Bits) -> Vec<Cut> {
        let arena = &self.prover.arena;
        let level = self.levels.last().expect("a level");
        let mut entered = arena.no_cells();
        let mut stack = vec![cell];
        let mut named: Vec<(CutReason, Directed)> = Vec::new();
        while let Some(from) = stack.pop() {
            for &next in arena.onward(from) {
                let to = arena.to(next);
                let is_child = from == cell && children.contains(&next);
                let goes_on = level.seen.has(to) || level.targets.has(to);
                if is_child || !goes_on || self.crossed.has(to) || self.listed.contains(&next) {
                    continue;
                }
                let is_goal = leading.has(to) || level.targets.has(to);
                match self.reasons.get(&next) {
                    Some(reason) if is_goal => {
                        named.push((*reason, next));
                        self.listed.push(next);
                    }
                    _ if level.seen.has(to) && entered.insert(to) => stack.push(to),
                    _ => {}
                }
            }
        }
        named.sort_unstable();
        let groups = named.chunk_by(|a, b| a.0 == b.0);
        groups
            .map(|group| Cut {
                reason: group[0].0,
                portals: group.iter().map(|(_, portal)| *portal).collect(),
            })
            .collect()
    }
}

/// Why a portal cannot be crossed after the path, as far as its last portal and `planes` tell.
fn excludes(
    arena: &Arena,
    path: &[Directed],
    planes: &[(CutReason, Plane)],
    portal: Directed,
) -> Option<CutReason> {
    let &last = path.last()?;
    let behind = arena.wholly_behind(arena.plane_of(last), portal)
        || arena.wholly_behind(arena.plane_of(reverse(portal)), last);
    if behind {
        return Some(CutReason::Behind { position: path.len() as u32 - 1 });
    }
    let found = planes.iter().find(|(_, plane)| arena.wholly_behind(plane, portal));
    found.map(|(reason, _)| *reason)
}
