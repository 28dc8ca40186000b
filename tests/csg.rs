//! Every scene of brushes against its snapshot, the files that the command writes, and bad input.

mod support;

use serde_json::Value;
use std::fs;
use support::{assert_fails, root, scenes, stabline, stderr, stdout};

#[test]
fn scenes_match_their_snapshots() {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(root().join("snapshots/csg"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    for path in scenes("scenes/csg") {
        let scene: Value = serde_json::from_slice(&fs::read(&path).unwrap()).unwrap();
        settings.set_description(scene["about"].as_str().unwrap());
        let name = path.file_stem().unwrap().to_str().unwrap().to_owned();
        let output = stabline(&root().join("scenes/csg"), &["csg", &format!("{name}.json")]);
        assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
        let text = format!("{}{}", stdout(&output), stderr(&output));
        settings.bind(|| insta::assert_snapshot!(name, text));
    }
}

#[test]
fn all_outputs_tell_of_one_body() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let scene = "scenes/csg/boxes_frame.json";
    let (json, obj, glb, bsp) = (at("a.json"), at("a.obj"), at("a.glb"), at("tree.json"));
    let output =
        stabline(root(), &["csg", scene, "-o", &json, "--obj", &obj, "--glb", &glb, "--bsp", &bsp]);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    let text = stdout(&output);
    assert!(
        text.contains("\na.obj: coordinates are exact\na.glb: coordinates are exact\n"),
        "{text}"
    );
    let body: Value = serde_json::from_slice(&fs::read(&json).unwrap()).unwrap();
    assert_eq!(
        [&body["format"], &body["volume"], &body["surface_area"]],
        ["stabline-body/1", "12", "48"]
    );
    let printed = stabline(root(), &["csg", scene, "--json"]);
    assert_eq!(printed.stdout, fs::read(&json).unwrap());
    let count = |list: &Value| list.as_array().unwrap().len();
    let lines = fs::read_to_string(&obj).unwrap();
    let starting = |start: &str| lines.lines().filter(|line| line.starts_with(start)).count();
    assert_eq!(starting("f "), count(&body["boundary"]));
    assert!(lines.contains("\no boxes_frame\n"), "{lines}");
    let glb = fs::read(&glb).unwrap();
    assert_eq!(&glb[..4], b"glTF");
    assert_eq!(u32::from_le_bytes(glb[8..12].try_into().unwrap()) as usize, glb.len());
    let tree: Value = serde_json::from_slice(&fs::read(&bsp).unwrap()).unwrap();
    assert_eq!(count(&tree["nodes"]), body["splits"].as_u64().unwrap() as usize);
    let nodes = tree["nodes"].as_array().unwrap();
    let leaves = nodes.iter().flat_map(|node| [&node["front"], &node["back"]]);
    assert_eq!(leaves.filter(|leaf| **leaf == "inside").count(), count(&body["cells"]));
}

/// Asserts that an expression is refused in words that contain `expected`.
fn assert_refused(text: &str, expected: &str) {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("bad.json"), text).unwrap();
    let output = stabline(folder.path(), &["csg", "bad.json", "-o", "out.json"]);
    assert_fails(&output, 3, &format!("bad.json: {expected}"));
    assert!(!folder.path().join("out.json").exists());
}

#[test]
fn bad_input_is_refused_by_place() {
    let unit = r#"{"box": {"low": [0, 0, 0], "high": [1, 1, 1]}}"#;
    let flat = r#"[[0, 0], [1, 0], [2, 2], [1, 0.1], [0, 1]]"#;
    for (body, expected) in [
        (r#"{"union": []}"#.into(), "union: expected one part at least"),
        (format!(r#"{{"complement": {unit}}}"#), "the expression is unbounded"),
        (
            format!(r#"{{"union": [{unit}, {{"difference": [{{"planes": [{{"normal": [1, 0, 0], "offset": 0}}]}}, {unit}]}}]}}"#),
            "union[1].difference[0].planes: brush 1: the planes leave it unbounded",
        ),
        (r#"{"planes": []}"#.into(), "planes: brush 0: the planes leave it unbounded"),
        (r#"{"planes": [{"normal": [1, 0, 0]}]}"#.into(), "planes: plane 0: expected `normal` and"),
        (
            r#"{"planes": [{"points": [[0, 0, 0], [1, 1, 1], [2, 2, 2]]}]}"#.into(),
            "planes: plane 0: the normal is zero",
        ),
        (
            format!(r#"{{"scale": {{"by": [1, 0, 2], "of": {unit}}}}}"#),
            "scale: the map is singular",
        ),
        (
            format!(r#"{{"complement": {{"matrix": {{"rows": [[1, 2, 3], [4, 5, 6], [7, 8, 9]], "of": {unit}}}}}}}"#),
            "complement.matrix: the map is singular",
        ),
        (
            format!(r#"{{"prism": {{"polygon": {flat}, "heights": [0, 1]}}}}"#),
            "prism: the polygon is not convex",
        ),
        (
            r#"{"sphere": {"center": [0, 0, 0], "radius": 1, "sides": 7, "grid": 9}}"#.into(),
            "sphere: expected 4 to 32 sides, an even number, got 7",
        ),
        (
            r#"{"cylinder": {"center": [0, 0], "radius": -1, "heights": [0, 1], "sides": 7, "grid": 9}}"#.into(),
            "cylinder: the radius is not positive",
        ),
        (r#"{"use": "nothing"}"#.into(), "use(nothing): no definition of `nothing`"),
        (r#"{"points": [[0, 0, NaN]]}"#.into(), "line 1, column"),
        (r#"{"box": {"low": [0, 0, 0], "hihg": [1, 1, 1]}}"#.into(), "line 1, column"),
        ("[".repeat(100_000), "line 1, column"),
        (r#"{"complement": "#.repeat(100_000), "line 1, column"),
    ] {
        assert_refused(&format!(r#"{{"format": "stabline-csg/1", "body": {body}}}"#), expected);
    }
    assert_refused("", "line 1, column 0: EOF");
    assert_refused(
        &format!(
            r#"{{"format": "stabline-csg/1", "body": {unit},
            "define": [{{"name": "a", "body": {unit}}}, {{"name": "a", "body": {unit}}}]}}"#
        ),
        "define[1]: `a` is defined twice",
    );
}

/// A file with one definition a line, the n-th made of `part` with the name before it put in.
fn chain(count: usize, part: &str) -> String {
    let unit = r#"{"name": "0", "body": {"box": {"low": [0, 0, 0], "high": [1, 1, 1]}}}"#;
    let mut define = vec![unit.to_owned()];
    define.extend((1..=count).map(|i| {
        let before = format!(r#"{{"use": "{}"}}"#, i - 1);
        format!(r#"{{"name": "{i}", "body": {}}}"#, part.replace("PART", &before))
    }));
    let define = define.join(",\n");
    format!(r#"{{"format": "stabline-csg/1", "define": [{define}], "body": {{"use": "{count}"}}}}"#)
}

#[test]
fn definitions_neither_nest_nor_multiply_without_end() {
    assert_refused(
        &chain(400, r#"{"complement": PART}"#),
        "use(400).complement.use(399).complement.use(398).",
    );
    assert_refused(&chain(40, r#"{"union": [PART, PART]}"#), "use(40).union[0].use(39).");
}
