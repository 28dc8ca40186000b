//! Worlds: what stands in space, before that space is divided into cells.
//!
//! A world is what a level's source, a JSON scene or a polygon soup comes to: solids and polygons
//! that occlude, hints that only split, detail objects that never occlude, and what tells which
//! part of space is asked about. All coordinates are world units.

use super::level::{Brush, Level, Role};
use crate::construct::{Limits, PlaneSet, Polygon};
use crate::geom::{AxialBox, BigPlane, RationalPoint3};
use std::collections::BTreeMap;

mod geometry;
mod polygons;
mod read;
mod snap;
mod soup;
#[cfg(test)]
mod tests;
mod warning;

pub use geometry::{StatementError, StatementErrorKind};
pub use read::{InputKind, WorldOptions, read_world, read_world_with};
pub use warning::{Repair, WorldWarning};

/// What stands in space.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct World {
    /// Convex solids that occlude. They may overlap, touch, and be without volume.
    pub solids: Vec<WorldSolid>,
    /// Planar, strictly convex polygons that occlude, seen from either side. They may cross and
    /// overlap each other and the solids.
    pub polygons: Vec<WorldPolygon>,
    /// Convex solids some of whose faces split cells.
    pub hints: Vec<WorldHint>,
    /// Detail objects: each its bounding box, which has volume.
    pub objects: Vec<Object>,
    /// Which part of the free space is asked about.
    pub inside: Inside,
    /// The box to be divided, where the input states one; otherwise one around everything.
    pub view: Option<AxialBox>,
}

/// Which empty leaves are cells.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Inside {
    /// All of them.
    Everywhere,
    /// Those that can be reached from marks. Unless the world states its `view`, a way from a mark
    /// to the boundary of the box is a leak.
    Reached(Vec<Mark>),
}

/// Where the input states something, for messages.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// What it is called.
    pub name: String,
    /// Its line in the file, counted from 1, where that is known.
    pub line: Option<usize>,
}

impl std::fmt::Display for Place {
    /// ``line 7: `name` `` or `` `name` ``.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        if let Some(line) = self.line {
            write!(f, "line {line}: ")?;
        }
        write!(f, "`{}`", self.name.escape_debug())
    }
}

/// A convex solid: the intersection of the negative sides of its planes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WorldSolid {
    /// The planes, outward.
    pub planes: Vec<BigPlane>,
    /// Where it is stated.
    pub place: Place,
}

/// A polygon that occludes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WorldPolygon {
    /// Three vertices or more, in one plane, strictly convex.
    pub vertices: Vec<RationalPoint3>,
    /// Where it is stated.
    pub place: Place,
}

/// A solid some of whose faces split cells.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WorldHint {
    /// The planes, outward.
    pub planes: Vec<BigPlane>,
    /// For each plane whether its face splits.
    pub splits: Vec<bool>,
}

/// A detail object.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Object {
    /// Its bounding box, which has volume.
    pub bounds: AxialBox,
    /// Where it is stated.
    pub place: Place,
}

/// A point that marks the inside.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mark {
    /// The point.
    pub point: RationalPoint3,
    /// Where it is stated.
    pub place: Place,
}

impl World {
    /// What a level means: its solids occlude, its hints split, entities without brushes mark the
    /// inside.
    ///
    /// Each brush entity other than the world is one detail object; detail brushes of the world
    /// (and of its groups) are one each.
    pub fn of_level(level: &Level) -> World {
        let of_role = |role| level.brushes.iter().filter(move |brush| brush.role == role);
        let planes = |brush: &Brush| brush.faces.iter().map(|face| face.plane.clone()).collect();
        let class = |entity: usize| level.entities[entity].class.clone();
        let place = |brush: &Brush| Place { name: class(brush.entity), line: Some(brush.line) };
        let solid = |brush| WorldSolid { planes: planes(brush), place: place(brush) };
        let hint = |brush: &Brush| WorldHint {
            planes: planes(brush),
            splits: brush.faces.iter().map(|face| face.splits).collect(),
        };
        let marks = level.entities.iter().filter(|entity| entity.is_point).filter_map(|entity| {
            let place = Place { name: entity.class.clone(), line: Some(entity.line) };
            Some(Mark { point: entity.origin.clone()?, place })
        });
        World {
            solids: of_role(Role::Solid).map(solid).collect(),
            polygons: Vec::new(),
            hints: of_role(Role::Hint).map(hint).collect(),
            objects: objects(level),
            inside: Inside::Reached(marks.collect()),
            view: None,
        }
    }

    /// The points that mark the inside.
    pub fn marks(&self) -> &[Mark] {
        match &self.inside {
            Inside::Everywhere => &[],
            Inside::Reached(marks) => marks,
        }
    }
}

/// The detail objects of a level, by entity, then by brush.
fn objects(level: &Level) -> Vec<Object> {
    let mut planes = PlaneSet::default();
    let detail = || level.brushes.iter().filter(|brush| brush.role == Role::Detail);
    let ids: Vec<_> = detail()
        .map(|brush| {
            let all: Vec<BigPlane> = brush.faces.iter().map(|face| face.plane.clone()).collect();
            planes.intern_all(&all).expect("a brush's planes have normals")
        })
        .collect();
    let limits = Limits::new(&mut planes);
    let mut boxes: BTreeMap<(usize, usize), Object> = BTreeMap::new();
    for (brush, ids) in detail().zip(&ids) {
        let body = limits.cut_out(&planes, ids).expect("a brush is bounded and has volume");
        let points: Vec<_> = body.solid.faces().iter().flat_map(Polygon::points).collect();
        let bounds = AxialBox::around(&points).expect("a solid has vertices");
        let entity = &level.entities[brush.entity];
        let (own, line) = match entity.is_structure {
            true => (brush.line, brush.line),
            false => (0, entity.line),
        };
        let place = Place { name: entity.class.clone(), line: Some(line) };
        let known = boxes.remove(&(brush.entity, own));
        let bounds = known.map_or(bounds.clone(), |object| object.bounds.and(&bounds));
        boxes.insert((brush.entity, own), Object { bounds, place });
    }
    boxes.into_values().collect()
}
