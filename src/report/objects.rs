//! Which cells see which objects, as `stabline-objects/1`.

use super::{PvsReport, Verdict};
use crate::geom::AxialBox;
use crate::num::{Number, Rational};
use schemars::JsonSchema;
use serde::Serialize;
use std::io::{self, Write};

/// The name of the format, its first field.
const FORMAT: &str = "stabline-objects/1";

/// The visibility of every object from every cell.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(title = "stabline-objects/1")]
pub struct ObjectsReport {
    /// The name of the format.
    #[schemars(regex(pattern = "^stabline-objects/1$"))]
    format: &'static str,
    /// The program and its version.
    program: String,
    /// The input.
    input: ObjectsInput,
    /// The options that change the result.
    options: ObjectsOptions,
    /// The names of the cells; cell i is the one at index i.
    cells: Vec<String>,
    /// The objects.
    objects: Vec<ObjectEntry>,
    /// How many pairs of an object and a cell have each verdict.
    counts: ObjectsCounts,
    /// One string an object, one digit a cell: 0 the cell does not see the object, 2 it does,
    /// 3 undecided.
    #[schemars(inner(regex(pattern = "^[023]*$")))]
    rows: Vec<String>,
    /// For each pair that is seen, unless a part of the object is in the cell, a line that proves
    /// it, in ascending order of objects, then of cells; or none at all.
    witnesses: Vec<ObjectWitness>,
}

/// What identifies the input.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
struct ObjectsInput {
    /// The file's name, without folders.
    name: String,
    /// The BLAKE3 hash of the file's bytes.
    #[schemars(regex(pattern = "^[0-9a-f]{64}$"))]
    blake3: String,
}

/// The options that change the result.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
struct ObjectsOptions {
    /// `exact`, or `conservative`: what the upper bound rules out is 0, the rest is 3.
    #[schemars(regex(pattern = "^(exact|conservative)$"))]
    method: &'static str,
}

/// An object.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct ObjectEntry {
    /// What the input calls it.
    name: String,
    /// The line of the input that states it, counted from 1; null where that is not known.
    line: Option<usize>,
    /// The corner of its box with the least coordinates, in world units.
    #[schemars(with = "Point")]
    low: Vec<Ratio>,
    /// The corner of its box with the greatest coordinates.
    #[schemars(with = "Point")]
    high: Vec<Ratio>,
    /// In the plane, where an object is a convex polygon: its corners, counter-clockwise.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Vec<[Ratio; 2]>", default)]
    polygon: Option<Vec<[Ratio; 2]>>,
    /// The cells that a part of it is in, ascending; none for an object in solids or outside.
    cells: Vec<u32>,
}

/// How many pairs of an object and a cell have each verdict.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, JsonSchema)]
pub struct ObjectsCounts {
    /// Pairs that are seen.
    pub seen: u64,
    /// Of these, the pairs of an object and a cell that a part of it is in.
    pub inside: u64,
    /// Pairs that are not seen.
    pub not_seen: u64,
    /// Pairs that are undecided.
    pub undecided: u64,
    /// Objects that are in no cell.
    pub nowhere: u64,
}

/// A line by which a cell sees an object.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct ObjectWitness {
    /// The object.
    pub object: u32,
    /// The cell that the line starts in.
    pub cell: u32,
    /// The portals that it crosses, in this order: indices into the portals between the cells.
    pub portals: Vec<u32>,
    /// Two distinct points of it, in its direction: ratios in lowest terms.
    #[schemars(with = "Line")]
    line: [Vec<Ratio>; 2],
}

/// A point of space or of the plane.
#[derive(JsonSchema)]
#[schemars(untagged, inline)]
#[expect(dead_code, reason = "only its schema is used")]
enum Point {
    /// In space.
    Space([Ratio; 3]),
    /// In the plane, for floorplans.
    Plane([Ratio; 2]),
}

/// Two points.
#[derive(JsonSchema)]
#[schemars(untagged, inline)]
#[expect(dead_code, reason = "only its schema is used")]
enum Line {
    /// In space.
    Space([[Ratio; 3]; 2]),
    /// In the plane, for floorplans.
    Plane([[Ratio; 2]; 2]),
}

/// An integer `p` or a ratio `p/q` in lowest terms, q > 1.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(inline)]
struct Ratio(#[schemars(regex(pattern = "^-?[0-9]+(/[1-9][0-9]*)?$"))] String);

/// The coordinates of a point as they are written.
fn ratios<T: ToString>(point: &[T]) -> Vec<Ratio> {
    point.iter().map(|c| Ratio(c.to_string())).collect()
}

impl ObjectEntry {
    /// The object of a name, a line and a box, with the cells that it is in.
    pub fn new(name: &str, line: Option<usize>, bounds: &AxialBox, cells: Vec<u32>) -> ObjectEntry {
        let (low, high) = (ratios(&bounds.low), ratios(&bounds.high));
        ObjectEntry { name: name.to_owned(), line, low, high, polygon: None, cells }
    }

    /// The object of a name and a convex polygon of the plane, in world units, with the cells that
    /// it is in.
    pub fn of_plan(name: &str, polygon: &[[Rational; 2]], cells: Vec<u32>) -> ObjectEntry {
        let along = |axis: usize| polygon.iter().map(move |corner| &corner[axis]);
        let low =
            [0, 1].map(|axis| along(axis).min().map_or_else(String::new, Rational::to_string));
        let high =
            [0, 1].map(|axis| along(axis).max().map_or_else(String::new, Rational::to_string));
        let corner = |corner: &[Rational; 2]| corner.each_ref().map(|c| Ratio(c.to_string()));
        ObjectEntry {
            name: name.to_owned(),
            line: None,
            low: ratios(&low),
            high: ratios(&high),
            polygon: Some(polygon.iter().map(corner).collect()),
            cells,
        }
    }
}

impl ObjectWitness {
    /// The witness of a pair, by two points of space or of the plane.
    pub fn new<const AXES: usize>(
        object: u32,
        cell: u32,
        portals: Vec<u32>,
        line: &[[Number; AXES]; 2],
    ) -> ObjectWitness {
        let line = line.each_ref().map(|point| ratios(point));
        ObjectWitness { object, cell, portals, line }
    }
}

impl ObjectsReport {
    /// A result that goes with one of cells; `rows` has a row of verdicts for each object.
    pub fn new(
        cells: &PvsReport,
        method: &'static str,
        objects: Vec<ObjectEntry>,
        rows: &[Vec<Verdict>],
        witnesses: Vec<ObjectWitness>,
    ) -> ObjectsReport {
        let digits = |row: &Vec<Verdict>| row.iter().map(|&v| char::from(b'0' + v as u8)).collect();
        let count =
            |verdict: Verdict| rows.iter().flatten().filter(|v| **v == verdict).count() as u64;
        ObjectsReport {
            format: FORMAT,
            program: cells.program.clone(),
            input: ObjectsInput {
                name: cells.input.name.clone(),
                blake3: cells.input.blake3.clone(),
            },
            options: ObjectsOptions { method },
            cells: cells.cells.clone(),
            counts: ObjectsCounts {
                seen: count(Verdict::Open),
                inside: objects.iter().map(|object| object.cells.len() as u64).sum(),
                not_seen: count(Verdict::NotOpen) + count(Verdict::Grazing),
                undecided: count(Verdict::Undecided),
                nowhere: objects.iter().filter(|object| object.cells.is_empty()).count() as u64,
            },
            objects,
            rows: rows.iter().map(digits).collect(),
            witnesses,
        }
    }

    /// How many pairs have each verdict.
    pub fn counts(&self) -> &ObjectsCounts {
        &self.counts
    }

    /// The number of objects.
    pub fn objects(&self) -> usize {
        self.objects.len()
    }

    /// Writes the canonical text: objects, rows and witnesses stand one a line.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        let text = |value: serde_json::Result<String>| value.map_err(io::Error::from);
        writeln!(out, "{{\"format\": {},", text(serde_json::to_string(self.format))?)?;
        writeln!(out, "\"program\": {},", text(serde_json::to_string(&self.program))?)?;
        writeln!(out, "\"input\": {},", text(serde_json::to_string(&self.input))?)?;
        writeln!(out, "\"options\": {},", text(serde_json::to_string(&self.options))?)?;
        writeln!(out, "\"cells\": {},", text(serde_json::to_string(&self.cells))?)?;
        write!(out, "\"objects\": [")?;
        write_lines(out, &self.objects)?;
        writeln!(out, "],\n\"counts\": {},", text(serde_json::to_string(&self.counts))?)?;
        write!(out, "\"rows\": [")?;
        write_lines(out, &self.rows)?;
        write!(out, "],\n\"witnesses\": [")?;
        write_lines(out, &self.witnesses)?;
        writeln!(out, "]}}")
    }

    /// The JSON schema of the format.
    pub fn schema() -> serde_json::Value {
        schemars::schema_for!(ObjectsReport).to_value()
    }
}

/// Items of a list, one a line.
fn write_lines(out: &mut dyn Write, items: &[impl Serialize]) -> io::Result<()> {
    for (index, item) in items.iter().enumerate() {
        write!(out, "{}\n{}", if index == 0 { "" } else { "," }, serde_json::to_string(item)?)?;
    }
    Ok(())
}
