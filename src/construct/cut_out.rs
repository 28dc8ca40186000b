//! Polyhedra cut out by planes alone, wherever they are.

use super::{Bounds, PlaneId, PlaneSet, Polyhedron, SolidError};
use crate::geom::RationalPoint3;
use crate::num::Int;
use num_integer::Integer;
use num_traits::{One, Signed};

/// A polyhedron and the integer box around it.
#[derive(Clone, Debug)]
pub struct Boxed {
    /// The polyhedron.
    pub solid: Polyhedron,
    /// The least corner of the box.
    pub low: [Int; 3],
    /// The greatest corner of the box.
    pub high: [Int; 3],
}

/// Two boxes around everything bounded: one that is usually large enough, and one that always is.
///
/// With |n| < 2^a and |o| < 2^b a vertex has coordinates x/w with w >= 1 and |x| < 2^(2a+b+3):
/// what reaches past the second box has no end.
#[derive(Clone, Copy, Debug)]
pub struct Limits([Bounds; 2]);

/// Levels seldom reach further, on a grid of whole units.
const USUAL_BITS: u64 = 18;

impl Limits {
    /// The boxes of everything bounded by planes of the set.
    pub fn new(planes: &mut PlaneSet) -> Limits {
        let (normal, offset) = planes.bits();
        let mut cube = |bits: u64| {
            let half = Int::one() << bits;
            Bounds::new(planes, &[0; 3].map(|_| -&half), &[0; 3].map(|_| half.clone()))
        };
        let sure = 2 * normal + offset + 3;
        Limits([cube(USUAL_BITS.min(sure)), cube(sure)])
    }

    /// The polyhedron on the negative side of planes of the set, from the first box that it does
    /// not touch.
    ///
    /// # Errors
    /// It is flat or unbounded.
    pub fn cut_out(&self, planes: &PlaneSet, half_spaces: &[PlaneId]) -> Result<Boxed, SolidError> {
        for bounds in &self.0 {
            let Some(solid) = Polyhedron::of_half_spaces(planes, bounds, half_spaces) else {
                continue;
            };
            let ends = bounds.planes();
            if solid.faces().iter().all(|face| !ends.contains(&face.support())) {
                return Ok(Boxed::new(solid));
            }
            if bounds == &self.0[1] {
                return Err(SolidError::Unbounded);
            }
        }
        Err(SolidError::Flat)
    }
}

impl Boxed {
    fn new(solid: Polyhedron) -> Boxed {
        let points: Vec<RationalPoint3> = solid.faces().iter().flat_map(|f| f.points()).collect();
        let floor = |i: usize, p: &RationalPoint3| p.numerators()[i].div_floor(p.denominator());
        let ceil = |i: usize, p: &RationalPoint3| -(-&p.numerators()[i]).div_floor(p.denominator());
        let all = || points.iter();
        Boxed {
            low: [0, 1, 2].map(|i| all().map(|p| floor(i, p)).min().expect("it has vertices")),
            high: [0, 1, 2].map(|i| all().map(|p| ceil(i, p)).max().expect("it has vertices")),
            solid,
        }
    }

    /// Whether the boxes of two solids have a point in common.
    pub fn may_touch(&self, other: &Boxed) -> bool {
        (0..3).all(|i| self.low[i] <= other.high[i] && other.low[i] <= self.high[i])
    }
}

impl Bounds {
    /// The box of some polyhedra and a margin, or `None` if there are none.
    pub fn around<'a>(
        planes: &mut PlaneSet,
        solids: impl IntoIterator<Item = &'a Boxed> + Clone,
        margin: &Int,
    ) -> Option<Bounds> {
        let margin = margin.abs().max(Int::one());
        let all = || solids.clone().into_iter();
        let low = |i: usize| all().map(|boxed| &boxed.low[i]).min();
        let high = |i: usize| all().map(|boxed| &boxed.high[i]).max();
        let low = [low(0)? - &margin, low(1)? - &margin, low(2)? - &margin];
        let high = [high(0)? + &margin, high(1)? + &margin, high(2)? + &margin];
        Some(Bounds::new(planes, &low, &high))
    }
}
