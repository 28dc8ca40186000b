//! Plücker vectors that need not come from two points: from rational points, in lowest terms, at
//! infinity.
//!
//! Any six integers may stand in a [`BigLine`]: they are a line where `direction · moment = 0` and
//! not all are zero, and a line at infinity where the direction is zero; the moment is then the
//! normal of the planes that contain it.

use super::BigLine;
use super::vector::{cross, dot};
use crate::num::{Int, Rational};
use num_integer::Integer;
use num_traits::{One, Zero};

impl BigLine {
    /// The line from `p` to `q` in lowest terms, or `None` if they are one point.
    pub fn through_rational(p: &[Rational; 3], q: &[Rational; 3]) -> Option<BigLine> {
        let common = p.iter().chain(q).fold(Int::one(), |c, x| c.lcm(x.denom()));
        let whole = |v: &[Rational; 3]| [0, 1, 2].map(|i| v[i].numer() * (&common / v[i].denom()));
        let (p, q) = (whole(p), whole(q));
        // (q - p)/c and (p x q)/c² are the true coordinates.
        let direction = [0, 1, 2].map(|i| (&q[i] - &p[i]) * &common);
        let line = BigLine { direction, moment: cross(&p, &q) };
        (!line.direction.iter().all(Zero::is_zero)).then(|| line.primitive())
    }

    /// The same line with coordinates that have no common factor.
    #[must_use]
    pub fn primitive(&self) -> BigLine {
        let divisor = self.direction.iter().chain(&self.moment).fold(Int::zero(), |g, c| g.gcd(c));
        if divisor.is_zero() {
            return self.clone();
        }
        let divide = |v: &[Int; 3]| [0, 1, 2].map(|i| &v[i] / &divisor);
        BigLine { direction: divide(&self.direction), moment: divide(&self.moment) }
    }

    /// The side product with another line, `d1·m2 + m1·d2`: positive where this line passes the
    /// other as a line through the inside of a portal passes the portal's edges, zero where the
    /// two are coplanar.
    pub fn side_product(&self, other: &BigLine) -> Int {
        dot(&self.direction, &other.moment) + dot(&self.moment, &other.direction)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geom::BigPoint3;

    fn point(p: [i64; 3]) -> BigPoint3 {
        BigPoint3 { coordinates: p.map(Int::from) }
    }

    #[test]
    fn the_side_product_is_the_determinant_of_four_points() {
        let [a, b, c, d] = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]].map(point);
        let side = |p: &BigPoint3, q: &BigPoint3, r: &BigPoint3, s: &BigPoint3| {
            BigLine::through(p, q).side_product(&BigLine::through(r, s))
        };
        assert_eq!(side(&a, &b, &c, &d), Int::one());
        assert_eq!(side(&c, &d, &a, &b), Int::one());
        assert_eq!(side(&b, &a, &c, &d), -Int::one());
        assert_eq!(side(&a, &b, &a, &d), Int::zero());
    }

    #[test]
    fn rational_points_give_a_line_in_lowest_terms() {
        let half = |v: [i64; 3]| v.map(|c| Rational::new(Int::from(c), Int::from(2)));
        // From (1/2, 1, 3/2) to (3/2, 1, 1/2).
        let line = BigLine::through_rational(&half([1, 2, 3]), &half([3, 2, 1])).unwrap();
        assert_eq!(line.direction, [1, 0, -1].map(Int::from));
        assert_eq!(line.moment, [-1, 2, -1].map(Int::from));
        assert_eq!(BigLine::through_rational(&half([1, 1, 1]), &half([1, 1, 1])), None);
    }
}
