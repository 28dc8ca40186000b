//! The result of a PVS computation, `stabline-pvs/1`.
//!
//! The text is canonical: equal results are equal bytes. Every number is exact, rows and
//! witnesses stand one a line in ascending order, and nothing depends on the machine. Writing
//! streams and is linear in the size of the text; reading is strict, so that what reads back is
//! what was written: unknown or missing fields, counts that differ from the rows, ratios that are
//! not in lowest terms and witnesses out of order are errors.

mod read;
#[cfg(test)]
mod tests;
mod wire;
mod write;

use super::Matrix;
use crate::formats::blake3;
use crate::num::Number;

pub use read::ReportError;

/// The name of the format, its first field.
pub const FORMAT: &str = "stabline-pvs/1";

/// The visibility of every ordered pair of cells, with witnesses.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PvsReport {
    /// The program and its version.
    pub program: String,
    /// Which input this is the result of.
    pub input: InputId,
    /// The options with which the input was read and divided, where they are not the default.
    pub reading: String,
    /// Whether the pairs that are not open were split into grazing and blocked.
    pub grazing_classified: bool,
    /// The names of the cells.
    pub cells: Vec<String>,
    /// The cell of each leaf of the input.
    pub leaf_to_cell: Vec<u32>,
    /// How many portals of the input were not planar and were triangulated.
    pub skew_portals: u32,
    /// The verdicts; as many cells as `cells`.
    pub matrix: Matrix,
    /// A sightline for each open pair with from < to, in ascending order, or none at all.
    pub witnesses: Vec<PairWitness>,
}

/// What identifies an input.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct InputId {
    /// The file's name, without folders.
    pub name: String,
    /// The BLAKE3 hash of its bytes, 64 hexadecimal digits in lower case.
    pub blake3: String,
}

/// A sightline from one cell to another.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PairWitness {
    /// The cell that it starts in.
    pub from: u32,
    /// The cell that it ends in, greater than `from`.
    pub to: u32,
    /// The portals that it crosses, in this order: indices into the input file's portals.
    pub portals: Vec<u32>,
    /// Two distinct points of it, in its direction, in world coordinates.
    pub line: WitnessLine,
}

/// Two points of a line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum WitnessLine {
    /// In the plane.
    Plane([[Number; 2]; 2]),
    /// In space.
    Space([[Number; 3]; 2]),
}

impl WitnessLine {
    /// The coordinates of the two points.
    pub fn points(&self) -> [&[Number]; 2] {
        match self {
            WitnessLine::Plane([p, q]) => [p, q],
            WitnessLine::Space([p, q]) => [p, q],
        }
    }

    /// The two points of a line in space.
    ///
    /// # Panics
    /// If it lies in the plane.
    pub fn in_space(&self) -> &[[Number; 3]; 2] {
        match self {
            WitnessLine::Plane(_) => panic!("a line of the plane"),
            WitnessLine::Space(points) => points,
        }
    }
}

impl InputId {
    /// Identifies the input of these bytes.
    pub fn new(name: &str, bytes: &[u8]) -> InputId {
        InputId { name: name.to_owned(), blake3: blake3::hex(bytes) }
    }
}

impl PvsReport {
    /// The name and version of this program, for [`PvsReport::program`].
    pub fn this_program() -> String {
        concat!("stabline ", env!("CARGO_PKG_VERSION")).to_owned()
    }

    /// The witness of the pair in either direction, as it is kept (from < to).
    pub fn witness(&self, a: usize, b: usize) -> Option<&PairWitness> {
        let pair = (a.min(b), a.max(b));
        let key = |witness: &PairWitness| (witness.from as usize, witness.to as usize);
        let found = self.witnesses.binary_search_by_key(&pair, key).ok()?;
        Some(&self.witnesses[found])
    }

    /// The JSON schema of the format.
    pub fn schema() -> serde_json::Value {
        schemars::schema_for!(wire::Report).to_value()
    }
}
