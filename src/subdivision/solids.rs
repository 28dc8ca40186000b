//! From planes to polyhedra, and the box around them.

use super::{Hint, Options};
use crate::construct::{Bounds, Boxed, Limits, PlaneId, PlaneSet, Polyhedron, SolidError};
use crate::geom::BigPlane;

/// The intersection of the negative sides of planes.
pub type Solid = Vec<BigPlane>;

/// Why a set of solids cannot be divided.
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
    /// Nothing to take the bounds of.
    #[error("no solid encloses volume, expected one or more")]
    NoSolid,
}

/// What the tree is built from.
pub(super) struct Prepared {
    pub planes: PlaneSet,
    pub bounds: Bounds,
    /// The solids with volume, in order.
    pub solids: Vec<Boxed>,
    pub hints: Vec<Hint>,
    /// The solids without.
    pub flat: Vec<usize>,
}

/// Interns all planes and cuts out all solids and hints.
pub(super) fn prepare(
    solids: &[Solid],
    hints: &[(Solid, Vec<bool>)],
    options: &Options,
) -> Result<Prepared, DivisionError> {
    let mut planes = PlaneSet::default();
    let all = solids.iter().chain(hints.iter().map(|(solid, _)| solid));
    let mut ids: Vec<Vec<PlaneId>> = Vec::with_capacity(solids.len() + hints.len());
    for (solid, half_spaces) in all.enumerate() {
        let interned = planes.intern_all(half_spaces);
        ids.push(interned.map_err(|plane| DivisionError::NoNormal { solid, plane })?);
    }
    let limits = Limits::new(&mut planes);
    let (mut bodies, mut flat) = (Vec::new(), Vec::new());
    for (solid, half_spaces) in ids[..solids.len()].iter().enumerate() {
        match limits.cut_out(&planes, half_spaces) {
            Ok(body) => bodies.push(body),
            Err(SolidError::Flat) => flat.push(solid),
            Err(SolidError::Unbounded) => return Err(DivisionError::Unbounded { solid }),
        }
    }
    let bounds = Bounds::around(&mut planes, &bodies, &options.margin);
    let bounds = bounds.ok_or(DivisionError::NoSolid)?;
    let mut faces = Vec::new();
    for (half_spaces, (_, splits)) in ids[solids.len()..].iter().zip(hints) {
        let Some(hint) = Polyhedron::of_half_spaces(&planes, &bounds, half_spaces) else {
            continue;
        };
        let splits = |plane: PlaneId| {
            half_spaces.iter().zip(splits).any(|(&own, &splits)| own == plane && splits)
        };
        faces.extend(hint.faces().iter().filter(|face| splits(face.support())).cloned());
    }
    Ok(Prepared { planes, bounds, solids: bodies, hints: faces, flat })
}
