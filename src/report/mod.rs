//! Results: their types, their canonical text, and the sink that searches report progress to.

mod progress;

pub use progress::{Progress, Silent};
