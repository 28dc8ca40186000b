//! Sides of planes and lines in world coordinates, where the floats can prove them.
//!
//! A search over a portal graph asks millions of times on which side of a plane a vertex lies,
//! or how a line passes an edge. Vertices are exact rationals, mostly integers; their nearest
//! floats are at hand. The types here evaluate the float formula once and return its sign where a
//! proved bound on the whole error (of the coordinates' rounding and of every operation) says
//! that the sign is right, and `None` otherwise: the caller then asks the exact predicate.
//!
//! Small integers, and multiples of 1/8 for points that a search picks itself, are evaluated
//! without any rounding: then the bound is 0 and a zero is a proved zero, never `None`. That case
//! matters most, because in architecture every third test is an exact zero.
//!
//! # Error analysis
//! Model: u = 2^-53; each float operation returns the correctly rounded result, in error by at
//! most u times its own magnitude (plus 2^-1075 where it underflows). B bounds every coordinate,
//! true or rounded; B >= 1. A coordinate is in error by at most δ = uB, or 0 where it is exact
//! (Higham, Accuracy and Stability of Numerical Algorithms, 2002, chapters 2 and 3; the idea of
//! semi-static bounds from Shewchuk 1997 and from Meyer and Pion, 2008). The bounds are derived
//! in the comments of `PlaneScale` and `LineScale`.
//!
//! Invariant: a returned sign is the sign of the exact determinant of the true coordinates.

#[cfg(test)]
mod tests;

use crate::num::Sign;

/// 2^-53: the relative error of one float operation.
const U: f64 = f64::EPSILON / 2.0;

/// Below this many units, sums and products of multiples of a unit are exact.
const EXACT_UNITS: f64 = 9_007_199_254_740_992.0;

/// More than what all underflows of one evaluation can add up to, per unit of B: fewer than 100
/// operations, each in error by at most 2^-1075, and no later factor beyond 2^10·B.
const UNDERFLOW: f64 = 1e-300;

/// The largest B for which no product of three coordinates comes near overflow.
const LARGEST_BOUND: f64 = 1e90;

/// How the floats of a point stand to its true coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Held {
    /// They are the coordinates, and integers.
    Integer,
    /// They are the coordinates, and multiples of 1/8.
    Eighth,
    /// Each is the float nearest to the true coordinate.
    Rounded,
}

impl Held {
    const ALL: [Held; 3] = [Held::Integer, Held::Eighth, Held::Rounded];

    /// What every coordinate is a multiple of; `None` where that is unknown.
    fn unit(self) -> Option<f64> {
        match self {
            Held::Integer => Some(1.0),
            Held::Eighth => Some(0.125),
            Held::Rounded => None,
        }
    }

    /// The largest error of a coordinate of magnitude up to `bound`.
    fn error(self, bound: f64) -> f64 {
        match self {
            Held::Integer | Held::Eighth => 0.0,
            Held::Rounded => U * bound,
        }
    }
}

/// A point by the floats nearest to its true coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Approx3 {
    p: [f64; 3],
    held: Held,
}

impl Approx3 {
    /// The point whose true coordinates are these very floats.
    pub fn exact(p: [f64; 3]) -> Approx3 {
        let whole = |scale: f64| p.iter().all(|c| (c * scale).fract() == 0.0);
        let held = if whole(1.0) {
            Held::Integer
        } else if whole(8.0) {
            Held::Eighth
        } else {
            Held::Rounded
        };
        Approx3 { p, held }
    }

    /// The point whose coordinates are these integers, below 2^53 in magnitude, times 2^-bits.
    pub fn dyadic(integers: [i64; 3], bits: u32) -> Approx3 {
        debug_assert!(integers.iter().all(|c| c.unsigned_abs() < 1 << 53), "not a float");
        debug_assert!(bits < 64, "a unit that small is not needed");
        let unit = 1.0 / (1u64 << bits) as f64;
        Approx3::exact(integers.map(|c| c as f64 * unit))
    }

    /// A point whose true coordinates have these nearest floats (ties either way).
    pub fn rounded(p: [f64; 3]) -> Approx3 {
        Approx3 { p, held: Held::Rounded }
    }

    /// The floats.
    #[inline]
    pub fn floats(&self) -> [f64; 3] {
        self.p
    }

    /// How they stand to the true coordinates.
    #[inline]
    pub fn held(&self) -> Held {
        self.held
    }
}

/// A bound B on the magnitude of every coordinate that takes part, of a scene's vertices and of
/// the points that a search picks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bound {
    /// At least 1, so that u·B also bounds the rounding of coordinates that underflow. Infinite
    /// where it is out of range or not a number: then nothing is ever decided.
    b: f64,
    /// The largest error that any plane's value at any point can have: decides nearly all.
    plane_error: f64,
}

impl Bound {
    /// Decides nothing: what is made with it always answers `None`. The way to switch these
    /// filters off, to compare results with and without them.
    pub const NEVER: Bound = Bound { b: f64::INFINITY, plane_error: f64::INFINITY };

    /// The bound `largest`, a magnitude that no coordinate exceeds.
    pub fn new(largest: f64) -> Bound {
        if largest.is_nan() || largest > LARGEST_BOUND {
            return Bound::NEVER;
        }
        let b = largest.max(1.0);
        Bound { b, plane_error: PlaneScale::widest(b).rounded_error(b) }
    }

    /// The bound of some points. Points that are used later with it must lie within it too.
    pub fn of<'a>(points: impl IntoIterator<Item = &'a Approx3>) -> Bound {
        Bound::new(largest(points.into_iter().flat_map(|point| point.p)))
    }

    /// The largest magnitude that it admits.
    pub fn largest(self) -> f64 {
        self.b
    }

    /// Twice the bound.
    pub fn doubled(self) -> Bound {
        Bound::new(2.0 * self.b)
    }

    /// Whether the bound holds for a point.
    fn holds(self, point: &Approx3) -> bool {
        max_abs(point.p) <= self.b
    }
}

/// A plane through three points, ready to tell on which side others lie.
#[derive(Clone, Copy, Debug)]
pub struct FilteredPlane {
    normal: [f64; 3],
    offset: f64,
    /// The largest coordinate of b - a and that of c - a; infinite where a point was beyond the
    /// bound, so that nothing is decided.
    differences: [f64; 2],
    held: Held,
    bound: Bound,
}

impl FilteredPlane {
    /// The plane through `a`, `b` and `c`; its positive side is where they are seen
    /// counter-clockwise from: side(v) is the sign of det[b-a, c-a, v-a].
    ///
    /// Points that `bound` does not hold for give a plane that never decides.
    pub fn through(a: &Approx3, b: &Approx3, c: &Approx3, bound: Bound) -> FilteredPlane {
        let (p, q) = (difference(b.p, a.p), difference(c.p, a.p));
        let normal = cross(p, q);
        let offset = dot(normal, a.p);
        let held = a.held.max(b.held).max(c.held);
        if bound.holds(a) && bound.holds(b) && bound.holds(c) {
            FilteredPlane { normal, offset, differences: [max_abs(p), max_abs(q)], held, bound }
        } else {
            let differences = [f64::INFINITY; 2];
            FilteredPlane { normal, offset, differences, held: Held::Rounded, bound: Bound::NEVER }
        }
    }

    /// The side of `v`, where the floats prove it.
    ///
    /// Requires: the plane's bound holds for `v`.
    #[inline]
    pub fn side(&self, v: &Approx3) -> Option<Sign> {
        debug_assert!(
            self.bound == Bound::NEVER || self.bound.holds(v),
            "a point lies outside the plane's bound"
        );
        let value = dot(self.normal, v.p) - self.offset;
        if value > self.bound.plane_error {
            Some(Sign::Positive)
        } else if value < -self.bound.plane_error {
            Some(Sign::Negative)
        } else {
            self.side_near(value, v.held)
        }
    }

    /// The sign of a value that may be small, with the error of this very plane.
    fn side_near(&self, value: f64, tested: Held) -> Option<Sign> {
        decide(value, self.scale().error(tested, self.bound.b))
    }

    fn scale(&self) -> PlaneScale {
        let [p, q] = self.differences;
        PlaneScale { p, q, normal: max_abs(self.normal), held: self.held }
    }

    /// The same plane seen from its other side.
    pub fn flipped(&self) -> FilteredPlane {
        FilteredPlane { normal: self.normal.map(|n| -n), offset: -self.offset, ..*self }
    }

    /// A normal, not normalised, towards the positive side: for proposals.
    pub fn normal(&self) -> [f64; 3] {
        self.normal
    }

    /// Normal and offset, where they are integers and known exactly.
    pub fn integers(&self) -> Option<[i64; 4]> {
        let [x, y, z] = self.normal;
        (self.scale().is_exact(Held::Integer, self.bound.b)
            && [x, y, z, self.offset].iter().all(|c| c.fract() == 0.0))
        .then(|| [x, y, z, self.offset].map(|c| c as i64))
    }

    /// The offset along [`FilteredPlane::normal`]: for proposals.
    pub fn offset(&self) -> f64 {
        self.offset
    }
}

/// The magnitudes that a plane's error depends on.
struct PlaneScale {
    /// The largest coordinate of b - a, P below.
    p: f64,
    /// The largest coordinate of c - a, Q below.
    q: f64,
    /// The largest coordinate of the normal, N below.
    normal: f64,
    held: Held,
}

impl PlaneScale {
    /// The largest magnitudes under a bound: differences of 2B, a normal of 2·(2B)², each with
    /// room for its rounding.
    fn widest(bound: f64) -> PlaneScale {
        let difference = 2.0 * bound * (1.0 + 4.0 * U);
        let normal = 2.0 * difference * difference * (1.0 + 8.0 * U);
        PlaneScale { p: difference, q: difference, normal, held: Held::Rounded }
    }

    fn error(&self, tested: Held, bound: f64) -> f64 {
        if self.is_exact(tested, bound) { 0.0 } else { self.rounded_error(bound) }
    }

    /// Exact: the true coordinates of a, b, c are multiples of g, those of v of h. Then
    /// differences are multiples of g below 2B, the normal's coordinates multiples of g² that no
    /// partial result brings beyond 2PQ, and all partial sums of n·v - n·a multiples of
    /// g²·min(g, h) that stay within 6NB. Each is exact while it stays within 2^53 units. (A
    /// float product is at least 2^k where the true one is, so `<` is safe; 8 for 6 makes the
    /// factor a power of two.) For integers B <= 2^15 is always enough: 8·2^33·2^15 = 2^51.
    fn is_exact(&self, tested: Held, bound: f64) -> bool {
        let (Some(g), Some(h)) = (self.held.unit(), tested.unit()) else {
            return false;
        };
        2.0 * bound < EXACT_UNITS * g
            && bound < EXACT_UNITS * h
            && 2.0 * self.p * self.q < EXACT_UNITS * g * g
            && 8.0 * self.normal * bound < EXACT_UNITS * g * g * g.min(h)
    }

    /// Rounded: let δ = uB for rounded a, b, c, else 0.
    /// A coordinate of b - a is in error by ηp = uP + 2δ at most: its own rounding, and that of
    /// the two points. So for c - a with ηq = uQ + 2δ.
    /// A coordinate of the normal is in error by
    ///   ν = 2(ηp·Q + P·ηq + ηp·ηq) + 5uPQ
    /// at most: from the factors, and two products (u·PQ each) and their difference
    /// (u·2PQ(1+u)), together below 5u·PQ.
    /// The true value is n'·(v' - a') with primes for true quantities. Against n·(v - a) it is
    /// off by 3ν·2B(1+u) from the normal and 3N·2uB from v and a. The float evaluation of n·v is
    /// off by 3uNB (products) + u(2+3)NB (sums), so is that of n·a, and their difference by
    /// u·6NB: 22uNB, to first order. With the second-order terms and the rounding of this very
    /// formula (a few u, relative) that is less than 6.1·Bν + 28.1·uNB; the constants below
    /// leave a margin.
    ///
    /// It grows with P, Q, N and δ, so its value at the largest of each bounds it everywhere.
    fn rounded_error(&self, bound: f64) -> f64 {
        let delta = self.held.error(bound);
        let eta_p = U * self.p + 2.0 * delta;
        let eta_q = U * self.q + 2.0 * delta;
        let from_factors = eta_p * self.q + self.p * eta_q + eta_p * eta_q;
        let nu = 2.0 * from_factors + 5.0 * U * self.p * self.q;
        6.5 * bound * nu + 30.0 * U * self.normal * bound + UNDERFLOW * bound
    }
}

/// A directed line through two points, ready to tell how it passes others.
#[derive(Clone, Copy, Debug)]
pub struct FilteredLine {
    /// Plücker coordinates of the line through p and q: q - p, and p x q.
    direction: [f64; 3],
    moment: [f64; 3],
    held: Held,
    /// The largest error of a side product with another line, by how that one is held. Never
    /// zero for rounded points.
    errors: [f64; 3],
    /// Only to check the contract.
    bound: Bound,
}

impl FilteredLine {
    /// The line through `p` and `q`, directed from `p` to `q`.
    ///
    /// Points that `bound` does not hold for give a line that never decides.
    pub fn through(p: &Approx3, q: &Approx3, bound: Bound) -> FilteredLine {
        let direction = difference(q.p, p.p);
        // p x q = p x (q - p), and the rounding of the latter is smaller for short edges.
        let moment = cross(p.p, direction);
        let held = p.held.max(q.held);
        if !(bound.holds(p) && bound.holds(q)) {
            // NaN on both sides of every comparison: `None` from either of the two lines.
            let nothing = [f64::NAN; 3];
            let held = Held::Rounded;
            return FilteredLine {
                direction: nothing,
                moment: nothing,
                held,
                errors: nothing,
                bound,
            };
        }
        let scale = LineScale {
            point: max_abs(p.p),
            direction: max_abs(direction),
            moment: max_abs(moment),
            held,
        };
        let errors = Held::ALL.map(|tested| scale.error(tested, bound.b));
        FilteredLine { direction, moment, held, errors, bound }
    }

    /// The Plücker side of this line and `edge`, where the floats prove it: the sign of
    /// det[q-p, r-p, s-p] for this line through p, q and the edge from r to s.
    ///
    /// Requires: both were made with the same bound.
    #[inline]
    pub fn side_of_edge(&self, edge: &FilteredLine) -> Option<Sign> {
        debug_assert!(self.bound == edge.bound, "two lines were made with different bounds");
        let value = dot(self.direction, edge.moment) + dot(self.moment, edge.direction);
        decide(value, self.errors[edge.held as usize])
    }

    /// The same line in the other direction.
    pub fn reversed(&self) -> FilteredLine {
        FilteredLine {
            direction: self.direction.map(|c| -c),
            moment: self.moment.map(|c| -c),
            ..*self
        }
    }

    /// Plücker coordinates (direction, moment) in floats: for proposals.
    pub fn coordinates(&self) -> ([f64; 3], [f64; 3]) {
        (self.direction, self.moment)
    }
}

/// The magnitudes that a line's error depends on.
struct LineScale {
    /// The largest coordinate of the first point, P below.
    point: f64,
    /// The largest coordinate of the direction, D below.
    direction: f64,
    /// The largest coordinate of the moment, M below.
    moment: f64,
    held: Held,
}

impl LineScale {
    /// Exact: this line's points are multiples of g, the other's of h. Directions are multiples
    /// of g and h below 2B; the partial results of moments multiples of g² and h² within 2PD and
    /// 4B²; and as the other's true direction and moment are within 2B and 2B², the partial sums
    /// of the side product are multiples of g·h·min(g, h) within 3(D·2B² + M·2B). Each is exact
    /// while it stays within 2^53 units; 8 for 6 covers the rounding of this formula. For
    /// integers B <= 2^15 is always enough: 8(2^16·2^30 + 2^31·2^15) = 2^50; for a line through
    /// eighths against integers B < 2^14: 8(2^15·2^28 + 2^29·2^14) = 2^47 = 2^53/64, and beyond
    /// it, lines that are short enough.
    fn is_exact(&self, tested: Held, bound: f64) -> bool {
        let (Some(g), Some(h)) = (self.held.unit(), tested.unit()) else {
            return false;
        };
        let side = 8.0 * bound * (self.direction * bound + self.moment);
        2.0 * bound < EXACT_UNITS * g.min(h)
            && 2.0 * self.point * self.direction < EXACT_UNITS * g * g
            && 4.0 * bound * bound < EXACT_UNITS * h * h
            && side < EXACT_UNITS * g * h * g.min(h)
    }

    /// Rounded: let δ = uB for rounded points, else 0.
    /// A coordinate of the direction is in error by ηd = uD + 2δ, one of the moment p x d by
    ///   ηm = 2(δD + P·ηd + δ·ηd) + 5uPD
    /// at most, as for a plane's normal. The other line is one of any that the bound holds for,
    /// so D' <= 2B, M' <= 4B²(1+2u), ηd' <= 2uB + 2uB = 4uB and, with P <= B and δ <= uB,
    ///   ηm' <= 2(2uB² + 4uB² + 4u²B²) + 10uB² <= 22.1·uB².
    /// The side product of the floats is off from the true one by
    ///   3(D·ηm' + ηd·M' + ηd·ηm') + 3(M·ηd' + ηm·D' + ηm·ηd')
    /// and its evaluation by 11u(DM' + MD'): six products (u each), two sums of three (2u and
    /// 3u), one sum of both (3u). Together, to first order,
    ///   (66.3 + 44)·u·DB² + (12 + 22)·u·MB + 12·ηd·B² + 6·ηm·B;
    /// the constants below leave a margin for the higher orders and this formula's rounding.
    fn error(&self, tested: Held, bound: f64) -> f64 {
        if self.is_exact(tested, bound) {
            return 0.0;
        }
        let delta = self.held.error(bound);
        let eta_d = U * self.direction + 2.0 * delta;
        let from_factors = delta * self.direction + self.point * eta_d + delta * eta_d;
        let eta_m = 2.0 * from_factors + 5.0 * U * self.point * self.direction;
        let square = bound * bound;
        let from_direction = (112.0 * U * self.direction + 12.5 * eta_d) * square;
        let from_moment = (36.0 * U * self.moment + 6.5 * eta_m) * bound;
        from_direction + from_moment + UNDERFLOW * square
    }
}

/// The sign of a true value that `value` is within `error` of, if that says it.
#[inline(always)]
fn decide(value: f64, error: f64) -> Option<Sign> {
    // One branch, nearly always the same way: the sign itself is taken without one. An error of
    // zero is that of exact points, whose value is never NaN.
    if value.abs() > error || error == 0.0 { Some(Sign::of(&value)) } else { None }
}

#[inline(always)]
fn difference(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

#[inline(always)]
fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[inline(always)]
fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn max_abs(a: [f64; 3]) -> f64 {
    largest(a)
}

/// The largest magnitude, or NaN if any is NaN: no bound holds for that.
fn largest(coordinates: impl IntoIterator<Item = f64>) -> f64 {
    let larger =
        |largest: f64, c: f64| if c.abs() > largest || c.is_nan() { c.abs() } else { largest };
    coordinates.into_iter().fold(0.0, larger)
}
