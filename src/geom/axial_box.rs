//! Boxes with edges along the axes.

use super::RationalPoint3;
use crate::num::Rational;

/// A closed axial box in world units.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AxialBox {
    /// The corner of least coordinates.
    pub low: [Rational; 3],
    /// The corner of greatest coordinates.
    pub high: [Rational; 3],
}

impl AxialBox {
    /// The least box that holds all points; `None` where there are none.
    pub fn around<'a>(points: impl IntoIterator<Item = &'a RationalPoint3>) -> Option<AxialBox> {
        let mut points = points.into_iter().map(RationalPoint3::coordinates);
        let first = points.next()?;
        let mut around = AxialBox { low: first.clone(), high: first };
        points.for_each(|point| around.extend(&point, &point));
        Some(around)
    }

    /// The least box that holds both.
    #[must_use]
    pub fn and(mut self, other: &AxialBox) -> AxialBox {
        self.extend(&other.low, &other.high);
        self
    }

    /// Whether it has volume.
    pub fn has_volume(&self) -> bool {
        self.low.iter().zip(&self.high).all(|(low, high)| low < high)
    }

    fn extend(&mut self, low: &[Rational; 3], high: &[Rational; 3]) {
        for axis in 0..3 {
            if low[axis] < self.low[axis] {
                self.low[axis] = low[axis].clone();
            }
            if high[axis] > self.high[axis] {
                self.high[axis] = high[axis].clone();
            }
        }
    }
}
