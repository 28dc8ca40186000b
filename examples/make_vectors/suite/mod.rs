//! The suite: families of cases, each built so that its answer is known beforehand.
//!
//! A family states the answer by its construction where it can; the engine's answer, which comes
//! with the witness or the certificate, has to be the same, or the suite is not written.

mod book;
mod notes;
mod number;
mod plane_sequences;

use stabline::vectors::VectorsFile;

/// Every file, in the order of their names.
pub fn files() -> Vec<VectorsFile> {
    vec![plane_sequences::file()]
}
