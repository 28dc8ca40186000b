//! Gordan.
use super::arena::Arena;
use crate::num::Int;
use num_traits::{Signed, Zero};

impl Arena {
    /// Whether a positive combination of the edges' Plücker vectors vanishes.
    pub fn excluded(&self, edges: &[[u32; 2]]) -> bool {
        let origin = self.grid_point(edges[0][0]);
        let rows: Vec<[Int; 6]> = edges
            .iter()
            .map(|&[u, v]| {
                let a = sub(&self.grid_point(u), &origin);
                let b = sub(&self.grid_point(v), &origin);
                let d = sub(&b, &a);
                let m = [
                    &a[1] * &b[2] - &a[2] * &b[1],
                    &a[2] * &b[0] - &a[0] * &b[2],
                    &a[0] * &b[1] - &a[1] * &b[0],
                ];
                let [x, y, z] = d;
                let [p, q, r] = m;
                [x, y, z, p, q, r]
            })
            .collect();
        null_positive(rows)
    }
}
fn sub(a: &[Int; 3], b: &[Int; 3]) -> [Int; 3] {
    [0, 1, 2].map(|i| &a[i] - &b[i])
}

fn null_positive(rows: Vec<[Int; 6]>) -> bool {
    let m = rows.len();
    // matrix 6 x m, unknown λ (m)
    let mut a: Vec<Vec<Int>> =
        (0..6).map(|c| rows.iter().map(|r| r[c].clone()).collect()).collect();
    let mut pivots = vec![];
    let mut row = 0;
    let mut free = None;
    let mut prev = Int::from(1);
    for col in 0..m {
        let Some(p) = (row..6).find(|&r| !a[r][col].is_zero()) else {
            if free.is_some() {
                return false;
            }
            free = Some(col);
            continue;
        };
        a.swap(row, p);
        for r in 0..6 {
            if r != row {
                for c in 0..m {
                    if c != col {
                        a[r][c] = (&a[r][c] * &a[row][col] - &a[r][col] * &a[row][c]) / &prev;
                    }
                }
                a[r][col] = Int::zero();
            }
        }
        // after Bareiss-Jordan: earlier pivots equal the current pivot
        prev = a[row][col].clone();
        for (r, &c) in pivots.iter().enumerate() {
            let c: usize = c;
            a[r][c] = prev.clone();
        }
        pivots.push(col);
        row += 1;
    }
    let Some(f) = free else { return false };
    // λ_f = prev*s, λ_pivot = -a[r][f]
    let sign = prev.is_positive();
    let ok = pivots.iter().enumerate().all(|(r, _)| {
        let v = &a[r][f];
        v.is_zero() || (v.is_negative() == sign)
    });
    ok
}
