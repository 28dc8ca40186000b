//! Geometric data: points, lines, planes. Data only; every decision about them is a predicate.

mod axial_box;
mod line;
mod plane;
mod plucker;
mod point;
pub mod vector;

pub use axial_box::AxialBox;
pub use line::{BigLine, Line};
pub use plane::{BigPlane, Plane};
pub use point::{BigPoint2, BigPoint3, Point2, Point3, RationalPoint3};
