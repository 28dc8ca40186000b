//! `stabline schema`: the JSON schemas.

use super::exit::{Exit, Failure};
use super::files;
use crate::audit;
use crate::formats::csg::CsgFile;
use crate::formats::json::SceneKind;
use crate::formats::lines::LinesFile;
use crate::formats::sequence::SequenceFile;
use crate::report::{
    BodyReport, BodyTreeReport, BspReport, CellsReport, EyePlanReport, EyeReport, MoveReport,
    ObjectsReport, PlanReport, PvsReport, StabReport, TransversalsReport,
};
use crate::vectors::{ScoreReport, VectorsFile};
use serde_json::Value;

/// Print the JSON schema of a format, or the names of all
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    /// The format, with or without its version: `pvs`, `stabline-scene/1`
    name: Option<String>,
    /// Print the list of names as JSON
    #[arg(long)]
    json: bool,
}

/// A format's full name, and its schema.
type Format = (&'static str, fn() -> Value);

/// Every format.
const SCHEMAS: &[Format] = &[
    (BodyReport::FORMAT, BodyReport::schema),
    (BspReport::FORMAT, BspReport::schema),
    (CellsReport::FORMAT, CellsReport::schema),
    ("stabline-check/1", audit::check::schema),
    ("stabline-csg/1", CsgFile::schema),
    (BodyTreeReport::FORMAT, BodyTreeReport::schema),
    (EyeReport::FORMAT, EyeReport::schema),
    (EyePlanReport::FORMAT, EyePlanReport::schema),
    ("stabline-lines/1", LinesFile::schema),
    (MoveReport::FORMAT, MoveReport::schema),
    ("stabline-objects/1", ObjectsReport::schema),
    (PlanReport::FORMAT, PlanReport::schema),
    ("stabline-pvs/1", PvsReport::schema),
    ("stabline-scene/1", SceneKind::schema),
    ("stabline-sequence/1", SequenceFile::schema),
    ("stabline-stab/1", StabReport::schema),
    ("stabline-transversals/1", TransversalsReport::schema),
    (VectorsFile::FORMAT, VectorsFile::schema),
    (ScoreReport::FORMAT, ScoreReport::schema),
];

/// Whether `name` is short for `full`: `pvs`, `pvs/1`, `stabline-pvs`, `stabline-pvs/1`.
fn means(name: &str, full: &str) -> bool {
    let short = full.strip_prefix("stabline-").unwrap_or(full);
    let stem = |text: &'_ str| text.split('/').next().unwrap_or_default().to_owned();
    [full, short].iter().any(|known| name == *known || name == stem(known))
}

pub(super) fn run(args: Args) -> Result<Exit, Failure> {
    let text = match args.name {
        None if args.json => {
            let names: Vec<&str> = SCHEMAS.iter().map(|(name, _)| *name).collect();
            format!("{}\n", Value::from(names))
        }
        None => SCHEMAS.iter().map(|(name, _)| format!("{name}\n")).collect(),
        Some(name) => match SCHEMAS.iter().find(|(full, _)| means(&name, full)) {
            Some((_, schema)) => format!("{:#}\n", schema()),
            None => {
                let known: Vec<&str> = SCHEMAS.iter().map(|(name, _)| *name).collect();
                let what = format!("no format `{name}`, expected one of {}", known.join(", "));
                return Err(Failure::usage(what));
            }
        },
    };
    files::print(&text).map(|()| Exit::Done)
}
