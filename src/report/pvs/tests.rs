use super::*;
use crate::report::Verdict;

fn sample() -> PvsReport {
    let mut matrix = Matrix::new(3, Verdict::Open);
    matrix.set(0, 2, Verdict::Grazing);
    matrix.set(2, 0, Verdict::NotOpen);
    matrix.set(1, 2, Verdict::Undecided);
    let big = Number::parse("123456789012345678901234567891/7").unwrap();
    PvsReport {
        program: "stabline 0.0.0".to_owned(),
        input: InputId::new("x \"1\".prt", b"some bytes"),
        reading: String::new(),
        grazing_classified: true,
        cells: ["0", "hall\n", "ü"].map(str::to_owned).to_vec(),
        leaf_to_cell: vec![0, 0, 2, 1],
        skew_portals: 1,
        matrix,
        witnesses: vec![PairWitness {
            from: 0,
            to: 1,
            portals: vec![7, 12],
            line: WitnessLine::Space([
                [Number::ratio(-3, 2), Number::ratio(0, 1), Number::ratio(i64::MIN.into(), 1)],
                [Number::ratio(1, 1), Number::ratio(2, 1), big],
            ]),
        }],
    }
}

fn text(report: &PvsReport) -> String {
    let mut bytes = Vec::new();
    report.write(&mut bytes).unwrap();
    String::from_utf8(bytes).unwrap()
}

#[test]
fn what_is_written_reads_back() {
    let mut report = sample();
    assert_eq!(PvsReport::read(text(&report).as_bytes()), Ok(report.clone()));
    let [p, q] = [[-3, 2], [1, 1 << 40]].map(|p| p.map(|c| Number::ratio(c, 7)));
    report.witnesses[0].line = WitnessLine::Plane([p, q]);
    assert_eq!(PvsReport::read(text(&report).as_bytes()), Ok(report.clone()));
    let mut report = sample();
    report.grazing_classified = false;
    report.matrix.set(0, 2, Verdict::NotOpen);
    report.witnesses.clear();
    assert_eq!(PvsReport::read(text(&report).as_bytes()), Ok(report));
}

#[test]
fn the_text_is_canonical() {
    insta::assert_snapshot!(text(&sample()), @r#"
    {"format": "stabline-pvs/1",
    "program": "stabline 0.0.0",
    "input": {"name": "x \"1\".prt", "blake3": "7e52aeb0d161c90714aca8a001c01e65c6ecdaf288681e4ba3d98f418259c175"},
    "options": {"grazing": true},
    "cells": ["0", "hall\n", "ü"],
    "leaf_to_cell": [0, 0, 2, 1],
    "skew_portals": 1,
    "counts": {"open": 6, "grazing": 1, "blocked": 1, "undecided": 1, "diagonal_included": true},
    "rows": [
    "221",
    "223",
    "022"],
    "witnesses": [
    {"from": 0, "to": 1, "portals": [7, 12], "line": [["-3/2", "0", "-9223372036854775808"], ["1", "2", "123456789012345678901234567891/7"]]}]}
    "#);
}

#[test]
fn a_broken_rule_is_named_with_its_place() {
    let good = text(&sample());
    let cases = [
        ("stabline-pvs/1", "stabline-pvs/2", "format: expected"),
        ("\"skew_portals\": 1,", "", "missing field `skew_portals`"),
        ("\"skew_portals\"", "\"more\": 1, \"skew_portals\"", "unknown field `more`"),
        ("\"open\": 6", "\"open\": 5", "counts.open: states 5, but the rows have 6"),
        ("\"grazing\": 1", "\"grazing\": null", "counts.grazing: states null"),
        ("\"grazing\": 1, ", "", "missing field `grazing`"),
        ("\"221\"", "\"22\"", "rows[0]"),
        ("\"221\"", "\"224\"", "rows[0]: expected digits 0 to 3"),
        ("{\"grazing\": true}", "{\"grazing\": false}", "rows[0]: a grazing pair"),
        ("[0, 0, 2, 1]", "[0, 0, 3, 1]", "leaf_to_cell[2]: names cell 3"),
        ("\"to\": 1", "\"to\": 0", "witnesses[0]: expected from < to < 3, got 0 and 0"),
        ("\"to\": 1", "\"to\": 2", "witnesses[0]: the pair 0, 2 is not open"),
        ("\"-3/2\"", "\"-6/4\"", "witnesses[0]: `-6/4` is not in lowest terms"),
        ("\"-3/2\"", "\"1/0\"", "witnesses[0]: `1/0`: the denominator is zero"),
        ("[7, 12]", "[]", "witnesses[0]: expected one portal or more"),
        ("]}\n", "]", "line 14"),
    ];
    for (from, to, expected) in cases {
        assert!(good.contains(from), "{from}");
        let error = PvsReport::read(good.replacen(from, to, 1).as_bytes()).unwrap_err();
        assert!(error.to_string().contains(expected), "{to}: {error}");
    }
}

#[test]
fn each_number_has_one_spelling() {
    let good = text(&sample());
    for other in ["+1", "01", "-0", "1.0", "1e0", "2/2", "-6/4", "6/-4", "3/02", "", "/", "1/"] {
        let text = good.replace("\"-3/2\"", &format!("\"{other}\""));
        assert!(PvsReport::read(text.as_bytes()).is_err(), "{other}");
    }
    for number in ["0", "-1", "10", "-99", "100", "7/10", "-1/100", "9223372036854775808/3"] {
        let text = good.replace("\"-3/2\"", &format!("\"{number}\""));
        assert!(PvsReport::read(text.as_bytes()).is_ok(), "{number}");
    }
}

#[test]
fn every_truncation_is_an_error() {
    let good = text(&sample());
    let good = good.trim_end();
    for end in 0..good.len() {
        assert!(PvsReport::read(&good.as_bytes()[..end]).is_err(), "{end}");
    }
}
