//! Every scene of a portal sequence against its snapshot, the laws of the verdict, and the command.

mod support;

use stabline::formats::sequence::{SequenceFile, SequencePoints};
use stabline::geom::BigPoint3;
use stabline::num::Int;
use stabline::oracle::{Family, sequence};
use stabline::stab::{Portal3, Stabber, Verdict, decide_open};
use std::process::Output;
use support::{root, scenes, stabline};

fn stdout(output: &Output) -> String {
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout.clone()).unwrap()
}

#[test]
fn scenes_match_their_snapshots() {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(root().join("snapshots/stab"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    for path in scenes("scenes/stab") {
        let file = SequenceFile::read(&std::fs::read(&path).unwrap()).unwrap();
        settings.set_description(file.about.clone().unwrap());
        let name = path.file_stem().unwrap().to_str().unwrap().to_owned();
        let text = stdout(&stabline(root(), &["stab", path.to_str().unwrap()]));
        settings.bind(|| insta::assert_snapshot!(name, text));
    }
}

#[test]
fn the_json_says_what_the_text_says() {
    for path in scenes("scenes/stab") {
        let path = path.to_str().unwrap();
        let json: serde_json::Value =
            serde_json::from_str(&stdout(&stabline(root(), &["stab", path, "--json"]))).unwrap();
        let text = stdout(&stabline(root(), &["stab", path]));
        let verdict = json["verdict"].as_str().unwrap();
        assert_eq!(text.lines().next().unwrap(), verdict);
        assert_eq!(json["witness"].is_array(), verdict == "open");
        assert_eq!(json["touching_line"].is_array(), verdict == "grazing");
        assert_eq!(json["certificate"].is_null(), verdict == "open");
        if verdict == "open" {
            for point in json["witness"].as_array().unwrap() {
                assert!(point.as_array().unwrap().iter().all(serde_json::Value::is_string));
            }
        }
    }
}

#[test]
fn lines_are_listed_with_the_edges_they_touch() {
    let scene = "scenes/stab/regulus_tight.json";
    let json = stdout(&stabline(root(), &["stab", scene, "--json", "--lines"]));
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    let lines = json["lines"].as_array().unwrap();
    assert_eq!(lines.len() as u64, json["extremal_lines"].as_u64().unwrap());
    assert!(!lines.is_empty());
    assert!(lines.iter().all(|line| line["edges"].as_array().unwrap().len() >= 4));
}

#[test]
fn the_order_is_asked_for_by_an_option() {
    let scene = "scenes/stab/order_wrong.json";
    assert!(stdout(&stabline(root(), &["stab", scene])).starts_with("open\n"));
    let ordered = stdout(&stabline(root(), &["stab", scene, "--ordered"]));
    assert!(ordered.starts_with("grazing\n"), "{ordered}");
    assert!(ordered.contains("portal 1 after 0"), "{ordered}");
}

#[test]
fn bad_input_is_refused_by_name_and_place() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("bad.json");
    let portals = |text: &str| format!(r#"{{"format": "stabline-sequence/1", "portals": {text}}}"#);
    for (content, expected) in [
        (String::new(), "bad.json: line 1, column 0: EOF while parsing a value"),
        (r#"{"format": "stabline-sequence/1"}"#.to_owned(), "missing field `portals`"),
        (r#"{"format": "x/1", "portals": []}"#.to_owned(), "expected `stabline-sequence/1`"),
        (portals("[]"), "portals: expected at least one"),
        (portals("[[]]"), "portals[0]: has no vertices"),
        (portals("[[[1]]]"), "portals[0]: vertex 0 has 1 coordinates, expected 2 or 3"),
        (portals("[[[0,0,0],[1,0],[0,1,0]]]"), "portals[0]: vertex 1 has 2 coordinates"),
        (portals("[[[0,0],[1,0],[2,0]]]"), "portals[0]: has 3 vertices, expected the 2 ends"),
        (portals("[[[0,0],[1,0]],[[1,1],[1,1]]]"), "portals[1]: vertex 1 is the same point"),
        (portals("[[[0,0,0],[1,0,0]]]"), "portals[0]: has 2 vertices"),
        (
            portals("[[[0,0,0],[1,0,0],[0,1,0]],[[0,0,0],[1,0,0],[1,0,0],[0,1,0]]]"),
            "portals[1]: vertex 2 is the same point as vertex 1",
        ),
        (portals("[[[0,0,0],[1,0,0],[2,0,0]]]"), "portals[0]: has no area"),
        (
            portals("[[[0,0,0],[1,0,0],[1,1,0.0000000000000001],[0,1,0]]]"),
            "portals[0]: vertex 1 is not in the plane",
        ),
        (
            portals("[[[0,0,0],[4,0,0],[1,1,0],[0,4,0]]]"),
            "portals[0]: is not convex: vertex 3 lies outside edge 1",
        ),
        (portals(r#"[[[0,0,"nan"]]]"#), "coordinate `nan`"),
    ] {
        std::fs::write(&path, &content).unwrap();
        let output = stabline(root(), &["stab", path.to_str().unwrap()]);
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(3), "{content}: {message}");
        assert!(message.contains(expected), "{content}: {message}");
        assert!(output.stdout.is_empty());
    }
    assert_eq!(stabline(root(), &["stab", "no/such/file"]).status.code(), Some(3));
    assert_eq!(stabline(root(), &["stab"]).status.code(), Some(2));
    let plane = "scenes/stab/plane_gates_open.json";
    assert_eq!(stabline(root(), &["stab", plane, "--lines"]).status.code(), Some(2));
}

type Points = Vec<Vec<BigPoint3>>;

fn verdict(points: &Points) -> (u8, usize) {
    let mut stabber = Stabber::new();
    for vertices in points {
        stabber.push(&Portal3::new(vertices).unwrap(), false);
    }
    let kind = match stabber.verdict() {
        Verdict::Open { .. } => 2,
        Verdict::Grazing { .. } => 1,
        Verdict::Blocked { .. } => 0,
    };
    (kind, stabber.extremal_lines().len())
}

fn mapped(points: &Points, map: impl Fn([Int; 3]) -> [Int; 3]) -> Points {
    let point = |p: &BigPoint3| BigPoint3 { coordinates: map(p.coordinates.clone()) };
    points.iter().map(|portal| portal.iter().map(point).collect()).collect()
}

#[test]
fn verdict_and_extremal_lines_are_kept_by_the_laws() {
    for family in Family::ALL {
        for seed in 1000..1025 {
            let name = format!("{family:?} {seed}");
            let points = sequence(family, seed);
            let truth = verdict(&points);
            let mut permuted = points.clone();
            permuted.rotate_left(1);
            assert_eq!(verdict(&permuted), truth, "{name}: sides alone know no order");
            let mut reversed: Points =
                points.iter().map(|p| p.iter().rev().cloned().collect()).collect();
            reversed.reverse();
            assert_eq!(verdict(&reversed), truth, "{name}: reversal");
            let mut rolled = points.clone();
            rolled.iter_mut().for_each(|portal| portal.rotate_left(1));
            assert_eq!(verdict(&rolled), truth, "{name}: first vertex");
            let moved = mapped(&points, |[x, y, z]| [x + 12345, y - 999, z + 77]);
            assert_eq!(verdict(&moved), truth, "{name}: translation");
            let scaled = mapped(&points, |p| p.map(|c| c * 1009));
            assert_eq!(verdict(&scaled), truth, "{name}: scaling");
            let sheared = mapped(&points, |[x, y, z]| [&x + &y * 3, &y + &z * 2, z]);
            assert_eq!(verdict(&sheared), truth, "{name}: affine maps keep lines");
            let mut mirrored = mapped(&points, |[x, y, z]| [-x, y, z]);
            mirrored.iter_mut().for_each(|portal| portal.reverse());
            assert_eq!(verdict(&mirrored), truth, "{name}: mirror image");
            let mut shorter = points.clone();
            shorter.pop();
            assert!(verdict(&shorter).0 >= truth.0, "{name}: a portal more never opens");
        }
    }
}

#[test]
fn pushing_and_popping_forgets() {
    let points = sequence(Family::Axial, 3);
    let portals: Vec<Portal3> = points.iter().map(|p| Portal3::new(p).unwrap()).collect();
    let other = Portal3::new(&sequence(Family::Random, 5)[0]).unwrap();
    let mut stabber = Stabber::new();
    for portal in &portals {
        stabber.push(&other, true);
        stabber.pop();
        stabber.push(portal, false);
    }
    let refs: Vec<&Portal3> = portals.iter().collect();
    assert_eq!(stabber.witness(), decide_open(&refs, &[]));
    portals.iter().for_each(|_| stabber.pop());
    assert!(stabber.is_open() && stabber.depth() == 0);
}

#[test]
fn decimals_become_the_grid() {
    let text = r#"{"format": "stabline-sequence/1",
        "portals": [[[0,0,0.5],[1,0,"1/2"],[0,1,5e-1]]]}"#;
    let file = SequenceFile::read(text.as_bytes()).unwrap();
    let SequencePoints::Space { denominator, portals } = file.points().unwrap() else {
        panic!("a polygon of space")
    };
    assert_eq!(denominator, Int::from(2));
    assert_eq!(portals[0][1].coordinates, [2, 0, 1].map(Int::from));
}
