//! Levels' sources: any bytes give a level or an error, a level's brushes bound a volume, and a
//! small level has cells or a reason why not.
#![no_main]

use libfuzzer_sys::fuzz_target;
use stabline::num::Rational;
use stabline::portal::cells_of_world;
use stabline::scene::{LevelOptions, World, read_level};
use stabline::subdivision::Options;

fuzz_target!(|bytes: &[u8]| {
    let Ok(level) = read_level("x", bytes, LevelOptions::default()) else { return };
    for brush in &level.brushes {
        assert!(brush.faces.len() >= 4 && brush.entity < level.entities.len());
    }
    let world = World::of_level(&level);
    // The time it takes grows with the square of the faces.
    if level.brushes.iter().map(|brush| brush.faces.len()).sum::<usize>() > 64 {
        return;
    }
    if let Ok(cells) = cells_of_world(&world, &Options::default()) {
        let division = &cells.subdivision;
        let volume: Rational = division.leaves.iter().map(|leaf| leaf.cell.volume()).sum();
        assert_eq!(volume, division.bounds.polyhedron(&division.planes).volume());
    }
});
