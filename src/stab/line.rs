//! Lines over Q(√d), and the check whether one meets closed portals.
//!
//! A line is kept as its Plücker vector `a + b√d` with integer vectors a, b: every condition on it
//! is linear, so each is the sign of one number of that field. A rational line has b = 0.

use super::closed::{ClosedPortal, Row};
use super::quadric::{Vector, quadric, side};
use super::sequence::Portal3;
use super::witness::{moved, primitive, zero};
use crate::geom::vector::{cross, dot};
use crate::num::{Int, Rational, Sign, Surd, sign_of_surd};
use num_traits::Signed;

/// A directed line with coordinates over Q(√d), in grid units.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StabLine {
    /// Two points of the line, in its direction.
    pub points: [[Surd; 3]; 2],
}

impl StabLine {
    /// The line with this direction, not zero, and this moment: its point next to the origin, and
    /// one a direction further.
    pub fn near_origin(direction: &[Surd; 3], moment: &[Surd; 3]) -> StabLine {
        let near = nearest_point(direction, moment);
        let next = std::array::from_fn(|i| &near[i] + &direction[i]);
        StabLine { points: [near, next] }
    }
}

/// The Plücker vector `rational + root·√radicand` of a line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct ExactLine {
    rational: Row,
    /// All zero, as is the radicand, for a rational line.
    root: Vector,
    radicand: Int,
}

impl ExactLine {
    /// A line with integer coordinates. Requires: it is one (Q = 0).
    pub(super) fn rational(vector: Vector) -> ExactLine {
        debug_assert!(quadric(&vector) == Int::ZERO, "not a line");
        ExactLine { rational: Row::new(primitive(vector)), root: zero(), radicand: Int::ZERO }
    }

    /// Where the quadric is crossed strictly between r and s, if it is: at most two lines.
    pub(super) fn between(r: &Vector, s: &Vector) -> Vec<ExactLine> {
        // Q(u r + v s) = (rr u² + 2 rs u v + ss v²) / 2.
        let (rr, rs, ss) = (side(r, r), side(r, s), side(s, s));
        let radicand: Int = &rs * &rs - &rr * &ss;
        // Roots with u, v > 0 need rs of the sign opposite to rr and ss, or rr and ss opposite.
        if Sign::of(&radicand) == Sign::Negative {
            return Vec::new();
        }
        if rr == Int::ZERO || ss == Int::ZERO {
            // One root is the ray that is itself a line; the other, -ss/(2 rs) or -rr/(2 rs).
            let (u, v) = if rr == Int::ZERO { (ss, rs * 2) } else { (rs * 2, rr) };
            return match Sign::of(&u) * Sign::of(&v) {
                Sign::Negative => {
                    let (u, v) = (u.abs(), v.abs());
                    vec![ExactLine::rational(std::array::from_fn(|i| &u * &r[i] + &v * &s[i]))]
                }
                // The other root is on the other side of a ray, or on a ray.
                Sign::Positive | Sign::Zero => Vec::new(),
            };
        }
        // u/v = (-rs ± √radicand) / rr: u = ∓(rs ∓ √radicand) · sign(rr), v = |rr|.
        let flip = if rr.is_negative() { -1 } else { 1 };
        let mut lines = Vec::new();
        for branch in [-1, 1] {
            let (constant, factor) = (-&rs * flip, Int::from(branch * flip));
            if sign_of_surd(&constant, &factor, &radicand) == Sign::Positive {
                let size = rr.abs();
                let rational = std::array::from_fn(|i| &constant * &r[i] + &size * &s[i]);
                let root = r.each_ref().map(|c| c * &factor);
                lines.push(ExactLine::new(rational, root, radicand.clone()));
            }
            if radicand == Int::ZERO {
                break;
            }
        }
        lines
    }

    /// The line `rational + root·√radicand`, a square root that is an integer taken.
    fn new(rational: Vector, root: Vector, radicand: Int) -> ExactLine {
        let exact = radicand.sqrt();
        if &exact * &exact == radicand {
            return ExactLine::rational(std::array::from_fn(|i| &rational[i] + &exact * &root[i]));
        }
        ExactLine { rational: Row::new(rational), root, radicand }
    }

    /// The same line with the opposite direction.
    pub(super) fn reversed(&self) -> ExactLine {
        let negated = |v: &Vector| v.each_ref().map(|c| -c);
        ExactLine {
            rational: Row::new(negated(&self.rational.vector)),
            root: negated(&self.root),
            radicand: self.radicand.clone(),
        }
    }

    /// The same line, relative to the grid's origin instead of the point `origin`.
    pub(super) fn moved(&self, origin: &[Int; 3]) -> ExactLine {
        ExactLine {
            rational: Row::new(moved(&self.rational.vector, origin)),
            root: moved(&self.root, origin),
            radicand: self.radicand.clone(),
        }
    }

    /// The same line on another grid, `to` units of which are as long as `from` of this one's: a
    /// direction grows by the quotient, a moment by its square.
    pub(super) fn on_grid(&self, from: &Int, to: &Int) -> ExactLine {
        let scaled = |v: &Vector| std::array::from_fn(|i| &v[i] * if i < 3 { from } else { to });
        ExactLine {
            rational: Row::new(scaled(&self.rational.vector)),
            root: scaled(&self.root),
            radicand: self.radicand.clone(),
        }
    }

    /// The rational part, the factor of the root, and the radicand.
    pub(super) fn parts(&self) -> (Vector, Vector, Int) {
        (self.rational.vector.clone(), self.root.clone(), self.radicand.clone())
    }

    /// The sign of `row · line`.
    pub(super) fn sign(&self, row: &Row) -> Sign {
        let is_rational = self.radicand == Int::ZERO;
        if is_rational && let Some(product) = row.small_product(&self.rational) {
            return Sign::of(&product);
        }
        let dot = |v: &Vector| row.vector.iter().zip(v).map(|(a, x)| a * x).sum::<Int>();
        match is_rational {
            true => Sign::of(&dot(&self.rational.vector)),
            false => sign_of_surd(&dot(&self.rational.vector), &dot(&self.root), &self.radicand),
        }
    }

    fn is_finite(&self) -> bool {
        let nothing = |v: &Vector| v[..3].iter().all(|c| *c == Int::ZERO);
        !(nothing(&self.rational.vector) && nothing(&self.root))
    }

    /// Does the line meet every closed portal, in its direction or within its plane?
    pub(super) fn touches_all(&self, portals: &[&ClosedPortal]) -> bool {
        self.is_finite() && portals.iter().all(|portal| self.touches(portal))
    }

    /// The same for one portal, of a line that is finite.
    pub(super) fn touches(&self, portal: &ClosedPortal) -> bool {
        let mut sides = portal.edges.iter().map(|row| self.sign(row));
        match self.sign(&portal.slope) {
            Sign::Positive => sides.all(|sign| sign != Sign::Negative),
            Sign::Negative => false,
            // Parallel to the portal's plane: it grazes iff it lies in it and meets the polygon,
            // that is, the vertices are not all strictly on one side of it.
            Sign::Zero => {
                let within: Vec<Sign> = match sides.all(|sign| sign == Sign::Zero) {
                    true => portal.vertices.iter().map(|row| self.sign(row)).collect(),
                    false => return false,
                };
                let all = |wanted: Sign| within.iter().all(|&sign| sign == wanted);
                !all(Sign::Positive) && !all(Sign::Negative)
            }
        }
    }

    /// The line by two points: where it crosses the first and the last of the portals' planes that
    /// it crosses, or else its point next to the origin and a step.
    pub(super) fn points(&self, portals: &[&ClosedPortal]) -> StabLine {
        let coordinates: [Surd; 6] = std::array::from_fn(|i| {
            let part = |v: &Vector| Rational::from(v[i].clone());
            Surd::new(part(&self.rational.vector), part(&self.root), self.radicand.clone())
        });
        let [dx, dy, dz, mx, my, mz] = coordinates;
        let (d, m) = ([dx, dy, dz], [mx, my, mz]);
        let meets: Vec<[Surd; 3]> = portals
            .iter()
            .filter(|portal| self.sign(&portal.slope) == Sign::Positive)
            .map(|portal| crossing(&portal.portal, &d, &m))
            .collect();
        let start = meets.first().cloned().unwrap_or_else(|| nearest_point(&d, &m));
        let apart = |end: &[Surd; 3]| {
            let step = (0..3).map(|i| &(&end[i] - &start[i]) * &d[i]);
            step.fold(Surd::from(Int::ZERO), |sum, term| &sum + &term).sign()
        };
        let end = meets.last().map(|end| (end.clone(), apart(end)));
        let points = match end {
            Some((end, Sign::Positive)) => [start, end],
            Some((end, Sign::Negative)) => [end, start],
            // One point only: the planes meet there, or only one is crossed, or none.
            Some((_, Sign::Zero)) | None => {
                let next = std::array::from_fn(|i| &start[i] + &d[i]);
                [start, next]
            }
        };
        StabLine { points }
    }
}

fn surd_dot(a: &[Int; 3], b: &[Surd; 3]) -> Surd {
    let terms = a.iter().zip(b).map(|(a, b)| &Surd::from(a.clone()) * b);
    terms.fold(Surd::from(Int::ZERO), |sum, term| &sum + &term)
}

fn surd_cross(a: &[Surd; 3], b: &[Surd; 3]) -> [Surd; 3] {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| &(&a[i] * &b[j]) - &(&a[j] * &b[i]))
}

/// Where the line crosses the portal's plane: (c d + n × m) / (n·d).
fn crossing(portal: &Portal3, d: &[Surd; 3], m: &[Surd; 3]) -> [Surd; 3] {
    let turn = surd_cross(&portal.normal().clone().map(Surd::from), m);
    let divisor = surd_dot(portal.normal(), d);
    let offset = Surd::from(portal.offset().clone());
    std::array::from_fn(|i| &(&(&offset * &d[i]) + &turn[i]) / &divisor)
}

/// The line's point next to the origin: (d × m) / (d·d).
fn nearest_point(d: &[Surd; 3], m: &[Surd; 3]) -> [Surd; 3] {
    let square = d.iter().map(|c| c * c).fold(Surd::from(Int::ZERO), |sum, term| &sum + &term);
    surd_cross(d, m).map(|c| &c / &square)
}

/// The meet of two portals' planes; all zero where they are one plane.
pub(super) fn meet_of_planes(a: &Portal3, b: &Portal3) -> Vector {
    let [dx, dy, dz] = cross(a.normal(), b.normal());
    let (first, second) = (a.offset(), b.offset());
    let moment = |i: usize| second * &a.normal()[i] - first * &b.normal()[i];
    [dx, dy, dz, moment(0), moment(1), moment(2)]
}

/// The product of a vector's direction with a normal.
pub(super) fn slope_of(vector: &Vector, normal: &[Int; 3]) -> Int {
    let [x, y, z] = [&vector[0], &vector[1], &vector[2]].map(Clone::clone);
    dot(normal, &[x, y, z])
}
