//! `check`, `export` and `schema` as a user runs them.

mod support;

use serde_json::Value;
use std::fs;
use support::{THREE_ROOMS, assert_fails, level, stabline, stdout, three_rooms_result};
use tempfile::TempDir;

/// A folder with the portal file, its result, and levels: perfect, with a hole, with waste.
fn folder() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    fs::write(at.join("rooms.prt"), THREE_ROOMS).unwrap();
    fs::write(at.join("rooms.json"), three_rooms_result()).unwrap();
    // Leafs 0 and 1 are cell 0, leaf 2 is cell 1, leaf 3 is cell 2.
    fs::write(at.join("exact.bsp"), level([0b0111, 0b0111, 0b1111, 0b1100])).unwrap();
    fs::write(at.join("hole.bsp"), level([0b0111, 0b0111, 0b1100, 0b1100])).unwrap();
    fs::write(at.join("waste.bsp"), level([0b1111, 0b0111, 0b1111, 0b1100])).unwrap();
    folder
}

#[test]
fn a_perfect_candidate_has_no_hole() {
    let folder = folder();
    for candidate in ["exact.bsp", "rooms.json"] {
        let output = stabline(folder.path(), &["check", "rooms.json", candidate]);
        assert_eq!(output.status.code(), Some(0));
        let text = stdout(&output);
        assert!(text.contains("holes      0 open pairs"), "{text}");
        assert!(text.contains("waste      0 pairs"), "{text}");
    }
}

#[test]
fn a_hole_is_named_with_its_sightline() {
    let folder = folder();
    let output = stabline(folder.path(), &["check", "rooms.json", "hole.bsp"]);
    assert_eq!(output.status.code(), Some(1));
    insta::assert_snapshot!(stdout(&output), @r"
    golden     rooms.json: 3 cells, 7 open pairs, 0 undecided, grazing not classified
    candidate  hole.bsp (Quake (version 29)): 6 pairs
    holes      1 open pairs that the candidate lacks
      1 -> 0: the line from (1, 5/2, 2) to (-1, 2, 2) through portals 0
    waste      0 pairs that are not open that the candidate has
    grazing    0 present, 0 missing
    undecided  0 present, 0 missing
    asymmetry  1 pairs present in one direction only
    ");
    let output = stabline(folder.path(), &["check", "rooms.json", "hole.bsp", "--json"]);
    assert_eq!(output.status.code(), Some(1));
    let score: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(score["format"], "stabline-check/1");
    assert_eq!(score["holes"][0]["from_name"], "1");
    assert_eq!(score["holes"][0]["witness"]["line"][0][1], "5/2");
    assert_eq!(score["open"], serde_json::json!({"present": 6, "missing": 1}));
}

#[test]
fn waste_is_no_failure() {
    let folder = folder();
    let output = stabline(folder.path(), &["check", "rooms.json", "waste.bsp"]);
    assert_eq!(output.status.code(), Some(0));
    let text = stdout(&output);
    assert!(text.contains("waste      1 pairs that are not open"), "{text}");
    assert!(text.contains("\n  0 -> 2\n"), "{text}");
    assert!(text.contains("split      1 pairs of cells"), "{text}");
}

/// A matrix as version 1.0 of the format.
fn npy(entries: [u8; 9]) -> Vec<u8> {
    let header = "{'descr': '|u1', 'fortran_order': False, 'shape': (3, 3), }\n";
    [b"\x93NUMPY\x01\0", &[header.len() as u8, 0][..], header.as_bytes(), &entries].concat()
}

#[test]
fn matrices_are_results_and_candidates() {
    let folder = folder();
    let at = folder.path();
    fs::write(at.join("exact.npy"), npy([2, 2, 0, 2, 2, 2, 0, 2, 2])).unwrap();
    fs::write(at.join("flags.npy"), npy([1, 1, 0, 1, 1, 1, 0, 1, 1])).unwrap();
    fs::write(at.join("grazing.npy"), npy([2, 2, 1, 2, 2, 2, 0, 2, 2])).unwrap();
    let code = |arguments: &[&str]| stabline(at, arguments).status.code();
    assert_eq!(code(&["check", "rooms.json", "exact.npy"]), Some(0));
    assert_eq!(code(&["check", "rooms.json", "flags.npy"]), Some(0));
    assert_eq!(code(&["check", "exact.npy", "exact.bsp", "--input", "rooms.prt"]), Some(0));
    assert_eq!(code(&["check", "exact.npy", "hole.bsp", "--input", "rooms.prt"]), Some(1));
    let grazing = ["check", "grazing.npy", "exact.bsp", "--input", "rooms.prt"];
    assert_eq!(code(&grazing), Some(0));
    assert_eq!(code(&[&grazing[..], &["--policy", "closed"]].concat()), Some(1));
    let output = stabline(at, &["check", "exact.npy", "exact.bsp"]);
    assert_fails(&output, 2, "exact.npy: an .npy result needs --input");
}

#[test]
fn an_exported_level_is_the_result() {
    let folder = folder();
    let at = folder.path();
    let export =
        ["export", "rooms.json", "--bsp", "waste.bsp", "-o", "out.bsp", "--policy", "open"];
    let output = stabline(at, &export);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let output = stabline(at, &["check", "rooms.json", "out.bsp"]);
    assert_eq!(output.status.code(), Some(0));
    assert!(stdout(&output).contains("waste      0"));
    // The exact level's own rows are what is written.
    assert_eq!(fs::read(at.join("out.bsp")).unwrap().len(), level([0; 4]).len());
}

#[test]
fn another_map_is_refused() {
    let folder = folder();
    let at = folder.path();
    let other = "PRT1\n2\n1\n3 0 1 (0 0 0 ) (1 0 0 ) (0 1 0 )\n";
    fs::write(at.join("other.prt"), other).unwrap();
    fs::write(at.join("exact.npy"), npy([2, 2, 0, 2, 2, 2, 0, 2, 2])).unwrap();
    let output = stabline(at, &["check", "exact.npy", "exact.bsp", "--input", "other.prt"]);
    assert_fails(&output, 3, "exact.npy: a matrix of 3 cells, but other.prt has 2");
    let output = stabline(at, &["check", "rooms.json", "exact.bsp", "--input", "other.prt"]);
    assert_fails(&output, 3, "rooms.json: the result is of another input than other.prt");
    let small = three_rooms_result().replace("[0, 0, 1, 2]", "[0, 1, 2]");
    fs::write(at.join("small.json"), small).unwrap();
    let output = stabline(at, &["check", "small.json", "exact.bsp"]);
    assert_fails(&output, 3, "exact.bsp: the candidate has 4 leafs, the golden result has 3");
    let output = stabline(at, &["export", "small.json", "--bsp", "exact.bsp", "-o", "out.bsp"]);
    assert_fails(&output, 3, "the level has 4 leafs with visibility, the result has 3");
    assert!(!at.join("out.bsp").exists());
    let elsewhere = three_rooms_result().replace("\"blake3\": \"", "\"blake3\": \"0");
    let hash = elsewhere.find("\"0").unwrap();
    let mut elsewhere = elsewhere;
    elsewhere.remove(hash + 2);
    fs::write(at.join("elsewhere.json"), elsewhere).unwrap();
    let output = stabline(at, &["check", "rooms.json", "elsewhere.json"]);
    assert_fails(&output, 3, "elsewhere.json: a result of another input");
}

#[test]
fn every_schema_is_named_and_printed() {
    let folder = tempfile::tempdir().unwrap();
    let names = stdout(&stabline(folder.path(), &["schema"]));
    for name in names.lines() {
        let schema: Value =
            serde_json::from_str(&stdout(&stabline(folder.path(), &["schema", name]))).unwrap();
        assert_eq!(schema["title"], name);
        let short = name.trim_start_matches("stabline-").trim_end_matches("/1");
        assert_eq!(stabline(folder.path(), &["schema", short]).status.code(), Some(0));
    }
    let output = stabline(folder.path(), &["schema", "pfs"]);
    assert_fails(&output, 2, "no format `pfs`, expected one of stabline-");
}

#[test]
fn the_documented_schemas_are_the_printed_ones() {
    let folder = tempfile::tempdir().unwrap();
    let docs = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/formats");
    for name in stdout(&stabline(folder.path(), &["schema"])).lines() {
        let file = docs.join(format!("{}.schema.json", name.replace('/', "-")));
        let printed = stdout(&stabline(folder.path(), &["schema", name]));
        let kept = fs::read_to_string(&file).unwrap_or_default();
        let command = format!(
            "stabline schema {name} > docs/formats/{}",
            file.file_name().unwrap().display()
        );
        assert!(kept == printed, "{} is not in step; run `{command}`", file.display());
    }
}
