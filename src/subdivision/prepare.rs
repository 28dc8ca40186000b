//! From planes and points to polyhedra and polygons, and the box around them.

use super::{Face, Occluders, Options, Source};
use crate::construct::{
    Bounds, IntegerBox, Limits, PlaneId, PlaneSet, Polygon, PolygonError, Polyhedron, SolidError,
    polygon_of_points,
};

/// Why space cannot be divided.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum DivisionError {
    /// A plane without a direction.
    #[error("solid {solid}: the normal of plane {plane} is zero")]
    NoNormal {
        /// The solid, counted from 0; hints come after the solids.
        solid: usize,
        /// The plane, counted from 0.
        plane: usize,
    },
    /// A solid without an end.
    #[error("solid {solid}: {}", SolidError::Unbounded)]
    Unbounded {
        /// The solid, counted from 0.
        solid: usize,
    },
    /// A polygon that is none.
    #[error("polygon {polygon}: {error}")]
    Polygon {
        /// The polygon, counted from 0.
        polygon: usize,
        /// What is wrong with it.
        error: PolygonError,
    },
    /// A view that holds nothing.
    #[error("the view has no volume")]
    FlatView,
    /// Nothing to take the bounds of.
    #[error("nothing occludes and no view is stated: expected a solid with volume or a polygon")]
    NothingToDivide,
    /// The work was told to stop.
    #[error("interrupted")]
    Interrupted,
}

/// A solid with volume, as far as it is in the box.
pub(super) struct Body {
    /// The solid's number.
    pub index: u32,
    pub solid: Polyhedron,
    /// A box around all of it.
    pub around: IntegerBox,
}

/// What the tree is built from.
pub(super) struct Prepared {
    pub planes: PlaneSet,
    pub bounds: Bounds,
    pub bodies: Vec<Body>,
    /// The thin polygons in the box.
    pub sheets: Vec<Face>,
    /// The faces of hints that split.
    pub hints: Vec<Face>,
    /// The solids without volume.
    pub flat: Vec<usize>,
}

/// Interns all planes, cuts out all solids and hints, and all polygons.
pub(super) fn prepare(occluders: &Occluders, options: &Options) -> Result<Prepared, DivisionError> {
    let Occluders { solids, polygons, hints, view } = occluders;
    let mut planes = PlaneSet::default();
    let all = solids.iter().chain(hints.iter().map(|hint| &hint.planes));
    let mut ids: Vec<Vec<PlaneId>> = Vec::with_capacity(solids.len() + hints.len());
    for (solid, half_spaces) in all.enumerate() {
        let interned = planes.intern_all(half_spaces);
        ids.push(interned.map_err(|plane| DivisionError::NoNormal { solid, plane })?);
    }
    let limits = Limits::new(&mut planes);
    let (mut bodies, mut flat) = (Vec::new(), Vec::new());
    for (solid, half_spaces) in ids[..solids.len()].iter().enumerate() {
        match limits.cut_out(&planes, half_spaces) {
            Ok(body) => {
                bodies.push(Body { index: solid as u32, solid: body.solid, around: body.around });
            }
            Err(SolidError::Flat) => flat.push(solid),
            Err(SolidError::Unbounded) => return Err(DivisionError::Unbounded { solid }),
        }
    }
    let mut sheets = Vec::with_capacity(polygons.len());
    let mut around_sheets = Vec::with_capacity(polygons.len());
    for (polygon, points) in polygons.iter().enumerate() {
        let made = polygon_of_points(&mut planes, points);
        sheets.push(made.map_err(|error| DivisionError::Polygon { polygon, error })?);
        around_sheets.extend(IntegerBox::around(points));
    }
    let around = match view {
        Some(view) if !view.has_volume() => return Err(DivisionError::FlatView),
        Some(view) => view.clone(),
        None => {
            let all = bodies.iter().map(|body| &body.around).chain(&around_sheets);
            let around = IntegerBox::of_all(all, &options.margin);
            around.ok_or(DivisionError::NothingToDivide)?
        }
    };
    let bounds = Bounds::new(&mut planes, &around);
    if view.is_some() {
        bodies.retain_mut(|body| {
            body.around.is_in(&around) || {
                let half_spaces = &ids[body.index as usize];
                let clipped = Polyhedron::of_half_spaces(&planes, &bounds, half_spaces);
                clipped.map(|clipped| body.solid = clipped).is_some()
            }
        });
    }
    let hints = faces_of_hints(&planes, &bounds, occluders, &ids[solids.len()..]);
    let sheets = sheets.into_iter().enumerate().filter_map(|(index, polygon)| {
        let polygon = bounds.clip(&planes, polygon)?;
        Some(Face { polygon, source: Source::Polygon(index as u32), thin: true })
    });
    let sheets = sheets.collect();
    Ok(Prepared { planes, bounds, bodies, sheets, hints, flat })
}

/// The faces of hints that split, as far as they are in the box.
fn faces_of_hints(
    planes: &PlaneSet,
    bounds: &Bounds,
    occluders: &Occluders,
    ids: &[Vec<PlaneId>],
) -> Vec<Face> {
    let mut faces = Vec::new();
    for (index, (half_spaces, hint)) in ids.iter().zip(&occluders.hints).enumerate() {
        let Some(body) = Polyhedron::of_half_spaces(planes, bounds, half_spaces) else {
            continue;
        };
        let splits = |face: &&Polygon| {
            let plane = face.support();
            let at_the_end = bounds.planes().contains(&plane);
            let own = half_spaces.iter().zip(&hint.splits);
            !at_the_end && own.into_iter().any(|(&own, &splits)| own == plane && splits)
        };
        let face = |polygon: &Polygon| Face {
            polygon: polygon.clone(),
            source: Source::Hint(index as u32),
            thin: true,
        };
        faces.extend(body.faces().iter().filter(splits).map(face));
    }
    faces
}
