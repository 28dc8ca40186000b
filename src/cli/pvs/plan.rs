//! `stabline pvs` on floorplans.

use super::super::exit::{Exit, Failure};
use super::super::files::{self, Input};
use super::super::plan::{self, Planar};
use super::summary::{self, Clock};
use super::{Args, on_threads};
use crate::pvs::plan::{Groups, PlanSight, plan_matrix, plan_sights};
use crate::pvs::{self, Options};
use crate::report::{InputId, Matrix, PairWitness, Progress, PvsReport, WitnessLine};
use crate::scene::plan::PlanGraph;

/// Computes and writes what was asked for.
pub(super) fn run(
    args: &Args,
    mut clock: Clock,
    input: &Input,
    writes_to_stdout: bool,
) -> Result<Exit, Failure> {
    refuse_parts(args)?;
    let planar = on_threads(args, |watch| plan::read(input, &args.plan, watch))??;
    clock.lap("read");
    let wants_witnesses = args.output.is_some() && !args.no_witness;
    let graph = planar.graph();
    let found = on_threads(args, |watch| sights(&planar, wants_witnesses, watch))?;
    let Some((matrix, witnesses)) = found else { return Err(Failure::Interrupted) };
    clock.lap("search");
    let report = PvsReport {
        program: PvsReport::this_program(),
        input: InputId::new(&input.file_name(), &input.bytes),
        reading: args.plan.stated(),
        grazing_classified: false,
        cells: graph.cells.clone(),
        leaf_to_cell: (0..graph.cells.len() as u32).collect(),
        skew_portals: 0,
        matrix,
        witnesses: if wants_witnesses { witnesses } else { Vec::new() },
    };
    if let Some(npy) = &args.npy {
        let bytes = report.matrix.to_npy();
        files::write(Some(npy), |out| out.write_all(&bytes))?;
    }
    if let Some(output) = &args.output {
        files::write(Some(output), |out| report.write(out))?;
    }
    clock.lap("write");
    if !writes_to_stdout && (args.json || (args.output.is_none() && args.npy.is_none())) {
        files::print(&summary::plan_summary(graph, &report, args.json))?;
    }
    if args.stats {
        summary::print_times(&clock);
    }
    Ok(Exit::Done)
}

/// A plan is decided whole and in one go.
fn refuse_parts(args: &Args) -> Result<(), Failure> {
    let parts = [
        (args.shard.is_some(), "--shard"),
        (!args.merge.is_empty(), "--merge"),
        (args.resume.is_some(), "--resume"),
        (args.budget.is_some(), "--budget"),
    ];
    match parts.iter().find(|(is_stated, _)| *is_stated) {
        Some((_, name)) => Err(Failure::usage(format!(
            "{name}: a floorplan is decided whole, vertex by vertex, so there are no parts of it"
        ))),
        None => Ok(()),
    }
}

/// `None` if interrupted.
pub(in crate::cli) type Found = Option<(Matrix, Vec<PairWitness>)>;

/// Which cells see which, and lines that show it where they are wanted.
pub(in crate::cli) fn sights(
    planar: &Planar,
    wants_witnesses: bool,
    progress: &dyn Progress,
) -> Found {
    match planar {
        Planar::Divided { cells, .. } => sweep(&cells.graph, wants_witnesses, progress),
        Planar::Graph(graph) => search(graph, progress),
    }
}

fn sweep(graph: &PlanGraph, wants_witnesses: bool, progress: &dyn Progress) -> Found {
    let crossings = graph.crossings();
    let groups = Groups::cells(graph.cells.len());
    if !wants_witnesses {
        return Some((plan_matrix(graph, &crossings, &groups, progress)?, Vec::new()));
    }
    let (matrix, sights) = plan_sights(graph, &crossings, &groups, progress)?;
    Some((matrix, sights.into_iter().map(witness).collect()))
}

fn witness(sight: PlanSight) -> PairWitness {
    let PlanSight { from, to, portals, line } = sight;
    PairWitness { from, to, portals, line: WitnessLine::Plane(line) }
}

/// A stated graph need not lie in the plane as a whole; its sequences are searched as those of
/// portals with a height of 1, which the same lines pass.
fn search(graph: &PlanGraph, progress: &dyn Progress) -> Found {
    let space = graph.in_space();
    let done = pvs::compute(&space, &Options::default(), Vec::new(), &|_| {}, progress);
    if !done.is_complete {
        return None;
    }
    let flat = |witness: PairWitness| {
        let line = witness.line.in_space().clone().map(|[x, y, _]| [x, y]);
        PairWitness { line: WitnessLine::Plane(line), ..witness }
    };
    let witnesses = pvs::witnesses(&done.rows).into_iter().map(flat).collect();
    Some((pvs::assemble(&space, &done.rows), witnesses))
}
