//! How far `--grazing` goes: galleries of n x n rooms, their doors offset from one another, or in
//! the corners, where touching lines run along the walls.
//!
//! Prints, for each size, the pairs by verdict and the time of the open pairs and of the grazing
//! ones. `cargo bench --bench grazing`, with `-- N` up to N x N rooms (default 6); `-- N BUDGET`
//! leaves a source cell after so many sequences.

use stabline::pvs::{self, Options};
use stabline::report::Silent;
use stabline::scene::{PortalGraph, read_graph};
use std::fmt::Write;
use std::time::Instant;

/// A floor of n x n rooms, a door in every wall between two, offset by a function of the wall, or
/// at the wall's low end in two rows of rooms, at its high end in the next two.
fn gallery(n: u32, in_corners: bool) -> PortalGraph {
    let mut doors = String::new();
    let mut count = 0;
    let mut door = |from: u32, to: u32, corners: [[u32; 3]; 4]| {
        let corners = corners.map(|[x, y, z]| format!("({x} {y} {z} ) ")).concat();
        let _ = writeln!(doors, "4 {from} {to} {corners}");
        count += 1;
    };
    for (row, column) in (0..n * n).map(|room| (room / n, room % n)) {
        let room = row * n + column;
        // Rooms are 16 units wide, doors 4; offset ones come no nearer than 2 to a corner.
        let place = |wall: u32| match in_corners {
            true => row / 2 % 2 * 12,
            false => 2 + (7 * row + 5 * column + 3 * wall) % 9,
        };
        if column + 1 < n {
            let (x, y) = (16 * (column + 1), 16 * row + place(0));
            door(room, room + 1, [[x, y, 0], [x, y + 4, 0], [x, y + 4, 8], [x, y, 8]]);
        }
        if row + 1 < n {
            let (x, y) = (16 * column + place(1), 16 * (row + 1));
            door(room, room + n, [[x, y, 0], [x, y, 8], [x + 4, y, 8], [x + 4, y, 0]]);
        }
    }
    let text = format!("PRT1\n{}\n{count}\n{doors}", n * n);
    read_graph("gallery", text.as_bytes()).expect("the doors are squares")
}

fn main() {
    // Of the arguments that cargo and the caller give, the numbers.
    let mut numbers = std::env::args().skip(1).filter_map(|argument| argument.parse::<u64>().ok());
    let (largest, budget) = (numbers.next().unwrap_or(6), numbers.next());
    println!(
        "doors in  rooms  doors   open  grazing  blocked  undecided  open pairs  grazing pairs"
    );
    let sizes = (2..=largest as u32).flat_map(|n| [(n, false), (n, true)]);
    for (n, in_corners) in sizes {
        let graph = gallery(n, in_corners);
        let start = Instant::now();
        let finished = pvs::compute(&graph, &Options::default(), Vec::new(), &|_| {}, &Silent);
        let mut matrix = pvs::assemble(&graph, &finished.rows);
        let open = start.elapsed();
        assert!(pvs::classify_grazing(&graph, &mut matrix, budget, &Silent).is_some());
        let counts = matrix.counts();
        println!(
            "{:8}  {:5}  {:5}  {:5}  {:7}  {:7}  {:9}  {open:10.3?}  {:.3?}",
            if in_corners { "corners" } else { "walls" },
            graph.cells.len(),
            graph.portals.len(),
            counts.open,
            counts.grazing,
            counts.not_open,
            counts.undecided,
            start.elapsed() - open,
        );
    }
}
