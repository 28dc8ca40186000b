//! Every decision about geometry: exact signs, each by the cheapest stage that can prove it.
//!
//! A predicate answers with a [`Sign`](crate::num::Sign). Its stages keep its name:
//! `x_filter -> Option<Sign>` decides in floats within a proved error bound, `x_exact` in integers
//! of a fixed width whose range is proved, `x_big` on unbounded integers; `x` itself is the
//! cascade of the first two. Which predicate has which stages follows from measurements: on grid
//! points two or three products of 64-bit integers cost what a float stage would, and exact
//! zeros, so common in architecture, cost nothing extra. The table of degrees, ranges
//! and bounds is `docs/predicates.md`.
//!
//! The sign convention, stated once: `orient3d(a, b, c, d)` is the sign of det[b-a, c-a, d-a]
//! (the `robust` crate's has the other sign), and `side_of_lines` of ab and cd equals it. With a
//! polygon's vertices counter-clockwise as seen from where a line goes, the line passes through
//! its interior iff its side is positive on every edge.
//!
//! [`Budget`] says how large a scene's coordinates are and can switch the filters off;
//! [`counters`] says which stage answered; [`filtered`] decides in world coordinates what floats
//! can prove, for searches.
//!
//! Invariant: no sign depends on the budget, on the stage that found it, or on a tolerance.

mod along;
mod budget;
pub mod counters;
mod direction;
pub mod filtered;
mod four_lines;
pub mod gordan;
mod lines;
mod lines4;
mod meets;
mod orient;
mod plan;
mod plane;
mod ring;
#[cfg(test)]
mod tests;
mod vertex;

pub use along::{
    compare_along_line, compare_along_line_big, compare_along_line_exact, compare_crossings,
    compare_crossings_big, compare_crossings_exact,
};
pub use budget::{Budget, RANGES, Range};
pub use direction::{
    Direction, FloatVector, side_of_direction, side_of_direction_big, side_of_direction_filter,
};
pub use four_lines::{FourLines, Sides};
pub use lines::{side_of_lines, side_of_lines_big, side_of_lines_exact, side_of_lines_filter};
pub use lines4::{
    TransversalCount, side_of_transversals, side_of_transversals_big, transversal_count,
    transversal_count_big,
};
pub use meets::{side_of_meets, side_of_meets_big, side_of_meets_exact, side_of_meets_filter};
pub use orient::{
    orient2d, orient2d_big, orient2d_exact, orient3d, orient3d_big, orient3d_exact,
    orient3d_filter, orient3d_rational,
};
pub use plan::{PlanPoint, PlanPoints, compare_coordinates, turn_of_points, turn_of_points_filter};
pub use plane::{
    side_of_plane, side_of_plane_big, side_of_plane_exact, vertex_side_of_plane,
    vertex_side_of_plane_big, vertex_side_of_plane_exact,
};
pub use vertex::{
    Vertex, VertexPlane, side_of_point, side_of_vertex, side_of_vertex_big, side_of_vertex_exact,
    side_of_vertex_filter,
};
