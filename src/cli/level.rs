//! Inputs that may be a level's source, whose cells are made on the way.

use super::exit::Failure;
use super::files::Input;
use crate::portal::cells_of_level;
use crate::scene::{self, LevelOptions, PortalGraph};
use crate::subdivision::Options;

/// The portal graph of any input: that of a portal file or a JSON scene, or that of the cells of
/// the inside of a level's source, whose name ends in `.map`.
pub(super) fn read_graph(input: &Input) -> Result<PortalGraph, Failure> {
    if !input.name.to_ascii_lowercase().ends_with(".map") {
        return Ok(scene::read_graph(&input.name, &input.bytes)?);
    }
    let level = scene::read_level(&input.name, &input.bytes, LevelOptions::default())?;
    if !level.warnings.is_empty() {
        let count = level.warnings.len();
        eprintln!("{}: {count} oddities repaired (`stabline bsp` lists them)", input.name);
    }
    let cells = cells_of_level(&level, &Options::default());
    Ok(cells.map_err(|error| Failure::file(&input.name, error))?.graph)
}
