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
    /// The options with which the input was read and divided, where they are not the default.
    pub reading: String,
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
    #[serde(default, skip_serializing_if = "String::is_empty")]
    reading: String,
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
            reading: self.reading.clone(),
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
        let (program, reading, budget) = (line.program, line.reading, line.budget);
        Ok(PartHeader { program, input, reading, budget })
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

    fn from_line(text: &str, ways: &Ways) -> Result<Row, String> {
        let line: RowLine = serde_json::from_str(text).map_err(|e| e.to_string())?;
        let source = ways.cell(line.source)?;
        let open = line.open.into_iter().map(|pair| pair.checked(source, ways));
        let row = Row {
            source,
            open: open.collect::<Result<_, String>>()?,
            undecided: line
                .undecided
                .into_iter()
                .map(|cell| ways.cell(cell))
                .collect::<Result<_, String>>()?,
            tally: Tally::default(),
        };
        let open: Vec<CellId> = row.open.iter().map(|pair| pair.target).collect();
        for (cells, what) in [(&open, "open"), (&row.undecided, "undecided")] {
            if let Some(pair) = cells.windows(2).find(|pair| pair[0] >= pair[1]) {
                let (before, after) = (pair[0].0, pair[1].0);
                return Err(format!(
                    "{what}: cell {after} after cell {before}, expected ascending cells"
                ));
            }
        }
        match row.undecided.iter().find(|cell| **cell == source || open.contains(cell)) {
            Some(cell) => Err(format!("undecided: cell {}, whose verdict is known", cell.0)),
            None => Ok(row),
        }
    }
}

impl OpenLine {
    /// The pair, if its portals lead from `source` to its target and its line is one.
    fn checked(self, source: CellId, ways: &Ways) -> Result<OpenPair, String> {
        let target = ways.cell(self.target)?;
        let mut cell = source;
        for &portal in &self.portals {
            cell = ways.across(portal, cell)?;
        }
        if self.portals.is_empty() || cell != target {
            return Err(format!(
                "the portals to cell {} lead to cell {}, or nowhere",
                target.0, cell.0
            ));
        }
        let [p, q] = self.line.map(|point| point.map(|text| Number::parse(&text)));
        let number = |parsed: Result<Number, _>| match parsed {
            Ok(number) => Ok(number.to_rational()),
            Err(error) => Err(format!("a coordinate is {error}")),
        };
        let [[px, py, pz], [qx, qy, qz]] = [p, q];
        let [p, q] =
            [[number(px)?, number(py)?, number(pz)?], [number(qx)?, number(qy)?, number(qz)?]];
        if p == q {
            return Err(format!("the line to cell {} has two equal points", target.0));
        }
        let line = Sightline::Rational(Box::new([p, q]));
        Ok(OpenPair { target, portals: self.portals, line })
    }
}

/// The cells of a graph, and the two that each portal of its input joins.
struct Ways {
    cells: u32,
    joined: Vec<Option<[CellId; 2]>>,
}

impl Ways {
    fn new(graph: &PortalGraph) -> Ways {
        let numbers = graph.portals.iter().map(|portal| portal.source as usize + 1).max();
        let mut joined = vec![None; numbers.unwrap_or(0)];
        for portal in &graph.portals {
            joined[portal.source as usize] = Some([portal.from, portal.to]);
        }
        Ways { cells: graph.cells.len() as u32, joined }
    }

    fn cell(&self, index: u32) -> Result<CellId, String> {
        let expected = || format!("cell {index}, expected one of the {} cells", self.cells);
        (index < self.cells).then_some(CellId(index)).ok_or_else(expected)
    }

    /// The cell on the other side of `portal` from `cell`.
    fn across(&self, portal: u32, cell: CellId) -> Result<CellId, String> {
        match self.joined.get(portal as usize).copied().flatten() {
            None => Err(format!("portal {portal}, expected one of the {}", self.joined.len())),
            Some([from, to]) if cell == from => Ok(to),
            Some([from, to]) if cell == to => Ok(from),
            Some([from, to]) => Err(format!(
                "portal {portal} is crossed from cell {}, but joins cells {} and {}",
                cell.0, from.0, to.0
            )),
        }
    }
}

impl Part {
    /// Reads a part of the rows of `graph`. Cells and portals are checked to exist and to join;
    /// whether a line stabs its portals is for a checker of witnesses to say.
    ///
    /// # Errors
    /// [`PartError`] names the line and what is wrong with it. A last line that is cut short is no
    /// error: its row was not finished.
    pub fn read(text: &str, graph: &PortalGraph) -> Result<Part, PartError> {
        let error = |line, what| PartError { line, what };
        let mut lines = text.split_inclusive('\n').filter(|line| line.ends_with('\n'));
        let header = lines.next().ok_or_else(|| error(1, "no header".to_owned()))?;
        let header = PartHeader::from_line(header).map_err(|what| error(1, what))?;
        let ways = Ways::new(graph);
        let rows = lines.enumerate().map(|(index, line)| {
            Row::from_line(line, &ways).map_err(|what| error(index + 2, what))
        });
        Ok(Part { header, rows: rows.collect::<Result<_, _>>()? })
    }
}
