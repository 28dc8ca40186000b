//! The choice of lines for segments of any direction: a BSP tree.

use super::EdgeLine;
use super::build::{Builder, Contents};
use crate::num::{Rational, Sign};
use crate::scene::plan::Plan;

/// How lines are chosen.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub enum PlanMethod {
    /// For segments of any direction: the line, of a sample, that divides the fewest others and
    /// divides them most evenly.
    #[default]
    Bsp,
    /// For axial segments: the k-D tree of Teller and Séquin 1991, §2.3 (see the module `kd`).
    Kd {
        /// A line that no segment spans a cell along splits it only if the lengths of the segments
        /// on it sum to more than this, in world units.
        threshold: Rational,
    },
}

/// The part of a segment inside an open cell, in its line's direction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Fragment {
    /// The plan's segment, by its index.
    segment: u32,
    /// Its line.
    line: u32,
    /// Its ends.
    ends: [u32; 2],
}

/// What of the segments is inside a cell, in the order of the segments.
pub(super) struct Bsp {
    fragments: Vec<Fragment>,
}

/// How many lines of a cell are tried, and how many of its fragments they are tried on.
const CANDIDATES: usize = 24;
const SAMPLE: usize = 96;

/// What dividing one fragment weighs against putting one more on the heavier side.
const SPLIT_WEIGHT: usize = 6;

impl Bsp {
    /// What of a plan's segments is inside of its box, whose edges are given.
    pub(super) fn of_box(
        builder: &mut Builder,
        plan: &Plan,
        of_segment: &[u32],
        edges: &[EdgeLine],
    ) -> Bsp {
        let whole = plan.segments.iter().zip(of_segment).enumerate();
        let fragments = whole.map(|(index, (segment, &line))| {
            let [p, q] = segment.ends;
            let through = builder.lines.through(line);
            let is_forward = builder.points.compare_along(through, p, q).is_lt();
            let ends = if is_forward { [p, q] } else { [q, p] };
            Fragment { segment: index as u32, line, ends }
        });
        let mut inside = Bsp { fragments: fragments.collect() };
        for edge in edges {
            let [left, right] = inside.split(edge.line, builder);
            inside = if edge.is_left { left } else { right };
        }
        inside
    }
}

impl Contents for Bsp {
    type Cut = u32;

    fn len(&self) -> usize {
        self.fragments.len()
    }

    fn choose(&self, builder: &Builder) -> Option<(u32, u32)> {
        let Builder { points, lines } = builder;
        let cost = |fragment: &&Fragment| {
            let [a, b] = lines.through(fragment.line);
            let [mut left, mut right, mut sampled] = [0usize; 3];
            for other in spread(&self.fragments, SAMPLE) {
                let signs = other.ends.map(|end| points.turn(a, b, end));
                sampled += 1;
                left += usize::from(signs.contains(&Sign::Positive));
                right += usize::from(signs.contains(&Sign::Negative));
            }
            // Those on the line are on neither side, which makes up for some that it divides.
            let split = (left + right).saturating_sub(sampled);
            SPLIT_WEIGHT * split + left.abs_diff(right)
        };
        let best = spread(&self.fragments, CANDIDATES).min_by_key(cost);
        best.map(|fragment| (fragment.line, fragment.line))
    }

    fn split(self, line: u32, builder: &mut Builder) -> [Bsp; 2] {
        let [a, b] = builder.lines.through(line);
        let (mut left, mut right) = (Vec::new(), Vec::new());
        for fragment in self.fragments {
            if fragment.line == line {
                continue;
            }
            let [p, q] = fragment.ends;
            match (builder.points.turn(a, b, p), builder.points.turn(a, b, q)) {
                (Sign::Positive, Sign::Positive | Sign::Zero) | (Sign::Zero, Sign::Positive) => {
                    left.push(fragment);
                }
                (Sign::Negative, Sign::Negative | Sign::Zero) | (Sign::Zero, Sign::Negative) => {
                    right.push(fragment);
                }
                // Both ends on the line would make the lines equal.
                (Sign::Zero, Sign::Zero) => unreachable!("two lines through two points"),
                (first, Sign::Positive | Sign::Negative) => {
                    let meet = builder.meet(line, fragment.line);
                    let parts = [[p, meet], [meet, q]].map(|ends| Fragment { ends, ..fragment });
                    let [on_left, on_right] =
                        if first == Sign::Positive { parts } else { [parts[1], parts[0]] };
                    left.push(on_left);
                    right.push(on_right);
                }
            }
        }
        [left, right].map(|fragments| Bsp { fragments })
    }

    fn segments(&self) -> impl Iterator<Item = u32> {
        self.fragments.iter().map(|fragment| fragment.segment)
    }
}

/// At most `count` of the fragments, evenly spread.
fn spread(fragments: &[Fragment], count: usize) -> impl Iterator<Item = &Fragment> {
    let step = fragments.len().div_ceil(count).max(1);
    fragments.iter().step_by(step)
}
