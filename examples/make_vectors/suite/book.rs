//! A file in the making: groups and tests, each with its proof.

use super::family::Seq;
use super::notes::note;
use super::number::{Polygon, values};
use serde_json::{Value, json};
use stabline::formats::sequence::{SequenceFile, SequencePoints};
use stabline::geom::{BigPoint3, RationalPoint3};
use stabline::num::Int;
use stabline::report::{StabReport, refutation_text};
use stabline::stab::hourglass::Hourglass;
use stabline::stab::{Certificate, Portal3, Stabber, Verdict};
use stabline::vectors::{Class, Group, Kind, SceneOfGroup, Test, VectorsFile, answer};
use std::collections::BTreeSet;

/// Grazing cases have their touching line; why they are not open is added where it is this short.
const LONGEST_REASON: usize = 1500;

/// A file in the making.
pub struct Book {
    file: VectorsFile,
    /// Cases whose answer is another than the construction says.
    wrong: Vec<String>,
    /// What was asked already.
    asked: BTreeSet<String>,
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
        Book { file, wrong: Vec::new(), asked: BTreeSet::new() }
    }

    /// Begins a group without a scene.
    pub fn group(&mut self, kind: Kind, about: &str) {
        let (about, tests) = (about.to_owned(), Vec::new());
        self.file.groups.push(Group { kind, about, scene: None, tests });
    }

    /// Adds a test to the group that was begun last, if it asks what no other does.
    pub fn test(&mut self, comment: &str, flags: &[&str], test: Test) {
        let group = self.file.groups.last_mut().expect("a group was begun");
        let mut scene = group.scene.as_ref().map(|scene| scene.input.clone());
        scene.iter_mut().for_each(|scene| scene["about"] = Value::Null);
        let question = json!([group.kind, scene, test.input, test.from, test.to]);
        if !self.asked.insert(question.to_string()) {
            return;
        }
        self.file.number_of_tests += 1;
        for flag in flags {
            self.file.notes.entry((*flag).to_owned()).or_insert_with(|| note(flag));
        }
        group.tests.push(Test {
            tc_id: self.file.number_of_tests,
            comment: comment.to_owned(),
            flags: flags.iter().map(|&flag| flag.to_owned()).collect(),
            ..test
        });
    }

    /// How many tests there are.
    pub fn count(&self) -> u32 {
        self.file.number_of_tests
    }

    /// Begins a group of tests that share a scene.
    pub fn scene(&mut self, kind: Kind, about: &str, name: &str, mut input: Value) {
        self.group(kind, about);
        input["about"] = json!(about);
        let group = self.file.groups.last_mut().expect("a group was begun");
        group.scene = Some(SceneOfGroup::new(name, input));
    }

    /// Adds a sequence.
    pub fn sequence(&mut self, case: &Seq) {
        let test = of_portals(&case.portals);
        let test = Test { input: Some(sequence_input(&case.portals)), ..test };
        self.judged(case, test);
    }

    /// Adds a test that must have the class of the case's construction, and no other.
    pub fn judged(&mut self, case: &Seq, test: Test) {
        if test.class != Some(case.class) {
            let what = format!("{:?}, not {:?}: {}", test.class, case.class, case.comment);
            self.wrong.push(what);
        }
        self.test(&case.comment, &case.flags, test);
    }

    /// The file, after every scene's answers were compared with the searches'.
    ///
    /// # Panics
    /// If an answer is another than the construction says.
    pub fn finish(mut self) -> VectorsFile {
        self.file.groups.retain(|group| !group.tests.is_empty());
        for (group, test) in self.file.tests().filter(|(group, _)| group.kind != Kind::Sequence) {
            let expected = test.expected().expect("one answer is stated");
            match answer(&group.case(test)) {
                Ok(got) if got == expected.answer() => {}
                got => self.wrong.push(format!(
                    "{}: {got:?}, not {:?}: {}",
                    test.tc_id,
                    test.expected(),
                    group.case(test).to_line()
                )),
            }
        }
        assert!(self.wrong.is_empty(), "{}:\n{}", self.file.name, self.wrong.join("\n"));
        if let Err(error) = self.file.check() {
            panic!("{}: {error}", self.file.name);
        }
        self.file
    }
}

/// A sequence in JSON.
pub fn sequence_input(portals: &[Polygon]) -> Value {
    let portals: Vec<Value> = portals.iter().map(|portal| values(portal)).collect();
    json!({ "format": "stabline-sequence/1", "portals": portals })
}

/// The verdict on a sequence, with its proof.
pub fn of_portals(portals: &[Polygon]) -> Test {
    let input = sequence_input(portals);
    let points = SequenceFile::read(input.to_string().as_bytes()).and_then(|file| file.points());
    match points.unwrap_or_else(|error| panic!("{error}: {input}")) {
        SequencePoints::Space { denominator, portals } => {
            let mut stabber = Stabber::new();
            for vertices in &portals {
                let portal = Portal3::new(vertices);
                let portal = portal.unwrap_or_else(|error| panic!("{error}: {input}"));
                stabber.push(&portal, false);
            }
            let verdict = stabber.verdict();
            let reason = match &verdict {
                Verdict::Open { .. } => None,
                Verdict::Grazing { certificate, .. } | Verdict::Blocked { certificate } => {
                    Some(refutation(certificate, &portals, &denominator))
                }
            };
            let test = of_report(&StabReport::new(&verdict, &[], &denominator, false));
            let is_kept =
                |text: &String| test.class == Some(Class::Blocked) || text.len() <= LONGEST_REASON;
            let reason = reason.filter(is_kept).map(|text| json!({ "refutation": text }));
            Test { certificate: reason, ..test }
        }
        SequencePoints::Plane { denominator, portals } => {
            let mut hourglass = Hourglass::new();
            for [left, right] in portals {
                hourglass.push_big(left, right);
            }
            of_report(&StabReport::of_plane(&hourglass.verdict(), &denominator))
        }
    }
}

/// A certificate in the words of proofs.
fn refutation(certificate: &Certificate, portals: &[Vec<BigPoint3>], units: &Int) -> String {
    let in_world = |p: &BigPoint3| RationalPoint3::new(p.coordinates.clone(), units.clone());
    let portals: Vec<Vec<RationalPoint3>> =
        portals.iter().map(|portal| portal.iter().map(in_world).collect()).collect();
    let portals = portals.iter().map(|portal| portal.iter().collect()).collect();
    refutation_text(certificate, portals, units)
}

/// The fields of a test that a verdict's report fills.
fn of_report(report: &StabReport) -> Test {
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
