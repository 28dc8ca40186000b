//! The public maps that are not part of the project: skipped, with a message, where absent.

mod support;

use stabline::audit::check::Presence;
use stabline::formats::bsp::{Visibility, write_visibility};
use stabline::scene::{CellOrder, read_graph};
use support::maps;

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
            graph.small_grid().expect("six decimals").denominator,
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

/// The place of a lump in a Quake level.
fn lump(level: &[u8], number: usize) -> &[u8] {
    let word = |at: usize| u32::from_le_bytes(level[at..at + 4].try_into().unwrap()) as usize;
    &level[word(4 + 8 * number)..][..word(8 + 8 * number)]
}

#[test]
fn every_level_is_read_and_rewritten() {
    let Some(maps) = maps() else { return };
    // Ordered pairs of clusters that the two levels call visible, counted by an independent
    // decoder. (The table published with the maps has 21302 and 59310 for two of the older
    // program's levels, whose results change with its number of threads.)
    let expected = [
        ("lq_e0m1", [20344, 18553]),
        ("lqdm1", [21300, 21104]),
        ("lqdm6", [60848, 59530]),
        ("lq_e1m2", [59309, 58282]),
        ("lq_e0m8", [86514, 84026]),
        ("lq_e1m5", [109246, 107195]),
    ];
    for (map, counts) in expected {
        let folder = maps.join(map);
        let bytes = std::fs::read(folder.join(format!("{map}.prt"))).unwrap();
        let graph = read_graph(map, &bytes).unwrap();
        let leaf_to_cell: Vec<u32> = graph.leaf_to_cell.iter().map(|cell| cell.0).collect();
        let cells = graph.cells.len();
        let levels = ["a", "b"]
            .map(|vis| std::fs::read(folder.join(format!("{map}.vis-{vis}.bsp"))).unwrap());
        let [a, b] = [&levels[0], &levels[1]].map(|level| Visibility::read(level).unwrap());
        for (level, count) in [(&a, counts[0]), (&b, counts[1])] {
            let sees = |from: usize, to: usize| level.matrix.get(from, to);
            let presence =
                Presence::from_leafs(cells, &leaf_to_cell, level.matrix.size(), sees).unwrap();
            let pairs = (0..cells * cells).filter(|p| presence.has(p / cells, p % cells)).count();
            assert_eq!((pairs, presence.split_pairs, level.rows_missing), (count, 0, 0), "{map}");
        }
        let written = write_visibility(&levels[0], &b.matrix).unwrap();
        assert_eq!(Visibility::read(&written).unwrap().matrix, b.matrix, "{map}");
        for number in (0..15).filter(|&number| number != 4 && number != 10) {
            assert!(lump(&written, number) == lump(&levels[0], number), "{map}: lump {number}");
        }
    }
}
