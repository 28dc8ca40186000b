//! Programs under test: a case on standard input, an answer on standard output.

use crate::forge::{Answer, Kind};
use std::io::Write;
use std::process::{Command, Stdio};

/// A program and its arguments.
pub(super) struct Program<'a> {
    words: &'a [String],
}

impl Program<'_> {
    /// The program with these words.
    pub(super) fn new(words: &[String]) -> Program<'_> {
        Program { words }
    }

    /// What the program answers to a case, or why that is no answer.
    pub(super) fn ask(&self, kind: Kind, case: &str) -> Result<Answer, String> {
        let mut command = Command::new(&self.words[0]);
        command.args(&self.words[1..]).stdin(Stdio::piped()).stdout(Stdio::piped());
        let mut child = command.spawn().map_err(|error| format!("{}: {error}", self.words[0]))?;
        if let Some(mut input) = child.stdin.take() {
            // A program may answer without having read all.
            let _ = writeln!(input, "{case}");
        }
        let output = child.wait_with_output().map_err(|error| error.to_string())?;
        if !output.status.success() {
            return Err(format!("the program ended with {}", output.status));
        }
        Answer::read(kind, &String::from_utf8_lossy(&output.stdout))
    }
}
