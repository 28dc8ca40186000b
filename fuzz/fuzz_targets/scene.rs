//! JSON scenes: what is read and written again is the same scene, and gives the same graph.
#![no_main]

use libfuzzer_sys::fuzz_target;
use stabline::formats::json::SceneFile;
use stabline::scene::read_graph;

fuzz_target!(|bytes: &[u8]| {
    if let Ok(scene) = SceneFile::read(bytes) {
        let text = scene.to_text();
        assert_eq!(SceneFile::read(text.as_bytes()), Ok(scene));
        assert_eq!(read_graph("x", bytes), read_graph("x", text.as_bytes()));
    }
});
