//! `stabline pvs --objects` as a user runs it.

mod support;

use serde_json::Value;
use std::fs;
use std::path::Path;
use support::{assert_fails, maps, root, stabline, stderr};

const SCENE: &str = "scenes/bsp/two_rooms_objects.map";

/// The objects' result for an input, with more arguments.
fn objects(input: &Path, more: &[&str]) -> String {
    let folder = tempfile::tempdir().unwrap();
    let output = folder.path().join("objects.json");
    let mut arguments = vec!["pvs", input.to_str().unwrap(), "--objects", output.to_str().unwrap()];
    arguments.extend(more);
    let run = stabline(root(), &arguments);
    assert_eq!(run.status.code(), Some(0), "{}", stderr(&run));
    fs::read_to_string(output).unwrap()
}

fn rows(text: &str) -> Vec<String> {
    let json: Value = serde_json::from_str(text).unwrap();
    json["rows"].as_array().unwrap().iter().map(|row| row.as_str().unwrap().to_owned()).collect()
}

#[test]
fn the_scene_matches_its_snapshot_on_any_number_of_threads() {
    let scene = root().join(SCENE);
    let text = objects(&scene, &[]);
    for threads in ["1", "3"] {
        assert_eq!(objects(&scene, &["--threads", threads]), text);
    }
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(root().join("snapshots/bsp"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    let source = fs::read_to_string(&scene).unwrap();
    settings.set_description(source.lines().next().unwrap().trim_start_matches("// "));
    // The hash is that of the scene, line ends included.
    let lines: Vec<&str> = text.lines().filter(|line| !line.contains("blake3")).collect();
    settings.bind(|| insta::assert_snapshot!("two_rooms_objects", lines.join("\n")));
}

#[test]
fn the_conservative_answer_is_a_superset_without_witnesses() {
    let scene = root().join(SCENE);
    let conservative = objects(&scene, &["--objects-method", "conservative"]);
    let exact = objects(&scene, &["--no-witness"]);
    for (left, seen) in rows(&conservative).iter().zip(rows(&exact)) {
        assert!(left.bytes().zip(seen.bytes()).all(|(left, seen)| seen != b'2' || left != b'0'));
    }
    for text in [&conservative, &exact] {
        assert!(text.ends_with("\"witnesses\": []}\n"), "{text}");
    }
    assert!(rows(&conservative).iter().any(|row| row.contains('3')));
}

#[test]
fn a_budget_leaves_pairs_undecided_that_may_be_seen() {
    let folder = tempfile::tempdir().unwrap();
    let output = folder.path().join("objects.json");
    let output = output.to_str().unwrap();
    let run = stabline(root(), &["pvs", SCENE, "--budget", "0", "--objects", output]);
    assert_eq!(run.status.code(), Some(4), "{}", stderr(&run));
    let left = rows(&fs::read_to_string(output).unwrap());
    for (left, seen) in left.iter().zip(rows(&objects(&root().join(SCENE), &[]))) {
        assert!(left.bytes().zip(seen.bytes()).all(|(left, seen)| seen != b'2' || left != b'0'));
    }
    assert!(left.iter().any(|row| row.contains('3')));
}

#[test]
fn what_states_no_objects_is_refused_in_words() {
    let folder = tempfile::tempdir().unwrap();
    let graph = root().join("scenes/pvs/gallery_nine_rooms.json");
    let run =
        stabline(folder.path(), &["pvs", graph.to_str().unwrap(), "--objects", "objects.json"]);
    assert_fails(&run, 2, "is a portal graph, which states no objects");
    assert!(!folder.path().join("objects.json").exists());
    let run = stabline(root(), &["pvs", SCENE, "--objects", "x.json", "--shard", "1/2"]);
    assert_fails(&run, 2, "--shard");
}

#[test]
fn an_interruption_leaves_no_result_behind() {
    let folder = tempfile::tempdir().unwrap();
    let scene = root().join(SCENE);
    let run = stabline(
        folder.path(),
        &["pvs", scene.to_str().unwrap(), "--objects", "objects.json", "--memory-limit", "1k"],
    );
    assert_eq!(run.status.code(), Some(130), "{}", stderr(&run));
    assert!(!folder.path().join("objects.json").exists());
}

#[test]
fn the_kept_schema_is_the_printed_one() {
    let run = stabline(root(), &["schema", "objects"]);
    let kept = fs::read(root().join("docs/formats/stabline-objects-1.schema.json")).unwrap();
    assert_eq!(run.stdout, kept);
}

/// The pairs of the smallest public level.
#[test]
fn the_objects_of_a_public_level() {
    let Some(maps) = maps() else {
        eprintln!("skipped: the public maps are not here");
        return;
    };
    let input = maps.join("lq_e0m1/lq_e0m1.map");
    let text = objects(&input, &[]);
    let json: Value = serde_json::from_str(&text).unwrap();
    let count = |name: &str| json["counts"][name].as_u64().unwrap();
    assert_eq!((json["objects"].as_array().unwrap().len(), count("nowhere")), (77, 0));
    let witnesses = json["witnesses"].as_array().unwrap().len() as u64;
    assert_eq!(count("seen"), count("inside") + witnesses);
    let (mut seen, mut left) = (0, 0);
    let conservative = objects(&input, &["--objects-method", "conservative"]);
    for (exact, bound) in rows(&text).iter().zip(rows(&conservative)) {
        for (exact, bound) in exact.bytes().zip(bound.bytes()) {
            assert!(exact != b'2' || bound != b'0');
            seen += u32::from(exact == b'2');
            left += u32::from(bound != b'0');
        }
    }
    assert!(count("inside") > 77 && witnesses > 1000 && seen < left);
}
