//! Inputs that may be a world, whose cells are made on the way.

use super::exit::Failure;
use super::files::Input;
use crate::portal::{WorldCells, cells_of_world};
use crate::scene::{self, LevelOptions, PortalGraph, World};
use crate::subdivision::Options;

/// Whether the input is a world, and not a portal graph.
pub(super) fn is_world(input: &Input) -> bool {
    input.name.to_ascii_lowercase().ends_with(".map")
}

/// The world that an input states.
pub(super) fn read(input: &Input) -> Result<World, Failure> {
    let level = scene::read_level(&input.name, &input.bytes, LevelOptions::default())?;
    if !level.warnings.is_empty() {
        let count = level.warnings.len();
        eprintln!("{}: {count} oddities repaired (`stabline bsp` lists them)", input.name);
    }
    Ok(World::of_level(&level))
}

/// The cells of a world.
pub(super) fn cells(input: &Input, world: &World) -> Result<WorldCells, Failure> {
    cells_of_world(world, &Options::default()).map_err(|error| Failure::file(&input.name, error))
}

/// The portal graph of any input: that of a portal file or a JSON scene, or that of a world's
/// cells.
pub(super) fn read_graph(input: &Input) -> Result<PortalGraph, Failure> {
    if !is_world(input) {
        return Ok(scene::read_graph(&input.name, &input.bytes)?);
    }
    Ok(cells(input, &read(input)?)?.graph)
}
