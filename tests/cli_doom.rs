//! Doom levels on the command line.

mod support;

use serde_json::Value;
use stabline::formats::wad::MapForm;
use std::fs;
use std::path::Path;
use support::wads::{Level, four_rooms, two_rooms};
use support::{THREE_ROOMS, assert_fails, stabline, stderr, stdout};
use tempfile::TempDir;

/// A folder with the four rooms in each form.
fn folder() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (form, name) in
        [(MapForm::Doom, "rooms.wad"), (MapForm::Hexen, "hexen.wad"), (MapForm::Udmf, "udmf.wad")]
    {
        fs::write(folder.path().join(name), four_rooms().archive("MAP01", form)).unwrap();
    }
    folder
}

/// What the command prints, where it ends with `code`.
fn prints(at: &Path, code: i32, arguments: &[&str]) -> String {
    let output = stabline(at, arguments);
    assert_eq!(output.status.code(), Some(code), "{}", stderr(&output));
    stdout(&output)
}

/// Writes an archive of one map and scores its table against the exact one.
fn score(at: &Path, level: &Level) -> String {
    fs::write(at.join("x.wad"), level.archive("E1M1", MapForm::Doom)).unwrap();
    prints(at, 0, &["pvs", "x.wad:E1M1", "-o", "x.json"]);
    let output = stabline(at, &["check", "x.json", "x.wad:E1M1"]);
    stdout(&output)
}

#[test]
fn the_sectors_of_a_level_are_its_cells() {
    let folder = folder();
    insta::assert_snapshot!(prints(folder.path(), 0, &["pvs", "rooms.wad:map01"]), @r"
    rooms.wad:map01: 4 cells, 3 portals, in the plane
    4 sectors in 4 leaves
    open               14   87.5 %
    not open            2   12.5 %
    ordered pairs of cells, each cell with itself included; every open pair has an exact sightline
    ");
    let results = ["rooms.wad:MAP01", "hexen.wad:MAP01", "udmf.wad:MAP01"].map(|map| {
        prints(folder.path(), 0, &["pvs", map, "--reject", "out.lmp"]);
        let reject = fs::read(folder.path().join("out.lmp")).unwrap();
        prints(folder.path(), 0, &["pvs", map, "--npy", "out.npy"]);
        (fs::read(folder.path().join("out.npy")).unwrap(), reject)
    });
    // Of 16 bits those of 0 and 3, and of 3 and 0.
    assert_eq!(results[0].1, [0b0000_1000, 0b0001_0000]);
    assert_eq!(results[0], results[1]);
    assert_eq!(results[0], results[2]);
}

#[test]
fn subsectors_are_the_finer_cells() {
    let folder = folder();
    let arguments = ["pvs", "rooms.wad:MAP01", "--cells", "subsectors", "--json"];
    let summary: Value = serde_json::from_str(&prints(folder.path(), 0, &arguments)).unwrap();
    assert_eq!(summary["cells"], summary["leaves"]);
    assert_eq!(summary["reading"], "--cells subsectors");
    // Walls back to back.
    assert_eq!(summary["oddities"][0]["kind"], "overlapping");
    assert_eq!(summary["oddities"][0]["count"], 3);
}

#[test]
fn reject_lumps_are_scored() {
    let folder = folder();
    let at = folder.path();
    prints(at, 0, &["pvs", "rooms.wad:MAP01", "-o", "exact.json"]);
    insta::assert_snapshot!(prints(at, 1, &["check", "exact.json", "rooms.wad:MAP01"]), @r"
    golden     exact.json: 4 cells, 14 open pairs, 0 undecided, grazing not classified
    candidate  rooms.wad:MAP01 (REJECT): 12 pairs
    holes      4 open pairs that the candidate lacks
      0 -> 2: the line from (128, 8) to (256, 120) through portals 0, 1
      1 -> 3: the line from (256, 120) to (384, 8) through portals 1, 2
      2 -> 0: the line from (256, 120) to (128, 8) through portals 1, 0
      3 -> 1: the line from (384, 8) to (256, 120) through portals 2, 1
    waste      2 pairs that are not open that the candidate has
      0 -> 3
      3 -> 0
    grazing    0 present, 0 missing
    undecided  0 present, 0 missing
    asymmetry  0 pairs present in one direction only
    ");
    let arguments = ["check", "exact.json", "rooms.wad:MAP01", "--json"];
    let found: Value = serde_json::from_str(&prints(at, 1, &arguments)).unwrap();
    assert_eq!(found["holes"].as_array().unwrap().len(), 4);
    assert_eq!(found["waste"][0]["from_name"], "0");
    // The exact lump has neither.
    prints(at, 0, &["pvs", "rooms.wad:MAP01", "--reject", "exact.lmp"]);
    let exact = Level { reject: fs::read(at.join("exact.lmp")).ok(), ..four_rooms() };
    let text = score(at, &exact);
    assert!(text.contains("holes      0 ") && text.contains("waste      0 "), "{text}");
}

#[test]
fn levels_without_a_whole_table_may_see_everything() {
    let folder = tempfile::tempdir().unwrap();
    for (reject, expected) in [
        (None, "no REJECT lump: every sector may see every other"),
        (Some(vec![]), "the REJECT lump is empty: every sector may see every other"),
        (Some(vec![255]), "the REJECT lump has 1 bytes, expected 2"),
    ] {
        let text = score(folder.path(), &Level { reject, ..four_rooms() });
        assert!(text.contains(expected), "{text}");
        assert!(text.contains("16 pairs") && text.contains("waste      2 "), "{text}");
    }
}

#[test]
fn oddities_are_told() {
    let folder = tempfile::tempdir().unwrap();
    let mut level = two_rooms();
    level.line([10, 10], [10, 10], Some(0), Some(0));
    level.line([20, 20], [30, 30], Some(0), Some(0));
    fs::write(folder.path().join("x.wad"), level.archive("M", MapForm::Udmf)).unwrap();
    let output = stabline(folder.path(), &["pvs", "x.wad:M", "--json"]);
    let told = stderr(&output);
    assert!(
        told.contains("x.wad:M: 1 lines of no length, left out: line 7 has no length\n"),
        "{told}"
    );
    let summary: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(summary["oddities"][0]["kind"], "zero-length");
    assert_eq!(summary["oddities"][1]["count"], 2);
    assert_eq!(summary["oddities"][1]["all"][1]["lines"], serde_json::json!([8]));
    assert_eq!(summary["oddities"][1]["all"][1]["sectors"], serde_json::json!([0]));
}

#[test]
fn what_is_wrong_is_told_and_nothing_is_written() {
    let folder = folder();
    let at = folder.path();
    fs::write(at.join("rooms.prt"), THREE_ROOMS).unwrap();
    let whole = fs::read(at.join("rooms.wad")).unwrap();
    fs::write(at.join("cut.wad"), &whole[..100]).unwrap();
    for (arguments, code, expected) in [
        (vec!["pvs", "rooms.wad"], 3, "an archive of 1 maps, expected one, such as FILE:MAP01"),
        (vec!["pvs", "rooms.wad:E1M1"], 3, "there is no such map; the archive has MAP01"),
        (vec!["pvs", "none.wad:E1M1"], 3, "none.wad: cannot read"),
        (vec!["pvs", "rooms.prt:E1M1"], 3, "not an archive of Doom, so it has no map E1M1"),
        (vec!["pvs", "cut.wad:MAP01"], 3, "byte 4: a directory of "),
        (
            vec!["move", "rooms.wad:MAP01", "--from", "0,0,0", "--to", "1,0,0"],
            3,
            "a floorplan, expected a world of three dimensions",
        ),
        (vec!["pvs", "rooms.prt", "--reject", "out.lmp"], 2, "--reject and --cells are of Doom"),
        (
            vec!["pvs", "rooms.wad:MAP01", "--cells", "subsectors", "--reject", "out.lmp"],
            2,
            "a REJECT lump is of sectors",
        ),
    ] {
        assert_fails(&stabline(at, &arguments), code, expected);
        assert!(!at.join("out.lmp").exists());
    }
    // A result of other sectors.
    prints(at, 0, &["pvs", "rooms.wad:MAP01", "-o", "four.json"]);
    fs::write(at.join("two.wad"), two_rooms().archive("MAP01", MapForm::Doom)).unwrap();
    let expected = "the candidate has 2 cells, the golden result has 4";
    assert_fails(&stabline(at, &["check", "four.json", "two.wad:MAP01"]), 3, expected);
}
