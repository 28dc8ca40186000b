//! The view frustum: four planes through the eye, rational, never narrower than asked for.
//!
//! The axes are `look` and `up`; they need not be normalised nor at right angles. With
//! r = look x up and u = r x look, a direction v is inside iff
//! |v·r| < (H·|r|/|look|)·(v·look) and |v·u| < (V·|r|)·(v·look); the half-tangents H and V are the
//! tangents of half the angles of view (Teller 1992, section 5.4.1). The two factors in
//! brackets are roots of rationals. Where a root is rational it is taken exactly, otherwise
//! rounded up within a factor of 1 + 2^-32: the frustum then holds the true one.

use super::Cone;
use crate::geom::vector::{cross, dot};
use crate::num::{Int, Rational, Sign};
use crate::predicates::Direction;
use num_integer::{Integer, Roots};
use num_traits::{One, Signed, Zero};
use std::rc::Rc;

/// A view frustum.
#[derive(Clone, Debug)]
pub struct Frustum {
    /// The normals of the right, lower, left and upper side, towards the inside.
    planes: [[Int; 3]; 4],
    /// Whether a root was rounded outward.
    widened: bool,
}

/// Why there is no such frustum.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum FrustumError {
    /// The direction of view is the zero vector.
    #[error("look is the zero vector")]
    NoLook,
    /// `up` is zero or along `look`.
    #[error("up is parallel to look, so it does not say which way is up")]
    UpAlongLook,
    /// A half-tangent that is zero or negative.
    #[error("a half-tangent must be positive, got {0}")]
    NotPositive(Rational),
    /// An angle of view that is no angle of a frustum.
    #[error("an angle of view must be above 0 and below 180 degrees, got {0}")]
    NoAngle(Rational),
}

impl Frustum {
    /// The frustum around `look`, its upper side towards `up`.
    ///
    /// # Errors
    /// [`FrustumError`] for axes that span no plane and half-tangents that are not positive.
    pub fn new(
        look: &[Rational; 3],
        up: &[Rational; 3],
        half_tangents: &[Rational; 2],
    ) -> Result<Frustum, FrustumError> {
        if look.iter().all(Zero::is_zero) {
            return Err(FrustumError::NoLook);
        }
        let right = cross(look, up);
        if right.iter().all(Zero::is_zero) {
            return Err(FrustumError::UpAlongLook);
        }
        if let Some(wrong) = half_tangents.iter().find(|tangent| !tangent.is_positive()) {
            return Err(FrustumError::NotPositive(wrong.clone()));
        }
        let up = cross(&right, look);
        let [h, v] = half_tangents;
        let breadth = dot(&right, &right);
        let (across, first) = root_up(&(h * h * &breadth / dot(look, look)));
        let (along, second) = root_up(&(v * v * &breadth));
        let side = |factor: &Rational, axis: &[Rational; 3], sign: Sign| {
            whole([0, 1, 2].map(|i| match sign {
                Sign::Positive | Sign::Zero => factor * &look[i] + &axis[i],
                Sign::Negative => factor * &look[i] - &axis[i],
            }))
        };
        let planes = [
            side(&across, &right, Sign::Negative),
            side(&along, &up, Sign::Positive),
            side(&across, &right, Sign::Positive),
            side(&along, &up, Sign::Negative),
        ];
        Ok(Frustum { planes, widened: first || second })
    }

    /// The normals of the right, lower, left and upper side, towards the inside.
    pub fn planes(&self) -> &[[Int; 3]; 4] {
        &self.planes
    }

    /// Whether it is wider than asked for, because an irrational length was rounded outward.
    pub fn is_widened(&self) -> bool {
        self.widened
    }

    pub(super) fn sides(&self) -> [Rc<Direction>; 4] {
        self.planes.clone().map(|plane| Rc::new(Direction::new(plane)))
    }
}

/// The six frusta around the axes: their closures cover all directions.
pub(super) fn around() -> [Cone; 6] {
    let axis = |i: usize, sign: i64| {
        let unit = |i: usize| [0, 1, 2].map(|k| Int::from(i64::from(i == k)));
        let (look, u, v) = (unit(i).map(|c| c * sign), unit((i + 1) % 3), unit((i + 2) % 3));
        let side = |axis: &[Int; 3], flip: i64| {
            Rc::new(Direction::new([0, 1, 2].map(|k| &look[k] + &axis[k] * flip)))
        };
        // Neighbours around +axis in the order in which their meets are rays of the cone.
        Cone::between(&[side(&u, -sign), side(&v, -1), side(&u, sign), side(&v, 1)])
    };
    [axis(0, 1), axis(0, -1), axis(1, 1), axis(1, -1), axis(2, 1), axis(2, -1)]
}

/// A half-tangent for an angle of view in degrees: tan(degrees/2), exactly for 90 degrees, else
/// rounded up by less than 2^-22 of its value.
///
/// With x not below half the angle in radians, the partial sums of the sine that end with a
/// positive term are above sin x, those of the cosine that end with a negative term below cos x:
/// for x below π/2 the terms alternate and, from the second on, decrease.
///
/// # Errors
/// [`FrustumError::NoAngle`] for angles outside of ]0, 180[, or too close to 180 to be told apart
/// from it in 48 digits.
pub fn half_tangent(degrees: &Rational) -> Result<Rational, FrustumError> {
    let half_turn = Rational::from(Int::from(180));
    if !degrees.is_positive() || *degrees >= half_turn {
        return Err(FrustumError::NoAngle(degrees.clone()));
    }
    if *degrees == Rational::from(Int::from(90)) {
        return Ok(Rational::one());
    }
    // π is above 3.14159…6939937510 by less than 10^-50.
    let digits = "314159265358979323846264338327950288419716939937511";
    let digits = digits.parse().expect("digits are an integer");
    let pi = Rational::new(digits, Int::from(10).pow(50));
    let small = (degrees.denom().bits()).saturating_sub(degrees.numer().bits());
    let x = round_up(&(degrees * pi / Int::from(360)), 192 + small);
    let square = &x * &x;
    let (mut sine, mut cosine) = (x.clone(), Rational::one());
    let (mut odd, mut even) = (x, Rational::one());
    // Terms up to x^50/50!, negative, for the cosine, and x^49/49!, positive, for the sine.
    for k in 1..=25u32 {
        even = -even * &square / Int::from((2 * k - 1) * (2 * k));
        cosine += &even;
        if k < 25 {
            odd = -odd * &square / Int::from((2 * k) * (2 * k + 1));
            sine += &odd;
        }
    }
    if !cosine.is_positive() {
        return Err(FrustumError::NoAngle(degrees.clone()));
    }
    let tangent = sine / cosine;
    let small = tangent.denom().bits().saturating_sub(tangent.numer().bits());
    Ok(round_up(&tangent, 24 + small))
}

/// The least multiple of 2^-bits that is not below.
fn round_up(value: &Rational, bits: u64) -> Rational {
    let power = Int::one() << bits;
    let ceiling = Integer::div_ceil(&(value.numer() * &power), value.denom());
    Rational::new(ceiling, power)
}

/// The root of a positive rational, and whether it had to be rounded up.
fn root_up(square: &Rational) -> (Rational, bool) {
    let (p, q) = (square.numer(), square.denom());
    let (root_p, root_q) = (p.sqrt(), q.sqrt());
    if &root_p * &root_p == *p && &root_q * &root_q == *q {
        return (Rational::new(root_p, root_q), false);
    }
    // √(p/q) = √(pq)/q, and pq >= 1 makes 2^-32 a small part of it.
    let root = Roots::sqrt(&((p * q) << 64u32)) + 1u32;
    (Rational::new(root, q << 32u32), true)
}

/// The integer vector of the same direction in lowest terms.
fn whole(vector: [Rational; 3]) -> [Int; 3] {
    let common = vector.iter().fold(Int::one(), |c, x| c.lcm(x.denom()));
    super::primitive(vector.map(|x| x.numer() * (&common / x.denom())))
}
