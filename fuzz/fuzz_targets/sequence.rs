//! The engine against its twins: each byte is a coordinate. The first says what is asked: triangles
//! in space, gates of the plane, or four lines.
#![no_main]

use libfuzzer_sys::fuzz_target;
use stabline::forge::{Fault, Input, Polygon, accepts, find, twin};
use stabline::num::{Int, Rational};

/// Groups of `count` points of `axes` coordinates.
fn groups(bytes: &[u8], axes: usize, count: usize) -> Vec<Polygon> {
    let number = |&byte: &u8| Rational::from(Int::from(byte as i8));
    let point = |point: &[u8]| point.iter().map(number).collect();
    let polygon = |group: &[u8]| group.chunks_exact(axes).map(point).collect();
    bytes.chunks_exact(axes * count).map(polygon).collect()
}

fuzz_target!(|bytes: &[u8]| {
    let Some((kind, bytes)) = bytes.split_first() else { return };
    let input = match kind % 3 {
        0 => Input::Sequence(groups(&bytes[..bytes.len().min(27)], 3, 3)),
        1 => Input::Sequence(groups(&bytes[..bytes.len().min(24)], 2, 2)),
        _ => Input::Lines(groups(&bytes[..bytes.len().min(24)], 3, 2)),
    };
    let is_whole = match &input {
        Input::Lines(lines) => lines.len() == 4,
        // Formats refuse a sequence of no portals.
        input => !input.polygons().is_empty(),
    };
    if !is_whole || !accepts(&input) {
        return;
    }
    match find(&input) {
        Ok(found) => assert_eq!(Some(found.answer), twin::answer(&input).unwrap()),
        Err(Fault::Refused(_)) => {}
        Err(fault) => panic!("{fault}"),
    }
});
