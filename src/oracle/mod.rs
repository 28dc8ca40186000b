//! Brute-force twins of the fast algorithms, and the families of input to compare them on.
//!
//! A twin answers the same question by a different and slower argument, with unbounded integers
//! and rationals only: no filter, no shared predicate, nothing of the engine. Where twin and
//! engine differ, one of them is wrong. Feature `oracle`.

mod families;
mod linear;
mod lines;
mod motion;
mod overlap;
mod plan;
mod plane;
mod polynomial;
mod pvs;
mod sequence;
mod sweep;
mod world;

pub use crate::num::Random;
pub use families::{Family, sequence, sequence_2d};
pub use lines::{MeetingLines, meeting_lines};
pub use motion::first_contact;
pub use overlap::overlap;
pub use plan::{Door, Flat, flat_pairs, flat_seers};
pub use plane::{PlaneGate, PlaneTruth, classify_2d, classify_pairs_2d};
pub use pvs::{Gate, on_common_grid, open_pairs, touched_pairs};
pub use sequence::{LinePoints, Truth, classify, open_in_order};
pub use sweep::{Star, star};
pub use world::{Occluders, middle_within};
