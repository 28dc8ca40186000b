//! Random worlds on a grid so small that faces coincide, and solids touch in faces, edges and
//! vertices.

use stabline::geom::vector::{cross, difference, dot};
use stabline::geom::{BigPlane, RationalPoint3};
use stabline::num::Int;
use stabline::oracle::Random;
use stabline::portal::WorldCells;
use stabline::scene::World;
use stabline::scene::world::{Inside, Place, WorldPolygon, WorldSolid};

pub fn point(numerators: [i64; 3], denominator: i64) -> RationalPoint3 {
    RationalPoint3::new(numerators.map(Int::from), Int::from(denominator))
}

/// The half-space n·x <= offset.
pub fn plane(normal: [i64; 3], offset: i64) -> BigPlane {
    BigPlane { normal: normal.map(Int::from), offset: Int::from(offset) }
}

/// An axial box.
pub fn cuboid(low: [i64; 3], high: [i64; 3]) -> Vec<BigPlane> {
    let axis = |i: usize, sign: i64| std::array::from_fn(|j| if i == j { sign } else { 0 });
    (0..3).flat_map(|i| [plane(axis(i, 1), high[i]), plane(axis(i, -1), -low[i])]).collect()
}

/// A world of these solids and nothing else, all of whose free space counts.
pub fn world(solids: Vec<Vec<BigPlane>>) -> World {
    let place = |index: usize| Place { name: format!("solid {index}"), line: None };
    let solids = solids.into_iter().enumerate();
    let solids = solids.map(|(index, planes)| WorldSolid { planes, place: place(index) });
    World {
        solids: solids.collect(),
        polygons: Vec::new(),
        hints: Vec::new(),
        objects: Vec::new(),
        inside: Inside::Everywhere,
        view: None,
    }
}

/// Boxes, and boxes cut through one of their grid points, between 0 and 8.
pub fn random_world(random: &mut Random, count: usize) -> World {
    let mut solids = Vec::new();
    while solids.len() < count {
        let low = [(); 3].map(|()| random.between(0, 5));
        let high = low.map(|low| low + random.between(1, 3));
        let mut solid = cuboid(low, high);
        for _ in 0..random.between(0, 2) {
            let normal = [(); 3].map(|()| random.between(-2, 2));
            if normal != [0; 3] {
                let at: [i64; 3] = std::array::from_fn(|i| random.between(low[i], high[i]));
                solid.push(plane(normal, (0..3).map(|i| normal[i] * at[i]).sum()));
            }
        }
        solids.push(solid);
    }
    // One that certainly has volume.
    solids.push(cuboid([3, 3, 0], [4, 5, 3]));
    world(solids)
}

/// A triangle or a parallelogram on the grid.
pub fn random_polygon(random: &mut Random) -> WorldPolygon {
    loop {
        let corner = [(); 3].map(|()| random.between(0, 8));
        let [p, q] = [(); 2].map(|()| [(); 3].map(|()| random.between(-3, 3)));
        if cross(&p, &q) == [0; 3] {
            continue;
        }
        let at =
            |a: i64, b: i64| point(std::array::from_fn(|i| corner[i] + a * p[i] + b * q[i]), 1);
        let mut vertices = vec![at(0, 0), at(1, 0), at(1, 1)];
        if random.one_in(2) {
            vertices.push(at(0, 1));
        }
        return WorldPolygon { vertices, place: Place { name: "polygon".into(), line: None } };
    }
}

/// The half-spaces of a polygon on the integer grid: its plane both ways, and one an edge.
pub fn polygon_planes(vertices: &[RationalPoint3]) -> Vec<BigPlane> {
    let corners: Vec<[Int; 3]> = vertices.iter().map(|v| v.numerators().clone()).collect();
    let normal =
        cross(&difference(&corners[1], &corners[0]), &difference(&corners[2], &corners[0]));
    let through = |normal: [Int; 3], corner: &[Int; 3]| {
        let offset = dot(&normal, corner);
        BigPlane { normal, offset }
    };
    let edges = corners.iter().zip(corners.iter().cycle().skip(1));
    let edges = edges.map(|(a, b)| through(cross(&difference(b, a), &normal), a));
    let back = normal.each_ref().map(|n| -n);
    [through(normal.clone(), &corners[0]), through(back, &corners[0])]
        .into_iter()
        .chain(edges)
        .collect()
}

/// What is beyond each of the planes that bound a divided world, as solids without an end.
pub fn end_of_world(cells: &WorldCells) -> Vec<Vec<BigPlane>> {
    let subdivision = &cells.subdivision;
    let planes = subdivision.bounds.planes();
    planes.map(|plane| vec![subdivision.planes.plane(plane.flipped()).clone()]).into()
}
