//! `stabline vectors`: test vectors for other implementations.

mod load;
mod run;
mod show;

use super::exit::{Exit, Failure};
use super::files;
use crate::vectors::{Case, EngineError, Witness, answer_with_witness};
use serde_json::json;
use std::io::{self, BufRead, Read};
use std::path::PathBuf;

/// Run a program on the test vectors, and tell what it gets wrong
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    #[command(subcommand)]
    command: VectorsCommand,
}

#[derive(Debug, clap::Subcommand)]
enum VectorsCommand {
    Run(run::Args),
    Answer(AnswerArgs),
    Show(ShowArgs),
}

/// Answer a case on standard input, as a program under test does
#[derive(Debug, clap::Args)]
struct AnswerArgs {
    /// Answer one case a line until the input ends
    #[arg(long)]
    stream: bool,
}

/// Print a case as a program under test gets it; with --expected what is true of it
#[derive(Debug, clap::Args)]
struct ShowArgs {
    /// The file of vectors
    file: PathBuf,
    /// The number of the test in it
    #[arg(value_name = "TCID")]
    tc_id: u32,
    /// Print the whole test instead: the answer, and what proves it
    #[arg(long)]
    expected: bool,
}

pub(super) fn run(args: Args) -> Result<Exit, Failure> {
    match args.command {
        VectorsCommand::Run(args) => run::run(args),
        VectorsCommand::Answer(args) => answer_cases(&args),
        VectorsCommand::Show(args) => show(&args),
    }
}

fn answer_cases(args: &AnswerArgs) -> Result<Exit, Failure> {
    let bad = |place: &str, what: String| Failure::file(place, what);
    if !args.stream {
        let mut bytes = Vec::new();
        let read = io::stdin().lock().read_to_end(&mut bytes);
        read.map_err(|error| bad("standard input", error.to_string()))?;
        let said = answer_to(&bytes).map_err(|what| bad("standard input", what))?;
        return files::print(&format!("{said}\n")).map(|()| Exit::Done);
    }
    for (line, number) in io::stdin().lock().split(b'\n').zip(1..) {
        let place = format!("standard input:{number}");
        let line = line.map_err(|error| bad(&place, error.to_string()))?;
        let said = answer_to(&line).map_err(|what| bad(&place, what))?;
        files::print(&format!("{said}\n"))?;
    }
    Ok(Exit::Done)
}

fn answer_to(bytes: &[u8]) -> Result<String, String> {
    let case = Case::read(bytes).map_err(|error| error.to_string())?;
    let (answer, witness) =
        answer_with_witness(&case).map_err(|error: EngineError| error.to_string())?;
    Ok(Witness::beside(&answer, witness.as_ref()).to_string())
}

fn show(args: &ShowArgs) -> Result<Exit, Failure> {
    let loaded = load::load(&args.file)?;
    let wanted = loaded.vectors.tests().find(|(_, test)| test.tc_id == args.tc_id);
    let Some((group, test)) = wanted else {
        let count = loaded.vectors.number_of_tests;
        let what = format!("no test {}, expected one of 1 to {count}", args.tc_id);
        return Err(Failure::usage(what));
    };
    let text = match args.expected {
        true => json!(test).to_string(),
        false => group.case(test).to_line(),
    };
    files::print(&format!("{text}\n")).map(|()| Exit::Done)
}
