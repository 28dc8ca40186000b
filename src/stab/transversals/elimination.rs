//! The null space of a small integer matrix, by elimination without fractions.
//!
//! Bareiss (1968): dividing each step's products by the pivot before keeps every entry a minor of
//! the matrix, so the division is exact and the entries stay as short as they can be.

use crate::num::Int;
use num_integer::Integer;
use num_traits::{One, Zero};

/// A vector of R^6.
pub(super) type Row = [Int; 6];

/// The rows that are independent of the ones before them, and a basis of the vectors that are
/// orthogonal to all rows; each basis vector is primitive.
pub(super) fn null_space(rows: &[Row]) -> (Vec<usize>, Vec<Row>) {
    let mut matrix: Vec<(usize, Row)> = rows.iter().cloned().enumerate().collect();
    let mut pivots: Vec<usize> = Vec::new();
    let mut last = Int::one();
    for step in 0..matrix.len() {
        // The first row that is not zero yet, and its first entry that is not zero: with this
        // order the rows kept are those independent of the rows before them.
        let found = matrix[step..].iter().enumerate().find_map(|(i, (_, row))| {
            row.iter().position(|c| !c.is_zero()).map(|column| (step + i, column))
        });
        let Some((row, column)) = found else { break };
        // Rotating instead of swapping keeps the order of the rows below.
        matrix[step..=row].rotate_right(1);
        let pivot_row = matrix[step].1.clone();
        let pivot = pivot_row[column].clone();
        for (i, (_, other)) in matrix.iter_mut().enumerate() {
            if i == step {
                continue;
            }
            let factor = other[column].clone();
            for (entry, pivot_entry) in other.iter_mut().zip(&pivot_row) {
                *entry = (&*entry * &pivot - pivot_entry * &factor) / &last;
            }
        }
        // Rows above were reduced by an earlier pivot: all pivots are now this one.
        pivots.push(column);
        last = pivot;
    }
    let independent = matrix[..pivots.len()].iter().map(|(index, _)| *index).collect();
    let free = (0..6).filter(|column| !pivots.contains(column));
    let basis = free.map(|column| {
        let mut vector = [(); 6].map(|()| Int::zero());
        vector[column] = last.clone();
        for ((_, row), &pivot) in matrix.iter().zip(&pivots) {
            vector[pivot] = -&row[column];
        }
        primitive(vector)
    });
    (independent, basis.collect())
}

fn primitive(vector: Row) -> Row {
    let divisor = vector.iter().fold(Int::zero(), |g, c| g.gcd(c));
    if divisor.is_zero() { vector } else { vector.map(|c| c / &divisor) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn null_vectors_are_orthogonal_to_every_row() {
        let matrices: [&[[i64; 6]]; 4] = [
            &[[1, 2, 3, 4, 5, 6], [0, 0, 1, 1, 0, 7], [2, 4, 6, 8, 10, 12], [5, 0, 0, 0, 1, 0]],
            &[[0, 0, 0, 0, 0, 3], [0, 0, 0, 0, 0, 5]],
            &[[3, 1, 4, 1, 5, 9], [2, 6, 5, 3, 5, 8], [9, 7, 9, 3, 2, 3], [8, 4, 6, 2, 6, 4]],
            &[[7, -3, 0, 0, 2, 0], [0, 0, 0, 0, 0, 0], [-14, 6, 0, 0, -4, 0], [0, 1, 0, 0, 1, 0]],
        ];
        let expected: [&[usize]; 4] = [&[0, 1, 3], &[0], &[0, 1, 2, 3], &[0, 3]];
        for (matrix, expected) in matrices.into_iter().zip(expected) {
            let rows: Vec<Row> = matrix.iter().map(|row| row.map(Int::from)).collect();
            let (independent, basis) = null_space(&rows);
            assert_eq!(independent, expected);
            assert_eq!(basis.len(), 6 - expected.len());
            for vector in &basis {
                for row in &rows {
                    let product: Int = row.iter().zip(vector).map(|(a, b)| a * b).sum();
                    assert!(product.is_zero());
                }
            }
        }
    }
}
