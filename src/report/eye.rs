//! What an eye sees, as canonical text and as `stabline-eye/1`.

use super::InputId;
use crate::num::{Int, Rational};
use num_traits::ToPrimitive;
use schemars::JsonSchema;
use serde::Serialize;

/// What an eye sees of a portal graph, or of a world.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(title = "stabline-eye/1")]
pub struct EyeReport {
    /// The name of the format.
    #[schemars(regex(pattern = "^stabline-eye/1$"))]
    format: &'static str,
    /// The input.
    pub input: EyeInput,
    /// Where the eye is, in world coordinates.
    pub eye: [Ratio; 3],
    /// How cells were ruled out: `exact`, `float`, `portals` or `flood`.
    pub cull: String,
    /// The names of the cells that the eye belongs to.
    pub eye_cells: Vec<String>,
    /// What the eye looks at; null for all around.
    pub frustum: Option<EyeFrustum>,
    /// How many portal sequences were found to be visible.
    pub sequences: u64,
    /// The cells reached, in their order.
    pub cells: Vec<EyeCell>,
    /// What is seen of the last portal of each sequence of a portal graph; only where it was asked
    /// for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub regions: Option<Vec<EyeRegion>>,
    /// What is seen of a world's cells; only where it was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub space: Option<EyeSpace>,
    /// The detail objects of a world that are seen, in their order; only where they were asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub objects: Option<Vec<EyeObject>>,
}

/// Which file the result is about.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct EyeInput {
    /// The file's name, without folders.
    name: String,
    /// The BLAKE3 hash of its bytes.
    #[schemars(regex(pattern = "^[0-9a-f]{64}$"))]
    blake3: String,
}

/// A view frustum, as it was used.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct EyeFrustum {
    /// The direction of view.
    pub look: [Ratio; 3],
    /// The direction that is up, not necessarily at a right angle to it.
    pub up: [Ratio; 3],
    /// The tangents of half the horizontal and half the vertical angle of view.
    pub half_tangents: [Ratio; 2],
    /// The normals of the right, lower, left and upper side, towards the inside.
    pub planes: [[Integer; 3]; 4],
    /// Whether it is wider than asked for, because an irrational length was rounded outward.
    pub widened: bool,
}

/// A cell that is reached.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct EyeCell {
    /// The cell's name.
    pub cell: String,
    /// The shortest sequence of portals to it: indices into the input's portals.
    pub portals: Vec<u32>,
    /// A direction strictly inside all of them and the frustum; null for culls but `exact`.
    pub direction: Option<[Integer; 3]>,
}

/// What is seen of the last portal of a sequence.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct EyeRegion {
    /// The cell behind it.
    pub cell: String,
    /// The sequence: indices into the input's portals.
    pub portals: Vec<u32>,
    /// A convex polygon, counter-clockwise as seen from the cell behind it.
    pub polygon: Vec<[Ratio; 3]>,
    /// The square of twice its area.
    pub doubled_area_squared: Ratio,
}

/// The seen space.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct EyeSpace {
    /// The sum of the volumes of all regions, which have no inner point in common.
    pub volume: Ratio,
    /// The eye's own cells in the frustum, then each sequence.
    pub regions: Vec<EyeSpaceRegion>,
}

/// What is seen of a cell through one sequence: a convex polyhedron.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct EyeSpaceRegion {
    /// The cell.
    pub cell: String,
    /// The sequence: indices into the world's portals; empty for the eye's own cell.
    pub portals: Vec<u32>,
    /// The volume.
    pub volume: Ratio,
    /// The vertices.
    pub vertices: Vec<[Ratio; 3]>,
    /// Each face's vertices by index, counter-clockwise as seen from outside.
    pub faces: Vec<Vec<u32>>,
}

/// A detail object that is seen.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct EyeObject {
    /// Its index in the world.
    pub object: u32,
    /// What the input calls it.
    pub name: String,
    /// Its line in the file, where that is known.
    pub line: Option<u32>,
    /// A cell in which it is seen.
    pub cell: String,
    /// The sequence through which it is seen there.
    pub portals: Vec<u32>,
    /// A point of the inside of its box that the eye sees.
    pub point: [Ratio; 3],
}

/// A rational number `p` or `p/q` in lowest terms with q > 1.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(transparent)]
#[schemars(rename = "Ratio")]
pub struct Ratio(#[schemars(regex(pattern = "^-?[0-9]+(/[1-9][0-9]*)?$"))] pub(super) String);

/// An integer: as a string where it does not fit in 53 bits.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(untagged)]
#[schemars(rename = "Integer")]
pub enum Integer {
    /// At most 53 bits.
    Small(i64),
    /// More than that.
    Large(#[schemars(regex(pattern = "^-?[0-9]+$"))] String),
}

impl Ratio {
    /// The number 1.
    pub(super) fn one() -> Ratio {
        Ratio("1".to_owned())
    }
}

impl From<&Rational> for Ratio {
    fn from(value: &Rational) -> Ratio {
        Ratio(value.to_string())
    }
}

impl std::fmt::Display for Ratio {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.0.fmt(f)
    }
}

impl From<&Int> for Integer {
    fn from(value: &Int) -> Integer {
        match value.to_i64() {
            Some(small) if small.unsigned_abs() < 1 << 53 => Integer::Small(small),
            Some(_) | None => Integer::Large(value.to_string()),
        }
    }
}

impl From<InputId> for EyeInput {
    fn from(InputId { name, blake3 }: InputId) -> EyeInput {
        EyeInput { name, blake3 }
    }
}

impl std::fmt::Display for Integer {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Integer::Small(value) => value.fmt(f),
            Integer::Large(value) => value.fmt(f),
        }
    }
}

impl EyeReport {
    /// The name of the format, its first field.
    pub const FORMAT: &'static str = "stabline-eye/1";

    /// A report that reaches nothing yet.
    pub fn new(input: InputId, eye: [Ratio; 3], cull: &str) -> EyeReport {
        EyeReport {
            format: EyeReport::FORMAT,
            input: input.into(),
            eye,
            cull: cull.to_owned(),
            eye_cells: Vec::new(),
            frustum: None,
            sequences: 0,
            cells: Vec::new(),
            regions: None,
            space: None,
            objects: None,
        }
    }

    /// As JSON.
    pub fn to_json(&self) -> String {
        format!("{:#}\n", serde_json::json!(self))
    }

    /// As canonical text, one fact a line.
    pub fn to_text(&self) -> String {
        let mut text = format!("eye {} in {}\n", tuple(&self.eye), self.eye_cells.join(", "));
        if let Some(frustum) = &self.frustum {
            let [h, v] = &frustum.half_tangents;
            let widened = if frustum.widened { ", rounded outward" } else { "" };
            let (look, up) = (tuple(&frustum.look), tuple(&frustum.up));
            text.push_str(&format!(
                "frustum look {look}, up {up}, half-tangents {} {}{widened}\n",
                h.0, v.0
            ));
        }
        let count = self.cells.len();
        text.push_str(&format!("{}: {count} cells, {} sequences\n", self.cull, self.sequences));
        for EyeCell { cell, portals, direction } in &self.cells {
            text.push_str(cell);
            text.push_str(&through(portals));
            if let Some([x, y, z]) = direction {
                text.push_str(&format!(" towards ({x} {y} {z})"));
            }
            text.push('\n');
        }
        for region in self.regions.iter().flatten() {
            let polygon: Vec<String> = region.polygon.iter().map(tuple).collect();
            text.push_str(&format!(
                "region of {} through {}: {}, (2 area)² = {}\n",
                region.cell,
                list(&region.portals),
                polygon.join(" "),
                region.doubled_area_squared.0
            ));
        }
        text.extend(self.space.iter().map(EyeSpace::to_text));
        if let Some(objects) = &self.objects {
            text.push_str(&format!("{} objects\n", objects.len()));
            text.extend(objects.iter().map(EyeObject::to_text));
        }
        text
    }

    /// The JSON schema of the format.
    pub fn schema() -> serde_json::Value {
        schemars::schema_for!(EyeReport).to_value()
    }
}

impl EyeSpace {
    fn to_text(&self) -> String {
        let mut text = format!("seen volume {}\n", self.volume.0);
        for region in &self.regions {
            let vertices: Vec<String> = region.vertices.iter().map(tuple).collect();
            let faces: Vec<String> = region.faces.iter().map(|face| list(face)).collect();
            text.push_str(&format!(
                "region of {}{}: volume {}\n  vertices {}\n  faces {}\n",
                region.cell,
                through(&region.portals),
                region.volume.0,
                vertices.join(" "),
                faces.join(", ")
            ));
        }
        text
    }
}

impl EyeObject {
    fn to_text(&self) -> String {
        let line = self.line.map(|line| format!(" of line {line}")).unwrap_or_default();
        format!(
            "object {} `{}`{line} in {}{}: {}\n",
            self.object,
            self.name.escape_debug(),
            self.cell,
            through(&self.portals),
            tuple(&self.point)
        )
    }
}

/// ` through 1 2`, or nothing for no portals.
pub(super) fn through(portals: &[u32]) -> String {
    if portals.is_empty() { String::new() } else { format!(" through {}", list(portals)) }
}

fn list(portals: &[u32]) -> String {
    portals.iter().map(u32::to_string).collect::<Vec<_>>().join(" ")
}

/// A point as canonical text shows it.
pub(super) fn tuple([x, y, z]: &[Ratio; 3]) -> String {
    format!("({} {} {})", x.0, y.0, z.0)
}
