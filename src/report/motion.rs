//! How far a move gets, as canonical text and as `stabline-move/1`.

use super::InputId;
use super::eye::{EyeInput, Integer, Ratio, tuple};
use schemars::JsonSchema;
use serde::Serialize;

/// The first contact of a straight move of a point or of an axial box.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(title = "stabline-move/1")]
pub struct MoveReport {
    /// The name of the format.
    #[schemars(regex(pattern = "^stabline-move/1$"))]
    format: &'static str,
    /// The input.
    pub input: EyeInput,
    /// Where the point starts.
    pub from: [Ratio; 3],
    /// Where it would end.
    pub to: [Ratio; 3],
    /// The box that it carries; null for a point alone.
    #[serde(rename = "box")]
    pub body: Option<MoveBox>,
    /// Whether something stops the move before its end.
    pub contact: bool,
    /// The share of the way that is free: the time of the first contact, or 1.
    pub time: Ratio,
    /// Where the point is then.
    pub point: [Ratio; 3],
    /// What is hit; empty for a free move.
    pub hits: Vec<MoveHit>,
    /// The closed cells that the point (the middle of the box) is in, in their order.
    pub cells: Vec<MoveStay>,
}

/// A box, as seen from the point that carries it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct MoveBox {
    /// The corner of least coordinates.
    pub low: [Ratio; 3],
    /// The corner of greatest coordinates.
    pub high: [Ratio; 3],
}

/// A contact with one plane of one obstacle.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct MoveHit {
    /// `solid`, `polygon`, or `bounds` for the end of the world.
    #[schemars(regex(pattern = "^(solid|polygon|bounds)$"))]
    pub kind: String,
    /// Which solid or polygon of the world, counted from 0; null for the end of the world.
    pub index: Option<u64>,
    /// What the input calls it.
    pub name: Option<String>,
    /// Its line in the input, counted from 1, where it has one.
    pub line: Option<u64>,
    /// The normal of the plane of contact, out of the obstacle, without a common divisor.
    pub normal: [Integer; 3],
    /// The value of normal · x on the plane.
    pub offset: Ratio,
    /// `face` of the obstacle, `box-face` of the mover, or `edges` of both, crosswise.
    #[schemars(regex(pattern = "^(face|box-face|edges)$"))]
    pub touch: String,
}

/// A cell on the way.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct MoveStay {
    /// The cell's name.
    pub cell: String,
    /// When it is entered.
    pub enter: Ratio,
    /// When it is left, or the way ends.
    pub leave: Ratio,
}

impl MoveReport {
    /// The name of the format, as in its first field.
    pub const FORMAT: &'static str = "stabline-move/1";

    /// A report of a free move through no cell yet.
    pub fn new(input: InputId, from: [Ratio; 3], to: [Ratio; 3]) -> MoveReport {
        MoveReport {
            format: MoveReport::FORMAT,
            input: input.into(),
            from,
            point: to.clone(),
            to,
            body: None,
            contact: false,
            time: Ratio::one(),
            hits: Vec::new(),
            cells: Vec::new(),
        }
    }

    /// As JSON.
    pub fn to_json(&self) -> String {
        format!("{:#}\n", serde_json::json!(self))
    }

    /// As canonical text, one fact a line.
    pub fn to_text(&self) -> String {
        let mut text = format!("from {} to {}\n", tuple(&self.from), tuple(&self.to));
        if let Some(MoveBox { low, high }) = &self.body {
            text.push_str(&format!("box {} .. {}\n", tuple(low), tuple(high)));
        }
        match self.contact {
            true => text.push_str(&format!("contact at {}, {}\n", self.time.0, tuple(&self.point))),
            false => text.push_str("free\n"),
        }
        for hit in &self.hits {
            text.push_str(&hit.to_line());
        }
        for MoveStay { cell, enter, leave } in &self.cells {
            text.push_str(&format!("cell {cell} from {} to {}\n", enter.0, leave.0));
        }
        text
    }

    /// The JSON schema of the format.
    pub fn schema() -> serde_json::Value {
        schemars::schema_for!(MoveReport).to_value()
    }
}

impl MoveHit {
    fn to_line(&self) -> String {
        let line = self.line.map(|line| format!(" of line {line}")).unwrap_or_default();
        let what = match (&self.name, self.index) {
            (Some(name), Some(index)) => format!("{} {index} `{name}`{line}", self.kind),
            _ => "the end of the world".to_owned(),
        };
        let [x, y, z] = self.normal.each_ref().map(Integer::to_string);
        let touch = match self.touch.as_str() {
            "face" => "a face",
            "box-face" => "a face of the box",
            _ => "two edges",
        };
        format!("hit {what}: {touch}, ({x} {y} {z}) . x = {}\n", self.offset.0)
    }
}
