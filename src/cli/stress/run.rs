//! Another program's answers beside ours.

use super::{Args, made, numbers};
use crate::cli::exit::{Exit, Failure};
use crate::cli::files;
use crate::cli::program::Program;
use crate::forge::{Family, Settings, find};
use crate::vectors::{Answer, Mishap};
use std::ffi::OsString;
use std::time::Duration;

/// How long a program may take for a case.
const TIMEOUT: Duration = Duration::from_secs(10);

/// The program that was named.
pub(super) fn program(args: &Args) -> Result<Program, Failure> {
    let command = args.run.iter().map(OsString::from).collect();
    Program::new(command, TIMEOUT, args.stream)
        .map_err(|error| Failure::usage(format!("{}: {error}", args.run[0])))
}

/// What is known of a program that did not answer.
pub(super) fn words(mishap: Mishap) -> String {
    match mishap {
        Mishap::Hang => "no answer in time".to_owned(),
        Mishap::Crash(what) | Mishap::Unreadable(what) => what,
    }
}

/// Asks the program about each case, and prints the answers that differ from ours.
pub(super) fn compare(args: &Args, family: &Family, settings: &Settings) -> Result<Exit, Failure> {
    let program = program(args)?;
    let mut session = program.session();
    let (mut differ, mut skipped) = (0, 0);
    for number in numbers(args) {
        let (input, case) = made(args, family, settings, number);
        let found = find(&input)
            .map_err(|fault| Failure::Input(format!("{}: case {number}: {fault}", family.name)))?;
        let said = match session.ask(&case) {
            Ok(Answer::Skip(_)) => {
                skipped += 1;
                continue;
            }
            Ok(answer) if answer == found.answer => continue,
            Ok(answer) => answer.to_value().to_string(),
            Err(mishap) => words(mishap),
        };
        differ += 1;
        let (expected, line) = (found.answer.to_value(), case.to_line());
        files::print(&format!("{said}, expected {expected}: {line}\n"))?;
    }
    let count = args.count;
    eprintln!("{}: {differ} of {count} answers differ, {skipped} skipped", family.name);
    Ok(if differ > 0 { Exit::Holes } else { Exit::Done })
}
