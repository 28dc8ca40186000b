//! The fields of `stabline-pvs/1` as they stand in the file: what serde reads and what the schema
//! is made of, so that the two cannot differ.

use schemars::JsonSchema;
use serde::Deserialize;

/// Cell-to-cell visibility of one input.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "stabline-pvs/1")]
pub(super) struct Report<'a> {
    /// The name of the format.
    #[schemars(regex(pattern = "^stabline-pvs/1$"))]
    pub format: String,
    /// The program and its version.
    pub program: String,
    /// Which input this is the result of.
    pub input: Input,
    /// The options that change the result.
    pub options: Options,
    /// The names of the cells; cell i is the one at index i.
    pub cells: Vec<String>,
    /// The cell of each leaf of the input.
    pub leaf_to_cell: Vec<u32>,
    /// How many portals of the input were not planar and were triangulated.
    pub skew_portals: u32,
    /// How many ordered pairs have each verdict.
    pub counts: Counts,
    /// One string a source cell, one digit a target cell: 0 not open (blocked, where grazing was
    /// classified), 1 grazing, 2 open, 3 undecided.
    #[schemars(inner(regex(pattern = "^[0-3]*$")))]
    #[serde(borrow)]
    pub rows: Vec<&'a str>,
    /// A sightline for each open pair with from < to in ascending order, or none at all.
    #[serde(borrow)]
    pub witnesses: Vec<Witness<'a>>,
}

/// What identifies the input.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct Input {
    /// The file's name, without folders.
    pub name: String,
    /// The BLAKE3 hash of the file's bytes.
    #[schemars(regex(pattern = "^[0-9a-f]{64}$"))]
    pub blake3: String,
}

/// The options that change the result.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct Options {
    /// Whether pairs that are not open were split into grazing and blocked.
    pub grazing: bool,
    /// The options with which the input was read and divided into cells, where they are not the
    /// default; with `--portals hull` open pairs are an upper bound.
    #[serde(default)]
    pub reading: String,
}

/// How many ordered pairs have each verdict.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct Counts {
    /// Open pairs.
    pub open: u64,
    /// Grazing pairs; null where grazing was not classified.
    #[serde(deserialize_with = "required")]
    #[schemars(required)]
    pub grazing: Option<u64>,
    /// Blocked pairs; null where grazing was not classified.
    #[serde(deserialize_with = "required")]
    #[schemars(required)]
    pub blocked: Option<u64>,
    /// Pairs that a budget left undecided.
    pub undecided: u64,
    /// That the pairs of a cell with itself are counted, which are open: always true.
    pub diagonal_included: bool,
}

/// A sightline between two cells.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct Witness<'a> {
    /// The cell that it starts in.
    pub from: u32,
    /// The cell that it ends in, greater than `from`.
    pub to: u32,
    /// The portals that it crosses, in this order: indices into the input file's portals.
    pub portals: Vec<u32>,
    /// Two distinct points of it in its direction, in world coordinates: ratios in lowest terms.
    #[schemars(with = "Line")]
    #[serde(borrow)]
    pub line: [Vec<&'a str>; 2],
}

/// Two points, of space or of the plane.
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
#[derive(JsonSchema)]
#[schemars(transparent, inline)]
#[expect(dead_code, reason = "only its schema is used")]
struct Ratio(#[schemars(regex(pattern = "^-?[0-9]+(/[1-9][0-9]*)?$"))] String);

/// Reads an `Option` that must be stated: a missing field is not a null.
fn required<'de, D: serde::Deserializer<'de>>(from: D) -> Result<Option<u64>, D::Error> {
    Option::deserialize(from)
}
