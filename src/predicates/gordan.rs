//! Whether directed lines exclude each other: Gordan's alternative for their Plücker vectors.
//!
//! No line (and no point of R^6) is strictly on the positive side of every one of some directed
//! lines if positive multiples of their Plücker vectors sum to zero (Gordan 1873; for stabbing
//! lines Teller 1992, §7.1). Seven vectors are always enough, and a search proposes them; what is
//! decided here is whether a given few of them do have such a sum.
//!
//! Figure: three edges of a slit and the fourth that closes it.
//! ```text
//!      e1 ──────►            λ1 e1 + λ2 e2 + … = 0, all λ > 0:
//!      ◄────── e2            a line would need side > 0 for each,
//!                            but Σ λ side(x, e) = side(x, 0) = 0
//! ```

use crate::geom::{Point3, RationalPoint3};
use crate::num::{Int, Sign};
use num_traits::{One, Signed, Zero};

/// 2^-53: the relative error of one float operation.
const U: f64 = f64::EPSILON / 2.0;

/// Whether some combination of the lines' Plücker vectors with weights `>= 0`, not all zero,
/// vanishes, if the vectors have only one linear dependency; `false` if they have none or several.
///
/// So `true` proves that no line is strictly on the positive side of all, while `false` proves
/// nothing: it asks the caller for another selection of lines.
///
/// Laws:
/// 1. independent of the order of the lines;
/// 2. unchanged by translation and by reversing *all* lines;
/// 3. unchanged by moving the two points of a line along it, in the same direction.
///
/// Contract: exact, degree 9, unperturbed
///
/// Source: Gordan 1873; bounds of the filter after Rump 2010 (residual of an approximate inverse).
pub fn exclude_each_other(lines: &[[Point3; 2]]) -> bool {
    match exclude_each_other_filter(lines) {
        Some(Sign::Positive) => true,
        Some(Sign::Zero | Sign::Negative) | None => {
            let big = |point: &Point3| point.integers().map(Int::from);
            let lines: Vec<_> = lines.iter().map(|line| line.each_ref().map(big)).collect();
            exclude_each_other_exact(&lines)
        }
    }
}

/// [`exclude_each_other`] of lines through rational points. A line's vector counts up to a positive
/// factor, so each is taken times the denominators of its own two points.
pub fn exclude_each_other_rational<'a>(
    lines: impl Iterator<Item = [&'a RationalPoint3; 2]>,
) -> bool {
    let columns: Vec<[Int; 6]> = lines
        .map(|[a, b]| {
            let (p, q) = (a.numerators(), b.numerators());
            let d = |i: usize| &q[i] * a.denominator() - &p[i] * b.denominator();
            let m = |i: usize, j: usize| &p[i] * &q[j] - &p[j] * &q[i];
            [d(0), d(1), d(2), m(1, 2), m(2, 0), m(0, 1)]
        })
        .collect();
    only_dependency_is_one_signed(&columns)
}

/// The filter: `Some(Positive)` where seven lines provably exclude each other with all weights
/// positive, `None` otherwise. The points' coordinates are exact integers below 2^53.
///
/// Let v_k be the Plücker vectors, scaled: moments by a common factor, then each vector so that no
/// component exceeds 1. Directions are differences of integers below 2^53, so exact or in error by
/// u relative, and so are the starts' differences from the origin; a moment's component p1 - p2 is
/// in error by at most 4u(|p1| + |p2|), to first order, and the scaling adds 3u. As the scale of a
/// vector is at least |p1| + |p2|, every component is in error by at most η = 8u.
///
/// Let μ solve V μ = -v_7 approximately (V = v_1 … v_6), λ = (μ, 1) / Σ, and B = V diag(λ_1..6),
/// r = Σ λ_k v_k for the true v_k. Then B^-1 (λ_7 v_7) = -1 + B^-1 r (1: the vector of ones), so
/// if |B^-1 r| < 1 in each component, the true weights -λ_k (B^-1 λ_7 v_7)_k are all positive.
/// With any R and E = I - R B, |B^-1 r|∞ <= |R r|∞ / (1 - |E|∞) if |E|∞ < 1.
/// Evaluated in floats: r_j is off by at most 8u Σ λ_k |v_kj| + η Σ λ_k <= 20u (Σ λ_k <= 1 + 8u);
/// E_ij by at most Σ_l |R_il| λ_j (9u + η), so a row of E by 20u Σ_l |R_il|. Sums of positive
/// terms are off by less than 1 % in all; the factor 1.01 covers them.
fn exclude_each_other_filter(lines: &[[Point3; 2]]) -> Option<Sign> {
    let lines: &[[Point3; 2]; 7] = lines.try_into().ok()?;
    let vectors = scaled_vectors(&lines.map(|line| line.map(|point| point.floats())))?;
    let inverse = invert(vectors.first_chunk()?)?;
    let mut weights = [1.0; 7];
    for (weight, row) in weights.iter_mut().zip(&inverse) {
        *weight = -(0..6).map(|j| row[j] * vectors[6][j]).sum::<f64>();
    }
    if weights.iter().any(|w| w.is_nan() || *w <= 0.0) {
        return None;
    }
    let total: f64 = weights.iter().sum();
    weights.iter_mut().for_each(|w| *w /= total);
    let residual: [f64; 6] =
        std::array::from_fn(|j| (0..7).map(|k| weights[k] * vectors[k][j]).sum::<f64>().abs());
    let (mut off_identity, mut off_zero) = (0.0f64, 0.0f64);
    for i in 0..6 {
        let row: [f64; 6] = std::array::from_fn(|l| inverse[i][l] / weights[i]);
        let size: f64 = row.iter().map(|r| r.abs()).sum();
        let error: f64 = (0..6)
            .map(|j| {
                let product: f64 = (0..6).map(|l| row[l] * (vectors[j][l] * weights[j])).sum();
                (f64::from(u8::from(i == j)) - product).abs()
            })
            .sum();
        off_identity = off_identity.max(1.01 * (error + 20.0 * U * size));
        let reach: f64 = (0..6).map(|l| row[l].abs() * (residual[l] + 20.0 * U)).sum();
        off_zero = off_zero.max(1.01 * reach);
    }
    // Both comparisons fail on NaN.
    (off_identity < 0.5 && off_zero < 0.45).then_some(Sign::Positive)
}

fn difference(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn scaled_vectors(lines: &[[[f64; 3]; 2]; 7]) -> Option<[[f64; 6]; 7]> {
    let origin = lines[0][0];
    let starts = lines.map(|line| difference(line[0], origin));
    let largest = starts.iter().flatten().fold(1.0f64, |m, c| m.max(c.abs()));
    let mut vectors = [[0.0; 6]; 7];
    for (vector, (line, a)) in vectors.iter_mut().zip(lines.iter().zip(&starts)) {
        let d = difference(line[1], line[0]);
        let products = |i: usize, j: usize| (a[i] * d[j], a[j] * d[i]);
        let moments = [products(1, 2), products(2, 0), products(0, 1)];
        let size = moments
            .iter()
            .map(|(p, q)| (p.abs() + q.abs()) / largest)
            .chain(d.iter().map(|c| c.abs()))
            .fold(0.0f64, f64::max);
        if size.is_nan() || size <= 0.0 {
            return None;
        }
        for i in 0..3 {
            vector[i] = d[i] / size;
            vector[3 + i] = (moments[i].0 - moments[i].1) / (largest * size);
        }
    }
    Some(vectors)
}

/// The inverse of the matrix with these columns, approximately: its row `i` has the product 1 with
/// column `i`, and 0 with the others.
pub(crate) fn invert(columns: &[[f64; 6]; 6]) -> Option<[[f64; 6]; 6]> {
    let mut a: [[f64; 6]; 6] = std::array::from_fn(|i| std::array::from_fn(|j| columns[j][i]));
    let mut inverse: [[f64; 6]; 6] =
        std::array::from_fn(|i| std::array::from_fn(|j| f64::from(u8::from(i == j))));
    for step in 0..6 {
        let pivot = (step..6).max_by(|&i, &j| a[i][step].abs().total_cmp(&a[j][step].abs()))?;
        a.swap(step, pivot);
        inverse.swap(step, pivot);
        let scale = 1.0 / a[step][step];
        if !scale.is_finite() {
            return None;
        }
        a[step] = a[step].map(|c| c * scale);
        inverse[step] = inverse[step].map(|c| c * scale);
        for i in 0..6 {
            let factor = a[i][step];
            if i == step || factor == 0.0 {
                continue;
            }
            let (pivot_row, pivot_inverse) = (a[step], inverse[step]);
            for j in 0..6 {
                a[i][j] -= factor * pivot_row[j];
                inverse[i][j] -= factor * pivot_inverse[j];
            }
        }
    }
    Some(inverse)
}

/// The exact stage: fraction-free elimination (Bareiss 1968) of the 6 x m matrix.
pub fn exclude_each_other_exact(lines: &[[[Int; 3]; 2]]) -> bool {
    let Some(origin) = lines.first().map(|line| &line[0]) else { return false };
    let columns: Vec<[Int; 6]> = lines
        .iter()
        .map(|[a, b]| {
            let d = sub(b, a);
            let a = sub(a, origin);
            let m = |i: usize, j: usize| &a[i] * &d[j] - &a[j] * &d[i];
            let moment = [m(1, 2), m(2, 0), m(0, 1)];
            let ([dx, dy, dz], [mx, my, mz]) = (d, moment);
            [dx, dy, dz, mx, my, mz]
        })
        .collect();
    only_dependency_is_one_signed(&columns)
}

fn sub(a: &[Int; 3], b: &[Int; 3]) -> [Int; 3] {
    [0, 1, 2].map(|i| &a[i] - &b[i])
}

/// Gauss-Jordan without fractions: after each step every pivot equals the last, `pivot`.
fn only_dependency_is_one_signed(columns: &[[Int; 6]]) -> bool {
    let mut rows: Vec<Vec<Int>> =
        (0..6).map(|i| columns.iter().map(|column| column[i].clone()).collect()).collect();
    let mut rank = 0;
    let mut free = None;
    let mut pivot = Int::one();
    for column in 0..columns.len() {
        let Some(found) = (rank..6).find(|&r| !rows[r][column].is_zero()) else {
            if free.replace(column).is_some() {
                return false;
            }
            continue;
        };
        rows.swap(rank, found);
        let pivot_row = rows[rank].clone();
        for (r, row) in rows.iter_mut().enumerate() {
            if r != rank {
                let factor = row[column].clone();
                for (entry, above) in row.iter_mut().zip(&pivot_row) {
                    *entry = (&*entry * &pivot_row[column] - &factor * above) / &pivot;
                }
            }
        }
        pivot = pivot_row[column].clone();
        rank += 1;
    }
    // The dependency gives `free` the weight `pivot`, and each pivot column minus its row's entry.
    free.is_some_and(|free| {
        rows[..rank].iter().all(|row| {
            let entry = &row[free];
            entry.is_zero() || entry.is_negative() == pivot.is_positive()
        })
    })
}
