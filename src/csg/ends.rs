//! Where brushes begin and end along the axes, by rank.
//!
//! The ends are put in order once, and boxes are compared by small integers from then on.

use crate::construct::{Bounds, PlaneId, PlaneSet, Polyhedron};
use crate::geom::{AxialBox, RationalPoint3};
use crate::num::{Int, Rational};
use num_traits::{One, Signed};

/// The axial planes at which brushes begin and end, in order, outermost those of a box around all.
pub(super) struct Ends {
    planes: [Vec<PlaneId>; 3],
}

/// A box by the ranks of its ends, the lower first on each axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Ranks(pub [[u32; 2]; 3]);

/// Brushes end within a step of their boxes, which have about this many steps.
const STEPS: i32 = 32;

impl Ends {
    /// The ends of some boxes within another, and each box by rank.
    pub(super) fn new(
        planes: &mut PlaneSet,
        whole: &AxialBox,
        boxes: &[AxialBox],
    ) -> (Ends, Vec<Ranks>) {
        let mut ranks = vec![Ranks([[0; 2]; 3]); boxes.len()];
        let planes = [0, 1, 2].map(|axis| {
            let all = || boxes.iter().chain([whole]);
            let mut ends: Vec<&Rational> =
                all().flat_map(|around| [&around.low[axis], &around.high[axis]]).collect();
            ends.sort();
            ends.dedup();
            let rank = |end: &Rational| ends.partition_point(|other| *other < end) as u32;
            for (ranks, around) in ranks.iter_mut().zip(boxes) {
                ranks.0[axis] = [rank(&around.low[axis]), rank(&around.high[axis])];
            }
            ends.into_iter().map(|end| planes.axial(axis, end)).collect()
        });
        (Ends { planes }, ranks)
    }

    /// The box of all ends.
    pub(super) fn whole(&self) -> Ranks {
        Ranks(self.planes.each_ref().map(|planes| [0, planes.len() as u32 - 1]))
    }

    /// The plane of a rank, positive towards larger coordinates.
    pub(super) fn plane(&self, axis: usize, rank: u32) -> PlaneId {
        self.planes[axis][rank as usize]
    }

    /// The planes of a box.
    pub(super) fn bounds(&self, ranks: &Ranks) -> Bounds {
        let side = |end: usize| [0, 1, 2].map(|axis| self.plane(axis, ranks.0[axis][end]));
        Bounds::of_planes(side(0).map(PlaneId::flipped), side(1))
    }
}

impl Ranks {
    /// Whether two boxes have no inner point in common.
    pub(super) fn misses(&self, other: &Ranks) -> bool {
        self.0.iter().zip(&other.0).any(|(a, b)| a[1] <= b[0] || b[1] <= a[0])
    }

    /// Whether it holds all of another box.
    pub(super) fn holds(&self, other: &Ranks) -> bool {
        self.0.iter().zip(&other.0).all(|(a, b)| a[0] <= b[0] && b[1] <= a[1])
    }
}

/// Whether a polyhedron is an axial box.
pub(super) fn is_box(planes: &PlaneSet, solid: &Polyhedron) -> bool {
    solid.faces().iter().all(|face| planes.is_axial(face.support()))
}

/// The box around a polyhedron: exact if it is a box itself, else rounded outwards to short
/// numbers.
pub(super) fn around(planes: &PlaneSet, solid: &Polyhedron) -> AxialBox {
    let points = solid.faces().iter().flat_map(|face| face.points());
    let mut corners = points.map(|point| RationalPoint3::coordinates(&point));
    let first = corners.next().expect("a polyhedron has vertices");
    let mut around = AxialBox { low: first.clone(), high: first };
    for corner in corners {
        for (i, c) in corner.into_iter().enumerate() {
            if c < around.low[i] {
                around.low[i] = c;
            } else if c > around.high[i] {
                around.high[i] = c;
            }
        }
    }
    if is_box(planes, solid) {
        return around;
    }
    let lengths = (0..3).map(|i| &around.high[i] - &around.low[i]);
    let step = power_of_two(&(lengths.max().expect("three axes") / Int::from(STEPS)));
    AxialBox {
        low: around.low.map(|c| (c / &step).floor() * &step),
        high: around.high.map(|c| (c / &step).ceil() * &step),
    }
}

/// A power of two within a factor of two of a positive number.
fn power_of_two(of: &Rational) -> Rational {
    debug_assert!(of.is_positive());
    let (up, down) = (of.numer().bits(), of.denom().bits());
    let power = |bits: u64| Int::one() << bits;
    Rational::new(power(up.saturating_sub(down)), power(down.saturating_sub(up)))
}
