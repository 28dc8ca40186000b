//! `stabline check`: scores a candidate PVS against an exact one.

mod show;

use super::doom;
use super::exit::{Exit, Failure};
use super::files::{self, Input};
use crate::audit::check::{self, CheckError, Policy, Presence};
use crate::formats::bsp::Visibility;
use crate::formats::npy::NpyMatrix;
use crate::report::{InputId, Matrix, PvsReport, Verdict};
use crate::scene::read_graph;
use std::path::PathBuf;

/// Score a candidate PVS against an exact one: holes, waste, grazing pairs
///
/// A hole is an open pair that the candidate lacks; waste is a pair that it has though it is not
/// open. Exits with 1 if there is a hole.
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    /// The exact result: `stabline-pvs/1`, or `.npy` together with --input
    golden: PathBuf,
    /// What is scored: `stabline-pvs/1`, `.npy`, a `.bsp`, or the REJECT lump of `FILE.wad:MAP`
    candidate: PathBuf,
    /// The portal graph that an `.npy` golden result belongs to
    #[arg(long)]
    input: Option<PathBuf>,
    /// Whether grazing pairs are only counted (open), or a missing one is a hole too (closed)
    #[arg(long, value_enum, default_value = "open")]
    policy: PolicyArg,
    /// How many holes, and how many pairs of waste, the text lists
    #[arg(long, value_name = "N", default_value_t = 20)]
    list: usize,
    /// Print JSON, with every hole and every pair of waste
    #[arg(long)]
    json: bool,
}

/// The option `--policy`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(super) enum PolicyArg {
    /// Grazing pairs are the implementer's choice
    Open,
    /// Grazing pairs are visible
    Closed,
}

impl From<PolicyArg> for Policy {
    fn from(policy: PolicyArg) -> Policy {
        match policy {
            PolicyArg::Open => Policy::Open,
            PolicyArg::Closed => Policy::Closed,
        }
    }
}

/// A candidate, and what it is.
struct Candidate {
    presence: Presence,
    /// The form it was read from, such as `Quake (version 29)`.
    kind: String,
    /// Leafs without a row of their own, in a level.
    rows_missing: usize,
}

pub(super) fn run(args: Args) -> Result<Exit, Failure> {
    let policy = Policy::from(args.policy);
    let golden = Input::read(&args.golden)?;
    let candidate = Input::read(&args.candidate)?;
    let report = read_golden(&golden, args.input.as_deref())?;
    let read = read_candidate(&candidate, &report, policy)?;
    let score = check::check(&report.matrix, &read.presence, policy)
        .map_err(|error| other_scene(&candidate, &error))?;
    let shown = show::Shown {
        golden: &golden.file_name(),
        candidate: &candidate.file_name(),
        report: &report,
        read: &read,
        policy,
        score: &score,
    };
    let text = if args.json { shown.json() } else { shown.text(args.list) };
    files::print(&text)?;
    Ok(if score.holes.is_empty() { Exit::Done } else { Exit::Holes })
}

fn other_scene(candidate: &Input, error: &CheckError) -> Failure {
    Failure::file(&candidate.name, error)
}

fn read_golden(golden: &Input, input: Option<&std::path::Path>) -> Result<PvsReport, Failure> {
    let graph = match input {
        Some(path) => {
            let file = Input::read(path)?;
            let graph = read_graph(&file.name, &file.bytes)?;
            Some((file, graph))
        }
        None => None,
    };
    if !NpyMatrix::is_npy(&golden.bytes) {
        let report = golden.report()?;
        if let Some((file, _)) = graph
            && InputId::new("", &file.bytes).blake3 != report.input.blake3
        {
            let what = format!("the result is of another input than {}", file.name);
            return Err(Failure::file(&golden.name, what));
        }
        return Ok(report);
    }
    let Some((file, graph)) = graph else {
        let what = "an .npy result needs --input, the portal graph that it belongs to";
        return Err(Failure::usage(format!("{}: {what}", golden.name)));
    };
    let matrix = read_npy(golden)?;
    if matrix.size() != graph.cells.len() {
        let (got, expected) = (matrix.size(), graph.cells.len());
        let what = format!("a matrix of {got} cells, but {} has {expected}", file.name);
        return Err(Failure::file(&golden.name, what));
    }
    Ok(PvsReport {
        program: String::new(),
        input: InputId::new(&file.file_name(), &file.bytes),
        reading: String::new(),
        grazing_classified: matrix.counts().grazing > 0,
        leaf_to_cell: graph.leaf_to_cell.iter().map(|cell| cell.0).collect(),
        cells: graph.cells,
        skew_portals: graph.skew_portals,
        matrix,
        witnesses: Vec::new(),
    })
}

fn read_candidate(file: &Input, golden: &PvsReport, policy: Policy) -> Result<Candidate, Failure> {
    let fail = |what: &dyn std::fmt::Display| Failure::file(&file.name, what);
    if NpyMatrix::is_npy(&file.bytes) {
        let matrix = read_npy(file)?;
        let counts = matrix.counts();
        // A cell is open to itself, so a coded matrix has twos: without any, these are flags.
        let presence = if counts.open + counts.undecided == 0 {
            let flags = matrix.entries().iter().map(|&v| v == Verdict::Grazing).collect();
            Presence::from_flags(matrix.size(), flags)
                .ok_or_else(|| fail(&"expected a square matrix"))?
        } else {
            check::presence(&matrix, policy)
        };
        return Ok(Candidate { presence, kind: "npy".to_owned(), rows_missing: 0 });
    }
    if file.map.is_some() {
        let (table, kind) = doom::shipped_table(&doom::map_of(file)?);
        let sectors = table.sectors();
        let pairs =
            (0..sectors * sectors).map(|pair| !table.rejects(pair / sectors, pair % sectors));
        let presence = Presence::from_flags(sectors, pairs.collect())
            .ok_or_else(|| fail(&"expected a square matrix"))?;
        return Ok(Candidate { presence, kind, rows_missing: 0 });
    }
    if Visibility::is_bsp(&file.bytes) {
        let level = Visibility::read(&file.bytes).map_err(|error| fail(&error))?;
        let sees = |from: usize, to: usize| level.matrix.get(from, to);
        let leafs = level.matrix.size();
        let cells = golden.cells.len();
        let presence = Presence::from_leafs(cells, &golden.leaf_to_cell, leafs, sees)
            .map_err(|error| other_scene(file, &error))?;
        let (kind, rows_missing) = (level.format.to_string(), level.rows_missing);
        return Ok(Candidate { presence, kind, rows_missing });
    }
    if file.bytes.trim_ascii_start().first() == Some(&b'{') {
        let report = file.report()?;
        if report.input.blake3 != golden.input.blake3 {
            let what = format!(
                "a result of another input ({}, BLAKE3 {}…), expected {} ({}…)",
                report.input.name,
                &report.input.blake3[..8],
                golden.input.name,
                &golden.input.blake3[..8]
            );
            return Err(fail(&what));
        }
        let presence = check::presence(&report.matrix, policy);
        return Ok(Candidate { presence, kind: report.program, rows_missing: 0 });
    }
    Err(match file.bytes.is_empty() {
        true => fail(&"the file is empty, expected a result, an .npy matrix or a .bsp level"),
        false => fail(&"not a result, an .npy matrix or a .bsp level of a known format"),
    })
}

/// Reads a square matrix of verdicts.
fn read_npy(file: &Input) -> Result<Matrix, Failure> {
    let npy = NpyMatrix::read(&file.bytes).map_err(|error| Failure::file(&file.name, error))?;
    if npy.rows != npy.columns {
        let what = format!("expected a square matrix, got {} x {}", npy.rows, npy.columns);
        return Err(Failure::file(&file.name, what));
    }
    let mut entries = Vec::with_capacity(npy.entries.len());
    for (index, &code) in npy.entries.iter().enumerate() {
        let Some(verdict) = Verdict::from_code(code) else {
            let (row, column) = (index / npy.columns, index % npy.columns);
            let what = format!("entry ({row}, {column}): expected 0 to 3, got {code}");
            return Err(Failure::file(&file.name, what));
        };
        entries.push(verdict);
    }
    Matrix::from_entries(npy.rows, entries)
        .ok_or_else(|| Failure::file(&file.name, "expected a square matrix"))
}
