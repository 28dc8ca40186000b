//! Boxes, half-spaces and clipping in rationals, and segments against solids: nothing of the
//! engine.

use num_traits::{Signed, Zero};
use stabline::construct::Polyhedron;
use stabline::geom::{AxialBox, BigPlane, RationalPoint3};
use stabline::num::{Int, Rational};
use stabline::oracle::Random;
use stabline::portal::WorldCells;
use stabline::scene::CellId;
use stabline::scene::world::World;
use std::collections::BTreeSet;

pub type Point = [Rational; 3];

pub fn rational(value: i64) -> Rational {
    Rational::from(Int::from(value))
}

/// The half-space n·x <= d.
#[derive(Clone, Debug)]
pub struct Half {
    normal: Point,
    offset: Rational,
}

impl Half {
    pub fn of(plane: &BigPlane) -> Half {
        let number = |c: &Int| Rational::from(c.clone());
        Half { normal: plane.normal.each_ref().map(number), offset: number(&plane.offset) }
    }

    /// The plane of a polygon, outward where its vertices run counter-clockwise.
    pub fn of_polygon(polygon: &[Point]) -> Half {
        let normal = area(polygon);
        let offset = dot(&normal, &polygon[0]);
        Half { normal, offset }
    }

    /// How far a point is outside, in units of the normal; negative inside.
    pub fn excess(&self, point: &Point) -> Rational {
        dot(&self.normal, point) - &self.offset
    }

    /// How fast a direction leads outside.
    pub fn along(&self, direction: &Point) -> Rational {
        dot(&self.normal, direction)
    }

    /// Whether both are the same set.
    pub fn is_same(&self, other: &Half) -> bool {
        cross(&self.normal, &other.normal).iter().all(Zero::is_zero)
            && dot(&self.normal, &other.normal).is_positive()
            && (0..3).all(|i| &self.normal[i] * &other.offset == &other.normal[i] * &self.offset)
    }

    /// The half-spaces at right angles to the plane, one through each edge of a polygon in it.
    pub fn fences(&self, polygon: &[Point]) -> Vec<Half> {
        (0..polygon.len())
            .map(|i| {
                let along = minus(&polygon[(i + 1) % polygon.len()], &polygon[i]);
                let normal = cross(&along, &self.normal);
                Half { offset: dot(&normal, &polygon[i]), normal }
            })
            .collect()
    }

    /// The face of a box that lies in the plane, one of the box's own.
    pub fn face_of(&self, bounds: &AxialBox) -> Vec<Point> {
        let axis = (0..3).find(|&i| !self.normal[i].is_zero()).unwrap();
        let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
        let side = if self.normal[axis].is_positive() { &bounds.high } else { &bounds.low };
        [(false, false), (true, false), (true, true), (false, true)]
            .map(|(at_i, at_j)| {
                let end = |high: bool, k: usize| {
                    if high { bounds.high[k].clone() } else { bounds.low[k].clone() }
                };
                let mut point = side.clone();
                point[i] = end(at_i, i);
                point[j] = end(at_j, j);
                point
            })
            .into()
    }
}

/// The six half-spaces of a box.
pub fn half_spaces(bounds: &AxialBox) -> Vec<Half> {
    let axis = |i: usize, sign: i64| [0, 1, 2].map(|j| rational(if i == j { sign } else { 0 }));
    (0..3)
        .flat_map(|i| {
            let low = Half { normal: axis(i, -1), offset: -&bounds.low[i] };
            [low, Half { normal: axis(i, 1), offset: bounds.high[i].clone() }]
        })
        .collect()
}

pub fn planes_of_cell(cells: &WorldCells, cell: CellId) -> Vec<Half> {
    let leaf = cells.subdivision.leaf(cells.leaves[cell.0 as usize]);
    let plane =
        |face: &stabline::construct::Polygon| cells.subdivision.planes.plane(face.support());
    leaf.cell.faces().iter().map(|face| Half::of(plane(face))).collect()
}

/// What of a convex polygon lies in all half-spaces (Sutherland and Hodgman 1974).
pub fn clip(mut polygon: Vec<Point>, halves: &[Half]) -> Vec<Point> {
    for half in halves {
        let excess: Vec<Rational> = polygon.iter().map(|point| half.excess(point)).collect();
        let mut kept: Vec<Point> = Vec::new();
        for i in 0..polygon.len() {
            let j = (i + 1) % polygon.len();
            if !excess[i].is_positive() {
                kept.push(polygon[i].clone());
            }
            if (&excess[i] * &excess[j]).is_negative() {
                let t = &excess[i] / (&excess[i] - &excess[j]);
                let step = minus(&polygon[j], &polygon[i]);
                kept.push([0, 1, 2].map(|k| &polygon[i][k] + &t * &step[k]));
            }
        }
        polygon = kept;
    }
    polygon
}

/// All vertices of the intersection of half-spaces, which is bounded: the meets of any three planes
/// that lie in all half-spaces.
pub fn vertices(halves: &[Half]) -> BTreeSet<Point> {
    let mut vertices = BTreeSet::new();
    for (i, a) in halves.iter().enumerate() {
        for (j, b) in halves.iter().enumerate().skip(i + 1) {
            let ab = cross(&a.normal, &b.normal);
            if ab.iter().all(Zero::is_zero) {
                continue;
            }
            for c in &halves[j + 1..] {
                let determinant = dot(&ab, &c.normal);
                if determinant.is_zero() {
                    continue;
                }
                let (bc, ca) = (cross(&b.normal, &c.normal), cross(&c.normal, &a.normal));
                let weighted =
                    |k: usize| &bc[k] * &a.offset + &ca[k] * &b.offset + &ab[k] * &c.offset;
                let point = [0, 1, 2].map(|k| weighted(k) / &determinant);
                if halves.iter().all(|half| !half.excess(&point).is_positive()) {
                    vertices.insert(point);
                }
            }
        }
    }
    vertices
}

pub fn with_area(polygon: &[Point]) -> bool {
    polygon.len() > 2 && area(polygon).iter().any(|c| !c.is_zero())
}

/// The polygon counter-clockwise as seen from a point that is not in its plane.
pub fn oriented(mut polygon: Vec<Point>, from: &Point) -> Vec<Point> {
    let side = Half::of_polygon(&polygon).excess(from);
    assert!(!side.is_zero());
    if side.is_negative() {
        polygon.reverse();
    }
    polygon
}

/// Whether points are not all in one plane.
pub fn spans_volume<'a>(points: impl Iterator<Item = &'a Point>) -> bool {
    let mut basis: Vec<Point> = Vec::new();
    let mut origin: Option<&Point> = None;
    for point in points {
        let Some(origin) = origin else {
            origin = Some(point);
            continue;
        };
        let arm = minus(point, origin);
        let independent = match &basis[..] {
            [] => arm.iter().any(|c| !c.is_zero()),
            [a] => cross(a, &arm).iter().any(|c| !c.is_zero()),
            [a, b] => !dot(&cross(a, b), &arm).is_zero(),
            _ => return true,
        };
        if independent {
            basis.push(arm);
        }
    }
    basis.len() == 3
}

fn plane(normal: [i64; 3], offset: i64) -> BigPlane {
    BigPlane { normal: normal.map(Int::from), offset: Int::from(offset) }
}

/// The planes of a box.
pub fn axial(low: [i64; 3], high: [i64; 3]) -> Vec<BigPlane> {
    let axis = |i: usize, sign: i64| [0, 1, 2].map(|j| if i == j { sign } else { 0 });
    (0..3).flat_map(|i| [plane(axis(i, -1), -low[i]), plane(axis(i, 1), high[i])]).collect()
}

/// The planes of a box, now and then with one more through the middle of the box.
pub fn cube(low: [i64; 3], high: [i64; 3], random: &mut Random) -> Vec<BigPlane> {
    let mut planes = axial(low, high);
    let normal = [(); 3].map(|()| random.between(-1, 1));
    if random.one_in(3) && normal != [0; 3] {
        let twice = (0..3).map(|i| normal[i] * (low[i] + high[i])).sum();
        planes.push(plane(normal.map(|c| 2 * c), twice));
    }
    planes
}

/// A vertex of a face, three times, and an inner point: their mean is inside, near the vertex.
pub fn corner(solid: &Polyhedron, pick: usize) -> [RationalPoint3; 4] {
    let faces = solid.faces();
    let points = faces[pick % faces.len()].points();
    let vertex = points[pick / 2 % points.len()].clone();
    [vertex.clone(), vertex.clone(), vertex, solid.inner_point()]
}

/// Whether the segment between two points meets no closed solid.
pub fn is_free(world: &World, from: &Point, to: &Point) -> bool {
    let direction = minus(to, from);
    world.solids.iter().all(|solid| {
        let (mut start, mut end) = (rational(0), rational(1));
        for half in solid.planes.iter().map(Half::of) {
            let (excess, slope) = (half.excess(from), half.along(&direction));
            if slope.is_zero() {
                if excess.is_positive() {
                    return true;
                }
                continue;
            }
            let at = -excess / &slope;
            if slope.is_positive() {
                end = end.min(at);
            } else {
                start = start.max(at);
            }
        }
        start > end
    })
}

pub fn mean<'a>(points: impl IntoIterator<Item = &'a Point>) -> Point {
    let (mut sum, mut count) = ([(); 3].map(|()| Rational::zero()), 0);
    for point in points {
        sum = [0, 1, 2].map(|i| &sum[i] + &point[i]);
        count += 1;
    }
    sum.map(|c| c / Int::from(count))
}

fn area(polygon: &[Point]) -> Point {
    let mut sum = [(); 3].map(|()| Rational::zero());
    for i in 1..polygon.len() - 1 {
        let [a, b] = [i, i + 1].map(|k| minus(&polygon[k], &polygon[0]));
        let part = cross(&a, &b);
        sum = [0, 1, 2].map(|k| &sum[k] + &part[k]);
    }
    sum
}

pub fn minus(a: &Point, b: &Point) -> Point {
    [0, 1, 2].map(|i| &a[i] - &b[i])
}

fn cross(a: &Point, b: &Point) -> Point {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| &a[i] * &b[j] - &a[j] * &b[i])
}

fn dot(a: &Point, b: &Point) -> Rational {
    a.iter().zip(b).fold(Rational::zero(), |sum, (a, b)| sum + a * b)
}
