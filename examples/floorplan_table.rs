//! The table of Teller and Séquin 1991, §5, on a floorplan that is made up.
//!
//! `cargo run --release --example floorplan_table [-- FACES SEED QUERIES]`, by default 1000, 3 and
//! 10000; other seeds are other buildings, whose great halls make the mean visibility differ. The
//! plan is that of `stabline generate floorplan`, the subdivision the k-D tree of §2.3 without a
//! threshold. Eyes are anywhere in the building with equal probability, as are the directions in
//! which they look; 60 degrees are a half-tangent of 97/168, rounded outward (60.002 degrees).
//! Areas are exact for each query, and means of them are shown in percent of the model's.

use memory_stats::memory_stats;
use num_traits::ToPrimitive;
use stabline::eye::plan::{CellSight, EyePlan, PlanCull, ViewCone};
use stabline::num::{Int, Random, Rational};
use stabline::portal::plan::cells_of_plan;
use stabline::predicates::PlanPoint;
use stabline::pvs::plan::{PlanStabTree, plan_stab_trees};
use stabline::report::Silent;
use stabline::scene::CellId;
use stabline::scene::plan::{FloorplanOptions, Plan, generate_floorplan};
use stabline::subdivision::plan::{PlanMethod, divide};
use std::time::Instant;

/// The paper's percentages and its reduction factors, which it rounds: all around, and within 60
/// degrees.
const PAPER: [(&str, [(f64, u32); 2]); 6] = [
    ("none (cell-to-cell vis.)", [(8.1, 10), (8.1, 10)]),
    ("disjoint cell", [(8.1, 10), (3.1, 30)]),
    ("connected component", [(8.1, 10), (2.4, 40)]),
    ("incident portals", [(8.1, 10), (2.2, 40)]),
    ("exact eye-to-cell", [(4.9, 20), (1.8, 50)]),
    ("exact visible area", [(2.1, 50), (0.3, 300)]),
];

/// Places in the building lie on a grid so fine, and directions are vectors about so long.
const FINE: i64 = 1 << 10;

fn main() {
    let mut arguments = std::env::args().skip(1).map(|argument| argument.parse::<u64>());
    let mut number = |default: u64| match arguments.next() {
        Some(Ok(number)) => number,
        Some(Err(error)) => panic!("floorplan_table FACES SEED QUERIES: {error}"),
        None => default,
    };
    let (faces, seed, queries) = (number(1000), number(3), number(10_000));
    let raw =
        generate_floorplan(&FloorplanOptions { faces: faces as usize, seed, is_general: false });
    let memory = || memory_stats().map_or(0, |used| used.physical_mem);
    let before = memory();
    let start = Instant::now();
    let plan = Plan::from_raw(&raw).expect("a made-up plan breaks no rule");
    let method = PlanMethod::Kd { threshold: Rational::default() };
    let tree = divide(&plan, &method, &Silent).expect("its segments are axial");
    let (divided, after_division) = (start.elapsed(), memory());
    let start = Instant::now();
    let cells = cells_of_plan(&plan, tree, false).expect("no mark, no leak");
    let count = cells.graph.cells.len();
    let sources: Vec<CellId> = (0..count as u32).map(CellId).collect();
    let crossings = cells.graph.crossings();
    let trees = plan_stab_trees(&cells.graph, &crossings, &sources, false, &Silent)
        .expect("nothing interrupts");
    let (searched, after_trees) = (start.elapsed(), memory());
    let vertices: usize = trees.iter().map(|tree| tree.nodes.len() + 1).sum();
    let mib = |from: usize, to: usize| to.saturating_sub(from) as f64 / (1 << 20) as f64;
    println!("                               paper      here");
    println!("faces                        ~ 1 000  {:>8}", plan.segments.len());
    println!("cells                          ~ 700  {count:>8}");
    println!("stab tree vertices          ~ 10 500  {vertices:>8}");
    println!("  a cell, mean                  ~ 15  {:>8.1}", vertices as f64 / count as f64);
    println!("subdivision, seconds              15  {:>8.4}", divided.as_secs_f64());
    println!("portals to stab trees, seconds    30  {:>8.4}", searched.as_secs_f64());
    println!("subdivision, MiB                   1  {:>8.2}", mib(before, after_division));
    println!("and all stab trees, MiB            2  {:>8.2}", mib(before, after_trees));
    let start = Instant::now();
    let eyes = EyePlan::new(&plan, &cells);
    let mean = ask(&plan, &eyes, &trees, seed, queries);
    let asked = start.elapsed().as_secs_f64();
    println!(
        "\n{queries} eyes, visible area in percent of the model's, and the reduction factor:\n"
    );
    println!("                                   360 degrees                60 degrees");
    println!("culling method                paper        here         paper        here");
    for ((name, paper), mean) in PAPER.iter().zip(mean) {
        let shown = |percent: f64, factor: f64| format!("{percent:>4.1}% {factor:>4.0}x");
        let [all, cone] = [0, 1].map(|i| {
            let (percent, factor) = paper[i];
            format!("{}  {}", shown(percent, factor.into()), shown(mean[i], 100.0 / mean[i]))
        });
        println!("{name:<26}{all}   {cone}");
    }
    println!("\n{:.1} microseconds a row and query", asked * 1e6 / (12 * queries) as f64);
}

/// The mean share of the model in percent, for each row of the table and either view.
fn ask(
    plan: &Plan,
    eyes: &EyePlan,
    trees: &[PlanStabTree],
    seed: u64,
    queries: u64,
) -> [[f64; 2]; 6] {
    let float = |ratio: Rational| ratio.to_f64().expect("areas are finite");
    let whole = float(eyes.whole_area());
    let area: Vec<f64> =
        (0..trees.len() as u32).map(|cell| float(eyes.area_of_cells([CellId(cell)]))).collect();
    let random = &mut Random::new(seed ^ 0x6579_6573);
    let mut sums = [[0.0; 2]; 6];
    for _ in 0..queries {
        let place = loop {
            // A point on a wall is no place for an eye; draw again.
            if let Ok(place) = eyes.place(somewhere(plan, random)) {
                break place;
            }
        };
        let tree = CellSight::Tree(&trees[place.cell().0 as usize].nodes);
        for (i, cone) in [None, Some(cone(random))].into_iter().enumerate() {
            let view = eyes.view(&place, cone.as_ref());
            for (row, cull) in PlanCull::ALL.into_iter().enumerate() {
                let left = view.cull(cull, tree);
                sums[row][i] += left.iter().map(|cell| area[cell.0 as usize]).sum::<f64>() / whole;
            }
            let seen = float(view.doubled_area(&view.sequences())) / 2.0;
            sums[5][i] += seen / whole;
        }
    }
    sums.map(|row| row.map(|sum| 100.0 * sum / queries as f64))
}

/// A point of the box.
fn somewhere(plan: &Plan, random: &mut Random) -> PlanPoint {
    let [low, high] = [0, 2].map(|corner| {
        plan.points.get(plan.bounds[corner]).small_integers().expect("the plan is made of integers")
    });
    let [x, y] = [0, 1].map(|d| Int::from(random.between(low[d] * FINE, high[d] * FINE - 1)));
    PlanPoint::new([x, y, Int::from(FINE)])
}

/// 60 degrees around any direction.
fn cone(random: &mut Random) -> ViewCone {
    let turn = random.between(0, (1 << 40) - 1) as f64 / (1u64 << 40) as f64;
    let (sin, cos) = (turn * std::f64::consts::TAU).sin_cos();
    let long = |c: f64| Rational::from(Int::from((c * (1 << 20) as f64).round() as i64));
    let half_tangent = Rational::new(97.into(), 168.into());
    ViewCone::new(&[long(cos), long(sin)], &half_tangent).expect("a direction and an angle")
}
