//! `.obj`: any bytes give faces whose corners are vertices, or an error with its line.
#![no_main]

use libfuzzer_sys::fuzz_target;
use stabline::formats::obj;

fuzz_target!(|bytes: &[u8]| match obj::read(bytes) {
    Ok(file) => {
        for face in &file.faces {
            assert!(face.corners.len() >= 3 && face.line >= 1);
            assert!(face.corners.iter().all(|&corner| (corner as usize) < file.vertices.len()));
        }
    }
    Err(error) => assert!(error.line >= 1),
});
