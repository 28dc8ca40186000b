//! Vertices of cut polygons against planes: three planes meet once, and the meet is then held
//! against many others.
//!
//! The meet of the planes n·x = o is kept in homogeneous coordinates (x, y, z, w), integers that
//! are never rounded: the 3x3 minors of the planes' coefficients, w their normals' determinant,
//! made positive. Beside them stand their nearest floats, for the filter. However deep a tree of
//! cuts is, its vertices are meets of three of the given planes, so their size is bounded once
//! for all (Sugihara and Iri, A solid modelling system free from topological inconsistency,
//! 1989).

use super::budget::U;
use super::counters::{Predicate, Stage, record};
use crate::geom::{BigPlane, RationalPoint3};
use crate::num::{Int, Int256, Sign};
use num_integer::Integer;
use num_traits::{ToPrimitive, Zero};

/// A plane as the stages of [`side_of_vertex`] read it.
#[derive(Clone, Debug)]
pub struct VertexPlane {
    /// The nearest floats of the normal and of the negated offset.
    floats: [f64; 4],
    /// The normal and the negated offset, where 127 bits hold them.
    fixed: Option<Fixed>,
    plane: BigPlane,
}

/// Four integers below 2^`bits`; of a plane, the first three are below 2^`normal_bits`.
#[derive(Clone, Copy, Debug)]
struct Fixed {
    values: [i128; 4],
    bits: u32,
    normal_bits: u32,
}

/// The point in which three planes meet.
#[derive(Clone, Debug)]
pub struct Vertex {
    /// The nearest floats of the homogeneous coordinates.
    floats: [f64; 4],
    exact: Homogeneous,
}

#[derive(Clone, Debug)]
enum Homogeneous {
    Fixed { values: [i128; 4], bits: u32 },
    Big(Box<[Int; 4]>),
}

impl VertexPlane {
    /// The plane with all that the stages need of it.
    pub fn new(plane: BigPlane) -> VertexPlane {
        let [a, b, c] = plane.normal.clone();
        let coefficients = [a, b, c, -&plane.offset];
        let fixed = || {
            let mut values = [0; 4];
            for (value, coefficient) in values.iter_mut().zip(&coefficients) {
                *value = coefficient.to_i128().filter(|c| *c != i128::MIN)?;
            }
            Some(Fixed { values, bits: bits(&values), normal_bits: bits(&values[..3]) })
        };
        VertexPlane { floats: coefficients.each_ref().map(nearest), fixed: fixed(), plane }
    }

    /// The coefficients.
    pub fn plane(&self) -> &BigPlane {
        &self.plane
    }
}

impl Vertex {
    /// The point in which three planes meet; `None` where they have none or more in common.
    ///
    /// With |n| < 2^a and |o| < 2^b, minors of normals are below 2^(2a+1), x, y and z (three
    /// products of an offset and a minor) below 2^(2a+b+3), w below 2^(3a+3).
    pub fn meet(planes: [&VertexPlane; 3]) -> Option<Vertex> {
        let fixed = planes.map(|plane| plane.fixed);
        if let [Some(p), Some(q), Some(r)] = fixed {
            let normal_bits = p.normal_bits.max(q.normal_bits).max(r.normal_bits);
            let all_bits = p.bits.max(q.bits).max(r.bits);
            if 2 * normal_bits + all_bits + 3 <= 127 {
                return Vertex::of_fixed(meet(&[p.values, q.values, r.values]));
            }
        }
        let rows = planes.map(|plane| {
            let [a, b, c] = plane.plane.normal.clone();
            [a, b, c, -&plane.plane.offset]
        });
        let exact = meet(&rows);
        let exact = match Sign::of(&exact[3]) {
            Sign::Negative => exact.map(|c| -c),
            // The normals are in one plane: nothing, or a line, or a plane is common.
            Sign::Zero => return None,
            Sign::Positive => exact,
        };
        let floats = exact.each_ref().map(nearest);
        Some(Vertex { floats, exact: Homogeneous::Big(Box::new(exact)) })
    }

    fn of_fixed(values: [i128; 4]) -> Option<Vertex> {
        let values = match Sign::of(&values[3]) {
            Sign::Negative => values.map(|c| -c),
            // The normals are in one plane: nothing, or a line, or a plane is common.
            Sign::Zero => return None,
            Sign::Positive => values,
        };
        let exact = Homogeneous::Fixed { values, bits: bits(&values) };
        Some(Vertex { floats: values.map(|c| c as f64), exact })
    }

    /// The point in lowest terms.
    pub fn point(&self) -> RationalPoint3 {
        let [x, y, z, w] = match &self.exact {
            // Most divisors are one; in machine integers that is known without an allocation.
            Homogeneous::Fixed { values, .. } => {
                let divisor = values.iter().fold(0, |divisor: i128, c| divisor.gcd(c));
                values.map(|c| Int::from(c / divisor))
            }
            Homogeneous::Big(values) => (**values).clone(),
        };
        RationalPoint3::new([x, y, z], w)
    }
}

/// On which side of `plane` the vertex lies.
///
/// Positive: on the side that the normal points to; zero: in the plane.
///
/// 1. Flipping the plane changes the sign; the order and the direction of the three planes that
///    meet in the vertex do not matter.
/// 2. Translation and positive scaling keep it.
///
/// Requires: nothing; coefficients of any size are decided.
///
/// Contract: exact, degree 9, unperturbed
///
/// Source: the definition of a plane's sides, in homogeneous coordinates with w > 0; it equals
/// [`vertex_side_of_plane`](super::vertex_side_of_plane), which keeps no meets.
#[inline]
pub fn side_of_vertex(plane: &VertexPlane, vertex: &Vertex) -> Sign {
    if let Some(sign) = side_of_vertex_filter(plane, vertex) {
        record(Predicate::VertexSideOfPlane, Stage::Filter);
        return sign;
    }
    side_of_vertex_exact(plane, vertex)
}

/// The float stage of [`side_of_vertex`].
///
/// Every factor is within a factor 1 + δ, |δ| <= u, of its integer; each of the four products
/// adds one such factor, the sum at most three: the value is off by at most 6u·S and terms of
/// higher order, where S is the sum of the magnitudes of the exact products. The S computed is
/// at least (1 - 6u)S before the same higher orders, so 8u times it is a bound. Factors are
/// integers: no underflow. Where something overflows, the bound is infinite or not a number, and
/// the comparison fails.
#[inline]
pub fn side_of_vertex_filter(plane: &VertexPlane, vertex: &Vertex) -> Option<Sign> {
    let (n, v) = (&plane.floats, &vertex.floats);
    let [a, b, c, d] = [n[0] * v[0], n[1] * v[1], n[2] * v[2], n[3] * v[3]];
    let value = (a + b) + (c + d);
    let scale = (a.abs() + b.abs()) + (c.abs() + d.abs());
    (value.abs() > 8.0 * U * scale).then(|| Sign::of(&value))
}

/// The stages of [`side_of_vertex`] in integers: fixed ones where the sizes allow them.
///
/// A product of factors below 2^p and 2^q is below 2^(p+q), the sum of four below 2^(p+q+2).
pub fn side_of_vertex_exact(plane: &VertexPlane, vertex: &Vertex) -> Sign {
    if let (Some(n), Homogeneous::Fixed { values: v, bits }) = (&plane.fixed, &vertex.exact) {
        let total = n.bits + bits + 2;
        let n = &n.values;
        if total <= 127 {
            record(Predicate::VertexSideOfPlane, Stage::Fixed);
            return Sign::of(&(n[0] * v[0] + n[1] * v[1] + n[2] * v[2] + n[3] * v[3]));
        }
        if total <= 255 {
            record(Predicate::VertexSideOfPlane, Stage::Fixed);
            let term = |i: usize| Int256::product(n[i], v[i]);
            return (term(0) + term(1) + term(2) + term(3)).sign();
        }
    }
    side_of_vertex_big(plane, vertex)
}

/// [`side_of_vertex`] in unbounded integers.
pub fn side_of_vertex_big(plane: &VertexPlane, vertex: &Vertex) -> Sign {
    record(Predicate::VertexSideOfPlane, Stage::Big);
    let BigPlane { normal: [a, b, c], offset } = &plane.plane;
    let value = match &vertex.exact {
        Homogeneous::Fixed { values: [x, y, z, w], .. } => a * x + b * y + c * z - offset * w,
        Homogeneous::Big(values) => {
            let [x, y, z, w] = &**values;
            a * x + b * y + c * z - offset * w
        }
    };
    Sign::of(&value)
}

/// Where a rational point lies with respect to a plane: positive on the side that the normal
/// points to, zero in the plane.
///
/// Positive: on the side that the normal points to.
///
/// Contract: exact, degree 3, unperturbed
pub fn side_of_point(plane: &VertexPlane, point: &RationalPoint3) -> Sign {
    let [x, y, z] = point.numerators();
    let BigPlane { normal: [a, b, c], offset } = &plane.plane;
    Sign::of(&(a * x + b * y + c * z - offset * point.denominator()))
}

/// The homogeneous coordinates of the meet of three planes, rows (n, -o): by Cramer's rule
/// w = det(n1, n2, n3) and (x, y, z) = o1·n2xn3 + o2·n3xn1 + o3·n1xn2.
fn meet<T>(rows: &[[T; 4]; 3]) -> [T; 4]
where
    T: std::ops::Neg<Output = T> + std::iter::Sum,
    for<'a> &'a T: std::ops::Mul<&'a T, Output = T>,
    T: std::ops::Sub<Output = T>,
{
    let minor = |p: &[T; 4], q: &[T; 4], i: usize| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        &p[j] * &q[k] - &p[k] * &q[j]
    };
    let pairs = [(1, 2), (2, 0), (0, 1)];
    let minors = pairs.map(|(p, q)| [0, 1, 2].map(|i| minor(&rows[p], &rows[q], i)));
    let coordinate = |i: usize| -(0..3).map(|r| &rows[r][3] * &minors[r][i]).sum::<T>();
    let weight = (0..3).map(|i| &rows[0][i] * &minors[0][i]).sum();
    [coordinate(0), coordinate(1), coordinate(2), weight]
}

/// The least n with |v| < 2^n for all values.
fn bits(values: &[i128]) -> u32 {
    let all = values.iter().fold(0, |all, v| all | v.unsigned_abs());
    128 - all.leading_zeros()
}

/// The nearest float; infinite where none is near, which no filter trusts.
fn nearest(value: &Int) -> f64 {
    if value.is_zero() { 0.0 } else { value.to_f64().unwrap_or(f64::INFINITY) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::predicates::vertex_side_of_plane_big;

    fn plane(coefficients: [i64; 4], scale: u32) -> VertexPlane {
        let [a, b, c, d] = coefficients.map(|c| Int::from(c) << scale);
        VertexPlane::new(BigPlane { normal: [a, b, c], offset: d })
    }

    /// A small generator of pseudo-random numbers (Marsaglia, Xorshift RNGs, 2003).
    fn random(state: &mut u64, limit: i64) -> i64 {
        *state ^= *state << 13;
        *state ^= *state >> 7;
        *state ^= *state << 17;
        (*state % (2 * limit as u64 + 1)) as i64 - limit
    }

    #[test]
    fn all_stages_agree_with_the_determinant() {
        let mut state = 88_172_645_463_325_252;
        // Scaled so that 127 bits, 255 bits and unbounded integers decide.
        for scale in [0, 20, 26, 34, 60, 130, 400] {
            let mut met = [0; 3];
            for _ in 0..2000 {
                let planes: [VertexPlane; 4] = std::array::from_fn(|_| {
                    plane(std::array::from_fn(|_| random(&mut state, 2)), scale)
                });
                let [p, q, r, s] = &planes;
                let big = planes.each_ref().map(|plane| plane.plane());
                let expected = vertex_side_of_plane_big([big[0], big[1], big[2]], big[3]);
                let vertex = Vertex::meet([p, q, r]);
                assert_eq!(vertex.is_some(), expected.is_some());
                let (Some(vertex), Some(expected)) = (vertex, expected) else { continue };
                assert_eq!(side_of_vertex(s, &vertex), expected);
                assert_eq!(side_of_vertex_exact(s, &vertex), expected);
                assert_eq!(side_of_vertex_big(s, &vertex), expected);
                assert_eq!(side_of_point(s, &vertex.point()), expected);
                let filter = side_of_vertex_filter(s, &vertex);
                assert!(filter.is_none_or(|sign| sign == expected));
                for own in [p, q, r] {
                    assert_eq!(side_of_vertex(own, &vertex), Sign::Zero);
                }
                met[(expected as i8 + 1) as usize] += 1;
            }
            assert!(met.iter().all(|&count| count > 20), "{scale}: {met:?}");
        }
    }
}
