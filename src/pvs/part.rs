//! Finished rows in a file, `stabline-pvs-part/1`: what an interrupted run keeps, and what shards
//! hand over.
//!
//! One JSON object a line: first the header, which says what the rows belong to, then one line a
//! row. Rows are appended as they are finished, in any order; a last line without its end (of a
//! run that was killed while writing) is left out when the part is read. Tallies stay behind, as
//! they depend on the threads.

use super::{OpenPair, Row, Sightline, Tally};
use crate::num::Number;
use crate::report::InputId;
use crate::scene::{CellId, PortalGraph};
use serde::{Deserialize, Serialize};

/// The name of the format.
pub const FORMAT: &str = "stabline-pvs-part/1";

/// What the rows of a part belong to; parts with equal headers may be put together.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PartHeader {
    /// The program and its version.
    pub program: String,
    /// The input.
    pub input: InputId,
    /// The budget that the rows were computed with.
    pub budget: Option<u64>,
}

/// A header and finished rows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Part {
    /// What the rows belong to.
    pub header: PartHeader,
    /// The rows, in the order of the file.
    pub rows: Vec<Row>,
}

/// Why a file is not a part, and in which line.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{what}")]
pub struct PartError {
    /// The line, counted from 1.
    pub line: usize,
    /// What is wrong.
    pub what: String,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct HeaderLine {
    format: String,
    program: String,
    input: InputLine,
    budget: Option<u64>,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct InputLine {
    name: String,
    blake3: String,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct RowLine {
    source: u32,
    open: Vec<OpenLine>,
    undecided: Vec<u32>,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct OpenLine {
    target: u32,
    portals: Vec<u32>,
    line: [[String; 3]; 2],
}

impl PartHeader {
    /// The header's line, with its end.
    ///
    /// # Errors
    /// None but those of the JSON writer, which has no reason to fail.
    pub fn to_line(&self) -> serde_json::Result<String> {
        let line = HeaderLine {
            format: FORMAT.to_owned(),
            program: self.program.clone(),
            input: InputLine { name: self.input.name.clone(), blake3: self.input.blake3.clone() },
            budget: self.budget,
        };
        Ok(serde_json::to_string(&line)? + "\n")
    }

    fn from_line(text: &str) -> Result<PartHeader, String> {
        let line: HeaderLine = serde_json::from_str(text).map_err(|e| e.to_string())?;
        if line.format != FORMAT {
            return Err(format!("format {:?}, expected {FORMAT:?}", line.format));
        }
        let input = InputId { name: line.input.name, blake3: line.input.blake3 };
        Ok(PartHeader { program: line.program, input, budget: line.budget })
    }
}

impl Row {
    /// The row's line, with its end.
    ///
    /// # Errors
    /// None but those of the JSON writer, which has no reason to fail.
    pub fn to_line(&self) -> serde_json::Result<String> {
        let open = self.open.iter().map(|pair| OpenLine {
            target: pair.target.0,
            portals: pair.portals.clone(),
            line: pair.line.numbers().map(|point| point.map(|number| number.to_string())),
        });
        let line = RowLine {
            source: self.source.0,
            open: open.collect(),
            undecided: self.undecided.iter().map(|cell| cell.0).collect(),
        };
        Ok(serde_json::to_string(&line)? + "\n")
    }

    fn from_line(text: &str, graph: &PortalGraph) -> Result<Row, String> {
        let line: RowLine = serde_json::from_str(text).map_err(|e| e.to_string())?;
        let cell = |index: u32| {
            let exists = (index as usize) < graph.cells.len();
            exists.then_some(CellId(index)).ok_or_else(|| {
                format!("cell {index}, expected one of the {} cells", graph.cells.len())
            })
        };
        let open = line.open.into_iter().map(|pair| {
            let mut points = pair.line.map(|point| point.map(|text| Number::parse(&text)));
            let number = |parsed: &mut Result<Number, _>| match parsed {
                Ok(number) => Ok(number.to_rational()),
                Err(error) => Err(format!("a coordinate is {error}")),
            };
            let [[px, py, pz], [qx, qy, qz]] = &mut points;
            let line =
                [[number(px)?, number(py)?, number(pz)?], [number(qx)?, number(qy)?, number(qz)?]];
            let line = Sightline::Rational(Box::new(line));
            Ok(OpenPair { target: cell(pair.target)?, portals: pair.portals, line })
        });
        Ok(Row {
            source: cell(line.source)?,
            open: open.collect::<Result<_, String>>()?,
            undecided: line.undecided.into_iter().map(cell).collect::<Result<_, String>>()?,
            tally: Tally::default(),
        })
    }
}

impl Part {
    /// Reads a part of the rows of `graph`.
    ///
    /// # Errors
    /// [`PartError`] names the line and what is wrong with it. A last line that is cut short is no
    /// error: its row was not finished.
    pub fn read(text: &str, graph: &PortalGraph) -> Result<Part, PartError> {
        let error = |line, what| PartError { line, what };
        let mut lines = text.split_inclusive('\n').filter(|line| line.ends_with('\n'));
        let header = lines.next().ok_or_else(|| error(1, "no header".to_owned()))?;
        let header = PartHeader::from_line(header).map_err(|what| error(1, what))?;
        let rows = lines.enumerate().map(|(index, line)| {
            Row::from_line(line, graph).map_err(|what| error(index + 2, what))
        });
        Ok(Part { header, rows: rows.collect::<Result<_, _>>()? })
    }
}
