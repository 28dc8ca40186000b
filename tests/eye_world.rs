//! Eyes in random worlds against exact segment tests, and the laws of what they see.
//!
//! The twin knows no cell and no portal: a point is seen iff the open segment from the eye to it
//! meets no solid and it lies strictly inside the frustum. Points are taken at random, with
//! denominators that no solid has, so that they lie on no plane that matters; where a segment
//! touches a solid without entering it, nothing is concluded.

use num_traits::{Signed, Zero};
use stabline::construct::{Polygon, Polyhedron};
use stabline::eye::{Cull, EyeWorld, Frustum, Query, SeenSpace, WorldAnswer};
use stabline::geom::{AxialBox, BigPlane, RationalPoint3};
use stabline::num::{Int, Rational};
use stabline::oracle::Random;
use stabline::portal::{WorldCells, cells_of_world};
use stabline::scene::world::{Inside, Object, Place, WorldSolid};
use stabline::scene::{CellId, World};
use stabline::subdivision::Options;

type Point = [Rational; 3];

/// Solids lie within this cube around the origin.
const REACH: i64 = 12;

fn ratio(p: i64, q: i64) -> Rational {
    Rational::new(p.into(), q.into())
}

fn integers(p: [i64; 3]) -> Point {
    p.map(|c| ratio(c, 1))
}

fn minus(a: &Point, b: &Point) -> Point {
    [0, 1, 2].map(|i| &a[i] - &b[i])
}

fn dot(a: &Point, b: &Point) -> Rational {
    (0..3).map(|i| &a[i] * &b[i]).sum()
}

fn cross(a: &Point, b: &Point) -> Point {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| &a[i] * &b[j] - &a[j] * &b[i])
}

fn normal(plane: &BigPlane) -> Point {
    plane.normal.clone().map(Rational::from)
}

fn axial_plane(axis: usize, sign: i64, at: i64) -> BigPlane {
    let normal = [0, 1, 2].map(|i| Int::from(if i == axis { sign } else { 0 }));
    BigPlane { normal, offset: Int::from(sign * at) }
}

fn box_planes(low: [i64; 3], high: [i64; 3]) -> Vec<BigPlane> {
    (0..3).flat_map(|i| [axial_plane(i, -1, low[i]), axial_plane(i, 1, high[i])]).collect()
}

fn place(name: &str) -> Place {
    Place { name: name.to_owned(), line: None }
}

fn world(solids: Vec<Vec<BigPlane>>) -> World {
    let solid = |planes| WorldSolid { planes, place: place("solid") };
    World {
        solids: solids.into_iter().map(solid).collect(),
        polygons: Vec::new(),
        hints: Vec::new(),
        objects: Vec::new(),
        inside: Inside::Everywhere,
        view: None,
    }
}

/// A box of whole coordinates, often against another one or level with it.
fn random_box(random: &mut Random, longest: i64) -> ([i64; 3], [i64; 3]) {
    let low = [0; 3].map(|_| 2 * random.between(-REACH / 2, REACH / 2 - 1));
    let high = low.map(|low| (low + 2 * random.between(1, longest)).min(REACH));
    (low, high)
}

/// Boxes, some with a corner cut off, some overlapping; and objects between them.
fn random_world(random: &mut Random) -> World {
    let count = random.between(1, 6);
    let solids = (0..count).map(|_| {
        let (low, high) = random_box(random, 4);
        let mut planes = box_planes(low, high);
        if random.one_in(3) {
            let normal = [0; 3].map(|_| random.between(-2, 2));
            let middle: i64 = (0..3).map(|i| normal[i] * (low[i] + high[i]) / 2).sum();
            if normal != [0; 3] {
                let normal = normal.map(Int::from);
                planes.push(BigPlane { normal, offset: Int::from(middle + 1) });
            }
        }
        planes
    });
    let mut world = world(solids.collect());
    let objects = (0..6).map(|_| {
        let (low, high) = random_box(random, 2);
        let bounds = AxialBox { low: integers(low), high: integers(high) };
        Object { bounds, place: place("object") }
    });
    world.objects = objects.collect();
    world
}

/// How a segment goes past the solids.
#[derive(PartialEq, Eq)]
enum Way {
    Free,
    Touching,
    Stopped,
}

/// The open segment from `a` to the closed end `b` against all solids.
fn way(world: &World, a: &Point, b: &Point) -> Way {
    let mut touches = false;
    for solid in &world.solids {
        // The part between the parameters `from` and `to` is in the closed solid.
        let (mut from, mut to) = (ratio(0, 1), ratio(1, 1));
        let mut inside_all = true;
        for plane in &solid.planes {
            let n = normal(plane);
            let offset = Rational::from(plane.offset.clone());
            let (height, slope) = (dot(&n, a) - offset, dot(&n, &minus(b, a)));
            if slope.is_zero() {
                inside_all &= height.is_negative();
                if height.is_positive() {
                    to = ratio(-1, 1);
                }
                continue;
            }
            let at = -height / &slope;
            if slope.is_positive() {
                to = to.min(at);
            } else {
                from = from.max(at);
            }
        }
        if from < to && inside_all {
            return Way::Stopped;
        }
        touches |= from <= to && to.is_positive();
    }
    if touches { Way::Touching } else { Way::Free }
}

/// A face by three of its corners: its outward normal, and a corner.
type Side = [Point; 2];

/// The faces of a polyhedron, by their vertices alone.
fn sides(polyhedron: &Polyhedron) -> Vec<Side> {
    let side = |face: &Polygon| {
        let points = face.points();
        let [a, b, c] = [0, 1, 2].map(|i| points[i].coordinates());
        [cross(&minus(&b, &a), &minus(&c, &a)), a]
    };
    polyhedron.faces().iter().map(side).collect()
}

/// Whether a point is strictly inside.
fn holds(sides: &[Side], point: &Point) -> bool {
    sides.iter().all(|[normal, corner]| dot(normal, &minus(point, corner)).is_negative())
}

fn in_frustum(frustum: Option<&Frustum>, eye: &Point, point: &Point) -> bool {
    let v = minus(point, eye);
    let planes = frustum.iter().flat_map(|frustum| frustum.planes());
    planes.map(|n| n.clone().map(Rational::from)).all(|n| dot(&n, &v).is_positive())
}

/// A point on none of the planes that matter, as good as always.
fn random_point(random: &mut Random, low: &Point, high: &Point) -> Point {
    [0, 1, 2].map(|i| &low[i] + (&high[i] - &low[i]) * ratio(random.between(1, 996), 997))
}

/// An eye anywhere, on a vertex, an edge or a face of a cell or a portal, or in a portal's plane.
fn random_eye(random: &mut Random, cells: &WorldCells) -> Point {
    let mut pick = |count: usize| random.between(0, count as i64 - 1) as usize;
    let leaf = cells.leaves[pick(cells.leaves.len())];
    let faces = cells.subdivision.leaf(leaf).cell.faces();
    let face: Vec<Point> =
        faces[pick(faces.len())].points().iter().map(RationalPoint3::coordinates).collect();
    let corners = match cells.graph.portals.is_empty() || pick(2) == 0 {
        true => face,
        false => {
            let portal = &cells.graph.portals[pick(cells.graph.portals.len())];
            cells.graph.corners(portal).map(RationalPoint3::coordinates).collect()
        }
    };
    let first = pick(corners.len());
    let [a, b, c] = [0, 1, 2].map(|i| &corners[(first + i) % corners.len()]);
    let middle = |p: &Point, q: &Point| [0, 1, 2].map(|i| (&p[i] + &q[i]) / Int::from(2));
    match pick(8) {
        0 => a.clone(),
        1 => middle(a, b),
        2 => middle(&middle(a, b), c),
        // In the plane, maybe outside of the polygon.
        3 => [0, 1, 2].map(|i| &a[i] + (&b[i] - &c[i]) / Int::from(3)),
        _ => random_point(random, &integers([-REACH - 2; 3]), &integers([REACH + 2; 3])),
    }
}

fn random_frustum(random: &mut Random) -> Option<Frustum> {
    if random.one_in(2) {
        return None;
    }
    let mut vector = || integers([0; 3].map(|_| random.between(-3, 3)));
    let (look, up) = (vector(), vector());
    Frustum::new(&look, &up, &[ratio(random.between(1, 9), 4), ratio(1, 1)]).ok()
}

/// A case: a world, its cells, an eye in it, a frustum, and what is seen.
struct Case<'a> {
    name: String,
    world: &'a World,
    cells: &'a WorldCells,
    eyes: &'a EyeWorld<'a>,
    at: RationalPoint3,
    eye: Point,
    frustum: Option<Frustum>,
    answer: WorldAnswer,
}

impl Case<'_> {
    fn look(&self, cull: Cull, frustum: Option<&Frustum>) -> WorldAnswer {
        let query = Query { eye: &self.at, frustum, cell: None, regions: true };
        self.eyes.look(&query, cull).unwrap()
    }

    fn space(&self) -> &SeenSpace {
        self.answer.space.as_ref().unwrap()
    }
}

/// Calls `check` with eyes in many worlds.
fn each_case(mut check: impl FnMut(&mut Random, &Case)) {
    let count = std::env::var("STABLINE_WORLDS").ok().and_then(|n| n.parse().ok()).unwrap_or(12);
    for seed in 0..count {
        let mut random = Random::new(77_000 + seed);
        let world = random_world(&mut random);
        let Ok(cells) = cells_of_world(&world, &Options::default()) else { continue };
        let eyes = EyeWorld::new(&world, &cells);
        for _ in 0..6 {
            let eye = random_eye(&mut random, &cells);
            let frustum = random_frustum(&mut random);
            let at = RationalPoint3::from(&eye);
            let query = Query { eye: &at, frustum: frustum.as_ref(), cell: None, regions: true };
            let Ok(answer) = eyes.look(&query, Cull::Exact) else {
                // All free space of the box is asked about.
                let inside = |solid: &WorldSolid| {
                    solid.planes.iter().all(|plane| {
                        let offset = Rational::from(plane.offset.clone());
                        !(dot(&normal(plane), &eye) - offset).is_positive()
                    })
                };
                let bounds = cells.subdivision.bounds.planes();
                let out_of_box = bounds.into_iter().any(|side| {
                    let side = cells.subdivision.planes.plane(side);
                    let offset = Rational::from(side.offset.clone());
                    (dot(&normal(side), &eye) - offset).is_positive()
                });
                assert!(out_of_box || world.solids.iter().any(inside), "{seed}: {eye:?}");
                continue;
            };
            let name = format!("{seed}: {eye:?}");
            let (world, cells, eyes) = (&world, &cells, &eyes);
            check(&mut random, &Case { name, world, cells, eyes, at, eye, frustum, answer });
        }
    }
}

#[test]
fn a_point_is_in_a_region_iff_the_segment_to_it_is_free() {
    let (mut seen, mut hidden, mut touching) = (0, 0, 0);
    each_case(|random, case| {
        let regions: Vec<_> = case.space().regions.iter().map(|r| sides(&r.polyhedron)).collect();
        for _ in 0..30 {
            let reach = [integers([-REACH - 3; 3]), integers([REACH + 3; 3])];
            let point = random_point(random, &reach[0], &reach[1]);
            let regions = regions.iter().filter(|region| holds(region, &point)).count();
            let looks = in_frustum(case.frustum.as_ref(), &case.eye, &point);
            match way(case.world, &case.eye, &point) {
                Way::Touching => touching += 1,
                Way::Free => {
                    assert_eq!(regions, usize::from(looks), "{}: {point:?}", case.name);
                    seen += usize::from(looks);
                }
                Way::Stopped => {
                    assert_eq!(regions, 0, "{}: {point:?}", case.name);
                    hidden += 1;
                }
            }
        }
    });
    println!("{seen} points seen, {hidden} hidden, {touching} behind what is touched");
    assert!(seen > 600 && hidden > 100 && touching * 20 < seen, "{seen} {hidden} {touching}");
}

#[test]
fn objects_are_seen_iff_a_point_of_their_inside_is() {
    let (mut seen, mut hidden) = (0, 0);
    each_case(|random, case| {
        let mut space = case.space().clone();
        let found = space.objects(&case.world.objects);
        for (index, Object { bounds, .. }) in case.world.objects.iter().enumerate() {
            let Some(object) = found.iter().find(|object| object.object == index) else {
                for _ in 0..20 {
                    let point = random_point(random, &bounds.low, &bounds.high);
                    let free = way(case.world, &case.eye, &point) == Way::Free;
                    let looks = in_frustum(case.frustum.as_ref(), &case.eye, &point);
                    assert!(!free || !looks, "{}: object {index} at {point:?}", case.name);
                }
                hidden += 1;
                continue;
            };
            let point = object.point.coordinates();
            let above = bounds.low.iter().zip(&point).all(|(low, c)| low < c);
            let below = bounds.high.iter().zip(&point).all(|(high, c)| c < high);
            assert!(above && below, "{}: object {index} at {point:?}", case.name);
            let region = sides(&space.regions[object.region].polyhedron);
            assert!(holds(&region, &point), "{}", case.name);
            assert!(way(case.world, &case.eye, &point) != Way::Stopped, "{}", case.name);
            assert!(in_frustum(case.frustum.as_ref(), &case.eye, &point), "{}", case.name);
            seen += 1;
        }
    });
    assert!(seen > 30 && hidden > 30, "{seen} seen, {hidden} hidden");
}

/// Every edge is met once in each direction.
fn assert_closed(polyhedron: &Polyhedron) {
    let mut edges: Vec<[RationalPoint3; 2]> = Vec::new();
    for points in polyhedron.faces().iter().map(Polygon::points) {
        let next = points.iter().cycle().skip(1);
        edges.extend(points.iter().zip(next).map(|(a, b)| [a.clone(), b.clone()]));
    }
    let back =
        |[a, b]: &[RationalPoint3; 2]| edges.iter().filter(|[c, d]| (a, b) == (d, c)).count();
    assert!(edges.iter().all(|edge| back(edge) == 1), "{edges:?}");
}

#[test]
fn regions_are_closed_and_inside_their_cells() {
    each_case(|_, case| {
        let leaf =
            |cell: CellId| &case.cells.subdivision.leaf(case.cells.leaves[cell.0 as usize]).cell;
        for region in &case.space().regions {
            let inner = region.polyhedron.inner_point().coordinates();
            assert!(holds(&sides(leaf(region.cell)), &inner), "{}", case.name);
            assert!(region.polyhedron.volume() <= leaf(region.cell).volume());
            assert!(region.polyhedron.volume().is_positive());
            assert_closed(&region.polyhedron);
        }
        let mut in_space: Vec<CellId> = case.space().regions.iter().map(|r| r.cell).collect();
        in_space.sort_unstable();
        in_space.dedup();
        let reached: Vec<CellId> = case.answer.answer.cells.iter().map(|r| r.cell).collect();
        assert_eq!(in_space, reached, "{}", case.name);
    });
}

#[test]
fn six_frusta_around_the_axes_see_as_much_as_no_frustum() {
    let mut cases = 0;
    each_case(|_, case| {
        if cases == 12 {
            return;
        }
        let axes = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]];
        let parts = axes.map(|look| {
            let up = if look[2] == 0 { [0, 0, 1] } else { [1, 0, 0] };
            let tangents = [ratio(1, 1), ratio(1, 1)];
            let frustum = Frustum::new(&integers(look), &integers(up), &tangents).unwrap();
            case.look(Cull::Exact, Some(&frustum)).space.unwrap().volume()
        });
        let whole = case.look(Cull::Exact, None).space.unwrap().volume();
        assert_eq!(parts.into_iter().sum::<Rational>(), whole, "{}", case.name);
        cases += 1;
    });
    assert_eq!(cases, 12);
}

#[test]
fn culls_never_miss_a_cell_of_a_world() {
    let (mut exact, mut float) = (0, 0);
    each_case(|_, case| {
        let reached = |cull| {
            let answer = case.look(cull, case.frustum.as_ref()).answer;
            answer.cells.iter().map(|reached| reached.cell).collect::<Vec<_>>()
        };
        let all = [Cull::Exact, Cull::Float, Cull::Portals, Cull::Flood].map(reached);
        for [less, more] in [[0, 1], [0, 2], [1, 3], [2, 3]] {
            assert!(all[less].iter().all(|cell| all[more].contains(cell)), "{}", case.name);
        }
        exact += all[0].len();
        float += all[1].len();
    });
    println!("{exact} cells seen, {float} by floats");
}

/// The inside of a box, between six solids.
fn room(inner: [[i64; 3]; 2]) -> Vec<Vec<BigPlane>> {
    let [low, high] = inner;
    let walls = (0..3).flat_map(|axis| {
        let (mut from, mut to) = (low.map(|c| c - 1), high.map(|c| c + 1));
        let below = {
            to[axis] = low[axis];
            box_planes(from, to)
        };
        (from[axis], to[axis]) = (high[axis], high[axis] + 1);
        [below, box_planes(from, to)]
    });
    walls.collect()
}

#[test]
fn alone_in_a_convex_room_an_eye_sees_all_of_it() {
    let mut world = world(room([[0, 0, 0], [6, 4, 3]]));
    // The marks keep what is around the walls out.
    let mark = stabline::scene::world::Mark {
        point: RationalPoint3::from(&integers([1, 1, 1])),
        place: place("mark"),
    };
    world.inside = Inside::Reached(vec![mark]);
    let cells = cells_of_world(&world, &Options::default()).unwrap();
    assert_eq!(cells.leaves.len(), 1);
    let eyes = EyeWorld::new(&world, &cells);
    let look = |eye: Point, frustum: Option<&Frustum>| {
        let eye = RationalPoint3::from(&eye);
        let query = Query { eye: &eye, frustum, cell: None, regions: true };
        eyes.look(&query, Cull::Exact).unwrap().space.unwrap().volume()
    };
    // Inside, on a wall, in an edge, in a corner.
    for eye in [[1, 1, 1], [0, 1, 1], [6, 4, 1], [0, 0, 0]] {
        assert_eq!(look(integers(eye), None), ratio(72, 1));
    }
    // Away from the wall, from the wall, along it: half of a pyramid would be seen.
    let frustum = |look| {
        let tangents = [ratio(1, 1), ratio(1, 1)];
        Frustum::new(&integers(look), &integers([0, 0, 1]), &tangents).unwrap()
    };
    let at_wall = || [ratio(0, 1), ratio(2, 1), ratio(3, 2)];
    assert_eq!(look(at_wall(), Some(&frustum([-1, 0, 0]))), ratio(0, 1));
    // Up to x = 3/2 a pyramid of (2x)², up to 2 a prism of height 3 and width 2x, then 4 x 3.
    let expected = ratio(9, 2) + ratio(3 * 7, 4) + ratio(4 * 3 * 4, 1);
    assert_eq!(look(at_wall(), Some(&frustum([1, 0, 0]))), expected);
    // Half of the pyramid along the wall: to y = 7/2 of height 2t, then 3; of width t.
    let expected = ratio(9, 4) + ratio(3 * 7, 8);
    assert_eq!(look(at_wall(), Some(&frustum([0, 1, 0]))), expected);
}
