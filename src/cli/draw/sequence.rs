//! Pictures of sequences of segments.

use super::super::exit::Failure;
use super::super::files::Input;
use super::super::stab::hourglass;
use super::{Args, options};
use crate::draw::{self, SequenceLine};
use crate::formats::sequence::{SEQUENCE_FORMAT, SequenceFile, SequencePoints};
use crate::num::Rational;
use crate::stab::hourglass::PlaneVerdict;

/// Whether the text says that it is a sequence. Who reads it finds what else is wrong with it.
pub(super) fn is_sequence(bytes: &[u8]) -> bool {
    #[derive(serde::Deserialize)]
    struct Stated {
        format: String,
    }
    serde_json::from_slice(bytes).is_ok_and(|stated: Stated| stated.format == SEQUENCE_FORMAT)
}

/// Draws a sequence with its verdict.
pub(super) fn draw(args: &Args, input: &Input) -> Result<String, Failure> {
    let wrong = |error: &dyn std::fmt::Display| Failure::file(&input.name, error);
    let file = SequenceFile::read(&input.bytes).map_err(|error| wrong(&error))?;
    let portals = match file.points().map_err(|error| wrong(&error))? {
        SequencePoints::Plane { portals, .. } => portals,
        SequencePoints::Space { .. } => {
            return Err(wrong(&"the sequence lies in space, and pictures in the plane"));
        }
    };
    let ends: Vec<[[Rational; 2]; 2]> = portals
        .iter()
        .map(|portal| portal.clone().map(|end| end.coordinates.map(Rational::from)))
        .collect();
    let hourglass = hourglass(portals).map_err(|error| wrong(&error))?;
    let (line, about) = match hourglass.verdict() {
        PlaneVerdict::Open(witness) => (SequenceLine::Stabbing(witness.points), "open"),
        PlaneVerdict::Grazing { touching_line, .. } => {
            let points = touching_line.map(|point| point.coordinates.map(Rational::from));
            (SequenceLine::Touching(points), "grazing")
        }
        PlaneVerdict::Blocked { .. } => (SequenceLine::Blocked, "blocked"),
    };
    Ok(draw::draw_sequence(&ends, &line, &options(args, input, about)))
}
