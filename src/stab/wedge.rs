//! Cramer's rule in six dimensions: the vector that is orthogonal to five given ones.
//!
//! The exterior product of `k` vectors of Z^6 has one coordinate for each `k`-subset `S` of the
//! six axes: the determinant of the vectors' coordinates in `S`. It vanishes iff the vectors are
//! linearly dependent, and one more vector extends it by Laplace's expansion along the new row, so
//! that choosing independent vectors greedily and solving for their common zero are one
//! computation. No division takes place; with entries of `b` bits the result has at most
//! `5b + log2(5!)` bits, whatever the vectors are.

use super::ring::Ring;

/// The subsets of `{0, …, 5}` as bit patterns, by size and in ascending order.
const SUBSETS: [[u8; 20]; 6] = subsets();
/// Where a subset stands in the list of its size.
const POSITION: [u8; 64] = positions();

const fn subsets() -> [[u8; 20]; 6] {
    let mut table = [[0; 20]; 6];
    let mut filled = [0; 7];
    let mut subset = 0u8;
    while subset < 63 {
        let size = subset.count_ones() as usize;
        table[size][filled[size]] = subset;
        filled[size] += 1;
        subset += 1;
    }
    table
}

const fn positions() -> [u8; 64] {
    let mut table = [0; 64];
    let mut filled = [0; 7];
    let mut subset = 0usize;
    while subset < 64 {
        let size = subset.count_ones() as usize;
        table[subset] = filled[size];
        filled[size] += 1;
        subset += 1;
    }
    table
}

/// How many subsets of six axes have a given size.
const COUNT: [usize; 6] = [1, 6, 15, 20, 15, 6];

/// The exterior product of up to five vectors.
#[derive(Clone, Debug)]
pub(super) struct Wedge<R> {
    grade: usize,
    /// By position in `SUBSETS[grade]`; zero beyond `COUNT[grade]`.
    coordinates: [R; 20],
}

impl<R: Ring> Wedge<R> {
    /// The empty product, 1.
    pub(super) fn empty() -> Wedge<R> {
        let coordinates = std::array::from_fn(|i| if i == 0 { R::one() } else { R::zero() });
        Wedge { grade: 0, coordinates }
    }

    /// How many vectors were multiplied.
    pub(super) fn grade(&self) -> usize {
        self.grade
    }

    /// The product with one more vector, or `None` where that vector depends on the others.
    pub(super) fn extended(&self, row: &[R::Narrow; 6]) -> Option<Wedge<R>> {
        let grade = self.grade + 1;
        let mut coordinates = std::array::from_fn(|_| R::zero());
        for (coordinate, &subset) in coordinates.iter_mut().zip(&SUBSETS[grade][..COUNT[grade]]) {
            for (axis, entry) in row.iter().enumerate().filter(|(axis, _)| subset >> axis & 1 == 1)
            {
                if R::narrow_is_zero(entry) {
                    continue;
                }
                let rest = usize::from(subset & !(1 << axis));
                let minor = &self.coordinates[usize::from(POSITION[rest])];
                // The expansion's sign: one exchange for each later axis of the subset.
                if (subset >> (axis + 1)).count_ones() % 2 == 0 {
                    coordinate.add_product(minor, entry);
                } else {
                    coordinate.subtract_product(minor, entry);
                }
            }
        }
        coordinates.iter().any(|c| !c.is_zero()).then_some(Wedge { grade, coordinates })
    }

    /// The vector `r` with `a·r = det(v1, …, v5, a)` for every `a`: orthogonal to all five.
    pub(super) fn orthogonal(&self) -> [R; 6] {
        assert_eq!(self.grade, 5, "five vectors leave one direction");
        std::array::from_fn(|axis| {
            let minor = &self.coordinates[usize::from(POSITION[63 & !(1 << axis)])];
            if axis % 2 == 1 { minor.clone() } else { minor.negated() }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::num::Int;

    #[test]
    fn the_sixth_vector_is_orthogonal_to_the_five() {
        let rows: Vec<[Int; 6]> = (0i64..5)
            .map(|i| {
                std::array::from_fn(|j| Int::from((i * 7 + j as i64 * 5 + 3).pow(3) % 23 - 11))
            })
            .collect();
        let product = rows.iter().try_fold(Wedge::<Int>::empty(), |w, row| w.extended(row));
        let vector = product.unwrap().orthogonal();
        assert!(vector.iter().any(|c| *c != Int::ZERO));
        for row in &rows {
            assert_eq!(row.iter().zip(&vector).map(|(a, b)| a * b).sum::<Int>(), Int::ZERO);
        }
    }

    #[test]
    fn a_dependent_vector_is_refused() {
        let row = |v: [i64; 6]| v.map(Int::from);
        let two = Wedge::<Int>::empty().extended(&row([1, 2, 0, 0, 5, 0])).unwrap();
        let two = two.extended(&row([0, 1, 0, 0, 0, 1])).unwrap();
        assert!(two.extended(&row([2, 3, 0, 0, 10, -1])).is_none());
        assert_eq!(two.grade(), 2);
    }

    #[test]
    fn the_determinant_has_the_right_sign() {
        let unit = |i: usize| std::array::from_fn(|j| Int::from(i64::from(i == j)));
        let five = (0..5).try_fold(Wedge::<Int>::empty(), |w, i| w.extended(&unit(i))).unwrap();
        assert_eq!(five.orthogonal()[5], Int::from(1));
    }
}
