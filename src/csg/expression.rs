//! Expressions of brushes: their operators, common brushes, affine maps.

use crate::geom::BigPlane;
use crate::geom::vector::{cross, determinant, difference, dot};
use crate::num::{Int, Rational, Sign};
use num_integer::Integer;
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

/// An expression over brushes by number.
pub(super) enum Formula {
    Brush(usize),
    Any(Vec<Formula>),
    All(Vec<Formula>),
    Not(Box<Formula>),
}

/// An expression's brushes with integer planes, and the expression over them.
pub(super) struct Flat {
    pub brushes: Vec<Vec<BigPlane>>,
    pub formula: Formula,
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

    /// The half-space of the images of a half-space's points. Requires: the map is invertible.
    fn image(&self, half: &Half) -> Half {
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
    /// The box with these opposite corners.
    pub fn cuboid(low: &[Rational; 3], high: &[Rational; 3]) -> Expression {
        let half = |axis: usize, sign: i32, offset: &Rational| {
            let mut normal = [(); 3].map(|()| Rational::zero());
            normal[axis] = Rational::from(Int::from(sign));
            Half { normal, offset: offset * Int::from(sign) }
        };
        let of_axis = |axis: usize| [half(axis, -1, &low[axis]), half(axis, 1, &high[axis])];
        Expression::Brush((0..3).flat_map(of_axis).collect())
    }

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

/// The half-space of points on the side of `inner` of the plane through three points; `None` if
/// that point is on the plane, or the three are collinear.
fn half_through(points: [&[Rational; 3]; 3], inner: &[Rational; 3]) -> Option<Half> {
    let [a, b, c] = points;
    let normal = cross(&difference(b, a), &difference(c, a));
    let offset = dot(&normal, a);
    match Sign::of(&(dot(&normal, inner) - &offset)) {
        Sign::Negative => Some(Half { normal, offset }),
        Sign::Positive => Some(Half { normal: normal.map(|c| -c), offset: -offset }),
        // Also where the three points are collinear: the normal is zero then.
        Sign::Zero => None,
    }
}

/// The convex hull of points, by its supporting planes; without half-spaces if they lie in one
/// plane. Cubic in the points for the planes, times the points.
pub fn hull(points: &[[Rational; 3]]) -> Vec<Half> {
    let count = Rational::from(Int::from(points.len()));
    let center: [Rational; 3] =
        std::array::from_fn(|i| points.iter().map(|p| &p[i]).sum::<Rational>() / &count);
    let mut halves: Vec<Half> = Vec::new();
    for (i, a) in points.iter().enumerate() {
        for (j, b) in points.iter().enumerate().skip(i + 1) {
            for c in &points[j + 1..] {
                let Some(half) = half_through([a, b, c], &center) else { continue };
                if points.iter().all(|p| dot(&half.normal, p) <= half.offset) {
                    halves.push(half);
                }
            }
        }
    }
    halves
}

/// The prism over a convex polygon of the plane, from one height to another.
pub fn prism(polygon: &[[Rational; 2]], heights: &[Rational; 2]) -> Vec<Half> {
    let at = |[x, y]: &[Rational; 2], z: &Rational| [x.clone(), y.clone(), z.clone()];
    let points: Vec<_> =
        heights.iter().flat_map(|z| polygon.iter().map(move |p| at(p, z))).collect();
    hull(&points)
}

/// The pyramid over a convex polygon at a height, up or down to its apex.
pub fn pyramid(polygon: &[[Rational; 2]], height: &Rational, apex: &[Rational; 3]) -> Vec<Half> {
    let mut points: Vec<_> =
        polygon.iter().map(|[x, y]| [x.clone(), y.clone(), height.clone()]).collect();
    points.push(apex.clone());
    hull(&points)
}

pub(super) fn flatten(expression: &Expression) -> Flat {
    let mut brushes = Vec::new();
    let formula = numbered(expression, &mut brushes);
    Flat { brushes, formula }
}

fn numbered(expression: &Expression, brushes: &mut Vec<Vec<BigPlane>>) -> Formula {
    match expression {
        Expression::Brush(halves) => {
            brushes.push(halves.iter().map(integer_plane).collect());
            Formula::Brush(brushes.len() - 1)
        }
        Expression::Union(of) => Formula::Any(of.iter().map(|e| numbered(e, brushes)).collect()),
        Expression::Intersection(of) => {
            Formula::All(of.iter().map(|e| numbered(e, brushes)).collect())
        }
        Expression::Difference(from, of) => {
            let from = numbered(from, brushes);
            let of = Formula::Any(of.iter().map(|e| numbered(e, brushes)).collect());
            Formula::All(vec![from, Formula::Not(Box::new(of))])
        }
        Expression::Complement(of) => Formula::Not(Box::new(numbered(of, brushes))),
    }
}

fn integer_plane(half: &Half) -> BigPlane {
    let all = || half.normal.iter().chain([&half.offset]);
    let scale = all().fold(Int::from(1), |lcm, c| lcm.lcm(c.denom()));
    let whole = |c: &Rational| (c * &scale).to_integer();
    BigPlane { normal: half.normal.each_ref().map(whole), offset: whole(&half.offset) }
}

impl Formula {
    /// The value where some brushes are known to hold or not; `None` where the others matter.
    pub(super) fn value(&self, known: &[Option<bool>]) -> Option<bool> {
        match self {
            Formula::Brush(brush) => known[*brush],
            Formula::Any(of) => fold(of, known, true),
            Formula::All(of) => fold(of, known, false),
            Formula::Not(of) => of.value(known).map(|value| !value),
        }
    }
}

/// `decisive` if one of them is that; its opposite if all are; else unknown.
fn fold(of: &[Formula], known: &[Option<bool>], decisive: bool) -> Option<bool> {
    let mut all_known = true;
    for formula in of {
        match formula.value(known) {
            Some(value) if value == decisive => return Some(decisive),
            Some(_) => {}
            None => all_known = false,
        }
    }
    all_known.then_some(!decisive)
}
