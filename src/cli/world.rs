//! Inputs that may be a world, whose cells are made on the way.

use super::division::DivisionArgs;
use super::exit::Failure;
use super::files::Input;
use crate::portal::{WorldCells, WorldError, divide_world};
use crate::report::Progress;
use crate::scene::world::{InputKind, WorldWarning, read_world_with};
use crate::scene::{self, LevelOptions, PortalGraph, World, WorldOptions};
use crate::subdivision::DivisionError;
use std::path::{Component, Path};

/// How an input that states geometry is read, and divided into cells.
#[derive(Clone, Debug, clap::Args)]
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
    #[command(flatten)]
    pub division: DivisionArgs,
}

impl WorldArgs {
    fn options(&self) -> WorldOptions {
        let level = LevelOptions {
            opaque_liquids: self.opaque_liquids,
            keep_digits: self.keep_digits,
            ..LevelOptions::default()
        };
        WorldOptions { level, snap: self.snap_input }
    }
}

impl WorldArgs {
    /// The options that are not the default, as they are written: what else than the input's bytes
    /// its cells depend on.
    pub(super) fn stated(&self) -> String {
        let mut stated = Vec::new();
        if self.opaque_liquids {
            stated.push("--opaque-liquids".to_owned());
        }
        if self.keep_digits {
            stated.push("--keep-digits".to_owned());
        }
        stated.extend(self.snap_input.map(|decimals| format!("--snap-input {decimals}")));
        stated.extend(self.division.stated());
        stated.join(" ")
    }

    /// Refuses portals that may run across occluders, for whoever would call exact what is not.
    pub(super) fn refuse_hulls(&self) -> Result<(), Failure> {
        match self.division.is_conservative() {
            true => Err(Failure::usage(
                "--portals hull: hulls run across occluders, and the answer is exact",
            )),
            false => Ok(()),
        }
    }
}

/// Whether the input is a world, and not a portal graph.
pub(super) fn is_world(input: &Input) -> bool {
    match InputKind::of(&input.name, &input.bytes) {
        Ok(InputKind::Map | InputKind::Obj | InputKind::Gltf | InputKind::Geometry) => true,
        // Who reads it as a graph finds what is wrong with it.
        Ok(InputKind::Graph | InputKind::Plan) | Err(_) => false,
    }
}

/// The world that an input states, and what was repaired.
pub(super) fn read_all(
    input: &Input,
    args: &WorldArgs,
) -> Result<(World, Vec<WorldWarning>), Failure> {
    let mut beside = |name: &str| file_beside(input, name);
    Ok(read_world_with(&input.name, &input.bytes, &args.options(), &mut beside)?)
}

/// The world that an input states.
fn read(input: &Input, args: &WorldArgs) -> Result<World, Failure> {
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

/// The world that an input states, and its cells.
pub(super) fn divided(
    input: &Input,
    args: &WorldArgs,
    progress: &dyn Progress,
) -> Result<(World, WorldCells), Failure> {
    let options = args.division.options()?;
    let world = read(input, args)?;
    let cells = divide_world(&world, &options, progress).map_err(|error| match error {
        WorldError::Division(DivisionError::Interrupted) => Failure::Interrupted,
        error => Failure::file(&input.name, error),
    })?;
    Ok((world, cells))
}

/// The portal graph of any input: that of a portal file or a JSON scene, or that of a world's
/// cells.
pub(super) fn read_graph(
    input: &Input,
    args: &WorldArgs,
    progress: &dyn Progress,
) -> Result<PortalGraph, Failure> {
    if !is_world(input) {
        return Ok(scene::read_graph(&input.name, &input.bytes)?);
    }
    Ok(divided(input, args, progress)?.1.graph)
}
