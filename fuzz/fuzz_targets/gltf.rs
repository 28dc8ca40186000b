//! glTF: any bytes give triangles whose corners are vertices, or an error.
#![no_main]

use libfuzzer_sys::fuzz_target;
use stabline::formats::gltf;

fuzz_target!(|bytes: &[u8]| {
    let mut beside = |_: &str| Ok(vec![0x3f; 64]);
    if let Ok(file) = gltf::read(bytes, &mut beside) {
        for part in &file.parts {
            let corners = part.triangles.as_flattened();
            assert!(corners.iter().all(|&corner| (corner as usize) < part.vertices.len()));
        }
    }
});
