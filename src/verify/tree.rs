//! Trees of sequences that leave no way to the cells that a cell is not open to.

use super::exact::{Directed, Graph, Vector, order, plane};
use super::text::{Checked, Fields, ensure};
use super::{Claims, Verified};
use num_bigint::Sign::NoSign;
use num_traits::Zero;
use std::mem::replace;

/// A sequence whose children are still to come; the first of a tree has no portal.
struct Node {
    /// The cell that it enters, or the source.
    cell: usize,
    /// The cells that a line might cross on, and those that no line may reach; none if refuted.
    seen: Vec<bool>,
    targets: Vec<bool>,
    children: Vec<usize>,
    /// The portals cut here.
    cuts: Vec<usize>,
}

/// All trees, one after the other.
pub struct Trees<'a> {
    graph: &'a Graph,
    claims: &'a Claims,
    /// Whether each cell's tree has begun.
    pub sources: Vec<bool>,
    /// The nodes above the next line, and the portals that they add to each other.
    nodes: Vec<Node>,
    sequence: Vec<&'a Directed>,
    /// How often each portal is cut at them.
    cuts_of: Vec<usize>,
    /// Those of the splits around a part of a certificate.
    splits: Vec<Vector>,
}

impl<'a> Trees<'a> {
    pub fn new(graph: &'a Graph, claims: &'a Claims) -> Trees<'a> {
        let (sources, cuts_of) = (vec![false; claims.len()], vec![0; graph.portals.len()]);
        let (nodes, sequence, splits) = Default::default();
        Trees { graph, claims, sources, nodes, sequence, cuts_of, splits }
    }

    /// A line `source A`.
    pub fn begin(&mut self, fields: &mut Fields) -> Checked<()> {
        self.close(0)?;
        fields.take()?;
        let cell = fields.index(self.sources.len())?;
        ensure(!replace(&mut self.sources[cell], true), "the cell has had its tree")?;
        let mut seen: Vec<bool> = self.claims[cell].iter().map(|&claim| claim >= 2).collect();
        let targets = seen.iter().zip(&self.sources).map(|(seen, done)| !seen && !done).collect();
        seen[cell] = false;
        self.nodes.push(Node { cell, seen, targets, children: Vec::new(), cuts: Vec::new() });
        fields.end()
    }

    /// A line of a node.
    pub fn node(&mut self, fields: &mut Fields, verified: &mut Verified) -> Checked<()> {
        let depth = fields.index(usize::MAX)?;
        self.close(depth)?;
        ensure(depth > 0 && self.nodes.len() == depth, "the node has no parent")?;
        let portal = fields.index(self.graph.portals.len())?;
        let directed = &self.graph.portals[portal];
        let cell = directed.to;
        let parent = &mut self.nodes[depth - 1];
        let enters_target = parent.targets[cell];
        let is_new = parent.cell == directed.from && !parent.children.contains(&portal);
        let goes_on = is_new && (parent.seen[cell] || enters_target);
        ensure(goes_on, "the node does not go on from its parent, or a second time")?;
        parent.children.push(portal);
        let kind = fields.peek();
        let is_refuted = matches!(kind, "l" | "i" | "s");
        let narrowed = |set: &[bool]| -> Vec<bool> {
            let may_see = self.claims[cell].iter().map(|&claim| !is_refuted && claim >= 2);
            set.iter().zip(may_see).map(|(&has, may_see)| has && may_see).collect()
        };
        let (mut seen, targets) = (narrowed(&parent.seen), narrowed(&parent.targets));
        seen[cell] = false;
        self.sequence.push(directed);
        verified.nodes[0] += 1;
        if is_refuted {
            verified.nodes[if kind == "l" { 1 } else { 2 }] += 1;
            self.check_refutation(fields)?;
            fields.end()?;
        }
        ensure(is_refuted || !enters_target, "a target is entered, and nothing refuted")?;
        let cuts = self.cuts(fields)?;
        self.nodes.push(Node { cell, seen, targets, children: Vec::new(), cuts });
        Ok(())
    }

    /// The rest of the fields: portals that cannot be crossed after the sequence.
    fn cuts(&mut self, fields: &mut Fields) -> Checked<Vec<usize>> {
        let (graph, length) = (self.graph, self.sequence.len());
        let mut cuts = Vec::new();
        while !fields.rest.is_empty() {
            let kind = fields.take()?;
            ensure(kind == "b" || kind == "p", "expected a cut or a refutation")?;
            let place = fields.index(length)?;
            let at = self.sequence[place];
            let mut separator = at.plane.clone();
            if kind == "p" {
                let later = fields.index(length)?;
                let mut vertex = || fields.index(graph.points.len());
                let corners = [vertex()?, vertex()?, vertex()?];
                separator = plane(corners.map(|corner| &graph.points[corner]));
                let [low, high] = at.heights(&separator);
                let [floor, top] = self.sequence[later].heights(&separator);
                let separates = high <= NoSign && floor >= NoSign && low < top && place < later;
                ensure(separates, "the plane does not separate the two portals")?;
            }
            for portal in fields.indices(graph.portals.len())? {
                let is_behind = graph.portals[portal].heights(&separator)[1] <= NoSign;
                let faces = || at.heights(&graph.portals[portal].plane)[0] >= NoSign;
                let is_cut_off = is_behind || (kind == "b" && faces());
                ensure(is_cut_off, &format!("portal {portal} is not cut off"))?;
                self.cuts_of[portal] += 1;
                cuts.push(portal);
            }
        }
        Ok(cuts)
    }

    /// Checks and forgets the nodes that are not above a line of this depth.
    pub fn close(&mut self, depth: usize) -> Checked<()> {
        for node in self.nodes.split_off(depth.min(self.nodes.len())).iter().rev() {
            let is_left = self.reaches_target(node);
            ensure(!is_left, "in the tree above, a way is left to a cell claimed not open")?;
            node.cuts.iter().for_each(|&portal| self.cuts_of[portal] -= 1);
            self.sequence.pop();
        }
        Ok(())
    }

    /// Whether portals that are neither cut nor children lead to a target, through seen cells.
    fn reaches_target(&self, node: &Node) -> bool {
        let (mut is_left, mut entered) = (false, vec![false; self.sources.len()]);
        let mut next = self.graph.leaving[node.cell].clone();
        next.retain(|portal| !node.children.contains(portal));
        while let Some(portal) = next.pop() {
            let cell = self.graph.portals[portal].to;
            let is_open = self.cuts_of[portal] == 0;
            is_left |= is_open && node.targets[cell];
            if is_open && node.seen[cell] && !replace(&mut entered[cell], true) {
                next.extend(&self.graph.leaving[cell]);
            }
        }
        is_left
    }

    /// A vector, and whether a line of the sequence must be strictly on its positive side.
    fn factor(&self, fields: &mut Fields) -> Checked<(Vector, bool)> {
        let field = fields.take()?;
        let number = |text: &str| text.parse().ok().filter(|n: &usize| n.to_string() == text);
        let find = || match (field.strip_prefix('o').map(number), field.strip_prefix('h')) {
            (Some(place), _) => {
                let before = self.sequence.get(place?.checked_sub(1)?)?;
                Some(order(&before.plane, &self.sequence.get(place?)?.plane))
            }
            (_, Some(split)) => self.splits.get(number(split)?).cloned(),
            _ => {
                let (portal, edge) = field.split_once('.')?;
                self.sequence.get(number(portal)?)?.edges.get(number(edge)?).cloned()
            }
        };
        let vector = find().ok_or_else(|| format!("{field:?} is no condition of the sequence"))?;
        Ok((vector, !field.starts_with('h')))
    }

    /// Why no line passes the sequence, or none of those on one side of the splits.
    fn check_refutation(&mut self, fields: &mut Fields) -> Checked<()> {
        match fields.take()? {
            "l" => return self.check_sum(fields),
            "i" => return self.check_identity(fields),
            kind => ensure(kind == "s", "expected i, l or s")?,
        }
        ensure(self.splits.len() < 64, "more than 64 splits enclose one another")?;
        let plane: Vector = fields.integers()?;
        for half in [plane.clone(), plane.map(|c| -c)] {
            self.splits.push(half);
            self.check_refutation(fields)?;
            self.splits.pop();
        }
        Ok(())
    }

    /// Vectors whose weighted sum is zero.
    fn check_sum(&self, fields: &mut Fields) -> Checked<()> {
        let (mut any_strict, mut sum) = (false, Vector::default());
        for _ in 0..fields.index(usize::MAX)? {
            let (vector, is_strict) = self.factor(fields)?;
            let weight = fields.positive()?;
            sum.iter_mut().zip(&vector).for_each(|(sum, part)| *sum += &weight * part);
            any_strict |= is_strict;
        }
        ensure(any_strict, "no condition of the sequence takes part")?;
        ensure(sum.iter().all(Zero::is_zero), "the weighted sum is not zero")
    }

    /// Products of conditions that add up to a multiple of the quadric.
    fn check_identity(&self, fields: &mut Fields) -> Checked<()> {
        let multiple = fields.integer()?;
        let (mut any_strict, mut sum) = (false, <[Vector; 6]>::default());
        for _ in 0..fields.index(usize::MAX)? {
            let ((f, f_is_strict), (g, g_is_strict)) = (self.factor(fields)?, self.factor(fields)?);
            let weight = fields.positive()?;
            any_strict |= f_is_strict && g_is_strict;
            // side(x, f) has the coefficient f[(a + 3) % 6] at x_a.
            for (a, b) in (0..36).map(|at| (at / 6, at % 6)) {
                sum[a.min(b)][a.max(b)] += &weight * &f[(a + 3) % 6] * &g[(b + 3) % 6];
            }
        }
        (0..3).for_each(|i| sum[i][i + 3] -= &multiple);
        ensure(any_strict && !multiple.is_zero(), "nothing strict, or the multiple is zero")?;
        ensure(sum.iter().flatten().all(Zero::is_zero), "no multiple of the quadric")
    }
}
