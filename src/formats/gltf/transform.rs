//! The transforms of nodes, exactly.
//!
//! A node states a matrix, or a translation, a rotation and a scale. The rotation of a quaternion
//! q = (x, y, z, w) has the entries of degree two in q over |q|², so a quaternion that is not quite
//! of unit length still gives a rotation (Shoemake, Animating rotation with quaternion curves,
//! 1985, for unit length).

use super::accessor::dyadic;
use crate::geom::RationalPoint3;
use crate::num::{Int, Rational};
use gltf::json::scene::Node;
use num_integer::Integer;
use num_traits::{One, Zero};

/// An affine map: the rows of a matrix, the last column the translation, over one denominator.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Affine {
    rows: [[Int; 4]; 3],
    /// Positive.
    denominator: Int,
}

/// Longer numbers come only from nodes nested for that purpose.
const MAX_BITS: u64 = 1 << 14;

impl Affine {
    pub fn identity() -> Affine {
        let rows = [0, 1, 2].map(|i| [0, 1, 2, 3].map(|j| Int::from(u8::from(i == j))));
        Affine { rows, denominator: Int::one() }
    }

    /// The transform that a node states, or why it is none.
    pub fn of_node(node: &Node) -> Result<Affine, &'static str> {
        let number = |bits: u32| dyadic(bits).ok_or("a number is infinite or not a number");
        if let Some(matrix) = &node.matrix {
            if node.translation.is_some() || node.rotation.is_some() || node.scale.is_some() {
                return Err("a matrix and one of translation, rotation and scale");
            }
            let columns = matrix.map(|entry| number(entry.to_bits()));
            let mut entries = Vec::with_capacity(16);
            for entry in columns {
                entries.push(entry?);
            }
            let entry = |row: usize, column: usize| entries[4 * column + row].clone();
            let bottom = [0, 1, 2, 3].map(|column| entry(3, column));
            if !bottom[..3].iter().all(Zero::is_zero) || !bottom[3].is_one() {
                return Err("the matrix's last row is not 0, 0, 0, 1");
            }
            return Ok(Affine::of([0, 1, 2].map(|i| [0, 1, 2, 3].map(|j| entry(i, j)))));
        }
        let mut rows = match &node.rotation {
            Some(rotation) => {
                let [x, y, z, w] = rotation.0.map(|entry| number(entry.to_bits()));
                rotation_of([x?, y?, z?, w?])?
            }
            None => {
                [0, 1, 2].map(|i| [0, 1, 2].map(|j| Rational::from(Int::from(i32::from(i == j)))))
            }
        };
        if let Some(scale) = &node.scale {
            for (column, factor) in scale.iter().enumerate() {
                let factor = number(factor.to_bits())?;
                rows.iter_mut().for_each(|row| row[column] *= &factor);
            }
        }
        let [a, b, c] = rows;
        let mut moved = [(); 3].map(|()| Rational::zero());
        for (coordinate, by) in moved.iter_mut().zip(node.translation.iter().flatten()) {
            *coordinate = number(by.to_bits())?;
        }
        let [x, y, z] = moved;
        let row = |[p, q, r]: [Rational; 3], by| [p, q, r, by];
        Ok(Affine::of([row(a, x), row(b, y), row(c, z)]))
    }

    fn of(rows: [[Rational; 4]; 3]) -> Affine {
        let all = rows.as_flattened();
        let denominator = all.iter().fold(Int::one(), |common, entry| common.lcm(entry.denom()));
        let scaled = |entry: &Rational| entry.numer() * (&denominator / entry.denom());
        Affine { rows: rows.each_ref().map(|row| row.each_ref().map(scaled)), denominator }
    }

    /// The map that applies `first` and then this one, or why it is not computed.
    pub fn after(&self, first: &Affine) -> Result<Affine, &'static str> {
        let entry = |row: &[Int; 4], column: usize| -> Int {
            let product: Int = (0..3).map(|k| &row[k] * &first.rows[k][column]).sum();
            if column == 3 { product + &row[3] * &first.denominator } else { product }
        };
        let rows = self.rows.each_ref().map(|row| [0, 1, 2, 3].map(|column| entry(row, column)));
        let denominator = &self.denominator * &first.denominator;
        let divisor = rows.as_flattened().iter().fold(denominator.clone(), |g, entry| g.gcd(entry));
        let reduced = Affine {
            rows: rows.map(|row| row.map(|entry| entry / &divisor)),
            denominator: denominator / divisor,
        };
        let longest = reduced.rows.as_flattened().iter().map(Int::bits).max();
        if longest.max(Some(reduced.denominator.bits())) > Some(MAX_BITS) {
            return Err("the transforms of nested nodes take more than 16384 bits");
        }
        Ok(reduced)
    }

    /// The image of a point.
    pub fn apply(&self, point: &RationalPoint3) -> RationalPoint3 {
        let ([x, y, z], w) = (point.numerators(), point.denominator());
        let image = self.rows.each_ref().map(|[a, b, c, d]| a * x + b * y + c * z + d * w);
        RationalPoint3::new(image, &self.denominator * w)
    }
}

/// The rotation of a quaternion, which need not have unit length.
fn rotation_of([x, y, z, w]: [Rational; 4]) -> Result<[[Rational; 3]; 3], &'static str> {
    let length = &x * &x + &y * &y + &z * &z + &w * &w;
    if length.is_zero() {
        return Err("the rotation's quaternion is zero");
    }
    let two = || Rational::from(Int::from(2));
    let twice = |a: &Rational, b: &Rational| two() * a * b;
    let diagonal = |a: &Rational, b: &Rational| &length - two() * (a * a + b * b);
    let rows = [
        [diagonal(&y, &z), twice(&x, &y) - twice(&z, &w), twice(&x, &z) + twice(&y, &w)],
        [twice(&x, &y) + twice(&z, &w), diagonal(&x, &z), twice(&y, &z) - twice(&x, &w)],
        [twice(&x, &z) - twice(&y, &w), twice(&y, &z) + twice(&x, &w), diagonal(&x, &y)],
    ];
    Ok(rows.map(|row| row.map(|entry| entry / &length)))
}
