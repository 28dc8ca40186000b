//! JSON scenes, `stabline-scene/1`: cells by name and the portals between them, or geometry.
//!
//! Numbers are read from their text, so that a decimal keeps all its digits: `12`, `12.125`,
//! `1e-3`, and as strings also `"7/3"`. Linear in the size of the file.

use crate::num::{Int, Number};
use num_traits::{One, Signed};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{Deserialize, Deserializer, Error};
use serde_json::value::{RawValue, Value};
use std::borrow::Cow;
use std::collections::BTreeMap;

mod exact;
mod geometry;
mod plan;

pub use exact::{exact, exact_if_any, read_exact};

pub use geometry::{
    BrushShape, GeometryFile, SceneBrush, SceneObject, ScenePlane, ScenePoint, ScenePolygon,
    SceneSolid,
};

pub use plan::{PlanFile, PlanFileObject, PlanFilePortal, PlanGraphFile, PlanePoint};

/// The name of the format.
pub const SCENE_FORMAT: &str = "stabline-scene/1";

/// A scene: convex cells and the convex polygons through which one sees from one into another.
#[derive(Clone, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "PortalGraph")]
pub struct SceneFile {
    /// The point of the scene: what is special about it, and what must come out.
    pub about: String,
    /// The name of the format.
    #[schemars(regex(pattern = "^stabline-scene/1$"))]
    pub format: String,
    /// Grid units in one world unit. Where it is given, every coordinate must be a multiple of
    /// the unit; otherwise the grid is the lowest common denominator of all coordinates.
    #[serde(default)]
    pub grid: Option<Grid>,
    /// The names of the cells, each once.
    pub cells: Vec<String>,
    /// The portals.
    pub portals: Vec<ScenePortal>,
}

/// A planar convex polygon between two cells.
#[derive(Clone, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "Portal")]
pub struct ScenePortal {
    /// The cell that the polygon's right-hand normal leaves.
    pub from: String,
    /// The cell that it enters.
    pub to: String,
    /// Three or more vertices, counter-clockwise as seen from `to`.
    pub polygon: Vec<[Coordinate; 3]>,
}

/// A coordinate in world units.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Coordinate(pub Number);

/// A positive integer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Grid(pub Int);

/// Why a text is not a JSON scene, and where.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("line {line}: {}", self.without_line())]
pub struct SceneFileError {
    /// The line, counted from 1.
    pub line: usize,
    /// The column, counted from 1.
    pub column: usize,
    /// The rule broken.
    pub what: String,
}

impl SceneFileError {
    /// The message without the line, for whoever names it already.
    pub fn without_line(&self) -> String {
        format!("column {}: {}", self.column, self.what)
    }
}

impl SceneFile {
    /// Reads a scene.
    ///
    /// # Errors
    /// [`SceneFileError`] names the line and the rule broken.
    pub fn read(bytes: &[u8]) -> Result<SceneFile, SceneFileError> {
        let file: SceneFile = parse(bytes)?;
        check_format(&file.format)?;
        Ok(file)
    }
}

fn parse<'b, T: Deserialize<'b>>(bytes: &'b [u8]) -> Result<T, SceneFileError> {
    serde_json::from_slice(bytes).map_err(|error| {
        let what = error.to_string();
        // serde_json ends its message with the place, which is kept apart here.
        let what = what.split(" at line ").next().unwrap_or_default().to_owned();
        SceneFileError { line: error.line(), column: error.column(), what }
    })
}

fn check_format(format: &str) -> Result<(), SceneFileError> {
    if format == SCENE_FORMAT {
        return Ok(());
    }
    let what = format!("format: expected `{SCENE_FORMAT}`, got `{}`", excerpt(format));
    Err(SceneFileError { line: 1, column: 1, what })
}

/// What a scene states.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SceneKind {
    /// Cells and portals: [`SceneFile`].
    Graph,
    /// What stands in space: [`GeometryFile`].
    Geometry,
    /// What stands in the plane: [`PlanFile`].
    Plan,
    /// Cells of the plane and segments between them: [`PlanGraphFile`].
    PlanGraph,
}

impl SceneKind {
    /// What the fields of a scene make it, whatever they hold.
    ///
    /// # Errors
    /// [`SceneFileError`]: not an object of JSON, or fields of both kinds.
    pub fn of(bytes: &[u8]) -> Result<SceneKind, SceneFileError> {
        let fields: BTreeMap<Cow<str>, &RawValue> = parse(bytes)?;
        let own = |names: &[&'static str]| {
            names.iter().find_map(|&name| Some((name, *fields.get(name)?)))
        };
        let portals = fields.get("portals").map_or("", |portals| portals.get());
        match (own(&["cells", "portals"]), own(&GeometryFile::OWN_FIELDS)) {
            (None, _) if fields.contains_key("segments") => Ok(SceneKind::Plan),
            (_, None) if PlanGraphFile::states_segments(portals) => Ok(SceneKind::PlanGraph),
            (_, None) => Ok(SceneKind::Graph),
            (None, Some(_)) => Ok(SceneKind::Geometry),
            (Some((of_graph, _)), Some((of_geometry, value))) => {
                // The value is a part of the text.
                let before = value.get().as_ptr() as usize - bytes.as_ptr() as usize;
                let before = &bytes[..before];
                let line = before.iter().filter(|&&byte| byte == b'\n').count() + 1;
                let column = before.iter().rev().take_while(|&&byte| byte != b'\n').count() + 1;
                let what = format!(
                    "`{of_geometry}` states geometry and `{of_graph}` a portal graph, expected one \
                     of the two"
                );
                Err(SceneFileError { line, column, what })
            }
        }
    }

    /// The JSON schema of the format.
    pub fn schema() -> Value {
        let mut generator = SchemaGenerator::default();
        let graph = generator.subschema_for::<SceneFile>();
        let geometry = generator.subschema_for::<GeometryFile>();
        let plan = generator.subschema_for::<PlanFile>();
        let plan_graph = generator.subschema_for::<PlanGraphFile>();
        let mut schema = json_schema!({
            "$schema": "https://json-schema.org/draft/2020-12/schema",
            "title": SCENE_FORMAT,
            "description": "A scene: cells and portals, or what stands in space or in the plane.",
            "oneOf": [graph, geometry, plan, plan_graph],
        });
        schema.insert("$defs".to_owned(), generator.take_definitions(true).into());
        schema.to_value()
    }
}

/// The text of a JSON number, or what a JSON string holds.
fn number_text<'de, D: Deserializer<'de>>(from: D) -> Result<Cow<'de, str>, D::Error> {
    let raw = <&RawValue>::deserialize(from)?.get();
    match raw.as_bytes().first() {
        Some(b'"') => serde_json::from_str::<String>(raw).map(Cow::Owned).map_err(D::Error::custom),
        Some(b'-' | b'0'..=b'9') => Ok(Cow::Borrowed(raw)),
        _ => {
            let expected = "expected a number or a ratio in quotes";
            Err(D::Error::custom(format!("{expected}, got `{}`", excerpt(raw))))
        }
    }
}

fn excerpt(text: &str) -> &str {
    let end = text.char_indices().nth(32).map_or(text.len(), |(end, _)| end);
    &text[..end]
}

impl<'de> Deserialize<'de> for Coordinate {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Coordinate, D::Error> {
        let text = number_text(from)?;
        let number = Number::parse(&text);
        number
            .map(Coordinate)
            .map_err(|error| D::Error::custom(format!("coordinate `{}`: {error}", excerpt(&text))))
    }
}

impl<'de> Deserialize<'de> for Grid {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Grid, D::Error> {
        let text = number_text(from)?;
        match Number::parse(&text).map(|number| number.to_rational()) {
            Ok(ratio) if ratio.denom().is_one() && ratio.is_positive() => {
                Ok(Grid(ratio.to_integer()))
            }
            _ => Err(D::Error::custom(format!(
                "grid: expected a positive integer, got `{}`",
                excerpt(&text)
            ))),
        }
    }
}

impl JsonSchema for Coordinate {
    fn schema_name() -> Cow<'static, str> {
        "Coordinate".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "description": "Read exactly, however many digits it has.",
            "anyOf": [
                {"type": "number"},
                {
                    "type": "string",
                    "pattern": r"^[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?$|^-?[0-9]+/[0-9]+$"
                }
            ]
        })
    }
}

impl JsonSchema for Grid {
    fn schema_name() -> Cow<'static, str> {
        "Grid".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "anyOf": [
                {"type": "integer", "minimum": 1},
                {"type": "string", "pattern": "^[0-9]+$"}
            ]
        })
    }
}

impl SceneFile {
    /// The canonical text of a scene, one portal a line.
    pub fn to_text(&self) -> String {
        let quoted = |text: &str| Value::from(text).to_string();
        let mut text = format!(
            "{{\"about\": {},\n\"format\": {},\n",
            quoted(&self.about),
            quoted(&self.format)
        );
        if let Some(Grid(grid)) = &self.grid {
            text.push_str(&format!("\"grid\": {},\n", number(&Number::from(grid.clone()))));
        }
        let cells: Vec<String> = self.cells.iter().map(|cell| quoted(cell)).collect();
        text.push_str(&format!("\"cells\": [{}],\n\"portals\": [", cells.join(", ")));
        for (index, portal) in self.portals.iter().enumerate() {
            let vertices: Vec<String> = portal
                .polygon
                .iter()
                .map(|[x, y, z]| format!("[{}, {}, {}]", number(&x.0), number(&y.0), number(&z.0)))
                .collect();
            text.push_str(&format!(
                "{}\n{{\"from\": {}, \"to\": {}, \"polygon\": [{}]}}",
                if index == 0 { "" } else { "," },
                quoted(&portal.from),
                quoted(&portal.to),
                vertices.join(", ")
            ));
        }
        text.push_str("]}\n");
        text
    }
}

/// A JSON integer while it fits in 53 bits, else a string.
fn number(number: &Number) -> String {
    match number {
        Number::Small(integer, 1) if integer.unsigned_abs() < 1 << 53 => integer.to_string(),
        _ => format!("\"{number}\""),
    }
}
