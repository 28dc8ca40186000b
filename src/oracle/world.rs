//! The twin of a world's visibility: whether two points see each other, straight from the
//! occluders.
//!
//! Every occluder is the intersection of closed half-spaces: a solid that of its planes, a polygon
//! that of its plane in both directions and of one plane through each edge. A segment misses it iff
//! the half-spaces leave nothing of the segment's parameters, an interval of rationals. There are
//! no cells, no portals and no lines here, so nothing is shared with what is checked.
//!
//! Complexity: one or two plane evaluations at each end, for each plane of each occluder.

use crate::geom::{BigPlane, RationalPoint3};
use crate::num::{Int, Rational};
use num_traits::{One, Signed, Zero};

/// What stands between points: closed convex sets.
#[derive(Clone, Debug, Default)]
pub struct Occluders {
    /// Each the common part of the closed negative sides of its planes.
    sets: Vec<Vec<BigPlane>>,
}

impl Occluders {
    /// Adds the solid on the negative side of all planes.
    pub fn add_solid(&mut self, planes: &[BigPlane]) {
        self.sets.push(planes.to_vec());
    }

    /// Adds a planar convex polygon of three or more vertices.
    pub fn add_polygon(&mut self, vertices: &[RationalPoint3]) {
        let points: Vec<_> = vertices.iter().map(RationalPoint3::coordinates).collect();
        let edge = |i: usize| minus(&points[(i + 1) % points.len()], &points[i]);
        let normal = cross(&edge(0), &edge(1));
        let back = normal.each_ref().map(|c| -c);
        let mut planes = vec![plane(&normal, &points[0]), plane(&back, &points[0])];
        planes.extend((0..points.len()).map(|i| plane(&cross(&edge(i), &normal), &points[i])));
        self.sets.push(planes);
    }

    /// Whether the point lies in no occluder.
    pub fn leaves_free(&self, point: &RationalPoint3) -> bool {
        self.between(point, point).is_none()
    }

    /// Whether the closed segment between two points meets no occluder.
    pub fn let_see(&self, p: &RationalPoint3, q: &RationalPoint3) -> bool {
        self.between(p, q).is_none()
    }

    /// The first occluder, in the order in which they were added, that the closed segment meets.
    pub fn between(&self, p: &RationalPoint3, q: &RationalPoint3) -> Option<usize> {
        self.sets.iter().position(|planes| meets(planes, p, q))
    }
}

/// Whether p + t·(q - p) lies on no positive side for some t from 0 to 1.
fn meets(planes: &[BigPlane], p: &RationalPoint3, q: &RationalPoint3) -> bool {
    let (mut low, mut high) = (Rational::zero(), Rational::one());
    for plane in planes {
        let (a, b) = (height(plane, p), height(plane, q));
        match (a.is_positive(), b.is_positive()) {
            (true, true) => return false,
            (false, false) => {}
            // Heights over p's and q's denominators; the ratio needs them over a common one.
            (enters, _) => {
                let (a, b) = (a * q.denominator(), b * p.denominator());
                let at = Rational::new(a.clone(), a - b);
                match enters {
                    true => low = low.max(at),
                    false => high = high.min(at),
                }
                if low > high {
                    return false;
                }
            }
        }
    }
    true
}

/// The middle of what of the line through two points lies within a bounded convex set, given by
/// its planes, outward; `None` where that is no segment in its interior.
pub fn middle_within([p, q]: [&RationalPoint3; 2], planes: &[BigPlane]) -> Option<RationalPoint3> {
    let (mut low, mut high): (Option<Rational>, Option<Rational>) = (None, None);
    for plane in planes {
        let (a, b) = (height(plane, p) * q.denominator(), height(plane, q) * p.denominator());
        let rise = &b - &a;
        if rise.is_zero() {
            if !a.is_negative() {
                return None;
            }
            continue;
        }
        let is_end = rise.is_positive();
        let at = Rational::new(-a, rise);
        if is_end {
            high = Some(high.map_or(at.clone(), |high| high.min(at)));
        } else {
            low = Some(low.map_or(at.clone(), |low| low.max(at)));
        }
    }
    let (low, high) = (low?, high?);
    (low < high).then(|| {
        let at = (low + high) / Int::from(2);
        let (p, q) = (p.coordinates(), q.coordinates());
        RationalPoint3::from(&[0, 1, 2].map(|i| &p[i] + &at * (&q[i] - &p[i])))
    })
}

/// n·x - offset at a point, times the point's denominator.
fn height(plane: &BigPlane, point: &RationalPoint3) -> Int {
    let sum: Int = plane.normal.iter().zip(point.numerators()).map(|(n, x)| n * x).sum();
    sum - &plane.offset * point.denominator()
}

/// The plane with this normal through a point.
fn plane(normal: &[Rational; 3], point: &[Rational; 3]) -> BigPlane {
    let offset: Rational = normal.iter().zip(point).map(|(n, x)| n * x).sum();
    let scale = normal.iter().fold(offset.denom().clone(), |scale, c| scale * c.denom());
    let integer = |c: &Rational| (c * &scale).to_integer();
    BigPlane { normal: normal.each_ref().map(integer), offset: integer(&offset) }
}

fn minus(a: &[Rational; 3], b: &[Rational; 3]) -> [Rational; 3] {
    [0, 1, 2].map(|i| &a[i] - &b[i])
}

fn cross(a: &[Rational; 3], b: &[Rational; 3]) -> [Rational; 3] {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| &a[i] * &b[j] - &a[j] * &b[i])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn point(numerators: [i64; 3], denominator: i64) -> RationalPoint3 {
        RationalPoint3::new(numerators.map(Int::from), Int::from(denominator))
    }

    fn cuboid(low: [i64; 3], high: [i64; 3]) -> Vec<BigPlane> {
        let side = |i: usize, sign: i64, at: i64| BigPlane {
            normal: std::array::from_fn(|j| Int::from(if i == j { sign } else { 0 })),
            offset: Int::from(sign * at),
        };
        (0..3).flat_map(|i| [side(i, 1, high[i]), side(i, -1, low[i])]).collect()
    }

    #[test]
    fn a_segment_is_stopped_by_any_point_of_a_closed_solid() {
        let mut cube = Occluders::default();
        cube.add_solid(&cuboid([0; 3], [2; 3]));
        let sees = |p, q| {
            let forth = cube.let_see(&point(p, 1), &point(q, 1));
            assert_eq!(forth, cube.let_see(&point(q, 1), &point(p, 1)));
            forth
        };
        assert!(!sees([-1, 1, 1], [3, 1, 1]), "through the middle");
        assert!(!sees([-1, 0, 1], [3, 0, 1]), "along a face");
        assert!(!sees([-1, 0, 0], [3, 0, 0]), "along an edge");
        assert!(!sees([-1, 1, 0], [1, -1, 0]), "through a corner, across");
        assert!(!sees([-1, 1, 1], [0, 1, 1]), "up to a face");
        assert!(!sees([1, 1, 1], [1, 1, 5]), "from within");
        assert!(sees([-2, 1, 1], [-1, 1, 1]), "short of it");
        assert!(sees([-1, 0, 1], [0, -1, 1]), "past an edge");
        assert!(!cube.leaves_free(&point([4, 0, 3], 2)) && cube.leaves_free(&point([5, 0, 3], 2)));
    }

    #[test]
    fn the_middle_of_a_line_within_a_solid_is_inside() {
        let cube = cuboid([0; 3], [2; 3]);
        let middle = |p, q| middle_within([&point(p, 1), &point(q, 1)], &cube);
        assert_eq!(middle([5, 1, 1], [9, 1, 1]), Some(point([1; 3], 1)));
        assert_eq!(middle([0; 3], [1, 1, 2]), Some(point([1, 1, 2], 2)));
        assert_eq!(middle([1, 0, 1], [2, 0, 1]), None, "along a face");
        assert_eq!(middle([-1, 1, 0], [1, -1, 0]), None, "through an edge");
    }

    #[test]
    fn a_segment_is_stopped_by_any_point_of_a_closed_polygon() {
        let mut square = Occluders::default();
        square.add_polygon(&[[1, 0, 0], [1, 2, 0], [1, 2, 2], [1, 0, 2]].map(|p| point(p, 2)));
        let sees = |p, q| square.let_see(&point(p, 2), &point(q, 2));
        assert!(!sees([0, 1, 1], [2, 1, 1]) && !sees([2, 1, 1], [0, 1, 1]), "across");
        assert!(!sees([0, 2, 1], [2, 2, 1]), "across an edge");
        assert!(!sees([1, -1, 1], [1, 3, 1]), "within its plane");
        assert!(!sees([1, 1, 3], [1, 3, 1]), "within its plane, through a vertex");
        assert!(sees([1, 2, 4], [1, 4, 2]), "within its plane, past a vertex");
        assert!(sees([0, 3, 1], [2, 3, 1]) && sees([0, 1, 1], [0, 2, 1]), "past it");
    }
}
