//! From exact coordinates to places of a picture.

use super::svg::Place;
use crate::num::Rational;
use crate::predicates::{PlanPoint, PlanPoints};
use num_traits::{ToPrimitive, Zero};

/// Where a box of the plane stands in a picture, y upwards.
///
/// A coordinate is moved and scaled exactly and rounded once, so that a plan far from the origin
/// is drawn as sharp as one around it.
#[derive(Clone, Debug)]
pub struct Frame {
    /// The box's corner of least coordinates.
    low: [Rational; 2],
    /// The longer side of the box, in its own units; positive.
    longer: Rational,
    /// The same, in the picture.
    scale: f64,
    /// Where the box's lower left corner is drawn.
    origin: Place,
    /// The size of the box in the picture.
    size: [f64; 2],
}

impl Frame {
    /// Fits the box between two corners into `room`, whose upper left corner is at `origin`.
    pub fn fit([low, high]: [[Rational; 2]; 2], [x, y]: Place, room: [f64; 2]) -> Frame {
        let extents = [0, 1].map(|axis| (&high[axis] - &low[axis]).max(Rational::zero()));
        let mut longer = extents[0].clone().max(extents[1].clone());
        if longer.is_zero() {
            longer = Rational::from_integer(1.into());
        }
        let shares = extents.map(|extent| (extent / &longer).to_f64().unwrap_or(0.0));
        // A side's share of zero sets no bound.
        let scale = (room[0] / shares[0]).min(room[1] / shares[1]);
        let size = shares.map(|share| share * scale);
        let origin = [x + (room[0] - size[0]) / 2.0, y + size[1]];
        Frame { low, longer, scale, origin, size }
    }

    /// The place of a point.
    pub fn place(&self, point: &[Rational; 2]) -> Place {
        let [x, y] = [0, 1].map(|axis| {
            let share = (&point[axis] - &self.low[axis]) / &self.longer;
            share.to_f64().unwrap_or(0.0) * self.scale
        });
        [self.origin[0] + x, self.origin[1] - y]
    }

    /// The place of a point of a plan, in grid units.
    pub fn place_point(&self, point: &PlanPoint) -> Place {
        self.place(&point.coordinates())
    }

    /// The places of all points of a table.
    pub fn place_all(&self, points: &PlanPoints) -> Vec<Place> {
        (0..points.len() as u32).map(|number| self.place_point(points.get(number))).collect()
    }

    /// The upper left and the lower right corner of the box.
    pub fn corners(&self) -> [Place; 2] {
        let [x, y] = self.origin;
        [[x, y - self.size[1]], [x + self.size[0], y]]
    }
}

/// The corners of the box around points; `None` where there is none.
pub fn box_around<'a>(
    points: impl IntoIterator<Item = &'a PlanPoint>,
) -> Option<[[Rational; 2]; 2]> {
    let mut corners: Option<[[Rational; 2]; 2]> = None;
    for point in points {
        let at = point.coordinates();
        let [low, high] = corners.get_or_insert_with(|| [at.clone(), at.clone()]);
        for axis in [0, 1] {
            if at[axis] < low[axis] {
                low[axis] = at[axis].clone();
            }
            if at[axis] > high[axis] {
                high[axis] = at[axis].clone();
            }
        }
    }
    corners
}
