//! All lines that meet given lines, with every degenerate case answered as what it is.
//!
//! A line x meets a given line l iff side(x, l) = 0, a linear condition on Plücker coordinates,
//! and six numbers are a line iff Q(x) = direction · moment = 0. So the answer is the Klein
//! quadric's section with the null space N of the matrix whose rows are the given lines (Teller
//! 1992, section 6.3), and its shape follows from the rank of the matrix and from Q on N. With T
//! the span of the given lines, N is the complement of T for the side product, a form of signature
//! (3, 3), and T is spanned by zeros of Q; that leaves these cases and no others:
//!
//! | rank | Q on N | lines |
//! |---|---|---|
//! | 4 | discriminant > 0, = 0, < 0 | two, one (counted twice), none |
//! | 4 | zero | a pencil: one point, one plane |
//! | 3 | rank 3, then indefinite | a regulus |
//! | 3 | rank 2, then split over the rationals | two pencils with one line in common |
//! | 3 | zero | all lines through a point, or all lines of a plane |
//! | 2 | rank 4 | all lines meeting two skew lines (a linear congruence) |
//! | 2 | rank 2 | all lines through a point, and all lines of a plane through it |
//! | 1 | | all lines meeting one line (a special linear complex) |
//!
//! Points and lines at infinity take part as in projective space: parallel lines meet. A single
//! line at infinity is a different answer than a line, and is kept apart.
//!
//! Complexity: constant; coordinates of the basis of N have at most four times the digits of the
//! given lines'.

mod elimination;
mod incidence;

pub use incidence::{ProjectivePlane, ProjectivePoint};

use crate::geom::BigLine;
use crate::geom::vector::{cross, dot};
use crate::num::{Int, Rational, Sign, Surd};
use elimination::null_space;
use incidence::{join, meet, meet_of_planes, pencil_of};
use num_traits::{One, Zero};

/// All lines that meet each of the given ones.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Transversals {
    /// The rank of the given lines' Plücker vectors.
    pub rank: usize,
    /// Lines at a finite place that belong to no family: none, one or two.
    pub isolated: Vec<IsolatedLine>,
    /// Lines at infinity that belong to no family, each by the normal of the planes through it.
    pub at_infinity: Vec<InfiniteLine>,
    /// The families: none, one or two.
    pub families: Vec<Family>,
}

/// A transversal that is not one of a family.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct IsolatedLine {
    /// The direction, not zero, and the moment, over one field Q(√d).
    pub direction: [Surd; 3],
    /// The moment about the origin.
    pub moment: [Surd; 3],
    /// Two for a double root: the given lines are tangent to the quadric of any three of them.
    pub multiplicity: u8,
}

/// A transversal at infinity that is not one of a family.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct InfiniteLine {
    /// The normal of the planes that contain the line; its first component that is not zero is 1.
    pub normal: [Surd; 3],
    /// Two for a double root.
    pub multiplicity: u8,
}

/// Infinitely many transversals.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Family {
    /// The lines of a plane through one of its points (one parameter).
    Pencil {
        /// The common point; at infinity where the lines are parallel.
        center: ProjectivePoint,
        /// The common plane.
        plane: ProjectivePlane,
    },
    /// One ruling of a quadric surface (one parameter).
    Regulus {
        /// Three of its lines, which determine it.
        lines: Box<[BigLine; 3]>,
        /// Whether the surface is a hyperbolic paraboloid (the ruling then holds one line at
        /// infinity) and not a hyperboloid of one sheet.
        paraboloid: bool,
    },
    /// All lines through a point (two parameters).
    Bundle {
        /// The point; at infinity where the lines are parallel.
        center: ProjectivePoint,
    },
    /// All lines of a plane (two parameters).
    PlaneField {
        /// The plane.
        plane: ProjectivePlane,
    },
    /// All lines that meet two skew lines (two parameters).
    Congruence {
        /// The two lines.
        axes: Box<[BigLine; 2]>,
    },
    /// All lines that meet one line (three parameters).
    Complex {
        /// The line.
        axis: BigLine,
    },
}

impl Family {
    /// How many parameters the family has.
    pub fn dimension(&self) -> u8 {
        match self {
            Family::Pencil { .. } | Family::Regulus { .. } => 1,
            Family::Bundle { .. } | Family::PlaneField { .. } | Family::Congruence { .. } => 2,
            Family::Complex { .. } => 3,
        }
    }
}

impl IsolatedLine {
    /// Two distinct points of the line, in its direction: for the first axis that the line is not
    /// perpendicular to, where that coordinate is 0 and where it is 1.
    pub fn points(&self) -> [[Surd; 3]; 2] {
        // The direction is not zero.
        let axis = self.direction.iter().position(|c| !c.is_zero()).unwrap_or_default();
        let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
        // The moment is p x d; with p_axis = 0 its other two components give p.
        let along = &self.direction[axis];
        let mut from = [(); 3].map(|()| Surd::from(Int::zero()));
        from[next] = &-&self.moment[last] / along;
        from[last] = &self.moment[next] / along;
        let to = [0, 1, 2].map(|i| &from[i] + &(&self.direction[i] / along));
        [from, to]
    }
}

/// The lines that meet all of `lines`.
///
/// # Panics
/// If `lines` is empty, longer than four, or holds something else than lines at a finite place.
pub fn transversals(lines: &[BigLine]) -> Transversals {
    assert!((1..=4).contains(&lines.len()), "transversals of {} lines", lines.len());
    for line in lines {
        assert!(line.direction.iter().any(|c| !c.is_zero()), "{line:?} is at infinity");
        assert!(dot(&line.direction, &line.moment).is_zero(), "{line:?} is not a line");
    }
    // side(x, l) = x · (moment of l, direction of l), x listed as direction, then moment.
    let rows: Vec<[Int; 6]> = lines.iter().map(|l| joined(&l.moment, &l.direction)).collect();
    let (independent, basis) = null_space(&rows);
    let basis: Vec<BigLine> = basis.into_iter().map(split).collect();
    let given: Vec<&BigLine> = independent.iter().map(|&i| &lines[i]).collect();
    let mut result = Transversals {
        rank: given.len(),
        isolated: Vec::new(),
        at_infinity: Vec::new(),
        families: Vec::new(),
    };
    match (given.as_slice(), basis.as_slice()) {
        ([_, _, _, _], [r, s]) => rank_four(r, s, &mut result),
        ([a, b, c], [u, v, w]) => result.families = rank_three([a, b, c], [u, v, w]),
        ([a, b], _) => result.families = rank_two(a, b),
        ([a], _) => result.families = vec![Family::Complex { axis: (*a).clone() }],
        _ => unreachable!("between one and four lines, none of them zero"),
    }
    result
}

/// Q(x) = direction · moment: zero for lines.
fn quadric(x: &BigLine) -> Int {
    dot(&x.direction, &x.moment)
}

/// The zeros of Q on the span of r and s.
fn rank_four(r: &BigLine, s: &BigLine, result: &mut Transversals) {
    let (q_r, q_s, mixed) = (quadric(r), quadric(s), r.side_product(s));
    if q_r.is_zero() && q_s.is_zero() && mixed.is_zero() {
        let (center, plane) = pencil_of(r, s);
        result.families.push(Family::Pencil { center, plane });
        return;
    }
    // Q(α·r + β·s) = α²·q_r + αβ·mixed + β²·q_s.
    let one = || Surd::from(Int::one());
    let roots: Vec<[Surd; 2]> = if q_s.is_zero() {
        // s itself, and α·q_r + β·mixed = 0.
        vec![[Surd::from(Int::zero()), one()], [Surd::from(mixed), Surd::from(-q_r)]]
    } else {
        let roots = Surd::roots_of_quadratic(&q_r, &mixed, &q_s);
        roots.into_iter().flatten().map(|beta| [one(), beta]).collect()
    };
    let double = match roots.as_slice() {
        // Proportional pairs of coefficients are one root counted twice.
        [[a, b], [c, d]] => (&(a * d) - &(b * c)).is_zero(),
        _ => false,
    };
    let multiplicity = if double { 2 } else { 1 };
    let distinct = if double { 1 } else { 2 };
    for [alpha, beta] in roots.iter().take(distinct) {
        let combine = |x: &[Int; 3], y: &[Int; 3]| {
            [0, 1, 2]
                .map(|i| &(alpha * &Surd::from(x[i].clone())) + &(beta * &Surd::from(y[i].clone())))
        };
        let direction = combine(&r.direction, &s.direction);
        let moment = combine(&r.moment, &s.moment);
        if direction.iter().all(Surd::is_zero) {
            let normal = scaled_to_one(&moment);
            result.at_infinity.push(InfiniteLine { normal, multiplicity });
        } else {
            result.isolated.push(IsolatedLine { direction, moment, multiplicity });
        }
    }
}

/// A vector divided by its first component that is not zero.
fn scaled_to_one(vector: &[Surd; 3]) -> [Surd; 3] {
    match vector.iter().find(|c| !c.is_zero()) {
        Some(leading) => [0, 1, 2].map(|i| &vector[i] / leading),
        None => vector.clone(),
    }
}

fn rank_three(given: [&BigLine; 3], basis: [&BigLine; 3]) -> Vec<Family> {
    let [a, b, c] = given;
    let gram = basis.map(|u| basis.map(|v| u.side_product(v)));
    if gram.iter().flatten().all(Zero::is_zero) {
        // The given lines meet each other, and not all do both: share a point and a plane.
        let (center, plane) = pencil_of(a, b);
        let family = match meet(c, &plane) {
            None => Family::PlaneField { plane },
            Some(_) => Family::Bundle { center },
        };
        return vec![family];
    }
    match radical(&gram) {
        None => vec![regulus(given)],
        Some(coefficients) => {
            let axis = combination(&coefficients, basis);
            other_lines(&gram, &coefficients)
                .map(|line| {
                    let (center, plane) = pencil_of(&axis, &combination(&line, basis));
                    Family::Pencil { center, plane }
                })
                .to_vec()
        }
    }
}

/// A vector of the kernel of a symmetric matrix that is not zero, if there is one.
fn radical(gram: &[[Int; 3]; 3]) -> Option<[Int; 3]> {
    let [x, y, z] = gram;
    if !dot(&cross(x, y), z).is_zero() {
        return None;
    }
    // The rank is two (see the module's table), so some two rows are independent.
    [cross(x, y), cross(y, z), cross(z, x)].into_iter().find(|v| v.iter().any(|c| !c.is_zero()))
}

/// Two zeros of a form of rank two, one off the kernel in each of its two isotropic planes.
fn other_lines(gram: &[[Int; 3]; 3], kernel: &[Int; 3]) -> [[Int; 3]; 2] {
    // The unit vectors but one that the kernel has a part in span a complement of the kernel.
    let dropped = kernel.iter().position(|c| !c.is_zero()).unwrap_or_default();
    let (i, j) = ((dropped + 1) % 3, (dropped + 2) % 3);
    let place = |alpha: Int, beta: Int| {
        let mut v = [(); 3].map(|()| Int::zero());
        v[i] = alpha;
        v[j] = beta;
        v
    };
    // α²·g_ii + 2αβ·g_ij + β²·g_jj = 0.
    let [g_ii, g_ij, g_jj] = [&gram[i][i], &gram[i][j], &gram[j][j]];
    if g_jj.is_zero() {
        return [place(Int::zero(), Int::one()), place(g_ij * 2, -g_ii)];
    }
    let quarter: Int = g_ij * g_ij - g_ii * g_jj;
    let root = quarter.sqrt();
    debug_assert_eq!(&root * &root, quarter, "the form splits over the rationals");
    [place(g_jj.clone(), -g_ij + &root), place(g_jj.clone(), -g_ij - root)]
}

/// The lines that meet three pairwise skew lines.
fn regulus(given: [&BigLine; 3]) -> Family {
    let [a, b, c] = given;
    // A finite point of a: the foot of the perpendicular, then steps along a.
    let weight = dot(&a.direction, &a.direction);
    let foot = cross(&a.direction, &a.moment);
    let line = |step: u8| {
        let step = &weight * step;
        let position = [0, 1, 2].map(|i| &foot[i] + &a.direction[i] * &step);
        let point = ProjectivePoint { position, weight: weight.clone() };
        // No point of a lies on b or c, which are skew to it; and their planes through the point
        // differ, since b and c are skew too.
        match (join(b, &point), join(c, &point)) {
            (Some(first), Some(second)) => meet_of_planes(&first, &second),
            _ => unreachable!("lines of a regulus are pairwise skew"),
        }
    };
    let paraboloid = dot(&cross(&a.direction, &b.direction), &c.direction).is_zero();
    Family::Regulus { lines: Box::new([line(0), line(1), line(2)]), paraboloid }
}

fn rank_two(a: &BigLine, b: &BigLine) -> Vec<Family> {
    if a.side_product(b).is_zero() {
        let (center, plane) = pencil_of(a, b);
        vec![Family::Bundle { center }, Family::PlaneField { plane }]
    } else {
        vec![Family::Congruence { axes: Box::new([a.clone(), b.clone()]) }]
    }
}

fn combination(coefficients: &[Int; 3], basis: [&BigLine; 3]) -> BigLine {
    let sum = |part: fn(&BigLine) -> &[Int; 3], i: usize| {
        coefficients.iter().zip(basis).map(|(k, line)| k * &part(line)[i]).sum()
    };
    let direction = [0, 1, 2].map(|i| sum(|line| &line.direction, i));
    let moment = [0, 1, 2].map(|i| sum(|line| &line.moment, i));
    BigLine { direction, moment }.primitive()
}

fn joined(first: &[Int; 3], second: &[Int; 3]) -> [Int; 6] {
    std::array::from_fn(|i| if i < 3 { first[i].clone() } else { second[i - 3].clone() })
}

fn split([a, b, c, d, e, f]: [Int; 6]) -> BigLine {
    BigLine { direction: [a, b, c], moment: [d, e, f] }
}

/// Whether a transversal of the line through p and q passes through the closed segment from p to
/// q (through the point, where the two are one).
///
/// With w(x) = direction × x + moment, which is zero exactly for the points of the transversal and
/// normal to its plane with x elsewhere: w(p) and w(q) are parallel, since all is in one plane, and
/// point opposite ways iff the transversal passes between p and q.
pub fn meets_segment(line: &IsolatedLine, p: &[Rational; 3], q: &[Rational; 3]) -> bool {
    let component = |point: &[Rational; 3], k: usize| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        let turned = &(&line.direction[i] * &Surd::from(point[j].clone()))
            - &(&line.direction[j] * &Surd::from(point[i].clone()));
        (&turned + &line.moment[k]).sign()
    };
    // Parallel vectors point opposite ways iff they do in a component that one of them has.
    (0..3)
        .map(|k| component(p, k) * component(q, k))
        .find(|product| *product != Sign::Zero)
        // Zero throughout: through an end point, which belongs to the segment.
        .is_none_or(|product| product == Sign::Negative)
}

#[cfg(test)]
mod tests;
