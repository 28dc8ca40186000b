//! Another program's answers beside ours.

use super::{Args, made, numbers};
use crate::cli::exit::{Exit, Failure};
use crate::cli::files;
use crate::cli::program::Program;
use crate::forge::{Answer, Family, Settings, find};

/// Asks the program about each case, and prints the answers that differ from ours.
pub(super) fn compare(args: &Args, family: &Family, settings: &Settings) -> Result<Exit, Failure> {
    let program = Program::new(&args.run);
    let (mut differ, mut skipped) = (0, 0);
    for number in numbers(args) {
        let (input, case) = made(args, family, settings, number);
        let found = find(&input)
            .map_err(|fault| Failure::Input(format!("{}: case {number}: {fault}", family.name)))?;
        let line = case.to_line();
        let said = program.ask(case.kind, &line);
        if let Ok(Answer::Skip(_)) = said {
            skipped += 1;
            continue;
        }
        let said = match said {
            Ok(answer) if answer == found.answer => continue,
            Ok(answer) => format!("{answer:?}"),
            Err(what) => what,
        };
        differ += 1;
        files::print(&format!("{said}, expected {:?}: {line}\n", found.answer))?;
    }
    let count = args.count;
    eprintln!("{}: {differ} of {count} answers differ, {skipped} skipped", family.name);
    Ok(if differ > 0 { Exit::Holes } else { Exit::Done })
}
