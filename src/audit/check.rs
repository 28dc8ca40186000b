//! Scores a candidate PVS against an exact one.
//!
//! A candidate says of every ordered pair of cells whether it is *present*. A **hole** is an open
//! pair that is not present: something visible would not be drawn, a defect. **Waste** is a pair
//! present though it is not open: never a defect. Grazing pairs are the implementer's choice and
//! are counted apart, unless the policy says that touching lines see; undecided pairs of the
//! golden result are counted apart too (semantics, fact 2). Quadratic in the number of cells.

pub mod report;

use crate::report::{Matrix, Verdict};

/// What to ask of a candidate about grazing pairs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Policy {
    /// Grazing pairs are only counted.
    #[default]
    Open,
    /// A missing grazing pair is a hole too.
    Closed,
}

/// An ordered pair of cells, by index.
pub type Pair = [usize; 2];

/// How many pairs of a kind the candidate has and lacks.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// Pairs that the candidate has.
    pub present: u64,
    /// Pairs that it lacks.
    pub missing: u64,
}

/// What a candidate PVS is worth.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Score {
    /// Pairs that must be present and are not, in ascending order.
    pub holes: Vec<Pair>,
    /// Pairs present that are not open (blocked, where grazing was classified), ascending.
    pub waste: Vec<Pair>,
    /// Open pairs.
    pub open: Tally,
    /// Grazing pairs, whatever the policy.
    pub grazing: Tally,
    /// Pairs that the golden result leaves undecided.
    pub undecided: Tally,
    /// All pairs that the candidate has.
    pub present: u64,
    /// Unordered pairs that the candidate has in one direction only: visibility is symmetric, so
    /// each is an error of one kind or the other.
    pub asymmetric: u64,
}

/// Why a candidate cannot be scored.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum CheckError {
    /// The candidate is of another scene.
    #[error("the candidate has {candidate} {what}, the golden result has {golden}")]
    Size {
        /// What is counted: cells, or leafs.
        what: &'static str,
        /// How many the candidate has.
        candidate: usize,
        /// How many the golden result has.
        golden: usize,
    },
    /// A level knows its cells by their leafs only.
    #[error("cell {0} of the golden result has no leaf, so a level says nothing about it")]
    CellWithoutLeaf(usize),
}

/// Which pairs a candidate in the form of a result has: open ones, undecided ones (they count as
/// visible wherever the answer must be conservative), and under [`Policy::Closed`] grazing ones.
pub fn presence(result: &Matrix, policy: Policy) -> Presence {
    let is_present = |&verdict: &Verdict| match verdict {
        Verdict::Open | Verdict::Undecided => true,
        Verdict::Grazing => policy == Policy::Closed,
        Verdict::NotOpen => false,
    };
    let pairs = result.entries().iter().map(is_present).collect();
    Presence { cells: result.size(), pairs, split_pairs: 0 }
}

/// For every ordered pair of cells, whether a candidate has it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Presence {
    cells: usize,
    /// Invariant: `cells` squared entries, row by row.
    pairs: Vec<bool>,
    /// Pairs of cells of which some but not all pairs of leafs are present.
    pub split_pairs: u64,
}

impl Presence {
    /// From one flag a pair, row by row; `None` unless there are `cells` squared of them.
    pub fn from_flags(cells: usize, pairs: Vec<bool>) -> Option<Presence> {
        let complete = cells.checked_mul(cells) == Some(pairs.len());
        complete.then_some(Presence { cells, pairs, split_pairs: 0 })
    }

    /// From a level's leafs: a pair of cells is present if a pair of their leafs is, since a finer
    /// PVS may well leave out others.
    ///
    /// # Errors
    /// A cell without a leaf, and a number of leafs that differs from `leafs`.
    pub fn from_leafs(
        cells: usize,
        leaf_to_cell: &[u32],
        leafs: usize,
        sees: impl Fn(usize, usize) -> bool,
    ) -> Result<Presence, CheckError> {
        if leafs != leaf_to_cell.len() {
            let golden = leaf_to_cell.len();
            return Err(CheckError::Size { what: "leafs", candidate: leafs, golden });
        }
        let mut leafs_of_cell = vec![0u64; cells];
        for &cell in leaf_to_cell {
            leafs_of_cell[cell as usize] += 1;
        }
        if let Some(cell) = leafs_of_cell.iter().position(|&count| count == 0) {
            return Err(CheckError::CellWithoutLeaf(cell));
        }
        let mut seen = vec![0u64; cells * cells];
        for (from, &row) in leaf_to_cell.iter().enumerate() {
            let counts = &mut seen[row as usize * cells..][..cells];
            for (to, &column) in leaf_to_cell.iter().enumerate() {
                counts[column as usize] += u64::from(sees(from, to));
            }
        }
        let all = |pair: usize| leafs_of_cell[pair / cells] * leafs_of_cell[pair % cells];
        let split = |&(pair, &count): &(usize, &u64)| count > 0 && count < all(pair);
        let split_pairs = seen.iter().enumerate().filter(split).count() as u64;
        Ok(Presence { cells, pairs: seen.iter().map(|&count| count > 0).collect(), split_pairs })
    }

    /// The number of cells.
    pub fn cells(&self) -> usize {
        self.cells
    }

    /// Whether the candidate has a pair.
    ///
    /// # Panics
    /// If there is no such pair.
    pub fn has(&self, from: usize, to: usize) -> bool {
        self.pairs[from * self.cells..][..self.cells][to]
    }
}

/// Scores `candidate` against `golden`.
///
/// # Errors
/// If their numbers of cells differ.
pub fn check(golden: &Matrix, candidate: &Presence, policy: Policy) -> Result<Score, CheckError> {
    let cells = golden.size();
    if candidate.cells != cells {
        let candidate = candidate.cells;
        return Err(CheckError::Size { what: "cells", candidate, golden: cells });
    }
    let mut score = Score::default();
    for from in 0..cells {
        for to in 0..cells {
            let present = candidate.has(from, to);
            score.present += u64::from(present);
            if from < to && present != candidate.has(to, from) {
                score.asymmetric += 1;
            }
            let tally = match golden.get(from, to) {
                Verdict::Open => {
                    if !present {
                        score.holes.push([from, to]);
                    }
                    &mut score.open
                }
                Verdict::Grazing => {
                    if !present && policy == Policy::Closed {
                        score.holes.push([from, to]);
                    }
                    &mut score.grazing
                }
                Verdict::Undecided => &mut score.undecided,
                Verdict::NotOpen => {
                    if present {
                        score.waste.push([from, to]);
                    }
                    continue;
                }
            };
            if present {
                tally.present += 1;
            } else {
                tally.missing += 1;
            }
        }
    }
    Ok(score)
}

/// The JSON schema of `stabline-check/1`.
pub fn schema() -> serde_json::Value {
    schemars::schema_for!(report::CheckReport).to_value()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn golden() -> Matrix {
        let mut golden = Matrix::new(3, Verdict::Open);
        golden.set(0, 1, Verdict::Grazing);
        golden.set(1, 0, Verdict::Grazing);
        golden.set(0, 2, Verdict::NotOpen);
        golden.set(1, 2, Verdict::Undecided);
        golden
    }

    #[test]
    fn each_kind_of_difference_is_named() {
        let flags = vec![true, true, true, false, true, false, false, true, true];
        let candidate = Presence::from_flags(3, flags).unwrap();
        let score = check(&golden(), &candidate, Policy::Open).unwrap();
        assert_eq!(score.holes, [[2, 0]]);
        assert_eq!(score.waste, [[0, 2]]);
        assert_eq!(score.open, Tally { present: 4, missing: 1 });
        assert_eq!(score.grazing, Tally { present: 1, missing: 1 });
        assert_eq!(score.undecided, Tally { present: 0, missing: 1 });
        assert_eq!((score.present, score.asymmetric), (6, 3));
        let closed = check(&golden(), &candidate, Policy::Closed).unwrap();
        assert_eq!(closed.holes, [[1, 0], [2, 0]]);
    }

    #[test]
    fn a_result_is_its_own_perfect_candidate_under_either_policy() {
        for policy in [Policy::Open, Policy::Closed] {
            let score = check(&golden(), &presence(&golden(), policy), policy).unwrap();
            assert!(score.holes.is_empty() && score.waste.is_empty());
        }
    }

    #[test]
    fn leafs_are_folded_into_their_cells() {
        let leaf_to_cell = [0, 1, 1];
        let sees = |from: usize, to: usize| from == to || (from, to) == (0, 2);
        let folded = Presence::from_leafs(2, &leaf_to_cell, 3, sees).unwrap();
        assert_eq!(folded.pairs, [true, true, false, true]);
        assert_eq!(folded.split_pairs, 2);
        let error = Presence::from_leafs(2, &leaf_to_cell, 4, sees).unwrap_err();
        assert_eq!(error, CheckError::Size { what: "leafs", candidate: 4, golden: 3 });
        let error = Presence::from_leafs(3, &leaf_to_cell, 3, sees).unwrap_err();
        assert_eq!(error, CheckError::CellWithoutLeaf(2));
    }

    #[test]
    fn another_scene_is_refused() {
        let candidate = Presence::from_flags(2, vec![true; 4]).unwrap();
        let error = check(&golden(), &candidate, Policy::Open).unwrap_err();
        assert_eq!(error, CheckError::Size { what: "cells", candidate: 2, golden: 3 });
    }
}
