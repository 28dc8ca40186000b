//! Scenes of solids, with a view cell at either end: blocks that share a face, an edge or a corner
//! leave no way, and one unit of gap between them leaves one.
//!
//! Every plane that is named has the one view cell behind it and the other in front, and within
//! the view the solids cover it but for its openings. So every line passes an opening of each
//! plane; and between two planes the openings' hull is free, so those lines do.

mod blocks;
mod slopes;

use super::book::{Book, of_portals};
use super::family::Seq;
use super::number::{Point, Polygon, Q, power, q, ratio, reversed, value, values};
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
        ("Blocks side by side in a wall.", blocks::side_by_side()),
        ("Two blocks, diagonally, at a common edge.", blocks::diagonal()),
        ("Two walls of blocks in a chequered pattern, back to back.", blocks::chequered()),
        ("Three thick walls in line.", blocks::posts()),
        ("A door and a solid that fills it.", blocks::plugs()),
        ("Blocks that meet in a slanted plane off the grid.", slopes::slanted()),
        ("Wedges whose edges meet.", slopes::wedges()),
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
