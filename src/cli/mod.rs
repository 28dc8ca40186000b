//! The command line: one file a subcommand, each with its `Args` and its `run`.
//!
//! A subcommand parses nothing and prints nothing by itself: clap fills `Args`, `files` reads the
//! inputs and writes the outputs (to a temporary name, then renamed), `Failure` and `Exit` carry
//! errors and exit codes to the one place that maps them. Data goes to standard output, all else
//! to standard error.

mod bsp;
mod check;
mod csg;
mod division;
mod doom;
mod draw;
mod exit;
mod export;
mod eye;
mod files;
mod generate;
mod golden;
mod interrupt;
mod meshes;
mod motion;
mod numbers;
mod plan;
mod program;
mod progress;
mod pvs;
mod schema;
mod stab;
mod stress;
mod transversals;
mod vectors;
mod verify;
mod why;
mod world;

use clap::{CommandFactory, FromArgMatches, Parser, Subcommand};
use exit::{Exit, Failure};
use std::ffi::OsString;
use std::io::{IsTerminal, Write};
use std::process::ExitCode;

/// Exact visibility: what can be seen from where, with a proof for every answer.
#[derive(Debug, Parser)]
#[command(name = "stabline", version, after_help = EXIT_CODES)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

const EXIT_CODES: &str = "Exit codes: 0 done, 1 holes found, 2 usage, 3 bad input, \
    4 undecided pairs remain, 5 a proof does not hold, 130 interrupted.";

/// Every subcommand, in the order of `stabline --help`.
#[derive(Debug, Subcommand)]
enum Command {
    Bsp(Box<bsp::Args>),
    Check(check::Args),
    Csg(csg::Args),
    Draw(draw::Args),
    Export(export::Args),
    Eye(eye::Args),
    Generate(generate::Args),
    Golden(golden::Args),
    Move(motion::Args),
    Pvs(Box<pvs::Args>),
    Schema(schema::Args),
    Stab(stab::Args),
    Stress(stress::Args),
    Transversals(transversals::Args),
    Vectors(vectors::Args),
    Verify(verify::Args),
    Why(why::Args),
}

impl Command {
    fn run(self) -> Result<Exit, Failure> {
        match self {
            Command::Bsp(args) => bsp::run(*args),
            Command::Check(args) => check::run(args),
            Command::Csg(args) => csg::run(args),
            Command::Draw(args) => draw::run(args),
            Command::Export(args) => export::run(args),
            Command::Eye(args) => eye::run(args),
            Command::Generate(args) => generate::run(args),
            Command::Golden(args) => golden::run(&args),
            Command::Move(args) => motion::run(args),
            Command::Pvs(args) => pvs::run(*args),
            Command::Schema(args) => schema::run(args),
            Command::Stab(args) => stab::run(args),
            Command::Stress(args) => stress::run(args),
            Command::Transversals(args) => transversals::run(args),
            Command::Vectors(args) => vectors::run(args),
            Command::Verify(args) => verify::run(args),
            Command::Why(args) => why::run(args),
        }
    }
}

/// Runs one command for another, as if it were given on the command line.
fn run_command(arguments: &[OsString]) -> Result<Exit, Failure> {
    let name = OsString::from("stabline");
    let cli = Cli::try_parse_from(std::iter::once(&name).chain(arguments));
    cli.map_err(|error| usage(&error))?.command.run()
}

/// Runs the command line `arguments`, the program's name first.
pub fn run(arguments: impl IntoIterator<Item = OsString>) -> ExitCode {
    interrupt::install();
    let parsed = Cli::command()
        .try_get_matches_from(arguments)
        .and_then(|matches| Cli::from_arg_matches(&matches));
    let outcome = match parsed {
        Ok(cli) => cli.command.run(),
        Err(error) if error.use_stderr() => Err(usage(&error)),
        Err(help) => files::print(&help.render().to_string()).map(|()| Exit::Done),
    };
    match outcome {
        Ok(exit) => ExitCode::from(exit.code()),
        Err(failure) => {
            // Nothing is left to be told if standard error is closed as well.
            let _ = writeln!(std::io::stderr(), "{failure}");
            ExitCode::from(failure.code())
        }
    }
}

/// What clap says about the arguments: in full at a terminal, else its first line.
fn usage(error: &clap::Error) -> Failure {
    let text = error.render().to_string();
    let text = text.trim_end().trim_start_matches("error: ");
    if std::io::stderr().is_terminal() {
        return Failure::usage(text);
    }
    // clap lists missing arguments on lines of their own after a colon.
    let mut lines = text.lines();
    let mut first = lines.next().unwrap_or_default().to_owned();
    for line in lines.take_while(|line| line.starts_with("  ")) {
        first.push(' ');
        first.push_str(line.trim());
    }
    Failure::usage(first)
}
