//! Expressions of brushes: whatever is read has a value or an error, and no cell without volume.
#![no_main]

use libfuzzer_sys::fuzz_target;
use stabline::csg::{Placed, evaluate};
use stabline::formats::csg::CsgFile;

fuzz_target!(|bytes: &[u8]| {
    let Ok(file) = CsgFile::read(bytes) else { return };
    let Ok(placed) = Placed::try_from(&file) else { return };
    // The time grows with the brushes, and more of them find nothing else.
    if placed.places.len() <= 12 {
        if let Ok(body) = evaluate(&placed.expression) {
            assert_eq!(body.boundary.is_empty(), body.cells.is_empty());
        }
    }
});
