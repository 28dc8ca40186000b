//! `--objects`: which cells see which detail objects, or objects and regions of a floorplan.

use super::super::exit::Failure;
use super::super::files::Input;
use super::super::plan::Planar;
use super::super::world::{self, WorldArgs};
use super::{Args, on_threads};
use crate::portal::Population;
use crate::pvs::plan::plan_object_sights;
use crate::pvs::{self, ObjectSight};
use crate::report::{
    Matrix, ObjectEntry, ObjectWitness, ObjectsReport, Progress, PvsReport, Verdict,
};
use crate::scene::world::Object;
use crate::scene::{ObjectGraph, PortalGraph};

/// How cells are ruled out.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(super) enum Method {
    /// What is seen is decided exactly
    Exact,
    /// What the upper bound rules out is not seen; the rest is left undecided
    Conservative,
}

/// Objects in a graph's cells.
pub(super) struct Objects {
    stated: Vec<Object>,
    graph: ObjectGraph,
}

/// The cells of a world, and the objects in them.
pub(super) fn read(
    input: &Input,
    args: &WorldArgs,
    progress: &dyn Progress,
) -> Result<(PortalGraph, Objects), Failure> {
    if !world::is_world(input) {
        return Err(Failure::usage(format!(
            "--objects: {} is a portal graph, which states no objects; expected a world",
            input.name
        )));
    }
    let (stated, mut cells) = world::divided(input, args, progress)?;
    let graph = Population::of(&stated.objects, &mut cells)
        .graph(&stated.objects, &cells.graph)
        .map_err(|error| Failure::file(&input.name, error))?;
    Ok((cells.graph, Objects { stated: stated.objects, graph }))
}

impl Objects {
    /// Which cells see them; `None` if interrupted.
    pub(super) fn compute(
        &self,
        args: &Args,
        report: &PvsReport,
    ) -> Result<Option<ObjectsReport>, Failure> {
        let found = match args.objects_method {
            Method::Exact => self.exact(args, &report.matrix)?,
            Method::Conservative => {
                let rows = on_threads(args, |watch| pvs::bound_objects(&self.graph, watch))?;
                rows.map(|rows| (rows, Vec::new()))
            }
        };
        let Some((rows, witnesses)) = found else { return Ok(None) };
        let entries = self.stated.iter().zip(&self.graph.held_by).map(|(object, cells)| {
            let cells = cells.iter().map(|cell| cell.0).collect();
            ObjectEntry::new(&object.place.name, object.place.line, &object.bounds, cells)
        });
        Ok(Some(ObjectsReport::new(
            report,
            match args.objects_method {
                Method::Exact => "exact",
                Method::Conservative => "conservative",
            },
            entries.collect(),
            &rows,
            witnesses,
        )))
    }

    fn exact(&self, args: &Args, known: &Matrix) -> Result<Option<Found>, Failure> {
        let found =
            on_threads(args, |watch| pvs::compute_objects(&self.graph, known, args.budget, watch))?;
        if !found.is_complete {
            return Ok(None);
        }
        let rows = pvs::assemble_objects(&self.graph, &found.rows);
        let witnesses = match args.no_witness {
            true => Vec::new(),
            false => pvs::object_sights(&self.graph, &found.rows).iter().map(witness).collect(),
        };
        Ok(Some((rows, witnesses)))
    }
}

/// The verdicts, and the witnesses.
type Found = (Vec<Vec<Verdict>>, Vec<ObjectWitness>);

fn witness(ObjectSight { object, cell, pair }: &ObjectSight) -> ObjectWitness {
    // The last portal is where the line enters the object.
    let (_, portals) = pair.portals.split_last().expect("a line into an object crosses its face");
    ObjectWitness::new(*object, cell.0, portals.to_vec(), &pair.line.numbers())
}

/// Which cells of a floorplan see its objects and regions; `None` if interrupted.
pub(super) fn of_plan(
    args: &Args,
    input: &Input,
    planar: &Planar,
    report: &PvsReport,
) -> Result<Option<ObjectsReport>, Failure> {
    let (plan, graph) = match planar {
        Planar::Divided { plan, cells, level: None } => (plan, &cells.graph),
        Planar::Divided { level: Some(_), .. } => return Err(states_none(input, "a Doom level")),
        Planar::Graph(_) => return Err(states_none(input, "a portal graph")),
    };
    let found = on_threads(args, |watch| {
        let crossings = graph.crossings();
        plan_object_sights(graph, &crossings, &plan.objects, !args.no_witness, watch)
    })?;
    let Some(found) = found else { return Ok(None) };
    let entries = plan.objects.iter().zip(&found.held_by).map(|(object, cells)| {
        let (polygon, cells) = (object.in_world(&plan.grid), cells.iter().map(|cell| cell.0));
        ObjectEntry::of_plan(&object.name, &polygon, cells.collect())
    });
    let sights = found.sights.into_iter();
    let witnesses =
        sights.map(|s| ObjectWitness::new(s.object, s.cell.0, s.portals, &s.line)).collect();
    let (entries, rows) = (entries.collect(), &found.verdicts);
    Ok(Some(ObjectsReport::new(report, "exact", entries, rows, witnesses)))
}

fn states_none(input: &Input, what: &str) -> Failure {
    Failure::usage(format!(
        "--objects: {} is {what}, which states no objects; expected a floorplan",
        input.name
    ))
}

/// One line that says what was found.
pub(super) fn summary(report: &ObjectsReport) -> String {
    let counts = report.counts();
    let mut text = format!(
        "{} objects, {} of them in no cell; pairs of an object and a cell: {} seen ({} inside), \
         {} not seen",
        report.objects(),
        counts.nowhere,
        counts.seen,
        counts.inside,
        counts.not_seen,
    );
    if counts.undecided > 0 {
        text += &format!(", {} undecided", counts.undecided);
    }
    text + "\n"
}
