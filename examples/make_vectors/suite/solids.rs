//! Scenes of solids, with a view cell at either end: blocks that share a face, an edge or a corner
//! leave no way, and one unit of gap between them leaves one.
//!
//! Every plane that is named has the one view cell behind it and the other in front, and within
//! the view the solids cover it but for its openings. So every line passes an opening of each
//! plane; and between two planes the openings' hull is free, so those lines do.

use super::book::{Book, of_portals};
use super::family::{Seq, TRIPLE};
use super::number::{Point, Polygon, Q, power, q, ratio, reversed, value, values};
use super::space::{square, whole};
use serde_json::{Value, json};
use stabline::vectors::Class::{self, Blocked, Open};
use stabline::vectors::{Kind, Test};

/// A convex solid.
#[derive(Clone)]
enum Brush {
    Box([Point; 2]),
    Points(Vec<Point>),
    /// Outward normals, and what their product with a point of the plane is.
    Planes(Vec<(Point, Q)>),
}

/// Solids between two view cells.
#[derive(Clone)]
struct Scene {
    comment: String,
    flags: Vec<&'static str>,
    brushes: Vec<Brush>,
    view: [Point; 2],
    near: [Point; 2],
    far: [Point; 2],
    between: Between,
    class: Class,
}

/// What is between the view cells.
#[derive(Clone)]
enum Between {
    /// For each plane its openings.
    Openings(Vec<Vec<Polygon>>),
    /// A plane that the solids cover.
    Closed(Point, Q),
}

/// What is left between two solids: a gap; a face, an edge or a corner that they share; nothing,
/// since they overlap.
const GAPS: [(i64, Class, &str); 3] = [
    (1, Open, "One unit of gap is left between them, and lines pass."),
    (0, Blocked, "They touch and leave no gap, so no line passes."),
    (-1, Blocked, "They overlap by one unit."),
];

/// Adds all scenes of solids.
pub fn add(book: &mut Book) {
    let families: [(&str, Vec<Scene>); 7] = [
        ("Blocks side by side in a wall.", side_by_side()),
        ("Two blocks, diagonally, at a common edge.", diagonal()),
        ("Two walls of blocks in a chequered pattern, back to back.", chequered()),
        ("Three thick walls in line.", posts()),
        ("A door and a solid that fills it.", plugs()),
        ("Blocks that meet in a slanted plane off the grid.", slanted()),
        ("Wedges whose edges meet.", wedges()),
    ];
    for (about, scenes) in families {
        for (index, scene) in scenes.iter().enumerate() {
            let scene = match index % 5 {
                2 => scene.moved("2^20 units away", "FarFromOrigin", &q(1), &power(20)),
                4 => scene.moved("Scaled by 0.0254", "UnitScale", &ratio(127, 5000), &q(0)),
                _ => scene.clone(),
            };
            scene.add(book, about, index);
        }
    }
}

fn block(x: [Q; 2], y: [Q; 2], z: [Q; 2]) -> Brush {
    let corner = |i: usize| vec![x[i].clone(), y[i].clone(), z[i].clone()];
    Brush::Box([corner(0), corner(1)])
}

fn corners(low: [i64; 3], high: [i64; 3]) -> [Point; 2] {
    [low.map(q).to_vec(), high.map(q).to_vec()]
}

/// Walls across z, in a view 8 wide and high, with view cells before the first and behind the last.
fn along_z(
    comment: String,
    flags: &[&'static str],
    brushes: Vec<Brush>,
    [first, last]: [Q; 2],
    between: Between,
    (sign, class, how): (i64, Class, &str),
) -> Scene {
    let at = |x: i64, z: &Q| vec![q(x), q(x), z.clone()];
    let end = &last + q(2);
    let mut flags = flags.to_vec();
    flags.push("Solids");
    flags.push(if sign == 0 { "Flush" } else { "OneUnit" });
    Scene {
        comment: format!("{comment} {how}"),
        flags,
        brushes,
        view: [at(0, &q(0)), at(8, &end)],
        near: [at(0, &q(0)), at(8, &first)],
        far: [at(0, &last), at(8, &end)],
        between,
        class,
    }
}

fn across(z: Q) -> Between {
    Between::Closed([0, 0, 1].map(q).to_vec(), z)
}

fn units(of: &[(i64, i64)]) -> Vec<(Q, String)> {
    of.iter().map(|&(n, d)| (ratio(n, d), ratio(n, d).to_string())).collect()
}

fn side_by_side() -> Vec<Scene> {
    let mut scenes = Vec::new();
    for (unit, name) in units(&[(1, 1), (1, 20), (1, 1_000_000_000_000)]) {
        for is_t in [false, true] {
            for critical in GAPS {
                let right = q(4) + &unit * q(critical.0);
                let (x, z) = ([right.clone(), q(8)], [q(2), q(3)]);
                let mut brushes = vec![block([q(0), q(4)], [q(0), q(8)], z.clone())];
                brushes.extend(match is_t {
                    false => vec![block(x, [q(0), q(8)], z)],
                    true => {
                        vec![block(x.clone(), [q(0), q(5)], z.clone()), block(x, [q(5), q(8)], z)]
                    }
                });
                let slit = |z: i64| vec![square(&q(z), [q(4), right.clone()], [q(0), q(8)])];
                let between = match critical.1 {
                    Open => Between::Openings(vec![slit(2), slit(3)]),
                    _ => across(ratio(5, 2)),
                };
                let what = match is_t {
                    false => "Two blocks side by side, their faces at x = 4",
                    true => "A block beside two that stand one on the other, faces at x = 4",
                };
                let comment = format!("{what}; the unit is {name}.");
                let flags: &[_] =
                    if is_t { &["CoincidentFaces", "TJunction"] } else { &["CoincidentFaces"] };
                scenes.push(along_z(comment, flags, brushes, [q(2), q(3)], between, critical));
            }
        }
    }
    scenes
}

/// In the plan, blocks fill the lower left and the upper right; near is the upper left and far the
/// lower right.
fn diagonal() -> Vec<Scene> {
    let mut scenes = Vec::new();
    for (unit, name) in units(&[(1, 1), (1, 100), (1, 1_000_000_000)]) {
        for critical in GAPS {
            let (sign, class, how) = critical;
            let corner = q(4) + &unit * q(sign);
            let (whole_z, low) = ([q(0), q(4)], [q(0), q(4)]);
            let high = [corner.clone(), q(8)];
            let brushes =
                vec![block(low.clone(), low, whole_z.clone()), block(high.clone(), high, whole_z)];
            let least = q(4).min(corner.clone());
            let upright = |a: [&Q; 2], b: [&Q; 2]| -> Polygon {
                let at = |p: [&Q; 2], z: i64| vec![p[0].clone(), p[1].clone(), q(z)];
                vec![at(a, 0), at(b, 0), at(b, 4), at(a, 4)]
            };
            // Out of near through its right side, past both edges, through far's upper side.
            let (four, eight) = (q(4), q(8));
            let gates = vec![
                vec![upright([&four, &eight], [&four, &four]).into_iter().rev().collect()],
                vec![upright([&four, &four], [&corner, &corner])],
                vec![upright([&four, &four], [&eight, &four])],
            ];
            let between = match class {
                Open => Between::Openings(gates),
                _ => Between::Closed([1, -1, 0].map(q).to_vec(), q(0)),
            };
            scenes.push(Scene {
                comment: format!(
                    "Two blocks, diagonally, with edges at (4, 4); the view cells are in the other \
                     two quarters, and the unit is {name}. {how}"
                ),
                flags: vec!["Solids", "SharedEdge", if sign == 0 { "Flush" } else { "OneUnit" }],
                brushes,
                view: corners([0; 3], [8, 8, 4]),
                near: [[0, 4, 0].map(q).to_vec(), vec![least.clone(), q(8), q(4)]],
                far: [[4, 0, 0].map(q).to_vec(), vec![q(8), least, q(4)]],
                between,
                class,
            });
        }
    }
    scenes
}

/// Two quarters of each wall are blocks, those that the other wall's are not.
fn chequered() -> Vec<Scene> {
    let mut scenes = Vec::new();
    let halves = [[0, 4], [4, 8]];
    for (unit, name) in units(&[(1, 1), (1, 10), (1, 10_000_000_000)]) {
        for critical in GAPS {
            let start = q(3) + &unit * q(critical.0);
            let walls = [[q(2), q(3)], [start.clone(), &start + q(1)]];
            let quarter = |z: &[Q; 2], i: usize, j: usize| {
                block(halves[i].map(q), halves[j].map(q), z.clone())
            };
            let mut brushes = vec![quarter(&walls[0], 0, 0), quarter(&walls[0], 1, 1)];
            brushes.extend([quarter(&walls[1], 0, 1), quarter(&walls[1], 1, 0)]);
            let open = |z: &Q, i: usize| vec![square(z, halves[i].map(q), halves[1].map(q))];
            let between = match critical.1 {
                // One way of four: past the edge between the upper quarters.
                Open => Between::Openings(vec![
                    open(&walls[0][0], 0),
                    open(&walls[0][1], 0),
                    open(&walls[1][0], 1),
                    open(&walls[1][1], 1),
                ]),
                _ => across(q(3)),
            };
            let comment = format!(
                "Two walls back to back, chequered: where the one is open the other is solid, and \
                 edges and corners meet. The unit is {name}."
            );
            let ends = [q(2), &start + q(1)];
            let flags = &["SharedEdge", "CornerTouch"];
            scenes.push(along_z(comment, flags, brushes, ends, between, critical));
        }
    }
    scenes
}

/// Half walls: solid on the right, on the left, on the right; their edges are in line.
fn posts() -> Vec<Scene> {
    let mut scenes = Vec::new();
    for (unit, name) in units(&[(1, 1), (1, 1_000_000_000)]) {
        for layout in 0..5 {
            for critical in TRIPLE {
                let edge = q(4) - &unit * q(critical.0);
                let y = || [q(0), q(8)];
                let mut brushes = vec![
                    block([q(4), q(8)], y(), [2, 3].map(q)),
                    block([q(4), q(8)], y(), [8, 9].map(q)),
                ];
                let x = [q(0), edge.clone()];
                let middle = block(x.clone(), y(), [5, 6].map(q));
                let (flag, what, more) = match layout {
                    0 => ("HalfWall", "three blocks", vec![middle]),
                    1 => {
                        let half = ratio(11, 2);
                        let parts = vec![
                            block(x.clone(), y(), [q(5), half.clone()]),
                            block(x, y(), [half, q(6)]),
                        ];
                        ("CoincidentFaces", "the middle one of two blocks, face to face", parts)
                    }
                    2 => {
                        let inner = block([q(1), q(3)], [1, 7].map(q), [5, 6].map(q));
                        let deep = block([q(1), q(2)], [2, 3].map(q), [q(5), ratio(11, 2)]);
                        (
                            "Nested",
                            "the middle one with two more solids in it",
                            vec![middle, inner, deep],
                        )
                    }
                    3 => {
                        let bar = block([edge.clone(), q(8)], [3, 5].map(q), [5, 6].map(q));
                        (
                            "TwoWays",
                            "the middle one with a bar across what it leaves",
                            vec![middle, bar],
                        )
                    }
                    _ => {
                        let parts = vec![
                            block([q(0), q(3)], y(), [5, 6].map(q)),
                            block([q(2), edge.clone()], y(), [5, 6].map(q)),
                        ];
                        ("Overlap", "the middle one of two blocks that overlap", parts)
                    }
                };
                brushes.extend(more);
                let left = |z: i64| vec![whole(z, [0, 4], [0, 8])];
                let free = if flag == "TwoWays" { vec![[0, 3], [5, 8]] } else { vec![[0, 8]] };
                let right = |z: i64| -> Vec<Polygon> {
                    let window = |y: &[i64; 2]| square(&q(z), [edge.clone(), q(8)], y.map(q));
                    free.iter().map(window).collect()
                };
                let openings = vec![left(2), left(3), right(5), right(6), left(8), left(9)];
                let comment = format!(
                    "Half walls one unit thick, solid on the right, left, right, their edges in \
                     line: {what}. The unit is {name}."
                );
                let between = Between::Openings(openings);
                scenes.push(along_z(comment, &[flag], brushes, [q(2), q(9)], between, critical));
            }
        }
    }
    scenes
}

/// A solid stands in a door, which it fills but for a gap on one side.
fn plugs() -> Vec<Scene> {
    let mut scenes = Vec::new();
    for (unit, name) in units(&[(1, 1), (1, 20), (1, 1_000_000_000_000)]) {
        for critical in GAPS {
            let right = q(6) - &unit * q(critical.0);
            let y = || [q(0), q(8)];
            let brushes = vec![
                block([q(0), q(2)], y(), [2, 3].map(q)),
                block([q(6), q(8)], y(), [2, 3].map(q)),
                block([q(2), right.clone()], y(), [ratio(9, 4), ratio(11, 4)]),
            ];
            let door = |z: i64| vec![whole(z, [2, 6], [0, 8])];
            let slit = |z: Q| vec![square(&z, [right.clone(), q(6)], [q(0), q(8)])];
            let between = match critical.1 {
                Open => {
                    Between::Openings(vec![door(2), slit(ratio(9, 4)), slit(ratio(11, 4)), door(3)])
                }
                _ => across(ratio(5, 2)),
            };
            let comment = format!("A door, and a thinner solid that fills it; the unit is {name}.");
            let flags = &["CoincidentFaces"];
            scenes.push(along_z(comment, flags, brushes, [q(2), q(3)], between, critical));
        }
    }
    scenes
}

/// Two blocks meet in the plane m · (x, y) = c, whose corners are on no grid of the walls'.
fn slanted() -> Vec<Scene> {
    let mut scenes = Vec::new();
    let planes = [([7, 3], ratio(124, 3)), ([5, -2], ratio(55, 7)), ([3, 1], ratio(50, 3))];
    for (index, (m, level)) in planes.into_iter().enumerate() {
        for (unit, name) in units(&[(1, 1), (1, 1_000_000_000)]) {
            for critical in GAPS {
                let upper = &level + &unit * q(critical.0);
                let x = |level: &Q, y: i64| (level - q(m[1] * y)) / q(m[0]);
                let part = |level: &Q, is_low: bool| match index {
                    1 => hull(&[x(level, 0), x(level, 8)], if is_low { 0 } else { 8 }),
                    _ => half(m, level, if is_low { 1 } else { -1 }),
                };
                let brushes = vec![part(&level, true), part(&upper, false)];
                let slit = |z: i64| {
                    let at = |level: &Q, y: i64| vec![x(level, y), q(y), q(z)];
                    vec![vec![at(&level, 0), at(&upper, 0), at(&upper, 8), at(&level, 8)]]
                };
                let between = match critical.1 {
                    Open => Between::Openings(vec![slit(2), slit(3)]),
                    _ => across(ratio(5, 2)),
                };
                let comment = format!(
                    "Two blocks that meet in the plane {} x + {} y = {level}; the unit is {name} on \
                     the right of that.",
                    m[0], m[1]
                );
                let flags = &["CoincidentFaces", "OffGrid"];
                scenes.push(along_z(comment, flags, brushes, [q(2), q(3)], between, critical));
            }
        }
    }
    scenes
}

/// The part of a wall where `sign` times m · (x, y) is at most that of the level, by its planes.
fn half(m: [i64; 2], level: &Q, sign: i64) -> Brush {
    let axes = [([1, 0, 0], 8), ([-1, 0, 0], 0), ([0, 1, 0], 8), ([0, -1, 0], 0)];
    let walls = [([0, 0, 1], 3), ([0, 0, -1], -2)];
    let faces = axes.into_iter().chain(walls).map(|(n, c)| (n.map(q).to_vec(), q(c)));
    let slope = ([m[0] * sign, m[1] * sign, 0].map(q).to_vec(), level * q(sign));
    Brush::Planes(faces.chain([slope]).collect())
}

/// The part of a wall between x = `side` and the line through (x0, 0) and (x1, 8), by its corners.
fn hull(ends: &[Q; 2], side: i64) -> Brush {
    let corner = |x: &Q, y: i64, z: i64| vec![x.clone(), q(y), q(z)];
    let at = |z: i64| {
        [(&ends[0], 0), (&ends[1], 8), (&q(side), 0), (&q(side), 8)].map(|(x, y)| corner(x, y, z))
    };
    Brush::Points([at(2), at(3)].concat())
}

/// A ridge along x at (y, z) = (4, 4), and over it a block or another ridge.
fn wedges() -> Vec<Scene> {
    let mut scenes = Vec::new();
    for (unit, name) in units(&[(1, 1), (1, 1_000_000_000)]) {
        for is_block in [true, false] {
            for critical in GAPS {
                let over = q(4) + &unit * q(critical.0);
                let ridge = |base: i64, edge: &Q| {
                    let end = |x: i64| {
                        [(q(base), 2), (q(base), 6), (edge.clone(), 4)]
                            .map(|(y, z)| vec![q(x), y, q(z)])
                    };
                    Brush::Points([end(0), end(8)].concat())
                };
                let upper = match is_block {
                    true => block([q(0), q(8)], [over.clone(), q(8)], [2, 6].map(q)),
                    false => ridge(8, &over),
                };
                let brushes = vec![ridge(0, &q(4)), upper];
                let height = if is_block { over.clone() } else { q(8) };
                let gate = |z: i64| vec![square(&q(z), [q(0), q(8)], [q(0), height.clone()])];
                let slit = vec![square(&q(4), [q(0), q(8)], [q(4), over.clone()])];
                let between = match critical.1 {
                    Open => Between::Openings(vec![gate(2), slit, gate(6)]),
                    _ => across(q(4)),
                };
                let (what, flag) = match is_block {
                    true => ("and the face of a block", "EdgeOnFace"),
                    false => ("and another's", "SharedEdge"),
                };
                let comment = format!("The edge of a wedge {what}; the unit is {name}.");
                scenes.push(along_z(comment, &[flag], brushes, [q(2), q(6)], between, critical));
            }
        }
    }
    scenes
}

impl Scene {
    /// Scaled, then moved along all axes.
    fn moved(&self, how: &str, flag: &'static str, scale: &Q, by: &Q) -> Scene {
        let shift = [by.clone(), -by, by * ratio(1, 2)];
        let place = |p: &Point| -> Point {
            p.iter().zip(&shift).map(|(c, shift)| c * scale + shift).collect()
        };
        let ends = |ends: &[Point; 2]| ends.each_ref().map(place);
        let plane = |n: &Point, c: &Q| -> (Point, Q) {
            let along: Q = n.iter().zip(&shift).map(|(n, shift)| n * shift).sum();
            (n.clone(), c * scale + along)
        };
        let brush = |brush: &Brush| match brush {
            Brush::Box(corners) => Brush::Box(ends(corners)),
            Brush::Points(points) => Brush::Points(points.iter().map(place).collect()),
            Brush::Planes(faces) => Brush::Planes(faces.iter().map(|(n, c)| plane(n, c)).collect()),
        };
        let polygon = |polygon: &Polygon| polygon.iter().map(place).collect();
        let between = match &self.between {
            Between::Openings(planes) => Between::Openings(
                planes.iter().map(|openings| openings.iter().map(polygon).collect()).collect(),
            ),
            Between::Closed(normal, offset) => {
                let (normal, offset) = plane(normal, offset);
                Between::Closed(normal, offset)
            }
        };
        let mut flags = self.flags.clone();
        flags.push(flag);
        Scene {
            comment: format!("{how}: {}", self.comment),
            flags,
            brushes: self.brushes.iter().map(brush).collect(),
            view: ends(&self.view),
            near: ends(&self.near),
            far: ends(&self.far),
            between,
            class: self.class,
        }
    }

    /// Adds it, asked for in both directions.
    fn add(&self, book: &mut Book, about: &str, index: usize) {
        let brushes: Vec<Value> = self.brushes.iter().map(Brush::to_value).collect();
        let scene = json!({
            "format": "stabline-scene/1",
            "view": values(&self.view),
            "brushes": brushes,
            "objects": [
                { "name": "near", "box": values(&self.near) },
                { "name": "far", "box": values(&self.far) },
            ],
        });
        book.scene(Kind::Scene, about, &format!("solids {index}"), scene);
        for (is_back, [from, to]) in [(false, ["near", "far"]), (true, ["far", "near"])] {
            let (from, to) = (Some(from.to_owned()), Some(to.to_owned()));
            let test = Test { from, to, ..self.proved(is_back) };
            let (comment, portals) = (self.comment.clone(), Vec::new());
            let case = Seq::new(comment, &self.flags, portals, self.class);
            book.judged(&if is_back { case.back() } else { case }, test);
        }
    }

    /// The best verdict of all ways, with why it is no better one.
    fn proved(&self, is_back: bool) -> Test {
        let planes = match &self.between {
            Between::Openings(planes) => planes,
            Between::Closed(normal, offset) => {
                let closed = json!({ "normal": vector(normal), "offset": value(offset) });
                let certificate = Some(json!({ "closed": closed }));
                return Test { class: Some(Blocked), certificate, ..Test::default() };
            }
        };
        let mut ways = vec![Vec::new()];
        for openings in planes {
            let longer = |way: &Vec<Polygon>| {
                let one = |opening: &Polygon| [way.clone(), vec![opening.clone()]].concat();
                openings.iter().map(one).collect::<Vec<_>>()
            };
            ways = ways.iter().flat_map(longer).collect();
        }
        let turn = |way: Vec<Polygon>| if is_back { reversed(&way) } else { way };
        let proved = |way: Vec<Polygon>| {
            let test = of_portals(&way);
            let openings: Vec<Value> = way.iter().map(|opening| values(opening)).collect();
            let mut proof = json!({ "openings": openings });
            if let Some(reason) = &test.certificate {
                proof["reason"] = reason.clone();
            }
            (test, proof)
        };
        let mut ways: Vec<(Test, Value)> = ways.into_iter().map(turn).map(proved).collect();
        ways.sort_by_key(|(test, _)| std::cmp::Reverse(test.class));
        let best = ways[0].0.clone();
        let mut proofs: Vec<Value> = ways.into_iter().map(|(_, proof)| proof).collect();
        let certificate =
            if proofs.len() == 1 { proofs.remove(0) } else { json!({ "ways": proofs }) };
        Test { certificate: Some(certificate), ..best }
    }
}

impl Brush {
    fn to_value(&self) -> Value {
        match self {
            Brush::Box(corners) => json!({ "box": values(corners) }),
            Brush::Points(points) => json!({ "points": values(points) }),
            Brush::Planes(faces) => {
                let face = |(normal, offset): &(Point, Q)| json!({ "normal": vector(normal), "offset": value(offset) });
                json!({ "planes": faces.iter().map(face).collect::<Vec<_>>() })
            }
        }
    }
}

fn vector(point: &Point) -> Vec<Value> {
    point.iter().map(value).collect()
}
