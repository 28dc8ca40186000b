//! Floorplans: whatever is read is divided, and every pair that is called open has its line.
#![no_main]

use libfuzzer_sys::fuzz_target;
use stabline::portal::plan::cells_of_plan;
use stabline::pvs::plan::{Groups, plan_sights};
use stabline::report::Silent;
use stabline::scene::plan::{PlanInput, read_plan};
use stabline::subdivision::plan::{PlanMethod, divide};

/// Larger plans take longer and are no odder.
const MOST_SEGMENTS: usize = 12;

fuzz_target!(|bytes: &[u8]| {
    let Ok(PlanInput::Plan(plan)) = read_plan("x", bytes) else { return };
    if plan.segments.len() > MOST_SEGMENTS || plan.grid.bits() > 200 {
        return;
    }
    for method in [PlanMethod::Bsp, PlanMethod::Kd { threshold: Default::default() }] {
        let Ok(tree) = divide(&plan, &method, &Silent) else { continue };
        let Ok(cells) = cells_of_plan(&plan, tree, !plan.has_view) else { continue };
        let graph = &cells.graph;
        let groups = Groups::cells(graph.cells.len());
        let found = plan_sights(graph, &graph.crossings(), &groups, &|_, _| true, &Silent);
        let (matrix, sights) = found.expect("never interrupted");
        assert_eq!(matrix.counts().open as usize, graph.cells.len() + 2 * sights.len());
    }
});
