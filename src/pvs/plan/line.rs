//! A line that turns around a vertex, and what lies along it when it is moved a little to one side.
//!
//! ```text
//!                     ahead            Moved to the left, the line runs from behind through the
//!              \     |                 cells to the left of the vertex (its left fan) to ahead,
//!       left    \    |    right        unless something opaque ends there.
//!       fan   ___\   |    fan
//!                 \  |
//!                  \ v----------
//!                    |
//!                    behind
//! ```

use super::around::Wedge;
use super::groups::Groups;
use super::view::View;
use crate::scene::CellId;
use crate::scene::plan::{Crossing, Crossings, PlanGraph};
use std::cmp::Ordering;

/// The line, and the memory that it uses from one vertex to the next.
pub(super) struct TurningLine<'a> {
    graph: &'a PlanGraph,
    crossings: &'a Crossings,
    groups: &'a Groups,
    view: View,
    /// The rank of each point in use among the directions of lines through the vertex.
    ranks: Vec<u32>,
    /// The leaf seen in each range between two neighbouring directions: of directions in the upper
    /// half turn, and opposite to them.
    leaves: [Vec<u32>; 2],
    chain: Chain,
}

/// No leaf.
const NONE: u32 = u32::MAX;

/// What lies along the line in one direction.
#[derive(Default)]
struct Arm {
    /// The nodes of the view, outward.
    nodes: Vec<u32>,
    /// The ways into their cells; of the first, which is at the vertex, none.
    ways: Vec<Crossing>,
    /// The groups of the cells, none as the count of groups.
    groups: Vec<u32>,
    cell: Option<CellId>,
}

/// The cells beside the vertex on one side of the line.
#[derive(Default)]
struct Fan {
    /// From the cell ahead on, around the vertex.
    from_ahead: Vec<Crossing>,
    /// From the cell behind on, the other way round; where the first reaches the cell behind, the
    /// same ways reversed.
    from_behind: Vec<Crossing>,
    /// Whether the first reaches the cell behind.
    is_open: bool,
}

/// What lies along the line where it is now.
#[derive(Default)]
pub(super) struct Chain {
    ahead: Arm,
    behind: Arm,
    /// To the left, and to the right.
    fans: [Fan; 2],
    groups_of_fans: [[Vec<u32>; 2]; 2],
    group_of_cell: Vec<u32>,
}

impl<'a> TurningLine<'a> {
    pub(super) fn new(
        graph: &'a PlanGraph,
        crossings: &'a Crossings,
        groups: &'a Groups,
    ) -> TurningLine<'a> {
        let of = |cell| groups.of(CellId(cell)).unwrap_or(groups.count() as u32);
        let group_of_cell = (0..graph.cells.len() as u32).map(of).collect();
        TurningLine {
            graph,
            crossings,
            groups,
            view: View::default(),
            ranks: vec![0; graph.points.len()],
            leaves: [Vec::new(), Vec::new()],
            chain: Chain { group_of_cell, ..Chain::default() },
        }
    }

    /// Turns the line once around a vertex, and calls `see` with pairs of groups that see each
    /// other along it. Pairs may come more than once; every pair that some line near the vertex
    /// joins, and stops joining there, comes.
    pub(super) fn turn_around(
        &mut self,
        vertex: u32,
        wedges: &[Wedge],
        see: &mut impl FnMut(u32, u32, &Chain),
    ) {
        self.view.look(&self.graph.points, self.crossings, vertex, wedges);
        let count = self.rank(vertex);
        self.spread(vertex, count);
        self.chain.ahead.clear();
        self.chain.behind.clear();
        let none = self.groups.count() as u32;
        for range in 0..count {
            let [ahead, behind] = [0, 1].map(|half| self.leaves[half][range]);
            let cells = [self.chain.ahead.cell, self.chain.behind.cell];
            let mut new_ahead =
                self.chain.ahead.follow(&self.view, ahead, &self.chain.group_of_cell);
            let mut new_behind =
                self.chain.behind.follow(&self.view, behind, &self.chain.group_of_cell);
            if cells != [self.chain.ahead.cell, self.chain.behind.cell] || range == 0 {
                self.chain.find_fans(self.crossings, vertex);
                (new_ahead, new_behind) = (0, 0);
                self.chain.see_within_fans(none, see);
            }
            self.chain.see_new(new_ahead, new_behind, none, see);
        }
    }

    /// Ranks all directions in which the view changes, opposite ones alike; returns how many there
    /// are.
    fn rank(&mut self, vertex: u32) -> usize {
        let points = &self.graph.points;
        let mut ends: Vec<(u32, bool)> = self
            .view
            .leaves
            .iter()
            .flat_map(|leaf| [leaf.from, leaf.to])
            .map(|p| (p, false))
            .collect();
        ends.dedup();
        for (point, is_upper) in &mut ends {
            *is_upper = points.is_upper(vertex, *point);
        }
        let order = |p: &(u32, bool), q: &(u32, bool)| points.compare_lines(vertex, *p, *q);
        ends.sort_by(order);
        let mut rank = 0;
        for i in 0..ends.len() {
            if i > 0 && order(&ends[i - 1], &ends[i]) != Ordering::Equal {
                rank += 1;
            }
            self.ranks[ends[i].0 as usize] = rank;
        }
        if ends.is_empty() { 0 } else { rank as usize + 1 }
    }

    /// Tells for each range of directions which leaf is seen in it, and which in the opposite one.
    /// Range i lies between rank i and the next; the last reaches over to rank 0 in the other half.
    fn spread(&mut self, vertex: u32, count: usize) {
        for half in &mut self.leaves {
            half.clear();
            half.resize(count, NONE);
        }
        for (number, leaf) in self.view.leaves.iter().enumerate() {
            let mut half = usize::from(!self.graph.points.is_upper(vertex, leaf.from));
            let [mut range, end] = [leaf.from, leaf.to].map(|p| self.ranks[p as usize] as usize);
            while range != end {
                self.leaves[half][range] = number as u32;
                range += 1;
                if range == count {
                    range = 0;
                    half = 1 - half;
                }
            }
        }
    }
}

impl Arm {
    fn clear(&mut self) {
        self.nodes.clear();
        self.ways.clear();
        self.groups.clear();
        self.cell = None;
    }

    /// Follows a leaf; returns the index of the first node that is new.
    fn follow(&mut self, view: &View, leaf: u32, group_of_cell: &[u32]) -> usize {
        if leaf == NONE {
            self.clear();
            return 0;
        }
        let last = view.leaves[leaf as usize].node;
        let length = view.nodes[last as usize].depth as usize + 1;
        let mut node = last;
        let mut fresh = length;
        self.nodes.resize(length, NONE);
        // From the end inward, until what was there before is met.
        loop {
            let &super::view::Node { parent, depth, .. } = &view.nodes[node as usize];
            if self.nodes[depth as usize] == node {
                break;
            }
            self.nodes[depth as usize] = node;
            fresh = depth as usize;
            match parent {
                Some(parent) => node = parent,
                None => break,
            }
        }
        self.groups.truncate(fresh);
        self.ways.truncate(fresh.saturating_sub(1));
        for &node in &self.nodes[fresh..] {
            let node = &view.nodes[node as usize];
            self.groups.push(group_of_cell[node.cell.0 as usize]);
            self.ways.extend(node.way);
        }
        self.cell = Some(view.nodes[self.nodes[0] as usize].cell);
        fresh
    }
}

impl Chain {
    /// Walks around the vertex from either end of the line, on either side.
    fn find_fans(&mut self, crossings: &Crossings, vertex: u32) {
        let (ahead, behind) = (self.ahead.cell, self.behind.cell);
        for (side, fan) in self.fans.iter_mut().enumerate() {
            // To the left of the cell ahead is counter-clockwise, to the left of the one behind
            // clockwise.
            let walk = |from: Option<CellId>, until: Option<CellId>, is_left: bool| {
                let mut ways = Vec::new();
                let Some(mut cell) = from else { return (ways, false) };
                if from == until {
                    return (ways, true);
                }
                let touches = |way: &&Crossing| match is_left {
                    true => way.left == vertex,
                    false => way.right == vertex,
                };
                while let Some(&way) = crossings.from(cell).iter().find(touches) {
                    ways.push(way);
                    cell = way.to;
                    if Some(cell) == until {
                        return (ways, true);
                    }
                }
                (ways, false)
            };
            (fan.from_ahead, fan.is_open) = walk(ahead, behind, side == 0);
            (fan.from_behind, _) = walk(behind, ahead, side == 1);
            let group = |way: &Crossing| self.group_of_cell[way.to.0 as usize];
            for (ways, groups) in
                [&fan.from_ahead, &fan.from_behind].into_iter().zip(&mut self.groups_of_fans[side])
            {
                groups.clear();
                groups.extend(ways.iter().map(group));
            }
        }
    }

    /// Pairs of cells at the vertex.
    fn see_within_fans(&self, none: u32, see: &mut impl FnMut(u32, u32, &Chain)) {
        for groups in self.groups_of_fans.iter().flatten() {
            for (i, &g) in groups.iter().enumerate() {
                for &h in &groups[..i] {
                    if g != none && h != none {
                        see(g, h, self);
                    }
                }
            }
        }
    }

    /// Pairs of a cell along the line that is new, and one at the vertex or beyond it.
    fn see_new(
        &self,
        new_ahead: usize,
        new_behind: usize,
        none: u32,
        see: &mut impl FnMut(u32, u32, &Chain),
    ) {
        let is_open = self.fans.iter().any(|fan| fan.is_open);
        let beyond = |arm: &'_ Arm| if is_open { arm.groups.len() } else { 0 };
        let arms =
            [(&self.ahead, new_ahead, &self.behind, 0), (&self.behind, new_behind, &self.ahead, 1)];
        for (arm, new, other, end) in arms {
            let mut last = none;
            for &g in &arm.groups[new.min(arm.groups.len())..] {
                if g == none || g == last {
                    continue;
                }
                last = g;
                let fans = self.groups_of_fans.iter().flat_map(|fan| &fan[end]);
                for &h in other.groups[..beyond(other)].iter().chain(fans) {
                    if h != none {
                        see(g, h, self);
                    }
                }
            }
        }
    }

    /// The ways along the line between a cell of group `g` and one of group `h`, in the direction
    /// from `g` to `h`, or from `h` to `g` unless `is_forward`.
    pub(super) fn ways(&self, g: u32, h: u32, is_forward: bool) -> Vec<Crossing> {
        let (from, to) = if is_forward { (g, h) } else { (h, g) };
        self.chains()
            .into_iter()
            .filter_map(|chain| shortest(&chain, from, to))
            .min_by_key(Vec::len)
            .expect("two groups seen along one line")
    }

    /// Everything along the line, from behind to ahead: on each side one chain, or two where
    /// something ends it at the vertex. Each is its first group, and the ways with the groups
    /// that they enter.
    fn chains(&self) -> Vec<(u32, Vec<(Crossing, u32)>)> {
        let group = |cell: CellId| self.group_of_cell[cell.0 as usize];
        // Ways walked outward become ways walked inward, and the other way round.
        let inward = |start: CellId, ways: &[Crossing]| {
            let mut cells = vec![start];
            cells.extend(ways.iter().map(|way| way.to));
            let back = |i: usize| {
                let way = ways[i];
                let back = Crossing { to: cells[i], left: way.right, right: way.left, ..way };
                (back, group(cells[i]))
            };
            let first = group(cells[ways.len()]);
            (first, (0..ways.len()).rev().map(back).collect::<Vec<_>>())
        };
        let outward =
            |ways: &[Crossing]| ways.iter().map(|way| (*way, group(way.to))).collect::<Vec<_>>();
        let mut chains = Vec::new();
        for fan in &self.fans {
            match (self.ahead.cell, self.behind.cell) {
                (Some(_), Some(behind)) if fan.is_open => {
                    let (first, mut all) = inward(behind, &self.behind.ways);
                    all.extend(outward(&fan.from_behind));
                    all.extend(outward(&self.ahead.ways));
                    chains.push((first, all));
                }
                (ahead, behind) => {
                    if let Some(ahead) = ahead {
                        let (first, mut all) = inward(ahead, &fan.from_ahead);
                        all.extend(outward(&self.ahead.ways));
                        chains.push((first, all));
                    }
                    if let Some(behind) = behind {
                        let (first, mut all) = inward(behind, &self.behind.ways);
                        all.extend(outward(&fan.from_behind));
                        chains.push((first, all));
                    }
                }
            }
        }
        chains
    }
}

/// The shortest part of a chain that joins two groups, in the direction from `from` to `to`.
fn shortest(
    (first, ways): &(u32, Vec<(Crossing, u32)>),
    from: u32,
    to: u32,
) -> Option<Vec<Crossing>> {
    let groups: Vec<u32> = std::iter::once(*first).chain(ways.iter().map(|(_, g)| *g)).collect();
    let mut best: Option<(usize, usize, bool)> = None;
    let mut last: Option<(usize, u32)> = None;
    for (i, &group) in groups.iter().enumerate() {
        if group != from && group != to {
            continue;
        }
        if let Some((before, other)) = last
            && other != group
            && best.is_none_or(|(a, b, _)| i - before < b - a)
        {
            best = Some((before, i, group == to));
        }
        last = Some((i, group));
    }
    let (start, end, is_forward) = best?;
    let part = ways[start..end].iter().map(|(way, _)| *way);
    if is_forward {
        return Some(part.collect());
    }
    // Walked backwards: the cells before them are entered.
    let cell_before = |i: usize, chain: &[(Crossing, u32)]| chain[i].0.to;
    let reversed = (start..end).rev().map(|i| {
        let way = ways[i].0;
        // The cell that the chain starts in is not named by a way: only the portal counts there.
        let to = if i > 0 { cell_before(i - 1, ways) } else { way.to };
        Crossing { to, left: way.right, right: way.left, ..way }
    });
    Some(reversed.collect())
}
