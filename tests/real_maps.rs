//! The public maps that are not part of the project: skipped, with a message, where absent.

use stabline::scene::{CellOrder, read_graph};
use std::path::PathBuf;

/// The folder of shared maps, where there is one.
fn maps() -> Option<PathBuf> {
    let shared = std::env::var_os("STABLINE_SHARED")
        .map_or_else(|| PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../shared"), PathBuf::from);
    let maps = shared.join("maps");
    if maps.is_dir() {
        return Some(maps);
    }
    eprintln!("skipped: no shared maps at {}", maps.display());
    None
}

#[test]
fn every_portal_file_becomes_a_graph() {
    let Some(maps) = maps() else { return };
    let expected = [
        ("lq_e0m1", 682, 426, 993, 18),
        ("lqdm1", 1043, 245, 631, 7),
        ("lqdm6", 2241, 387, 1094, 5),
        ("lq_e1m2", 2715, 631, 1532, 0),
        ("lq_e0m8", 960, 837, 2174, 5),
        ("lq_e1m5", 3633, 1520, 3374, 540),
    ];
    for (map, leafs, cells, portals, skew) in expected {
        let bytes = std::fs::read(maps.join(map).join(format!("{map}.prt"))).unwrap();
        let start = std::time::Instant::now();
        let graph = read_graph(map, &bytes).unwrap();
        let read = start.elapsed();
        let order = CellOrder::new(&graph);
        println!(
            "{map}: read {read:?}, order {:?}, grid {}, {} vertices, {} portals, {} cells not convex, \
             {} pairs, {:?}",
            start.elapsed() - read,
            graph.denominator,
            graph.vertices.len(),
            graph.portals.len(),
            order.nonconvex_cells,
            order.pairs().len(),
            graph.repairs,
        );
        assert_eq!(graph.leaf_to_cell.len(), leafs, "{map}");
        assert_eq!(graph.cells.len(), cells, "{map}");
        assert_eq!(graph.portals.last().unwrap().source + 1, portals, "{map}");
        assert_eq!(graph.skew_portals, skew, "{map}");
    }
}
