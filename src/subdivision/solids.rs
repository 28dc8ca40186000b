//! From planes to polyhedra, and the box around them.

use super::{Hint, Options};
use crate::construct::{Bounds, PlaneId, PlaneSet, Polyhedron, SolidError};
use crate::geom::{BigPlane, RationalPoint3};
use crate::num::Int;
use num_integer::Integer;
use num_traits::{One, Signed};

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
    pub solids: Vec<Body>,
    pub hints: Vec<Hint>,
    /// The solids without.
    pub flat: Vec<usize>,
}

/// A solid with volume and the integer box around it.
pub(super) struct Body {
    pub solid: Polyhedron,
    pub low: [Int; 3],
    pub high: [Int; 3],
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
        let interned = half_spaces
            .iter()
            .enumerate()
            .map(|(plane, p)| planes.intern(p).ok_or(DivisionError::NoNormal { solid, plane }));
        ids.push(interned.collect::<Result<_, _>>()?);
    }
    let limits = limits(&mut planes);
    let (mut bodies, mut flat) = (Vec::new(), Vec::new());
    for (solid, half_spaces) in ids[..solids.len()].iter().enumerate() {
        match cut_out(&planes, &limits, half_spaces) {
            Ok(body) => bodies.push(body),
            Err(SolidError::Flat) => flat.push(solid),
            Err(SolidError::Unbounded) => return Err(DivisionError::Unbounded { solid }),
        }
    }
    let bounds = around(&mut planes, &bodies, &options.margin).ok_or(DivisionError::NoSolid)?;
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

/// Two boxes around everything bounded: one that is usually large enough, and one that always is.
///
/// With |n| < 2^a and |o| < 2^b a vertex has coordinates x/w with w >= 1 and |x| < 2^(2a+b+3):
/// what reaches past the second box has no end.
fn limits(planes: &mut PlaneSet) -> [Bounds; 2] {
    let (normal, offset) = planes.bits();
    let mut cube = |bits: u64| {
        let half = Int::one() << bits;
        Bounds::new(planes, &[0; 3].map(|_| -&half), &[0; 3].map(|_| half.clone()))
    };
    let sure = 2 * normal + offset + 3;
    [cube(USUAL_BITS.min(sure)), cube(sure)]
}

/// Levels seldom reach further, on a grid of whole units.
const USUAL_BITS: u64 = 18;

/// The polyhedron of half-spaces, from the first box that it does not touch.
fn cut_out(
    planes: &PlaneSet,
    limits: &[Bounds; 2],
    half_spaces: &[PlaneId],
) -> Result<Body, SolidError> {
    for bounds in limits {
        let Some(solid) = Polyhedron::of_half_spaces(planes, bounds, half_spaces) else {
            continue;
        };
        let ends = bounds.planes();
        if solid.faces().iter().all(|face| !ends.contains(&face.support())) {
            return Ok(Body::new(solid));
        }
        if bounds == &limits[1] {
            return Err(SolidError::Unbounded);
        }
    }
    Err(SolidError::Flat)
}

impl Body {
    fn new(solid: Polyhedron) -> Body {
        let points: Vec<RationalPoint3> = solid.faces().iter().flat_map(|f| f.points()).collect();
        let floor = |i: usize, p: &RationalPoint3| p.numerators()[i].div_floor(p.denominator());
        let ceil = |i: usize, p: &RationalPoint3| -(-&p.numerators()[i]).div_floor(p.denominator());
        let all = || points.iter();
        Body {
            low: [0, 1, 2].map(|i| all().map(|p| floor(i, p)).min().expect("it has vertices")),
            high: [0, 1, 2].map(|i| all().map(|p| ceil(i, p)).max().expect("it has vertices")),
            solid,
        }
    }

    /// Whether the boxes of two solids have a point in common.
    pub fn may_touch(&self, other: &Body) -> bool {
        (0..3).all(|i| self.low[i] <= other.high[i] && other.low[i] <= self.high[i])
    }
}

/// The box of all bodies and a margin, or `None` if there is none.
fn around(planes: &mut PlaneSet, bodies: &[Body], margin: &Int) -> Option<Bounds> {
    let margin = margin.abs().max(Int::one());
    let low = |i: usize| bodies.iter().map(|body| &body.low[i]).min();
    let high = |i: usize| bodies.iter().map(|body| &body.high[i]).max();
    let low = [low(0)? - &margin, low(1)? - &margin, low(2)? - &margin];
    let high = [high(0)? + &margin, high(1)? + &margin, high(2)? + &margin];
    Some(Bounds::new(planes, &low, &high))
}
