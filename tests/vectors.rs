//! The test vectors: they are what is generated, every answer is proved by what stands beside it,
//! and the engine and its twin give it.

#[path = "../examples/make_vectors/suite/mod.rs"]
#[allow(dead_code, reason = "the generator uses all of it")]
mod suite;
mod support;
mod vectors_exact;

use serde_json::{Value, json};
use stabline::formats::sequence::{SequenceFile, SequencePoints};
use stabline::oracle::{PlaneTruth, Truth, classify, classify_2d};
use stabline::vectors::{Class, Expected, Group, Kind, Test, VectorsFile, answer};
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::process::Command;

fn path(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(format!("vectors/{name}.json"))
}

fn committed(name: &str) -> VectorsFile {
    let bytes = std::fs::read(path(name)).expect("the file is committed");
    VectorsFile::read(&bytes).unwrap_or_else(|error| panic!("{name}: {error}"))
}

fn check_generated(name: &str) {
    let text = std::fs::read_to_string(path(name)).expect("the file is committed");
    assert!(suite::file(name).to_text() == text, "{name}: run the example make_vectors");
}

/// The other files share all but their frames with these; `make_vectors` writes them all.
#[test]
fn files_are_what_is_generated() {
    ["transversals", "sequences_2d", "eyes"].into_iter().for_each(check_generated);
}

#[test]
fn files_are_canonical_and_every_flag_has_cases() {
    let (mut count, mut flags) = (0, BTreeMap::<String, u32>::new());
    let mut kinds = BTreeMap::<Kind, u32>::new();
    for name in suite::NAMES {
        let file = committed(name);
        assert_eq!(file.name, name);
        assert!(file.to_text().as_bytes() == std::fs::read(path(name)).unwrap(), "{name}");
        count += file.number_of_tests;
        for (group, test) in file.tests() {
            assert!(test.comment.len() > 10 && !test.flags.is_empty(), "{name} {}", test.tc_id);
            test.flags.iter().for_each(|flag| *flags.entry(flag.clone()).or_default() += 1);
            *kinds.entry(group.kind).or_default() += 1;
        }
    }
    assert!(count >= 2000, "{count} cases");
    assert_eq!(kinds.len(), Kind::ALL.len());
    let rare: Vec<_> = flags.iter().filter(|(_, count)| **count < 10).collect();
    assert!(rare.is_empty(), "{rare:?}");
}

#[test]
fn every_witness_touching_line_and_certificate_holds() {
    for name in suite::NAMES {
        let file = committed(name);
        for (group, test) in file.tests() {
            if let Err(what) = vectors_exact::check(group, test) {
                panic!("{name} {}: {what}: {}", test.tc_id, test.comment);
            }
        }
    }
}

/// Where, and what becomes of it.
type Change<'c> = (&'c str, &'c dyn Fn(&mut Value));

/// The certificate, changed in one place each so that it proves nothing.
fn tampered(certificate: &Value) -> Vec<Value> {
    let with = |pointer: &str, to: &dyn Fn(&mut Value)| {
        let mut changed = certificate.clone();
        changed.pointer_mut(pointer).map(to).map(|()| changed)
    };
    let other_last = |text: &mut Value| {
        let (start, last) = text.as_str().unwrap().rsplit_once(' ').unwrap();
        *text = json!(format!("{start} 1{last}"));
    };
    let without_last = |list: &mut Value| {
        list.as_array_mut().unwrap().pop();
    };
    let another = |number: &mut Value| *number = json!("1234567/89");
    let twice = |list: &mut Value| list[0] = list[1].clone();
    let changes: [Change; 9] = [
        ("/refutation", &other_last),
        ("/reason/refutation", &other_last),
        ("/ways", &without_last),
        ("/closed/offset", &another),
        ("/lines", &without_last),
        ("/quadratic/form/0", &another),
        ("/quadratic/vectors", &without_last),
        ("/three", &twice),
        ("/three", &without_last),
    ];
    // Nothing can be taken from no lines.
    let is_other = |changed: &Value| changed != certificate;
    changes.iter().filter_map(|(at, to)| with(at, to)).filter(is_other).collect()
}

#[test]
fn tampered_certificates_are_refused() {
    let mut count = 0;
    for name in ["scenes_3d", "sequences_3d", "transversals"] {
        let file = committed(name);
        let proved = |(_, test): &(&Group, &Test)| test.class != Some(Class::Open);
        for (group, test) in file.tests().filter(proved).step_by(3) {
            for certificate in test.certificate.iter().flat_map(tampered) {
                count += 1;
                let changed = Test { certificate: Some(certificate), ..test.clone() };
                let checked = vectors_exact::check(group, &changed);
                assert!(checked.is_err(), "{name} {}: {:?}", test.tc_id, changed.certificate);
            }
        }
    }
    assert!(count > 400, "{count}");
}

/// The twin's verdict on a sequence.
fn by_twin(test: &Test) -> Class {
    let bytes = test.input.as_ref().expect("a sequence").to_string().into_bytes();
    match SequenceFile::read(&bytes).and_then(|file| file.points()).expect("a sequence") {
        SequencePoints::Space { portals, .. } => match classify(&portals) {
            Truth::Open(_) => Class::Open,
            Truth::Grazing(_) => Class::Grazing,
            Truth::Blocked => Class::Blocked,
        },
        SequencePoints::Plane { portals, .. } => match classify_2d(&portals) {
            PlaneTruth::Open => Class::Open,
            PlaneTruth::Grazing => Class::Grazing,
            PlaneTruth::Blocked => Class::Blocked,
        },
    }
}

#[test]
fn the_twin_agrees_on_a_share_of_the_sequences() {
    for (name, step, most) in [("sequences_2d", 3, 8), ("sequences_3d", 17, 3)] {
        let file = committed(name);
        let small = |(_, test): &(&Group, &Test)| {
            let portals = test.input.as_ref().map(|input| input["portals"].clone());
            let portals = portals.as_ref().and_then(|portals| portals.as_array());
            portals.is_some_and(|portals| {
                portals.len() <= most && portals.iter().all(|p| p.as_array().unwrap().len() <= 4)
            })
        };
        let share: Vec<_> = file.tests().filter(small).step_by(step).collect();
        assert!(share.len() >= 20, "{}", share.len());
        // Those that only products of sides refute are the search's word, so all of them.
        let is_quadric = |test: &Test| test.flags.iter().any(|flag| flag == "Quadric");
        let quadric = file.tests().filter(small).filter(|(_, test)| is_quadric(test));
        for (_, test) in share.into_iter().chain(quadric) {
            assert_eq!(Some(by_twin(test)), test.class, "{name} {}", test.tc_id);
        }
    }
}

#[test]
fn the_engine_agrees_on_a_share_of_all() {
    for name in suite::NAMES {
        for (group, test) in committed(name).tests().step_by(17) {
            let expected = test.expected().as_ref().map(Expected::answer);
            assert_eq!(answer(&group.case(test)).ok(), expected, "{name} {}", test.tc_id);
        }
    }
}

#[test]
fn the_engine_scores_full_marks_through_the_runner() {
    let stabline = env!("CARGO_BIN_EXE_stabline");
    let run = |more: &[&str], answer: &[&str]| {
        let files = ["transversals", "eyes"].map(|name| format!("--file={}", path(name).display()));
        let mut command = Command::new(stabline);
        command.args(["vectors", "run", "--json"]).args(files).args(more).arg("--");
        let output = command.arg(stabline).args(["vectors", "answer"]).args(answer).output();
        let output = output.expect("it runs");
        let score: serde_json::Value = serde_json::from_slice(&output.stdout).expect("a score");
        assert!(output.status.success(), "{score}");
        assert_eq!(score["all"]["cases"], score["all"]["exact"], "{score}");
    };
    run(&["--stream"], &["--stream"]);
    run(&["--flag=AtInfinity"], &[]);
}

/// The runner's score of a program that says the same of every case of a file.
fn score_of(said: &str, file: &str) -> Value {
    let program = format!("while read -r case; do echo '{said}'; done");
    let mut command = Command::new(env!("CARGO_BIN_EXE_stabline"));
    command.args(["vectors", "run", "--json", "--stream", "--file"]).arg(path(file));
    let output = command.args(["--", "sh", "-c", &program]).output().expect("it runs");
    serde_json::from_slice(&output.stdout).expect("a score")
}

#[test]
fn a_line_that_is_shown_has_to_be_inside() {
    // The engine shows one for each open sequence.
    let stabline = env!("CARGO_BIN_EXE_stabline");
    let mut command = Command::new(stabline);
    command.args(["vectors", "run", "--json", "--stream", "--kind=sequence", "--flag=OneUnit"]);
    command.args(
        ["sequences_2d", "sequences_3d"].map(|file| format!("--file={}", path(file).display())),
    );
    let output = command.args(["--", stabline, "vectors", "answer", "--stream"]).output();
    let score: Value = serde_json::from_slice(&output.expect("it runs").stdout).expect("a score");
    assert_eq!(score["all"]["cases"], score["all"]["exact"], "{score}");

    let open = score_of(r#"{"class": "open"}"#, "sequences_2d");
    assert_eq!(open["all"].get("wrong-witness"), None);
    let line = r#"{"class": "open", "witness": [["1/2", -9], ["1/2", 9]]}"#;
    let shown = score_of(line, "sequences_2d");
    let count = |score: &Value, mark: &str| score["all"][mark].as_u64().unwrap_or(0);
    assert!(count(&shown, "wrong-witness") > 100 && count(&shown, "exact") > 10, "{shown}");
    assert_eq!(count(&shown, "waste") + count(&shown, "allowed"), 0, "{shown}");
    // In a graph only a line with its portals is looked at.
    let line = r#"{"class": "open", "witness": [["1/2", -9], ["1/2", 9]], "portals": [0]}"#;
    assert!(count(&score_of(line, "graphs_2d"), "wrong-witness") > 100);
}
