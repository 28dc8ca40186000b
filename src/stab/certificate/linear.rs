//! Linear systems in exact integers: one solution, or one without negative values.
//!
//! Both work on tableaux of integers over a common divisor, which is the last pivot: every entry
//! is then a minor of the system, and the divisions leave no rest (Bareiss 1968; Edmonds 1967).

use crate::num::{Int, Sign};
use num_traits::{One, Signed, Zero};

/// Values of some unknowns, by index in ascending order and not zero, over a positive divisor.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Solution {
    pub(super) values: Vec<(usize, Int)>,
    pub(super) divisor: Int,
}

/// A matrix, its last column the right side, over the last pivot.
struct Tableau {
    rows: Vec<Vec<Int>>,
    divisor: Int,
}

impl Tableau {
    fn new(columns: &[Vec<Int>], right: &[Int]) -> Tableau {
        let entry = |r: usize| {
            columns.iter().chain(std::iter::once(&right.to_vec())).map(|c| c[r].clone()).collect()
        };
        Tableau { rows: (0..right.len()).map(entry).collect(), divisor: Int::one() }
    }

    /// Makes the column a multiple of a unit vector.
    fn pivot(&mut self, row: usize, column: usize) {
        let pivot_row = std::mem::take(&mut self.rows[row]);
        let pivot = &pivot_row[column];
        for (_, line) in self.rows.iter_mut().enumerate().filter(|(r, _)| *r != row) {
            let factor = line[column].clone();
            for (entry, above) in line.iter_mut().zip(&pivot_row) {
                let taken = !factor.is_zero() && !above.is_zero();
                if entry.is_zero() && !taken {
                    continue;
                }
                *entry *= pivot;
                if taken {
                    *entry -= &factor * above;
                }
                if !self.divisor.is_one() {
                    *entry /= &self.divisor;
                }
            }
        }
        self.divisor = pivot.clone();
        self.rows[row] = pivot_row;
    }

    /// The values of the unknowns that stand in the rows.
    fn solution(&self, unknowns: impl Iterator<Item = (usize, usize)>) -> Solution {
        let last = self.rows.first().map_or(0, |row| row.len() - 1);
        let turned = self.divisor.is_negative();
        let oriented = |value: &Int| if turned { -value } else { value.clone() };
        let mut values: Vec<(usize, Int)> = unknowns
            .map(|(row, unknown)| (unknown, oriented(&self.rows[row][last])))
            .filter(|(_, value)| !value.is_zero())
            .collect();
        values.sort_by_key(|(unknown, _)| *unknown);
        Solution { values, divisor: oriented(&self.divisor) }
    }
}

/// A solution of `Σ x_k columns[k] = right`: that with zeros for the columns that depend on columns
/// before them. `None` where there is none.
pub(super) fn solve(columns: &[Vec<Int>], right: &[Int]) -> Option<Solution> {
    let mut tableau = Tableau::new(columns, right);
    let mut pivots: Vec<usize> = Vec::new();
    for column in 0..columns.len() {
        let rest = pivots.len()..right.len();
        let candidates = rest.filter(|&r| !tableau.rows[r][column].is_zero());
        let Some(found) = candidates.min_by_key(|&r| tableau.rows[r][column].bits()) else {
            continue;
        };
        tableau.rows.swap(pivots.len(), found);
        tableau.pivot(pivots.len(), column);
        pivots.push(column);
    }
    let consistent = tableau.rows[pivots.len()..].iter().all(|row| row[columns.len()].is_zero());
    consistent.then(|| tableau.solution(pivots.iter().copied().enumerate()))
}

/// A basic solution of `Σ x_k columns[k] = right` with `x >= 0`, where there is one: the first
/// phase of the simplex method with Bland's rule (1977), which cannot cycle.
pub(super) fn solve_nonnegative(columns: &[Vec<Int>], right: &[Int]) -> Option<Solution> {
    let mut tableau = Tableau::new(columns, right);
    for row in &mut tableau.rows {
        if row[columns.len()].is_negative() {
            row.iter_mut().for_each(|entry| *entry = -&*entry);
        }
    }
    // One artificial unknown a row, which leaves for good. Pivots are positive, so is the divisor.
    let (height, count) = (right.len(), columns.len());
    let mut basis: Vec<usize> = (0..height).map(|r| count + r).collect();
    let gain = |tableau: &Tableau, basis: &[usize], k: usize| -> Sign {
        let artificial = (0..height).filter(|&r| basis[r] >= count);
        Sign::of(&artificial.map(|r| &tableau.rows[r][k]).sum::<Int>())
    };
    while let Some(k) = (0..count).find(|&k| gain(&tableau, &basis, k) == Sign::Positive) {
        let positive = (0..height).filter(|&r| tableau.rows[r][k].is_positive());
        let leaving = positive.min_by(|&r, &s| {
            let (r_row, s_row) = (&tableau.rows[r], &tableau.rows[s]);
            let by_ratio = (&r_row[count] * &s_row[k]).cmp(&(&s_row[count] * &r_row[k]));
            by_ratio.then(basis[r].cmp(&basis[s]))
        })?;
        tableau.pivot(leaving, k);
        basis[leaving] = k;
    }
    if gain(&tableau, &basis, count) == Sign::Positive {
        return None;
    }
    let unknowns = basis.iter().copied().enumerate().filter(|(_, unknown)| *unknown < count);
    Some(tableau.solution(unknowns))
}
