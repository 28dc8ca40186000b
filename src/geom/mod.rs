//! Geometric data: points, lines, planes. Data only; every decision about them is a predicate.

mod line;
mod plane;
mod plucker;
mod point;
pub mod vector;

pub use line::{BigLine, Line};
pub use plane::{BigPlane, Plane};
pub use point::{BigPoint2, BigPoint3, Point2, Point3, RationalPoint3};
