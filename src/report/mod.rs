//! Results: their types, their canonical text, and the sink that searches report progress to.

mod matrix;
mod progress;
mod pvs;
mod stab;
mod transversals;

pub use matrix::{Counts, Matrix, Verdict};
pub use progress::{Progress, Silent};
pub use pvs::{InputId, PairWitness, PvsReport, ReportError};
pub use stab::StabReport;
pub use transversals::{TransversalsReport, transversals_text};
