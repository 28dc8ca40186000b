//! An axial box with integer corners, from which planes are cut to polygons.

use super::{PlaneId, PlaneSet, Polygon, Polyhedron};
use crate::num::{Int, Sign};
use num_traits::Signed;

/// A box: its six planes, outward, those of low coordinates first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bounds {
    low: [PlaneId; 3],
    high: [PlaneId; 3],
}

impl Bounds {
    /// The box from `low` to `high`.
    ///
    /// # Panics
    /// If `low` is not below `high` on every axis.
    pub fn new(planes: &mut PlaneSet, low: &[Int; 3], high: &[Int; 3]) -> Bounds {
        assert!(low.iter().zip(high).all(|(l, h)| l < h), "a box without volume");
        Bounds {
            low: [0, 1, 2].map(|i| planes.axial(i, low[i].clone()).flipped()),
            high: [0, 1, 2].map(|i| planes.axial(i, high[i].clone())),
        }
    }

    /// The six planes, outward.
    pub fn planes(&self) -> [PlaneId; 6] {
        let ([a, b, c], [d, e, f]) = (self.low, self.high);
        [a, b, c, d, e, f]
    }

    /// What of a plane lies in the box; `None` where that has no area.
    pub fn section(&self, planes: &PlaneSet, support: PlaneId) -> Option<Polygon> {
        let (axis, polygon) = self.prism_section(planes, support);
        polygon.inside(planes, self.low[axis])?.inside(planes, self.high[axis])
    }

    /// The plane within the four sides of the box parallel to the axis that its normal is nearest
    /// to: these sides it always crosses.
    fn prism_section(&self, planes: &PlaneSet, support: PlaneId) -> (usize, Polygon) {
        let normal = &planes.plane(support).normal;
        let longer = |a: usize, b: usize| if normal[b].abs() > normal[a].abs() { b } else { a };
        let axis = longer(longer(0, 1), 2);
        let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
        // Counter-clockwise as seen from the end of the axis, with i to the right and j up.
        let mut cuts = [self.low[j], self.high[i], self.high[j], self.low[i]];
        match Sign::of(&normal[axis]) {
            Sign::Negative => cuts.reverse(),
            Sign::Zero => unreachable!("the longest coordinate of a normal is not zero"),
            Sign::Positive => {}
        }
        (axis, Polygon::new(planes, support, &cuts))
    }

    /// The box itself.
    pub fn polyhedron(&self, planes: &PlaneSet) -> Polyhedron {
        let faces = self.planes().map(|plane| self.prism_section(planes, plane).1);
        Polyhedron::new(faces.into())
    }
}
