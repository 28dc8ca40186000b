//! An axial box, from which planes are cut to polygons.

use super::{PlaneId, PlaneSet, Polygon, Polyhedron};
use crate::geom::AxialBox;
use crate::num::{Rational, Sign};
use num_traits::Signed;

/// A box: its six planes, outward, those of low coordinates first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bounds {
    low: [PlaneId; 3],
    high: [PlaneId; 3],
}

impl Bounds {
    /// The planes of a box.
    ///
    /// # Panics
    /// If the box has no volume.
    pub fn new(planes: &mut PlaneSet, around: &AxialBox) -> Bounds {
        assert!(around.has_volume(), "a box without volume");
        Bounds {
            low: [0, 1, 2].map(|i| planes.axial(i, &around.low[i]).flipped()),
            high: [0, 1, 2].map(|i| planes.axial(i, &around.high[i])),
        }
    }

    /// The box behind six planes.
    ///
    /// Requires: they are perpendicular to the axes in order, point outwards and enclose volume.
    pub fn of_planes(low: [PlaneId; 3], high: [PlaneId; 3]) -> Bounds {
        Bounds { low, high }
    }

    /// The box by its corners.
    pub fn corners(&self, planes: &PlaneSet) -> AxialBox {
        let offset = |plane: PlaneId, axis: usize| {
            let plane = planes.plane(plane);
            Rational::new(plane.offset.clone(), plane.normal[axis].clone())
        };
        AxialBox {
            low: [0, 1, 2].map(|i| offset(self.low[i], i)),
            high: [0, 1, 2].map(|i| offset(self.high[i], i)),
        }
    }

    /// What of a polygon lies in the box; `None` where that has no area, or lies in its boundary.
    pub fn clip(&self, planes: &PlaneSet, polygon: Polygon) -> Option<Polygon> {
        let sides = self.planes();
        if sides.iter().any(|side| side.undirected() == polygon.support().undirected()) {
            return None;
        }
        sides.into_iter().try_fold(polygon, |rest, side| rest.inside(planes, side))
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
