//! The levels of Freedoom, which is no part of this repository: tests skip themselves without it.

mod support;

use stabline::formats::wad::{Archive, MapForm, RejectTable};
use stabline::pvs::plan::{Cover, plan_sights};
use stabline::report::Silent;
use support::sightlines::assert_joins;
use support::wads::{divided, faced, freedoom, half_point};

/// The start of the BLAKE3 hash of Freedoom's first archive in version 0.12.1.
const KNOWN: &str = "a9c1c14007cea4b344860dc2e3ecb4c8";

/// Pseudorandom numbers, the same in every run.
fn next(state: &mut u64) -> u64 {
    *state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
    *state >> 33
}

#[test]
fn every_map_is_read_and_has_a_whole_reject_lump() {
    let Some(archives) = freedoom() else { return };
    let mut count = 0;
    for bytes in &archives {
        let archive = Archive::read(bytes).unwrap();
        for name in archive.maps() {
            let map = archive.map(name).unwrap();
            assert_eq!(map.form, MapForm::Doom, "{name}");
            let table = RejectTable::read(&map.reject.unwrap(), map.sectors).unwrap();
            assert!((0..map.sectors).all(|sector| !table.rejects(sector, sector)), "{name}");
            count += 1;
        }
    }
    assert_eq!(count, 36 + 32);
}

#[test]
fn leaves_are_of_the_sector_that_the_next_line_faces() {
    let Some(archives) = freedoom() else { return };
    let mut state = 1;
    for bytes in &archives {
        let archive = Archive::read(bytes).unwrap();
        for name in archive.maps() {
            let map = archive.map(name).unwrap();
            let (doom, cells, areas) = divided(&map);
            let unclosed = areas.unclosed();
            let [low, high] = [0, 2].map(|corner| {
                let corner = doom.plan.points.get(doom.plan.bounds[corner]);
                corner.small_integers().unwrap()
            });
            for _ in 0..100 {
                let doubled = [0, 1].map(|axis| {
                    let width = (high[axis] - low[axis]) as u64;
                    2 * (low[axis] + (next(&mut state) % width) as i64) + 1
                });
                let sectors = areas.sectors_of_leaf(cells.tree.locate(&half_point(doubled)));
                let faced = faced(&map, &doom, doubled);
                // A line with one sector on both sides may face an area of another.
                let weak = |sector: &u32| {
                    unclosed.contains(sector)
                        || doom
                            .lines
                            .iter()
                            .any(|line| line.is_self_referencing() && line.front == Some(*sector))
                };
                match faced {
                    Some(sector) if weak(&sector) => {}
                    Some(sector) => assert_eq!(sectors, [sector], "{name} {doubled:?}"),
                    None => assert!(sectors.is_empty(), "{name} {doubled:?} {sectors:?}"),
                }
            }
        }
    }
}

#[test]
fn what_a_shipped_table_lacks_is_seen_along_a_line_that_meets_no_wall() {
    let Some([first, _]) = freedoom() else { return };
    let archive = Archive::read(&first).unwrap();
    let mut holes = 0;
    for name in ["E1M3", "E1M6", "E3M6", "E4M6"] {
        let map = archive.map(name).unwrap();
        let (doom, cells, areas) = divided(&map);
        let leaves = 0..areas.of_leaf.len() as u32;
        let cover = Cover::new(doom.sectors, leaves.map(|leaf| areas.sectors_of_leaf(leaf)));
        let table = RejectTable::read(map.reject.as_ref().unwrap(), map.sectors).unwrap();
        let rejects = |from: u32, to: u32| table.rejects(from as usize, to as usize);
        let crossings = cells.graph.crossings();
        let wants = |g: u32, h: u32| {
            let (from, to) = (cover.sets_of(g), cover.sets_of(h));
            from.iter().any(|&from| to.iter().any(|&to| rejects(from, to)))
        };
        let groups = cover.groups();
        let (_, sights) = plan_sights(&cells.graph, &crossings, groups, &wants, &Silent).unwrap();
        let mut sights = cover.sights(&cells.graph, sights);
        sights.retain(|sight| rejects(sight.from, sight.to));
        for sight in sights.iter().filter(|sight| !sight.portals.is_empty()) {
            assert_joins(&map, &doom, &cells, &areas.unclosed(), sight);
        }
        holes += 2 * sights.len();
    }
    // Of version 0.12.1; others may have been built by another program.
    eprintln!("{holes} holes in four maps");
    let is_known = blake3::hash(&first).to_hex().starts_with(KNOWN);
    assert!(!is_known || holes == 2 + 240 + 34 + 12, "{holes}");
}
