//! The forge: every family makes valid cases, our two engines and the twins agree on them, laws
//! hold and can be broken, and the commands do what they say.
//!
//! `STABLINE_CASES=N` sets the number of cases a family (default 12); `examples/soak.rs` is for
//! many.

mod support;

use serde_json::{Value, json};
use stabline::forge::{
    FAMILIES, Family, Input, LAWS, Relation, Settings, accepts, check, find, graph_of,
    occluders_of, portal_graph, regions_of, test_of,
};
use stabline::num::{Number, Random};
use stabline::oracle::{MeetingLines, meeting_lines};
use stabline::scene::read_graph;
use stabline::vectors::{Answer, Case, Class, Kind, LineCount, Test, VectorsFile, Witness, answer};
use stabline::verify::verify;
use std::collections::BTreeSet;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};
use support::{assert_fails, root, stabline, stderr, stdout};

fn count() -> u64 {
    std::env::var("STABLINE_CASES").ok().and_then(|n| n.parse().ok()).unwrap_or(12)
}

/// What the family takes if nothing is said, and the rooms of a gallery where it takes a map.
fn defaults(family: &Family) -> Settings {
    let map = || {
        let bytes = std::fs::read(root().join(GALLERY)).unwrap();
        graph_of(&read_graph(GALLERY, &bytes).unwrap())
    };
    family.settings(&[], family.from_map.then(map)).unwrap()
}

const GALLERY: &str = "scenes/pvs/gallery_nine_rooms.json";

/// Inputs of every family, with their names.
fn inputs() -> impl Iterator<Item = (&'static Family, String, Input)> {
    FAMILIES.iter().flat_map(|family| {
        let settings = defaults(family);
        (0..count()).map(move |number| {
            let name = format!("{} {number}", family.name);
            (family, name, family.input(&settings, 3, number))
        })
    })
}

#[test]
fn families_make_valid_cases_of_their_kind_that_read_back() {
    for (family, name, input) in inputs() {
        assert!(accepts(&input), "{name}");
        let case = input.case(7, "why", &[family.name]);
        assert_eq!(case.kind, family.kind, "{name}");
        let read = Case::read(case.to_line().as_bytes()).unwrap();
        assert_eq!(read, case, "{name}");
        assert_eq!(Input::of_case(&read).unwrap().case(7, "why", &[family.name]), case, "{name}");
    }
}

#[test]
fn a_case_is_a_function_of_family_seed_and_number() {
    let mut seen = BTreeSet::new();
    for family in FAMILIES {
        let settings = defaults(family);
        let line = |seed, number| family.input(&settings, seed, number).case(0, "", &[]).to_line();
        assert_eq!(line(1, 5), line(1, 5), "{}", family.name);
        let differ: BTreeSet<String> = (0..20).map(|number| line(1, number)).collect();
        assert!(differ.len() > 15, "{}: {} of 20 differ", family.name, differ.len());
        assert_ne!(
            (0..5).map(|n| line(1, n)).collect::<Vec<_>>(),
            (0..5).map(|n| line(2, n)).collect::<Vec<_>>()
        );
        assert!(seen.insert(family.name), "{} twice", family.name);
        assert!(family.purpose.len() > 20 && !family.purpose.contains("  "), "{}", family.name);
    }
}

#[test]
fn evidence_holds_and_both_engines_agree() {
    for (family, name, input) in inputs() {
        let found = find(&input).unwrap_or_else(|fault| panic!("{name}: {fault}"));
        let case = input.case(0, &name, &[family.name]);
        assert_eq!(answer(&case), Ok(found.answer), "{name}: {}", case.to_line());
    }
}

#[test]
fn every_class_comes_out_of_the_families() {
    let mut seen = BTreeSet::new();
    for kind in [Kind::Sequence, Kind::Graph, Kind::Scene] {
        for family in FAMILIES.iter().filter(|family| family.kind == kind) {
            for number in 0..40 {
                let found = find(&family.input(&defaults(family), 11, number)).unwrap();
                if let Answer::Class(class) = found.answer {
                    seen.insert((kind, class));
                }
            }
        }
    }
    assert_eq!(seen.len(), 9, "{seen:?}");
}

#[test]
fn four_lines_are_those_of_the_twin() {
    let family = Family::named("transversals").unwrap();
    let mut seen = [0; 4];
    for reach in [1, 2, 3, 20, 1000, 1 << 40] {
        let settings = family.settings(&[("reach".to_owned(), reach)], None).unwrap();
        for number in 0..400 {
            let input = family.input(&settings, 1, number);
            let Input::Lines(lines) = &input else { panic!("four lines") };
            let ends = |k: usize| [0, 1].map(|end| [0, 1, 2].map(|i| lines[k][end][i].clone()));
            let twin = match meeting_lines(&[0, 1, 2, 3].map(ends)) {
                MeetingLines::None => LineCount::None,
                MeetingLines::One => LineCount::One,
                MeetingLines::Two => LineCount::Two,
                MeetingLines::Family => LineCount::Family,
            };
            assert_eq!(find(&input).unwrap().answer, Answer::Lines(twin), "{reach} {number}");
            seen[twin as usize] += 1;
        }
    }
    assert!(seen.iter().all(|&count| count > 15), "{seen:?}");
}

/// Whether every law that applies holds for this way of answering.
fn laws_hold(input: &Input, kind: Kind, say: impl Fn(&Input) -> Answer) -> Result<usize, String> {
    let said = say(input);
    let mut held = 0;
    for law in LAWS.iter().filter(|law| law.applies_to(kind)) {
        let others = law.derive(input, &mut Random::new(held as u64));
        assert!(others.iter().all(accepts), "{}", law.name);
        let answers: Vec<Answer> = others.iter().map(&say).collect();
        if others.is_empty() {
            continue;
        }
        if !law.relation.holds(&said, &answers) {
            return Err(format!("{}: {said:?}, {answers:?}", law.name));
        }
        held += 1;
    }
    Ok(held)
}

#[test]
fn laws_hold_of_the_engine() {
    let mut held = 0;
    for (family, name, input) in inputs().filter(|(_, name, _)| name.ends_with(['0', '1', '2'])) {
        let say = |input: &Input| find(input).unwrap_or_else(|f| panic!("{name}: {f}")).answer;
        held += laws_hold(&input, family.kind, say).unwrap_or_else(|what| panic!("{name}: {what}"));
    }
    assert!(held > 500, "{held}");
}

#[test]
fn programs_that_look_at_coordinates_break_laws() {
    // Open if the first coordinate is positive; and: open if there are more than two portals.
    let by_place = |input: &Input| {
        let zero = stabline::num::Rational::from(stabline::num::Int::from(0));
        let positive = input.polygons().first().is_some_and(|polygon| polygon[0][0] > zero);
        Answer::Class(if positive { Class::Open } else { Class::Blocked })
    };
    let by_number = |input: &Input| {
        Answer::Class(if input.polygons().len() > 2 { Class::Open } else { Class::Blocked })
    };
    for family in FAMILIES.iter().filter(|family| family.kind != Kind::Transversals) {
        let inputs: Vec<Input> =
            (0..30).map(|number| family.input(&defaults(family), 1, number)).collect();
        let inputs = || inputs.iter().filter(|input| !input.polygons().is_empty());
        assert!(inputs().any(|i| laws_hold(i, family.kind, by_place).is_err()), "{}", family.name);
        // An occluder more or less need not change the answer about a scene.
        if family.kind != Kind::Scene {
            let name = family.name;
            assert!(inputs().any(|i| laws_hold(i, family.kind, by_number).is_err()), "{name}");
        }
    }
}

#[test]
fn relations_are_what_they_say() {
    let [blocked, grazing, open] = [Class::Blocked, Class::Grazing, Class::Open].map(Answer::Class);
    let holds =
        |relation: Relation, a: &Answer, b: &Answer| relation.holds(a, std::slice::from_ref(b));
    assert!(holds(Relation::Same, &open, &open) && !holds(Relation::Same, &open, &grazing));
    assert!(holds(Relation::SameOpen, &blocked, &grazing));
    assert!(!holds(Relation::SameOpen, &blocked, &open));
    assert!(
        holds(Relation::AtMost, &grazing, &blocked) && !holds(Relation::AtMost, &grazing, &open)
    );
    assert!(
        holds(Relation::AtLeast, &grazing, &open) && !holds(Relation::AtLeast, &grazing, &blocked)
    );
    assert!(holds(Relation::OpensNothing, &open, &blocked));
    assert!(!holds(Relation::OpensNothing, &grazing, &open));
    assert!(
        holds(Relation::KeepsOpen, &blocked, &open) && !holds(Relation::KeepsOpen, &open, &grazing)
    );
    let two = [blocked.clone(), grazing.clone()];
    assert!(Relation::Greatest.holds(&grazing, &two) && !Relation::Greatest.holds(&open, &two));
}

#[test]
fn stress_prints_cases_or_their_digest() {
    let text = |arguments: &[&str]| {
        let output = stabline(root(), arguments);
        assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
        stdout(&output)
    };
    let listed = text(&["stress", "--list"]);
    assert!(FAMILIES.iter().all(|family| listed.contains(&format!("{} (", family.name))));
    let lines = text(&["stress", "--family", "slit", "--count", "3", "--param", "digits=20"]);
    assert_eq!(lines.lines().count(), 3);
    let number = |line: &str| Case::read(line.as_bytes()).unwrap().tc_id;
    assert_eq!(lines.lines().map(number).collect::<Vec<_>>(), [0, 1, 2]);
    assert!(lines.contains("00000000000000000000"), "{lines}");
    let digest = text(&["stress", "--family", "gates", "--count", "20", "--digest"]);
    assert!(digest.starts_with("gates 20 seed 1 ") && digest.len() == 81, "{digest}");
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path().to_str().unwrap();
    assert_eq!(text(&["stress", "--family", "gates", "--count", "2", "--out", at]), "");
    assert!(folder.path().join("gates-1-1.json").exists());
}

#[test]
fn stress_refuses_what_it_does_not_know() {
    for (arguments, expected) in [
        (&["stress", "--family", "none"][..], "no family `none`, expected one of coplanar"),
        (
            &["stress", "--family", "gates", "--param", "x=1"],
            "no parameter `x`; it has portals, reach",
        ),
        (&["stress", "--family", "gates", "--param", "reach=0"], "expected 1 to "),
        (&["stress", "--family", "gates", "--param", "reach"], "expected K=V"),
        (&["stress"], "--family"),
    ] {
        assert_fails(&stabline(root(), arguments), 2, expected);
    }
}

#[cfg(unix)]
#[test]
fn stress_asks_programs() {
    let own = env!("CARGO_BIN_EXE_stabline");
    let run = |program: &[&str], laws: bool| {
        let mut arguments = vec!["stress", "--family", "gates", "--count", "10"];
        arguments.extend(laws.then_some("--laws"));
        arguments.push("--run");
        arguments.extend(program);
        stabline(root(), &arguments)
    };
    let says_open = ["sh", "-c", "cat > /dev/null; echo '{\"class\": \"open\"}'"];
    let output = run(&says_open, false);
    assert_eq!(output.status.code(), Some(1), "{}", stderr(&output));
    assert!(stdout(&output).contains("{\"class\":\"open\"}, expected {\"class\":\"blocked\"}"));
    // Whoever always says the same breaks no law.
    assert_eq!(run(&says_open, true).status.code(), Some(0));
    for laws in [false, true] {
        let output = run(&[own, "vectors", "answer"], laws);
        assert_eq!(output.status.code(), Some(0), "{}{}", stdout(&output), stderr(&output));
    }
}

#[cfg(unix)]
fn reduced(case: &Case, command: &str, at: &Path) -> String {
    let mut child = Command::new(env!("CARGO_BIN_EXE_stabline"))
        .args(["reduce", "-", "--while", command])
        .current_dir(at)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    child.stdin.take().unwrap().write_all(case.to_line().as_bytes()).unwrap();
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    stdout(&output)
}

#[cfg(unix)]
#[test]
fn reduce_writes_the_smallest_case_as_a_vector() {
    let folder = tempfile::tempdir().unwrap();
    let family = Family::named("touch").unwrap();
    let case = family.input(&defaults(family), 1, 0).case(9, "a story", &["touch"]);
    let text = reduced(&case, "grep -q '\"kind\":\"sequence\"'", folder.path());
    let file = VectorsFile::read(text.as_bytes()).unwrap();
    let (group, test) = file.tests().next().unwrap();
    let Input::Sequence(portals) = Input::of_case(&group.case(test)).unwrap() else { panic!() };
    assert_eq!((portals.len(), portals[0].len()), (1, 3), "{text}");
    assert_eq!((test.comment.as_str(), test.class), ("a story", Some(Class::Open)));
    // Nothing is smaller than a command that always fails leaves it.
    let path = folder.path().join("case.json");
    std::fs::write(&path, case.to_line()).unwrap();
    let path = path.to_str().unwrap();
    let output = stabline(root(), &["reduce", path, "--while", "false"]);
    assert_fails(&output, 2, "does not exit with 0 for the case itself");
    std::fs::write(path, "{}").unwrap();
    assert_fails(&stabline(root(), &["reduce", path, "--while", "true"]), 3, "missing field");
}

#[test]
fn vectors_of_answers_are_accepted_by_their_own_format() {
    let mut made = BTreeSet::new();
    for (family, name, input) in inputs() {
        let test = test_of(&input).unwrap_or_else(|fault| panic!("{name}: {fault}"));
        let answered = test.expected().unwrap().answer();
        assert_eq!(answered, find(&input).unwrap().answer, "{name}");
        let is_open = answered == Answer::Class(Class::Open);
        assert_eq!(test.witness.is_some(), is_open, "{name}");
        let is_grazing = answered == Answer::Class(Class::Grazing);
        assert_eq!(test.touching_line.is_some(), is_grazing, "{name}");
        if let Some(proof) = test.certificate.as_ref().and_then(|c| c.get("proof")) {
            let lines = proof.as_array().unwrap().iter().map(|line| line.as_str().unwrap());
            let text: String = lines.flat_map(|line| [line, "\n"]).collect();
            verify(text.as_bytes()).unwrap_or_else(|flaw| panic!("{name}: {flaw}"));
        }
        if let Some(line) = &test.witness {
            check_witness(&input, &test, line, &name);
        }
        made.insert((family.kind, format!("{answered:?}")));
    }
    // Three classes of sequences, graphs and scenes, and four counts of lines at most.
    assert!(made.len() >= 12, "{made:?}");
}

/// That the line of an open answer is one.
fn check_witness(input: &Input, test: &Test, line: &Value, name: &str) {
    if let Input::Graph(graph) = input {
        let built = portal_graph(graph).unwrap();
        // Of a portal that is not flat or not convex the line passes a piece.
        if built.skew_portals + built.repairs.dented_portals > 0 {
            return;
        }
    }
    let Input::Scene(scene) = input else {
        let said = json!({"class": "open", "witness": line, "portals": test.portals}).to_string();
        let answer = Answer::Class(Class::Open);
        let witness = Witness::read(input.kind(), &answer, &said).unwrap().unwrap();
        assert!(witness.proves(&input.case(1, "", &[])), "{name}: {said}");
        return;
    };
    let number = |c: &Value| Number::parse(c.as_str().unwrap()).unwrap().to_rational();
    // In the plane halfway up the walls.
    let half = Number::parse("1/2").unwrap().to_rational();
    let point = |p: &Value| [0, 1, 2].map(|i| p.get(i).map_or(half.clone(), number));
    let (p, q) = (point(&line[0]), point(&line[1]));
    let regions = regions_of(scene);
    let regions = regions.each_ref().map(Vec::as_slice);
    assert!(check::shows([&p, &q], regions, &occluders_of(scene)), "{name}: {line}");
}
