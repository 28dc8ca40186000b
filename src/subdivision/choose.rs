//! Which plane splits a cell.
//!
//! A candidate is the plane of a face in the cell. Its score rewards faces that lie in it
//! (obscuration: they close off the section) and axial planes, and charges for faces that it cuts
//! (cleaving) and for an unequal number of faces on its sides (Teller 1992, section 8.2.1; the
//! trade between size and balance: Carr 2004, chapter 2). All weights are integers; equal scores
//! go to the plane that was there first, so the choice is a function of the input.

use crate::construct::{PlaneId, PlaneSet, Polygon};
use crate::num::Int;
use rustc_hash::FxHashMap;

/// How to divide space.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Options {
    /// How far the box reaches past the solids, in grid units; at least 1.
    pub margin: Int,
    /// Reward for each face in the plane.
    pub coplanar: i64,
    /// Charge for each face that is cut.
    pub cut: i64,
    /// Charge for each face that one side has more than the other.
    pub imbalance: i64,
    /// Reward for an axial plane.
    pub axial: i64,
    /// The most candidates to score in one cell, at least 1; where there are more, they are taken
    /// at equal steps.
    pub samples: usize,
}

impl Default for Options {
    fn default() -> Options {
        Options { margin: Int::from(64), coplanar: 5, cut: 5, imbalance: 1, axial: 5, samples: 24 }
    }
}

/// The best plane among those of the faces, undirected.
///
/// # Panics
/// If there are no faces.
pub(super) fn plane(planes: &PlaneSet, faces: &[Polygon], options: &Options) -> PlaneId {
    let mut candidates: Vec<PlaneId> = Vec::new();
    let mut counts: FxHashMap<PlaneId, usize> = FxHashMap::default();
    for face in faces {
        let plane = face.support().undirected();
        *counts.entry(plane).or_insert_with(|| {
            candidates.push(plane);
            0
        }) += 1;
    }
    let samples = options.samples.clamp(1, candidates.len());
    let sampled = (0..samples).map(|i| candidates[i * candidates.len() / samples]);
    let mut best: Option<(i64, PlaneId)> = None;
    for plane in sampled {
        let score = score(planes, faces, plane, options);
        if best.is_none_or(|(highest, _)| score > highest) {
            best = Some((score, plane));
        }
    }
    best.expect("there is a candidate").1
}

fn score(planes: &PlaneSet, faces: &[Polygon], plane: PlaneId, options: &Options) -> i64 {
    let (mut coplanar, mut cut, mut balance) = (0, 0, 0i64);
    for face in faces {
        let extent = face.extent(planes, plane);
        match (extent.front, extent.back) {
            (true, true) => cut += 1,
            (true, false) => balance += 1,
            (false, true) => balance -= 1,
            (false, false) => coplanar += 1,
        }
    }
    let axial = if planes.is_axial(plane) { options.axial } else { 0 };
    options.coplanar * coplanar - options.cut * cut - options.imbalance * balance.abs() + axial
}
