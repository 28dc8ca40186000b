//! What a reader of worlds repaired or left out.

use super::Place;
use crate::num::Rational;
use crate::scene::level::LevelWarning;

/// Something of an input that was repaired or left out.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum WorldWarning {
    /// Of a level's source.
    Level(LevelWarning),
    /// One kind of repair, however often it was made.
    Repaired {
        /// What was found, and what was done.
        repair: Repair,
        /// How often.
        count: usize,
        /// Where first, if the input has places.
        first: Option<Place>,
    },
    /// Coordinates were rounded, as asked for.
    Snapped {
        /// How many were moved.
        count: usize,
        /// How far at most.
        largest: Rational,
    },
}

impl std::fmt::Display for WorldWarning {
    /// One line.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            WorldWarning::Level(warning) => warning.fmt(f),
            WorldWarning::Repaired { repair, count, first: Some(first) } => {
                write!(f, "{first}: {repair}; {count} in all")
            }
            WorldWarning::Repaired { repair, count, first: None } => {
                write!(f, "{repair}; {count} in all")
            }
            WorldWarning::Snapped { count, largest } => {
                write!(f, "{count} coordinates rounded, by {largest} at most")
            }
        }
    }
}

/// What is found in inputs, and what is done with it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, thiserror::Error)]
pub enum Repair {
    /// A vertex equal to the one before it.
    #[error("a vertex is repeated; one is left out")]
    RepeatedVertex,
    /// A vertex on the line through its neighbours.
    #[error("a vertex is between its neighbours on one line; it is left out")]
    CollinearVertex,
    /// A polygon whose vertices are not in one plane.
    #[error("a polygon is not planar; it is cut into triangles")]
    Skew,
    /// A planar polygon that is not convex.
    #[error("a polygon is not convex; it is cut into triangles")]
    Dented,
    /// A polygon of a soup without area.
    #[error("a polygon has no area; it is left out")]
    Flat,
    /// A polygon with the vertices of another.
    #[error("a polygon has the vertices of one before it; it is left out")]
    Duplicate,
    /// A polygon that had area before its vertices were rounded.
    #[error("a polygon has no area once rounded; it is left out")]
    FlattenedPolygon,
    /// A solid or a box that had volume before it was rounded.
    #[error("a solid has no volume once rounded; it is left out")]
    FlattenedSolid,
    /// A plane that cuts nothing off, or is another once more.
    #[error("a plane of a brush holds no face of it; it is left out")]
    RedundantPlane,
    /// A part of an expression without volume.
    #[error("a shape of an expression has no volume; it holds nothing")]
    FlatShape,
    /// A primitive of a glTF file.
    #[error("points or lines, which occlude nothing, are left out")]
    NoSurface,
    /// A mesh of a glTF file.
    #[error("a mesh has a skin or morph targets; it is taken at rest")]
    Deformed,
}

/// Repairs being counted.
#[derive(Clone, Debug, Default)]
pub(super) struct Repairs {
    counts: std::collections::BTreeMap<Repair, (usize, Option<Place>)>,
}

impl Repairs {
    /// Counts repairs at one place.
    pub fn add(&mut self, repair: Repair, count: usize, place: Option<&Place>) {
        if count > 0 {
            let entry = self.counts.entry(repair).or_insert_with(|| (0, place.cloned()));
            entry.0 += count;
        }
    }

    /// One warning for each kind, in a fixed order.
    pub fn into_warnings(self) -> impl Iterator<Item = WorldWarning> {
        let warning = |(repair, (count, first))| WorldWarning::Repaired { repair, count, first };
        self.counts.into_iter().map(warning)
    }
}
