//! `stabline reduce`: a failing case made small.

use super::exit::{Exit, Failure};
use super::files::{self, Input};
use super::interrupt;
use crate::forge::{self, Fault, Trial, measure};
use crate::vectors::{Case, Group, Note, SceneOfGroup, VectorsFile};
use std::io::Write;
use std::path::PathBuf;
use std::process::{Command, Stdio};

/// Shrink a case for as long as a command exits with 0
///
/// The command gets each smaller case on its standard input, as one JSON object: fewer portals,
/// cells, vertices, smaller numbers. What is left is written as a test vector
/// (`stabline-vectors/1`) with our answer and its evidence. Interrupted, it writes the smallest
/// case so far.
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    /// The case, one JSON object, or `-` for standard input
    case: PathBuf,
    /// A command of the shell: what it exits with 0 for is kept
    #[arg(long = "while", value_name = "COMMAND")]
    command: String,
    /// Write to this file, and not to standard output
    #[arg(short, long, value_name = "OUT.json")]
    output: Option<PathBuf>,
}

pub(super) fn run(args: Args) -> Result<Exit, Failure> {
    files::check_outputs([&args.output])?;
    let file = Input::read(&args.case)?;
    let case = Case::read(&file.bytes).map_err(|error| Failure::file(&file.name, error))?;
    let input = forge::Input::of_case(&case).map_err(|error| Failure::file(&file.name, error))?;
    let mut shell = Shell { command: &args.command, case: &case, tests: 0 };
    if !shell.holds(&input) {
        return Err(Failure::usage(
            "--while: the command does not exit with 0 for the case itself",
        ));
    }
    interrupt::watch();
    let smallest = forge::reduce(&input, &mut shell);
    let tests = shell.tests;
    let is_interrupted = interrupt::is_raised();
    interrupt::unwatch();
    let (parts, cells, vertices, digits, _) = measure(&smallest);
    eprintln!(
        "{parts} parts, {cells} cells, {vertices} vertices, {digits} bits after {tests} tests"
    );
    let text = text_of(&smallest, &shell.case_of(&smallest))
        .map_err(|fault| Failure::file(&file.name, fault))?;
    files::write(args.output.as_deref(), |out| out.write_all(text.as_bytes()))?;
    Ok(if is_interrupted { Exit::Interrupted } else { Exit::Done })
}

/// The command of the shell.
struct Shell<'a> {
    command: &'a str,
    case: &'a Case,
    tests: u64,
}

impl Shell<'_> {
    /// The smaller input as a case, its words those of the case that was given.
    fn case_of(&self, input: &forge::Input) -> Case {
        let flags: Vec<&str> = self.case.flags.iter().map(String::as_str).collect();
        input.case(self.case.tc_id, &self.case.comment, &flags)
    }
}

impl Trial for Shell<'_> {
    fn holds(&mut self, input: &forge::Input) -> bool {
        self.tests += 1;
        let mut command = shell(self.command);
        command.stdin(Stdio::piped()).stdout(Stdio::null()).stderr(Stdio::null());
        let Ok(mut child) = command.spawn() else { return false };
        if let Some(mut stdin) = child.stdin.take() {
            // A command may decide without having read all.
            let _ = writeln!(stdin, "{}", self.case_of(input).to_line());
        }
        child.wait().is_ok_and(|status| status.success())
    }

    fn is_interrupted(&self) -> bool {
        interrupt::is_raised()
    }

    fn found(&mut self, input: &forge::Input) {
        let (parts, cells, vertices, digits, _) = measure(input);
        eprintln!("{parts} parts, {cells} cells, {vertices} vertices, {digits} bits");
    }
}

#[cfg(unix)]
fn shell(text: &str) -> Command {
    let mut command = Command::new("sh");
    command.args(["-c", text]);
    command
}

#[cfg(not(unix))]
fn shell(text: &str) -> Command {
    let mut command = Command::new("cmd");
    command.args(["/C", text]);
    command
}

/// A file of one test.
fn text_of(input: &forge::Input, case: &Case) -> Result<String, Fault> {
    let mut test = forge::test_of(input)?;
    test.tc_id = 1;
    test.comment = case.comment.clone();
    test.flags = case.flags.clone();
    let about = "A case that was made small by `stabline reduce`".to_owned();
    let scene = test.input.is_none().then(|| SceneOfGroup::new("reduced", case.input.clone()));
    let note = |flag: &String| {
        let family = forge::Family::named(flag);
        let about = family.map_or_else(|| flag.clone(), |family| family.purpose.to_owned());
        (flag.clone(), Note { about, recalls: None })
    };
    let file = VectorsFile {
        format: VectorsFile::FORMAT.to_owned(),
        name: "reduced".to_owned(),
        about: about.clone(),
        number_of_tests: 1,
        notes: test.flags.iter().map(note).collect(),
        groups: vec![Group { kind: case.kind, about, scene, tests: vec![test] }],
    };
    Ok(file.to_text())
}
