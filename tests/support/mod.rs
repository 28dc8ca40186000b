//! Running the command, and small inputs for it.
#![allow(dead_code, reason = "each test program uses its own part of this")]

pub mod arguments;
pub mod boxes;
pub mod certificate;
pub mod graphs;
pub mod mutations;
pub mod obstacles;
pub mod plans;
pub mod proofs;
pub mod sightlines;
pub mod wads;
pub mod witness;
pub mod worlds;

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// Three rooms in a row, the door between the last two skew; leafs 0 and 1 are both cell 0.
pub const THREE_ROOMS: &str = "PRT2
4
3
2
4 0 1 (0 0 0 ) (0 4 0 ) (0 4 4 ) (0 0 4 )\x20
4 1 2 (8 0 0 ) (8.5 4 0 ) (8 4 4 ) (8 0 4 )\x20
0 1 -1
2 -1
3 -1
";

/// The result for [`THREE_ROOMS`] in which all see all but the first and last room, and one
/// sightline is given.
pub fn three_rooms_result() -> String {
    let hash = blake3::hash(THREE_ROOMS.as_bytes()).to_hex();
    format!(
        r#"{{"format": "stabline-pvs/1",
"program": "stabline 0.1.0",
"input": {{"name": "rooms.prt", "blake3": "{hash}"}},
"options": {{"grazing": false}},
"cells": ["0", "1", "2"],
"leaf_to_cell": [0, 0, 1, 2],
"skew_portals": 1,
"counts": {{"open": 7, "grazing": null, "blocked": null, "undecided": 0, "diagonal_included": true}},
"rows": [
"220",
"222",
"022"],
"witnesses": [
{{"from": 0, "to": 1, "portals": [0], "line": [["-1", "2", "2"], ["1", "5/2", "2"]]}}]}}
"#
    )
}

/// A Quake level (version 29) of four leafs with visibility, given as one byte a row, and one
/// lump behind it.
pub fn level(rows: [u8; 4]) -> Vec<u8> {
    let mut bytes = vec![0; 124];
    bytes[0] = 29;
    let mut leafs = [0; 28 * 5];
    for (row, offset) in [-1i32, 0, 1, 2, 3].iter().enumerate() {
        leafs[28 * row + 4..][..4].copy_from_slice(&offset.to_le_bytes());
    }
    let mut model = [0; 64];
    model[52] = 4;
    for (lump, data) in [(10, &leafs[..]), (4, &rows[..]), (14, &model[..])] {
        let entry = 4 + 8 * lump;
        let place = bytes.len() as u32;
        bytes[entry..entry + 4].copy_from_slice(&place.to_le_bytes());
        bytes[entry + 4..entry + 8].copy_from_slice(&(data.len() as u32).to_le_bytes());
        bytes.extend_from_slice(data);
    }
    bytes
}

/// Runs `stabline` in the folder `at`.
pub fn stabline(at: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_stabline")).current_dir(at).args(arguments).output().unwrap()
}

/// The project's folder.
pub fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The scenes in a folder of the project, in the order of their names.
pub fn scenes(folder: &str) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(root().join(folder)).unwrap();
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    paths
}

/// The folder of shared maps, where there is one.
pub fn maps() -> Option<PathBuf> {
    let shared =
        std::env::var_os("STABLINE_SHARED").map_or_else(|| root().join("../shared"), PathBuf::from);
    let maps = shared.join("maps");
    if maps.is_dir() {
        return Some(maps);
    }
    eprintln!("skipped: no shared maps at {}", maps.display());
    None
}

/// What a command printed to standard output.
pub fn stdout(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).unwrap()
}

/// What a command printed to standard error.
pub fn stderr(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

/// Asserts that a command failed with `code` and one line on standard error that contains
/// `expected`, and printed nothing else.
pub fn assert_fails(output: &Output, code: i32, expected: &str) {
    let error = stderr(output);
    assert_eq!(output.status.code(), Some(code), "{error}");
    assert!(error.starts_with("error: ") && error.contains(expected), "{error}");
    assert_eq!(error.matches('\n').count(), 1, "{error}");
    assert!(error.ends_with('\n') && output.stdout.is_empty(), "{error}");
}
