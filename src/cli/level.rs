//! Inputs that may be a level's source, whose cells are made on the way.

use super::exit::Failure;
use super::files::Input;
use crate::portal::{LevelCells, LevelError, cells_of_level};
use crate::scene::{self, Level, LevelOptions, PortalGraph};
use crate::subdivision::Options;

/// Whether the input is a level's source: its name ends in `.map`.
pub(super) fn is_level(input: &Input) -> bool {
    input.name.to_ascii_lowercase().ends_with(".map")
}

/// The portal graph of any input: that of a portal file or a JSON scene, or that of the cells of a
/// level's inside.
pub(super) fn read_graph(input: &Input) -> Result<PortalGraph, Failure> {
    if !is_level(input) {
        return Ok(scene::read_graph(&input.name, &input.bytes)?);
    }
    let level = read(input, LevelOptions::default())?;
    if !level.warnings.is_empty() {
        let count = level.warnings.len();
        eprintln!("{}: {count} oddities repaired (`stabline bsp` lists them)", input.name);
    }
    let cells = divide(&level).map_err(|error| failure(input, &error))?;
    Ok(cells.graph)
}

/// A level's source.
pub(super) fn read(input: &Input, options: LevelOptions) -> Result<Level, Failure> {
    Ok(scene::read_level(&input.name, &input.bytes, options)?)
}

/// The cells of a level's inside.
pub(super) fn divide(level: &Level) -> Result<LevelCells, LevelError> {
    cells_of_level(level, &Options::default())
}

/// The error of a level, with its file.
pub(super) fn failure(input: &Input, error: &LevelError) -> Failure {
    Failure::file(&input.name, error)
}
