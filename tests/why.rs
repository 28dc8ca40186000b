//! `stabline why` of cells that the bound keeps apart: it names what fails on the shortest way.

mod support;

use std::fs;
use support::{stabline, stdout};

/// A door in the plane x = `x` between y = `low` and `high`, counter-clockwise as seen from `x`
/// greater (`forward`) or less.
fn door(cells: &str, x: i32, [low, high]: [i32; 2], forward: bool) -> String {
    let mut corners = [[low, 0], [high, 0], [high, 4], [low, 4]];
    if !forward {
        corners.reverse();
    }
    let corners = corners.map(|[y, z]| format!("({x} {y} {z} ) ")).concat();
    format!("4 {cells} {corners}\n")
}

fn why(cells: u32, doors: &[String], from: &str, to: &str) -> (String, serde_json::Value) {
    let folder = tempfile::tempdir().unwrap();
    let text = format!("PRT1\n{cells}\n{}\n{}", doors.len(), doors.concat());
    fs::write(folder.path().join("x.prt"), text).unwrap();
    let run = |more: &[&str]| {
        let output = stabline(folder.path(), &[&["why", "x.prt", from, to], more].concat());
        assert_eq!(output.status.code(), Some(0));
        stdout(&output)
    };
    (run(&[]), serde_json::from_str(&run(&["--json"])).unwrap())
}

#[test]
fn cells_that_no_portals_join() {
    let doors = [door("0 1", 0, [0, 4], true), door("2 3", 9, [0, 4], true)];
    let (text, json) = why(4, &doors, "0", "3");
    assert_eq!(text, "0 does not see 3: not open\nno portals lead from 0 to 3\n");
    assert_eq!(json["refuted"]["by"], "graph");
}

#[test]
fn the_portal_that_cannot_follow_is_named() {
    // A second door in the wall of the first, back through it.
    let back = [door("0 1", 0, [0, 4], true), door("1 2", 0, [5, 9], false)];
    // A door that faces the first one.
    let facing = [door("0 1", 0, [0, 4], true), door("1 2", 8, [0, 4], false)];
    // To the second door a line turns left, and the third is on the right.
    let zigzag =
        [door("0 1", 0, [0, 1], true), door("1 2", 1, [5, 6], true), door("2 3", 2, [0, 1], true)];
    let cases = [
        (3, &back[..], "2", "portals 0 1: no part of portal 1 is in front of portal 0"),
        (3, &facing[..], "2", "portals 0 1: no part of portal 0 is behind portal 1"),
        (4, &zigzag[..], "3", "portals 0 1 2: portal 2 cannot follow portal 0"),
    ];
    for (cells, doors, to, expected) in cases {
        let (text, json) = why(cells, doors, "0", to);
        assert!(text.starts_with(&format!("0 does not see {to}: not open\n")), "{text}");
        assert!(text.contains(&format!("the shortest: {expected}")), "{text}");
        assert_eq!(json["refuted"]["by"], "bound");
        assert_eq!(json["refuted"]["between"].as_array().unwrap().len(), 2);
        let why = json["refuted"]["why"].as_str().unwrap();
        assert!(expected.contains(why) || why.contains("cannot follow"), "{why}");
    }
}
