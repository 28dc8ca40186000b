//! Exit codes and failures: the one place that knows the numbers.

use crate::scene::InputError;
use std::fmt;
use std::path::Path;

/// How a command that did its work ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Exit {
    /// Everything asked for is done.
    Done,
    /// `check` found holes.
    Holes,
    /// `golden` found other bytes than those that are kept.
    Drift,
    /// Pairs remain undecided under the budget given.
    Undecided,
    /// Interrupted, with the finished work kept.
    Interrupted,
}

impl Exit {
    pub(super) fn code(self) -> u8 {
        match self {
            Exit::Done => 0,
            Exit::Holes | Exit::Drift => 1,
            Exit::Undecided => 4,
            Exit::Interrupted => 130,
        }
    }
}

/// Why a command could not do its work: shown as one line, `error: FILE:LINE: what`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Failure {
    /// The arguments do not go together.
    Usage(String),
    /// An input is wrong, or a file cannot be read or written.
    Input(String),
    /// A proof does not hold.
    Flaw(String),
    /// Interrupted before there was anything to keep.
    Interrupted,
}

impl Failure {
    /// Arguments that do not go together.
    pub(super) fn usage(what: impl fmt::Display) -> Failure {
        Failure::Usage(what.to_string())
    }

    /// Something wrong in the file `name`.
    pub(super) fn file(name: &str, what: impl fmt::Display) -> Failure {
        Failure::Input(format!("{name}: {what}"))
    }

    /// The system refuses to `verb` (read, write) the file at `path`.
    pub(super) fn system(verb: &str, path: &Path, error: &std::io::Error) -> Failure {
        Failure::Input(format!("{}: cannot {verb}: {error}", path.display()))
    }

    /// A proof that does not hold.
    pub(super) fn flaw(what: impl fmt::Display) -> Failure {
        Failure::Flaw(what.to_string())
    }

    pub(super) fn code(&self) -> u8 {
        match self {
            Failure::Usage(_) => 2,
            Failure::Flaw(_) => 5,
            Failure::Input(_) => 3,
            Failure::Interrupted => Exit::Interrupted.code(),
        }
    }
}

impl From<InputError> for Failure {
    fn from(error: InputError) -> Failure {
        Failure::Input(error.to_string())
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Failure::Usage(what) => write!(f, "error: {what}"),
            Failure::Interrupted => f.write_str("interrupted"),
            // Names and excerpts of a file may hold line ends; an error is one line.
            Failure::Input(what) | Failure::Flaw(what) => {
                f.write_str("error: ")?;
                for piece in what.split_inclusive(char::is_control) {
                    f.write_str(piece.trim_end_matches(char::is_control))?;
                    if piece.ends_with(char::is_control) {
                        f.write_str(" ")?;
                    }
                }
                Ok(())
            }
        }
    }
}
