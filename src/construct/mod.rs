//! Exact constructions: polygons and polyhedra cut from planes.
//!
//! A polygon is its supporting plane and the cyclic list of the planes that cut it; a vertex is
//! the meet of three planes. Nothing derived is ever rounded (Sugihara and Iri, A solid modelling
//! system free from topological inconsistency, 1989), and every decision is the sign of a vertex
//! against a plane.

mod bounds;
mod coplanar;
mod cut_out;
mod planes;
mod polygon;
mod polyhedron;

pub use bounds::Bounds;
pub use coplanar::{PolygonError, hull, merged, minus, polygon_of_points};
pub use cut_out::{Boxed, IntegerBox, Limits};
pub use planes::{PlaneId, PlaneSet};
pub use polygon::{Extent, Polygon, Split};
pub use polyhedron::{Polyhedron, SolidError, mean};
