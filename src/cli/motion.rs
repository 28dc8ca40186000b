//! `stabline move`: how far a point or a box gets.

use super::exit::{Exit, Failure};
use super::files::{self, Input};
use super::numbers::{numbers, point};
use super::world::{self, WorldArgs};
use crate::geom::AxialBox;
use crate::motion::{Move, MoveError, Space};
use crate::num::Rational;
use crate::report::{InputId, Silent};
use crate::scene::World;
use std::path::PathBuf;

/// Move a point or an axial box in a straight line, up to the first contact
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    /// The world, as a level's source (`.map`)
    input: PathBuf,
    #[command(flatten)]
    world: WorldArgs,
    /// Where the point starts: three decimals or ratios
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true)]
    from: String,
    /// Where it would end
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true)]
    to: String,
    /// The box that it carries, as seen from it: half its size on each axis, or two corners
    #[arg(long = "box", value_name = "HX,HY,HZ|LOW..HIGH", allow_hyphen_values = true)]
    body: Option<String>,
    /// Print JSON (`stabline-move/1`)
    #[arg(long)]
    json: bool,
}

pub(super) fn run(args: Args) -> Result<Exit, Failure> {
    args.world.refuse_hulls()?;
    let motion = Move {
        from: point("--from", &args.from)?,
        to: point("--to", &args.to)?,
        body: args.body.as_deref().map(corners).transpose()?,
    };
    let input = Input::read(&args.input)?;
    if super::plan::is_plan(&input) {
        return Err(Failure::file(
            &input.name,
            "a floorplan, expected a world of three dimensions",
        ));
    }
    if !world::is_world(&input) {
        let what = "a portal graph has no walls to meet, expected a world (`.map`)";
        return Err(Failure::file(&input.name, what));
    }
    let (world, cells) = world::divided(&input, &args.world, &Silent)?;
    let walk = Space::new(&world, &cells).first_contact(&motion);
    let walk = walk.map_err(|error| failure(&input, &world, &error))?;
    let id = InputId::new(&input.file_name(), &input.bytes);
    let report = walk.report(&motion, &world, &cells.graph.cells, id);
    let text = if args.json { report.to_json() } else { report.to_text() };
    files::print(&text).map(|()| Exit::Done)
}

/// A box around the point, or between two corners as seen from it.
fn corners(text: &str) -> Result<AxialBox, Failure> {
    let Some((low, high)) = text.split_once("..") else {
        let high: [Rational; 3] = numbers("--box", text)?;
        return Ok(AxialBox { low: high.each_ref().map(|h| -h), high });
    };
    Ok(AxialBox { low: numbers("--box", low)?, high: numbers("--box", high)? })
}

fn failure(input: &Input, world: &World, error: &MoveError) -> Failure {
    let obstacle = match error {
        MoveError::NoVolume => return Failure::usage(format!("--box: {error}")),
        MoveError::Nowhere { solid, .. } => *solid,
        MoveError::Overlap { obstacle } => Some(*obstacle),
    };
    match obstacle.map(|obstacle| obstacle.place(world)) {
        None => Failure::file(&input.name, error),
        Some(None) => Failure::file(&input.name, format!("{error}: the end of the world")),
        Some(Some(place)) => Failure::file(&input.name, format!("{error}: {place}")),
    }
}
