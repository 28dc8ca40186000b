//! `stabline bsp` on floorplans.

use super::super::exit::{Exit, Failure};
use super::super::files::{self, Input};
use super::super::plan::{self, Planar};
use super::super::progress::Watch;
use super::Args;
use crate::portal::plan::PlanCells;
use crate::report::{InputId, PlanCell, PlanCellPortal, PlanCrossing, PlanPosition, PlanReport};
use crate::scene::plan::Plan;

pub(super) fn run(args: &Args, input: &Input, writes_to_stdout: bool) -> Result<Exit, Failure> {
    refuse_space(args)?;
    let watch = Watch::new(args.progress.reporter(), None);
    let planar = plan::read(input, &args.plan, &watch)?;
    let Planar::Divided { plan, cells, .. } = &planar else {
        return Err(Failure::file(
            &input.name,
            "the graph states cells and portals already; expected a floorplan",
        ));
    };
    drop(watch);
    let id = InputId::new(&input.file_name(), &input.bytes);
    let report = PlanReport { reading: args.plan.stated(), ..report(id, plan, cells) };
    if let Some(path) = &args.cells {
        files::write(Some(path), |out| report.write(out))?;
    }
    if writes_to_stdout {
        return Ok(Exit::Done);
    }
    match args.json {
        true => files::write(None, |out| report.write(out))?,
        false => files::print(&report.to_text())?,
    }
    Ok(Exit::Done)
}

/// Refuses what has no meaning in the plane.
fn refuse_space(args: &Args) -> Result<(), Failure> {
    let of_space = [
        (args.prt.is_some(), "--prt"),
        (args.pts.is_some(), "--pts"),
        (args.painter.is_some(), "--painter"),
        (args.check, "--check"),
        (args.stats, "--stats"),
    ];
    match of_space.iter().find(|(is_stated, _)| *is_stated) {
        Some((_, name)) => {
            Err(Failure::usage(format!("{name}: for scenes in space, not for floorplans")))
        }
        None => Ok(()),
    }
}

fn report(id: InputId, plan: &Plan, cells: &PlanCells) -> PlanReport {
    let PlanCells { tree, graph, meets, .. } = cells;
    let position = |point: u32| -> PlanPosition { graph.world(point).map(|c| c.to_string()) };
    let source = |segment: u32| plan.segments[segment as usize].source;
    let crossings = graph.crossings();
    let cell = |(number, name): (usize, &String)| PlanCell {
        name: name.clone(),
        polygon: graph.polygons[number].iter().map(|&corner| position(corner)).collect(),
        portals: crossings
            .from(crate::scene::CellId(number as u32))
            .iter()
            .map(|way| way.portal)
            .collect(),
    };
    PlanReport {
        segments: plan.segments.len(),
        zero_length: plan.repairs.zero_length.clone(),
        overlapping: meets.overlapping.iter().map(|pair| pair.map(source)).collect(),
        crossing: meets
            .crossing
            .iter()
            .map(|(pair, at)| PlanCrossing { segments: pair.map(source), at: position(*at) })
            .collect(),
        left_inside: tree.left_inside.iter().map(|&segment| source(segment)).collect(),
        leaves: tree.leaves.len(),
        depth: tree.depth(),
        cells: graph.cells.iter().enumerate().map(cell).collect(),
        portals: graph
            .portals
            .iter()
            .map(|portal| PlanCellPortal {
                from: portal.from.0,
                to: portal.to.0,
                segment: [portal.left, portal.right].map(position),
            })
            .collect(),
        ..PlanReport::of(id)
    }
}
