//! The strict reader.

use super::{FORMAT, InputId, PairWitness, PvsReport, WitnessLine, wire};
use crate::num::Number;
use crate::report::{Matrix, Verdict};

/// Why a text is not a `stabline-pvs/1` result.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ReportError {
    /// Not JSON, or not of the format's fields and types.
    #[error("line {line}, column {column}: {what}")]
    Json {
        /// The line, counted from 1.
        line: usize,
        /// The column, counted from 1.
        column: usize,
        /// What the JSON reader says.
        what: String,
    },
    /// The first field names another format.
    #[error("format: expected `{FORMAT}`, got `{0}`")]
    Format(String),
    /// A field that contradicts another, or a value out of range.
    #[error("{place}: {what}")]
    Rule {
        /// The field, such as `rows[3]`.
        place: String,
        /// The rule broken, what was expected, and what was found.
        what: String,
    },
}

impl ReportError {
    fn rule(place: impl Into<String>, what: impl Into<String>) -> ReportError {
        ReportError::Rule { place: place.into(), what: what.into() }
    }

    /// The message without the line, for whoever names it already.
    pub fn without_line(&self) -> String {
        match self {
            ReportError::Json { column, what, .. } => format!("column {column}: {what}"),
            ReportError::Format(_) | ReportError::Rule { .. } => self.to_string(),
        }
    }

    /// The line of the file, where there is one.
    pub fn line(&self) -> Option<usize> {
        match self {
            ReportError::Json { line, .. } => Some(*line),
            ReportError::Format(_) | ReportError::Rule { .. } => None,
        }
    }
}

impl PvsReport {
    /// Reads a result, strictly.
    ///
    /// # Errors
    /// [`ReportError`] names the place and the rule broken.
    pub fn read(bytes: &[u8]) -> Result<PvsReport, ReportError> {
        if bytes.is_empty() {
            return Err(ReportError::rule("file", format!("empty, expected {FORMAT}")));
        }
        let report: wire::Report = serde_json::from_slice(bytes).map_err(|error| {
            let what = error.to_string();
            // serde_json ends its message with the place, which is said before it here.
            let what = what.split(" at line ").next().unwrap_or_default().to_owned();
            ReportError::Json { line: error.line(), column: error.column(), what }
        })?;
        if report.format != FORMAT {
            return Err(ReportError::Format(report.format));
        }
        let is_hash = |c: char| c.is_ascii_digit() || ('a'..='f').contains(&c);
        if report.input.blake3.len() != 64 || !report.input.blake3.chars().all(is_hash) {
            let what = "expected 64 hexadecimal digits in lower case";
            return Err(ReportError::rule("input.blake3", what));
        }
        let cells = report.cells.len();
        let stray = |&(_, cell): &(usize, &u32)| *cell as usize >= cells;
        if let Some((leaf, cell)) = report.leaf_to_cell.iter().enumerate().find(stray) {
            let what = format!("names cell {cell}, but there are {cells} cells, counted from 0");
            return Err(ReportError::rule(format!("leaf_to_cell[{leaf}]"), what));
        }
        let matrix = read_rows(&report.rows, cells, report.options.grazing)?;
        check_counts(&report.counts, &matrix, report.options.grazing)?;
        Ok(PvsReport {
            program: report.program,
            input: InputId { name: report.input.name, blake3: report.input.blake3 },
            reading: report.options.reading,
            grazing_classified: report.options.grazing,
            cells: report.cells,
            leaf_to_cell: report.leaf_to_cell,
            skew_portals: report.skew_portals,
            witnesses: read_witnesses(report.witnesses, &matrix)?,
            matrix,
        })
    }
}

fn read_rows(rows: &[&str], cells: usize, grazing: bool) -> Result<Matrix, ReportError> {
    if rows.len() != cells {
        let what = format!("expected one row for each of {cells} cells, got {}", rows.len());
        return Err(ReportError::rule("rows", what));
    }
    let mut entries = Vec::with_capacity(rows.iter().map(|row| row.len()).sum());
    for (from, row) in rows.iter().enumerate() {
        let place = || format!("rows[{from}]");
        if row.len() != cells {
            let what = format!("expected {cells} digits, got {}", row.len());
            return Err(ReportError::rule(place(), what));
        }
        for digit in row.bytes() {
            match digit.checked_sub(b'0').and_then(Verdict::from_code) {
                Some(Verdict::Grazing) if !grazing => {
                    let what = "a grazing pair, though grazing was not classified";
                    return Err(ReportError::rule(place(), what));
                }
                Some(verdict) => entries.push(verdict),
                None => return Err(ReportError::rule(place(), "expected digits 0 to 3")),
            }
        }
    }
    let count = entries.len();
    Matrix::from_entries(cells, entries)
        .ok_or_else(|| ReportError::rule("rows", format!("{count} digits in {cells} rows")))
}

fn check_counts(stated: &wire::Counts, matrix: &Matrix, grazing: bool) -> Result<(), ReportError> {
    let found = matrix.counts();
    let classified = |count: u64| grazing.then_some(count);
    let pairs = [
        ("counts.open", Some(stated.open), Some(found.open)),
        ("counts.grazing", stated.grazing, classified(found.grazing)),
        ("counts.blocked", stated.blocked, classified(found.not_open)),
        ("counts.undecided", Some(stated.undecided), Some(found.undecided)),
    ];
    let text = |count: Option<u64>| count.map_or("null".to_owned(), |count| count.to_string());
    for (place, stated, found) in pairs {
        if stated != found {
            let what = format!("states {}, but the rows have {}", text(stated), text(found));
            return Err(ReportError::rule(place, what));
        }
    }
    if !stated.diagonal_included {
        return Err(ReportError::rule("counts.diagonal_included", "expected true"));
    }
    Ok(())
}

fn read_witnesses(
    stated: Vec<wire::Witness<'_>>,
    matrix: &Matrix,
) -> Result<Vec<PairWitness>, ReportError> {
    let mut witnesses: Vec<PairWitness> = Vec::with_capacity(stated.len());
    for (index, wire::Witness { from, to, portals, line }) in stated.into_iter().enumerate() {
        let error = |what: String| Err(ReportError::rule(format!("witnesses[{index}]"), what));
        if from >= to || to as usize >= matrix.size() {
            let cells = matrix.size();
            return error(format!("expected from < to < {cells}, got {from} and {to}"));
        }
        if matrix.get(from as usize, to as usize) != Verdict::Open {
            return error(format!("the pair {from}, {to} is not open"));
        }
        if witnesses.last().is_some_and(|last| (last.from, last.to) >= (from, to)) {
            return error(format!("the pair {from}, {to} is out of ascending order"));
        }
        let mut numbers = Vec::with_capacity(6);
        for text in line.iter().flatten() {
            match Number::parse(text) {
                Ok(parsed) if is_spelled(&parsed, text) => numbers.push(parsed),
                Ok(parsed) => return error(format!("`{text}` is not in lowest terms: `{parsed}`")),
                Err(what) => return error(format!("`{text}`: {what}")),
            }
        }
        let (first, second) = numbers.split_at(numbers.len() / 2);
        if first == second || line[0].len() != line[1].len() {
            return error("expected two distinct points".to_owned());
        }
        let line = match <[Number; 6]>::try_from(numbers) {
            Ok([a, b, c, d, e, f]) => WitnessLine::Space([[a, b, c], [d, e, f]]),
            Err(numbers) => match <[Number; 4]>::try_from(numbers) {
                Ok([a, b, c, d]) => WitnessLine::Plane([[a, b], [c, d]]),
                Err(_) => return error("expected points of two or three coordinates".to_owned()),
            },
        };
        // Sectors of a Doom level may share a leaf; cells of space share nothing.
        if portals.is_empty() && matches!(line, WitnessLine::Space(_)) {
            return error("expected one portal or more".to_owned());
        }
        witnesses.push(PairWitness { from, to, portals, line });
    }
    Ok(witnesses)
}

/// Whether `text` is the canonical spelling of `number`, which it was read as.
fn is_spelled(number: &Number, text: &str) -> bool {
    // An integer that parses has its one spelling if it has no superfluous sign or digit.
    let is_integer = |text: &str, expected: i64| {
        let digits = expected.unsigned_abs().checked_ilog10().map_or(1, |log| log as usize + 1);
        text.len() == digits + usize::from(expected < 0) && text.parse() == Ok(expected)
    };
    match number {
        Number::Small(numerator, 1) => is_integer(text, *numerator),
        Number::Small(numerator, denominator) => text
            .split_once('/')
            .is_some_and(|(p, q)| is_integer(p, *numerator) && is_integer(q, *denominator)),
        Number::Big(ratio) => text == ratio.to_string(),
    }
}
