//! Stabbing lines of portal sequences, and the lines that meet four lines.

pub mod transversals;
