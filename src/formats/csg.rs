//! Boolean expressions of convex brushes, `stabline-csg/1`.
//!
//! A [`Node`] is one object with one key, which says what it is: an operator over nodes, an affine
//! map of a node, or a brush. Numbers are read exactly, as in JSON scenes. What the shapes mean is
//! for `csg` to say; here is only their form. Linear in the size of the file; objects nest at most
//! some hundred deep, as the JSON reader allows.

use super::json::{Coordinate, Grid};
use schemars::JsonSchema;

/// The name of the format.
pub const CSG_FORMAT: &str = "stabline-csg/1";

/// An expression and the expressions that it uses by name.
#[derive(Clone, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "stabline-csg/1")]
pub struct CsgFile {
    /// The point of the example: what is special about it, and what must come out.
    #[serde(default)]
    pub about: Option<String>,
    /// The name of the format.
    #[schemars(regex(pattern = "^stabline-csg/1$"))]
    pub format: String,
    /// Expressions with names; each may use those before it.
    #[serde(default)]
    pub define: Vec<Definition>,
    /// The expression.
    pub body: Node,
}

/// An expression with a name.
#[derive(Clone, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Definition {
    /// The name, given once.
    pub name: String,
    /// What it stands for.
    pub body: Node,
}

/// A set of points.
#[derive(Clone, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Node {
    /// What is in one of them at least.
    Union(Vec<Node>),
    /// What is in all of them.
    Intersection(Vec<Node>),
    /// What is in the first and in none of the others.
    Difference(Vec<Node>),
    /// What is not in it.
    Complement(Box<Node>),
    /// What a definition stands for.
    Use(String),
    /// An axial box.
    Box(Corners),
    /// The part of a box below the plane that rises from its lower edge at the least x to its
    /// upper edge at the greatest x.
    Wedge(Corners),
    /// A polygon drawn upwards.
    Prism(Prism),
    /// A polygon joined to an apex.
    Pyramid(Pyramid),
    /// A prism over a rounded regular polygon.
    Cylinder(Cylinder),
    /// The convex hull of rounded points of meridians.
    Sphere(Sphere),
    /// The points that are on no plane's outer side.
    Planes(Vec<PlaneNode>),
    /// The convex hull of points.
    Points(Vec<[Coordinate; 3]>),
    /// A node moved by a vector.
    Translate(Vector),
    /// A node scaled along the axes, from the origin.
    Scale(Vector),
    /// A node turned about an axis through the origin.
    Rotate90(Turn),
    /// A node mirrored in the plane through the origin perpendicular to an axis.
    Mirror(Reflection),
    /// A node under any affine map that can be undone.
    Matrix(Matrix),
}

/// Opposite corners of a box.
#[derive(Clone, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Corners {
    /// The corner of the least coordinates.
    pub low: [Coordinate; 3],
    /// The corner of the greatest coordinates.
    pub high: [Coordinate; 3],
}

/// A prism along z.
#[derive(Clone, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Prism {
    /// The vertices [x, y] of a convex polygon, in either direction.
    pub polygon: Vec<[Coordinate; 2]>,
    /// The least and the greatest z.
    pub heights: [Coordinate; 2],
}

/// A pyramid.
#[derive(Clone, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Pyramid {
    /// The vertices [x, y] of the base, a convex polygon, in either direction.
    pub polygon: Vec<[Coordinate; 2]>,
    /// The z of the base.
    pub height: Coordinate,
    /// Above or below the base.
    pub apex: [Coordinate; 3],
}

/// A cylinder along z, approximated.
#[derive(Clone, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Cylinder {
    /// The x and y of its axis.
    pub center: [Coordinate; 2],
    /// The radius, positive.
    pub radius: Coordinate,
    /// The least and the greatest z.
    pub heights: [Coordinate; 2],
    /// How many vertices the polygon has before it is rounded.
    #[schemars(range(min = 3, max = 256))]
    pub sides: u32,
    /// Vertices differ from the axis by multiples of one over this.
    pub grid: Grid,
}

/// A sphere, approximated.
#[derive(Clone, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Sphere {
    /// Its centre.
    pub center: [Coordinate; 3],
    /// The radius, positive.
    pub radius: Coordinate,
    /// How many meridians it has, an even number; on each half as many steps from pole to pole.
    #[schemars(range(min = 4, max = 32))]
    pub sides: u32,
    /// Vertices differ from the centre by multiples of one over this.
    pub grid: Grid,
}

/// A half-space, either by `normal` and `offset` or by `points`.
#[derive(Clone, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "Plane")]
pub struct PlaneNode {
    /// Points out of the half-space.
    #[serde(default)]
    pub normal: Option<[Coordinate; 3]>,
    /// The half-space is normal · x <= offset.
    #[serde(default)]
    pub offset: Option<Coordinate>,
    /// Three points of the plane, counter-clockwise as seen from outside.
    #[serde(default)]
    pub points: Option<[[Coordinate; 3]; 3]>,
}

/// A node and a vector.
#[derive(Clone, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Vector {
    /// The vector.
    pub by: [Coordinate; 3],
    /// The node.
    pub of: Box<Node>,
}

/// A node and how it is turned.
#[derive(Clone, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Turn {
    /// The axis, about which turns are counter-clockwise as seen from its end.
    pub axis: Axis,
    /// How many quarters of a turn; may be negative.
    pub turns: i32,
    /// The node.
    pub of: Box<Node>,
}

/// A node and the axis that is mirrored.
#[derive(Clone, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Reflection {
    /// The axis whose coordinate changes its sign.
    pub axis: Axis,
    /// The node.
    pub of: Box<Node>,
}

/// A node and the map x -> rows · x + shift.
#[derive(Clone, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Matrix {
    /// The linear part, by rows; its determinant is not zero.
    pub rows: [[Coordinate; 3]; 3],
    /// What is added; nothing if left out.
    #[serde(default)]
    pub shift: Option<[Coordinate; 3]>,
    /// The node.
    pub of: Box<Node>,
}

/// An axis of space.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Axis {
    /// The first coordinate's.
    X,
    /// The second coordinate's.
    Y,
    /// The third coordinate's.
    Z,
}

/// Why a text is not an expression.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum CsgFileError {
    /// Not the JSON that the format asks for.
    #[error("line {line}, column {column}: {what}")]
    Json {
        /// The line, counted from 1.
        line: usize,
        /// The column, counted from 1.
        column: usize,
        /// The rule broken.
        what: String,
    },
    /// Another format, or another version.
    #[error("format: expected `{CSG_FORMAT}`, got `{0}`")]
    Format(String),
}

impl CsgFile {
    /// Reads an expression.
    ///
    /// # Errors
    /// [`CsgFileError`] names the place and the rule broken.
    pub fn read(bytes: &[u8]) -> Result<CsgFile, CsgFileError> {
        let file: CsgFile = serde_json::from_slice(bytes).map_err(|error| {
            let what = error.to_string();
            // serde_json ends its message with the place, which is kept apart here.
            let what = what.split(" at line ").next().unwrap_or_default().to_owned();
            CsgFileError::Json { line: error.line(), column: error.column(), what }
        })?;
        match file.format == CSG_FORMAT {
            true => Ok(file),
            false => Err(CsgFileError::Format(file.format)),
        }
    }

    /// The JSON schema of the format.
    pub fn schema() -> serde_json::Value {
        schemars::schema_for!(CsgFile).to_value()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::num::Number;

    #[test]
    fn every_kind_of_node_is_read() {
        let text = r#"{"format": "stabline-csg/1",
            "define": [{"name": "unit", "body": {"box": {"low": [0, 0, 0], "high": [1, 1, 1]}}}],
            "body": {"union": [{"use": "unit"},
                {"difference": [{"planes": [{"normal": ["1/3", 0, 1e-3], "offset": 2}]}]},
                {"intersection": [{"complement": {"points": [[0, 0, "0.1"]]}}]},
                {"rotate90": {"axis": "z", "turns": -1, "of": {"use": "unit"}}},
                {"matrix": {"rows": [[1, 0, 0], [0, 1, 0], [0, 0, 2]], "of": {"use": "unit"}}}]}}"#;
        let Node::Union(of) = CsgFile::read(text.as_bytes()).unwrap().body else { panic!() };
        let Node::Difference(parts) = &of[1] else { panic!() };
        let Node::Planes(planes) = &parts[0] else { panic!() };
        let third = Coordinate(Number::Small(1, 3));
        assert_eq!(planes[0].normal.as_ref().unwrap()[0], third);
        assert!(matches!(&of[3], Node::Rotate90(Turn { axis: Axis::Z, turns: -1, .. })));
        assert!(matches!(&of[4], Node::Matrix(Matrix { shift: None, .. })));
    }

    #[test]
    fn what_has_another_form_is_refused_with_its_place() {
        let body = |body: &str| format!("{{\"format\": \"stabline-csg/1\",\n\"body\": {body}}}");
        let deep = format!("{}{}", "{\"union\":[".repeat(100_000), "]}".repeat(100_000));
        for (text, expected) in [
            (String::new(), "line 1, column 0: EOF"),
            (body(r#"{"cube": {}}"#), "line 2, column 15: unknown variant `cube`"),
            (body(r#"{"box": {"low": [0, 0, 0], "up": 1}}"#), "unknown field `up`"),
            (body(r#"{"box": {"low": [0, 0, 0]}}"#), "missing field `high`"),
            (body(r#"{"points": [[0, 0, NaN]]}"#), "line 2, column 28: expected value"),
            (body(r#"{"points": [[0, 0, "nan"]]}"#), "coordinate `nan`: not a decimal"),
            (body(r#"{"points": [[0, 0]]}"#), "expected an array of length 3"),
            (body(r#"{"union": [], "use": "a"}"#), "line 2"),
            (body(&deep), "recursion limit exceeded"),
            (body(&"[".repeat(100_000)), "line 2"),
            (
                r#"{"format": "stabline-csg/2", "body": {"union": []}}"#.into(),
                "got `stabline-csg/2`",
            ),
        ] {
            let error = CsgFile::read(text.as_bytes()).unwrap_err().to_string();
            assert!(error.contains(expected), "{error}");
        }
    }
}
