//! Coordinates in which a sequence's portals are about as wide as they are far apart.
//!
//! A sequence of small portals at great distances has a very thin cone, and floats see little of
//! it. An affine map keeps every sign of `side` (if it keeps orientation), so the search for
//! points of the cone is free to choose one: the axis from the first portal to the last becomes
//! one unit long, and so does the portals' size across it.

use crate::stab::propose::Half;
use glam::{DMat3, DVec3};

/// An affine map `p -> to_frame * (p - origin)` of positive determinant.
#[derive(Clone, Copy, Default)]
pub(crate) struct Frame {
    origin: DVec3,
    to_frame: DMat3,
    to_world: DMat3,
}

/// A point of R^6 in world coordinates: direction and moment about the world's origin.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bivector {
    direction: DVec3,
    moment: DVec3,
}

impl Bivector {
    /// The side of the edge from `a` to `b`.
    pub fn side(&self, a: DVec3, b: DVec3) -> f64 {
        self.direction.dot(a.cross(b)) + self.moment.dot(b - a)
    }
}

impl Frame {
    /// The frame of portals of about `width` from `first` to `last`.
    pub fn new(first: DVec3, last: DVec3, width: f64) -> Frame {
        let along = last - first;
        let length = along.length();
        let (axis, length) =
            if length > width { (along / length, length) } else { (DVec3::Z, width) };
        let (u, v) = axis.any_orthonormal_pair();
        let rotation = DMat3::from_cols(u, v, u.cross(v));
        let size = DVec3::new(width, width, length);
        Frame {
            origin: first,
            to_frame: DMat3::from_diagonal(size.recip()) * rotation.transpose(),
            to_world: rotation * DMat3::from_diagonal(size),
        }
    }

    pub fn point(&self, p: DVec3) -> DVec3 {
        self.to_frame * (p - self.origin)
    }

    pub fn world_point(&self, p: DVec3) -> DVec3 {
        self.to_world * p + self.origin
    }

    pub fn world_direction(&self, d: DVec3) -> DVec3 {
        self.to_world * d
    }

    /// The point of R^6 whose direction and moment about `origin` are given in world coordinates.
    pub fn bivector(&self, direction: DVec3, moment: DVec3, origin: DVec3) -> Half {
        let moment = moment + (origin - self.origin).cross(direction);
        let cofactors = self.to_world.transpose() * self.to_frame.determinant();
        let (d, m) = (self.to_frame * direction, cofactors * moment);
        [d.x, d.y, d.z, m.x, m.y, m.z]
    }

    /// The same point of R^6 in world coordinates: directions map by the linear part, moments
    /// about the frame's origin by its cofactors.
    pub fn world_bivector(&self, x: &Half) -> Bivector {
        let direction = self.to_world * DVec3::new(x[0], x[1], x[2]);
        let cofactors = self.to_frame.transpose() * self.to_world.determinant();
        let moment = cofactors * DVec3::new(x[3], x[4], x[5]);
        Bivector { direction, moment: moment + self.origin.cross(direction) }
    }
}

/// The half-space of the directed edge from `a` to `b`, of norm one.
pub(crate) fn half(a: DVec3, b: DVec3) -> Half {
    let d = b - a;
    let m = a.cross(b);
    let n = (d.length_squared() + m.length_squared()).sqrt().recip();
    [m.x * n, m.y * n, m.z * n, d.x * n, d.y * n, d.z * n]
}
