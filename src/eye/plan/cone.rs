//! View cones of the plane, and wedges: the directions between two rays from an eye.
//!
//! A ray is given by a point on it: an end of a portal, or a point far out along a side of the view
//! cone. Never is it made from other rays, so that degrees stay bounded however often a wedge is
//! narrowed.

use super::super::FrustumError;
use crate::num::{Int, Rational, Sign};
use crate::predicates::{PlanPoint, turn_of_points};
use num_integer::Integer;
use num_traits::{One, Signed, Zero};

/// The directions between two rays around a direction of view, less than half a turn apart.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ViewCone {
    look: [Rational; 2],
    half_tangent: Rational,
    /// The directions of the right and of the left ray, in lowest terms.
    sides: [[Int; 2]; 2],
}

impl ViewCone {
    /// The cone around `look` (of any length) whose rays are `look` turned by the angle with this
    /// tangent to the right and to the left: look ∓ h·(-look.y, look.x).
    ///
    /// # Errors
    /// A direction without length, or a half-tangent that is not positive.
    pub fn new(look: &[Rational; 2], half_tangent: &Rational) -> Result<ViewCone, FrustumError> {
        if look.iter().all(Zero::is_zero) {
            return Err(FrustumError::NoLook);
        }
        if !half_tangent.is_positive() {
            return Err(FrustumError::NotPositive(half_tangent.clone()));
        }
        let [x, y] = look;
        let across = [-y * half_tangent, x * half_tangent];
        let right = whole([x - &across[0], y - &across[1]]);
        let left = whole([x + &across[0], y + &across[1]]);
        let (look, half_tangent) = (look.clone(), half_tangent.clone());
        Ok(ViewCone { look, half_tangent, sides: [right, left] })
    }

    /// The direction of view.
    pub fn look(&self) -> &[Rational; 2] {
        &self.look
    }

    /// The tangent of half the angle of view.
    pub fn half_tangent(&self) -> &Rational {
        &self.half_tangent
    }

    /// The directions of the right and of the left ray, in lowest terms.
    pub fn sides(&self) -> &[[Int; 2]; 2] {
        &self.sides
    }

    /// A point on the right and one on the left ray from an eye, `bits` or more long.
    pub(super) fn rays(&self, eye: &PlanPoint, bits: u64) -> [PlanPoint; 2] {
        let [x, y, w] = eye.numbers();
        self.sides.each_ref().map(|[dx, dy]| {
            let length = dx.bits().max(dy.bits());
            let stretch = &w << bits.saturating_sub(length);
            PlanPoint::new([&x + dx * &stretch, &y + dy * &stretch, w.clone()])
        })
    }
}

/// The integer vector of the same direction in lowest terms.
fn whole(vector: [Rational; 2]) -> [Int; 2] {
    let common = vector[0].denom().lcm(vector[1].denom());
    let whole = vector.map(|c| c.numer() * (&common / c.denom()));
    let divisor = whole[0].gcd(&whole[1]);
    if divisor.is_one() { whole } else { whole.map(|c| c / &divisor) }
}

/// The directions strictly between two rays from an eye, counter-clockwise from `right` to `left`.
///
/// Invariant: they turn left by less than half a turn.
#[derive(Clone, Copy, Debug)]
pub(super) struct Wedge<'a> {
    /// A point on the right ray.
    pub(super) right: &'a PlanPoint,
    /// A point on the left ray.
    pub(super) left: &'a PlanPoint,
}

/// Whether the directions from `eye` to `a` and to `b` turn left.
#[inline]
pub(super) fn turn(eye: &PlanPoint, a: &PlanPoint, b: &PlanPoint) -> Sign {
    // A graph has each point once.
    if std::ptr::eq(a, b) { Sign::Zero } else { turn_of_points(eye, a, b) }
}

impl<'a> Wedge<'a> {
    /// The wedge between two rays; `None` unless they turn left.
    pub(super) fn between(
        eye: &PlanPoint,
        right: &'a PlanPoint,
        left: &'a PlanPoint,
    ) -> Option<Wedge<'a>> {
        match turn(eye, right, left) {
            Sign::Positive => Some(Wedge { right, left }),
            // Without width: what lies in it is grazed.
            Sign::Zero => None,
            Sign::Negative => None,
        }
    }

    /// What of it leads between two points, where all four rays lie within half a turn.
    #[inline]
    pub(super) fn narrowed(
        self,
        eye: &PlanPoint,
        right: &'a PlanPoint,
        left: &'a PlanPoint,
    ) -> Option<Wedge<'a>> {
        let right = match turn(eye, self.right, right) {
            Sign::Positive => right,
            Sign::Zero | Sign::Negative => self.right,
        };
        let left = match turn(eye, self.left, left) {
            Sign::Negative => left,
            Sign::Zero | Sign::Positive => self.left,
        };
        Wedge::between(eye, right, left)
    }

    /// What two wedges have in common, wherever they point.
    ///
    /// Each is less than half a turn, so what they have in common is in one piece; it begins with
    /// that right ray which the other wedge holds.
    pub(super) fn meet(self, eye: &PlanPoint, other: Wedge<'a>) -> Option<Wedge<'a>> {
        let right = if other.begins(eye, self.right) {
            self.right
        } else if self.begins(eye, other.right) {
            other.right
        } else {
            return None;
        };
        let left = match turn(eye, self.left, other.left) {
            Sign::Negative => other.left,
            Sign::Zero | Sign::Positive => self.left,
        };
        Some(Wedge { right, left })
    }

    /// Whether some of it follows a ray counter-clockwise: the ray is inside or its right one.
    fn begins(self, eye: &PlanPoint, ray: &PlanPoint) -> bool {
        let after_right = match turn(eye, self.right, ray) {
            // The opposite ray is on the line as well, but not before the left one.
            Sign::Positive | Sign::Zero => true,
            Sign::Negative => false,
        };
        after_right && turn(eye, ray, self.left) == Sign::Positive
    }

    /// Whether a point lies strictly inside.
    pub(super) fn holds(self, eye: &PlanPoint, point: &PlanPoint) -> bool {
        turn(eye, self.right, point) == Sign::Positive
            && turn(eye, point, self.left) == Sign::Positive
    }

    /// A direction strictly inside, in lowest terms: the sum of the two rays'.
    pub(super) fn direction(self, eye: &PlanPoint) -> [Int; 2] {
        let eye = eye.coordinates();
        let [right, left] = [self.right, self.left].map(|end| {
            let end = end.coordinates();
            whole([0, 1].map(|i| &end[i] - &eye[i]))
        });
        let bits = |v: &[Int; 2]| v[0].bits().max(v[1].bits());
        let most = bits(&right).max(bits(&left));
        // Brought to one order of magnitude, so that the sum is not along one of them nearly.
        let stretched = |v: &[Int; 2], i: usize| &v[i] << (most - bits(v));
        let sum = [0, 1].map(|i| Rational::from(stretched(&right, i) + stretched(&left, i)));
        whole(sum)
    }
}
