//! The PVS of random portal graphs against the brute-force twin, and every witness against an
//! independent check.
//!
//! `STABLINE_GRAPHS=N` sets the number of graphs a family (default 40), `STABLINE_SEED=S` the
//! first seed (default 0).

mod support;

use num_traits::{One, Signed, Zero};
use stabline::num::{Int, Rational, parse_decimal};
use stabline::oracle::{self, Random};
use stabline::pvs::{self, Finished, Options};
use stabline::report::{Matrix, Silent, Verdict};
use stabline::scene::{CellOrder, PortalGraph};
use support::graphs::{Family, Graph, Portal, gates, integer};
use support::witness;

fn setting(name: &str, default: u64) -> u64 {
    std::env::var(name).ok().and_then(|n| n.parse().ok()).unwrap_or(default)
}

fn seeds(share: u64) -> std::ops::Range<u64> {
    let first = setting("STABLINE_SEED", 0);
    first..first + (setting("STABLINE_GRAPHS", 40) / share).max(1)
}

fn compute(graph: &PortalGraph, options: &Options) -> Finished {
    pvs::compute(graph, options, Vec::new(), &|_| {}, &Silent)
}

/// The matrix, after a check of every witness and of which pairs have one.
fn checked(graph: &PortalGraph, options: &Options, name: &str) -> Matrix {
    let finished = compute(graph, options);
    let matrix = pvs::assemble(graph, &finished.rows);
    assert_eq!(matrix.asymmetric_pairs(), 0, "{name}");
    let witnesses = pvs::witnesses(&finished.rows);
    for found in &witnesses {
        if let Err(why) = witness::check(graph, found) {
            panic!("{name}: {} -> {}: {why}: {found:?}", found.from, found.to);
        }
    }
    let pairs: Vec<(u32, u32)> = witnesses.iter().map(|w| (w.from, w.to)).collect();
    let size = matrix.size();
    let open = (0..size).flat_map(|a| (a + 1..size).map(move |b| (a, b)));
    let open = open.filter(|&(a, b)| matrix.get(a, b) == Verdict::Open);
    assert_eq!(pairs, open.map(|(a, b)| (a as u32, b as u32)).collect::<Vec<_>>(), "{name}");
    matrix
}

/// Five cells in a row. The planes of the two middle doors, x = z and x = -z, cross each other, so
/// below z = 0 they are met in the order of the row and above it the other way round; the outer
/// doors keep lines between `low` and `high`.
fn crossed_doors(low: i64, high: i64) -> PortalGraph {
    let door = |slope: i64, x: i64, z0: i64, z1: i64| {
        let corner = |y: i64, z: i64| [x + slope * z, y, z].map(integer);
        vec![corner(0, z0), corner(5, z0), corner(5, z1), corner(0, z1)]
    };
    let polygons =
        [door(0, -40, low, high), door(1, 0, -9, 9), door(-1, 0, -9, 9), door(0, 40, low, high)];
    let portals = polygons.into_iter().zip(0..);
    let portals =
        portals.map(|(polygon, cell)| Portal { cells: [cell, cell + 1], polygon }).collect();
    Graph { cells: 5, portals }.validated()
}

#[test]
fn doors_met_in_the_wrong_order_are_not_open() {
    for (low, high, expected) in [(-8, -2, Verdict::Open), (2, 8, Verdict::Grazing)] {
        let graph = crossed_doors(low, high);
        let doors = gates(&graph);
        let doors: Vec<_> = doors.iter().map(|gate| gate.vertices.as_slice()).collect();
        let by_sides_alone = oracle::classify(&oracle::on_common_grid(&doors).1);
        assert!(matches!(by_sides_alone, oracle::Truth::Open(_)), "{low} to {high}");
        let mut matrix = checked(&graph, &Options::default(), "crossed doors");
        assert_is_twin(&matrix, &graph, "crossed doors");
        assert!(pvs::classify_grazing(&graph, &mut matrix, None, &Silent).is_some());
        assert_eq!(matrix.get(0, 4), expected, "{low} to {high}");
        assert_eq!(CellOrder::new(&graph).pairs().len(), 1);
    }
}

#[test]
fn grazing_pairs_are_those_of_the_twin() {
    for family in Family::ALL {
        let start = std::time::Instant::now();
        let mut grazing = 0;
        for seed in seeds(2) {
            let name = format!("{family:?} {seed}");
            let graph = Graph::random(family, 7000 + seed).validated();
            // Touching lines run along every wall: the small graphs only.
            if graph.portals.len() > 9 {
                continue;
            }
            let finished = compute(&graph, &Options::default());
            let mut matrix = pvs::assemble(&graph, &finished.rows);
            let open = matrix.clone();
            assert!(pvs::classify_grazing(&graph, &mut matrix, None, &Silent).is_some(), "{name}");
            let touched = oracle::touched_pairs(graph.cells.len(), &gates(&graph));
            for (a, row) in touched.iter().enumerate() {
                for (b, &is_touched) in row.iter().enumerate() {
                    let expected = match open.get(a, b) {
                        Verdict::NotOpen if is_touched => Verdict::Grazing,
                        verdict => verdict,
                    };
                    assert_eq!(matrix.get(a, b), expected, "{name}: {a} -> {b}");
                    grazing += u32::from(expected == Verdict::Grazing);
                }
            }
        }
        println!("{family:?}: {grazing} grazing pairs, {:?}", start.elapsed());
    }
}

fn assert_is_twin(matrix: &Matrix, graph: &PortalGraph, name: &str) -> usize {
    let twin = oracle::open_pairs(graph.cells.len(), &gates(graph));
    let mut open = 0;
    for (a, row) in twin.iter().enumerate() {
        for (b, &is_open) in row.iter().enumerate() {
            let expected = if is_open { Verdict::Open } else { Verdict::NotOpen };
            assert_eq!(matrix.get(a, b), expected, "{name}: {a} -> {b}");
            open += usize::from(is_open && a != b);
        }
    }
    open
}

#[test]
fn the_pvs_is_that_of_the_twin() {
    for family in Family::ALL {
        let start = std::time::Instant::now();
        let (mut open, mut pairs, mut nonconvex, mut ordered) = (0, 0, 0, 0);
        for seed in seeds(1) {
            let name = format!("{family:?} {seed}");
            let graph = Graph::random(family, seed).validated();
            let order = CellOrder::new(&graph);
            nonconvex += order.nonconvex_cells;
            ordered += order.pairs().len();
            let matrix = checked(&graph, &Options::default(), &name);
            open += assert_is_twin(&matrix, &graph, &name);
            pairs += graph.cells.len() * (graph.cells.len() - 1);
        }
        println!(
            "{family:?}: {open} of {pairs} pairs open, {nonconvex} cells not convex, \
             {ordered} pairs of portals need the order, {:?}",
            start.elapsed()
        );
        assert!(open > 0 && open < pairs, "{family:?} asks nothing");
    }
}

#[test]
fn wide_coordinates_decide_as_narrow_ones_do() {
    let decimal = |text: &str| parse_decimal(text).unwrap();
    let far = || Rational::from(Int::one() << 30);
    let scales: [(Rational, [Rational; 3]); 6] = [
        // Portal files: six decimals, far away.
        (decimal("0.000001"), [far(), -far(), far() + decimal("0.123457")]),
        (decimal("0.0254"), [Rational::zero(), far(), decimal("-77.5")]),
        // A shortest double, and 26 decimals.
        (decimal("0.30000000000000004"), [decimal("0.1"), decimal("1e17"), Rational::one()]),
        (decimal("0.56285683454726874605620706"), [(); 3].map(|()| Rational::zero())),
        // Coordinates that no float holds, large and small.
        (decimal("1e400"), [(); 3].map(|()| Rational::zero())),
        (decimal("1e-400"), [(); 3].map(|()| Rational::zero())),
    ];
    for family in Family::ALL {
        for seed in seeds(6) {
            let graph = Graph::random(family, seed);
            let name = format!("{family:?} {seed}");
            let narrow = checked(&graph.validated(), &Options::default(), &name);
            for (scale, offset) in &scales {
                assert!(scale.is_positive());
                let name = format!("{name}, scaled by {scale}");
                let wide = graph.scaled(scale, offset).validated();
                assert_eq!(checked(&wide, &Options::default(), &name), narrow, "{name}");
            }
        }
    }
}

#[test]
fn vertices_without_a_common_grid_decide_as_the_twin_does() {
    let mut open = 0;
    for family in Family::ALL {
        let start = std::time::Instant::now();
        for seed in seeds(10) {
            for bits in [20, 60] {
                let name = format!("{family:?} {seed}, {bits} bits");
                let moved = Graph::random(family, 9000 + seed).shaken(&mut Random::new(seed), bits);
                let graph = moved.validated();
                if graph.portals.len() > 2 {
                    assert_eq!(graph.small_grid(), None, "{name}");
                }
                let matrix = checked(&graph, &Options::default(), &name);
                // The twin's numbers are as long as a sequence: small graphs only.
                if graph.portals.len() <= if bits == 20 { 7 } else { 5 } {
                    open += assert_is_twin(&matrix, &graph, &name);
                }
                let options = Options { without_filters: true, ..Options::default() };
                assert_eq!(checked(&graph, &options, &name), matrix, "{name} without filters");
                for scale in ["1/3", "7/11", "1/2305843009213693951"] {
                    let none = [(); 3].map(|()| Rational::zero());
                    let scaled = moved.scaled(&parse_decimal(scale).unwrap(), &none).validated();
                    let name = format!("{name}, scaled by {scale}");
                    assert_eq!(checked(&scaled, &Options::default(), &name), matrix, "{name}");
                }
            }
        }
        println!("{family:?}: {:?}", start.elapsed());
    }
    assert!(open > 0, "nothing is open");
}

#[test]
fn grazing_pairs_without_a_common_grid_are_those_of_the_twin() {
    let mut grazing = 0;
    for family in [Family::Rooms, Family::Convex] {
        for seed in seeds(4) {
            let name = format!("{family:?} {seed}");
            // Only the first portal is moved: the others still share walls and edges.
            let mut graph = Graph::random(family, 7000 + seed);
            let moved = graph.shaken(&mut Random::new(seed), 40);
            graph.portals.splice(..1, moved.portals.into_iter().take(1));
            let graph = graph.validated();
            if graph.portals.len() > 8 || graph.portals.is_empty() {
                continue;
            }
            let mut matrix = checked(&graph, &Options::default(), &name);
            assert!(pvs::classify_grazing(&graph, &mut matrix, None, &Silent).is_some(), "{name}");
            for (a, row) in
                oracle::touched_pairs(graph.cells.len(), &gates(&graph)).iter().enumerate()
            {
                for (b, &touched) in row.iter().enumerate() {
                    let verdict = matrix.get(a, b);
                    assert_eq!(verdict != Verdict::NotOpen, touched, "{name}: {a} -> {b}");
                    grazing += u32::from(verdict == Verdict::Grazing);
                }
            }
        }
    }
    assert!(grazing > 0, "no pair is grazing");
}
