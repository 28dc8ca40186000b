//! Results: their types, their canonical text, and the sink that searches report progress to.

mod body;
mod bsp;
mod eye;
mod eye_plan;
mod matrix;
mod motion;
mod objects;
mod plan;
mod progress;
mod proof;
mod pvs;
mod stab;
mod transversals;

pub use body::{BodyReport, BodyTreeReport, body_text};
pub use bsp::{BspChecked, BspReport, BspStage, CellShape, CellsReport, PortalPolygon};
pub use eye::{
    EyeCell, EyeFrustum, EyeObject, EyeRegion, EyeReport, EyeSpace, EyeSpaceRegion,
    Integer as EyeInteger, Ratio as EyeRatio,
};
pub use eye_plan::{
    EyeCone, EyePlanCell, EyePlanRegion, EyePlanReport, EyePlanSeen, EyePlanStep, EyePlanView,
};
pub use matrix::{Counts, Matrix, Verdict};
pub use motion::{MoveBox, MoveHit, MoveReport, MoveStay};
pub use objects::{ObjectEntry, ObjectWitness, ObjectsCounts, ObjectsReport};
pub use plan::{PlanCell, PlanCellPortal, PlanCrossing, PlanPosition, PlanReport};
pub use progress::{Progress, Silent};
pub use proof::{
    Cut, CutReason, DirectedPortal, ProofHead, ProofNode, ProofText, ProofTree, ProvedGrazing,
    ProvedOpen, Refutation, graph_text, refutation_text,
};
pub use pvs::{InputId, PairWitness, PvsReport, ReportError, WitnessLine};
pub use stab::{StabReport, surd_value};
pub use transversals::{TransversalsReport, transversals_text};
