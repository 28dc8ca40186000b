//! The directions in which an eye sees through portals: an open convex polygonal cone.
//!
//! The cone is a cycle of planes through the eye and of the rays in which neighbours meet. A ray is
//! a vertex's direction or the meet of the planes on its two sides, never a combination of rays,
//! so that degrees stay bounded however often a cone is clipped. Every plane is one that was given:
//! a portal's edge with the eye, a side of the frustum, an order of crossing.
//!
//! Invariants: three or more faces; the cone has an interior; the ray of a face and the ray of the
//! next one have the face's normal as their cross product, up to a positive factor; the inside is
//! on the positive side of every face.
//!
//! Complexity: linear in the number of faces for each clip.

use crate::num::{Int, Sign};
use crate::predicates::{Direction, side_of_direction};
use num_integer::Integer;
use num_traits::Signed;
use std::rc::Rc;

/// An open pointed convex cone with an interior.
#[derive(Clone, Debug)]
pub struct Cone {
    faces: Vec<Face>,
}

/// A side of a cone.
#[derive(Clone, Debug)]
struct Face {
    /// Where it meets the face before it.
    ray: Rc<Direction>,
    /// Its normal, towards the inside.
    plane: Rc<Direction>,
}

impl Cone {
    /// The cone over a convex polygon whose vertices have these directions, `planes[i]` spanned by
    /// the directions i and i + 1.
    pub fn over(rays: &[Rc<Direction>], planes: &[Rc<Direction>]) -> Cone {
        let face =
            |(ray, plane): (&Rc<_>, &Rc<_>)| Face { ray: Rc::clone(ray), plane: Rc::clone(plane) };
        Cone { faces: rays.iter().zip(planes).map(face).collect() }
    }

    /// The cone between planes, each of which meets the next one in a ray of the cone.
    pub fn between(planes: &[Rc<Direction>]) -> Cone {
        let count = planes.len();
        let ray =
            |i: usize| Rc::new(Direction::cross(&planes[(i + count - 1) % count], &planes[i]));
        let face = |i: usize| Face { ray: ray(i), plane: Rc::clone(&planes[i]) };
        Cone { faces: (0..count).map(face).collect() }
    }

    /// The extreme rays, in their cyclic order.
    pub fn rays(&self) -> impl Iterator<Item = &Rc<Direction>> {
        self.faces.iter().map(|face| &face.ray)
    }

    /// The planes of the faces, positive inside.
    pub fn planes(&self) -> impl Iterator<Item = &Rc<Direction>> {
        self.faces.iter().map(|face| &face.plane)
    }

    /// Keeps what is on the positive side of a plane; false where nothing with an interior is.
    #[must_use]
    pub fn clip(&mut self, plane: &Rc<Direction>) -> bool {
        let sides: Vec<Sign> = self.rays().map(|ray| side_of_direction(plane, ray)).collect();
        if !sides.contains(&Sign::Negative) {
            // A ray in the plane does not matter: the cone is open, and all of it is inside.
            return true;
        }
        if !sides.contains(&Sign::Positive) {
            // What is left lies in the plane: such directions graze (semantics, the verdicts).
            return false;
        }
        let meet = |a: &Rc<_>, b: &Rc<_>| Rc::new(Direction::cross(a, b));
        let of_plane = |ray| Face { ray, plane: Rc::clone(plane) };
        self.faces = clipped(
            &self.faces,
            &sides,
            |face| of_plane(meet(&face.plane, plane)),
            |face| of_plane(Rc::clone(&face.ray)),
            |face| Face { ray: meet(plane, &face.plane), plane: Rc::clone(&face.plane) },
        );
        true
    }

    /// A direction inside, in lowest terms: the sum of the rays, each with its largest coordinate
    /// brought to the same order of magnitude.
    pub fn interior(&self) -> [Int; 3] {
        let rays: Vec<[Int; 3]> = self.rays().map(|ray| primitive(ray.exact().clone())).collect();
        let bits = |ray: &[Int; 3]| ray.iter().map(Int::bits).max().unwrap_or(0);
        let most = rays.iter().map(bits).max().unwrap_or(0);
        let mut sum = [Int::ZERO, Int::ZERO, Int::ZERO];
        for ray in &rays {
            let shift = most - bits(ray);
            for (total, c) in sum.iter_mut().zip(ray) {
                *total += c << shift;
            }
        }
        primitive(sum)
    }
}

/// The faces of a cone that is clipped by a plane, given on which side of it each face's first ray
/// is, with rays strictly on both: `leaving` makes the plane's own face where it leaves a face,
/// `turning` where it begins at a face's first ray, and `entering` what it leaves of a face.
pub(super) fn clipped<F: Clone>(
    faces: &[F],
    sides: &[Sign],
    leaving: impl Fn(&F) -> F,
    turning: impl Fn(&F) -> F,
    entering: impl Fn(&F) -> F,
) -> Vec<F> {
    let mut kept = Vec::with_capacity(faces.len() + 1);
    for (i, face) in faces.iter().enumerate() {
        match (sides[i], sides[(i + 1) % faces.len()]) {
            (Sign::Positive, Sign::Positive | Sign::Zero) | (Sign::Zero, Sign::Positive) => {
                kept.push(face.clone());
            }
            (Sign::Positive, Sign::Negative) => {
                kept.push(face.clone());
                kept.push(leaving(face));
            }
            // The new face starts at a ray that lies in it.
            (Sign::Zero, Sign::Negative | Sign::Zero) => kept.push(turning(face)),
            (Sign::Negative, Sign::Positive) => kept.push(entering(face)),
            // Its end is the next face's ray, which is kept there.
            (Sign::Negative, Sign::Zero | Sign::Negative) => {}
        }
    }
    kept
}

/// The vector divided by the greatest common divisor of its coordinates.
pub fn primitive(vector: [Int; 3]) -> [Int; 3] {
    let divisor = vector.iter().fold(Int::ZERO, |g, c| g.gcd(c)).abs();
    if divisor == Int::ZERO { vector } else { vector.map(|c| c / &divisor) }
}
