//! Scenes of geometry. A line from the one view cell to the other misses all that hides; or each of
//! some planes between them is covered, but for its openings, and no line passes these.
//!
//! What is in the plane is taken as upright, from z = 0 to z = 1.

use super::{Point, Q, check_line, check_reason, edges, ensure, number, point, polygons, zero};
use serde_json::Value;
use stabline::num::Int;
use stabline::vectors::{Class, Test};

/// The points with normal · x <= offset.
#[derive(Clone)]
struct HalfSpace {
    normal: [Q; 3],
    offset: Q,
}

/// A closed convex set: a solid, or all within a polygon's edges and plane.
type Convex = Vec<HalfSpace>;

impl HalfSpace {
    fn height(&self, p: &[Q]) -> Q {
        self.normal.iter().zip(p).map(|(n, c)| n * c).sum::<Q>() - &self.offset
    }

    fn reversed(&self) -> HalfSpace {
        HalfSpace { normal: self.normal.clone().map(|c| -c), offset: -self.offset.clone() }
    }

    fn through(normal: [Q; 3], p: &[Q]) -> HalfSpace {
        let offset = normal.iter().zip(p).map(|(n, c)| n * c).sum();
        HalfSpace { normal, offset }
    }
}

/// Checks the line or the reasons of a pair of view cells.
pub fn check(scene: &Value, test: &Test) -> Result<(), String> {
    let proof = test.certificate.as_ref().ok_or("no certificate")?;
    let named = [room(scene, &test.from)?, room(scene, &test.to)?];
    let rooms = named.map(corners);
    let obstacles = obstacles(scene);
    if let Some(plane) = proof.get("closed") {
        let normal = point(&plane["normal"]).try_into().map_err(|_| "no normal")?;
        let plane = HalfSpace { normal, offset: number(&plane["offset"]) };
        let is_forth = is_between(&plane, &rooms);
        ensure(is_forth || is_between(&plane.reversed(), &rooms), "not between the view cells")?;
        check_line(&[], test)?;
        return ensure(
            uncovered(&obstacles, &section(&view(scene), &plane), &[]).is_empty(),
            "the plane is not covered",
        );
    }
    let one = vec![proof.clone()];
    let ways = proof["ways"].as_array().unwrap_or(&one);
    let openings: Vec<Vec<Vec<Point>>> = ways.iter().map(|w| polygons(&w["openings"])).collect();
    check_line(openings.first().ok_or("no way")?, test)?;
    if let Some(line) = &test.witness {
        return check_sight(&obstacles, named, [point(&line[0]), point(&line[1])].map(raised));
    }
    for (way, openings) in ways.iter().zip(&openings) {
        // What is grazing says why it is not open only where that is short.
        if test.class == Some(Class::Blocked) || !way["reason"].is_null() {
            check_reason(openings, &way["reason"])?;
        }
    }
    check_planes(&obstacles, &view(scene), &rooms, &openings)
}

/// Every plane lies between the view cells and is covered but for the openings on it, and every
/// choice of one opening from each plane is one of the ways.
fn check_planes(
    obstacles: &[Convex],
    view: &[Point; 2],
    rooms: &[Vec<Point>; 2],
    ways: &[Vec<Vec<Point>>],
) -> Result<(), String> {
    let mut choices = 1;
    for index in 0..ways[0].len() {
        let mut openings: Vec<Vec<Point>> = Vec::new();
        for way in ways {
            let opening = upright(way.get(index).ok_or("a way is shorter")?);
            if !openings.contains(&opening) {
                openings.push(opening);
            }
        }
        choices *= openings.len();
        let plane = plane_of(&openings[0]);
        let flat = openings.iter().flatten().all(|p| plane.height(p) == zero());
        ensure(flat && is_between(&plane, rooms), "an opening is not between the view cells")?;
        ensure(
            uncovered(obstacles, &section(view, &plane), &openings).is_empty(),
            "there is another opening",
        )?;
    }
    let is_new = |i: usize| ways[..i].iter().all(|way| *way != ways[i]);
    ensure(choices == ways.len() && (0..ways.len()).all(is_new), "a way is left out")
}

fn is_between(plane: &HalfSpace, [from, to]: &[Vec<Point>; 2]) -> bool {
    from.iter().all(|p| plane.height(p) <= zero()) && to.iter().all(|p| plane.height(p) >= zero())
}

/// The line is inside both view cells, one after the other, and meets nothing between.
fn check_sight(obstacles: &[Convex], rooms: [&Value; 2], [p, q]: [Point; 2]) -> Result<(), String> {
    let d: Point = p.iter().zip(&q).map(|(p, q)| q - p).collect();
    let two = Q::from(Int::from(2));
    let middle = |room: &Value| {
        let [from, to] = within(&inside(room), &p, &d).ok_or("the witness misses a view cell")?;
        ensure(from < to, "the witness only touches a view cell").map(|()| (from + to) / &two)
    };
    let (start, end) = (middle(rooms[0])?, middle(rooms[1])?);
    ensure(start < end, "the witness runs the other way")?;
    let hides =
        |solid: &Convex| within(solid, &p, &d).is_some_and(|[from, to]| from <= end && start <= to);
    ensure(!obstacles.iter().any(hides), "something hides the witness")
}

/// From where to where p + t d is in a bounded convex set.
fn within(set: &Convex, p: &[Q], d: &[Q]) -> Option<[Q; 2]> {
    let (mut from, mut to) = (None::<Q>, None::<Q>);
    for half in set {
        let slope: Q = half.normal.iter().zip(d).map(|(n, d)| n * d).sum();
        let height = half.height(p);
        if slope == zero() {
            if height > zero() {
                return None;
            }
            continue;
        }
        let at = -height / &slope;
        match slope > zero() {
            true => to = Some(to.map_or(at.clone(), |to| to.min(at))),
            false => from = Some(from.map_or(at.clone(), |from| from.max(at))),
        }
    }
    let (from, to) = (from?, to?);
    (from <= to).then_some([from, to])
}

/// What is left of a plane's section when all that hides and the openings are taken away.
fn uncovered(obstacles: &[Convex], section: &[Point], openings: &[Vec<Point>]) -> Vec<Vec<Point>> {
    let openings: Vec<Convex> = openings.iter().map(|opening| flat(opening)).collect();
    let mut left = vec![section.to_vec()];
    for set in obstacles.iter().chain(&openings) {
        let mut outside = Vec::new();
        for piece in left {
            let mut inside = piece;
            for half in set {
                // What lies in the boundary of a closed set is in it.
                if inside.iter().any(|p| half.height(p) > zero()) {
                    outside.push(clipped(&inside, &half.reversed()));
                }
                inside = clipped(&inside, half);
                if inside.is_empty() {
                    break;
                }
            }
        }
        outside.retain(|piece| has_area(piece));
        left = outside;
    }
    left
}

/// The plane's part in a box.
fn section([low, high]: &[Point; 2], plane: &HalfSpace) -> Vec<Point> {
    let solved = (0..3).find(|&i| plane.normal[i] != zero()).expect("a normal is not zero");
    let (u, v) = ((solved + 1) % 3, (solved + 2) % 3);
    let corner = |a: &Point, b: &Point| {
        let mut p = vec![zero(), zero(), zero()];
        (p[u], p[v]) = (a[u].clone(), b[v].clone());
        p[solved] = -plane.height(&p) / &plane.normal[solved];
        p
    };
    let whole = vec![corner(low, low), corner(high, low), corner(high, high), corner(low, high)];
    axial_box(low, high).iter().fold(whole, |polygon, half| clipped(&polygon, half))
}

/// The part of a convex polygon in a half-space.
fn clipped(polygon: &[Point], half: &HalfSpace) -> Vec<Point> {
    let mut part = Vec::new();
    for (i, p) in polygon.iter().enumerate() {
        let q = &polygon[(i + 1) % polygon.len()];
        let (a, b) = (half.height(p), half.height(q));
        if a <= zero() {
            part.push(p.clone());
        }
        if (a < zero() && b > zero()) || (a > zero() && b < zero()) {
            let t = &a / (&a - &b);
            part.push(p.iter().zip(q).map(|(p, q)| p + (q - p) * &t).collect());
        }
    }
    part
}

fn has_area(polygon: &[Point]) -> bool {
    polygon.len() >= 3 && normal(polygon).iter().any(|c| *c != zero())
}

/// Twice the area, across the polygon.
fn normal(polygon: &[Point]) -> [Q; 3] {
    // The moments of the edges sum to it.
    let mut sum = [zero(), zero(), zero()];
    for edge in edges(polygon) {
        sum.iter_mut().zip(&edge[3..]).for_each(|(sum, c)| *sum += c);
    }
    sum
}

fn plane_of(polygon: &[Point]) -> HalfSpace {
    HalfSpace::through(normal(polygon), &polygon[0])
}

/// A polygon as a set without thickness: its plane from both sides, then its sides.
fn flat(polygon: &[Point]) -> Convex {
    let plane = plane_of(polygon);
    let n = &plane.normal;
    let side = |i: usize| {
        let q = &polygon[(i + 1) % polygon.len()];
        let d: Point = polygon[i].iter().zip(q).map(|(p, q)| q - p).collect();
        let outward = [(1, 2), (2, 0), (0, 1)].map(|(a, b)| &d[a] * &n[b] - &d[b] * &n[a]);
        HalfSpace::through(outward, q)
    };
    let sides: Convex = (0..polygon.len()).map(side).collect();
    [vec![plane.reversed(), plane.clone()], sides].concat()
}

fn axial_box(low: &[Q], high: &[Q]) -> Convex {
    let half = |i: usize, corner: &[Q], sign: i64| {
        let normal = std::array::from_fn(|j| Q::from(Int::from(if i == j { sign } else { 0 })));
        HalfSpace::through(normal, corner)
    };
    (0..3).flat_map(|i| [half(i, low, -1), half(i, high, 1)]).collect()
}

/// The half-spaces of all planes through three of the points that have the others behind.
fn hull(points: &[Point]) -> Convex {
    let mut faces = Convex::new();
    let count = points.len();
    let orders = (0..count.pow(3)).map(|n| [n / count / count, n / count % count, n % count]);
    for [i, j, k] in orders.filter(|[i, j, k]| i < j && i < k && j != k) {
        let corners = [i, j, k].map(|i| points[i].clone());
        let is_known = |face: &HalfSpace| corners.iter().all(|p| face.height(p) == zero());
        if !has_area(&corners) || faces.iter().any(is_known) {
            continue;
        }
        let face = plane_of(&corners);
        if points.iter().all(|p| face.height(p) <= zero()) {
            faces.push(face);
        }
    }
    faces
}

/// All that hides.
fn obstacles(scene: &Value) -> Vec<Convex> {
    let list = |name: &str| scene[name].as_array().into_iter().flatten();
    let polygon = |polygon: &Value| -> Vec<Point> {
        upright(&polygon.as_array().expect("points").iter().map(point).collect::<Vec<_>>())
    };
    let thin = list("polygons").map(|p| flat(&polygon(&p["polygon"])));
    let segments = list("segments").map(|s| flat(&polygon(s)));
    thin.chain(segments).chain(list("brushes").map(brush)).collect()
}

fn brush(brush: &Value) -> Convex {
    let points = |name: &str| brush[name].as_array().map(|p| p.iter().map(point).collect());
    let half = |plane: &Value| HalfSpace {
        normal: point(&plane["normal"]).try_into().expect("a normal"),
        offset: number(&plane["offset"]),
    };
    let corners: Option<Vec<Point>> = points("box");
    if let Some(corners) = corners {
        return axial_box(&corners[0], &corners[1]);
    }
    match points("points") {
        Some(corners) => hull(&corners),
        None => brush["planes"].as_array().expect("planes").iter().map(half).collect(),
    }
}

/// The object of this name.
fn room<'s>(scene: &'s Value, name: &Option<String>) -> Result<&'s Value, String> {
    let mut objects = scene["objects"].as_array().ok_or("no objects")?.iter();
    let object = objects.find(|object| object["name"].as_str() == name.as_deref());
    object.ok_or_else(|| "no such object".to_owned())
}

fn inside(room: &Value) -> Convex {
    let corners = corners(room);
    let (low, high) = (&corners[0], &corners[corners.len() - 1]);
    let Some(polygon) = room["polygon"].as_array() else { return axial_box(low, high) };
    let sides = flat(&corners[..polygon.len()]).split_off(2);
    let heights = axial_box(&corners[0], &corners[polygon.len()]).split_off(4);
    [sides, heights].concat()
}

fn corners(room: &Value) -> Vec<Point> {
    if let Some(polygon) = room["polygon"].as_array() {
        let polygon: Vec<Point> = polygon.iter().map(point).collect();
        return [0, 1].map(|z| polygon.iter().map(|p| at(p, z)).collect::<Vec<_>>()).concat();
    }
    let [low, high] = [0, 1].map(|end| point(&room["box"][end]));
    let corner = |n: usize| -> Point {
        (0..3).map(|i| if n >> i & 1 == 0 { low[i].clone() } else { high[i].clone() }).collect()
    };
    (0..8).map(corner).collect()
}

fn view(scene: &Value) -> [Point; 2] {
    [0, 1].map(|end| {
        let corner = point(&scene["view"][end]);
        if corner.len() == 2 { at(&corner, end as i64) } else { corner }
    })
}

/// A point of the plane, at a height.
fn at(p: &[Q], z: i64) -> Point {
    vec![p[0].clone(), p[1].clone(), Q::from(Int::from(z))]
}

/// A point of the plane halfway up; a point of space.
fn raised(p: Point) -> Point {
    match p.len() {
        2 => vec![p[0].clone(), p[1].clone(), Q::new(1.into(), 2.into())],
        _ => p,
    }
}

/// A segment as an upright rectangle, in front of which is what is ahead if its left end is first.
fn upright(polygon: &[Point]) -> Vec<Point> {
    match polygon {
        [left, right] if left.len() == 2 => {
            vec![at(right, 0), at(left, 0), at(left, 1), at(right, 1)]
        }
        _ => polygon.to_vec(),
    }
}
