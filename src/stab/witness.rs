//! A rational line strictly inside an open sequence, with small numbers.
//!
//! From two interior points of the cone where the Klein quadric has opposite signs, the segment
//! between them is bisected towards the quadric; each approximation (d, m) is moved onto it by
//! taking m's part orthogonal to d, which changes it little near the quadric, and checked exactly.
//! With lineality l the quadric is linear along l, and one division reaches it. The line found is
//! then replaced by the simplest one near it: its crossings with the first and the last portal's
//! planes are rounded to the coarsest grid of powers of two for which the line through them passes
//! every check.
//!
//! **Invariants.** A returned line passes every half-space strictly, exactly. It is a function of
//! the sequence only; the reversed sequence gives the same line reversed, because everything is
//! computed for the one of the two directions that comes first lexicographically.

use super::quadric::{BothSigns, Vector, extremum_of_sign, quadric, side};
use super::sequence::{Frame, Portal3};
use super::stabber::rows_of;
use crate::geom::vector::{cross, difference, dot};
use crate::num::{Int, Rational, Sign};
use num_integer::Integer;
use num_traits::ToPrimitive;

/// A directed line through two distinct rational points, in grid units.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Witness {
    /// Two points of the line, in its direction.
    pub points: [[Rational; 3]; 2],
}

impl Witness {
    /// The x axis: a line for the sequence that asks nothing.
    pub(super) fn any() -> Witness {
        let at = |x: i32| [x, 0, 0].map(|c| Rational::from(Int::from(c)));
        Witness { points: [at(0), at(1)] }
    }
}

/// What the cone knows about its interior.
pub(super) struct Interior {
    pub(super) rays: Vec<Vector>,
    pub(super) lineality: Vec<Vector>,
    /// Points of the cone on both sides of the quadric, where it has no lineality.
    pub(super) signs: BothSigns,
    /// The point that the vectors take for the origin.
    pub(super) origin: [Int; 3],
}

/// The rows that a witness must be positive on, and where to measure it.
struct Problem {
    rows: Vec<Vector>,
    origin: [Int; 3],
    /// Normal and offset of the first and the last portal's planes, seen from the origin.
    ends: [([Int; 3], Int); 2],
    /// The bits of the sequence's extent.
    extent: u64,
}

/// A line strictly inside the sequence. Requires: there is one.
pub(super) fn find(interior: Interior, portals: &[&Portal3], orders: &[bool]) -> Witness {
    let mut problem = Problem::new(portals, orders);
    let shift = difference(&interior.origin, &problem.origin);
    let carry = |vector: &Vector| primitive(moved(vector, &shift));
    let lineality = echelon(interior.lineality.iter().map(carry).collect());
    let reduced = |vector: &Vector| primitive(without(&carry(vector), &lineality));
    let mut rays: Vec<Vector> = interior.rays.iter().map(reduced).collect();
    let mut beyond: Vec<Vector> = [&interior.signs.positive, &interior.signs.negative]
        .into_iter()
        .flatten()
        .map(carry)
        .collect();
    // A point inside the cone crosses every portal forward, so its direction is not zero.
    let backward = leading_sign(&rays.iter().fold(zero(), plus_ref)) == Sign::Negative;
    if backward {
        problem.reverse();
        rays.iter_mut().chain(&mut beyond).flatten().for_each(|c| *c = -&*c);
    }
    rays.sort();
    let line = match lineality.is_empty() {
        true => problem.bisected(&rays, beyond),
        false => along_lineality(&rays, &lineality),
    };
    let [from, to] = problem.simplest(&line);
    Witness { points: if backward { [to, from] } else { [from, to] } }
}

impl Problem {
    fn new(portals: &[&Portal3], orders: &[bool]) -> Problem {
        let all = || portals.iter().flat_map(|p| p.vertices()).map(|v| &v.coordinates);
        let least = |axis: usize| all().map(|v| &v[axis]).min().cloned().unwrap_or_default();
        let origin = std::array::from_fn(least);
        let extent =
            all().flat_map(|v| difference(v, &origin)).map(|c| c.bits()).max().unwrap_or(0);
        let (mut rows, frame) = (Vec::new(), Frame::about(&origin));
        for (index, portal) in portals.iter().enumerate() {
            let ordered = index > 0 && orders.get(index).copied().unwrap_or(false);
            let before = ordered.then(|| portals[index - 1]);
            rows.extend(rows_of(portal, before, &frame).into_iter().map(|(row, _)| row));
        }
        let plane = |portal: &Portal3| {
            (portal.normal().clone(), portal.offset() - dot(portal.normal(), &origin))
        };
        let ends = [plane(portals[0]), plane(portals[portals.len() - 1])];
        Problem { rows, origin, ends, extent }
    }

    /// The problem of the reversed sequence.
    fn reverse(&mut self) {
        self.rows.iter_mut().flatten().for_each(|c| *c = -&*c);
        self.ends.reverse();
    }

    /// Is the line strictly inside every half-space?
    fn passes(&self, line: &Vector) -> bool {
        let pairing = |row: &Vector| row.iter().zip(line).map(|(a, x)| a * x).sum::<Int>();
        self.rows.iter().all(|row| Sign::of(&pairing(row)) == Sign::Positive)
    }

    /// A line near the quadric's crossing between an interior point and one beyond the quadric.
    fn bisected(&self, rays: &[Vector], mut beyond: Vec<Vector>) -> Vector {
        let longest = rays.iter().map(bits).max().unwrap_or(0);
        let levelled = |ray: &Vector| {
            let shift = longest - bits(ray);
            ray.each_ref().map(|c| c << shift)
        };
        let inside = primitive(rays.iter().fold(zero(), |sum, ray| plus(&sum, &levelled(ray))));
        let here = Sign::of(&quadric(&inside));
        if here == Sign::Zero {
            return inside;
        }
        let others = rays.iter().filter(|ray| Sign::of(&quadric(ray)) == -here);
        let sum = others.clone().fold(zero(), |sum, ray| plus(&sum, &levelled(ray)));
        beyond.sort();
        // Where no ray lies beyond the quadric, the first pair of rays between which it is crossed.
        let pairs =
            rays.iter().enumerate().flat_map(|(i, r)| rays[..i].iter().map(move |s| [r, s]));
        let pairs = pairs.filter_map(|pair| extremum_of_sign(pair, -here));
        let mut candidates = std::iter::once(sum).chain(others.cloned()).chain(pairs).chain(beyond);
        let outside = candidates.find(|x| Sign::of(&quadric(x)) == -here);
        let outside = outside.expect("the quadric takes both signs on an open sequence's cone");
        self.crossing(&inside, &outside, here)
    }

    /// Bisects from `inside` (in the cone's interior, sign `here`) to `outside` until the line
    /// next to the crossing passes.
    fn crossing(&self, inside: &Vector, outside: &Vector, here: Sign) -> Vector {
        let (ii, io, oo) = (quadric(inside), side(inside, outside), quadric(outside));
        // Q((unit - n)·inside + n·outside) for the dyadic n / unit.
        let at = |n: &Int, unit: &Int| {
            let rest = unit - n;
            &ii * &rest * &rest + &io * &rest * n + &oo * n * n
        };
        let (mut low, mut unit) = (Int::ZERO, Int::from(1));
        loop {
            for _ in 0..8 {
                unit *= 2;
                low *= 2;
                let middle: Int = &low + 1;
                if Sign::of(&at(&middle, &unit)) == here {
                    low = middle;
                }
            }
            let rest = &unit - &low;
            let near: Vector = std::array::from_fn(|i| &rest * &inside[i] + &low * &outside[i]);
            let line = onto_quadric(&near);
            if self.passes(&line) {
                return line;
            }
        }
    }

    /// Two points, rounded to the coarsest grid of powers of two, of a line near `line`.
    fn simplest(&self, line: &Vector) -> [[Rational; 3]; 2] {
        let anchors = self.anchors(line);
        let mut exponent = self.extent as i64;
        loop {
            // In multiples of 1 / unit, with unit a power of two.
            let unit = Int::from(1) << exponent.min(0).unsigned_abs();
            let points = anchors.each_ref().map(|point| rounded(point, exponent));
            if self.passes(&through(&points, &unit)) {
                let place =
                    |c: &Int, i: usize| Rational::new(c + &self.origin[i] * &unit, unit.clone());
                return points.map(|point| std::array::from_fn(|i| place(&point[i], i)));
            }
            exponent -= 1;
        }
    }

    /// Two points of the line in its direction, each as numerators and a positive denominator:
    /// where it crosses the first and the last plane, or else a step of the extent's length.
    fn anchors(&self, line: &Vector) -> [([Int; 3], Int); 2] {
        let [d, m]: [[Int; 3]; 2] = [[0, 1, 2], [3, 4, 5]].map(|at| at.map(|i| line[i].clone()));
        // The point of the line on n·x = c is (c d + n × m) / (n·d).
        let meet = |(normal, offset): &([Int; 3], Int)| {
            let turn = cross(normal, &m);
            let divisor = dot(normal, &d);
            (std::array::from_fn(|i| offset * &d[i] + &turn[i]), divisor)
        };
        let [first, last]: [([Int; 3], Int); 2] = self.ends.each_ref().map(meet);
        let apart: Int =
            (0..3).map(|i| (&last.0[i] * &first.1 - &first.0[i] * &last.1) * &d[i]).sum();
        match Sign::of(&apart) {
            Sign::Positive => [first, last],
            Sign::Negative => [last, first],
            // Both planes are crossed in one point: any second point of the line will do.
            Sign::Zero => {
                let longest = d.iter().map(|c| c.magnitude().clone()).max().unwrap_or_default();
                let longest = Int::from(longest);
                let step = Int::from(1) << self.extent;
                let ahead = |i: usize| &first.0[i] * &longest + &d[i] * &first.1 * &step;
                let second = (std::array::from_fn(ahead), &first.1 * &longest);
                [first, second]
            }
        }
    }
}

/// A line strictly inside a cone with lineality: from an interior point along a lineality line.
fn along_lineality(rays: &[Vector], lineality: &[Vector]) -> Vector {
    let sum = rays.iter().fold(zero(), plus_ref);
    for line in lineality {
        for ray in std::iter::once(&zero()).chain(rays) {
            let inside = plus(&sum, ray);
            let slope = side(&inside, line);
            // Q(inside + t line) = Q(inside) + t slope, as lines of the lineality space have Q = 0
            // (they lie in every portal's plane).
            let value = quadric(&inside);
            match Sign::of(&slope) {
                Sign::Positive => {
                    return std::array::from_fn(|i| &slope * &inside[i] - &value * &line[i]);
                }
                Sign::Negative => {
                    return std::array::from_fn(|i| &value * &line[i] - &slope * &inside[i]);
                }
                // This point's plane is tangent along the line: another point's is not.
                Sign::Zero => {}
            }
        }
    }
    unreachable!("an open set of vectors is not orthogonal to a line")
}

fn plus_ref(sum: Vector, ray: &Vector) -> Vector {
    plus(&sum, ray)
}

/// The reduced echelon basis of the vectors' span, each primitive with a positive pivot.
fn echelon(vectors: Vec<Vector>) -> Vec<Vector> {
    let mut basis: Vec<Vector> = Vec::new();
    for vector in vectors {
        let rest = primitive(without(&vector, &basis));
        if leading_sign(&rest) == Sign::Zero {
            continue;
        }
        let rest = if leading_sign(&rest) == Sign::Negative { rest.map(|c| -c) } else { rest };
        let alone = [rest];
        basis = basis.iter().map(|other| primitive(without(other, &alone))).collect();
        basis.extend(alone);
        basis.sort_by_key(pivot);
    }
    basis
}

/// The vector with a multiple of each echelon vector taken off, so that it is zero at their pivots;
/// times a positive factor.
fn without(vector: &Vector, basis: &[Vector]) -> Vector {
    basis.iter().fold(vector.clone(), |x, line| {
        let at = pivot(line);
        std::array::from_fn(|i| &line[at] * &x[i] - &x[at] * &line[i])
    })
}

/// The place of the first coordinate that is not zero.
fn pivot(x: &Vector) -> usize {
    x.iter().position(|c| *c != Int::ZERO).unwrap_or(6)
}

/// (d, m) moved to (|d|² d, |d|² m - (d·m) d), which is a line.
fn onto_quadric(near: &Vector) -> Vector {
    let excess = quadric(near);
    let square: Int = near[..3].iter().map(|c| c * c).sum();
    primitive(std::array::from_fn(|i| {
        let own = &near[i] * &square;
        if i < 3 { own } else { own - &excess * &near[i - 3] }
    }))
}

/// The line through the points a / unit and b / unit, times unit².
fn through([a, b]: &[[Int; 3]; 2], unit: &Int) -> Vector {
    let [dx, dy, dz] = difference(b, a).map(|c| c * unit);
    let [mx, my, mz] = cross(a, b);
    [dx, dy, dz, mx, my, mz]
}

/// The multiple of 2^exponent nearest to the point (ties up in each coordinate), in grid units
/// where that is a whole number of them, else in units of 2^exponent.
fn rounded((numerators, divisor): &([Int; 3], Int), exponent: i64) -> [Int; 3] {
    let shift = exponent.unsigned_abs();
    let (scale, step) = if exponent < 0 { (shift, 0) } else { (0, shift) };
    numerators.each_ref().map(|numerator| {
        let double: Int = (numerator << (scale + 1)) + (divisor << step);
        let whole: Int = divisor << (step + 1);
        double.div_floor(&whole) << step
    })
}

pub(super) fn zero() -> Vector {
    std::array::from_fn(|_| Int::ZERO)
}

pub(super) fn plus(x: &Vector, y: &Vector) -> Vector {
    std::array::from_fn(|i| &x[i] + &y[i])
}

pub(super) fn bits(x: &Vector) -> u64 {
    x.iter().map(|c| c.bits()).max().unwrap_or(0)
}

/// The vector divided by the content of its coordinates.
pub(super) fn primitive(x: Vector) -> Vector {
    // Most rays fit in machine integers, whose divisors are found much sooner.
    let small: Option<Vec<i128>> = x.iter().map(|c| c.to_i128()).collect();
    if let Some(small) = small {
        let divisor = small.iter().map(|c| c.unsigned_abs()).fold(0, small_divisor);
        return match i128::try_from(divisor) {
            Ok(divisor) if divisor > 1 => std::array::from_fn(|i| Int::from(small[i] / divisor)),
            Ok(_) | Err(_) => x,
        };
    }
    let divisor = x.iter().fold(Int::ZERO, |g, c| g.gcd(c));
    if divisor.bits() <= 1 { x } else { x.map(|c| c / &divisor) }
}

/// The greatest common divisor, by subtraction and halving (Stein 1967).
fn small_divisor(a: u128, b: u128) -> u128 {
    if a == 0 || b == 0 {
        return a | b;
    }
    let twos = (a | b).trailing_zeros();
    let (mut a, mut b) = (a >> a.trailing_zeros(), b >> b.trailing_zeros());
    while a != b && a != 1 && b != 1 {
        if a < b {
            std::mem::swap(&mut a, &mut b);
        }
        a -= b;
        a >>= a.trailing_zeros();
    }
    a.min(b) << twos
}

/// The vector seen from an origin that lies at `-shift`: p becomes p + shift, m becomes
/// m + shift × d.
pub(super) fn moved(x: &Vector, shift: &[Int; 3]) -> Vector {
    let d: [Int; 3] = std::array::from_fn(|i| x[i].clone());
    let turn = cross(shift, &d);
    std::array::from_fn(|i| if i < 3 { x[i].clone() } else { &x[i] + &turn[i - 3] })
}

/// The sign of the first coordinate that is not zero.
fn leading_sign(x: &Vector) -> Sign {
    x.iter().map(Sign::of).find(|&sign| sign != Sign::Zero).unwrap_or(Sign::Zero)
}
