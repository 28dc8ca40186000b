//! Geometric data: points, polygons. Data only; every decision about them is a predicate.

mod line;
mod point;

pub use line::BigLine;
pub use point::{BigPoint2, BigPoint3, Point2, Point3};
