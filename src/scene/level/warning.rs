//! What a level's reader repaired or left out, and where.

use crate::num::Rational;

/// Something of a level that was repaired or left out.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LevelWarning {
    /// The line of the file, counted from 1.
    pub line: usize,
    /// The entity, counted from 0.
    pub entity: usize,
    /// The entity's class.
    pub class: String,
    /// The brush within its entity, counted from 0, where a brush is concerned.
    pub brush: Option<usize>,
    /// What was found, and what was done.
    pub kind: LevelWarningKind,
}

impl std::fmt::Display for LevelWarning {
    /// `line 7: entity 0 (worldspawn), brush 3: what was found; what was done`.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "line {}: entity {}", self.line, self.entity)?;
        if !self.class.is_empty() {
            write!(f, " ({})", self.class.escape_debug())?;
        }
        if let Some(brush) = self.brush {
            write!(f, ", brush {brush}")?;
        }
        write!(f, ": {}", self.kind)
    }
}

/// The oddities of a level. Faces count from 0 within their brush, as the file lists them.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum LevelWarningKind {
    /// An entity without a class.
    #[error("no `classname`; the entity is a detail object")]
    NoClass,
    /// Coordinates of faces with too many decimals; this is the first such face.
    #[error(
        "{count} coordinates of faces, from here on, have more than {decimals} decimals; each is \
         rounded to these, by {largest} at most"
    )]
    Rounded {
        /// How many are kept.
        decimals: u32,
        /// How many.
        count: usize,
        /// The largest displacement.
        largest: Rational,
    },
    /// An origin that is not three numbers.
    #[error("origin `{0}` is not three numbers; the entity has none")]
    Origin(String),
    /// A curved surface.
    #[error("`{0}` is a curved surface; it is left out")]
    Patch(String),
    /// Faces whose textures ask for different roles.
    #[error("some faces are {0}, others are not; the whole brush is taken as {0}")]
    MixedFaces(&'static str),
    /// A brush of the structure without a face that is drawn.
    #[error("no face is drawn, by their textures; the brush is a wall all the same")]
    UndrawnWall,
    /// Three points that give no plane.
    #[error("the three points of face {face} are on one line; the face is left out")]
    CollinearPoints {
        /// The face.
        face: usize,
    },
    /// Two faces in one plane.
    #[error("face {face} has the plane of face {first}; it is left out")]
    SamePlane {
        /// The face.
        face: usize,
        /// The face that has the plane already.
        first: usize,
    },
    /// A face that the others cut away.
    #[error("face {face} has no area left by the other faces; it is left out")]
    CutAway {
        /// The face.
        face: usize,
    },
    /// Planes that enclose nothing.
    #[error("{0}; the brush is left out")]
    NoSolid(NoSolid),
}

/// Why planes enclose no solid.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NoSolid {
    /// Fewer planes than a tetrahedron has.
    #[error("{0} distinct planes, expected four or more")]
    TooFewPlanes(usize),
    /// The planes leave a way to infinity.
    #[error("the planes do not close it")]
    Open,
    /// What the planes have in common is flat or empty.
    #[error("the planes leave it no volume")]
    NoVolume,
}
