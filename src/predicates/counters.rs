//! Which stage answered: counts for tuning, compiled in by the feature `counters` only.
//!
//! Without the feature counting is an empty function and costs nothing. With it, each answer is one
//! relaxed atomic addition, correct from any number of threads.

#[cfg(feature = "counters")]
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

/// What decided a predicate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// Floats, within a proved error bound.
    Filter,
    /// Integers of a fixed width.
    Fixed,
    /// Unbounded integers.
    Big,
}

/// The predicates that are counted; their order is that of [`RANGES`](super::RANGES).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "each is named after its predicate")]
pub enum Predicate {
    Orient2d,
    Orient3d,
    SideOfPlane,
    SideOfLines,
    SideOfMeets,
    VertexSideOfPlane,
    CompareAlongLine,
    CompareCrossings,
    TransversalCount,
    SideOfTransversals,
    SidesOfEach,
}

/// How often each stage (filter, fixed, big) of each predicate answered.
pub type Counts = [[u64; 3]; 11];

#[cfg(feature = "counters")]
static COUNTS: [[AtomicU64; 3]; 11] = [const { [const { AtomicU64::new(0) }; 3] }; 11];

/// Counts one answer.
#[inline(always)]
pub(super) fn record(predicate: Predicate, stage: Stage) {
    #[cfg(feature = "counters")]
    COUNTS[predicate as usize][stage as usize].fetch_add(1, Relaxed);
    #[cfg(not(feature = "counters"))]
    let _ = (predicate, stage);
}

/// The counts since the program began, or `None` without the feature `counters`.
pub fn counts() -> Option<Counts> {
    #[cfg(feature = "counters")]
    return Some(COUNTS.each_ref().map(|row| row.each_ref().map(|count| count.load(Relaxed))));
    #[cfg(not(feature = "counters"))]
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn answers_are_counted_where_asked_for() {
        let before = counts();
        record(Predicate::CompareCrossings, Stage::Big);
        assert_eq!(before.is_some(), cfg!(feature = "counters"));
        if let (Some(before), Some(after)) = (before, counts()) {
            let (row, column) = (Predicate::CompareCrossings as usize, Stage::Big as usize);
            assert!(after[row][column] > before[row][column]);
        }
    }
}
