//! Portal graphs against the walk over all sequences: a byte for the two cells of a portal, then
//! one for each coordinate of a triangle.
#![no_main]

use libfuzzer_sys::fuzz_target;
use stabline::forge::{Door, Graph, portal_graph, pvs_of, twin};
use stabline::num::{Int, Rational};
use stabline::report::Verdict;

const CELLS: usize = 4;

fuzz_target!(|bytes: &[u8]| {
    let door = |bytes: &[u8]| {
        let from = usize::from(bytes[0]) % CELLS;
        let to = (from + 1 + usize::from(bytes[0] >> 2) % (CELLS - 1)) % CELLS;
        let number = |&byte: &u8| Rational::from(Int::from(byte as i8));
        let polygon = bytes[1..].chunks(3).map(|p| p.iter().map(number).collect()).collect();
        Door { cells: [from, to], polygon }
    };
    let doors: Vec<Door> = bytes.chunks_exact(10).take(4).map(door).collect();
    let graph = Graph { cells: CELLS, doors, from: 0, to: 1 };
    if portal_graph(&graph).is_err() {
        return;
    }
    let (_, matrix, _) = pvs_of(&graph).unwrap_or_else(|fault| panic!("{fault}"));
    for (a, row) in twin::open_cells(&graph).unwrap().iter().enumerate() {
        for (b, &is_open) in row.iter().enumerate() {
            assert_eq!(matrix.get(a, b) == Verdict::Open, is_open, "cells {a} and {b}");
        }
    }
});
