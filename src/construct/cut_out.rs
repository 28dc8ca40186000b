//! Polyhedra cut out by planes alone, wherever they are.

use super::{Bounds, PlaneId, PlaneSet, Polyhedron, SolidError};
use crate::geom::{AxialBox, RationalPoint3};
use crate::num::{Int, Rational};
use num_integer::Integer;
use num_traits::{One, Signed};

/// A polyhedron and the box around it.
#[derive(Clone, Debug)]
pub struct Boxed {
    /// The polyhedron.
    pub solid: Polyhedron,
    /// The box around it.
    pub around: IntegerBox,
}

/// A closed axial box with integer corners.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct IntegerBox {
    /// The least corner.
    pub low: [Int; 3],
    /// The greatest corner.
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
            let half = Rational::from(Int::one() << bits);
            let (low, high) = ([0; 3].map(|_| -&half), [0; 3].map(|_| half.clone()));
            Bounds::new(planes, &AxialBox { low, high })
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
        Boxed { around: IntegerBox::around(&points).expect("it has vertices"), solid }
    }
}

impl IntegerBox {
    /// The least integer box that holds all points; `None` where there are none.
    pub fn around(points: &[RationalPoint3]) -> Option<IntegerBox> {
        let floor = |i: usize, p: &RationalPoint3| p.numerators()[i].div_floor(p.denominator());
        let ceil = |i: usize, p: &RationalPoint3| -(-&p.numerators()[i]).div_floor(p.denominator());
        let low = |i: usize| points.iter().map(|p| floor(i, p)).min();
        let high = |i: usize| points.iter().map(|p| ceil(i, p)).max();
        let (low, high) = ([low(0)?, low(1)?, low(2)?], [high(0)?, high(1)?, high(2)?]);
        Some(IntegerBox { low, high })
    }

    /// Whether two boxes have a point in common.
    pub fn touches(&self, other: &IntegerBox) -> bool {
        (0..3).all(|i| self.low[i] <= other.high[i] && other.low[i] <= self.high[i])
    }

    /// Whether the box lies within another.
    pub fn is_in(&self, other: &AxialBox) -> bool {
        let ends = |i: usize| (self.low[i].clone().into(), self.high[i].clone().into());
        (0..3).all(|i| {
            let (low, high): (Rational, Rational) = ends(i);
            other.low[i] <= low && high <= other.high[i]
        })
    }

    /// The box of some boxes and a margin of at least 1, or `None` if there are none.
    pub fn of_all<'a>(
        boxes: impl IntoIterator<Item = &'a IntegerBox> + Clone,
        margin: &Int,
    ) -> Option<AxialBox> {
        let margin = margin.abs().max(Int::one());
        let all = || boxes.clone().into_iter();
        let low = |i: usize| Some(Rational::from(all().map(|b| &b.low[i]).min()? - &margin));
        let high = |i: usize| Some(Rational::from(all().map(|b| &b.high[i]).max()? + &margin));
        let (low, high) = ([low(0)?, low(1)?, low(2)?], [high(0)?, high(1)?, high(2)?]);
        Some(AxialBox { low, high })
    }
}
