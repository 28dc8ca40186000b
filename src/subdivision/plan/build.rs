//! Dividing a plan's box by lines of its segments until none is left inside.

use super::choose::{Chooser, PlanMethod};
use super::{Branch, EdgeLine, PlanLeaf, PlanLines, PlanNode, PlanTree};
use crate::num::Sign;
use crate::predicates::{PlanPoint, PlanPoints};
use crate::report::Progress;
use crate::scene::plan::Plan;

/// The part of a segment inside an open cell, in its line's direction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Fragment {
    /// The plan's segment, by its index.
    pub(super) segment: u32,
    /// Its line.
    pub(super) line: u32,
    /// Its ends.
    pub(super) ends: [u32; 2],
}

/// A cell being divided.
pub(super) struct Region {
    pub(super) leaf: PlanLeaf,
    /// What of the segments is inside, each list in the order of the segments.
    pub(super) fragments: Vec<Fragment>,
}

/// Where a region hangs in the tree.
#[derive(Clone, Copy)]
enum Place {
    Root,
    Left(u32),
    Right(u32),
}

/// Divides the box of a plan; `None` if interrupted.
///
/// O(f) a node of f fragments for the split, and what the method says for the choice; the number
/// of fragments is the plan's property (at most quadratic, near linear in architecture).
pub fn divide(plan: &Plan, method: &PlanMethod, progress: &dyn Progress) -> Option<PlanTree> {
    let (lines, of_segment, sides) = PlanLines::of(plan);
    let mut builder = Builder { points: plan.points.clone(), lines };
    let mut tree = (Vec::new(), Vec::new(), Branch::Leaf(0), Vec::new());
    let (nodes, leaves, root, left_inside) = &mut tree;
    let region = builder.region_of_box(plan, &of_segment, sides);
    progress.begin("subdivision", region.fragments.len() as u64);
    let chooser = Chooser::new(plan, method);
    let mut stack = vec![(Place::Root, region)];
    while let Some((place, region)) = stack.pop() {
        if progress.is_interrupted() {
            return None;
        }
        let choice = chooser.choose(&builder.points, &builder.lines, &region);
        let branch = match choice {
            None => {
                left_inside.extend(region.fragments.iter().map(|fragment| fragment.segment));
                progress.advance(region.fragments.len() as u64);
                leaves.push(region.leaf);
                Branch::Leaf(leaves.len() as u32 - 1)
            }
            Some(line) => {
                let number = nodes.len() as u32;
                let before = region.fragments.len();
                let (left, right) = builder.split(region, line);
                let after = left.fragments.len() + right.fragments.len();
                progress.advance(before.saturating_sub(after) as u64);
                nodes.push(PlanNode { line, left: Branch::Leaf(0), right: Branch::Leaf(0) });
                stack.push((Place::Right(number), right));
                stack.push((Place::Left(number), left));
                Branch::Node(number)
            }
        };
        match place {
            Place::Root => *root = branch,
            Place::Left(parent) => nodes[parent as usize].left = branch,
            Place::Right(parent) => nodes[parent as usize].right = branch,
        }
    }
    let (nodes, leaves, root, mut left_inside) = tree;
    left_inside.sort_unstable();
    left_inside.dedup();
    let Builder { points, lines } = builder;
    let segment_lines = of_segment;
    Some(PlanTree { points, lines, nodes, leaves, root, segment_lines, left_inside })
}

struct Builder {
    points: PlanPoints,
    lines: PlanLines,
}

impl Builder {
    /// The whole box, with what of the segments is in its inside.
    fn region_of_box(&mut self, plan: &Plan, of_segment: &[u32], sides: [u32; 4]) -> Region {
        let edges = [0, 1, 2, 3].map(|i: usize| {
            let [a, b] = self.lines.through(sides[i]);
            let inner = plan.bounds[(i + 2) % 4];
            EdgeLine { line: sides[i], is_left: self.points.turn(a, b, inner) == Sign::Positive }
        });
        let whole = plan.segments.iter().zip(of_segment).enumerate();
        let mut fragments: Vec<Fragment> = whole
            .map(|(index, (segment, &line))| {
                let [a, b] = self.lines.through(line);
                let [p, q] = segment.ends;
                let ends =
                    if self.points.compare_along([a, b], p, q).is_lt() { [p, q] } else { [q, p] };
                Fragment { segment: index as u32, line, ends }
            })
            .collect();
        for edge in edges {
            let (left, right) = self.cut(fragments, edge.line);
            fragments = if edge.is_left { left } else { right };
        }
        let leaf = PlanLeaf { polygon: plan.bounds.to_vec(), edges: edges.to_vec() };
        Region { leaf, fragments }
    }

    /// The parts of a region to the left and to the right of a line through its inside.
    fn split(&mut self, region: Region, line: u32) -> (Region, Region) {
        let (left, right) = self.cut_leaf(&region.leaf, line);
        let (on_left, on_right) = self.cut(region.fragments, line);
        (Region { leaf: left, fragments: on_left }, Region { leaf: right, fragments: on_right })
    }

    /// What of the fragments lies to the left and to the right of a line. Those on it are in
    /// neither: they are on the boundary from now on.
    fn cut(&mut self, fragments: Vec<Fragment>, line: u32) -> (Vec<Fragment>, Vec<Fragment>) {
        let [a, b] = self.lines.through(line);
        let (mut left, mut right) = (Vec::new(), Vec::new());
        for fragment in fragments {
            if fragment.line == line {
                continue;
            }
            let [p, q] = fragment.ends;
            match (self.points.turn(a, b, p), self.points.turn(a, b, q)) {
                (Sign::Positive, Sign::Positive | Sign::Zero) | (Sign::Zero, Sign::Positive) => {
                    left.push(fragment);
                }
                (Sign::Negative, Sign::Negative | Sign::Zero) | (Sign::Zero, Sign::Negative) => {
                    right.push(fragment);
                }
                // Both ends on the line would make the lines equal.
                (Sign::Zero, Sign::Zero) => unreachable!("two lines through two points"),
                (first, Sign::Positive | Sign::Negative) => {
                    let meet = self.meet(line, fragment.line);
                    let parts = [[p, meet], [meet, q]].map(|ends| Fragment { ends, ..fragment });
                    let [on_left, on_right] =
                        if first == Sign::Positive { parts } else { [parts[1], parts[0]] };
                    left.push(on_left);
                    right.push(on_right);
                }
            }
        }
        (left, right)
    }

    fn cut_leaf(&mut self, leaf: &PlanLeaf, line: u32) -> (PlanLeaf, PlanLeaf) {
        let [a, b] = self.lines.through(line);
        let n = leaf.polygon.len();
        let signs: Vec<Sign> = leaf.polygon.iter().map(|&p| self.points.turn(a, b, p)).collect();
        let empty = || PlanLeaf { polygon: Vec::new(), edges: Vec::new() };
        let mut sides = [empty(), empty()];
        for (side, keep) in [Sign::Positive, Sign::Negative].into_iter().enumerate() {
            let part = &mut sides[side];
            let mut push = |corner: u32, edge: EdgeLine| {
                part.polygon.push(corner);
                part.edges.push(edge);
            };
            let along = EdgeLine { line, is_left: keep == Sign::Positive };
            for i in 0..n {
                let (corner, edge) = (leaf.polygon[i], leaf.edges[i]);
                let next = signs[(i + 1) % n];
                match signs[i] {
                    sign if sign == keep => {
                        push(corner, edge);
                        if next == -keep {
                            push(self.meet(line, edge.line), along);
                        }
                    }
                    // A corner on the line: an end of the edge along it, in one order or the other.
                    Sign::Zero => push(corner, if next == keep { edge } else { along }),
                    Sign::Positive | Sign::Negative => {
                        if next == keep {
                            push(self.meet(line, edge.line), edge);
                        }
                    }
                }
            }
        }
        let [left, right] = sides;
        (left, right)
    }

    fn meet(&mut self, first: u32, second: u32) -> u32 {
        let [a, b] = self.lines.through(first).map(|end| self.points.get(end));
        let [c, d] = self.lines.through(second).map(|end| self.points.get(end));
        let meet = PlanPoint::meet(a, b, c, d).expect("lines that cross are not parallel");
        self.points.insert(meet)
    }
}
