//! Points of a floorplan, and the decisions about them: which way three turn, in which order two
//! come.
//!
//! A plan is divided along its walls' lines, so its points are ends of walls and meets of two
//! lines: rational, each over a denominator of its own. [`PlanPoint`] holds one exactly, with the
//! nearest floats beside it; [`PlanPoints`] is a table of distinct ones, to which everything about
//! a plan refers by number.
//!
//! Which stage decides: where all points of a table are integers of 30 bits, 64-bit integers do at
//! once; else floats within a proved bound, then integers of 192 bits, then unbounded ones.

mod point;
mod table;
#[cfg(test)]
mod tests;

pub use point::{PlanPoint, compare_coordinates, turn_of_points, turn_of_points_filter};
pub use table::PlanPoints;
