//! Portal sequences for tests: a function of a family and a seed, the same on every machine.
//!
//! A sequence has 2 to 5 planar convex portals of 3 to 5 vertices (in 2D, 2 to 8 segments). All
//! families but [`Family::Reversed`] orient the portals along one rough direction, so that a fair
//! share of the sequences is open. Each family provokes one kind of degeneracy, and the grids are
//! small so that exact ties happen by themselves.
//!
//! Polygons are laid out in the lattice of their own plane, `origin + i·u + j·v`, so that they are
//! exactly planar and convex whatever the plane.

use crate::geom::{BigPoint2, BigPoint3};
use crate::num::{Int, Random};

/// A point with small integer coordinates.
type Vector = [i64; 3];

/// What is special about a sequence.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Family {
    /// Oblique portals in general position, coordinates of a few hundred units.
    Random,
    /// Axis-parallel rectangles, as in buildings.
    Axial,
    /// Coordinates of magnitude two: ties of every kind.
    TinyGrid,
    /// Neighbouring portals have a vertex in common.
    SharedVertex,
    /// Some portals lie in the plane of the one before.
    Coplanar,
    /// All portals lie in parallel planes.
    Parallel,
    /// Portals a hundred times longer than wide.
    Slit,
    /// Some portals are crossed against the others' direction.
    Reversed,
    /// Some vertices lie in the middle of a straight side.
    Collinear,
    /// Rows of parallel edges: all portals share one edge direction.
    Prism,
}

impl Family {
    /// Every family.
    pub const ALL: [Family; 10] = [
        Family::Random,
        Family::Axial,
        Family::TinyGrid,
        Family::SharedVertex,
        Family::Coplanar,
        Family::Parallel,
        Family::Slit,
        Family::Reversed,
        Family::Collinear,
        Family::Prism,
    ];
}

fn vector(random: &mut Random, reach: i64) -> Vector {
    [(); 3].map(|()| random.between(-reach, reach))
}

/// The sequence of this family and seed.
pub fn sequence(family: Family, seed: u64) -> Vec<Vec<BigPoint3>> {
    let mut random = Random::new(seed.wrapping_mul(31).wrapping_add(family as u64));
    let count = random.between(2, 5);
    let mut portals: Vec<Vec<Vector>> = Vec::new();
    for index in 0..count {
        let portal = match family {
            Family::Random => oblique(&mut random, index, 100, 200),
            Family::Axial => axial(&mut random, index),
            Family::TinyGrid => tiny(&mut random),
            Family::SharedVertex => shared_vertex(&mut random, index, portals.last()),
            Family::Coplanar => coplanar(&mut random, index, portals.last()),
            Family::Parallel => parallel(&mut random, index),
            Family::Slit => slit(&mut random, index),
            Family::Reversed => {
                let mut portal = oblique(&mut random, index, 6, 4);
                if random.one_in(3) {
                    portal.reverse();
                }
                portal
            }
            Family::Collinear => collinear(&mut random, index),
            Family::Prism => prism(&mut random, index),
        };
        portals.push(portal);
    }
    portals.iter().map(|portal| portal.iter().map(|&p| to_point(p)).collect()).collect()
}

/// The 2D sequence of this family and seed: per portal first the end on the line's left, then the
/// one on its right. The rough direction is that of the positive y axis.
pub fn sequence_2d(family: Family, seed: u64) -> Vec<[BigPoint2; 2]> {
    let mut random = Random::new(seed.wrapping_mul(37).wrapping_add(family as u64));
    let count = random.between(2, 8);
    let mut portals: Vec<[[i64; 2]; 2]> = Vec::new();
    while portals.len() < count as usize {
        let (reach, step) = match family {
            Family::TinyGrid => (2, 0),
            Family::Random => (300, 100),
            _ => (5, 2),
        };
        let y = step * portals.len() as i64;
        let mut left = [random.between(-reach, 1), y + random.between(-reach, reach)];
        let mut right = [random.between(-1, reach), y + random.between(-reach, reach)];
        match family {
            Family::Axial | Family::Parallel => right[1] = left[1],
            Family::SharedVertex | Family::Coplanar => {
                if let Some(&[a, b]) = portals.last() {
                    match random.between(0, 2) {
                        0 => left = a,
                        1 => right = b,
                        _ => left = [2 * b[0] - a[0], 2 * b[1] - a[1]],
                    }
                }
            }
            Family::Slit => right = [left[0] + 1, left[1] + random.between(-1, 1)],
            Family::Reversed if random.one_in(4) => std::mem::swap(&mut left, &mut right),
            Family::Collinear | Family::Prism => {
                left = [random.between(-2, 0), y];
                right = [left[0] + random.between(1, 2), y + random.between(0, 1)];
            }
            Family::Random | Family::TinyGrid | Family::Reversed => {}
        }
        if left != right {
            portals.push([left, right]);
        }
    }
    let point = |p: [i64; 2]| BigPoint2 { coordinates: p.map(Int::from) };
    portals.iter().map(|ends| ends.map(point)).collect()
}

fn to_point(p: Vector) -> BigPoint3 {
    BigPoint3 { coordinates: p.map(Int::from) }
}

/// A portal across the y axis, about `spacing·index` along it.
fn oblique(random: &mut Random, index: i64, size: i64, spacing: i64) -> Vec<Vector> {
    let origin = add(vector(random, size / 2), [0, spacing * index, 0]);
    let [u, v] = loop {
        let u = vector(random, size / 4 + 1);
        let v = vector(random, size / 4 + 1);
        if cross(u, v)[1] != 0 {
            break [u, v];
        }
    };
    lay_out(origin, u, v, &convex(random, 4, 2), [0, 1, 0])
}

/// An axis-parallel rectangle; the rough direction is (1, 1, 1).
fn axial(random: &mut Random, index: i64) -> Vec<Vector> {
    let axis = random.between(0, 2) as usize;
    let origin = add(vector(random, 3), [2 * index; 3]);
    let mut u = [0; 3];
    let mut v = [0; 3];
    u[(axis + 1) % 3] = random.between(1, 6);
    v[(axis + 2) % 3] = random.between(1, 6);
    lay_out(origin, u, v, &[[0, 0], [1, 0], [1, 1], [0, 1]], [1, 1, 1])
}

/// A triangle or parallelogram with coordinates of magnitude at most two.
fn tiny(random: &mut Random) -> Vec<Vector> {
    loop {
        let (origin, a, b) = (vector(random, 2), vector(random, 2), vector(random, 2));
        let (u, v) = (sub(a, origin), sub(b, origin));
        let normal = cross(u, v);
        if normal == [0; 3] || (normal[1] == 0 && random.one_in(2)) {
            continue;
        }
        let fourth = add(a, v);
        let square = fourth.iter().all(|c| c.abs() <= 2) && random.one_in(2);
        let corners: &[[i64; 2]] =
            if square { &[[0, 0], [1, 0], [1, 1], [0, 1]] } else { &[[0, 0], [1, 0], [0, 1]] };
        return lay_out(origin, u, v, corners, [0, 1, 0]);
    }
}

/// A portal that has a vertex of the one before.
fn shared_vertex(random: &mut Random, index: i64, before: Option<&Vec<Vector>>) -> Vec<Vector> {
    let portal = oblique(random, index, 6, 3);
    let Some(before) = before else { return portal };
    let from = portal[random.between(0, portal.len() as i64 - 1) as usize];
    let to = before[random.between(0, before.len() as i64 - 1) as usize];
    let shift = sub(to, from);
    portal.into_iter().map(|p| add(p, shift)).collect()
}

/// Often a portal in the plane of the one before, beside it, over it, or sharing an edge.
fn coplanar(random: &mut Random, index: i64, before: Option<&Vec<Vector>>) -> Vec<Vector> {
    match before {
        Some(before) if !random.one_in(3) => {
            let u = sub(before[1], before[0]);
            let v = sub(before[2], before[0]);
            let (i, j) = (random.between(-1, 1), random.between(-1, 1));
            let origin = add(before[0], add(scale(u, i), scale(v, j)));
            lay_out(origin, u, v, &convex(random, 2, 0), [0, 1, 0])
        }
        _ => oblique(random, index, 6, 3),
    }
}

/// A portal in the plane y = 2·index.
fn parallel(random: &mut Random, index: i64) -> Vec<Vector> {
    let origin = [random.between(-2, 1), 2 * index, random.between(-2, 1)];
    lay_out(origin, [1, 0, 0], [0, 0, 1], &convex(random, 4, 0), [0, 1, 0])
}

/// A long thin portal.
fn slit(random: &mut Random, index: i64) -> Vec<Vector> {
    let [long, wide] = loop {
        let long = scale(vector(random, 2), 50);
        let wide = vector(random, 1);
        if cross(long, wide)[1] != 0 {
            break [long, wide];
        }
    };
    let middle = add(vector(random, 2), [0, 20 * index, 0]);
    let origin = sub(middle, scale(long, 1).map(|c| c / 2));
    lay_out(origin, long, wide, &[[0, 0], [1, 0], [1, 1], [0, 1]], [0, 1, 0])
}

/// A portal with a vertex in the middle of each side that has a middle on the grid.
fn collinear(random: &mut Random, index: i64) -> Vec<Vector> {
    let portal = oblique(random, index, 4, 4);
    let mut result = Vec::new();
    for (i, &p) in portal.iter().enumerate() {
        let q = portal[(i + 1) % portal.len()];
        result.push(p);
        let sum = add(p, q);
        if sum.iter().all(|c| c % 2 == 0) && result.len() < i + 3 {
            result.push(sum.map(|c| c / 2));
        }
    }
    result
}

/// A parallelogram with two sides along the z axis.
fn prism(random: &mut Random, index: i64) -> Vec<Vector> {
    let origin = [random.between(-3, 1), 2 * index + random.between(-1, 1), random.between(-2, 0)];
    let u = [random.between(1, 4), random.between(-1, 1), random.between(-1, 1)];
    let v = [0, 0, random.between(1, 3)];
    lay_out(origin, u, v, &[[0, 0], [1, 0], [1, 1], [0, 1]], [0, 1, 0])
}

/// A strictly convex polygon of 3 to 5 vertices with coordinates from `-shift` to `size - shift`.
fn convex(random: &mut Random, size: i64, shift: i64) -> Vec<[i64; 2]> {
    loop {
        let count = random.between(3, 5);
        let points = (0..count)
            .map(|_| [random.between(0, size) - shift, random.between(0, size) - shift])
            .collect();
        let hull = hull(points);
        if hull.len() >= 3 {
            return hull;
        }
    }
}

/// The strictly convex hull, counter-clockwise (Andrew's monotone chain).
fn hull(mut points: Vec<[i64; 2]>) -> Vec<[i64; 2]> {
    points.sort_unstable();
    points.dedup();
    let mut hull: Vec<[i64; 2]> = Vec::new();
    for _ in 0..2 {
        let start = hull.len();
        for &p in &points {
            while hull.len() >= start + 2
                && turn(hull[hull.len() - 2], hull[hull.len() - 1], p) <= 0
            {
                hull.pop();
            }
            hull.push(p);
        }
        hull.pop();
        points.reverse();
    }
    hull
}

fn turn(a: [i64; 2], b: [i64; 2], c: [i64; 2]) -> i64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// The corners `origin + i·u + j·v`, in the order that makes the normal point along `direction`
/// (in the order given where it points across).
fn lay_out(
    origin: Vector,
    u: Vector,
    v: Vector,
    corners: &[[i64; 2]],
    direction: Vector,
) -> Vec<Vector> {
    let place = |[i, j]: [i64; 2]| add(origin, add(scale(u, i), scale(v, j)));
    let mut portal: Vec<Vector> = corners.iter().map(|&corner| place(corner)).collect();
    let normal = cross(u, v);
    if normal.iter().zip(direction).map(|(n, d)| n * d).sum::<i64>() < 0 {
        portal.reverse();
    }
    portal
}

fn add(a: Vector, b: Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

fn sub(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn scale(a: Vector, k: i64) -> Vector {
    a.map(|c| c * k)
}

fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn minus(a: &BigPoint3, b: &BigPoint3) -> [Int; 3] {
        [0, 1, 2].map(|i| &a.coordinates[i] - &b.coordinates[i])
    }

    fn determinant(a: &[Int; 3], b: &[Int; 3], c: &[Int; 3]) -> Int {
        (&a[1] * &b[2] - &a[2] * &b[1]) * &c[0]
            + (&a[2] * &b[0] - &a[0] * &b[2]) * &c[1]
            + (&a[0] * &b[1] - &a[1] * &b[0]) * &c[2]
    }

    #[test]
    fn every_portal_is_planar_and_convex() {
        for family in Family::ALL {
            for seed in 0..300 {
                for portal in sequence(family, seed) {
                    assert!((3..=7).contains(&portal.len()), "{family:?} {seed}");
                    assert_convex(&portal, &format!("{family:?} {seed}"));
                }
            }
        }
    }

    fn assert_convex(portal: &[BigPoint3], name: &str) {
        let zero = Int::default();
        let n = portal.len();
        let edge = |i: usize| minus(&portal[(i + 1) % n], &portal[i]);
        let sum = |a: [Int; 3], b: [Int; 3]| [0, 1, 2].map(|i| &a[i] + &b[i]);
        let cross = |a: [Int; 3], b: [Int; 3]| {
            [
                &a[1] * &b[2] - &a[2] * &b[1],
                &a[2] * &b[0] - &a[0] * &b[2],
                &a[0] * &b[1] - &a[1] * &b[0],
            ]
        };
        let normal = (1..n - 1)
            .map(|i| cross(minus(&portal[i], &portal[0]), minus(&portal[i + 1], &portal[0])))
            .fold([0, 0, 0].map(Int::from), sum);
        for i in 0..n {
            assert_ne!(edge(i), [0, 0, 0].map(Int::from), "{name}");
            for point in portal {
                let arm = minus(point, &portal[i]);
                let offset = minus(point, &portal[0]);
                let height: Int = (0..3).map(|k| &offset[k] * &normal[k]).sum();
                assert_eq!(height, zero, "{name}");
                assert!(determinant(&edge(i), &arm, &normal) >= zero, "{name}");
            }
        }
    }

    #[test]
    fn the_same_seed_gives_the_same_sequence() {
        assert_eq!(sequence(Family::Random, 7), sequence(Family::Random, 7));
        assert_ne!(sequence(Family::Random, 7), sequence(Family::Random, 8));
        assert_eq!(Random::new(0).bits(), 0xe220_a839_7b1d_cdaf);
    }

    #[test]
    fn segments_have_two_ends() {
        for family in Family::ALL {
            for seed in 0..300 {
                let portals = sequence_2d(family, seed);
                assert!((2..=8).contains(&portals.len()));
                assert!(portals.iter().all(|[left, right]| left != right));
            }
        }
    }
}
