//! Random portal graphs: a function of a family and a seed, the same on every machine.
//!
//! - [`Rooms`](Family::Rooms): a box cut into rooms by axial planes; doors in the walls, several
//!   in one, sharing edges and vertices, slits, triangles.
//! - [`Convex`](Family::Convex): a box cut by oblique planes; whole faces, faces shrunk, cut by
//!   another plane, or only a triangle of them.
//! - [`Skew`](Family::Skew): the same with all vertices rounded to a coarse grid, so that polygons
//!   are not planar and cells not convex.
//! - [`Wild`](Family::Wild): polygons anywhere between any two cells. No space looks like that, but
//!   the definition of open does not ask.

use num_traits::{One, Signed, Zero};
use stabline::num::{Int, Number, Rational};
use stabline::oracle::{self, Gate, Random};
use stabline::scene::{PortalGraph, RawGraph, RawPortal};

/// A point with rational coordinates.
pub type Point = [Rational; 3];

/// What is special about a graph.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Family {
    Rooms,
    Convex,
    Skew,
    Wild,
}

impl Family {
    pub const ALL: [Family; 4] = [Family::Rooms, Family::Convex, Family::Skew, Family::Wild];
}

/// A polygon between two cells, counter-clockwise as seen from the second.
#[derive(Clone, Debug)]
pub struct Portal {
    pub cells: [u32; 2],
    pub polygon: Vec<Point>,
}

/// A portal graph, to be changed and then validated.
#[derive(Clone, Debug)]
pub struct Graph {
    pub cells: u32,
    pub portals: Vec<Portal>,
}

impl Graph {
    /// The graph of this family and seed.
    pub fn random(family: Family, seed: u64) -> Graph {
        let mut random = Random::new(seed.wrapping_mul(4).wrapping_add(family as u64));
        match family {
            Family::Rooms => rooms(&mut random),
            Family::Convex => convex(&mut random),
            Family::Skew => skew(&mut random),
            Family::Wild => wild(&mut random),
        }
    }

    pub fn validated(&self) -> PortalGraph {
        PortalGraph::from_raw(self.raw()).expect("the families make valid polygons")
    }

    pub fn raw(&self) -> RawGraph {
        let number = |c: &Rational| Number::from(c.clone());
        let portals = self.portals.iter().map(|portal| RawPortal {
            cells: portal.cells,
            vertices: portal.polygon.iter().map(|p| p.each_ref().map(number)).collect(),
            line: None,
        });
        RawGraph {
            cells: (0..self.cells).map(|cell| cell.to_string()).collect(),
            portals: portals.collect(),
            leaf_to_cell: (0..self.cells).collect(),
            declared_grid: None,
        }
    }

    /// The graph as a portal file, coordinates as decimals or ratios.
    pub fn to_prt(&self) -> String {
        let mut text = format!("PRT1\n{}\n{}\n", self.cells, self.portals.len());
        for Portal { cells: [from, to], polygon } in &self.portals {
            text.push_str(&format!("{} {from} {to} ", polygon.len()));
            for [x, y, z] in polygon {
                text.push_str(&format!("({x} {y} {z} ) "));
            }
            text.push('\n');
        }
        text
    }

    /// The same graph with every point moved. A map that mirrors turns the polygons over.
    pub fn mapped(&self, mirrors: bool, map: impl Fn(&Point) -> Point) -> Graph {
        let mut graph = self.clone();
        for portal in &mut graph.portals {
            portal.polygon = portal.polygon.iter().map(&map).collect();
            if mirrors {
                portal.polygon.reverse();
            }
        }
        graph
    }

    /// The same graph, every vertex moved a little towards the middle of its polygon, by a share
    /// with a denominator of its own that is about `bits` long: planar polygons stay planar, and
    /// there is no common grid.
    pub fn shaken(&self, random: &mut Random, bits: u32) -> Graph {
        let mut graph = self.clone();
        for portal in &mut graph.portals {
            let count = integer(portal.polygon.len() as i64);
            let middle =
                [0, 1, 2].map(|i| portal.polygon.iter().map(|p| &p[i]).sum::<Rational>() / &count);
            for p in &mut portal.polygon {
                let odd = (1i64 << (bits - 1)) + 2 * random.between(0, (1 << (bits - 2)) - 1) + 1;
                let share =
                    Rational::new(Int::from(odd / random.between(50, 5000)), Int::from(odd));
                *p = [0, 1, 2].map(|i| &p[i] + &share * (&middle[i] - &p[i]));
            }
        }
        graph
    }

    /// The same graph, every coordinate times `scale` plus `offset`.
    pub fn scaled(&self, scale: &Rational, offset: &[Rational; 3]) -> Graph {
        self.mapped(false, |p| [0, 1, 2].map(|i| &p[i] * scale + &offset[i]))
    }
}

/// The portals of a validated graph as the twin takes them.
pub fn gates(graph: &PortalGraph) -> Vec<Gate> {
    let gate = |portal: &stabline::scene::Portal| Gate {
        from: portal.from.0 as usize,
        to: portal.to.0 as usize,
        vertices: graph.corners(portal).cloned().collect(),
    };
    graph.portals.iter().map(gate).collect()
}

pub fn integer(value: i64) -> Rational {
    Rational::from(Int::from(value))
}

fn point(p: [i64; 3]) -> Point {
    p.map(integer)
}

/// Which coordinates a box spans.
type Box3 = [[i64; 2]; 3];

fn rooms(random: &mut Random) -> Graph {
    let extent = |random: &mut Random| [0, random.between(5, 12)];
    let mut boxes: Vec<Box3> = vec![[extent(random), extent(random), extent(random)]];
    let wanted = random.between(4, 10) as usize;
    for _ in 0..40 {
        let index = random.between(0, boxes.len() as i64 - 1) as usize;
        let axis = random.between(0, 2) as usize;
        let [low, high] = boxes[index][axis];
        if boxes.len() < wanted && high - low >= 2 {
            let cut = random.between(low + 1, high - 1);
            let mut other = boxes[index];
            boxes[index][axis][1] = cut;
            other[axis][0] = cut;
            boxes.push(other);
        }
    }
    let mut portals = Vec::new();
    for a in 0..boxes.len() {
        for b in 0..boxes.len() {
            for axis in 0..3 {
                if boxes[a][axis][1] == boxes[b][axis][0] {
                    doors(random, [a, b], [&boxes[a], &boxes[b]], axis, &mut portals);
                }
            }
        }
    }
    Graph { cells: boxes.len() as u32, portals }
}

/// Doors in the wall between two boxes, the second of which follows the first along `axis`.
fn doors(
    random: &mut Random,
    cells: [usize; 2],
    boxes: [&Box3; 2],
    axis: usize,
    portals: &mut Vec<Portal>,
) {
    let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
    let common =
        |k: usize| [boxes[0][k][0].max(boxes[1][k][0]), boxes[0][k][1].min(boxes[1][k][1])];
    let ([u0, u1], [v0, v1]) = (common(i), common(j));
    if u0 >= u1 || v0 >= v1 || random.one_in(2) {
        return;
    }
    // Two doors lie on either side of a cut, and often touch there.
    let cut = if u1 - u0 >= 2 && random.one_in(2) { random.between(u0 + 1, u1 - 1) } else { u1 };
    for [low, high] in [[u0, cut], [cut, u1]] {
        if low == high {
            continue;
        }
        let [a, b] = interval(random, [low, high]);
        let [c, d] = interval(random, [v0, v1]);
        let corner = |u: i64, v: i64| {
            let mut p = [boxes[0][axis][1]; 3];
            p[i] = u;
            p[j] = v;
            point(p)
        };
        let mut polygon = vec![corner(a, c), corner(b, c), corner(b, d), corner(a, d)];
        if random.one_in(6) {
            polygon.remove(random.between(0, 3) as usize);
        }
        portals.push(Portal { cells: cells.map(|cell| cell as u32), polygon });
    }
}

/// A part of an interval: rarely all of it, mostly one unit of it.
fn interval(random: &mut Random, [low, high]: [i64; 2]) -> [i64; 2] {
    match random.between(0, 7) {
        0 => [low, high],
        1..6 => {
            let at = random.between(low, high - 1);
            [at, at + 1]
        }
        _ => {
            let a = random.between(low, high - 1);
            [a, random.between(a + 1, high.min(a + 3))]
        }
    }
}

/// The plane `normal · x = offset`.
#[derive(Clone)]
struct Plane {
    normal: Point,
    offset: Rational,
}

impl Plane {
    fn height(&self, p: &Point) -> Rational {
        dot(&self.normal, p) - &self.offset
    }

    fn flipped(&self) -> Plane {
        Plane { normal: self.normal.clone().map(|c| -c), offset: -&self.offset }
    }
}

fn dot(a: &Point, b: &Point) -> Rational {
    a.iter().zip(b).fold(Rational::zero(), |sum, (a, b)| sum + a * b)
}

fn minus(a: &Point, b: &Point) -> Point {
    [0, 1, 2].map(|i| &a[i] - &b[i])
}

fn cross(a: &Point, b: &Point) -> Point {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| &a[i] * &b[j] - &a[j] * &b[i])
}

/// The part of a convex polygon in front of the plane, if it has area.
fn clipped(polygon: &[Point], plane: &Plane) -> Option<Vec<Point>> {
    let heights: Vec<Rational> = polygon.iter().map(|p| plane.height(p)).collect();
    let mut kept: Vec<Point> = Vec::new();
    for (i, p) in polygon.iter().enumerate() {
        let j = (i + 1) % polygon.len();
        if !heights[i].is_negative() {
            kept.push(p.clone());
        }
        if (heights[i].is_positive() && heights[j].is_negative())
            || (heights[i].is_negative() && heights[j].is_positive())
        {
            let share = &heights[i] / (&heights[i] - &heights[j]);
            let step = minus(&polygon[j], p);
            kept.push([0, 1, 2].map(|k| &p[k] + &share * &step[k]));
        }
    }
    kept.dedup();
    (kept.len() >= 3 && heights.iter().any(Rational::is_positive)).then_some(kept)
}

/// A polygon of the plane, larger than the box of the given size around the origin.
fn on_plane(plane: &Plane, size: i64) -> Vec<Point> {
    let axis = (0..3).max_by_key(|&i| plane.normal[i].abs()).unwrap();
    let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
    let at = |u: i64, v: i64| {
        let mut p = point([0; 3]);
        p[i] = integer(u);
        p[j] = integer(v);
        p[axis] = -plane.height(&p) / &plane.normal[axis];
        p
    };
    let mut polygon = vec![at(-size, -size), at(size, -size), at(size, size), at(-size, size)];
    if plane.normal[axis].is_negative() {
        polygon.reverse();
    }
    polygon
}

/// The whole faces between the convex parts into which random planes cut a box.
fn subdivision(random: &mut Random, size: i64) -> Graph {
    let mut walls = Vec::new();
    for axis in 0..3 {
        for sign in [1, -1] {
            let mut normal = [0; 3];
            normal[axis] = sign;
            walls.push(Plane { normal: point(normal), offset: integer(-size) });
        }
    }
    // Each cell as the planes that it is in front of.
    let mut cells = vec![walls];
    let mut portals: Vec<Portal> = Vec::new();
    let wanted = random.between(4, 8) as usize;
    for _ in 0..30 {
        let plane = random_plane(random, size);
        let index = random.between(0, cells.len() as i64 - 1) as usize;
        let face = cells[index]
            .iter()
            .try_fold(on_plane(&plane, 8 * size), |polygon, wall| clipped(&polygon, wall));
        let Some(face) = face.filter(|_| cells.len() < wanted) else { continue };
        let new = cells.len();
        let mut front = cells[index].clone();
        front.push(plane.clone());
        cells[index].push(plane.flipped());
        cells.push(front);
        let mut split = vec![Portal { cells: [index as u32, new as u32], polygon: face }];
        for portal in portals {
            let Some(side) = portal.cells.iter().position(|&cell| cell == index as u32) else {
                split.push(portal);
                continue;
            };
            for (half, cell) in [(plane.clone(), new), (plane.flipped(), index)] {
                if let Some(polygon) = clipped(&portal.polygon, &half) {
                    let mut cells = portal.cells;
                    cells[side] = cell as u32;
                    split.push(Portal { cells, polygon });
                }
            }
        }
        portals = split;
    }
    Graph { cells: cells.len() as u32, portals }
}

/// A plane through three lattice points of the box.
fn random_plane(random: &mut Random, size: i64) -> Plane {
    loop {
        let reach = size - 1;
        let [a, b, c] = [(); 3].map(|()| point([(); 3].map(|()| random.between(-reach, reach))));
        let normal = cross(&minus(&b, &a), &minus(&c, &a));
        if normal.iter().any(|c| !c.is_zero()) {
            let offset = dot(&normal, &a);
            return Plane { normal, offset };
        }
    }
}

fn convex(random: &mut Random) -> Graph {
    let mut graph = subdivision(random, 3);
    graph.portals.retain(|_| random.one_in(2));
    for portal in &mut graph.portals {
        portal.polygon = opening(random, &portal.polygon);
    }
    graph
}

/// A convex part of a convex polygon.
fn opening(random: &mut Random, polygon: &[Point]) -> Vec<Point> {
    match random.between(0, 11) {
        0 => polygon.to_vec(),
        1..6 => {
            let count = polygon.len();
            let mut corners = vec![0; count];
            for _ in 0..3 {
                corners[random.between(0, count as i64 - 1) as usize] = 1;
            }
            let chosen: Vec<Point> =
                (0..count).filter(|&i| corners[i] == 1).map(|i| polygon[i].clone()).collect();
            if chosen.len() == 3 { chosen } else { polygon[..3].to_vec() }
        }
        6..11 => {
            let share = Rational::new(Int::one(), Int::from(random.between(2, 12)));
            let apex = &polygon[random.between(0, polygon.len() as i64 - 1) as usize];
            let shrunk = |p: &Point| {
                let arm = minus(p, apex);
                [0, 1, 2].map(|i| &apex[i] + &share * &arm[i])
            };
            polygon.iter().take(5).map(shrunk).collect()
        }
        _ => clipped(polygon, &random_plane(random, 3)).unwrap_or_else(|| polygon.to_vec()),
    }
}

fn skew(random: &mut Random) -> Graph {
    let mut graph = subdivision(random, 4);
    for portal in &mut graph.portals {
        portal.polygon = opening(random, &portal.polygon);
    }
    // The coarser the grid, the farther from convex.
    let grid = integer([4, 16, 64][random.between(0, 2) as usize]);
    graph = graph.mapped(false, |p| p.each_ref().map(|c| (c * &grid).round()));
    graph.portals.retain(|_| random.one_in(2));
    with_valid_portals(graph)
}

fn wild(random: &mut Random) -> Graph {
    let cells = random.between(3, 6);
    let mut portals = Vec::new();
    let families = [
        oracle::Family::TinyGrid,
        oracle::Family::Axial,
        oracle::Family::Coplanar,
        oracle::Family::Reversed,
    ];
    while (portals.len() as i64) < cells + 3 {
        let family = families[random.between(0, 3) as usize];
        for vertices in oracle::sequence(family, random.bits() >> 8) {
            let from = random.between(0, cells - 1) as u32;
            let to = random.between(0, cells - 1) as u32;
            if from != to {
                let polygon = vertices.iter().map(|v| v.coordinates.clone().map(Rational::from));
                portals.push(Portal { cells: [from, to], polygon: polygon.collect() });
            }
        }
    }
    portals.truncate(cells as usize + 4);
    with_valid_portals(Graph { cells: cells as u32, portals })
}

/// Without the polygons that rounding has spoilt.
fn with_valid_portals(mut graph: Graph) -> Graph {
    let cells = graph.cells;
    graph.portals.retain(|portal| {
        let alone = Graph { cells, portals: vec![portal.clone()] };
        PortalGraph::from_raw(alone.raw()).is_ok()
    });
    graph
}
