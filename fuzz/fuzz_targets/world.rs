//! JSON scenes with geometry, and `.obj`, to worlds: what comes out keeps the world's promises.
#![no_main]

use libfuzzer_sys::fuzz_target;
use stabline::scene::{WorldOptions, read_world};

fuzz_target!(|bytes: &[u8]| {
    for (name, snap) in [("x", None), ("x", Some(1)), ("x.obj", None), ("x.obj", Some(0))] {
        let options = WorldOptions { snap, ..WorldOptions::default() };
        if let Ok((world, warnings)) = read_world(name, bytes, &options) {
            assert!(world.solids.iter().all(|solid| solid.planes.len() >= 4));
            assert!(world.polygons.iter().all(|polygon| polygon.vertices.len() >= 3));
            assert!(world.objects.iter().all(|object| object.bounds.has_volume()));
            assert!(warnings.iter().all(|warning| !warning.to_string().contains('\n')));
        }
    }
});
