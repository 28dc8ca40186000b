//! Test vectors for other implementations: cases with answers known, and the scores of programs.
//!
//! A [`Case`] is what a program is asked, an [`Answer`] what it says; a [`VectorsFile`] holds cases
//! with the answers that are expected and with what proves them (`docs/formats/vectors.md`), after
//! the manner of Wycheproof. [`judge`] compares the two under the [`Policy`] for grazing that a
//! program declares, and a [`Tally`] adds up. [`answer`] is this crate's own answer to any case.
//!
//! No program is run here: that is `cli`'s.

mod answer;
mod case;
mod engine;
mod file;
mod score;
mod witness;

pub use answer::{Answer, AnswerError, Class, LineCount};
pub use case::{Case, Kind};
pub use engine::{EngineError, ViewCells, ViewCells2, answer, answer_with_witness};
pub use file::{Expected, Group, Note, SceneOfGroup, Test, VectorsError, VectorsFile};
pub use score::{Failing, Mark, Marks, Mishap, Policy, ScoreReport, ScoredFile, Tally, judge};
pub use witness::{Witness, passes};
