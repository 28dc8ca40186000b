//! Products of linear forms that seem to sum to a quadratic one: the first phase of the simplex
//! method, in floats.
//!
//! A quadratic form is given by its bilinear form's values on pairs of six independent vectors. In
//! a cone whose rays these are, the values of the cone's own forms and of their products are not
//! negative, and none of them comes from a difference: however thin the cone, floats hold them to
//! full relative precision.

use crate::num::Int;
use num_traits::ToPrimitive;

/// What is not larger beside values of about one is taken for zero.
const NOTHING: f64 = 1e-9;

/// Pivots before the search is given up; it takes some thirty.
const MOST_PIVOTS: usize = 300;

/// The values of some forms on vectors, and what their products shall sum to.
pub(in crate::stab) struct Pairs {
    /// By form and vector; not negative.
    values: Vec<Vec<f64>>,
    /// The quadratic form's bilinear form on the vectors, by the later and the earlier of two; not
    /// negative.
    goal: Vec<Vec<f64>>,
}

impl Pairs {
    /// The pairs of vectors that are scaled to values of about one.
    pub(in crate::stab) fn new(values: &[Vec<Int>], goal: &[Vec<Int>]) -> Pairs {
        let bits = |k: usize| values.iter().map(|of| of[k].bits()).max().unwrap_or(0);
        let scales: Vec<u64> = (0..goal.len()).map(bits).collect();
        let mut values: Vec<Vec<f64>> = values
            .iter()
            .map(|of| of.iter().zip(&scales).map(|(value, &scale)| scaled(value, scale)).collect())
            .collect();
        for of in &mut values {
            let largest = of.iter().copied().fold(0.0, f64::max);
            of.iter_mut().for_each(|value| *value /= largest);
        }
        let goal = goal.iter().enumerate();
        let goal = goal.map(|(k, of)| {
            of.iter().enumerate().map(|(l, value)| scaled(value, scales[k] + scales[l])).collect()
        });
        Pairs { values, goal: goal.collect() }
    }
}

/// value / 2^scale.
fn scaled(value: &Int, scale: u64) -> f64 {
    let shift = value.bits().saturating_sub(64);
    let exponent = i32::try_from(shift as i64 - scale as i64).unwrap_or(i32::MIN);
    (value >> shift).to_f64().unwrap_or(f64::NAN) * 2.0f64.powi(exponent)
}

/// Which of the `allowed` products of two forms (by their indices) seem to be the basis of a
/// non-negative combination that is the goal; `None` if there seems to be none.
pub(in crate::stab) fn basic_products(pairs: &Pairs, allowed: &[[usize; 2]]) -> Option<Vec<usize>> {
    let Pairs { values, goal } = pairs;
    let six = independent(values)?;
    let mut rows: Vec<Vec<f64>> = Vec::new();
    for (place, &k) in six.iter().enumerate() {
        for &l in &six[..=place] {
            let value =
                |&[i, j]: &[usize; 2]| values[i][k] * values[j][l] + values[i][l] * values[j][k];
            let right = 2.0 * goal[k.max(l)][k.min(l)];
            // Where the goal is zero, so are all allowed products.
            if right > 0.0 {
                let entries = allowed.iter().map(|pair| value(pair) / right);
                rows.push(entries.chain(std::iter::once(1.0)).collect());
            }
        }
    }
    for column in 0..allowed.len() {
        let largest = rows.iter().map(|row| row[column]).fold(0.0, f64::max);
        if largest > 0.0 {
            rows.iter_mut().for_each(|row| row[column] /= largest);
        }
    }
    basis(rows, allowed.len())
}

/// Six vectors that seem to be independent, by the forms' values on them.
fn independent(values: &[Vec<f64>]) -> Option<Vec<usize>> {
    let count = values.first()?.len();
    let mut vectors: Vec<Vec<f64>> =
        (0..count).map(|k| values.iter().map(|of| of[k]).collect()).collect();
    let dot = |x: &[f64], y: &[f64]| -> f64 { x.iter().zip(y).map(|(a, b)| a * b).sum() };
    for vector in &mut vectors {
        let norm = dot(vector, vector).sqrt();
        vector.iter_mut().for_each(|c| *c /= norm);
    }
    let mut chosen = Vec::new();
    for _ in 0..6 {
        let longest = (0..count).max_by(|&k, &l| {
            dot(&vectors[k], &vectors[k]).total_cmp(&dot(&vectors[l], &vectors[l]))
        })?;
        let axis = vectors[longest].clone();
        let square = dot(&axis, &axis);
        if square.is_nan() || square <= NOTHING * NOTHING {
            return None;
        }
        for vector in &mut vectors {
            let along = dot(vector, &axis) / square;
            vector.iter_mut().zip(&axis).for_each(|(c, a)| *c -= along * a);
        }
        chosen.push(longest);
    }
    Some(chosen)
}

/// The basis in which the first phase ends, columns beyond `count` (artificial ones) left out. Rows
/// end with their right sides.
fn basis(mut rows: Vec<Vec<f64>>, count: usize) -> Option<Vec<usize>> {
    let mut basis = vec![count; rows.len()];
    for _ in 0..MOST_PIVOTS {
        let gain = |k: usize| -> f64 {
            rows.iter().zip(&basis).filter(|(_, b)| **b == count).map(|(row, _)| row[k]).sum()
        };
        if gain(count) < NOTHING {
            basis.retain(|&k| k < count);
            return Some(basis);
        }
        let entering = (0..count).map(|k| (k, gain(k))).max_by(|a, b| a.1.total_cmp(&b.1))?;
        if entering.1 < NOTHING {
            return None;
        }
        let column = entering.0;
        let ratio = |r: usize| rows[r][count].max(0.0) / rows[r][column];
        let positive = (0..rows.len()).filter(|&r| rows[r][column] > NOTHING);
        let leaving = positive.min_by(|&r, &s| {
            let (first, second) = (ratio(r), ratio(s));
            // Of equal ratios the larger pivot.
            match (first - second).abs() <= NOTHING * first.max(second) {
                true => rows[s][column].total_cmp(&rows[r][column]),
                false => first.total_cmp(&second),
            }
        })?;
        pivot(&mut rows, leaving, column);
        basis[leaving] = column;
    }
    None
}

fn pivot(rows: &mut [Vec<f64>], row: usize, column: usize) {
    let mut pivot_row = std::mem::take(&mut rows[row]);
    let pivot = pivot_row[column];
    pivot_row.iter_mut().for_each(|entry| *entry /= pivot);
    for line in rows.iter_mut().filter(|line| !line.is_empty()) {
        let factor = line[column];
        if factor != 0.0 {
            line.iter_mut().zip(&pivot_row).for_each(|(entry, above)| *entry -= factor * above);
            line[column] = 0.0;
        }
    }
    rows[row] = pivot_row;
}
