//! The cells of a floorplan, `stabline-plan/1`.

use super::InputId;
use schemars::JsonSchema;
use serde::Serialize;
use std::io::{self, Write};

/// What a floorplan comes to.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(title = "stabline-plan/1")]
pub struct PlanReport {
    /// The name of the format.
    #[schemars(regex(pattern = "^stabline-plan/1$"))]
    pub format: &'static str,
    /// The input's name, without folders.
    pub input: String,
    /// The BLAKE3 hash of the input's bytes.
    #[schemars(regex(pattern = "^[0-9a-f]{64}$"))]
    pub blake3: String,
    /// The options with which the plan was divided, where they are not the default.
    pub reading: String,
    /// Segments of positive length, those that only split cells included.
    pub segments: usize,
    /// Segments without length, left out.
    pub zero_length: Vec<u32>,
    /// Pairs of segments that share more than a point, by their numbers in the input.
    pub overlapping: Vec<[u32; 2]>,
    /// Pairs of segments that cross.
    pub crossing: Vec<PlanCrossing>,
    /// Segments that are left inside of cells, where they do not occlude: none but for a k-D tree
    /// with a threshold.
    pub left_inside: Vec<u32>,
    /// Leaves of the tree.
    pub leaves: usize,
    /// The length of the longest way from the tree's top to a leaf.
    pub depth: usize,
    /// The cells, by ascending number.
    pub cells: Vec<PlanCell>,
    /// The portals, by ascending number.
    pub portals: Vec<PlanCellPortal>,
}

/// A point in world units: integers, or ratios in lowest terms.
pub type PlanPosition = [String; 2];

/// Two segments that cross, and are split there.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct PlanCrossing {
    /// Their numbers in the input.
    pub segments: [u32; 2],
    /// Where.
    pub at: PlanPosition,
}

/// A cell.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct PlanCell {
    /// Its name.
    pub name: String,
    /// Its corners, counter-clockwise.
    pub polygon: Vec<PlanPosition>,
    /// The portals on its boundary, counter-clockwise.
    pub portals: Vec<u32>,
}

/// A portal.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct PlanCellPortal {
    /// The cell that a line leaves which has the first end on its left.
    pub from: u32,
    /// The cell that it enters.
    pub to: u32,
    /// The end on the left, and the one on the right.
    pub segment: [PlanPosition; 2],
}

impl PlanReport {
    /// The name of the format.
    pub const FORMAT: &'static str = "stabline-plan/1";

    /// A report without its contents.
    pub fn of(input: InputId) -> PlanReport {
        PlanReport {
            format: PlanReport::FORMAT,
            input: input.name,
            blake3: input.blake3,
            reading: String::new(),
            segments: 0,
            zero_length: Vec::new(),
            overlapping: Vec::new(),
            crossing: Vec::new(),
            left_inside: Vec::new(),
            leaves: 0,
            depth: 0,
            cells: Vec::new(),
            portals: Vec::new(),
        }
    }

    /// A few lines of text.
    pub fn to_text(&self) -> String {
        let odd = self.zero_length.len() + self.overlapping.len() + self.crossing.len();
        let mut text = format!(
            "{}: {} segments; {odd} oddities: {} of zero length, {} pairs overlap, {} pairs cross\n\
             {} leaves of the tree, depth {}\n{} cells, {} portals between them\n",
            self.input,
            self.segments,
            self.zero_length.len(),
            self.overlapping.len(),
            self.crossing.len(),
            self.leaves,
            self.depth,
            self.cells.len(),
            self.portals.len(),
        );
        if !self.left_inside.is_empty() {
            text += &format!("{} segments are left inside of cells\n", self.left_inside.len());
        }
        text
    }

    /// Writes the report as JSON.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        serde_json::to_writer(&mut *out, self)?;
        out.write_all(b"\n")
    }

    /// The JSON schema of the format.
    pub fn schema() -> serde_json::Value {
        schemars::schema_for!(PlanReport).to_value()
    }
}
