//! `stabline bsp` and `stabline pvs` on levels' sources.

mod support;

use std::fs;
use support::{assert_fails, maps, root, stabline, stderr, stdout};

const SCENE: &str = "scenes/bsp/two_rooms_door_slab.map";

#[test]
fn two_rooms_fall_into_cells_that_a_portal_file_can_hold() {
    let folder = tempfile::tempdir().unwrap();
    let prt = folder.path().join("rooms.prt");
    let run = stabline(root(), &["bsp", SCENE, "--prt", prt.to_str().unwrap()]);
    assert_eq!(
        stdout(&run),
        "two_rooms_door_slab.map: 10 brushes that occlude, 0 hints, 0 others; 0 oddities repaired\n\
         21 leaves of the tree, 15 solid\n6 cells inside, 7 portals between them\n",
        "{}",
        stderr(&run)
    );
    let of = |input: &str| {
        let npy = folder.path().join("x.npy");
        let run = stabline(root(), &["pvs", input, "--npy", npy.to_str().unwrap()]);
        assert_eq!(run.status.code(), Some(0), "{}", stderr(&run));
        fs::read(npy).unwrap()
    };
    assert_eq!(of(SCENE), of(prt.to_str().unwrap()));
}

#[test]
fn a_level_without_its_ceiling_leaks() {
    let text = fs::read_to_string(root().join(SCENE)).unwrap();
    // The world's second brush is the ceiling.
    let brushes: Vec<&str> = text.split("\n{\n( ").collect();
    let open = [&brushes[..2], &brushes[3..]].concat().join("\n{\n( ");
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("open.map"), open).unwrap();
    let run = stabline(folder.path(), &["bsp", "open.map", "--pts", "way.pts", "--prt", "x.prt"]);
    assert_fails(&run, 3, "`info_player_start`: a leak: from here a way of");
    let way = fs::read_to_string(folder.path().join("way.pts")).unwrap();
    assert!(way.starts_with("64.000 64.000 32.000\n") && way.lines().count() > 1, "{way}");
    assert!(!folder.path().join("x.prt").exists());
    assert_fails(&stabline(folder.path(), &["pvs", "open.map"]), 3, "a leak");
}

#[test]
fn a_level_that_nothing_marks_is_refused() {
    let text = fs::read_to_string(root().join(SCENE)).unwrap();
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("dark.map"), text.replace("\"origin\"", "\"place\"")).unwrap();
    let run = stabline(folder.path(), &["bsp", "dark.map"]);
    assert_fails(&run, 3, "no entity marks the inside");
}

/// Cells and portals of the smallest public level.
#[test]
fn a_public_level_is_closed() {
    let Some(maps) = maps() else {
        eprintln!("skipped: the public maps are not here");
        return;
    };
    let input = maps.join("lq_e0m1/lq_e0m1.map");
    let run = stabline(root(), &["bsp", input.to_str().unwrap(), "--json"]);
    let json: serde_json::Value = serde_json::from_str(&stdout(&run)).unwrap();
    assert_eq!((&json["cells"], &json["portals"]), (&351.into(), &750.into()));
}
