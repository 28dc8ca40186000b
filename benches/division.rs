//! How the division of space grows with its input: generated buildings, doubling in size.
//!
//! `cargo bench --bench division` prints for each size and each way of building walls the time,
//! the memory, and the exponent of growth since the size before. `-- ROOMS` sets the rooms of the
//! largest building, 1280 by default, which makes about 100 000 polygons.
//!
//! A building has floors of a square grid of rooms: a slab with a stairwell under each floor's
//! first room, a door to the next room in both directions, windows in the outer walls, and a table
//! and boxes in each room. Walls are brushes, or thin polygons. Nothing is random: what differs
//! from room to room follows from the room's number.

use stabline::geom::{AxialBox, BigPlane, RationalPoint3};
use stabline::num::{Int, Rational};
use stabline::portal::enumerate;
use stabline::report::Silent;
use stabline::subdivision::{Occluders, Options, PortalShape, Solid, build};
use std::time::Instant;

/// The width and depth of a room, its height, and the thickness of walls that are brushes.
const ROOM: i64 = 256;
const HEIGHT: i64 = 128;
const THICK: i64 = 8;

/// Boxes, from corner to corner.
type Cuboid = ([i64; 3], [i64; 3]);

fn main() {
    let largest = std::env::args().skip(1).find_map(|argument| argument.parse().ok());
    let largest: i64 = largest.unwrap_or(1280);
    println!("walls     rooms polygons   leaves    cells  portals  seconds exponent   MiB");
    for thin in [false, true] {
        let mut before: Option<(f64, f64)> = None;
        let mut rooms = (largest / 64).max(16);
        while rooms <= largest {
            let occluders = building(rooms, thin);
            let polygons = occluders.solids.len() * 6 + occluders.polygons.len();
            let start = Instant::now();
            let mut subdivision = build(&occluders, &Options::default(), &Silent).unwrap();
            let portals = enumerate(&mut subdivision, PortalShape::Merged);
            let seconds = start.elapsed().as_secs_f64();
            let grown = before.map_or("-".to_owned(), |(size, time)| {
                format!("{:.2}", (seconds / time).ln() / (polygons as f64 / size).ln())
            });
            before = Some((polygons as f64, seconds));
            let memory = memory_stats::memory_stats().map_or(0, |used| used.physical_mem >> 20);
            let empty = subdivision.leaves.iter().filter(|leaf| !leaf.solid).count();
            println!(
                "{:<8} {rooms:>6} {polygons:>8} {:>8} {empty:>8} {:>8} {seconds:>8.2} {grown:>8} {memory:>5}",
                if thin { "polygons" } else { "brushes" },
                subdivision.leaves.len(),
                portals.len(),
            );
            rooms *= 2;
        }
    }
}

/// A building of about so many rooms.
fn building(rooms: i64, thin: bool) -> Occluders {
    let floors = (1..=rooms).rev().find(|f| f * f * f * 16 <= rooms).unwrap_or(1);
    let side = (1..).find(|side| floors * side * side >= rooms).unwrap();
    let (mut walls, mut furniture): (Vec<Cuboid>, Vec<Cuboid>) = (Vec::new(), Vec::new());
    for floor in 0..floors {
        for row in 0..side {
            for column in 0..side {
                let number = (floor * side + row) * side + column;
                room(&mut walls, [column, row, floor], number, side);
                furnish(&mut furniture, [column * ROOM, row * ROOM, floor * HEIGHT], number);
            }
        }
    }
    let roof = floors * HEIGHT;
    walls.push(([0, 0, roof], [side * ROOM, side * ROOM, roof + THICK]));
    let end = |length: i64| Rational::from(Int::from(length + 64));
    let view = Some(AxialBox {
        low: [(); 3].map(|()| Rational::from(Int::from(-64))),
        high: [end(side * ROOM), end(side * ROOM), end(roof)],
    });
    let mut occluders = Occluders { view, ..Occluders::default() };
    if thin {
        occluders.polygons.extend(walls.iter().map(middle));
    } else {
        occluders.solids.extend(walls.iter().map(cuboid));
    }
    occluders.solids.extend(furniture.iter().map(cuboid));
    occluders
}

/// The slab under a room and its walls to the left and to the front; the last rooms of a row have
/// a wall behind them as well.
fn room(walls: &mut Vec<Cuboid>, [column, row, floor]: [i64; 3], number: i64, side: i64) {
    let [x, y, z] = [column * ROOM, row * ROOM, floor * HEIGHT];
    let mut slab = |from: [i64; 2], to: [i64; 2]| {
        walls.push(([x + from[0], y + from[1], z], [x + to[0], y + to[1], z + THICK]));
    };
    if column == 0 && row == 0 && floor > 0 {
        // Round a stairwell.
        slab([0, 0], [ROOM, 64]);
        slab([0, 64], [64, 192]);
        slab([192, 64], [ROOM, 192]);
        slab([0, 192], [ROOM, ROOM]);
    } else {
        slab([0, 0], [ROOM, ROOM]);
    }
    let shift = number * 37 % 96;
    for across in 0..2 {
        let mut at = vec![0];
        if [column, row][across] + 1 == side {
            at.push(ROOM);
        }
        for at in at {
            let outer = at > 0 || [column, row][across] == 0;
            // A door reaches down to the floor, a window does not.
            let (bottom, top) = if outer { (40, 88) } else { (THICK, 80) };
            let mut piece = |from: i64, to: i64, low: i64, high: i64| {
                let (mut a, mut b) = ([x, y, z + low], [x, y, z + high]);
                a[across] += at;
                b[across] += at + THICK;
                a[1 - across] += from;
                b[1 - across] += to;
                walls.push((a, b));
            };
            let (left, right) = (THICK + 56 + shift, THICK + 104 + shift);
            piece(THICK, left, THICK, HEIGHT);
            piece(right, ROOM, THICK, HEIGHT);
            piece(left, right, top, HEIGHT);
            if outer {
                piece(left, right, THICK, bottom);
            }
        }
    }
}

/// A table and two boxes.
fn furnish(furniture: &mut Vec<Cuboid>, [x, y, z]: [i64; 3], number: i64) {
    let (dx, dy) = (number * 29 % 60, number * 53 % 60);
    let mut add = |low: [i64; 3], high: [i64; 3]| {
        let at = [x + 24 + dx, y + 24 + dy, z + THICK];
        let moved = |corner: [i64; 3]| std::array::from_fn(|i| at[i] + corner[i]);
        furniture.push((moved(low), moved(high)));
    };
    for (a, b) in [(0, 0), (44, 0), (0, 28), (44, 28)] {
        add([a, b, 0], [a + 4, b + 4, 28]);
    }
    add([0, 0, 28], [48, 32, 32]);
    add([60, 10, 0], [76, 26, 16]);
    add([64, 90, 0], [104, 110, 48]);
}

fn cuboid((low, high): &Cuboid) -> Solid {
    let side = |axis: usize, sign: i64, at: i64| {
        let normal = std::array::from_fn(|i| Int::from(if i == axis { sign } else { 0 }));
        BigPlane { normal, offset: Int::from(sign * at) }
    };
    (0..3).flat_map(|i| [side(i, 1, high[i]), side(i, -1, low[i])]).collect()
}

/// The rectangle in the low plane of a wall, across its shortest extent; its edges run on by the
/// thickness, so that walls meet.
fn middle((low, high): &Cuboid) -> Vec<RationalPoint3> {
    let axis = (0..3).min_by_key(|&i| high[i] - low[i]).unwrap();
    let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
    let start = |k: usize| if low[k] % ROOM == THICK { low[k] - THICK } else { low[k] };
    let corner = |a: i64, b: i64| {
        let mut point = *low;
        (point[i], point[j]) = (a, b);
        RationalPoint3::new(point.map(Int::from), Int::from(1))
    };
    let (a, b, c, d) = (start(i), high[i], start(j), high[j]);
    vec![corner(a, c), corner(b, c), corner(b, d), corner(a, d)]
}
