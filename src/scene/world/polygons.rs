//! Polygons of an input to polygons of a world: planar, strictly convex, each once.

use super::snap::Snap;
use super::warning::{Repair, Repairs};
use super::{Place, WorldPolygon};
use crate::geom::RationalPoint3;
use crate::scene::SceneErrorKind;
use crate::scene::build::shape_alone;
use crate::scene::polygon::Pieces;
use rustc_hash::{FxHashMap, FxHashSet};

/// What an input's polygons are, besides where they are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Source {
    /// Polygons that somebody stated one by one: one without area is an error.
    Stated,
    /// Polygon soup: what has no area, or is there already, is left out and counted.
    Soup,
}

/// Polygons being collected.
pub(super) struct Collector<'s> {
    pub polygons: Vec<WorldPolygon>,
    source: Source,
    snap: Option<&'s mut Snap>,
    vertices: Vec<RationalPoint3>,
    indices: FxHashMap<RationalPoint3, u32>,
    known: FxHashSet<Vec<u32>>,
}

impl<'s> Collector<'s> {
    pub fn new(source: Source, snap: Option<&'s mut Snap>) -> Collector<'s> {
        Collector {
            polygons: Vec::new(),
            source,
            snap,
            vertices: Vec::new(),
            indices: FxHashMap::default(),
            known: FxHashSet::default(),
        }
    }

    /// Adds what the outline encloses.
    ///
    /// # Errors
    /// The outline crosses or touches itself, or takes too fine a grid; without area where
    /// polygons are stated one by one.
    pub fn add(
        &mut self,
        outline: &[RationalPoint3],
        place: &Place,
        repairs: &mut Repairs,
    ) -> Result<(), SceneErrorKind> {
        let exact = match self.shape(outline) {
            Err(error) if self.source == Source::Soup && is_flat(&error) => {
                repairs.add(Repair::Flat, 1, Some(place));
                return Ok(());
            }
            shaped => shaped?,
        };
        if self.snap.is_none() {
            self.keep(exact, place, repairs);
            return Ok(());
        }
        match self.snapped(outline) {
            Ok(shaped) => self.keep(shaped, place, repairs),
            Err(error) if is_flat(&error) => {
                repairs.add(Repair::FlattenedPolygon, 1, Some(place));
            }
            // Rounding made the outline touch itself; a triangle never does.
            Err(_) => self.snap_triangles(exact, place, repairs),
        }
        Ok(())
    }

    fn snapped(&mut self, outline: &[RationalPoint3]) -> Result<Shaped, SceneErrorKind> {
        let Some(snap) = &mut self.snap else { return self.shape(outline) };
        let rounded: Vec<RationalPoint3> = outline.iter().map(|p| snap.point(p)).collect();
        self.shape(&rounded)
    }

    fn snap_triangles(&mut self, exact: Shaped, place: &Place, repairs: &mut Repairs) {
        let corner = |&corner: &u32| self.vertices[corner as usize].clone();
        let triangles: Vec<Vec<RationalPoint3>> =
            exact.triangles().iter().map(|t| t.iter().map(corner).collect()).collect();
        repairs.add(Repair::Skew, 1, Some(place));
        for triangle in triangles {
            match self.snapped(&triangle) {
                Ok(shaped) => self.keep(shaped, place, repairs),
                Err(_) => repairs.add(Repair::FlattenedPolygon, 1, Some(place)),
            }
        }
    }

    fn shape(&mut self, outline: &[RationalPoint3]) -> Result<Shaped, SceneErrorKind> {
        let mut corners = Vec::with_capacity(outline.len());
        for point in outline {
            let next = self.vertices.len() as u32;
            corners.push(*self.indices.entry(point.clone()).or_insert_with_key(|point| {
                self.vertices.push(point.clone());
                next
            }));
        }
        let mut repairs = super::super::Repairs::default();
        let pieces = shape_alone(&self.vertices, corners, &mut repairs)?;
        let repeated = repairs.repeated_vertices as usize;
        Ok(Shaped { pieces, repeated, collinear: repairs.collinear_vertices as usize })
    }

    fn keep(&mut self, shaped: Shaped, place: &Place, repairs: &mut Repairs) {
        repairs.add(Repair::RepeatedVertex, shaped.repeated, Some(place));
        repairs.add(Repair::CollinearVertex, shaped.collinear, Some(place));
        let pieces = match shaped.pieces {
            Pieces::Convex(polygon) => vec![polygon],
            Pieces::Skew(triangles) => {
                repairs.add(Repair::Skew, 1, Some(place));
                triangles.into_iter().map(Vec::from).collect()
            }
            Pieces::Dented(triangles) => {
                repairs.add(Repair::Dented, 1, Some(place));
                triangles.into_iter().map(Vec::from).collect()
            }
        };
        for corners in pieces {
            // In convex position, the vertices alone tell a polygon, whichever way around.
            let mut set = corners.clone();
            set.sort_unstable();
            if self.source == Source::Soup && !self.known.insert(set) {
                repairs.add(Repair::Duplicate, 1, Some(place));
                continue;
            }
            let vertices = corners.iter().map(|&c| self.vertices[c as usize].clone()).collect();
            self.polygons.push(WorldPolygon { vertices, place: place.clone() });
        }
    }
}

fn is_flat(error: &SceneErrorKind) -> bool {
    matches!(error, SceneErrorKind::ZeroArea | SceneErrorKind::TooFewVertices(_))
}

/// An outline in planar, convex pieces.
struct Shaped {
    pieces: Pieces,
    repeated: usize,
    collinear: usize,
}

impl Shaped {
    fn triangles(&self) -> Vec<[u32; 3]> {
        match &self.pieces {
            Pieces::Convex(polygon) => {
                polygon[1..].windows(2).map(|pair| [polygon[0], pair[0], pair[1]]).collect()
            }
            Pieces::Skew(triangles) | Pieces::Dented(triangles) => triangles.clone(),
        }
    }
}
