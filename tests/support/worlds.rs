//! Random small worlds on a tiny grid, where solids touch, lie flush, overlap and occur twice; and
//! affine maps of them.
//!
//! - [`Family::Boxes`]: axial boxes, many beside or upon an earlier one.
//! - [`Family::Cut`]: boxes with corners cut off through grid points.
//! - [`Family::Walls`]: walls across the whole room that leave slits and doors.
//! - [`Family::Slivers`]: thin wedges and needles whose planes are nearly parallel.
//! - [`Family::Simplices`]: tetrahedra with grid points as vertices.
//! - [`Family::Polygons`]: polygons without volume, and a box or two.

use super::graphs::integer;
use num_traits::{One, Zero};
use stabline::geom::{AxialBox, BigPlane, BigPoint3, RationalPoint3};
use stabline::num::{Int, Rational};
use stabline::oracle::{Occluders, Random};
use stabline::scene::World;
use stabline::scene::world::{Inside, Mark, Place, WorldHint, WorldPolygon, WorldSolid};

/// The planes of a solid.
pub type Planes = Vec<BigPlane>;

/// What is special about a world.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Family {
    Boxes,
    Cut,
    Walls,
    Slivers,
    Simplices,
    Polygons,
}

impl Family {
    pub const ALL: [Family; 6] = [
        Family::Boxes,
        Family::Cut,
        Family::Walls,
        Family::Slivers,
        Family::Simplices,
        Family::Polygons,
    ];
}

/// A world, to be changed and then divided.
#[derive(Clone, Debug)]
pub struct Case {
    /// Solids, each with volume.
    pub solids: Vec<Planes>,
    /// Solids without volume, which mean nothing.
    pub flat: Vec<Planes>,
    /// Solids that split, and do not occlude.
    pub hints: Vec<Planes>,
    /// Polygons that occlude.
    pub polygons: Vec<Vec<RationalPoint3>>,
    /// The marks of the inside, or none where everything is asked about.
    pub marks: Vec<RationalPoint3>,
    /// The box asked about, where that is not everything.
    pub view: Option<AxialBox>,
}

/// The inside of the closed rooms reaches from 0 to here on each axis.
pub const REACH: i64 = 6;

impl Case {
    /// Solids of a family in a closed room, with one mark or two.
    pub fn closed(family: Family, seed: u64) -> Case {
        let mut random = Random::new(seed.wrapping_mul(8).wrapping_add(family as u64));
        let mut case = Case::open_with(&mut random, family);
        let wall = |axis: usize, low: i64, high: i64| {
            let mut ends = [[-1; 3], [REACH + 1; 3]];
            (ends[0][axis], ends[1][axis]) = (low, high);
            cuboid(ends[0], ends[1])
        };
        for axis in 0..3 {
            case.solids.extend([wall(axis, -1, 0), wall(axis, REACH, REACH + 1)]);
        }
        let occluders = case.occluders();
        while case.marks.len() < 2 {
            let point = random_point(&mut random, 5);
            if occluders.leaves_free(&point) {
                case.marks.push(point);
            }
        }
        case
    }

    /// Solids of a family in open space.
    pub fn open(family: Family, seed: u64) -> Case {
        Case::open_with(&mut Random::new(seed.wrapping_mul(8).wrapping_add(family as u64)), family)
    }

    fn open_with(random: &mut Random, family: Family) -> Case {
        let mut solids: Vec<Planes> = Vec::new();
        let mut polygons: Vec<Vec<RationalPoint3>> = Vec::new();
        let most = if family == Family::Polygons { 2 } else { 7 };
        for _ in 0..random.between(1, most) {
            if !solids.is_empty() && random.one_in(10) {
                solids.push(solids[random.between(0, solids.len() as i64 - 1) as usize].clone());
            } else {
                solids.extend(of_family(random, family));
            }
        }
        if family == Family::Polygons {
            for _ in 0..random.between(1, 7) {
                polygons.push(random_polygon(random));
            }
        }
        let (flat, marks) = (vec![cuboid([1, 1, 2], [4, 4, 2])], Vec::new());
        Case { solids, flat, hints: Vec::new(), polygons, marks, view: None }
    }

    /// The solids that have volume, and the polygons.
    pub fn occluders(&self) -> Occluders {
        let mut occluders = Occluders::default();
        self.solids.iter().for_each(|solid| occluders.add_solid(solid));
        self.polygons.iter().for_each(|polygon| occluders.add_polygon(polygon));
        occluders
    }

    pub fn world(&self) -> World {
        let place = || Place { name: "brush".to_owned(), line: None };
        let solids = self.solids.iter().chain(&self.flat).cloned();
        let inside = match self.marks.is_empty() {
            true => Inside::Everywhere,
            false => {
                let mark = |point: &RationalPoint3| Mark { point: point.clone(), place: place() };
                Inside::Reached(self.marks.iter().map(mark).collect())
            }
        };
        let hint = |planes: &Planes| WorldHint {
            planes: planes.clone(),
            splits: vec![true; planes.len()],
        };
        let polygon = |vertices: &Vec<RationalPoint3>| WorldPolygon {
            vertices: vertices.clone(),
            place: place(),
        };
        World {
            solids: solids.map(|planes| WorldSolid { planes, place: place() }).collect(),
            polygons: self.polygons.iter().map(polygon).collect(),
            hints: self.hints.iter().map(hint).collect(),
            objects: Vec::new(),
            inside,
            view: self.view.clone(),
        }
    }

    /// The same world, every point moved; it must have no view.
    pub fn mapped(&self, map: &Affine) -> Case {
        let planes =
            |solid: &Planes| -> Planes { solid.iter().map(|plane| map.of_plane(plane)).collect() };
        let points =
            |points: &Vec<RationalPoint3>| points.iter().map(|p| map.of_point(p)).collect();
        Case {
            solids: self.solids.iter().map(planes).collect(),
            flat: self.flat.iter().map(planes).collect(),
            hints: self.hints.iter().map(planes).collect(),
            polygons: self.polygons.iter().map(points).collect(),
            marks: points(&self.marks),
            view: None,
        }
    }
}

/// x to scale·matrix·x + shift, the matrix one of integers with determinant 1 or -1.
#[derive(Clone, Debug)]
pub struct Affine {
    pub matrix: [[i64; 3]; 3],
    pub scale: Rational,
    pub shift: [Rational; 3],
}

impl Affine {
    pub fn identity() -> Affine {
        let matrix = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
        Affine { matrix, scale: Rational::one(), shift: [(); 3].map(|()| Rational::zero()) }
    }

    /// A map that mixes and turns the axes, mirrors, shears, scales and moves.
    pub fn random(random: &mut Random) -> Affine {
        let mut map = Affine::identity();
        map.matrix.swap(0, random.between(0, 2) as usize);
        map.matrix.swap(1, random.between(1, 2) as usize);
        for row in &mut map.matrix {
            if random.one_in(2) {
                *row = row.map(|c| -c);
            }
        }
        if random.one_in(2) {
            let (from, to) = [(0, 1), (1, 2), (2, 0)][random.between(0, 2) as usize];
            let factor = random.between(-2, 2);
            map.matrix[to] = [0, 1, 2].map(|i| map.matrix[to][i] + factor * map.matrix[from][i]);
        }
        let ratio = |random: &mut Random, low: i64| {
            Rational::new(random.between(low, 40).into(), random.between(1, 9).into())
        };
        map.scale = ratio(random, 1);
        map.shift = [(); 3].map(|()| ratio(random, -40));
        map
    }

    pub fn of_point(&self, point: &RationalPoint3) -> RationalPoint3 {
        let x = point.coordinates();
        RationalPoint3::from(&[0, 1, 2].map(|i| {
            let sum: Rational = (0..3).map(|j| &x[j] * Int::from(self.matrix[i][j])).sum();
            &self.scale * sum + &self.shift[i]
        }))
    }

    /// The point that goes to this one.
    pub fn inverse(&self, point: &RationalPoint3) -> RationalPoint3 {
        let x = point.coordinates();
        let y = [0, 1, 2].map(|i| (&x[i] - &self.shift[i]) / &self.scale);
        let cofactors = self.cofactors();
        RationalPoint3::from(
            &[0, 1, 2]
                .map(|i| (0..3).map(|j| &y[j] * Int::from(cofactors[j][i])).sum::<Rational>()),
        )
    }

    /// The inverse transpose of the matrix.
    fn cofactors(&self) -> [[i64; 3]; 3] {
        let m = &self.matrix;
        let minor = |i: usize, j: usize| {
            let ([a, b], [c, d]) = ([(i + 1) % 3, (i + 2) % 3], [(j + 1) % 3, (j + 2) % 3]);
            m[a][c] * m[b][d] - m[a][d] * m[b][c]
        };
        let determinant: i64 = (0..3).map(|j| m[0][j] * minor(0, j)).sum();
        assert_eq!(determinant.abs(), 1);
        std::array::from_fn(|i| std::array::from_fn(|j| determinant * minor(i, j)))
    }

    fn of_plane(&self, plane: &BigPlane) -> BigPlane {
        let cofactors = self.cofactors();
        let normal: [Int; 3] = std::array::from_fn(|i| {
            (0..3).map(|j| &plane.normal[j] * Int::from(cofactors[i][j])).sum()
        });
        let shift: Rational = (0..3).map(|i| &self.shift[i] * &normal[i]).sum();
        let offset = &self.scale * &plane.offset + shift;
        let unit = offset.denom().clone();
        BigPlane { normal: normal.map(|c| c * &unit), offset: (offset * &unit).to_integer() }
    }
}

/// The plane n·x <= offset.
pub fn half_space(normal: [i64; 3], offset: i64) -> BigPlane {
    BigPlane { normal: normal.map(Int::from), offset: Int::from(offset) }
}

/// An axial box.
pub fn cuboid(low: [i64; 3], high: [i64; 3]) -> Planes {
    let axis = |i: usize, sign: i64| std::array::from_fn(|j| if i == j { sign } else { 0 });
    (0..3)
        .flat_map(|i| [half_space(axis(i, 1), high[i]), half_space(axis(i, -1), -low[i])])
        .collect()
}

/// A rational point of the closed room.
pub fn random_point(random: &mut Random, denominator: i64) -> RationalPoint3 {
    let coordinates = [(); 3].map(|()| Int::from(random.between(0, REACH * denominator)));
    RationalPoint3::new(coordinates, Int::from(denominator))
}

/// A solid with volume, or two.
pub fn of_family(random: &mut Random, family: Family) -> Vec<Planes> {
    match family {
        Family::Boxes | Family::Polygons => vec![random_box(random, 3)],
        Family::Cut => vec![cut_box(random)],
        Family::Walls => wall(random),
        Family::Slivers => vec![sliver(random)],
        Family::Simplices => vec![simplex(random)],
    }
}

/// A rectangle across an axis, a parallelogram, or a triangle, on grid points.
pub fn random_polygon(random: &mut Random) -> Vec<RationalPoint3> {
    let whole = |corner: [i64; 3]| RationalPoint3::new(corner.map(Int::from), Int::from(1));
    let grid_point = |random: &mut Random| [(); 3].map(|()| random.between(0, REACH));
    if random.one_in(2) {
        let axis = random.between(0, 2) as usize;
        let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
        let low = [(); 3].map(|()| random.between(0, REACH - 1));
        let mut corners = [low; 4];
        let [u, v] = [i, j].map(|k| random.between(low[k] + 1, REACH));
        (corners[1][i], corners[2][i]) = (u, u);
        (corners[2][j], corners[3][j]) = (v, v);
        return corners.map(whole).into();
    }
    loop {
        let [a, b, c] = [(); 3].map(|()| grid_point(random));
        let minor =
            |i: usize, j: usize| (b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]);
        if [minor(0, 1), minor(1, 2), minor(2, 0)] == [0; 3] {
            continue;
        }
        let fourth = [0, 1, 2].map(|i| a[i] + c[i] - b[i]);
        let corners = if random.one_in(2) { vec![a, b, c] } else { vec![a, b, c, fourth] };
        return corners.into_iter().map(whole).collect();
    }
}

fn random_box(random: &mut Random, longest: i64) -> Planes {
    let low = [(); 3].map(|()| random.between(0, REACH - 1));
    let high = low.map(|low| low + random.between(1, longest));
    cuboid(low, high)
}

/// A box less what lies beyond planes that leave its middle.
fn cut_box(random: &mut Random) -> Planes {
    let low = [(); 3].map(|()| random.between(0, REACH - 2));
    let high = low.map(|low| low + random.between(1, 4));
    let mut solid = cuboid(low, high);
    for _ in 0..random.between(1, 3) {
        let normal = [(); 3].map(|()| random.between(-2, 2));
        let at: [i64; 3] = std::array::from_fn(|i| random.between(low[i], high[i]));
        let offset: i64 = (0..3).map(|i| normal[i] * at[i]).sum();
        let middle: i64 = (0..3).map(|i| normal[i] * (low[i] + high[i])).sum();
        if middle < 2 * offset {
            solid.push(half_space(normal, offset));
        }
    }
    solid
}

/// The two parts of a wall across the room, with a slit between them.
fn wall(random: &mut Random) -> Vec<Planes> {
    let (across, along) = [(0, 1), (1, 2), (2, 0), (1, 0)][random.between(0, 3) as usize];
    let at = random.between(1, REACH - 1);
    let slit = random.between(0, REACH - 1);
    let mut low = [0; 3];
    let mut high = [REACH; 3];
    (low[across], high[across]) = (at, at + random.between(1, 2));
    let (mut left, mut right) = (high, low);
    left[along] = slit;
    right[along] = slit + random.between(0, 2);
    let parts = [(low, left), (right, high)].into_iter();
    let mut parts: Vec<Planes> = parts
        .filter(|(low, high)| (0..3).all(|i| low[i] < high[i]))
        .map(|(low, high)| cuboid(low, high))
        .collect();
    // Half of the time the slit is a hundredth wide.
    if random.one_in(2) && slit > 0 {
        let mut normal = [0; 3];
        normal[along] = -100;
        low[along] = slit;
        let mut rest = cuboid(low, high);
        rest.push(half_space(normal, -(100 * slit + 1)));
        parts.truncate(1);
        parts.push(rest);
    }
    parts
}

/// A long box between two planes through its middle axis that are nearly parallel to it.
fn sliver(random: &mut Random) -> Planes {
    let low = [(); 3].map(|()| random.between(0, REACH - 2));
    let high = low.map(|low| low + random.between(1, 5));
    let mut solid = cuboid(low, high);
    let steep = random.between(3, 90);
    let (i, j) = [(0, 1), (1, 2), (2, 0)][random.between(0, 2) as usize];
    // Between x_j = low_j and a plane that rises from there by 1 in `steep`.
    let mut normal = [0; 3];
    (normal[i], normal[j]) = (-1, steep);
    solid.push(half_space(normal, steep * low[j] - low[i]));
    solid
}

fn simplex(random: &mut Random) -> Planes {
    loop {
        let corner = |random: &mut Random| BigPoint3 {
            coordinates: [(); 3].map(|()| Int::from(random.between(0, REACH))),
        };
        let corners = [(); 4].map(|()| corner(random));
        let height = |plane: &BigPlane, p: &BigPoint3| {
            let sum: Int = plane.normal.iter().zip(&p.coordinates).map(|(n, x)| n * x).sum();
            sum - &plane.offset
        };
        let faces = [[0, 1, 2, 3], [0, 1, 3, 2], [0, 2, 3, 1], [1, 2, 3, 0]].map(|[a, b, c, d]| {
            let plane = BigPlane::through(&corners[a], &corners[b], &corners[c]);
            match height(&plane, &corners[d]) > Int::ZERO {
                true => BigPlane { normal: plane.normal.map(|c| -c), offset: -plane.offset },
                false => plane,
            }
        });
        // All four heights are the same determinant.
        if height(&faces[0], &corners[3]) != Int::ZERO {
            return faces.into();
        }
    }
}

/// A random mean of some points, weights from zero: often on the boundary of their hull.
pub fn random_mean(random: &mut Random, points: &[RationalPoint3]) -> RationalPoint3 {
    let mut weights: Vec<i64> = points.iter().map(|_| random.between(0, 4)).collect();
    weights[random.between(0, points.len() as i64 - 1) as usize] += 1;
    let total = integer(weights.iter().sum());
    let points: Vec<[Rational; 3]> = points.iter().map(RationalPoint3::coordinates).collect();
    let mean = |i: usize| {
        let terms = points.iter().zip(&weights).map(|(point, &weight)| &point[i] * integer(weight));
        terms.sum::<Rational>() / &total
    };
    RationalPoint3::from(&[0, 1, 2].map(mean))
}
