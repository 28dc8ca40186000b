//! `pvs --proof` and `verify` as a user runs them, and the checker in Python the same way.

mod support;

use flate2::{Compression, write::GzEncoder};
use serde_json::{Value, json};
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use support::{THREE_ROOMS, assert_fails, root, stabline, stderr, stdout};
use tempfile::TempDir;

const GALLERY: &str = "scenes/pvs/gallery_nine_rooms.json";

/// A folder with an input, `name`, and its proof in the folder `proof`.
fn proved(name: &str, input: &[u8], options: &[&str]) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join(name), input).unwrap();
    let command = [&["pvs", name, "--proof", "proof"], options].concat();
    let output = stabline(folder.path(), &command);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    folder
}

fn gallery() -> TempDir {
    proved("gallery.json", &fs::read(root().join(GALLERY)).unwrap(), &["--grazing"])
}

/// The checker in Python; none where there is no Python.
fn python(at: &Path, arguments: &[&str]) -> Option<Output> {
    let script = root().join("examples/verify.py");
    let output = Command::new("python3").arg(script).args(arguments).current_dir(at).output();
    if output.is_err() {
        println!("skipped: there is no python3");
    }
    output.ok()
}

/// Both checkers fail with `code` and one line that contains `expected`.
fn both_fail(at: &Path, arguments: &[&str], code: i32, expected: &str) {
    let command: Vec<&str> = std::iter::once("verify").chain(arguments.iter().copied()).collect();
    assert_fails(&stabline(at, &command), code, expected);
    if let Some(output) = python(at, arguments) {
        assert_fails(&output, code, expected);
    }
}

/// Both hold, and say the same in their first lines; whether both matched the input.
fn both_hold(at: &Path, arguments: &[&str]) -> [bool; 2] {
    let command: Vec<&str> = std::iter::once("verify").chain(arguments.iter().copied()).collect();
    let output = stabline(at, &command);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let text = stdout(&output);
    assert!(text.starts_with("all holds; pairs of different cells: "), "{text}");
    let matched = !stderr(&output).contains("not matched");
    let Some(other) = python(at, arguments) else { return [matched; 2] };
    assert_eq!(other.status.code(), Some(0), "{other:?}");
    assert!(stdout(&other).starts_with(&text), "{}{text}", stdout(&other));
    [matched, !stderr(&other).contains("not matched")]
}

#[test]
fn a_folder_a_file_and_a_packed_file() {
    let folder = gallery();
    let at = folder.path();
    let text = fs::read(at.join("proof/proof.txt")).unwrap();
    let packed = |text: &[u8]| {
        let mut packer = GzEncoder::new(Vec::new(), Compression::default());
        packer.write_all(text).unwrap();
        packer.finish().unwrap()
    };
    fs::create_dir(at.join("packed")).unwrap();
    fs::write(at.join("packed/proof.txt.gz"), packed(&text)).unwrap();
    // Two members of one gzip file are one text.
    let (head, rest) = text.split_at(1000);
    fs::write(at.join("two.gz"), [packed(head), packed(rest)].concat()).unwrap();
    for proof in ["proof", "proof/proof.txt", "packed", "packed/proof.txt.gz", "two.gz"] {
        assert_eq!(both_hold(at, &[proof]), [true; 2], "{proof}");
        assert_eq!(both_hold(at, &[proof, "gallery.json"]), [true; 2], "{proof}");
    }
    let half = packed(&text);
    fs::write(at.join("half.gz"), &half[..half.len() / 2]).unwrap();
    both_fail(at, &["half.gz"], 5, "half.gz: line ");
    let output = stabline(at, &["verify", "proof", "--json", "gallery.json"]);
    let counts: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(counts["holds"], json!(true));
    assert_eq!(counts["matched"], json!(true));
    assert_eq!([&counts["open"], &counts["grazing"], &counts["not_open"]], [27, 1, 8]);
}

#[test]
fn what_is_no_proof() {
    let folder = gallery();
    let at = folder.path();
    fs::write(at.join("empty"), "").unwrap();
    fs::write(at.join("newer"), "stabline-proof/2\n").unwrap();
    fs::create_dir(at.join("nothing")).unwrap();
    both_fail(at, &["missing"], 3, "missing");
    both_fail(at, &["nothing"], 3, "nothing");
    both_fail(at, &["empty"], 3, "empty: line 1");
    both_fail(at, &["newer"], 3, "newer: line 1: no proof");
    both_fail(at, &["gallery.json"], 3, "gallery.json: line 1: no proof");
    both_fail(at, &["proof", "missing.prt"], 3, "missing.prt");
}

#[test]
fn what_does_not_hold_is_told_with_its_line() {
    let folder = gallery();
    let at = folder.path();
    let text = fs::read_to_string(at.join("proof/proof.txt")).unwrap();
    let lines = text.lines().count();
    let start = |word: &str| text.lines().position(|line| line.starts_with(word)).unwrap() + 1;
    let grazing = start("grazing ");
    let broken = text.replacen("\ngrazing ", "\nopen ", 1);
    fs::write(at.join("broken"), broken).unwrap();
    both_fail(at, &["broken"], 5, &format!("broken: line {grazing}: "));
    fs::write(at.join("sealed"), text.replacen("gallery.json", "gallery.jsom", 1)).unwrap();
    both_fail(at, &["sealed"], 5, &format!("sealed: line {lines}: "));
    fs::write(at.join("longer"), format!("{text}\n")).unwrap();
    both_fail(at, &["longer"], 5, "longer: line ");
    fs::write(at.join("shorter"), &text[..text.len() - 1]).unwrap();
    both_fail(at, &["shorter"], 5, &format!("shorter: line {lines}: "));
}

#[test]
fn a_portal_file_and_its_skew_portal() {
    let folder = proved("rooms.prt", THREE_ROOMS.as_bytes(), &[]);
    let at = folder.path();
    assert_eq!(both_hold(at, &["proof", "rooms.prt"]), [true; 2]);
    // Blanks and the way numbers are written do not matter.
    let written = THREE_ROOMS.replace("8.5", "85e-1").replace(" (", "  ( ").replace(" )", ")");
    fs::write(at.join("written.prt"), written).unwrap();
    assert_eq!(both_hold(at, &["proof", "written.prt"]), [true; 2]);
    for (name, from, to) in [
        ("moved.prt", "0 4 4", "0 4 5"),
        ("skewer.prt", "8.5 4 0", "8.25 4 0"),
        ("turned.prt", "4 0 1 ", "4 1 0 "),
        ("elsewhere.prt", "4 1 2 ", "4 0 2 "),
        ("more.prt", "3\n2\n", "3\n1\n"),
    ] {
        let mut changed = THREE_ROOMS.replacen(from, to, 1);
        if name == "more.prt" {
            let portal = changed.lines().nth(5).unwrap().to_owned();
            changed = changed.replacen(&format!("{portal}\n"), "", 1);
        }
        assert_ne!(changed, THREE_ROOMS);
        fs::write(at.join(name), changed).unwrap();
        both_fail(at, &["proof", name], 5, "the proof is of another graph");
    }
}

#[test]
fn another_graph_and_geometry() {
    let folder = gallery();
    let at = folder.path();
    let scene = |path: &str| -> PathBuf { root().join(path) };
    let other = scene("scenes/pvs/enfilade_offset_doors.json");
    both_fail(at, &["proof", other.to_str().unwrap()], 5, "the proof is of another graph");
    let text = fs::read_to_string(scene(GALLERY)).unwrap();
    fs::write(at.join("renamed.json"), text.replace("\"hall\"", "\"hell\"")).unwrap();
    both_fail(at, &["proof", "renamed.json"], 5, "the proof is of another graph");
    // The cells of geometry are of the program's making.
    let geometry = scene("scenes/bsp/two_rooms_door_slab.map");
    assert_eq!(both_hold(at, &["proof", geometry.to_str().unwrap()]), [false; 2]);
}

#[test]
fn every_scene_matches() {
    for path in support::scenes("scenes/pvs") {
        let name = path.file_name().unwrap().to_str().unwrap();
        let folder = proved(name, &fs::read(&path).unwrap(), &["--grazing"]);
        assert_eq!(both_hold(folder.path(), &["proof", name]), [true; 2], "{name}");
    }
}

#[test]
fn floorplans_and_graphs_of_the_plane_hold() {
    let mut grazing = 0;
    for path in support::scenes("scenes/plan") {
        let name = path.file_name().unwrap().to_str().unwrap();
        let folder = proved(name, &fs::read(&path).unwrap(), &["--grazing"]);
        // The portal graph of a floorplan is of this program's making.
        let is_graph = name.starts_with("graph_");
        assert_eq!(both_hold(folder.path(), &["proof", name]), [is_graph; 2], "{name}");
        let proof = fs::read_to_string(folder.path().join("proof/proof.txt")).unwrap();
        grazing += proof.lines().filter(|line| line.starts_with("grazing ")).count();
    }
    assert!(grazing > 2, "{grazing}");
}

#[test]
fn in_the_plane_no_touching_line_stands_upright() {
    let file = fs::read(root().join("scenes/regression/doors_around_one_post.json")).unwrap();
    let file: Value = serde_json::from_slice(&file).unwrap();
    let graph = file["case"]["input"].to_string();
    let folder = proved("post.json", graph.as_bytes(), &["--grazing", "-o", "post.pvs.json"]);
    assert_eq!(both_hold(folder.path(), &["proof", "post.json"]), [true; 2]);
    let result = fs::read(folder.path().join("post.pvs.json")).unwrap();
    let result: Value = serde_json::from_slice(&result).unwrap();
    assert_eq!(result["rows"], json!(["22220", "22221", "22222", "22222", "01222"]));
}

#[test]
fn graphs_of_the_plane_and_strange_names() {
    let graph = json!({
        "about": "Strange names.",
        "format": "stabline-scene/1",
        "cells": ["a \"quoted\"\nname", "back\\slash\tand é\u{301}", "c"],
        "portals": [
            {"from": "a \"quoted\"\nname", "to": "back\\slash\tand é\u{301}", "segment": [[0, 0], ["1/3", 0]]},
            {"from": "back\\slash\tand é\u{301}", "to": "c", "segment": [[0, 9], [0.5, 9]]}]});
    let folder = proved("plane.json", graph.to_string().as_bytes(), &[]);
    assert_eq!(both_hold(folder.path(), &["proof", "plane.json"]), [true; 2]);
    let mut moved = graph;
    moved["portals"][1]["segment"][0][0] = json!(-1);
    fs::write(folder.path().join("moved.json"), moved.to_string()).unwrap();
    both_fail(folder.path(), &["proof", "moved.json"], 5, "the proof is of another graph");
}
