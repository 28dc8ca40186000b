//! `stabline vectors run`: a program on all cases.

use super::load::{Loaded, load_all};
use super::show;
use crate::cli::exit::{Exit, Failure};
use crate::cli::files;
use crate::cli::program::Program;
use crate::cli::progress::ProgressArgs;
use crate::report::Progress;
use crate::vectors::{
    Answer, Case, Expected, Failing, Kind, Mark, Mishap, Policy, ScoreReport, Tally, Witness, judge,
};
use serde_json::{Value, json};
use std::ffi::OsString;
use std::path::PathBuf;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};
use std::time::Duration;

/// Run a program on the test vectors: a case on its standard input, an answer on its output
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    /// What the program declares about pairs that a line only touches
    #[arg(long, value_enum, default_value = "any")]
    policy: PolicyArg,
    /// Files of vectors [default: those in the folder `vectors`]
    #[arg(long, value_name = "FILE")]
    file: Vec<PathBuf>,
    /// Give one process all cases, one line each, instead of a process for each
    #[arg(long)]
    stream: bool,
    /// How long a case may take, in seconds
    #[arg(long, value_name = "SECONDS", default_value = "10",
        value_parser = clap::value_parser!(u64).range(1..=86_400))]
    timeout: u64,
    /// Only cases of these kinds
    #[arg(long, value_enum)]
    kind: Vec<KindArg>,
    /// Only cases with one of these flags
    #[arg(long)]
    flag: Vec<String>,
    /// How many processes run at a time [default: one a processor]
    #[arg(long, value_parser = clap::value_parser!(u16).range(1..))]
    threads: Option<u16>,
    /// Print the score as JSON (`stabline-vectors-score/1`)
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    progress: ProgressArgs,
    /// The program and its arguments
    #[arg(last = true, required = true, value_name = "PROGRAM")]
    program: Vec<OsString>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum PolicyArg {
    /// What is only touched is not seen: to say so is waste
    Open,
    /// What is touched is seen: not to say so is a failure
    Closed,
    /// It promises neither, and both are right
    Any,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum KindArg {
    Sequence,
    Transversals,
    Graph,
    Scene,
    Eye,
}

impl From<KindArg> for Kind {
    fn from(kind: KindArg) -> Kind {
        match kind {
            KindArg::Sequence => Kind::Sequence,
            KindArg::Transversals => Kind::Transversals,
            KindArg::Graph => Kind::Graph,
            KindArg::Scene => Kind::Scene,
            KindArg::Eye => Kind::Eye,
        }
    }
}

/// A case, with what is true of it.
struct Question<'f> {
    file: &'f str,
    case: Case,
    expected: Expected,
}

/// An answer, and the line that is shown for it.
type Said = (Answer, Option<Witness>);

pub(super) fn run(args: Args) -> Result<Exit, Failure> {
    let policy = match args.policy {
        PolicyArg::Open => Policy::Open,
        PolicyArg::Closed => Policy::Closed,
        PolicyArg::Any => Policy::Any,
    };
    let loaded = load_all(&args.file)?;
    let questions = questions(&args, &loaded);
    if questions.is_empty() {
        return Err(Failure::usage("no case of the vectors has these kinds and flags"));
    }
    let timeout = Duration::from_secs(args.timeout);
    let program = Program::new(args.program.clone(), timeout, args.stream).map_err(|error| {
        Failure::usage(format!("{}: cannot run: {error}", args.program[0].display()))
    })?;
    let answers = ask_all(&args, &program, &questions).ok_or(Failure::Interrupted)?;
    let mut tally = Tally::default();
    let mut listed = Vec::new();
    for (question, said) in questions.iter().zip(&answers) {
        let answer = said.clone().map(|(answer, _)| answer);
        let Question { file, case, expected } = question;
        let is_refuted = |said: &Said| said.1.as_ref().is_some_and(|line| !line.proves(case));
        let mark = match said.as_ref().is_ok_and(is_refuted) {
            true => Mark::WrongWitness,
            false => judge(expected, &answer, policy),
        };
        tally.add(case.kind, &case.flags, mark);
        if mark.fails() || mark == Mark::Waste {
            listed.push(Failing {
                file: (*file).to_owned(),
                tc_id: case.tc_id,
                mark,
                expected: expected.answer().to_value(),
                got: shown(said),
                comment: case.comment.clone(),
                flags: case.flags.clone(),
            });
        }
    }
    let report = ScoreReport {
        format: ScoreReport::FORMAT,
        program: program.command(),
        policy,
        files: loaded.into_iter().map(|loaded| loaded.scored).collect(),
        all: tally.all,
        by_kind: tally.by_kind,
        by_flag: tally.by_flag,
        listed,
    };
    let text = match args.json {
        true => format!("{:#}\n", json!(report)),
        false => show::text(&report),
    };
    files::print(&text)?;
    Ok(if report.all.failures() > 0 { Exit::Holes } else { Exit::Done })
}

fn questions<'f>(args: &Args, loaded: &'f [Loaded]) -> Vec<Question<'f>> {
    let is_kind = |kind| args.kind.is_empty() || args.kind.iter().any(|&k| Kind::from(k) == kind);
    let has_flag = |flags: &[String]| {
        args.flag.is_empty() || args.flag.iter().any(|flag| flags.contains(flag))
    };
    let of_file = |loaded: &'f Loaded| {
        let tests = loaded.vectors.tests();
        tests.filter_map(|(group, test)| {
            Some(Question {
                file: &loaded.scored.name,
                case: group.case(test),
                expected: test.expected()?,
            })
        })
    };
    let all = loaded.iter().flat_map(of_file);
    all.filter(|q| is_kind(q.case.kind) && has_flag(&q.case.flags)).collect()
}

fn shown(said: &Result<Said, Mishap>) -> Value {
    match said {
        Ok((answer, witness)) => Witness::beside(answer, witness.as_ref()),
        Err(Mishap::Hang) => json!("no answer in time"),
        Err(Mishap::Crash(what) | Mishap::Unreadable(what)) => json!(what),
    }
}

/// What the program answers to each question; `None` if interrupted.
fn ask_all(
    args: &Args,
    program: &Program,
    questions: &[Question],
) -> Option<Vec<Result<Said, Mishap>>> {
    let reporter = args.progress.reporter();
    reporter.begin("cases", questions.len() as u64);
    let at_hand = std::thread::available_parallelism().map_or(1, |count| count.get() as u16);
    let threads = args.threads.unwrap_or(at_hand);
    let next = AtomicUsize::new(0);
    let answers = Mutex::new(Vec::with_capacity(questions.len()));
    std::thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                let mut session = program.session();
                loop {
                    let index = next.fetch_add(1, Relaxed);
                    let Some(question) = questions.get(index) else { return };
                    if reporter.is_interrupted() {
                        return;
                    }
                    let answer = session.ask_for_witness(&question.case);
                    reporter.advance(1);
                    answers.lock().expect("no thread panics").push((index, answer));
                }
            });
        }
    });
    let mut answers = answers.into_inner().expect("no thread panics");
    answers.sort_by_key(|(index, _)| *index);
    (answers.len() == questions.len())
        .then(|| answers.into_iter().map(|(_, answer)| answer).collect())
}
