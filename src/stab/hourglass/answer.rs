//! What an hourglass has to say: a witness, a touching line, a certificate.
//!
//! The certificate is Gordan's (1873): ends with positive weights whose vectors ±(x, y, 1) sum to
//! zero, so that no line can be positive on all of them; at most four, by Carathéodory. A line that
//! is weakly right must pass through every end that has a weight, which leaves one line, the lines
//! through one point, or none to be tried for grazing.

use super::{Hourglass, is_left};
use crate::geom::BigPoint2;
use crate::num::{Int, Rational, Sign};
use crate::predicates::orient2d_big;
use num_integer::Integer;
use num_traits::{Signed, Zero};

/// Which end of a segment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// The end on the line's left.
    Left,
    /// The end on its right.
    Right,
}

/// An end of a segment with a positive weight.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EndTerm {
    /// The index of the segment.
    pub portal: usize,
    /// Which of its ends.
    pub end: End,
    /// The weight.
    pub weight: Int,
}

/// Two distinct points of a line strictly between left and right ends, in its direction.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlaneWitness {
    /// The points.
    pub points: [[Rational; 2]; 2],
}

/// Open, grazing or blocked, as `docs/semantics.md` defines them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum PlaneVerdict {
    /// Some line passes strictly between left and right ends.
    Open(PlaneWitness),
    /// None does, but one meets all closed segments in its direction.
    Grazing {
        /// Two ends on such a line, in its direction.
        touching_line: [BigPoint2; 2],
        /// Why the sequence is not open: the sum of weight · ±(x, y, 1), plus for left ends and
        /// minus for right ones, is zero.
        certificate: Vec<EndTerm>,
    },
    /// No line meets all closed segments in its direction.
    Blocked {
        /// Why the sequence is not open, as above.
        certificate: Vec<EndTerm>,
    },
}

/// An end as a vector, (x, y, 1) for a left end and its negative for a right one.
type Vector = [Int; 3];

impl Hourglass {
    /// The verdict on the whole sequence.
    ///
    /// # Panics
    /// If the sequence is empty.
    pub fn verdict(&self) -> PlaneVerdict {
        assert!(self.depth() > 0, "the verdict on no segment");
        let list = self.list();
        let Some((end, _)) = self.chains.closed_by() else {
            return PlaneVerdict::Open(self.witness(&list));
        };
        let terms = self.certificate(&list, end);
        let touching = self.touching_line(&terms);
        let certificate = terms
            .into_iter()
            .map(|(end, weight)| EndTerm {
                portal: end as usize / 2,
                end: if is_left(end) { End::Left } else { End::Right },
                weight,
            })
            .collect();
        match touching {
            Some(touching_line) => PlaneVerdict::Grazing { touching_line, certificate },
            None => PlaneVerdict::Blocked { certificate },
        }
    }

    fn vector(&self, end: u32) -> Vector {
        let [x, y] = self.point(end).coordinates;
        if is_left(end) { [x, y, Int::from(1)] } else { [-x, -y, Int::from(-1)] }
    }

    /// Weights for `end`, which closed the cone of `list`, and for ends of the list.
    fn certificate(&self, list: &[u32], end: u32) -> Vec<(u32, Int)> {
        if let [first, second] = *list {
            return self.certificate_on_line(first, second, end);
        }
        // The vector of the end is opposite to one of the dual cone, which is the union of the
        // cones of the first end of the list and two neighbours.
        let apex = self.vector(list[0]);
        let opposite = self.vector(end).map(|c| -c);
        let fan = list.windows(2).skip(1).find_map(|pair| {
            let [a, b] = [pair[0], pair[1]].map(|end| self.vector(end));
            let weights = [
                determinant(&a, &b, &opposite),
                determinant(&b, &apex, &opposite),
                determinant(&apex, &a, &opposite),
                determinant(&apex, &a, &b),
            ];
            let fits = weights.iter().all(|weight| !weight.is_negative());
            fits.then(|| in_lowest_terms([list[0], pair[0], pair[1], end], weights))
        });
        let Some(terms) = fan else { unreachable!("an end that closes a cone is in its dual") };
        terms
    }

    /// The same where all ends lie on one line, `first` and `second` bounding the gap.
    fn certificate_on_line(&self, first: u32, second: u32, end: u32) -> Vec<(u32, Int)> {
        let (same, other) =
            if is_left(end) == is_left(first) { (first, second) } else { (second, first) };
        let [p, q, r] = [end, same, other].map(|e| self.point(e).coordinates);
        // An axis that the line is not perpendicular to.
        let axis = usize::from(p[0] == q[0] && q[0] == r[0]);
        let distance = |a: &[Int; 2], b: &[Int; 2]| (&a[axis] - &b[axis]).abs();
        // `other` divides the way from `end` to `same`, or is `end`.
        let weights = [distance(&q, &r), distance(&p, &r), distance(&p, &q), Int::zero()];
        in_lowest_terms([end, same, other, end], weights)
    }

    /// A line weakly right of all ends; it passes through every end of the certificate.
    fn touching_line(&self, certificate: &[(u32, Int)]) -> Option<[BigPoint2; 2]> {
        let points: Vec<BigPoint2> = certificate.iter().map(|(end, _)| self.point(*end)).collect();
        let first = &points[0];
        let fits = |line: &[BigPoint2; 2]| {
            (0..2 * self.depth() as u32).all(|end| {
                let wrong = if is_left(end) { Sign::Negative } else { Sign::Positive };
                orient2d_big(&line[0], &line[1], &self.point(end)) != wrong
            })
        };
        let both =
            |other: &BigPoint2| [[first.clone(), other.clone()], [other.clone(), first.clone()]];
        match points.iter().find(|p| *p != first) {
            Some(second) if points.iter().any(|p| !collinear(first, second, p)) => None,
            Some(second) => both(second).into_iter().find(fits),
            // A left and a right end in one point: the line can be turned about it until it meets
            // another end.
            None => (0..2 * self.depth() as u32)
                .map(|end| self.point(end))
                .filter(|p| p != first)
                .find_map(|p| both(&p).into_iter().find(fits)),
        }
    }

    /// A line strictly inside the cone of `list`: through simple points of the first and the last
    /// segment if such a line passes, else the sum of all extremal lines.
    fn witness(&self, list: &[u32]) -> PlaneWitness {
        let last = self.depth() - 1;
        const FRACTIONS: [(i64, i64); 7] = [(1, 2), (1, 3), (2, 3), (1, 4), (3, 4), (1, 8), (7, 8)];
        let on = |portal: usize, (p, q): (i64, i64)| {
            let t = Rational::new(p.into(), q.into());
            let [a, b] = [0, 1].map(|end| self.point((2 * portal + end) as u32).coordinates);
            [0, 1].map(|i| Rational::from(a[i].clone()) + &t * Rational::from(&b[i] - &a[i]))
        };
        let simple = FRACTIONS.iter().flat_map(|f| FRACTIONS.iter().map(move |l| (f, l)));
        simple
            .take(if last == 0 { 0 } else { usize::MAX })
            .map(|(first_part, last_part)| [on(0, *first_part), on(last, *last_part)])
            .find(|points| list.iter().all(|&end| self.passes(points, end)))
            .map_or_else(|| self.inner_line(list), |points| PlaneWitness { points })
    }

    fn passes(&self, [p, q]: &[[Rational; 2]; 2], end: u32) -> bool {
        let [x, y] = self.point(end).coordinates.map(Rational::from);
        let turn = (&q[0] - &p[0]) * (y - &p[1]) - (&q[1] - &p[1]) * (x - &p[0]);
        if is_left(end) { turn.is_positive() } else { turn.is_negative() }
    }

    fn inner_line(&self, list: &[u32]) -> PlaneWitness {
        let [a, b, c] = if let [first, second] = *list {
            // Half way between the two innermost ends of one line, square to it.
            let (left, right) = if is_left(first) { (first, second) } else { (second, first) };
            let [l, r] = [left, right].map(|end| self.point(end).coordinates);
            let normal = [0, 1].map(|i| &l[i] - &r[i]);
            let middle: Int = (0..2).map(|i| &normal[i] * (&l[i] + &r[i])).sum();
            let [a, b] = normal;
            [a * 2, b * 2, -middle]
        } else {
            let neighbours = (0..list.len()).map(|i| (list[i], list[(i + 1) % list.len()]));
            neighbours
                .map(|(v, w)| cross(&self.vector(v), &self.vector(w)))
                .fold([(); 3].map(|()| Int::zero()), |sum, ray| {
                    [0, 1, 2].map(|i| &sum[i] + &ray[i])
                })
        };
        // The foot of the perpendicular from the origin, and a step to the right of (a, b).
        let square = &a * &a + &b * &b;
        let from = [&a, &b].map(|n| Rational::new(-n * &c, square.clone()));
        let divisor = a.gcd(&b);
        let step = [&b / &divisor, -&a / &divisor].map(Rational::from);
        let to = [0, 1].map(|i| &from[i] + &step[i]);
        PlaneWitness { points: [from, to] }
    }
}

fn collinear(a: &BigPoint2, b: &BigPoint2, c: &BigPoint2) -> bool {
    orient2d_big(a, b, c) == Sign::Zero
}

/// The terms with their common factor taken out, those of weight zero dropped.
fn in_lowest_terms(ends: [u32; 4], weights: [Int; 4]) -> Vec<(u32, Int)> {
    let divisor = weights.iter().fold(Int::zero(), |g, weight| g.gcd(weight));
    let terms = ends.into_iter().zip(weights).filter(|(_, weight)| !weight.is_zero());
    terms.map(|(end, weight)| (end, weight / &divisor)).collect()
}

fn cross(a: &Vector, b: &Vector) -> Vector {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| &a[i] * &b[j] - &a[j] * &b[i])
}

fn determinant(a: &Vector, b: &Vector, c: &Vector) -> Int {
    let normal = cross(a, b);
    (0..3).map(|i| &normal[i] * &c[i]).sum()
}
