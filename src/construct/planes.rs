//! Planes by number: equal planes are one, and a plane's two directions differ in one bit.

use crate::geom::BigPlane;
use crate::num::{Int, Rational, Sign};
use crate::predicates::VertexPlane;
use num_integer::Integer;
use num_traits::Zero;
use rustc_hash::FxHashMap;

/// A directed plane of a [`PlaneSet`].
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct PlaneId(u32);

impl PlaneId {
    /// The same plane, positive on its other side.
    pub fn flipped(self) -> PlaneId {
        PlaneId(self.0 ^ 1)
    }

    /// The one of the plane's two directions whose first non-zero coefficient is positive.
    pub fn undirected(self) -> PlaneId {
        PlaneId(self.0 & !1)
    }
}

impl std::fmt::Debug for PlaneId {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "plane{}", self.0)
    }
}

/// Distinct planes, each in both directions.
///
/// Invariant: coefficients have no common factor, so that two ids are of one plane iff they are
/// equal or each other's flips.
#[derive(Clone, Debug, Default)]
pub struct PlaneSet {
    planes: Vec<VertexPlane>,
    ids: FxHashMap<BigPlane, PlaneId>,
}

impl PlaneSet {
    /// The id of a plane, new or known; `None` where the normal is zero.
    pub fn intern(&mut self, plane: &BigPlane) -> Option<PlaneId> {
        let leading = plane.normal.iter().find(|c| !c.is_zero())?;
        let negative = Sign::of(leading) == Sign::Negative;
        let mut divisor = plane.normal.iter().fold(plane.offset.clone(), |g, c| g.gcd(c));
        if negative {
            divisor = -divisor;
        }
        let normal = plane.normal.each_ref().map(|c| c / &divisor);
        let primitive = BigPlane { normal, offset: &plane.offset / &divisor };
        let next = PlaneId(self.planes.len() as u32);
        let id = *self.ids.entry(primitive).or_insert_with_key(|primitive| {
            let flipped = BigPlane {
                normal: primitive.normal.each_ref().map(|c| -c),
                offset: -&primitive.offset,
            };
            self.planes.push(VertexPlane::new(primitive.clone()));
            self.planes.push(VertexPlane::new(flipped));
            next
        });
        Some(if negative { id.flipped() } else { id })
    }

    /// The ids of some planes; the index of the first whose normal is zero, if one is.
    pub fn intern_all(&mut self, planes: &[BigPlane]) -> Result<Vec<PlaneId>, usize> {
        planes.iter().enumerate().map(|(i, plane)| self.intern(plane).ok_or(i)).collect()
    }

    /// The plane x = at, y = at or z = at, positive towards larger coordinates.
    pub fn axial(&mut self, axis: usize, at: &Rational) -> PlaneId {
        let mut normal = [Int::ZERO, Int::ZERO, Int::ZERO];
        normal[axis] = at.denom().clone();
        let plane = BigPlane { normal, offset: at.numer().clone() };
        self.intern(&plane).expect("the normal is not zero")
    }

    /// The plane of an id.
    pub fn get(&self, id: PlaneId) -> &VertexPlane {
        &self.planes[id.0 as usize]
    }

    /// The coefficients of an id's plane, without a common factor.
    pub fn plane(&self, id: PlaneId) -> &BigPlane {
        self.get(id).plane()
    }

    /// The least bits that hold the magnitudes of all normals' coordinates, and of all offsets.
    pub fn bits(&self) -> (u64, u64) {
        let all = || self.planes.iter().map(VertexPlane::plane);
        let normal = all().flat_map(|plane| &plane.normal).map(Int::bits).max();
        let offset = all().map(|plane| plane.offset.bits()).max();
        (normal.unwrap_or(0), offset.unwrap_or(0))
    }

    /// Whether the plane is perpendicular to an axis.
    pub fn is_axial(&self, id: PlaneId) -> bool {
        self.plane(id).normal.iter().filter(|c| c.is_zero()).count() == 2
    }
}
