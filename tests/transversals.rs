//! Every scene of four lines against its snapshot, and the command that answers them.

mod support;

use stabline::formats::lines::LinesFile;
use stabline::report::{TransversalsReport, transversals_text};
use stabline::stab::transversals::transversals;
use support::{root, scenes, stabline};

#[test]
fn scenes_match_their_snapshots() {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(root().join("snapshots/transversals"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    for path in scenes("scenes/transversals") {
        let file = LinesFile::read(&std::fs::read(&path).unwrap()).unwrap();
        settings.set_description(file.about.clone().unwrap());
        let text = transversals_text(&transversals(&file.lines().unwrap()));
        let name = path.file_stem().unwrap().to_str().unwrap().to_owned();
        settings.bind(|| insta::assert_snapshot!(name, text));
    }
}

#[test]
fn the_json_says_what_the_text_says() {
    for path in scenes("scenes/transversals") {
        let file = LinesFile::read(&std::fs::read(&path).unwrap()).unwrap();
        let result = transversals(&file.lines().unwrap());
        let json: serde_json::Value =
            serde_json::from_str(&TransversalsReport::new(&result).to_json()).unwrap();
        let text = transversals_text(&result);
        let kind = json["kind"].as_str().unwrap();
        let headline = match kind {
            "none" => "no line meets",
            "one" => "one line meets",
            "two" => "two lines meet",
            _ => "infinitely many lines meet",
        };
        assert!(text.starts_with(headline), "{kind}: {text}");
        assert_eq!(kind == "family", !json["families"].as_array().unwrap().is_empty());
        let points = |value: &serde_json::Value| value.as_array().unwrap().len();
        assert_eq!(points(&json["lines"]), result.isolated.len());
        assert_eq!(points(&json["at_infinity"]), result.at_infinity.len());
    }
}

#[test]
fn the_command_prints_text_or_json() {
    let scene = "scenes/transversals/lines_skew_two.json";
    let text = stabline(root(), &["transversals", scene]);
    assert_eq!(text.status.code(), Some(0));
    assert!(text.stdout.starts_with(b"two lines meet all four\n"));
    let json = stabline(root(), &["transversals", scene, "--json"]);
    let json: serde_json::Value = serde_json::from_slice(&json.stdout).unwrap();
    assert_eq!(json["kind"], "two");
    assert_eq!(json["lines"][0]["points"][1][2]["d"], "2");
    assert_eq!(stabline(root(), &["transversals", scene]).stdout, text.stdout);
}

#[test]
fn bad_input_is_refused_by_name_and_place() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("lines.json");
    for (content, expected) in [
        ("", "lines.json: line 1, column 0: EOF while parsing a value"),
        ("[", "lines.json: line 1, column 1: "),
        (r#"{"format": "stabline-lines/1"}"#, "missing field `lines`"),
        (r#"{"format": "stabline-lines/1", "lines": []}"#, "lines: expected 4, got 0"),
        (r#"{"format": "stabline-lines/2", "lines": []}"#, "expected `stabline-lines/1`"),
    ] {
        std::fs::write(&path, content).unwrap();
        let output = stabline(root(), &["transversals", path.to_str().unwrap()]);
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(3), "{message}");
        assert!(message.contains(expected), "{message}");
        assert!(output.stdout.is_empty());
    }
    assert_eq!(stabline(root(), &["transversals", "no/such/file"]).status.code(), Some(3));
    assert_eq!(stabline(root(), &["transversals"]).status.code(), Some(2));
}
