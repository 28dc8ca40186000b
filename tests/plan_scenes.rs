//! Every floorplan of `scenes/plan` against its snapshot: cells, verdicts, lines; and what `why`
//! says.

mod support;

use support::{assert_fails, root, scenes, stabline, stdout};

#[test]
fn scenes_match_their_snapshots() {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(root().join("snapshots/plan"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    let paths = scenes("scenes/plan");
    assert!(paths.len() >= 6, "{paths:?}");
    for path in paths {
        let scene = path.to_str().unwrap();
        let name = path.file_stem().unwrap().to_str().unwrap();
        let is_graph = name.starts_with("graph_");
        let mut text = String::new();
        if !is_graph {
            let output = stabline(root(), &["bsp", scene]);
            text += &stdout(&output);
            text += &told(&output);
        }
        let output = stabline(root(), &["pvs", scene, "-o", "-", "--grazing"]);
        let result = stdout(&output);
        let rows = result.split_once("\"counts\"").unwrap().1;
        text += &format!("\"counts\"{rows}");
        settings.bind(|| insta::assert_snapshot!(name, text));
    }
}

/// What is told of a scene's oddities, without the path.
fn told(output: &std::process::Output) -> String {
    let text = String::from_utf8(output.stderr.clone()).unwrap();
    let lines = text.lines().filter_map(|line| line.split_once(".json: "));
    lines.map(|(_, what)| format!("{what}\n")).collect()
}

#[test]
fn why_names_the_line_or_the_way() {
    let scene = "scenes/plan/doors_in_one_wall_grazing.json";
    let open = stdout(&stabline(root(), &["why", scene, "0", "1"]));
    assert!(open.contains(" sees 1: open\nportals   "), "{open}");
    let json = stdout(&stabline(root(), &["why", scene, "0", "1", "--json"]));
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    assert_eq!(json["verdict"], "open");
    assert_eq!(json["line"][0].as_array().unwrap().len(), 2);
}

#[test]
fn the_same_bytes_on_any_number_of_threads() {
    let scene = "scenes/plan/walls_cross_overlap_end.json";
    let [one, two] = ["1", "3"]
        .map(|threads| stdout(&stabline(root(), &["pvs", scene, "-o", "-", "--threads", threads])));
    assert_eq!(one, two);
}

#[test]
fn bad_plans_are_refused_with_their_place() {
    let head = r#"{"about": "", "format": "stabline-scene/1", "#;
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("plan.json");
    let shown = path.to_str().unwrap();
    let cases = [
        (r#""segments": []}"#, "segments: no segment of positive length"),
        (r#""segments": [[[1,1],[1,1]]]}"#, "segments: no segment of positive length"),
        (r#""segments": [[[0,0],[1,0]]], "view": [[0,0],[0,1]]}"#, "view: the first corner"),
        (r#""segments": [[[0,0],[4,0]]], "inside": [[1,0]]}"#, "inside[0] lies on segment 0"),
        (
            r#""segments": [[[0,0],[4,0]]], "inside": [[9,9]]}"#,
            "inside[0] does not lie inside the box",
        ),
        (
            r#""segments": [[[0,0],[4,0]],[[4,0],[4,4]],[[4,4],[0,0]]], "inside": [[1,3]]}"#,
            "the plan leaks: inside[0] reaches the edge of the box",
        ),
        (
            r#""segments": [[[0,0],["1/2",0]]], "grid": 3}"#,
            "segments[0]: coordinate 1/2 is not a multiple",
        ),
        (r#""segments": [[[0,0],[1,0,2]]]}"#, "plan.json:1: column 70"),
        (r#""segments": [[[0,0],["x",0]]]}"#, "`x`"),
        (
            r#""segments": [[[0,0],[9,9]]], "objects": [{"polygon": [[0,0],[1,1],[2,2]]}]}"#,
            "objects[0]: expected three or more corners",
        ),
        (
            r#""cells": ["a", "a"], "portals": [{"from":"a","to":"a","segment":[[0,0],[1,0]]}]}"#,
            "cells[1]",
        ),
        (
            r#""cells": ["a", "b"], "portals": [{"from":"a","to":"c","segment":[[0,0],[1,0]]}]}"#,
            "portals[0].to: there is no cell `c`",
        ),
        (
            r#""cells": ["a", "b"], "portals": [{"from":"a","to":"b","segment":[[0,0],[0,0]]}]}"#,
            "portals[0]: both ends are one point",
        ),
    ];
    for (rest, expected) in cases {
        std::fs::write(&path, format!("{head}{rest}")).unwrap();
        assert_fails(&stabline(root(), &["pvs", shown]), 3, expected);
    }
    std::fs::write(&path, format!("{head}\"segments\": [[[0,0],[1,2]]]}}")).unwrap();
    assert_fails(&stabline(root(), &["pvs", shown, "--kd"]), 3, "segments[0]: not parallel");
    assert_fails(&stabline(root(), &["pvs", shown, "--shard", "1/2"]), 2, "--shard");
    assert_fails(
        &stabline(root(), &["move", shown, "--from", "0,0,0", "--to", "1,1,1"]),
        3,
        "a floorplan",
    );
}
