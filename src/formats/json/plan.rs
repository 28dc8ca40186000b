//! JSON scenes of two dimensions: floorplans, and graphs of cells joined by segments.

use super::{Coordinate, Grid, SceneFileError};
use schemars::JsonSchema;

/// A point of the plane in world units.
pub type PlanePoint = [Coordinate; 2];

/// A floorplan: what stands in the plane.
#[derive(Clone, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "Floorplan")]
pub struct PlanFile {
    /// The point of the scene: what is special about it, and what must come out.
    pub about: String,
    /// The name of the format.
    #[schemars(regex(pattern = "^stabline-scene/1$"))]
    pub format: String,
    /// Grid units in one world unit. Where it is given, every coordinate must be a multiple of the
    /// unit.
    #[serde(default)]
    pub grid: Option<Grid>,
    /// The box to be divided, by its corners of least and of greatest coordinates; otherwise the
    /// one around all segments.
    #[serde(default)]
    pub view: Option<[PlanePoint; 2]>,
    /// Segments that occlude, each by its ends.
    pub segments: Vec<[PlanePoint; 2]>,
    /// Segments that split cells and are otherwise nothing.
    #[serde(default)]
    pub hints: Vec<[PlanePoint; 2]>,
    /// What may be seen and does not occlude.
    #[serde(default)]
    pub objects: Vec<PlanFileObject>,
    /// Points that mark the inside: only what can be reached from them is asked about. Without the
    /// field everything in the box is.
    #[serde(default)]
    pub inside: Option<Vec<PlanePoint>>,
}

/// A convex region, or a detail object.
#[derive(Clone, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "FloorplanObject")]
pub struct PlanFileObject {
    /// What it is called, if it is.
    #[serde(default)]
    pub name: Option<String>,
    /// Three or more corners of a convex polygon in order, either way around.
    pub polygon: Vec<PlanePoint>,
}

/// A graph of cells of the plane.
#[derive(Clone, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "PlanePortalGraph")]
pub struct PlanGraphFile {
    /// The point of the scene: what is special about it, and what must come out.
    pub about: String,
    /// The name of the format.
    #[schemars(regex(pattern = "^stabline-scene/1$"))]
    pub format: String,
    /// Grid units in one world unit, as in a floorplan.
    #[serde(default)]
    pub grid: Option<Grid>,
    /// The names of the cells, each once.
    pub cells: Vec<String>,
    /// The portals.
    pub portals: Vec<PlanFilePortal>,
}

/// A segment between two cells.
#[derive(Clone, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "PlanePortal")]
pub struct PlanFilePortal {
    /// The cell that a line leaves.
    pub from: String,
    /// The cell that it enters.
    pub to: String,
    /// The end on such a line's left, and the one on its right.
    pub segment: [PlanePoint; 2],
}

impl PlanFile {
    /// Reads a floorplan.
    ///
    /// # Errors
    /// [`SceneFileError`] names the line and the rule broken.
    pub fn read(bytes: &[u8]) -> Result<PlanFile, SceneFileError> {
        let file: PlanFile = super::parse(bytes)?;
        super::check_format(&file.format)?;
        Ok(file)
    }
}

impl PlanGraphFile {
    /// Reads a graph.
    ///
    /// # Errors
    /// [`SceneFileError`] names the line and the rule broken.
    pub fn read(bytes: &[u8]) -> Result<PlanGraphFile, SceneFileError> {
        let file: PlanGraphFile = super::parse(bytes)?;
        super::check_format(&file.format)?;
        Ok(file)
    }

    /// Whether the text of a field `portals` states segments: whether `"segment"` is the name of a
    /// field in it.
    pub(super) fn states_segments(portals: &str) -> bool {
        let name = "\"segment\"";
        let after = portals.match_indices(name).map(|(at, _)| &portals[at + name.len()..]);
        after.into_iter().any(|rest| rest.trim_ascii_start().starts_with(':'))
    }
}
