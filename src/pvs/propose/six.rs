//! Six half-spaces that seem to let no line through, for `stab::six_edges_exclude_lines`.

use crate::predicates::gordan::invert;
use crate::stab::propose::{Half, dot};

/// A product of two unit vectors that may be zero but for rounding.
const ROUNDING: f64 = 1e-9;

/// More half-spaces than this have too many selections of six.
const MOST: usize = 9;

/// Indices of six half-spaces such that the side products of their dual basis seem to be all of
/// one sign, or zero: of all such selections the one with the clearest signs.
pub(crate) fn agreeing_six(halves: &[Half]) -> Option<[usize; 6]> {
    if !(6..=MOST).contains(&halves.len()) {
        return None;
    }
    let selections = (0u32..1 << halves.len()).filter(|selection| selection.count_ones() == 6);
    let mut best = None;
    let mut margin = -ROUNDING;
    for selection in selections {
        let mut members = (0..halves.len()).filter(|i| selection >> i & 1 == 1);
        let six: [usize; 6] = std::array::from_fn(|_| members.next().unwrap_or(0));
        if let Some(found) = agreement(six.map(|i| halves[i]))
            && found > margin
        {
            margin = found;
            best = Some(six);
        }
    }
    best
}

/// How far the side products of the dual basis are from having different signs; negative if they
/// do, `None` if there is no dual basis.
fn agreement(rows: [Half; 6]) -> Option<f64> {
    let duals = dual_basis(rows)?;
    let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
    for (i, x) in duals.iter().enumerate() {
        for y in &duals[..=i] {
            let side: f64 = (0..6).map(|k| x[k] * y[(k + 3) % 6]).sum();
            least = least.min(side);
            most = most.max(side);
        }
        if least < -ROUNDING && most > ROUNDING {
            return None;
        }
    }
    Some(least.max(-most))
}

/// The vectors of length one that five of the six vanish on.
fn dual_basis(rows: [Half; 6]) -> Option<[Half; 6]> {
    let rays = invert(&rows)?;
    Some(rays.map(|ray| {
        let length = dot(&ray, &ray).sqrt();
        ray.map(|c| c / length)
    }))
}
