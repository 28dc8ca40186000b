//! Portal graphs: rows of rooms, two ways between two rooms, and portals in two parts.

use super::book::{Book, of_portals};
use super::family::{Family, Seq};
use super::number::{Polygon, Q, ratio, values};
use serde_json::{Value, json};
use stabline::vectors::Class::{self, Blocked};
use stabline::vectors::{Kind, Test, VectorsFile};

/// More portals than this are left to the files of sequences.
const MOST_PORTALS: usize = 12;

/// A portal of a graph.
struct Door<'a> {
    ends: [String; 2],
    polygon: &'a Polygon,
}

/// The graphs of all families whose portals stand one behind the other.
pub fn file(name: &str, about: &str, families: &[Family]) -> VectorsFile {
    let mut book = Book::new(name, about);
    for family in families.iter().filter(|family| family.is_row) {
        let short = |case: &&Seq| (2..=MOST_PORTALS).contains(&case.portals.len());
        let cases: Vec<&Seq> = family.cases.iter().filter(short).collect();
        // The transformed ones are in the files of sequences; every third of them is here.
        let plain = cases.iter().enumerate().filter(|(i, case)| i % 3 == 0 || !is_moved(case));
        for (index, case) in plain {
            row(&mut book, family.about, case, index);
            if case.portals[0].len() == 4 && index % 4 == 0 {
                in_parts(&mut book, family.about, case, index);
            }
        }
        for (index, pair) in cases.windows(2).enumerate().filter(|(index, _)| index % 7 == 1) {
            two_ways(&mut book, family.about, [pair[0], pair[1]], index);
        }
    }
    book.finish()
}

fn is_moved(case: &Seq) -> bool {
    case.flags
        .iter()
        .any(|flag| ["Backwards", "Mirrored", "UnitScale", "FarFromOrigin"].contains(flag))
}

/// Rooms in a row, asked for in both directions.
fn row(book: &mut Book, about: &str, case: &Seq, index: usize) {
    let rooms: Vec<String> = (0..=case.portals.len()).map(|room| format!("room {room}")).collect();
    let door =
        |(i, polygon): (usize, _)| Door { ends: [rooms[i].clone(), rooms[i + 1].clone()], polygon };
    let doors: Vec<Door> = case.portals.iter().enumerate().map(door).collect();
    begin(book, about, &format!("row {index}"), &rooms, &doors);
    let way: Vec<u32> = (0..case.portals.len() as u32).collect();
    let ends = [&rooms[0], &rooms[case.portals.len()]];
    book.judged(case, pair(&[(way, case.portals.clone())], ends));
    // The same doors from the other end, with each door's directed number.
    let back = case.back();
    let way: Vec<u32> = (0..case.portals.len() as u32).rev().collect();
    book.judged(&back, pair(&[(way, back.portals.clone())], [ends[1], ends[0]]));
}

/// Two rooms with two ways between them, of two cases: the better one decides.
fn two_ways(book: &mut Book, about: &str, cases: [&Seq; 2], index: usize) {
    let mut rooms = vec!["start".to_owned(), "goal".to_owned()];
    let mut doors = Vec::new();
    let mut ways = Vec::new();
    for (case, side) in cases.iter().zip(["left", "right"]) {
        let last = case.portals.len() - 1;
        rooms.extend((1..=last).map(|room| format!("{side} {room}")));
        let name = |room: usize| match room {
            0 => "start".to_owned(),
            room if room > last => "goal".to_owned(),
            room => format!("{side} {room}"),
        };
        let first = doors.len() as u32;
        ways.push(((first..=first + last as u32).collect(), case.portals.clone()));
        let door = |(i, polygon): (usize, _)| Door { ends: [name(i), name(i + 1)], polygon };
        doors.extend(case.portals.iter().enumerate().map(door));
    }
    begin(book, about, &format!("two ways {index}"), &rooms, &doors);
    let class = cases.iter().map(|case| case.class).max().unwrap_or(Blocked);
    let [a, b] = cases.map(|case| case.class.name());
    let mut flags = vec!["TwoWays"];
    flags.extend(cases[0].flags.iter().filter(|flag| !["Flush", "OneUnit"].contains(flag)));
    let comment =
        format!("Two ways, one {a} and one {b}, so {}: {}", class.name(), cases[0].comment);
    let case = Seq { comment, flags, portals: Vec::new(), class };
    book.judged(&case, pair(&ways, [&rooms[0], &rooms[1]]));
}

/// A row whose middle door is two portals side by side.
fn in_parts(book: &mut Book, about: &str, case: &Seq, index: usize) {
    let rooms: Vec<String> = (0..=case.portals.len()).map(|room| format!("room {room}")).collect();
    let middle = case.portals.len() / 2;
    if case.portals[middle].len() != 4 {
        return;
    }
    let parts = halves(&case.portals[middle]);
    let mut doors = Vec::new();
    for (i, polygon) in case.portals.iter().enumerate() {
        let ends = [rooms[i].clone(), rooms[i + 1].clone()];
        let polygons = if i == middle { parts.iter().collect() } else { vec![polygon] };
        doors.extend(polygons.into_iter().map(|polygon| Door { ends: ends.clone(), polygon }));
    }
    begin(book, about, &format!("parts {index}"), &rooms, &doors);
    let way = |part: usize| {
        let number = |i: usize| if i < middle { i } else { i + usize::from(i > middle) };
        let numbers =
            (0..case.portals.len()).map(|i| number(i) + if i == middle { part } else { 0 });
        let mut portals = case.portals.clone();
        portals[middle] = parts[part].clone();
        (numbers.map(|i| i as u32).collect(), portals)
    };
    let mut flags = case.flags.clone();
    flags.push("SplitPortal");
    let comment = format!("The middle door in two parts, which changes nothing: {}", case.comment);
    let case = Seq { comment, flags, portals: Vec::new(), class: case.class };
    book.judged(&case, pair(&[way(0), way(1)], [&rooms[0], &rooms[rooms.len() - 1]]));
}

/// A quadrilateral, cut a third of the way along two opposite sides.
fn halves(polygon: &Polygon) -> [Polygon; 2] {
    let part = |a: usize, b: usize| -> Vec<Q> {
        let third = ratio(1, 3);
        polygon[a].iter().zip(&polygon[b]).map(|(a, b)| a + (b - a) * &third).collect()
    };
    let (low, high) = (part(0, 1), part(3, 2));
    let [a, b, c, d] = [0, 1, 2, 3].map(|i| polygon[i].clone());
    [vec![a, low.clone(), high.clone(), d], vec![low, b, c, high]]
}

fn begin(book: &mut Book, about: &str, name: &str, rooms: &[String], doors: &[Door]) {
    let shape = if doors[0].polygon.len() == 2 { "segment" } else { "polygon" };
    let door = |door: &Door| {
        let [from, to] = &door.ends;
        json!({ "from": from, "to": to, shape: values(door.polygon) })
    };
    let doors: Vec<Value> = doors.iter().map(door).collect();
    let scene = json!({ "format": "stabline-scene/1", "cells": rooms, "portals": doors });
    book.scene(Kind::Graph, about, name, scene);
}

/// The best verdict of all ways between two cells, with its proof.
fn pair(ways: &[(Vec<u32>, Vec<Polygon>)], [from, to]: [&String; 2]) -> Test {
    let tests: Vec<Test> = ways.iter().map(|(_, portals)| of_portals(portals)).collect();
    let class: Option<Class> = tests.iter().filter_map(|test| test.class).max();
    let best = tests.iter().position(|test| test.class == class).expect("a way");
    let reason = |((numbers, _), test): (&(Vec<u32>, Vec<Polygon>), &Test)| {
        let reason = test.certificate.clone()?;
        Some(json!({ "portals": numbers, "reason": reason }))
    };
    let reasons: Vec<Value> = ways.iter().zip(&tests).filter_map(reason).collect();
    let is_whole = class != Some(Class::Open) && reasons.len() == ways.len();
    Test {
        from: Some(from.clone()),
        to: Some(to.clone()),
        portals: (class != Some(Blocked)).then(|| ways[best].0.clone()),
        certificate: is_whole.then(|| json!({ "sequences": reasons })),
        ..tests[best].clone()
    }
}
