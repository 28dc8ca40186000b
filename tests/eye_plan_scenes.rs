//! Every floorplan of an eye against its snapshot, and the command that answers.

mod support;

use support::{assert_fails, root, scenes, stabline, stdout};

/// The options with which each plan is asked.
const QUERIES: &[(&str, &[&str])] = &[
    (
        "corridor_between_rooms",
        &[
            "--at 1,4 --region",
            "--at 17/2,2 --look -1,2 --half-tangent 1/3 --cull none",
            "--at 17/2,2 --look -1,2 --half-tangent 1/3 --cull disjoint",
            "--at 17/2,2 --look -1,2 --half-tangent 1/3 --cull component",
            "--at 17/2,2 --look -1,2 --half-tangent 1/3 --cull portals",
            "--at 17/2,2 --look -1,2 --half-tangent 1/3 --regions",
            // In a door, with its back to one room.
            "--at 5/2,5 --look 0,-1 --fov 60",
            "--at 17/2,3",
            // Along the corridor, into a room and, not along the way, into another.
            "--path 1,4^3/2,4^17/2,4^17/2,2^11,1^21/2,7",
        ],
    ),
    (
        "walls_crossing_touching",
        &[
            "--at 3/2,3 --region",
            "--at 2,1",
            "--at 4,7/2 --look -1,1 --half-tangent 7 --regions",
            "--at 6,1 --look 1,1 --fov 90",
        ],
    ),
];

/// The arguments of a query, in which `^` is a space within one.
fn arguments(scene: &str, query: &str) -> Vec<String> {
    let options = query.split(' ').map(|part| part.replace('^', " "));
    ["eye".to_owned(), scene.to_owned()].into_iter().chain(options).collect()
}

fn run(scene: &str, query: &str) -> std::process::Output {
    let arguments = arguments(scene, query);
    stabline(root(), &arguments.iter().map(String::as_str).collect::<Vec<_>>())
}

#[test]
fn scenes_match_their_snapshots() {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(root().join("snapshots/eye_plan"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    let paths = scenes("scenes/eye_plan");
    assert_eq!(paths.len(), QUERIES.len());
    for (path, (name, queries)) in paths.iter().zip(QUERIES) {
        assert_eq!(path.file_stem().unwrap(), *name);
        let mut text = String::new();
        for query in *queries {
            let output = run(path.to_str().unwrap(), query);
            assert_eq!(output.status.code(), Some(0), "{query}: {output:?}");
            text.push_str(&format!("$ {query}\n{}\n", stdout(&output)));
        }
        settings.bind(|| insta::assert_snapshot!(*name, text));
    }
}

const CORRIDOR: &str = "scenes/eye_plan/corridor_between_rooms.json";

#[test]
fn the_json_says_what_the_text_says() {
    let query = "--path 1,4^3/2,4 --look 1,0 --half-tangent 1/3 --region";
    let text = stdout(&run(CORRIDOR, query));
    let json = run(CORRIDOR, &format!("{query} --json"));
    let json: serde_json::Value = serde_json::from_slice(&json.stdout).unwrap();
    assert_eq!(json["format"], "stabline-eye-plan/1");
    assert_eq!(json["cone"]["half_tangent"], "1/3");
    assert_eq!(json["area"], "96");
    let view = &json["views"][1];
    assert_eq!(view["step"]["portals"], 0);
    assert!(view["step"]["entered"].as_array().unwrap().is_empty());
    let cells = view["cells"].as_array().unwrap();
    assert!(text.contains(&format!("exact: {} cells", cells.len())), "{text}");
    let area = view["seen"]["area"].as_str().unwrap();
    assert!(text.contains(&format!("seen area {area} through")), "{text}");
    let regions = view["seen"]["regions"].as_array().unwrap();
    assert_eq!(view["seen"]["sequences"], regions.len() - 1);
}

#[test]
fn bad_queries_are_refused() {
    let fails = |query: &str, code: i32, expected: &str| {
        assert_fails(&run(CORRIDOR, query), code, expected);
    };
    fails("--at 1,4,2", 2, "--at: expected 2 numbers between commas, got 3 (the input lies in");
    fails("--path 1,4^2", 2, "--path: expected 2 numbers between commas, got 1");
    fails("--path ^", 2, "--path: expected one or more points");
    fails("--at 1,4 --path 1,4", 2, "cannot be used with");
    fails("--at 1,4 --look 1,0,0 --fov 90", 2, "--look: expected 2 numbers");
    fails("--at 1,4 --look 1,0 --fov 90,60", 2, "--fov: expected 1 numbers");
    fails("--at 1,4 --look 1,0 --fov 180", 2, "below 180 degrees, got 180");
    fails("--at 1,4 --look 1,0 --half-tangent 0", 2, "must be positive, got 0");
    fails("--at 1,4 --look 0,0 --fov 60", 2, "look is the zero vector");
    fails("--at 1,4 --look 1,0", 2, "--look needs --half-tangents or --fov");
    fails("--at 1,4 --cull float", 2, "--cull float and flood are for space");
    fails("--at 1,4 --cull none --region", 2, "--regions needs the exact cull");
    fails("--at 1,4 --cell 0", 2, "--cell: the input lies in the plane");
    fails("--at 1,4 --objects", 2, "--objects: the input lies in the plane");
    fails("--at 4,6", 3, "(4 6): the eye is on a wall: segments[11]");
    fails("--at 2,3", 3, "the eye is on a wall: segments[9]");
    fails("--at 13,4", 3, "the eye is outside of the box");
    fails("--path 1,4^2,9", 3, "(2 9): the eye is outside of the box");
    let space = "scenes/eye/four_rooms_shared_edge.json";
    assert_fails(&run(space, "--path 1,4"), 2, "--path is for floorplans");
    assert_fails(&run(space, "--at 1,4"), 2, "--at: expected 3 numbers between commas, got 2");
    assert_fails(&run(space, "--at 1,1,1 --cull none"), 2, "are for floorplans");
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("graph.json");
    let graph = r#"{"about": "two cells", "format": "stabline-scene/1", "cells": ["a", "b"],
        "portals": [{"from": "a", "to": "b", "segment": [[0, 1], [0, 0]]}]}"#;
    std::fs::write(&path, graph).unwrap();
    let output = run(path.to_str().unwrap(), "--at 1,1");
    assert_fails(&output, 3, "a graph of the plane does not say where its cells end");
}

#[test]
fn a_plan_that_leaves_out_the_outside_tells_eyes_there() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("plan.json");
    let plan = r#"{"about": "a room in a box", "format": "stabline-scene/1",
        "view": [[-5, -5], [9, 9]], "inside": [[1, 1]],
        "segments": [[[0, 0], [4, 0]], [[4, 0], [4, 4]], [[4, 4], [0, 4]], [[0, 4], [0, 0]]]}"#;
    std::fs::write(&path, plan).unwrap();
    let scene = path.to_str().unwrap();
    assert!(stdout(&run(scene, "--at 1,1")).contains("seen area 16 through 0 sequences"));
    assert_fails(&run(scene, "--at 6,6"), 3, "the eye is in no cell");
    assert_fails(&run(scene, "--at 9,3"), 3, "the eye is on the edge of the box");
    assert_fails(&run(scene, "--at 4,2"), 3, "the eye is on a wall: segments[1]");
}
