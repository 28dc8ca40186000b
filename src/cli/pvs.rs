//! `stabline pvs`: cell-to-cell visibility.

mod keep;
mod objects;
pub(super) mod plan;
mod proof;
mod summary;
mod tree;

use super::exit::{Exit, Failure};
use super::files::{self, Input};
use super::plan::PlanArgs;
use super::progress::{MemoryLimit, ProgressArgs, Watch};
use super::world::{self, WorldArgs};
use crate::pvs::{self, Finished, Options, PartHeader, Shard};
use crate::report::{InputId, ObjectsReport, ProvedGrazing, PvsReport};
use crate::scene::PortalGraph;
use keep::Keeper;
use std::path::PathBuf;

/// Compute which cells see which, exactly, with a sightline for every open pair
///
/// INPUT is a portal file (`.prt`), a JSON scene, a level's source (`.map`), polygons (`.obj`,
/// `.gltf`, `.glb`), a floorplan in JSON, or a Doom level (`FILE.wad:MAP01`). Without an output a
/// summary is printed; `-o -` prints the whole result.
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    /// A portal graph, or geometry to be divided into cells
    input: PathBuf,
    /// Write the result (`stabline-pvs/1`) to a file
    #[arg(short, long, value_name = "OUT.json")]
    output: Option<PathBuf>,
    /// Write the matrix as an n x n array of bytes
    #[arg(long, value_name = "OUT.npy")]
    npy: Option<PathBuf>,
    /// Write the stab trees: every open portal sequence from each cell, with a sightline
    #[arg(long, value_name = "OUT.json")]
    stab_tree: Option<PathBuf>,
    /// What the cells of a Doom level are
    #[arg(long, value_enum, default_value = "sectors")]
    cells: CellsArg,
    /// Write the exact REJECT lump of a Doom level to a file
    #[arg(long, value_name = "OUT.lmp")]
    reject: Option<PathBuf>,
    /// Write the proof (`stabline-proof/1`) to a folder: what `stabline verify` checks
    #[arg(long, value_name = "DIR", conflicts_with = "shard")]
    proof: Option<PathBuf>,
    /// Only the stab trees of these cells, by number
    #[arg(long, value_name = "CELL", num_args = 1.., requires = "stab_tree")]
    from: Vec<u32>,
    /// Write which cells see which detail objects (`stabline-objects/1`) to a file
    #[arg(long, value_name = "OUT.json", conflicts_with = "shard")]
    objects: Option<PathBuf>,
    /// How the pairs of a cell and an object are decided
    #[arg(long, value_enum, value_name = "METHOD", default_value = "exact", requires = "objects")]
    objects_method: objects::Method,
    /// Split the pairs that are not open into grazing and blocked (for hundreds of cells; on
    /// larger graphs with --budget, which leaves some undecided)
    #[arg(long)]
    grazing: bool,
    /// Leave the witnesses out of the result
    #[arg(long)]
    no_witness: bool,
    /// How many threads work [default: one a processor]
    #[arg(long, value_name = "N")]
    threads: Option<usize>,
    /// The most portal sequences to visit for one source cell; what is not settled by then is
    /// undecided
    #[arg(long, value_name = "SEQUENCES")]
    budget: Option<u64>,
    /// Compute only every N-th source cell, from the I-th on; the output is a part, for `--merge`
    #[arg(long, value_name = "I/N", value_parser = parse_shard)]
    shard: Option<Shard>,
    /// Take over the finished cells of these parts
    #[arg(long, value_name = "PART", num_args = 1..)]
    merge: Vec<PathBuf>,
    /// Keep finished cells in this folder, and go on from those that are there
    #[arg(long, value_name = "DIR")]
    resume: Option<PathBuf>,
    /// End as an interruption, with the finished cells kept, before using more memory than this
    /// (such as 500M or 4G)
    #[arg(long, value_name = "BYTES", value_parser = parse_bytes)]
    memory_limit: Option<MemoryLimit>,
    /// Print the summary as JSON
    #[arg(long)]
    json: bool,
    /// Print times, memory and how pairs were settled, to standard error
    #[arg(long)]
    stats: bool,
    #[command(flatten)]
    world: WorldArgs,
    #[command(flatten)]
    plan: PlanArgs,
    #[command(flatten)]
    progress: ProgressArgs,
}

/// The option `--cells`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum CellsArg {
    /// Its sectors: a pair is open if any of their leaves are
    Sectors,
    /// The convex leaves that it is divided into
    Subsectors,
}

fn parse_shard(text: &str) -> Result<Shard, String> {
    let expected = || format!("expected I/N with I from 1 to N, not {text:?}");
    let (index, count) = text.split_once('/').ok_or_else(expected)?;
    let number = |text: &str| text.parse::<u32>().map_err(|_| expected());
    let (index, count) = (number(index)?, number(count)?);
    if index == 0 || index > count {
        return Err(expected());
    }
    Ok(Shard { index: index - 1, count })
}

fn parse_bytes(text: &str) -> Result<MemoryLimit, String> {
    let digits = text.trim_end_matches(['k', 'K', 'M', 'G', 'T']);
    let unit: u64 = match &text[digits.len()..] {
        "" => 1,
        "k" | "K" => 1 << 10,
        "M" => 1 << 20,
        "G" => 1 << 30,
        "T" => 1 << 40,
        _ => 0,
    };
    let bytes = digits.parse::<u64>().ok().and_then(|bytes| bytes.checked_mul(unit));
    match bytes {
        Some(bytes) if bytes > 0 => Ok(MemoryLimit(bytes)),
        Some(_) | None => Err(format!("expected a size such as 500M or 4G, not {text:?}")),
    }
}

pub(super) fn run(args: Args) -> Result<Exit, Failure> {
    let mut clock = summary::Clock::start();
    let outputs = [&args.output, &args.npy, &args.stab_tree, &args.objects, &args.reject];
    let writes_to_stdout = files::check_outputs(outputs)?;
    let input = Input::read(&args.input)?;
    if super::plan::is_plan(&input) {
        return plan::run(&args, clock, &input, writes_to_stdout);
    }
    refuse_doom_options(&args, false)?;
    let watch = Watch::new(args.progress.reporter(), args.memory_limit);
    let (graph, objects) = match &args.objects {
        None => (world::read_graph(&input, &args.world, &watch)?, None),
        Some(_) => objects::read(&input, &args.world, &watch).map(|(a, b)| (a, Some(b)))?,
    };
    drop(watch);
    let header = part_header(&args, &input);
    clock.lap("read");
    let keeper = Keeper::open(&args, &header, &graph)?;
    let finished = compute(&args, &graph, &keeper)?;
    clock.lap("search");
    keeper.check()?;
    if !finished.is_complete {
        return keeper.interrupted(&args, &header, &finished);
    }
    if args.shard.is_some() {
        keep::write_part(args.output.as_deref(), &header, &finished.rows)?;
        return Ok(Exit::Done);
    }
    let mut report = report(&args, &graph, header, &finished);
    clock.lap("assemble");
    let mut grazing = Vec::new();
    if args.grazing {
        let Some(lines) = classify_grazing(&args, &graph, &mut report)? else {
            return keeper.interrupted(&args, &part_header(&args, &input), &finished);
        };
        grazing = lines;
    }
    let objects = match objects.map(|objects| objects.compute(&args, &report)).transpose()? {
        None => None,
        Some(None) => return keeper.interrupted(&args, &part_header(&args, &input), &finished),
        Some(Some(found)) => Some(found),
    };
    if let (Some(output), Some(objects)) = (&args.objects, &objects) {
        clock.lap("objects");
        files::write(Some(output), |out| objects.write(out))?;
    }
    if let Some(output) = &args.stab_tree {
        let Some(trees) = tree::of_graph(&args, &graph)? else {
            return keeper.interrupted(&args, &part_header(&args, &input), &finished);
        };
        clock.lap("stab trees");
        trees.write_to(output, &report.input, args.stats)?;
    }
    if let Some(folder) = &args.proof {
        if !proof::write(&args, folder, &graph, &report, &finished.rows, &grazing)? {
            return keeper.interrupted(&args, &part_header(&args, &input), &finished);
        }
        clock.lap("proof");
    }
    write(&args, &report)?;
    clock.lap("write");
    if !writes_to_stdout && (args.json || (args.output.is_none() && args.npy.is_none())) {
        files::print(&summary::summary(&graph, &report, objects.as_ref(), &finished, &args))?;
    }
    if args.stats {
        summary::print_stats(&clock, &graph, &finished);
    }
    Ok(if is_undecided(&args, &report, objects.as_ref()) { Exit::Undecided } else { Exit::Done })
}

/// Writes the result, whole and as a matrix, as far as it was asked for.
fn write(args: &Args, report: &PvsReport) -> Result<(), Failure> {
    if let Some(npy) = &args.npy {
        let bytes = report.matrix.to_npy();
        files::write(Some(npy), |out| out.write_all(&bytes))?;
    }
    match &args.output {
        Some(output) => files::write(Some(output), |out| report.write(out)),
        None => Ok(()),
    }
}

/// Whether a budget left something open that was asked for exactly.
fn is_undecided(args: &Args, report: &PvsReport, objects: Option<&ObjectsReport>) -> bool {
    let is_spent = |objects: &ObjectsReport| {
        args.objects_method == objects::Method::Exact && objects.counts().undecided > 0
    };
    report.matrix.counts().undecided > 0 || objects.is_some_and(is_spent)
}

/// Refuses options for Doom levels on other inputs.
fn refuse_doom_options(args: &Args, is_doom: bool) -> Result<(), Failure> {
    if !is_doom && (args.reject.is_some() || args.cells != CellsArg::Sectors) {
        return Err(Failure::usage("--reject and --cells are of Doom levels, FILE.wad:MAP01"));
    }
    if args.reject.is_some() && args.cells != CellsArg::Sectors {
        return Err(Failure::usage("--reject: a REJECT lump is of sectors, not of subsectors"));
    }
    Ok(())
}

fn part_header(args: &Args, input: &Input) -> PartHeader {
    PartHeader {
        program: PvsReport::this_program(),
        input: InputId::new(&input.file_name(), &input.bytes),
        // Of a portal graph these options change nothing.
        reading: if world::is_world(input) { args.world.stated() } else { String::new() },
        budget: args.budget,
    }
}

/// Runs `work` on the threads asked for, watched for interrupts.
fn on_threads<T: Send>(args: &Args, work: impl FnOnce(&Watch) -> T + Send) -> Result<T, Failure> {
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(args.threads.unwrap_or(0))
        .build()
        .map_err(|error| Failure::usage(format!("--threads: {error}")))?;
    let watch = Watch::new(args.progress.reporter(), args.memory_limit);
    Ok(pool.install(|| work(&watch)))
}

fn compute(args: &Args, graph: &PortalGraph, keeper: &Keeper) -> Result<Finished, Failure> {
    let shard = args.shard.unwrap_or_default();
    let options = Options { budget: args.budget, shard, ..Options::default() };
    let keep = |row: &_| keeper.keep(row);
    on_threads(args, |watch| pvs::compute(graph, &options, keeper.done(), &keep, watch))
}

/// The touching lines; `None` if interrupted.
fn classify_grazing(
    args: &Args,
    graph: &PortalGraph,
    report: &mut PvsReport,
) -> Result<Option<Vec<ProvedGrazing>>, Failure> {
    report.grazing_classified = true;
    let matrix = &mut report.matrix;
    on_threads(args, |watch| pvs::classify_grazing(graph, matrix, args.budget, watch))
}

fn report(args: &Args, graph: &PortalGraph, header: PartHeader, finished: &Finished) -> PvsReport {
    let wants_witnesses = args.output.is_some() && !args.no_witness;
    PvsReport {
        program: header.program,
        input: header.input,
        reading: header.reading,
        grazing_classified: false,
        cells: graph.cells.clone(),
        leaf_to_cell: graph.leaf_to_cell.iter().map(|cell| cell.0).collect(),
        skew_portals: graph.skew_portals,
        matrix: pvs::assemble(graph, &finished.rows),
        witnesses: if wants_witnesses { pvs::witnesses(&finished.rows) } else { Vec::new() },
    }
}
