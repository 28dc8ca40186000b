//! Parts of a result: garbled ones are refused with their line, and none panics.

mod support;

use proptest::prelude::*;
use stabline::pvs::{self, Options, Part, PartHeader};
use stabline::report::{InputId, PvsReport, Silent};
use stabline::scene::{PortalGraph, RawGraph};
use std::sync::LazyLock;
use support::graphs::{Family, Graph, integer};
use support::witness;

fn header() -> PartHeader {
    let program = PvsReport::this_program();
    PartHeader {
        program,
        input: InputId::new("graph.prt", b""),
        reading: String::new(),
        budget: None,
    }
}

/// A part with rows of every kind: the text of a random graph's.
fn part_text() -> (PortalGraph, String) {
    let graph = Graph::random(Family::Rooms, 3).validated();
    let options = Options { budget: Some(4), ..Options::default() };
    let rows = pvs::compute(&graph, &options, Vec::new(), &|_| {}, &Silent).rows;
    assert!(rows.iter().any(|row| !row.open.is_empty()));
    assert!(rows.iter().any(|row| !row.undecided.is_empty()));
    let mut text = header().to_line().unwrap();
    rows.iter().for_each(|row| text.push_str(&row.to_line().unwrap()));
    (graph, text)
}

#[test]
fn a_garbled_part_names_the_line_and_the_rule() {
    let graph = PortalGraph::from_raw(chain_of_rooms()).unwrap();
    let row = |open: &str, undecided: &str| {
        let text = header().to_line().unwrap();
        let text =
            format!("{text}{{\"source\":0,\"open\":[{open}],\"undecided\":[{undecided}]}}\n");
        Part::read(&text, &graph).map_err(|error| (error.line, error.to_string()))
    };
    let pair = |target: u32, portals: &str, end: &str| {
        format!(
            "{{\"target\":{target},\"portals\":[{portals}],\
             \"line\":[[\"0\",\"0\",\"0\"],[\"{end}\",\"0\",\"0\"]]}}"
        )
    };
    assert!(row(&[pair(1, "0", "1"), pair(2, "0,1", "1/2")].join(","), "").is_ok());
    assert!(row(&pair(1, "0", "1"), "2").is_ok());
    let cases = [
        (pair(3, "0", "1"), "", "cell 3, expected one of the 3 cells"),
        (pair(1, "2", "1"), "", "portal 2, expected one of the 2"),
        (pair(1, "4294967295", "1"), "", "portal 4294967295"),
        (pair(2, "1", "1"), "", "portal 1 is crossed from cell 0, but joins cells 1 and 2"),
        (pair(2, "0", "1"), "", "the portals to cell 2 lead to cell 1"),
        (pair(1, "", "1"), "", "the portals to cell 1 lead to cell 0, or nowhere"),
        (pair(1, "0", "0"), "", "the line to cell 1 has two equal points"),
        (pair(1, "0", "1/0"), "", "a coordinate is"),
        ([pair(2, "0,1", "1"), pair(1, "0", "1")].join(","), "", "open: cell 1 after cell 2"),
        (pair(1, "0", "1"), "1", "undecided: cell 1, whose verdict is known"),
        (pair(1, "0", "1"), "0", "undecided: cell 0, whose verdict is known"),
        (String::new(), "2,1", "undecided: cell 1 after cell 2"),
        (String::new(), "3", "cell 3, expected one of the 3 cells"),
        ("7".to_owned(), "", "invalid type"),
    ];
    for (open, undecided, expected) in cases {
        let (line, what) = row(&open, undecided).unwrap_err();
        assert_eq!(line, 2, "{open}");
        assert!(what.contains(expected), "{open}: {what}");
    }
    assert_eq!(Part::read("", &graph).unwrap_err().line, 1);
    assert!(Part::read("{}\n", &graph).unwrap_err().what.contains("missing field"));
}

/// Three rooms in a row: the doors 0 and 1.
fn chain_of_rooms() -> RawGraph {
    let door = |cell: u32| support::graphs::Portal {
        cells: [cell, cell + 1],
        polygon: [[0, 0], [4, 0], [4, 4], [0, 4]]
            .map(|[y, z]| [cell.into(), y, z].map(integer))
            .to_vec(),
    };
    Graph { cells: 3, portals: vec![door(0), door(1)] }.raw()
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 2000,
        failure_persistence: None,
        ..ProptestConfig::default()
    })]

    #[test]
    fn damaged_parts_do_not_panic(
        damage in prop::collection::vec((any::<prop::sample::Index>(), 9u8..127), 1..6),
        cut in any::<prop::sample::Index>(),
        splice in any::<prop::sample::Index>(),
    ) {
        static PART: LazyLock<(PortalGraph, String)> = LazyLock::new(part_text);
        let (graph, text) = &*PART;
        let mut damaged = text.clone().into_bytes();
        for (at, byte) in damage {
            let at = at.index(damaged.len());
            damaged[at] = byte;
        }
        let (a, b) = (cut.index(text.len()), splice.index(text.len()));
        let spliced = [&damaged[..a], &damaged[b..]].concat();
        for bytes in [damaged, spliced] {
            let text = String::from_utf8(bytes).expect("damage by ASCII characters");
            match Part::read(&text, graph) {
                Err(error) => assert!(error.line >= 1),
                // What is read can be used.
                Ok(part) => {
                    let matrix = pvs::assemble(graph, &part.rows);
                    assert_eq!(matrix.size(), graph.cells.len());
                    for found in pvs::witnesses(&part.rows) {
                        let _ = witness::check(graph, &found);
                    }
                    let text: String =
                        part.rows.iter().map(|row| row.to_line().unwrap()).collect();
                    assert_eq!(text.lines().count(), part.rows.len());
                }
            }
        }
    }
}
