//! `stabline transversals`: all lines that meet four given lines.

use super::exit::{Exit, Failure};
use super::files::{self, Input};
use crate::formats::lines::LinesFile;
use crate::report::{TransversalsReport, transversals_text};
use crate::stab::transversals::transversals;
use std::path::PathBuf;

/// Compute all lines that meet four given lines, exactly, every degenerate case included
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    /// The four lines: `stabline-lines/1`, or `-` for standard input
    lines: PathBuf,
    /// Print JSON (`stabline-transversals/1`)
    #[arg(long)]
    json: bool,
}

pub(super) fn run(args: Args) -> Result<Exit, Failure> {
    let input = Input::read(&args.lines)?;
    let lines = LinesFile::read(&input.bytes)
        .and_then(|file| file.lines())
        .map_err(|error| Failure::file(&input.name, error))?;
    let result = transversals(&lines);
    let text = if args.json {
        TransversalsReport::new(&result).to_json()
    } else {
        transversals_text(&result)
    };
    files::print(&text).map(|()| Exit::Done)
}
