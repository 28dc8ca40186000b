//! `stabline pvs` on floorplans.

use super::super::doom::{self, DoomLevel};
use super::super::exit::{Exit, Failure};
use super::super::files::{self, Input};
use super::super::plan::{self, Planar};
use super::summary::{self, Clock};
use super::{Args, CellsArg, objects, on_threads, proof, tree};
use crate::pvs::plan::{
    Cover, PlanSight, PlanTouch, classify_plan_grazing, plan_matrix, plan_sights,
};
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
    super::refuse_doom_options(args, input.map.is_some())?;
    let planar = on_threads(args, |watch| plan::read(input, &args.plan, watch))??;
    clock.lap("read");
    refuse_proof_of_sectors(args, &planar)?;
    if sectors_asked(args, &planar).is_none() && planar.graph().cells.len() > MOST_CELLS {
        return only_trees(args, input, &planar);
    }
    let wants_witnesses = args.output.is_some() && !args.no_witness;
    let wants = Wants { witnesses: wants_witnesses || args.proof.is_some(), grazing: args.grazing };
    let level = sectors_asked(args, &planar);
    let Sights { matrix, witnesses, touches } =
        on_threads(args, |watch| sights(&planar, level, wants, watch))?
            .ok_or(Failure::Interrupted)?;
    clock.lap("search");
    let cells = match level {
        Some(level) => (0..level.sectors).map(|sector| sector.to_string()).collect(),
        None => planar.graph().cells.clone(),
    };
    let mut report = PvsReport {
        program: PvsReport::this_program(),
        input: identified(args, input),
        reading: reading(args),
        grazing_classified: args.grazing,
        leaf_to_cell: (0..cells.len() as u32).collect(),
        cells,
        skew_portals: 0,
        matrix,
        witnesses,
    };
    let mut objects = None;
    if let Some(output) = &args.objects {
        let found = objects::of_plan(args, input, &planar, &report)?.ok_or(Failure::Interrupted)?;
        clock.lap("objects");
        files::write(Some(output), |out| found.write(out))?;
        objects = Some(found);
    }
    if let Some(output) = &args.stab_tree {
        let trees = tree::of_plan(args, &planar)?.ok_or(Failure::Interrupted)?;
        clock.lap("stab trees");
        trees.write_to(output, &report.input, args.stats)?;
    }
    if let Some(folder) = &args.proof {
        if !proof::write_of_plan(args, folder, planar.graph(), &report, &touches)? {
            return Err(Failure::Interrupted);
        }
        clock.lap("proof");
    }
    if !wants_witnesses {
        report.witnesses.clear();
    }
    write(args, &report)?;
    clock.lap("write");
    let is_written = [&args.output, &args.npy, &args.reject].iter().any(|path| path.is_some());
    if !writes_to_stdout && (args.json || !is_written) {
        files::print(&summary::plan_summary(&planar, &report, objects.as_ref(), args.json))?;
    }
    if args.stats {
        summary::print_times(&clock);
    }
    Ok(Exit::Done)
}

/// The most cells that are decided pair by pair: their table takes 2.1 GB, their matrix 1.1 GB.
const MOST_CELLS: usize = 1 << 15;

/// Writes the stab trees of a plan that has too many cells for a matrix.
fn only_trees(args: &Args, input: &Input, planar: &Planar) -> Result<Exit, Failure> {
    let needs_matrix = [&args.output, &args.npy, &args.objects].iter().any(|path| path.is_some());
    let Some(output) = args.stab_tree.as_ref().filter(|_| !needs_matrix && !args.grazing) else {
        return Err(Failure::file(
            &input.name,
            format!(
                "{} cells, more than the {MOST_CELLS} that are decided pair by pair; --stab-tree \
                 alone writes what each cell sees",
                planar.graph().cells.len()
            ),
        ));
    };
    let trees = tree::of_plan(args, planar)?.ok_or(Failure::Interrupted)?;
    let id = InputId::new(&input.file_name(), &input.bytes);
    trees.write_to(output, &id, args.stats)?;
    Ok(Exit::Done)
}

/// What identifies the input; its hash only where something that is written states it, since an
/// archive is large and a level of it small.
fn identified(args: &Args, input: &Input) -> InputId {
    let stated = [&args.output, &args.stab_tree, &args.objects, &args.proof]
        .iter()
        .any(|path| path.is_some());
    match stated || args.json {
        true => InputId::new(&input.file_name(), &input.bytes),
        false => InputId { name: input.file_name(), blake3: String::new() },
    }
}

/// The Doom level whose sectors are asked about, if they are.
fn sectors_asked<'p>(args: &Args, planar: &'p Planar) -> Option<&'p DoomLevel> {
    planar.level().filter(|_| args.cells == CellsArg::Sectors)
}

/// The options that are not the default, as they are written.
fn reading(args: &Args) -> String {
    let cells = match args.cells {
        CellsArg::Sectors => "",
        CellsArg::Subsectors => "--cells subsectors",
    };
    [cells, &args.plan.stated()].join(" ").trim().to_owned()
}

fn write(args: &Args, report: &PvsReport) -> Result<(), Failure> {
    if let Some(reject) = &args.reject {
        let table = doom::reject_table(&report.matrix);
        files::write(Some(reject), |out| out.write_all(table.bytes()))?;
    }
    super::write(args, report)
}

/// Sectors are no cells: they have no portals of their own.
fn refuse_proof_of_sectors(args: &Args, planar: &Planar) -> Result<(), Failure> {
    match args.proof.is_some() && sectors_asked(args, planar).is_some() {
        true => Err(Failure::usage("--proof: it is of cells; expected --cells subsectors")),
        false => Ok(()),
    }
}

/// A plan is decided whole and in one go.
fn refuse_parts(args: &Args) -> Result<(), Failure> {
    let parts = [
        (args.shard.is_some(), "--shard"),
        (!args.merge.is_empty(), "--merge"),
        (args.resume.is_some(), "--resume"),
        (args.budget.is_some(), "--budget"),
        (args.objects_method == objects::Method::Conservative, "--objects-method conservative"),
    ];
    match parts.iter().find(|(is_stated, _)| *is_stated) {
        Some((_, name)) => Err(Failure::usage(format!(
            "{name}: a floorplan is decided whole, vertex by vertex, so there are no parts of it"
        ))),
        None => Ok(()),
    }
}

/// What was found of a plan.
pub(in crate::cli) struct Sights {
    /// The verdicts.
    pub(in crate::cli) matrix: Matrix,
    /// A line for each open pair, if wanted.
    pub(in crate::cli) witnesses: Vec<PairWitness>,
    /// A line for each grazing pair of cells, or of the sets of cells that make up sectors.
    touches: Vec<PlanTouch>,
}

/// What is asked for besides open or not open.
#[derive(Clone, Copy)]
pub(in crate::cli) struct Wants {
    /// A line for each open pair.
    pub(in crate::cli) witnesses: bool,
    /// Which of the other pairs are grazing.
    pub(in crate::cli) grazing: bool,
}

/// Which cells see which, or which sectors of a level; `None` if interrupted.
pub(in crate::cli) fn sights(
    planar: &Planar,
    sectors_of: Option<&DoomLevel>,
    wants: Wants,
    progress: &dyn Progress,
) -> Option<Sights> {
    let graph = planar.graph();
    let cover = match sectors_of {
        Some(level) => level.cover(),
        None => Cover::cells(graph.cells.len()),
    };
    let (crossings, groups) = (graph.crossings(), cover.groups());
    let (mut matrix, witnesses) = match planar {
        Planar::Graph(graph) => search(graph, progress)?,
        Planar::Divided { .. } if wants.witnesses => {
            let (matrix, sights) = plan_sights(graph, &crossings, groups, &|_, _| true, progress)?;
            (matrix, cover.sights(graph, sights).into_iter().map(witness).collect())
        }
        Planar::Divided { .. } => (plan_matrix(graph, &crossings, groups, progress)?, Vec::new()),
    };
    let touches = match wants.grazing {
        true => classify_plan_grazing(graph, &crossings, groups, &mut matrix, progress)?,
        false => Vec::new(),
    };
    Some(Sights { matrix: cover.matrix(matrix), witnesses, touches })
}

fn witness(sight: PlanSight) -> PairWitness {
    let PlanSight { from, to, portals, line } = sight;
    PairWitness { from, to, portals, line: WitnessLine::Plane(line) }
}

/// A stated graph need not lie in the plane as a whole; its sequences are searched as those of
/// portals with a height of 1, which the same lines pass.
fn search(graph: &PlanGraph, progress: &dyn Progress) -> Option<(Matrix, Vec<PairWitness>)> {
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
