//! How a long computation tells of its progress, and is told to stop.

/// A sink for progress; shared by all threads of a computation.
pub trait Progress: Sync {
    /// A stage of the work begins that takes `total` steps.
    fn begin(&self, stage: &str, total: u64);

    /// `steps` more steps of the stage are done.
    fn advance(&self, steps: u64);

    /// Whether the computation shall end as an interruption, keeping what is finished.
    fn is_interrupted(&self) -> bool;
}

/// Reports nothing and never interrupts.
#[derive(Clone, Copy, Debug, Default)]
pub struct Silent;

impl Progress for Silent {
    fn begin(&self, _stage: &str, _total: u64) {}
    fn advance(&self, _steps: u64) {}
    fn is_interrupted(&self) -> bool {
        false
    }
}
