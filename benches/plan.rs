//! How the work on floorplans grows: from a text to all stab trees, sizes doubling.
//!
//! `cargo bench --bench plan -- --table` prints a table for plans that are made up, up to 128 000
//! faces or as many as `-- --table FACES` says: the seconds of reading, of the k-D tree and the BSP
//! tree, of portals and of all stab trees; and for both trees the factor for twice the faces beside
//! that of n lg n. `general` plans have walls of any direction, so that no k-D tree divides them.
//! Stab trees are told with their vertices, and the time for each of these.

use criterion::Criterion;
use stabline::portal::plan::{PlanCells, cells_of_plan};
use stabline::pvs::plan::plan_tree_sizes;
use stabline::report::Silent;
use stabline::scene::CellId;
use stabline::scene::plan::{
    FloorplanOptions, Plan, PlanInput, RawPlan, generate_floorplan, read_plan,
};
use stabline::subdivision::plan::{PlanMethod, PlanTree, divide};
use std::hint::black_box;
use std::time::Instant;

fn generated(faces: usize, is_general: bool) -> RawPlan {
    generate_floorplan(&FloorplanOptions { faces, seed: 1, is_general })
}

/// A plan as a scene in JSON.
fn text(raw: &RawPlan) -> String {
    let ends = raw.segments.iter().map(|segment| {
        let [[a, b], [c, d]] = &segment.ends;
        format!("[[{a},{b}],[{c},{d}]]")
    });
    let segments = ends.collect::<Vec<_>>().join(",");
    format!(r#"{{"format":"stabline-scene/1","about":"made up","segments":[{segments}]}}"#)
}

fn read(text: &str) -> Plan {
    match read_plan("made up", text.as_bytes()).expect("a made-up plan breaks no rule") {
        PlanInput::Plan(plan) => *plan,
        PlanInput::Graph(_) => unreachable!("it states segments"),
    }
}

fn kd() -> PlanMethod {
    PlanMethod::Kd { threshold: Default::default() }
}

fn tree(plan: &Plan, method: &PlanMethod) -> PlanTree {
    divide(plan, method, &Silent).expect("nothing interrupts, and the k-D tree gets axial plans")
}

fn cells(plan: &Plan, tree: PlanTree) -> PlanCells {
    cells_of_plan(plan, tree, false).expect("no mark, no leak")
}

/// The vertices of all stab trees, the cells themselves included.
fn vertices(cells: &PlanCells) -> u64 {
    let sources: Vec<CellId> = (0..cells.graph.cells.len() as u32).map(CellId).collect();
    let crossings = cells.graph.crossings();
    let sizes = plan_tree_sizes(&cells.graph, &crossings, &sources, &Silent);
    sizes.expect("nothing interrupts").iter().map(|size| size.nodes + 1).sum()
}

fn seconds<T>(work: impl FnOnce() -> T) -> (T, f64) {
    let start = Instant::now();
    let result = work();
    (result, start.elapsed().as_secs_f64())
}

fn table(largest: usize) {
    println!(
        "kind       faces   cells depth    read    tree grown n lg n portals   trees vertices ns each"
    );
    for (kind, is_general, method) in
        [("kd", false, kd()), ("bsp", false, PlanMethod::Bsp), ("general", true, PlanMethod::Bsp)]
    {
        let mut before: Option<(usize, f64)> = None;
        let mut faces = 1000;
        while faces <= largest {
            let text = text(&generated(faces, is_general));
            let (plan, reading) = seconds(|| read(&text));
            let (divided, dividing) = seconds(|| tree(&plan, &method));
            let depth = divided.depth();
            let (cells, enumerating) = seconds(|| cells(&plan, divided));
            let (vertices, searching) = seconds(|| vertices(&cells));
            let size = |n: usize| n as f64 * (n as f64).log2();
            let grown = before.map_or("    -      -".to_owned(), |(n, time)| {
                format!("{:>5.2} {:>6.2}", dividing / time, size(faces) / size(n))
            });
            before = Some((faces, dividing));
            println!(
                "{kind:<8}{:>8}{:>8}{depth:>6}{reading:>8.3}{dividing:>8.3} {grown}{enumerating:>8.3}\
                 {searching:>8.3}{vertices:>9}{:>8.0}",
                plan.segments.len(),
                cells.graph.cells.len(),
                searching * 1e9 / vertices as f64,
            );
            faces *= 2;
        }
    }
}

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    if let Some(at) = arguments.iter().position(|argument| argument == "--table") {
        let largest = arguments.get(at + 1).and_then(|argument| argument.parse().ok());
        return table(largest.unwrap_or(128_000));
    }
    let mut criterion = Criterion::default().sample_size(10).configure_from_args();
    for faces in [1000, 2000, 4000] {
        let text = text(&generated(faces, false));
        let plan = read(&text);
        for (name, method) in [("kd", kd()), ("bsp", PlanMethod::Bsp)] {
            criterion.bench_function(&format!("plan/{name}/{faces}"), |bencher| {
                bencher.iter(|| black_box(tree(&plan, &method)));
            });
        }
        criterion.bench_function(&format!("plan/text to stab trees/{faces}"), |bencher| {
            bencher.iter(|| {
                let plan = read(black_box(&text));
                let divided = tree(&plan, &kd());
                vertices(&cells(&plan, divided))
            });
        });
    }
    criterion.final_summary();
}
