//! Expressions of brushes: their operators, affine maps.

use crate::geom::vector::{cross, determinant, dot};
use crate::num::{Int, Rational, Sign};
use num_traits::Zero;

/// A half-space `normal · x <= offset` with rational coefficients.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Half {
    /// Points out of the half-space.
    pub normal: [Rational; 3],
    /// The offset along the normal.
    pub offset: Rational,
}

/// An affine map `x -> matrix · x + shift`, which must be invertible.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Transform {
    /// The linear part, by rows.
    pub matrix: [[Rational; 3]; 3],
    /// The translation.
    pub shift: [Rational; 3],
}

/// A set of points, by brushes and operators.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Expression {
    /// The intersection of half-spaces.
    Brush(Vec<Half>),
    /// What is in one of them at least.
    Union(Vec<Expression>),
    /// What is in all of them.
    Intersection(Vec<Expression>),
    /// What is in the first and in none of the others.
    Difference(Box<Expression>, Vec<Expression>),
    /// What is not in it.
    Complement(Box<Expression>),
}

impl Transform {
    /// The factor by which it scales volumes, negative if it mirrors.
    pub fn scale(&self) -> Rational {
        determinant(self.matrix.each_ref())
    }

    /// Whether it can be undone.
    pub fn is_invertible(&self) -> bool {
        !self.scale().is_zero()
    }

    /// The map that changes nothing.
    pub fn identity() -> Transform {
        let unit = |i: usize, j: usize| Rational::from(Int::from(u8::from(i == j)));
        Transform {
            matrix: std::array::from_fn(|i| std::array::from_fn(|j| unit(i, j))),
            shift: [(); 3].map(|()| Rational::zero()),
        }
    }

    /// The map that does `first`, then this one.
    #[must_use]
    pub fn after(&self, first: &Transform) -> Transform {
        let column = |j: usize| [0, 1, 2].map(|i| first.matrix[i][j].clone());
        let columns = [0, 1, 2].map(column);
        Transform {
            matrix: self.matrix.each_ref().map(|row| columns.each_ref().map(|c| dot(row, c))),
            shift: std::array::from_fn(|i| dot(&self.matrix[i], &first.shift) + &self.shift[i]),
        }
    }

    /// The half-space of the images of a half-space's points. Requires: the map is invertible.
    pub fn image(&self, half: &Half) -> Half {
        // n · x <= c with x = M^-1 (y - s): the new normal is M^-T n, times |det M| to spare the
        // division. With the rows a, b, c of M, det M · M^-T has the rows b × c, c × a, a × b.
        let [a, b, c] = &self.matrix;
        let cofactors = [cross(b, c), cross(c, a), cross(a, b)];
        let normal = cofactors.each_ref().map(|row| dot(row, &half.normal));
        let (normal, scale) = match Sign::of(&self.scale()) {
            // Zero: not an invertible map, of which nothing is promised.
            Sign::Positive | Sign::Zero => (normal, self.scale()),
            Sign::Negative => (normal.map(|c| -c), -self.scale()),
        };
        let along = dot(&normal, &self.shift);
        Half { normal, offset: &half.offset * scale + along }
    }
}

impl Expression {
    /// The image under an affine map. Requires: the map is invertible.
    pub fn transformed(&self, map: &Transform) -> Expression {
        let all = |of: &[Expression]| of.iter().map(|one| one.transformed(map)).collect();
        match self {
            Expression::Brush(halves) => {
                Expression::Brush(halves.iter().map(|half| map.image(half)).collect())
            }
            Expression::Union(of) => Expression::Union(all(of)),
            Expression::Intersection(of) => Expression::Intersection(all(of)),
            Expression::Difference(from, of) => {
                Expression::Difference(Box::new(from.transformed(map)), all(of))
            }
            Expression::Complement(of) => Expression::Complement(Box::new(of.transformed(map))),
        }
    }
}
