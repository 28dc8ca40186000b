//! `stabline bsp` and `stabline pvs` on levels' sources.

mod support;

use std::fs;
use std::path::Path;
use support::{assert_fails, maps, root, stabline, stderr, stdout};

const SCENE: &str = "scenes/bsp/two_rooms_door_slab.map";

#[test]
fn two_rooms_fall_into_cells_that_a_portal_file_can_hold() {
    let folder = tempfile::tempdir().unwrap();
    let prt = folder.path().join("rooms.prt");
    let run = stabline(root(), &["bsp", SCENE, "--prt", prt.to_str().unwrap()]);
    assert_eq!(
        stdout(&run),
        "two_rooms_door_slab.map: 10 solids, 0 polygons, 0 hints, 0 objects, 1 marks; 0 oddities repaired\n\
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
    assert_eq!((&json["cells"], &json["portals"]), (&308.into(), &662.into()));
}

/// The scenes whose cells are shown whole; that of the detail objects has its own test.
const SHOWN: [&str; 3] = [
    "scenes/bsp/pillars_coincident_touching_edge.map",
    "scenes/bsp/two_rooms_door_slab.map",
    "scenes/bsp/wedge_in_corner_vertices_off_grid.map",
];

/// The cells and portals of scenes, and the order of painting for one eye.
#[test]
fn scenes_match_their_snapshots() {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(root().join("snapshots/bsp"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    let folder = tempfile::tempdir().unwrap();
    for input in SHOWN {
        let name = Path::new(input).file_stem().unwrap().to_str().unwrap();
        let out = folder.path().join("cells.json");
        let run = stabline(root(), &["bsp", input, "--check", "--cells", out.to_str().unwrap()]);
        assert_eq!(run.status.code(), Some(0), "{}", stderr(&run));
        let json: serde_json::Value =
            serde_json::from_str(&fs::read_to_string(&out).unwrap()).unwrap();
        let mut text = stdout(&run);
        for (number, cell) in json["cells"].as_array().unwrap().iter().enumerate() {
            text.push_str(&format!("cell {number}: volume {}\n", cell["volume"]));
            text.push_str(&format!("  vertices {}\n  faces {}\n", cell["vertices"], cell["faces"]));
        }
        for portal in json["portals"].as_array().unwrap() {
            let (from, to, at) = (&portal["from"], &portal["to"], &portal["vertices"]);
            text.push_str(&format!("portal {from} to {to}: {at}\n"));
        }
        let painted = stdout(&stabline(root(), &["bsp", input, "--painter", "64,64,32"]));
        let cells: Vec<&str> = painted.lines().filter(|line| line.starts_with("cell ")).collect();
        text.push_str(&format!("painted from (64 64 32): {}\n", cells.join(", ")));
        settings.bind(|| insta::assert_snapshot!(name, text.replace('"', "")));
    }
}

#[test]
fn options_of_division_change_the_cells_and_keep_the_laws() {
    let cells = |options: &[&str]| {
        let all = [&["bsp", SCENE, "--check", "--json"], options].concat();
        let run = stabline(root(), &all);
        assert_eq!(run.status.code(), Some(0), "{options:?}: {}", stderr(&run));
        let json: serde_json::Value = serde_json::from_str(&stdout(&run)).unwrap();
        assert_eq!(json["checked"]["leaves"], json["leaves"]);
        json["cells"].as_u64().unwrap()
    };
    let usual = cells(&[]);
    assert!(cells(&["--largest-volume", "1/50"]) > usual);
    assert!(cells(&["--largest-aspect", "1.5"]) > usual);
    assert!(cells(&["--obscuration", "1/2"]) > 0);
    assert!(cells(&["--reward-coplanar=0", "--charge-cut=1000000", "--reward-axial=0"]) > 0);
    for (options, what) in [
        (["--obscuration", "2"], "--obscuration: `2`: expected above 0 and at most 1"),
        (["--largest-volume", "0"], "--largest-volume: `0`: expected above 0"),
        (["--largest-aspect", "1/2"], "--largest-aspect: `1/2`: expected at least 1"),
        (["--painter", "1,2"], "--painter: expected 3 numbers"),
    ] {
        assert_fails(&stabline(root(), &[&["bsp", SCENE], &options[..]].concat()), 2, what);
    }
}

#[test]
fn conservative_portals_say_so() {
    let run = stabline(root(), &["bsp", SCENE, "--portals", "hull"]);
    assert!(stdout(&run).contains("conservative"), "{}", stdout(&run));
    let run = stabline(root(), &["bsp", SCENE, "--portals", "exact"]);
    assert!(!stdout(&run).contains("conservative"));
}
