//! Which plane splits a cell that faces enter.
//!
//! A candidate is the plane of a face in the cell. In the round of obscuration the plane whose
//! faces cover most of the cell's section splits, if that is enough; in the round of cleaving the
//! plane of the highest score. Weights are integers and shares rationals; of equals the plane
//! that was there first is taken, so the choice is a function of the input.

use super::{Face, Options};
use crate::construct::{Bounds, PlaneId, PlaneSet, Polyhedron};
use crate::num::{Int, Rational};
use num_traits::Signed;
use rustc_hash::FxHashSet;

/// Where faces lie with respect to a plane.
#[derive(Clone, Copy, Debug, Default)]
struct Tally {
    coplanar: i64,
    cut: i64,
    front: i64,
    back: i64,
}

impl Tally {
    fn of(planes: &PlaneSet, faces: &[Face], plane: PlaneId) -> Tally {
        let mut tally = Tally::default();
        for face in faces {
            let extent = face.polygon.extent(planes, plane);
            match (extent.front, extent.back) {
                (true, true) => tally.cut += 1,
                (true, false) => tally.front += 1,
                (false, true) => tally.back += 1,
                (false, false) => tally.coplanar += 1,
            }
        }
        tally
    }

    fn imbalance(&self) -> i64 {
        (self.front - self.back).abs()
    }
}

/// The plane of the highest score, undirected.
///
/// # Panics
/// If there are no faces.
pub(super) fn by_score(planes: &PlaneSet, faces: &[Face], options: &Options) -> PlaneId {
    let weights = &options.weights;
    let score = |plane: &PlaneId| {
        let tally = Tally::of(planes, faces, *plane);
        let axial = if planes.is_axial(*plane) { weights.axial } else { 0 };
        weights.coplanar * tally.coplanar
            - weights.cut * tally.cut
            - weights.imbalance * tally.imbalance()
            + axial
    };
    first_greatest(candidates(faces, options.samples), score).expect("there is a candidate").0
}

/// The plane whose faces cover most of the cell's section, if that is at least `least`; of equals
/// the one nearest to the median.
pub(super) fn by_obscuration(
    planes: &PlaneSet,
    bounds: &Bounds,
    cell: &Polyhedron,
    faces: &[Face],
    least: &Rational,
    samples: usize,
) -> Option<PlaneId> {
    let merit = |plane: &PlaneId| {
        let share = obscured(planes, bounds, cell, faces, *plane);
        let imbalance = match share < *least {
            // It cannot win, and need not be compared further.
            true => 0,
            false => Tally::of(planes, faces, *plane).imbalance(),
        };
        (share, -imbalance)
    };
    let (plane, (share, _)) = first_greatest(candidates(faces, samples), merit)?;
    (share >= *least).then_some(plane)
}

/// The share of the cell's section that faces in the plane cover; where they overlap, more.
fn obscured(
    planes: &PlaneSet,
    bounds: &Bounds,
    cell: &Polyhedron,
    faces: &[Face],
    plane: PlaneId,
) -> Rational {
    // Areas in one plane are in the ratio of their shadows along any axis that is not in it.
    let normal = &planes.plane(plane).normal;
    let longer = |a: usize, b: usize| if normal[b].abs() > normal[a].abs() { b } else { a };
    let axis = longer(longer(0, 1), 2);
    let coplanar = faces.iter().filter(|face| face.polygon.support().undirected() == plane);
    let covered: Rational = coplanar.map(|face| face.polygon.doubled_shadow(axis).abs()).sum();
    covered / cell.section(planes, bounds, plane).doubled_shadow(axis).abs()
}

/// The planes of the faces, in the order of the faces; at most `samples`, at equal steps.
fn candidates(faces: &[Face], samples: usize) -> impl Iterator<Item = PlaneId> {
    let mut seen = FxHashSet::default();
    let planes = faces.iter().map(|face| face.polygon.support().undirected());
    let distinct: Vec<PlaneId> = planes.filter(|plane| seen.insert(*plane)).collect();
    let samples = samples.clamp(1, distinct.len().max(1)).min(distinct.len());
    (0..samples).map(move |i| distinct[i * distinct.len() / samples])
}

fn first_greatest<T, K: PartialOrd>(
    all: impl Iterator<Item = T>,
    key: impl Fn(&T) -> K,
) -> Option<(T, K)> {
    let mut best: Option<(T, K)> = None;
    for item in all {
        let merit = key(&item);
        if best.as_ref().is_none_or(|(_, greatest)| merit > *greatest) {
            best = Some((item, merit));
        }
    }
    best
}

/// Where a free cell is cut along an axis: the offset of the least greatest aspect of the parts,
/// if one is strictly inside and better than none, else the middle of the longest axis.
pub(super) fn free_cut(
    low: &[Rational; 3],
    high: &[Rational; 3],
    offsets: &[Vec<Rational>; 3],
) -> (usize, Rational) {
    let extent: [Rational; 3] = std::array::from_fn(|i| &high[i] - &low[i]);
    let longest = |a: usize, b: usize| if extent[b] > extent[a] { b } else { a };
    let axis = longest(longest(0, 1), 2);
    let middle = (&low[axis] + &high[axis]) / Int::from(2);
    // The greater aspect of the two parts of the box.
    let aspect_at = |axis: usize, at: &Rational| {
        let part = |length: Rational| {
            let mut extent = extent.clone();
            extent[axis] = length;
            aspect(&extent)
        };
        part(at - &low[axis]).max(part(&high[axis] - at))
    };
    let own = aspect(&extent);
    let mut best: Option<(Rational, usize, &Rational)> = None;
    for (axis, offsets) in offsets.iter().enumerate() {
        for at in offsets.iter().filter(|at| low[axis] < **at && **at < high[axis]) {
            let greatest = aspect_at(axis, at);
            let better = best.as_ref().is_none_or(|(least, _, _)| greatest < *least);
            if better && greatest <= own {
                best = Some((greatest, axis, at));
            }
        }
    }
    best.map_or((axis, middle), |(_, axis, at)| (axis, at.clone()))
}

/// The longest extent in terms of the shortest.
pub(super) fn aspect(extent: &[Rational; 3]) -> Rational {
    let shortest = extent.iter().min().expect("three axes");
    extent.iter().max().expect("three axes") / shortest
}
