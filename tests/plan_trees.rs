//! `stabline pvs --stab-tree` and `--objects` on floorplans, as a user runs them.

mod support;

use serde_json::Value;
use std::fs;
use std::path::Path;
use support::{assert_fails, root, stabline, stderr};

const SCENE: &str = "scenes/plan_trees/offset_doors_objects.json";

/// What one of the options writes for an input.
fn written(input: &str, option: &str, more: &[&str]) -> String {
    let folder = tempfile::tempdir().unwrap();
    let output = folder.path().join("out.json");
    let mut arguments = vec!["pvs", input, option, output.to_str().unwrap()];
    arguments.extend(more);
    let run = stabline(root(), &arguments);
    assert_eq!(run.status.code(), Some(0), "{}", stderr(&run));
    fs::read_to_string(output).unwrap()
}

#[test]
fn the_scene_matches_its_snapshot() {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(root().join("snapshots/plan_trees"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    let scene: Value = serde_json::from_slice(&fs::read(root().join(SCENE)).unwrap()).unwrap();
    settings.set_description(scene["about"].as_str().unwrap());
    let text = ["--objects", "--stab-tree"].map(|option| written(SCENE, option, &[])).concat();
    // The hash is that of the scene, line ends included.
    let lines: Vec<&str> = text.lines().filter(|line| !line.contains("blake3")).collect();
    settings.bind(|| insta::assert_snapshot!("offset_doors_objects", lines.join("\n")));
}

#[test]
fn objects_are_the_same_on_any_number_of_threads() {
    let text = written(SCENE, "--objects", &[]);
    for threads in ["1", "3"] {
        assert_eq!(written(SCENE, "--objects", &["--threads", threads]), text);
    }
    let without = written(SCENE, "--objects", &["--no-witness"]);
    assert!(without.ends_with("\"witnesses\": []}\n"), "{without}");
}

#[test]
fn stab_trees_hold_what_the_result_says() {
    let text = written(SCENE, "--stab-tree", &[]);
    assert_eq!(written(SCENE, "--stab-tree", &["--threads", "1"]), text);
    let trees: Value = serde_json::from_str(&text).unwrap();
    let result: Value = serde_json::from_str(&written(SCENE, "-o", &[])).unwrap();
    for tree in trees["trees"].as_array().unwrap() {
        let source = tree["source"].as_u64().unwrap();
        let nodes = tree["nodes"].as_array().unwrap();
        let sees = |cell: u64| {
            cell == source || nodes.iter().any(|node| node["cell"].as_u64() == Some(cell))
        };
        let row = result["rows"][source as usize].as_str().unwrap();
        let seen: String = (0..row.len() as u64).map(|c| if sees(c) { '2' } else { '0' }).collect();
        assert_eq!(seen, row);
    }
}

#[test]
fn graphs_of_the_plane_have_lines_of_two_coordinates() {
    let folder = tempfile::tempdir().unwrap();
    let graph = folder.path().join("graph.json");
    fs::write(
        &graph,
        r#"{"about": "Two doors in a row.", "format": "stabline-scene/1", "cells": ["room", "corridor", "office"], "portals": [
            {"from": "room", "to": "corridor", "segment": [[0,0],[1,0]]},
            {"from": "corridor", "to": "office", "segment": [[0,9],["1/2",9]]}]}"#,
    )
    .unwrap();
    let text = written(graph.to_str().unwrap(), "--stab-tree", &["--from", "0"]);
    let trees: Value = serde_json::from_str(&text).unwrap();
    let nodes = trees["trees"][0]["nodes"].as_array().unwrap();
    let portals: Vec<u64> = nodes.iter().map(|node| node["portal"].as_u64().unwrap()).collect();
    assert_eq!(portals, [0, 1]);
    for point in nodes.iter().flat_map(|node| node["line"].as_array().unwrap()) {
        assert_eq!(point.as_array().unwrap().len(), 2);
    }
    let to = folder.path().join("out.json");
    let objects = ["pvs", graph.to_str().unwrap(), "--objects", to.to_str().unwrap()];
    assert_fails(&stabline(root(), &objects), 2, "states no objects; expected a floorplan");
    assert!(!to.exists());
}

#[test]
fn what_cannot_be_is_refused_and_nothing_written() {
    let folder = tempfile::tempdir().unwrap();
    let to = folder.path().join("out.json");
    let out = |path: &Path| path.to_str().unwrap().to_owned();
    let cases: [(&str, &[&str], &str); 3] = [
        ("--stab-tree", &["--from", "99"], "--from 99: expected a cell below"),
        ("--objects", &["--objects-method", "conservative"], "--objects-method conservative"),
        ("--objects", &["--shard", "1/2"], "--shard"),
    ];
    for (option, more, expected) in cases {
        let to_text = out(&to);
        let mut arguments = vec!["pvs", SCENE, option, &to_text];
        arguments.extend(more);
        assert_fails(&stabline(root(), &arguments), 2, expected);
        assert!(!to.exists(), "{option} {more:?}");
    }
}
