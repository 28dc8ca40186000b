//! Where portals are, roughly: centres and radii, and which planes might have one behind them.

use crate::num::Sign;
use crate::predicates::filtered::{Approx3, FilteredPlane};
use glam::DVec3;

/// A portal's centre (the mean of its vertices) and the distance of the farthest vertex from it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Outline {
    pub center: DVec3,
    pub radius: f64,
}

impl Outline {
    pub fn of<'a>(vertices: impl Iterator<Item = &'a Approx3> + Clone) -> Outline {
        let points = vertices.map(|vertex| DVec3::from(vertex.floats()));
        let count = points.clone().count() as f64;
        let center = points.clone().sum::<DVec3>() / count;
        Outline { center, radius: points.map(|p| p.distance(center)).fold(0.0, f64::max) }
    }
}

/// Some planes, arranged so that a point is compared with all of them at once.
#[derive(Default)]
pub(crate) struct PlaneHints {
    normals: [Vec<f64>; 3],
    offsets: Vec<f64>,
}

/// How many planes are compared together.
const LANES: usize = 8;

impl PlaneHints {
    pub fn clear(&mut self) {
        self.normals.iter_mut().for_each(Vec::clear);
        self.offsets.clear();
    }

    pub fn push(&mut self, plane: &FilteredPlane) {
        for (column, coordinate) in self.normals.iter_mut().zip(plane.normal()) {
            column.push(coordinate);
        }
        self.offsets.push(plane.offset());
    }

    /// Whether `confirm` holds for one of the planes that do not seem to have `point` in front.
    ///
    /// With a portal's centre for `point`, a plane that has it in front has some vertex in front:
    /// skipping the plane keeps a portal, and only to drop one takes proof.
    #[inline]
    pub fn any_behind(&self, point: DVec3, confirm: impl Fn(usize) -> bool) -> bool {
        let count = self.offsets.len();
        let [x, y, z] = &self.normals;
        let (x, y, z, offsets) = (&x[..count], &y[..count], &z[..count], &self.offsets[..count]);
        let height = |i: usize| x[i] * point.x + y[i] * point.y + z[i] * point.z - offsets[i];
        let mut start = 0;
        while start + LANES <= count {
            let mut heights = [0.0; LANES];
            for (lane, value) in heights.iter_mut().enumerate() {
                *value = height(start + lane);
            }
            if heights.iter().any(|&h| h <= 0.0)
                && (0..LANES).any(|lane| heights[lane] <= 0.0 && confirm(start + lane))
            {
                return true;
            }
            start += LANES;
        }
        (start..count).any(|i| height(i) <= 0.0 && confirm(i))
    }
}

/// Proposes the vertex of `polygon` beyond which there is none, turning about the edge from `u` to
/// `v`: its index. `None` if all are on the edge's own line, or if the plane there seems to have
/// some of `own`, the edge's polygon, on the same side.
///
/// `sense` is positive to turn counter-clockwise about the edge, else negative.
pub(crate) fn supporting_vertex<'a>(
    [u, v]: [&Approx3; 2],
    polygon: impl Iterator<Item = &'a Approx3>,
    mut own: impl Iterator<Item = &'a Approx3>,
    sense: Sign,
) -> Option<usize> {
    let origin = DVec3::from(u.floats());
    let along = DVec3::from(v.floats()) - origin;
    let along = if sense == Sign::Positive { along } else { -along };
    let mut best = None;
    let mut normal = DVec3::ZERO;
    for (index, vertex) in polygon.enumerate() {
        let towards = DVec3::from(vertex.floats()) - origin;
        // The first vertex off the edge's own line, and then each that is beyond the best.
        if best.is_none() || normal.dot(towards) > 0.0 {
            let turned = along.cross(towards);
            if turned != DVec3::ZERO {
                best = Some(index);
                normal = turned;
            }
        }
    }
    let seems_beyond = |vertex: &Approx3| {
        let towards = DVec3::from(vertex.floats()) - origin;
        let height = normal.dot(towards);
        height >= 0.0
            || height * height <= ROUNDING2 * normal.length_squared() * towards.length_squared()
    };
    best.filter(|_| own.all(seems_beyond))
}

/// The square of a sine that may be zero but for rounding.
const ROUNDING2: f64 = 1e-24;
