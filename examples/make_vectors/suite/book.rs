//! A file in the making: groups and tests, each with its proof.

use super::notes::note;
use super::number::{Polygon, values};
use serde_json::{Value, json};
use stabline::formats::sequence::{SequenceFile, SequencePoints};
use stabline::report::StabReport;
use stabline::stab::hourglass::Hourglass;
use stabline::stab::{Portal3, Stabber};
use stabline::vectors::{Class, Group, Kind, Test, VectorsFile};

/// A file in the making.
pub struct Book {
    file: VectorsFile,
}

impl Book {
    /// An empty file.
    pub fn new(name: &str, about: &str) -> Book {
        let file = VectorsFile {
            format: VectorsFile::FORMAT.to_owned(),
            name: name.to_owned(),
            about: about.to_owned(),
            number_of_tests: 0,
            notes: Default::default(),
            groups: Vec::new(),
        };
        Book { file }
    }

    /// Begins a group without a scene.
    pub fn group(&mut self, kind: Kind, about: &str) {
        let (about, tests) = (about.to_owned(), Vec::new());
        self.file.groups.push(Group { kind, about, scene: None, tests });
    }

    /// Adds a test to the group that was begun last.
    pub fn test(&mut self, comment: &str, flags: &[&str], test: Test) {
        self.file.number_of_tests += 1;
        for flag in flags {
            self.file.notes.entry((*flag).to_owned()).or_insert_with(|| note(flag));
        }
        let test = Test {
            tc_id: self.file.number_of_tests,
            comment: comment.to_owned(),
            flags: flags.iter().map(|&flag| flag.to_owned()).collect(),
            ..test
        };
        let group = self.file.groups.last_mut().expect("a group was begun");
        group.tests.push(test);
    }

    /// Adds a sequence, which is `truth` by its construction.
    pub fn sequence(&mut self, comment: &str, flags: &[&str], portals: &[Polygon], truth: Class) {
        let portals: Vec<Value> = portals.iter().map(|portal| values(portal)).collect();
        let input = json!({ "format": "stabline-sequence/1", "portals": portals });
        let test = Test { input: Some(input.clone()), ..of_sequence(&input) };
        assert_eq!(test.class, Some(truth), "{}: {comment}: {input}", self.file.name);
        self.test(comment, flags, test);
    }

    /// The file.
    pub fn finish(self) -> VectorsFile {
        if let Err(error) = self.file.check() {
            panic!("{}: {error}", self.file.name);
        }
        self.file
    }
}

/// The verdict on a sequence, with its proof.
pub fn of_sequence(input: &Value) -> Test {
    let bytes = input.to_string().into_bytes();
    let points = SequenceFile::read(&bytes).and_then(|file| file.points());
    let report = match points.unwrap_or_else(|error| panic!("{error}: {input}")) {
        SequencePoints::Space { denominator, portals } => {
            let mut stabber = Stabber::new();
            for vertices in &portals {
                let portal = Portal3::new(vertices);
                let portal = portal.unwrap_or_else(|error| panic!("{error}: {input}"));
                stabber.push(&portal, false);
            }
            StabReport::new(&stabber.verdict(), &[], &denominator, false)
        }
        SequencePoints::Plane { denominator, portals } => {
            let mut hourglass = Hourglass::new();
            for [left, right] in portals {
                hourglass.push_big(left, right);
            }
            StabReport::of_plane(&hourglass.verdict(), &denominator)
        }
    };
    of_report(&report)
}

/// The fields of a test that a verdict's report fills.
pub fn of_report(report: &StabReport) -> Test {
    let report: Value = serde_json::from_str(&report.to_json()).expect("it is JSON");
    let field = |name: &str| report.get(name).filter(|value| !value.is_null()).cloned();
    let class = match report["verdict"].as_str() {
        Some("open") => Class::Open,
        Some("grazing") => Class::Grazing,
        _ => Class::Blocked,
    };
    Test {
        class: Some(class),
        witness: field("witness"),
        touching_line: field("touching_line"),
        certificate: field("certificate"),
        ..Test::default()
    }
}
