//! Portal sequences, `stabline-sequence/1`: polygons in space or segments in the plane, numbers
//! read exactly.

use super::json::Coordinate;
use crate::geom::{BigPoint2, BigPoint3};
use crate::num::{Int, Rational};
use num_integer::Integer;
use num_traits::One;
use schemars::JsonSchema;

/// The name of the format.
pub const SEQUENCE_FORMAT: &str = "stabline-sequence/1";

/// A portal sequence.
#[derive(Clone, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "stabline-sequence/1")]
pub struct SequenceFile {
    /// The point of the example: what is special about it, and what must come out.
    #[serde(default)]
    pub about: Option<String>,
    /// The name of the format.
    #[schemars(regex(pattern = "^stabline-sequence/1$"))]
    pub format: String,
    /// The portals in the order of the sequence. In space each has three or more vertices
    /// [x, y, z], counter-clockwise as seen from the side to which the line leaves; in the plane
    /// two vertices [x, y], first the end on the line's left, then the one on its right.
    #[schemars(length(min = 1))]
    pub portals: Vec<Vec<Vec<Coordinate>>>,
}

/// A sequence's vertices on its grid: the lowest common denominator of its coordinates.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum SequencePoints {
    /// Polygons in space.
    Space {
        /// Grid units in one unit of the file.
        denominator: Int,
        /// The vertices of each portal, in grid units.
        portals: Vec<Vec<BigPoint3>>,
    },
    /// Segments in the plane.
    Plane {
        /// Grid units in one unit of the file.
        denominator: Int,
        /// The left and the right end of each portal, in grid units.
        portals: Vec<[BigPoint2; 2]>,
    },
}

/// Why a text is not a portal sequence.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SequenceFileError {
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
    #[error("format: expected `{SEQUENCE_FORMAT}`, got `{0}`")]
    Format(String),
    /// A sequence without portals.
    #[error("portals: expected at least one, got none")]
    Empty,
    /// A portal without vertices.
    #[error("portals[{0}]: has no vertices")]
    NoVertices(usize),
    /// A vertex with the wrong number of coordinates.
    #[error(
        "portals[{portal}]: vertex {vertex} has {count} coordinates, expected {expected}, as the \
         sequence's first vertex has"
    )]
    Coordinates {
        /// The portal, from 0.
        portal: usize,
        /// The vertex, from 0.
        vertex: usize,
        /// How many coordinates it has.
        count: usize,
        /// 2 or 3.
        expected: usize,
    },
    /// The first vertex is neither of the plane nor of space.
    #[error("portals[0]: vertex 0 has {0} coordinates, expected 2 or 3")]
    Dimension(usize),
    /// A portal of the plane that is not a segment.
    #[error("portals[{portal}]: has {count} vertices, expected the 2 ends of a segment")]
    NotASegment {
        /// The portal, from 0.
        portal: usize,
        /// How many vertices it has.
        count: usize,
    },
}

impl SequenceFile {
    /// Reads a sequence.
    ///
    /// # Errors
    /// [`SequenceFileError`] names the place and the rule broken.
    pub fn read(bytes: &[u8]) -> Result<SequenceFile, SequenceFileError> {
        let file: SequenceFile = serde_json::from_slice(bytes).map_err(|error| {
            let what = error.to_string();
            // serde_json ends its message with the place, which is kept apart here.
            let what = what.split(" at line ").next().unwrap_or_default().to_owned();
            SequenceFileError::Json { line: error.line(), column: error.column(), what }
        })?;
        if file.format != SEQUENCE_FORMAT {
            return Err(SequenceFileError::Format(file.format));
        }
        Ok(file)
    }

    /// The vertices in grid units.
    ///
    /// # Errors
    /// [`SequenceFileError`] where the portals are neither all polygons nor all segments.
    pub fn points(&self) -> Result<SequencePoints, SequenceFileError> {
        let first = self.portals.first().ok_or(SequenceFileError::Empty)?;
        let expected = first.first().ok_or(SequenceFileError::NoVertices(0))?.len();
        if expected != 2 && expected != 3 {
            return Err(SequenceFileError::Dimension(expected));
        }
        for (portal, vertices) in self.portals.iter().enumerate() {
            if vertices.is_empty() {
                return Err(SequenceFileError::NoVertices(portal));
            }
            if let Some(vertex) = vertices.iter().position(|v| v.len() != expected) {
                let count = vertices[vertex].len();
                return Err(SequenceFileError::Coordinates { portal, vertex, count, expected });
            }
            if expected == 2 && vertices.len() != 2 {
                return Err(SequenceFileError::NotASegment { portal, count: vertices.len() });
            }
        }
        let ratio = |c: &Coordinate| c.0.to_rational();
        let all = self.portals.iter().flatten().flatten().map(ratio);
        let denominator = all.fold(Int::one(), |common, c| common.lcm(c.denom()));
        let scaled = |c: &Coordinate| (ratio(c) * Rational::from(denominator.clone())).to_integer();
        Ok(if expected == 3 {
            let point =
                |v: &Vec<Coordinate>| BigPoint3 { coordinates: [0, 1, 2].map(|i| scaled(&v[i])) };
            let portals = self.portals.iter().map(|p| p.iter().map(point).collect()).collect();
            SequencePoints::Space { denominator, portals }
        } else {
            let point =
                |v: &Vec<Coordinate>| BigPoint2 { coordinates: [0, 1].map(|i| scaled(&v[i])) };
            let portals = self.portals.iter().map(|p| [point(&p[0]), point(&p[1])]).collect();
            SequencePoints::Plane { denominator, portals }
        })
    }

    /// The JSON schema of the format.
    pub fn schema() -> serde_json::Value {
        schemars::schema_for!(SequenceFile).to_value()
    }
}
