//! `stabline stress`: hard cases, made from a seed.

mod laws;
mod run;

use super::exit::{Exit, Failure};
use super::files::{self, Input as InputFile};
use super::world::{self, WorldArgs};
use crate::forge::{FAMILIES, Family, Graph, Input, Parameter, Settings, find, graph_of};
use crate::formats::blake3;
use crate::report::Silent;
use crate::vectors::Case;
use std::path::{Path, PathBuf};

/// Make hard cases, hold our own answers to them, or ask another program
///
/// Without a program each case is answered by this one, its witness or certificate checked, and the
/// cases are printed, one JSON object a line. With `--run` the program gets one case on its
/// standard input, a process each, and prints its answer as one JSON object.
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    /// The family of cases; with `--input` it is `perturbed` if none is named
    #[arg(long, value_name = "NAME", required_unless_present_any = ["list", "input"])]
    family: Option<String>,
    /// The map that the family is made from: a portal graph, or anything that has one
    #[arg(long, value_name = "MAP")]
    input: Option<PathBuf>,
    /// Another number makes other cases
    #[arg(long, value_name = "S", default_value_t = 1)]
    seed: u64,
    /// How many cases
    #[arg(long, value_name = "N", default_value_t = 10)]
    count: u32,
    /// The number of the first case
    #[arg(long, value_name = "I", default_value_t = 0)]
    first: u32,
    /// Set a parameter of the family (`--list` has them)
    #[arg(long, value_name = "K=V", value_parser = parse_parameter)]
    param: Vec<(String, i64)>,
    /// Write each case to a file of its own in this folder
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Print no cases, but a line with their number and the hash of all answers
    #[arg(long, conflicts_with = "out")]
    digest: bool,
    /// List the families with their parameters
    #[arg(long)]
    list: bool,
    /// Ask this program, and compare its answers with ours
    #[arg(long, value_name = "PROGRAM", num_args = 1.., allow_hyphen_values = true)]
    run: Vec<String>,
    /// Hold laws: how the answers to permuted, mirrored, moved, scaled, reversed, split, opened and
    /// closed cases must stand to each other
    #[arg(long)]
    laws: bool,
    /// The program answers one line a case, one line each, in one process
    #[arg(long, requires = "run")]
    stream: bool,
    #[command(flatten)]
    world: WorldArgs,
}

fn parse_parameter(text: &str) -> Result<(String, i64), String> {
    let expected = || format!("expected K=V with a whole number V, not {text:?}");
    let (name, value) = text.split_once('=').ok_or_else(expected)?;
    Ok((name.to_owned(), value.parse().map_err(|_| expected())?))
}

pub(super) fn run(args: Args) -> Result<Exit, Failure> {
    if args.list {
        return files::print(&listed()).map(|()| Exit::Done);
    }
    let name = args.family.as_deref().unwrap_or("perturbed");
    let family = Family::named(name).ok_or_else(|| {
        let names: Vec<&str> = FAMILIES.iter().map(|family| family.name).collect();
        Failure::usage(format!("no family `{name}`, expected one of {}", names.join(", ")))
    })?;
    let map = args.input.as_ref().map(|path| read_map(path, &args.world)).transpose()?;
    let settings = family.settings(&args.param, map).map_err(Failure::usage)?;
    if args.laws {
        return laws::hold(&args, family, &settings);
    }
    if !args.run.is_empty() {
        return run::compare(&args, family, &settings);
    }
    let mut text = String::new();
    let mut answers = String::new();
    for number in numbers(&args) {
        let (input, case) = made(&args, family, &settings, number);
        let found = find(&input).map_err(|fault| {
            Failure::Input(format!("{}: case {number}: {fault}\n{}", family.name, case.to_line()))
        })?;
        answers.push_str(&format!("{number} {:?} {}\n", found.answer, found.evidence));
        match &args.out {
            Some(folder) => {
                let name = format!("{}-{}-{number}.json", family.name, args.seed);
                let line = case.to_line() + "\n";
                files::write(Some(&folder.join(name)), |out| out.write_all(line.as_bytes()))?;
            }
            None => text.push_str(&(case.to_line() + "\n")),
        }
    }
    if args.digest {
        let hash = blake3::hex(answers.as_bytes());
        text = format!("{} {} seed {} {hash}\n", family.name, args.count, args.seed);
    }
    files::print(&text).map(|()| Exit::Done)
}

/// The portal graph of a file.
fn read_map(path: &Path, args: &WorldArgs) -> Result<Graph, Failure> {
    let file = InputFile::read(path)?;
    Ok(graph_of(&world::read_graph(&file, args, &Silent)?))
}

fn numbers(args: &Args) -> std::ops::Range<u32> {
    args.first..args.first.saturating_add(args.count)
}

/// The case of a number.
fn made(args: &Args, family: &Family, settings: &Settings, number: u32) -> (Input, Case) {
    let input = family.input(settings, args.seed, u64::from(number));
    let comment = format!("family {}, seed {}, case {number}", family.name, args.seed);
    let case = input.case(number, &comment, &[family.name]);
    (input, case)
}

/// The families, each with its purpose and its parameters.
fn listed() -> String {
    let mut text = String::new();
    for family in FAMILIES {
        text.push_str(&format!(
            "{} ({})\n    {}\n",
            family.name,
            family.kind.name(),
            family.purpose
        ));
        for Parameter { name, purpose, default, range: [low, high] } in family.parameters {
            text.push_str(&format!("    {name}={default} ({low} to {high}): {purpose}\n"));
        }
    }
    text
}
