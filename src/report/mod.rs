//! Results: their types, their canonical text, and the sink that searches report progress to.

mod bsp;
mod eye;
mod matrix;
mod motion;
mod progress;
mod pvs;
mod stab;
mod transversals;

pub use bsp::{BspChecked, BspReport, BspStage, CellShape, CellsReport, PortalPolygon};
pub use eye::{
    EyeCell, EyeFrustum, EyeRegion, EyeReport, Integer as EyeInteger, Ratio as EyeRatio,
};
pub use matrix::{Counts, Matrix, Verdict};
pub use motion::{MoveBox, MoveHit, MoveReport, MoveStay};
pub use progress::{Progress, Silent};
pub use pvs::{InputId, PairWitness, PvsReport, ReportError};
pub use stab::StabReport;
pub use transversals::{TransversalsReport, transversals_text};
