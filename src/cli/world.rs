//! Inputs that may be a world, whose cells are made on the way.

use super::exit::Failure;
use super::files::Input;
use crate::portal::{WorldCells, cells_of_world};
use crate::scene::world::{InputKind, WorldWarning, read_world_with};
use crate::scene::{self, LevelOptions, PortalGraph, World, WorldOptions};
use crate::subdivision::Options;
use std::path::{Component, Path};

/// How an input that states geometry is read.
#[derive(Clone, Copy, Debug, Default, clap::Args)]
pub(super) struct WorldArgs {
    /// Liquids of a `.map` hide what is behind them
    #[arg(long)]
    opaque_liquids: bool,
    /// Keep every digit of a `.map`'s coordinates with more than six decimals
    #[arg(long)]
    keep_digits: bool,
    /// Round the coordinates of an input's points to this many decimals; the largest displacement
    /// is told
    #[arg(long, value_name = "DECIMALS", conflicts_with = "keep_digits",
        value_parser = clap::value_parser!(u32).range(0..=18))]
    snap_input: Option<u32>,
}

impl WorldArgs {
    fn options(self) -> WorldOptions {
        let level = LevelOptions {
            opaque_liquids: self.opaque_liquids,
            keep_digits: self.keep_digits,
            ..LevelOptions::default()
        };
        WorldOptions { level, snap: self.snap_input }
    }
}

/// Whether the input is a world, and not a portal graph.
pub(super) fn is_world(input: &Input) -> bool {
    match InputKind::of(&input.name, &input.bytes) {
        Ok(InputKind::Map | InputKind::Obj | InputKind::Gltf | InputKind::Geometry) => true,
        // Who reads it as a graph finds what is wrong with it.
        Ok(InputKind::Graph) | Err(_) => false,
    }
}

/// The world that an input states, and what was repaired.
pub(super) fn read_all(
    input: &Input,
    args: WorldArgs,
) -> Result<(World, Vec<WorldWarning>), Failure> {
    let mut beside = |name: &str| file_beside(input, name);
    Ok(read_world_with(&input.name, &input.bytes, &args.options(), &mut beside)?)
}

/// The world that an input states.
pub(super) fn read(input: &Input, args: WorldArgs) -> Result<World, Failure> {
    let (world, warnings) = read_all(input, args)?;
    if !warnings.is_empty() {
        let count = warnings.len();
        eprintln!("{}: {count} oddities repaired (`stabline bsp` lists them)", input.name);
    }
    Ok(world)
}

/// The bytes of a file that the input names, in its folder or below.
fn file_beside(input: &Input, name: &str) -> Result<Vec<u8>, String> {
    let shown = name.escape_debug();
    let path = Path::new(name);
    let is_below = path.components().all(|part| matches!(part, Component::Normal(_)));
    if name.is_empty() || !is_below || name.contains(':') {
        return Err(format!("`{shown}` is not a file in the folder of the input"));
    }
    if input.name == "-" {
        return Err(format!("`{shown}` has no place beside standard input"));
    }
    let folder = Path::new(&input.name).parent().unwrap_or(Path::new(""));
    std::fs::read(folder.join(path)).map_err(|error| format!("`{shown}`: {error}"))
}

/// The cells of a world.
pub(super) fn cells(input: &Input, world: &World) -> Result<WorldCells, Failure> {
    cells_of_world(world, &Options::default()).map_err(|error| Failure::file(&input.name, error))
}

/// The portal graph of any input: that of a portal file or a JSON scene, or that of a world's
/// cells.
pub(super) fn read_graph(input: &Input, args: WorldArgs) -> Result<PortalGraph, Failure> {
    if !is_world(input) {
        return Ok(scene::read_graph(&input.name, &input.bytes)?);
    }
    Ok(cells(input, &read(input, args)?)?.graph)
}
