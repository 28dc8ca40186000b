//! From exact coordinates to places of a picture.

use super::svg::Place;
use crate::num::Rational;
use crate::predicates::{PlanPoint, PlanPoints};
use num_traits::{Signed, ToPrimitive, Zero};

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
        // A side's share of zero sets no bound; the share of the longer side is one.
        let most = room[0].max(room[1]);
        let scale = (room[0] / shares[0]).min(room[1] / shares[1]).min(most);
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

    /// The place and the direction of a line through two points; `None` if they are one.
    pub fn ray(&self, [from, to]: &[[Rational; 2]; 2]) -> Option<Ray> {
        Some(Ray {
            from: self.place(from),
            direction: direction([0, 1].map(|i| &to[i] - &from[i]))?,
        })
    }

    /// The place of a ray by its direction in the plane; `None` for one without length.
    pub fn ray_along(&self, from: &PlanPoint, along: &[Rational; 2]) -> Option<Ray> {
        Some(Ray { from: self.place_point(from), direction: direction(along.clone())? })
    }

    /// The upper left and the lower right corner of the box.
    pub fn corners(&self) -> [Place; 2] {
        let [x, y] = self.origin;
        [[x, y - self.size[1]], [x + self.size[0], y]]
    }
}

/// A box that is a tenth of its longer side wider on each side.
pub fn widened([low, high]: [[Rational; 2]; 2]) -> [[Rational; 2]; 2] {
    let extents = [0, 1].map(|axis| &high[axis] - &low[axis]);
    let longer = extents[0].clone().max(extents[1].clone());
    let tenth = longer / Rational::from_integer(10.into());
    [low.map(|c| c - &tenth), high.map(|c| c + &tenth)]
}

/// A directed line in a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// A place on it.
    pub from: Place,
    /// Its direction, 1 along the axis where it is longer.
    pub direction: [f64; 2],
}

/// The direction in a picture of a vector of any length.
fn direction(vector: [Rational; 2]) -> Option<[f64; 2]> {
    let longer = vector[0].abs().max(vector[1].abs());
    if longer.is_zero() {
        return None;
    }
    let [x, y] = vector.map(|c| (c / &longer).to_f64().unwrap_or(0.0));
    Some([x, -y])
}

impl Ray {
    /// The place so far along it.
    pub fn at(&self, distance: f64) -> Place {
        [0, 1].map(|axis| self.from[axis] + distance * self.direction[axis])
    }

    /// How far along it meets the line through two places; nowhere near for a parallel one.
    pub fn crosses(&self, [a, b]: [Place; 2]) -> f64 {
        let along = [b[0] - a[0], b[1] - a[1]];
        let to = [a[0] - self.from[0], a[1] - self.from[1]];
        cross(to, along) / cross(self.direction, along)
    }

    /// How far along it enters and leaves a convex polygon, if it passes that.
    pub fn within(&self, outline: &[Place]) -> Option<[f64; 2]> {
        let turns: f64 =
            (0..outline.len()).map(|i| cross(outline[i], outline[(i + 1) % outline.len()])).sum();
        let [mut enter, mut leave] = [f64::NEG_INFINITY, f64::INFINITY];
        for (index, a) in outline.iter().enumerate() {
            let b = outline[(index + 1) % outline.len()];
            let inward = [a[1] - b[1], b[0] - a[0]].map(|c| c * turns.signum());
            let height = inward[0] * (self.from[0] - a[0]) + inward[1] * (self.from[1] - a[1]);
            let slope = inward[0] * self.direction[0] + inward[1] * self.direction[1];
            if slope > 0.0 {
                enter = enter.max(-height / slope);
            } else if slope < 0.0 {
                leave = leave.min(-height / slope);
            } else if height < 0.0 {
                return None;
            }
        }
        (enter.is_finite() && leave.is_finite() && enter < leave).then_some([enter, leave])
    }
}

fn cross(a: Place, b: Place) -> f64 {
    a[0] * b[1] - a[1] * b[0]
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

#[cfg(test)]
mod tests {
    use super::*;

    fn point(x: i64, y: i64) -> [Rational; 2] {
        [x, y].map(|c| Rational::from_integer(c.into()))
    }

    #[test]
    fn boxes_fit_whatever_their_shape() {
        let room = [100.0, 50.0];
        for (high, size) in [
            ([200, 100], [100.0, 50.0]),
            ([10, 10], [50.0, 50.0]),
            ([1000, 0], [100.0, 0.0]),
            ([0, 7], [0.0, 50.0]),
            ([0, 0], [0.0, 0.0]),
        ] {
            let frame = Frame::fit([point(0, 0), point(high[0], high[1])], [10.0, 20.0], room);
            let [low, upper] = frame.corners();
            assert_eq!([upper[0] - low[0], upper[1] - low[1]], size, "{high:?}");
            assert!(low[0] >= 10.0 && low[1] >= 20.0 && upper[0] <= 110.0 && upper[1] <= 70.0);
        }
    }

    #[test]
    fn y_points_up() {
        let frame = Frame::fit([point(0, 0), point(4, 2)], [0.0, 0.0], [40.0, 20.0]);
        assert_eq!(frame.place(&point(1, 2)), [10.0, 0.0]);
        let ray = frame.ray(&[point(0, 0), point(2, 1)]).unwrap();
        assert_eq!((ray.from, ray.direction), ([0.0, 20.0], [1.0, -0.5]));
        assert_eq!(frame.ray(&[point(1, 1), point(1, 1)]), None);
    }

    #[test]
    fn rays_pass_polygons_either_way_around_or_miss_them() {
        let mut square = vec![[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
        for _ in 0..2 {
            let ray = |from, direction| Ray { from, direction }.within(&square);
            assert_eq!(ray([-1.0, 2.0], [1.0, 0.0]), Some([1.0, 5.0]));
            assert_eq!(ray([-1.0, 5.0], [1.0, 0.0]), None);
            assert_eq!(ray([1.0, 1.0], [0.5, 1.0]), Some([-1.0, 3.0]));
            square.reverse();
        }
    }
}
