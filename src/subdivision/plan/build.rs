//! Dividing a plan's box by lines of its segments until none is left inside.

use super::choose::{Bsp, PlanMethod};
use super::kd::Axial;
use super::{Branch, EdgeLine, PlanDivisionError, PlanLeaf, PlanLines, PlanNode, PlanTree};
use crate::num::Sign;
use crate::predicates::{PlanPoint, PlanPoints};
use crate::report::Progress;
use crate::scene::plan::Plan;

/// What of the segments is inside an open cell, kept as the method needs it to choose lines.
pub(super) trait Contents: Sized {
    /// Where to divide, in the method's terms.
    type Cut;

    /// How many parts of segments are inside.
    fn len(&self) -> usize;

    /// Where to divide the cell, and the line there; `None` for a leaf.
    fn choose(&self, builder: &Builder) -> Option<(Self::Cut, u32)>;

    /// What is to the left and to the right. What lies on the line is in neither: it is on the
    /// boundary from now on.
    fn split(self, cut: Self::Cut, builder: &mut Builder) -> [Self; 2];

    /// The segments that are inside, by their index; some of them more than once.
    fn segments(&self) -> impl Iterator<Item = u32>;
}

/// Where a cell hangs in the tree.
#[derive(Clone, Copy)]
enum Place {
    Root,
    Left(u32),
    Right(u32),
}

/// Divides the box of a plan.
///
/// O(f) a node of f fragments for the split, and what the method says for the choice; the number
/// of fragments is the plan's property (at most quadratic, near linear in architecture).
///
/// # Errors
/// An interruption; segments that the method does not admit.
pub fn divide(
    plan: &Plan,
    method: &PlanMethod,
    progress: &dyn Progress,
) -> Result<PlanTree, PlanDivisionError> {
    let (lines, of_segment, sides) = PlanLines::of(plan);
    let mut builder = Builder { points: plan.points.clone(), lines };
    let leaf = builder.leaf_of_box(plan, sides);
    let grown = match method {
        PlanMethod::Bsp => {
            let inside = Bsp::of_box(&mut builder, plan, &of_segment, &leaf.edges);
            grow(&mut builder, leaf, inside, progress)
        }
        PlanMethod::Kd { threshold } => {
            let (axial, faces) = Axial::new(plan, &of_segment, threshold)?;
            let inside = axial.cell_of_box(plan, faces);
            grow(&mut builder, leaf, inside, progress)
        }
    };
    let Grown { nodes, leaves, root, left_inside } = grown?;
    let Builder { points, lines } = builder;
    let segment_lines = of_segment;
    Ok(PlanTree { points, lines, nodes, leaves, root, segment_lines, left_inside })
}

/// A tree without its points and lines.
struct Grown {
    nodes: Vec<PlanNode>,
    leaves: Vec<PlanLeaf>,
    root: Branch,
    left_inside: Vec<u32>,
}

/// Divides a cell until the method says that all of its parts are leaves.
fn grow<C: Contents>(
    builder: &mut Builder,
    leaf: PlanLeaf,
    contents: C,
    progress: &dyn Progress,
) -> Result<Grown, PlanDivisionError> {
    let (mut nodes, mut leaves, mut left_inside) = (Vec::new(), Vec::new(), Vec::new());
    let mut root = Branch::Leaf(0);
    progress.begin("subdivision", contents.len() as u64);
    let mut stack = vec![(Place::Root, leaf, contents)];
    while let Some((place, leaf, contents)) = stack.pop() {
        if progress.is_interrupted() {
            return Err(PlanDivisionError::Interrupted);
        }
        let before = contents.len();
        let (branch, after) = match contents.choose(builder) {
            None => {
                left_inside.extend(contents.segments());
                leaves.push(leaf);
                (Branch::Leaf(leaves.len() as u32 - 1), 0)
            }
            Some((cut, line)) => {
                let number = nodes.len() as u32;
                let [left, right] = builder.cut_leaf(&leaf, line);
                let [on_left, on_right] = contents.split(cut, builder);
                let after = on_left.len() + on_right.len();
                nodes.push(PlanNode { line, left: Branch::Leaf(0), right: Branch::Leaf(0) });
                stack.push((Place::Right(number), right, on_right));
                stack.push((Place::Left(number), left, on_left));
                (Branch::Node(number), after)
            }
        };
        progress.advance(before.saturating_sub(after) as u64);
        match place {
            Place::Root => root = branch,
            Place::Left(parent) => nodes[parent as usize].left = branch,
            Place::Right(parent) => nodes[parent as usize].right = branch,
        }
    }
    left_inside.sort_unstable();
    left_inside.dedup();
    Ok(Grown { nodes, leaves, root, left_inside })
}

/// The points and lines of a tree that is being built.
pub(super) struct Builder {
    pub(super) points: PlanPoints,
    pub(super) lines: PlanLines,
}

impl Builder {
    /// The whole box.
    fn leaf_of_box(&self, plan: &Plan, sides: [u32; 4]) -> PlanLeaf {
        let edges = [0, 1, 2, 3].map(|i: usize| {
            let [a, b] = self.lines.through(sides[i]);
            let inner = plan.bounds[(i + 2) % 4];
            EdgeLine { line: sides[i], is_left: self.points.turn(a, b, inner) == Sign::Positive }
        });
        PlanLeaf { polygon: plan.bounds.to_vec(), edges: edges.to_vec() }
    }

    /// The parts of a leaf to the left and to the right of a line through its inside.
    fn cut_leaf(&mut self, leaf: &PlanLeaf, line: u32) -> [PlanLeaf; 2] {
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
        sides
    }

    /// The meet of two lines that are not parallel.
    pub(super) fn meet(&mut self, first: u32, second: u32) -> u32 {
        let [a, b] = self.lines.through(first).map(|end| self.points.get(end));
        let [c, d] = self.lines.through(second).map(|end| self.points.get(end));
        let meet = PlanPoint::meet(a, b, c, d).expect("lines that cross are not parallel");
        self.points.insert(meet)
    }
}
