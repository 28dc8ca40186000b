//! Which line divides a cell next.

use super::build::{Fragment, Region};
use super::lines::PlanLines;
use crate::num::Sign;
use crate::predicates::PlanPoints;
use crate::scene::plan::Plan;

/// How lines are chosen.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub enum PlanMethod {
    /// For segments of any direction: the line, of a sample, that divides the fewest others and
    /// divides them most evenly.
    #[default]
    Bsp,
}

/// Chooses lines for the cells of one plan.
pub(super) struct Chooser;

/// How many lines of a cell are tried, and how many of its fragments they are tried on.
const CANDIDATES: usize = 24;
const SAMPLE: usize = 96;

/// What dividing one fragment weighs against putting one more on the heavier side.
const SPLIT_WEIGHT: usize = 6;

impl Chooser {
    pub(super) fn new(_plan: &Plan, method: &PlanMethod) -> Chooser {
        match method {
            PlanMethod::Bsp => Chooser,
        }
    }

    /// The line that divides the region, `None` if nothing is left to divide it.
    pub(super) fn choose(
        &self,
        points: &PlanPoints,
        lines: &PlanLines,
        region: &Region,
    ) -> Option<u32> {
        let cost = |fragment: &&Fragment| {
            let [a, b] = lines.through(fragment.line);
            let [mut left, mut right] = [0usize; 2];
            for other in spread(&region.fragments, SAMPLE) {
                let signs = other.ends.map(|end| points.turn(a, b, end));
                left += usize::from(signs.contains(&Sign::Positive));
                right += usize::from(signs.contains(&Sign::Negative));
            }
            let split = (left + right).saturating_sub(SAMPLE.min(region.fragments.len()));
            SPLIT_WEIGHT * split + left.abs_diff(right)
        };
        let best = spread(&region.fragments, CANDIDATES).min_by_key(cost);
        best.map(|fragment| fragment.line)
    }
}

/// At most `count` of the fragments, evenly spread.
fn spread(fragments: &[Fragment], count: usize) -> impl Iterator<Item = &Fragment> {
    let step = fragments.len().div_ceil(count).max(1);
    fragments.iter().step_by(step)
}
