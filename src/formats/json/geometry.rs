//! JSON scenes that state geometry instead of cells and portals.
//!
//! Shapes that may be stated in several ways are read into one struct of optional fields and then
//! judged, so that an error names the line and the column.

use super::{Coordinate, Grid, SceneFileError};
use crate::formats::csg::Node;
use schemars::JsonSchema;
use serde_json::json;

/// A point in world units.
pub type ScenePoint = [Coordinate; 3];

/// A scene: what stands in space.
#[derive(Clone, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "Geometry")]
pub struct GeometryFile {
    /// The point of the scene: what is special about it, and what must come out.
    pub about: String,
    /// The name of the format.
    #[schemars(regex(pattern = "^stabline-scene/1$"))]
    pub format: String,
    /// Grid units in one world unit. Where it is given, every coordinate of a point must be a
    /// multiple of the unit.
    #[serde(default)]
    pub grid: Option<Grid>,
    /// The box to be divided, by its corners of least and of greatest coordinates; otherwise one
    /// around everything.
    #[serde(default)]
    pub view: Option<[ScenePoint; 2]>,
    /// Polygons that occlude, seen from either side.
    #[serde(default)]
    pub polygons: Vec<ScenePolygon>,
    /// Convex solids that occlude.
    #[serde(default)]
    pub brushes: Vec<SceneBrush>,
    /// Solids that occlude, as expressions of convex ones.
    #[serde(default)]
    pub solids: Vec<SceneSolid>,
    /// Detail objects, which never occlude.
    #[serde(default)]
    pub objects: Vec<SceneObject>,
    /// Points that mark the inside: only what can be reached from them is asked about. Without the
    /// field all empty space is.
    #[serde(default)]
    pub inside: Option<Vec<ScenePoint>>,
    /// Convex solids whose faces split cells, and that are otherwise nothing.
    #[serde(default)]
    pub hints: Vec<SceneBrush>,
}

/// A polygon.
#[derive(Clone, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "Polygon")]
pub struct ScenePolygon {
    /// What it is called, if it is.
    #[serde(default)]
    pub name: Option<String>,
    /// Three or more vertices in order, either way around.
    pub polygon: Vec<ScenePoint>,
}

/// A solid that need not be convex.
#[derive(Clone, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "Solid")]
pub struct SceneSolid {
    /// What it is called, if it is.
    #[serde(default)]
    pub name: Option<String>,
    /// The expression, as in `stabline-csg/1`.
    pub solid: Node,
}

/// A detail object.
#[derive(Clone, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "Object")]
pub struct SceneObject {
    /// What it is called, if it is.
    #[serde(default)]
    pub name: Option<String>,
    /// Its bounding box, by its corners of least and of greatest coordinates.
    #[serde(rename = "box")]
    pub bounds: [ScenePoint; 2],
}

/// A convex solid.
#[derive(Clone, Debug, PartialEq, Eq, serde::Deserialize)]
#[serde(try_from = "BrushFields")]
pub struct SceneBrush {
    /// What it is called, if it is.
    pub name: Option<String>,
    /// How it is stated.
    pub shape: BrushShape,
}

/// How a convex solid is stated.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum BrushShape {
    /// The common part of the half-spaces behind planes.
    Planes(Vec<ScenePlane>),
    /// The convex hull of points.
    Points(Vec<ScenePoint>),
    /// A box by its corners of least and of greatest coordinates.
    Box([ScenePoint; 2]),
}

/// A plane, directed.
#[derive(Clone, Debug, PartialEq, Eq, serde::Deserialize)]
#[serde(try_from = "PlaneFields")]
pub enum ScenePlane {
    /// normal · x = offset, the normal pointing out of the solid.
    Equation {
        /// The normal.
        normal: ScenePoint,
        /// The offset.
        offset: Coordinate,
    },
    /// Three points, counter-clockwise as seen from outside the solid.
    Points([ScenePoint; 3]),
}

#[derive(serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(
    rename = "Brush",
    extend("oneOf" = [
        json!({"required": ["planes"]}), json!({"required": ["points"]}), json!({"required": ["box"]})
    ])
)]
/// A convex solid, by one of `planes`, `points` and `box`.
struct BrushFields {
    /// What it is called, if it is.
    #[serde(default)]
    name: Option<String>,
    /// The planes of its faces.
    #[serde(default)]
    planes: Option<Vec<ScenePlane>>,
    /// Points whose convex hull it is.
    #[serde(default)]
    points: Option<Vec<ScenePoint>>,
    /// Its corners of least and of greatest coordinates.
    #[serde(default, rename = "box")]
    bounds: Option<[ScenePoint; 2]>,
}

#[derive(serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(
    rename = "BrushPlane",
    extend("oneOf" = [json!({"required": ["normal", "offset"]}), json!({"required": ["points"]})])
)]
/// A plane, by `normal` and `offset` or by three `points`.
struct PlaneFields {
    /// The normal, out of the solid: on the plane normal · x = offset.
    #[serde(default)]
    normal: Option<ScenePoint>,
    /// The value of normal · x on the plane.
    #[serde(default)]
    offset: Option<Coordinate>,
    /// Three points, counter-clockwise as seen from outside the solid.
    #[serde(default)]
    points: Option<[ScenePoint; 3]>,
}

impl TryFrom<BrushFields> for SceneBrush {
    type Error = &'static str;

    fn try_from(fields: BrushFields) -> Result<SceneBrush, &'static str> {
        let shape = match (fields.planes, fields.points, fields.bounds) {
            (Some(planes), None, None) => BrushShape::Planes(planes),
            (None, Some(points), None) => BrushShape::Points(points),
            (None, None, Some(bounds)) => BrushShape::Box(bounds),
            _ => return Err("a brush: expected one of `planes`, `points` and `box`"),
        };
        Ok(SceneBrush { name: fields.name, shape })
    }
}

impl TryFrom<PlaneFields> for ScenePlane {
    type Error = &'static str;

    fn try_from(fields: PlaneFields) -> Result<ScenePlane, &'static str> {
        match (fields.normal, fields.offset, fields.points) {
            (Some(normal), Some(offset), None) => Ok(ScenePlane::Equation { normal, offset }),
            (None, None, Some(points)) => Ok(ScenePlane::Points(points)),
            _ => Err("a plane: expected `normal` and `offset`, or `points`"),
        }
    }
}

macro_rules! schema_of {
    ($type:ty, $fields:ty) => {
        impl JsonSchema for $type {
            fn schema_name() -> std::borrow::Cow<'static, str> {
                <$fields>::schema_name()
            }

            fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
                <$fields>::json_schema(generator)
            }
        }
    };
}

schema_of!(SceneBrush, BrushFields);
schema_of!(ScenePlane, PlaneFields);

impl GeometryFile {
    /// The names of the fields that no portal graph has.
    pub(super) const OWN_FIELDS: [&'static str; 7] =
        ["view", "polygons", "brushes", "solids", "objects", "inside", "hints"];

    /// Reads a scene that states geometry.
    ///
    /// # Errors
    /// [`SceneFileError`] names the line and the rule broken.
    pub fn read(bytes: &[u8]) -> Result<GeometryFile, SceneFileError> {
        let file: GeometryFile = super::parse(bytes)?;
        super::check_format(&file.format)?;
        Ok(file)
    }
}
