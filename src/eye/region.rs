//! The part of a portal that an eye sees: the portal's plane cut by the cone of directions.

use super::Cone;
use super::view::View;
use crate::geom::RationalPoint3;
use crate::num::{Int, Rational};
use crate::scene::{CellId, PortalId};

/// What is seen of the last portal of a sequence.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Region {
    /// The sequence.
    pub portals: Vec<PortalId>,
    /// The cell behind it.
    pub cell: CellId,
    /// A convex polygon of positive area in the last portal, counter-clockwise as seen from the
    /// side to which the eye looks.
    pub polygon: Vec<RationalPoint3>,
    /// The square of twice the polygon's area.
    pub doubled_area_squared: Rational,
}

impl Region {
    pub(super) fn new(view: &View, portals: &[usize], cell: CellId, cone: &Cone) -> Region {
        let last = portals[portals.len() - 1];
        // The cone is inside the last portal's, so each of its rays crosses the portal's plane.
        let polygon: Vec<_> = cone.rays().map(|ray| view.meet(last, ray.exact())).collect();
        let doubled_area_squared = doubled_area_squared(&polygon);
        let portals = portals.iter().map(|&portal| PortalId(portal as u32)).collect();
        Region { portals, cell, polygon, doubled_area_squared }
    }
}

/// |Σ v_i x v_(i+1)|², the square of twice the area of a planar polygon.
fn doubled_area_squared(polygon: &[RationalPoint3]) -> Rational {
    let zero = || Rational::from(Int::ZERO);
    let mut area = [zero(), zero(), zero()];
    for (a, b) in polygon.iter().zip(polygon.iter().cycle().skip(1)) {
        let (p, q) = (a.numerators(), b.numerators());
        let scale = a.denominator() * b.denominator();
        for (sum, (i, j)) in area.iter_mut().zip([(1, 2), (2, 0), (0, 1)]) {
            *sum += Rational::new(&p[i] * &q[j] - &p[j] * &q[i], scale.clone());
        }
    }
    area.iter().map(|c| c * c).sum()
}
