//! `stabline stab`: the verdict of one portal sequence.

use super::exit::{Exit, Failure};
use super::files::{self, Input};
use crate::formats::sequence::{SequenceFile, SequencePoints};
use crate::geom::{BigPoint2, BigPoint3};
use crate::report::StabReport;
use crate::stab::hourglass::Hourglass;
use crate::stab::{Portal3, Stabber};
use std::path::PathBuf;

/// Decide whether a line passes a sequence of portals: open, grazing or blocked, with a proof
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    /// The portals: `stabline-sequence/1`, or `-` for standard input
    sequence: PathBuf,
    /// Print JSON (`stabline-stab/1`)
    #[arg(long)]
    json: bool,
    /// List the extremal stabbing lines, each with the edges that it touches
    #[arg(long)]
    lines: bool,
    /// Ask lines to cross consecutive portals in their order
    #[arg(long)]
    ordered: bool,
}

pub(super) fn run(args: Args) -> Result<Exit, Failure> {
    let input = Input::read(&args.sequence)?;
    let points = SequenceFile::read(&input.bytes)
        .and_then(|file| file.points())
        .map_err(|error| Failure::file(&input.name, error))?;
    let report = match points {
        SequencePoints::Space { denominator, portals } => {
            let stabber = stabber(&portals, args.ordered)
                .map_err(|error| Failure::file(&input.name, error))?;
            let (verdict, lines) = (stabber.verdict(), stabber.extremal_lines());
            StabReport::new(&verdict, &lines, &denominator, args.lines)
        }
        SequencePoints::Plane { denominator, portals } => {
            if args.lines || args.ordered {
                return Err(Failure::usage("--lines and --ordered are for sequences in space"));
            }
            let hourglass =
                hourglass(portals).map_err(|error| Failure::file(&input.name, error))?;
            StabReport::of_plane(&hourglass.verdict(), &denominator)
        }
    };
    let text = if args.json { report.to_json() } else { report.to_text() };
    files::print(&text).map(|()| Exit::Done)
}

/// The hourglass of a sequence in the plane.
pub(super) fn hourglass(portals: Vec<[BigPoint2; 2]>) -> Result<Hourglass, String> {
    let mut hourglass = Hourglass::new();
    for (index, [left, right]) in portals.into_iter().enumerate() {
        if left == right {
            return Err(format!("portals[{index}]: vertex 1 is the same point as vertex 0"));
        }
        hourglass.push_big(left, right);
    }
    Ok(hourglass)
}

fn stabber(portals: &[Vec<BigPoint3>], ordered: bool) -> Result<Stabber, String> {
    let mut stabber = Stabber::new();
    for (index, vertices) in portals.iter().enumerate() {
        let portal =
            Portal3::new(vertices).map_err(|error| format!("portals[{index}]: {error}"))?;
        stabber.push(&portal, ordered && index > 0);
    }
    Ok(stabber)
}
