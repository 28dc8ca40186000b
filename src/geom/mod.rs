//! Geometric data: points, polygons. Data only; every decision about them is a predicate.

mod point;

pub use point::{BigPoint2, BigPoint3, Point2, Point3};
