//! Carr's traversal (Computation of potentially visible set for occluded three-dimensional
//! environments, 2004: the frustum is clipped against each portal on the way) in floats.
//!
//! **It never misses a cell that the exact search reaches.** A [`FloatCone`] stands for an exact
//! set: the intersection of the half-spaces of some of the planes that the exact cone is clipped
//! by. A plane clips only where the floats prove on which side of it every ray is; otherwise it is
//! left out, which leaves the set larger. A cone is given up only where every ray is proved to be
//! on the negative side or in the plane. Its rays are meets of these planes, as the exact cone's
//! are, so their errors do not add up along a sequence.

use super::cone::clipped;
use crate::num::Sign;
use crate::predicates::{Direction, FloatVector};
use std::rc::Rc;

/// A cone that holds the exact one; see the module.
#[derive(Clone, Debug)]
pub struct FloatCone {
    /// Each face's first ray and its normal, as in [`super::Cone`].
    faces: Vec<[FloatVector; 2]>,
}

impl FloatCone {
    /// The cone over a convex polygon; see [`super::Cone::over`].
    pub fn over(rays: &[Rc<Direction>], planes: &[Rc<Direction>]) -> FloatCone {
        let faces = rays.iter().zip(planes).map(|(ray, plane)| [*ray.float(), *plane.float()]);
        FloatCone { faces: faces.collect() }
    }

    /// Keeps at least what is on the positive side of a plane; false where that is proved empty.
    #[must_use]
    pub fn clip(&mut self, plane: &FloatVector) -> bool {
        let sides: Option<Vec<Sign>> = self.faces.iter().map(|[ray, _]| plane.side(ray)).collect();
        let Some(sides) = sides else { return true };
        if !sides.contains(&Sign::Negative) {
            return true;
        }
        if !sides.contains(&Sign::Positive) {
            return false;
        }
        self.faces = clipped(
            &self.faces,
            &sides,
            |[_, side]| [side.cross(plane), *plane],
            |[ray, _]| [*ray, *plane],
            |[_, side]| [plane.cross(side), *side],
        );
        true
    }
}
