//! This crate's own answers, by the searches that `pvs`, `stab` and `eye` use.

mod eye;
mod pairs;
mod view_cells;

pub use view_cells::{ViewCells, ViewCells2};

use super::witness::on_grid;
use super::{Answer, Case, Class, Kind, LineCount, Witness};
use crate::formats::lines::LinesFile;
use crate::formats::sequence::{SequenceFile, SequencePoints};
use crate::scene::InputError;
use crate::stab::hourglass::{Hourglass, PlaneVerdict};
use crate::stab::transversals::transversals;
use crate::stab::{Portal3, Stabber, Verdict};
use serde_json::Value;
use std::fmt::Display;

/// Why a case has no answer.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum EngineError {
    /// The input is refused.
    #[error("input: {0}")]
    Input(String),
    /// A field that the kind of case needs is missing.
    #[error("no `{0}`")]
    NoField(&'static str),
    /// A name that nothing has.
    #[error("`{field}`: there is no `{name}`")]
    Unknown {
        /// The field that holds the name.
        field: &'static str,
        /// The name.
        name: String,
    },
}

impl EngineError {
    fn input(what: impl Display) -> EngineError {
        EngineError::Input(what.to_string())
    }
}

impl From<InputError> for EngineError {
    fn from(error: InputError) -> EngineError {
        EngineError::input(error)
    }
}

/// The name that messages give to a case's scene.
const NAME: &str = "input";

/// The exact answer to a case.
///
/// Complexity: that of the question, as its module states it.
///
/// # Errors
/// [`EngineError`] for an input that is refused, and for a name that it does not have.
pub fn answer(case: &Case) -> Result<Answer, EngineError> {
    answer_with_witness(case).map(|(answer, _)| answer)
}

/// The exact answer to a case; with the line of an open sequence.
///
/// Complexity: as [`answer`].
///
/// # Errors
/// As [`answer`].
pub fn answer_with_witness(case: &Case) -> Result<(Answer, Option<Witness>), EngineError> {
    let bytes = || case.input.to_string().into_bytes();
    let answer = match case.kind {
        Kind::Sequence => {
            return sequence(&bytes()).map(|(class, line)| (Answer::Class(class), line));
        }
        Kind::Transversals => lines(&bytes()).map(Answer::Lines),
        Kind::Graph => pairs::of_graph(&case.input, ends(case)?).map(Answer::Class),
        Kind::Scene => pairs::of_scene(&case.input, ends(case)?).map(Answer::Class),
        Kind::Eye => eye::seen(&case.input).map(Answer::of_cells),
    };
    answer.map(|answer| (answer, None))
}

/// The names in `from` and `to`.
fn ends(case: &Case) -> Result<[&str; 2], EngineError> {
    let from = case.from.as_deref().ok_or(EngineError::NoField("from"))?;
    let to = case.to.as_deref().ok_or(EngineError::NoField("to"))?;
    Ok([from, to])
}

/// The place of a name in a list.
fn index_of<'a>(
    mut names: impl Iterator<Item = &'a String>,
    field: &'static str,
    name: &str,
) -> Result<usize, EngineError> {
    let index = names.position(|other| other == name);
    index.ok_or_else(|| EngineError::Unknown { field, name: name.to_owned() })
}

fn sequence(bytes: &[u8]) -> Result<(Class, Option<Witness>), EngineError> {
    let points = SequenceFile::read(bytes).and_then(|file| file.points());
    match points.map_err(EngineError::input)? {
        SequencePoints::Space { denominator, portals } => {
            let mut stabber = Stabber::new();
            for vertices in &portals {
                stabber.push(&Portal3::new(vertices).map_err(EngineError::input)?, false);
            }
            Ok(match stabber.verdict() {
                Verdict::Open { witness } => {
                    (Class::Open, Some(on_grid(&witness.points, &denominator)))
                }
                Verdict::Grazing { .. } => (Class::Grazing, None),
                Verdict::Blocked { .. } => (Class::Blocked, None),
            })
        }
        SequencePoints::Plane { denominator, portals } => {
            let mut hourglass = Hourglass::new();
            for [left, right] in portals {
                if left == right {
                    return Err(EngineError::input("a portal with one end"));
                }
                hourglass.push_big(left, right);
            }
            Ok(match hourglass.verdict() {
                PlaneVerdict::Open(witness) => {
                    (Class::Open, Some(on_grid(&witness.points, &denominator)))
                }
                PlaneVerdict::Grazing { .. } => (Class::Grazing, None),
                PlaneVerdict::Blocked { .. } => (Class::Blocked, None),
            })
        }
    }
}

fn lines(bytes: &[u8]) -> Result<LineCount, EngineError> {
    let lines = LinesFile::read(bytes).and_then(|file| file.lines()).map_err(EngineError::input)?;
    let found = transversals(&lines);
    Ok(match (found.families.is_empty(), found.isolated.len()) {
        (false, _) => LineCount::Family,
        (true, 0) => LineCount::None,
        (true, 1) => LineCount::One,
        (true, _) => LineCount::Two,
    })
}

/// A field of an object.
fn field<'v>(value: &'v Value, name: &'static str) -> Result<&'v Value, EngineError> {
    value.get(name).ok_or(EngineError::NoField(name))
}
