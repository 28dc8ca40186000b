//! One verdict for each ordered pair of cells.

use crate::formats::npy::NpyMatrix;

/// What is known of an ordered pair of cells; the number is its code in every file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Verdict {
    /// Not open; blocked, where grazing was classified.
    #[default]
    NotOpen = 0,
    /// Not open, but some touching line joins the cells.
    Grazing = 1,
    /// A sightline joins the cells.
    Open = 2,
    /// A budget ended the work before an answer.
    Undecided = 3,
}

impl Verdict {
    /// Every verdict, each at the index of its code.
    pub const ALL: [Verdict; 4] =
        [Verdict::NotOpen, Verdict::Grazing, Verdict::Open, Verdict::Undecided];

    /// The verdict of a code, 0 to 3.
    pub fn from_code(code: u8) -> Option<Verdict> {
        Verdict::ALL.get(usize::from(code)).copied()
    }
}

/// An n x n matrix of verdicts: row = source cell, column = target cell.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Matrix {
    size: usize,
    /// Invariant: `size` squared entries, row by row.
    entries: Vec<Verdict>,
}

/// How many ordered pairs have each verdict, the pairs of a cell with itself included.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Not open.
    pub not_open: u64,
    /// Grazing.
    pub grazing: u64,
    /// Open.
    pub open: u64,
    /// Undecided.
    pub undecided: u64,
}

impl Matrix {
    /// A matrix of `size` cells with `verdict` throughout.
    ///
    /// # Panics
    /// If `size` squared exceeds the address space.
    pub fn new(size: usize, verdict: Verdict) -> Matrix {
        let pairs = size.checked_mul(size).expect("a matrix larger than the address space");
        Matrix { size, entries: vec![verdict; pairs] }
    }

    /// A matrix of `size` cells from its entries, row by row; `None` unless there are `size`
    /// squared of them.
    pub fn from_entries(size: usize, entries: Vec<Verdict>) -> Option<Matrix> {
        (size.checked_mul(size) == Some(entries.len())).then_some(Matrix { size, entries })
    }

    /// The number of cells.
    pub fn size(&self) -> usize {
        self.size
    }

    /// The verdicts of all pairs, row by row.
    pub fn entries(&self) -> &[Verdict] {
        &self.entries
    }

    /// The verdicts from one cell to each.
    ///
    /// # Panics
    /// If there is no such cell.
    pub fn row(&self, from: usize) -> &[Verdict] {
        &self.entries[from * self.size..][..self.size]
    }

    /// The verdicts from one cell to each, to be changed.
    ///
    /// # Panics
    /// If there is no such cell.
    pub fn row_mut(&mut self, from: usize) -> &mut [Verdict] {
        &mut self.entries[from * self.size..][..self.size]
    }

    /// The verdict of a pair.
    ///
    /// # Panics
    /// If there is no such pair.
    pub fn get(&self, from: usize, to: usize) -> Verdict {
        self.row(from)[to]
    }

    /// Changes the verdict of a pair.
    ///
    /// # Panics
    /// If there is no such pair.
    pub fn set(&mut self, from: usize, to: usize, verdict: Verdict) {
        self.row_mut(from)[to] = verdict;
    }

    /// The matrix as a NumPy array of bytes, the codes of the verdicts.
    pub fn to_npy(&self) -> Vec<u8> {
        let mut bytes = NpyMatrix::header(self.size, self.size);
        bytes.extend(self.entries.iter().map(|&verdict| verdict as u8));
        bytes
    }

    /// How many pairs have each verdict.
    pub fn counts(&self) -> Counts {
        let mut counts = [0; 4];
        for &verdict in &self.entries {
            counts[verdict as usize] += 1;
        }
        let [not_open, grazing, open, undecided] = counts;
        Counts { not_open, grazing, open, undecided }
    }

    /// The unordered pairs whose two directions have different verdicts.
    pub fn asymmetric_pairs(&self) -> u64 {
        let differs = |from: &usize, to: usize| self.get(*from, to) != self.get(to, *from);
        let row = |from: usize| (0..from).filter(|to| differs(&from, *to)).count() as u64;
        (0..self.size).map(row).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_matrix_counts_its_verdicts_and_its_asymmetry() {
        let mut matrix = Matrix::new(3, Verdict::NotOpen);
        matrix.set(0, 0, Verdict::Open);
        matrix.set(0, 2, Verdict::Grazing);
        matrix.set(2, 0, Verdict::Grazing);
        matrix.set(1, 2, Verdict::Undecided);
        let counts = Counts { not_open: 5, grazing: 2, open: 1, undecided: 1 };
        assert_eq!(matrix.counts(), counts);
        assert_eq!(matrix.asymmetric_pairs(), 1);
        assert_eq!(matrix.row(2), [Verdict::Grazing, Verdict::NotOpen, Verdict::NotOpen]);
        let npy = NpyMatrix::read(&matrix.to_npy()).unwrap();
        assert_eq!((npy.rows, npy.columns), (3, 3));
        assert_eq!(npy.entries, [2, 0, 1, 0, 0, 3, 1, 0, 0]);
        assert_eq!(Matrix::from_entries(2, vec![Verdict::Open; 3]), None);
    }

    #[test]
    fn codes_are_the_indices_of_the_verdicts() {
        for code in 0..4u8 {
            assert_eq!(Verdict::from_code(code).map(|verdict| verdict as u8), Some(code));
        }
        assert_eq!(Verdict::from_code(4), None);
    }
}
