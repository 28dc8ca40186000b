//! What eyes see of a floorplan, as canonical text and as `stabline-eye-plan/1`.

use super::InputId;
use super::eye::{EyeInput, Integer, Ratio, through};
use schemars::JsonSchema;
use serde::Serialize;

/// What an eye sees of a floorplan, from one point or from each of a path.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(title = "stabline-eye-plan/1")]
pub struct EyePlanReport {
    /// The name of the format.
    #[schemars(regex(pattern = "^stabline-eye-plan/1$"))]
    format: &'static str,
    /// The input.
    pub input: EyeInput,
    /// How cells were ruled out: `none`, `disjoint`, `component`, `portals` or `exact`.
    pub cull: String,
    /// What the eye looks at; null for all around.
    pub cone: Option<EyeCone>,
    /// The area of all cells, in square world units.
    pub area: Ratio,
    /// Each point, in the order of the path.
    pub views: Vec<EyePlanView>,
}

/// A view cone, as it was used.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct EyeCone {
    /// The direction of view.
    pub look: [Ratio; 2],
    /// The tangent of half the angle of view.
    pub half_tangent: Ratio,
    /// The directions of its right and of its left side.
    pub sides: [[Integer; 2]; 2],
}

/// What is seen from one point.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct EyePlanView {
    /// Where the eye is, in world coordinates.
    pub eye: [Ratio; 2],
    /// The cell whose half-open extent holds it.
    pub cell: String,
    /// The cells whose closed polygons hold it.
    pub around: Vec<String>,
    /// How it came here; only on a path.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub step: Option<EyePlanStep>,
    /// The cells that the cull leaves, in their order.
    pub cells: Vec<EyePlanCell>,
    /// Their area.
    pub cells_area: Ratio,
    /// What is seen; null for culls but `exact`.
    pub seen: Option<EyePlanSeen>,
}

/// A step of a path.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct EyePlanStep {
    /// Through how many portals the straight way led; null where the cell had to be located anew.
    pub portals: Option<u32>,
    /// Cells that came into view.
    pub entered: Vec<String>,
    /// Cells that went out of view.
    pub left: Vec<String>,
}

/// A cell that a cull leaves.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct EyePlanCell {
    /// The cell's name.
    pub cell: String,
    /// A shortest sequence of portals through which it is seen, none for a cell that holds the
    /// eye; null for culls but `exact`.
    pub portals: Option<Vec<u32>>,
    /// A direction strictly inside of them and of the view cone; null for a cell that holds the
    /// eye.
    pub direction: Option<[Integer; 2]>,
}

/// What is seen exactly.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct EyePlanSeen {
    /// Its area: the sum of all regions', which have no inner point in common.
    pub area: Ratio,
    /// Through how many portal sequences the eye sees.
    pub sequences: u64,
    /// The parts of cells that are seen: those of cells that hold the eye, then each sequence's;
    /// only where they were asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub regions: Option<Vec<EyePlanRegion>>,
}

/// What is seen of a cell through one sequence.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct EyePlanRegion {
    /// The cell.
    pub cell: String,
    /// The portals; none for a cell that holds the eye.
    pub portals: Vec<u32>,
    /// The area.
    pub area: Ratio,
    /// A convex polygon, counter-clockwise.
    pub polygon: Vec<[Ratio; 2]>,
}

impl EyePlanReport {
    /// The name of the format, its first field.
    pub const FORMAT: &'static str = "stabline-eye-plan/1";

    /// A report without a view yet.
    pub fn new(input: InputId, cull: &str, cone: Option<EyeCone>, area: Ratio) -> EyePlanReport {
        EyePlanReport {
            format: EyePlanReport::FORMAT,
            input: input.into(),
            cull: cull.to_owned(),
            cone,
            area,
            views: Vec::new(),
        }
    }

    /// As JSON.
    pub fn to_json(&self) -> String {
        format!("{:#}\n", serde_json::json!(self))
    }

    /// As canonical text, one fact a line.
    pub fn to_text(&self) -> String {
        let mut text = String::new();
        if let Some(EyeCone { look, half_tangent, sides: [right, left] }) = &self.cone {
            let side = |[x, y]: &[Integer; 2]| format!("({x} {y})");
            text.push_str(&format!(
                "cone look {}, half-tangent {half_tangent}, sides {} {}\n",
                pair(look),
                side(right),
                side(left)
            ));
        }
        for view in &self.views {
            text.push_str(&view.to_text(&self.cull, &self.area));
        }
        text
    }

    /// The JSON schema of the format.
    pub fn schema() -> serde_json::Value {
        schemars::schema_for!(EyePlanReport).to_value()
    }
}

impl EyePlanView {
    fn to_text(&self, cull: &str, area: &Ratio) -> String {
        let mut text = format!("eye {} in {}", pair(&self.eye), self.cell);
        if self.around.len() > 1 {
            text.push_str(&format!(", around it {}", self.around.join(" ")));
        }
        text.push('\n');
        text.extend(self.step.iter().map(EyePlanStep::to_text));
        let (count, cells_area) = (self.cells.len(), &self.cells_area);
        text.push_str(&format!("{cull}: {count} cells of area {cells_area} of {area}\n"));
        if let Some(EyePlanSeen { area, sequences, .. }) = &self.seen {
            text.push_str(&format!("seen area {area} through {sequences} sequences\n"));
        }
        for EyePlanCell { cell, portals, direction } in &self.cells {
            text.push_str(&format!("{cell}{}", through(portals.as_deref().unwrap_or_default())));
            if let Some([x, y]) = direction {
                text.push_str(&format!(" towards ({x} {y})"));
            }
            text.push('\n');
        }
        for region in self.seen.iter().flat_map(|seen| seen.regions.iter().flatten()) {
            let polygon: Vec<String> = region.polygon.iter().map(pair).collect();
            text.push_str(&format!(
                "region of {}{}: area {}, {}\n",
                region.cell,
                through(&region.portals),
                region.area,
                polygon.join(" ")
            ));
        }
        text
    }
}

impl EyePlanStep {
    fn to_text(&self) -> String {
        let way = match self.portals {
            Some(portals) => format!("through {portals} portals"),
            None => "located".to_owned(),
        };
        let names = |what: &str, cells: &[String]| match cells {
            [] => String::new(),
            cells => format!(", {what} {}", cells.join(" ")),
        };
        format!("{way}{}{}\n", names("entered", &self.entered), names("left", &self.left))
    }
}

/// A point or a direction as canonical text shows it.
fn pair([x, y]: &[Ratio; 2]) -> String {
    format!("({x} {y})")
}
