//! Levels' sources: any bytes give a level or an error, and a level's brushes bound a volume.
#![no_main]

use libfuzzer_sys::fuzz_target;
use stabline::scene::{LevelOptions, read_level};

fuzz_target!(|bytes: &[u8]| {
    if let Ok(level) = read_level("x", bytes, LevelOptions::default()) {
        for brush in &level.brushes {
            assert!(brush.faces.len() >= 4 && brush.entity < level.entities.len());
        }
    }
});
