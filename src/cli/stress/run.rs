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

/// Asks the program about each case, and prints the answers that differ from ours.
pub(super) fn compare(args: &Args, family: &Family, settings: &Settings) -> Result<Exit, Failure> {
    let command = args.run.iter().map(OsString::from).collect();
    let program = Program::new(command, TIMEOUT, args.stream)
        .map_err(|error| Failure::usage(format!("{}: {error}", args.run[0])))?;
    let mut session = program.session();
    let (mut differ, mut skipped) = (0, 0);
    for number in numbers(args) {
        let (input, case) = made(args, family, settings, number);
        let found = find(&input)
            .map_err(|fault| Failure::Input(format!("{}: case {number}: {fault}", family.name)))?;
        let line = case.to_line();
        let said = session.ask(&case);
        if let Ok(Answer::Skip(_)) = said {
            skipped += 1;
            continue;
        }
        let said = match said {
            Ok(answer) if answer == found.answer => continue,
            Ok(answer) => answer.to_value().to_string(),
            Err(Mishap::Hang) => "no answer in time".to_owned(),
            Err(Mishap::Crash(what) | Mishap::Unreadable(what)) => what,
        };
        differ += 1;
        files::print(&format!("{said}, expected {}: {line}\n", found.answer.to_value()))?;
    }
    let count = args.count;
    eprintln!("{}: {differ} of {count} answers differ, {skipped} skipped", family.name);
    Ok(if differ > 0 { Exit::Holes } else { Exit::Done })
}
