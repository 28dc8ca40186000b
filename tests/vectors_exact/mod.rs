//! Checks what stands beside an answer, by rationals and the format's pages alone.

mod lines;
mod refutation;
mod scene;

use refutation::check_reason;
use serde_json::Value;
use stabline::num::{Int, Rational};
use stabline::vectors::{Class, Group, Kind, Test};

type Q = Rational;
type Point = Vec<Q>;
type Vector = [Q; 6];

fn number(value: &Value) -> Q {
    let text = value.as_str().map_or_else(|| value.to_string(), str::to_owned);
    let (p, q) = text.split_once('/').unwrap_or((&text, "1"));
    let whole = |text: &str| text.parse::<Int>().expect("an integer");
    Q::new(whole(p), whole(q))
}

fn point(value: &Value) -> Point {
    value.as_array().expect("a point").iter().map(number).collect()
}

fn polygons(value: &Value) -> Vec<Vec<Point>> {
    let polygon = |p: &Value| p.as_array().expect("a polygon").iter().map(point).collect();
    value.as_array().expect("polygons").iter().map(polygon).collect()
}

/// A number a + b√d with a common d.
type Surd = [Q; 2];

fn sign(value: &Surd, d: &Q) -> i32 {
    let of = |q: &Q| i32::from(*q > zero()) - i32::from(*q < zero());
    let [a, b] = value;
    let (a_sign, b_sign) = (of(a), of(&(b * d)));
    match a_sign * b_sign {
        1 => a_sign,
        0 => a_sign + b_sign,
        _ => a_sign * of(&(a * a - b * b * d)),
    }
}

fn zero() -> Q {
    Q::from(Int::from(0))
}

/// (q - p, p × q), or in the plane only what turns need, with z = 0.
fn join(p: &[Q], q: &[Q]) -> Vector {
    let at = |v: &[Q], i: usize| v.get(i).cloned().unwrap_or_else(zero);
    let cross = |i: usize, j: usize| at(p, i) * at(q, j) - at(p, j) * at(q, i);
    let d = |i: usize| at(q, i) - at(p, i);
    [d(0), d(1), d(2), cross(1, 2), cross(2, 0), cross(0, 1)]
}

fn side(x: &Vector, y: &Vector) -> Q {
    (0..6).map(|i| &x[i] * &y[(i + 3) % 6]).sum()
}

/// The edges of a portal as lines; a segment's two ends, as upright lines.
fn edges(portal: &[Point]) -> Vec<Vector> {
    let up = |p: &Point, z: i64| vec![p[0].clone(), p[1].clone(), Q::from(Int::from(z))];
    match portal {
        // A line passes between them with the left one upwards and the right one downwards.
        [left, right] if left.len() == 2 => {
            vec![join(&up(left, 0), &up(left, 1)), join(&up(right, 1), &up(right, 0))]
        }
        _ => (0..portal.len()).map(|i| join(&portal[i], &portal[(i + 1) % portal.len()])).collect(),
    }
}

fn check_witness(portals: &[Vec<Point>], witness: &Value) -> Result<(), String> {
    let line = join(&point(&witness[0]), &point(&witness[1]));
    let is_inside = portals.iter().flat_map(|p| edges(p)).all(|edge| side(&line, &edge) > zero());
    ensure(is_inside, "the witness is not strictly inside")
}

fn ensure(holds: bool, what: &str) -> Result<(), String> {
    holds.then_some(()).ok_or_else(|| what.to_owned())
}

/// The rational part of each coordinate, and its factor of the root.
fn surd_point(point: &Value) -> [Point; 2] {
    let of = |name: &str| {
        point.as_array().expect("a point").iter().map(|c| number(&c[name])).collect::<Point>()
    };
    [of("a"), of("b")]
}

/// The d of all numbers a + b√d in some points.
fn root_of(points: &Value) -> Q {
    let numbers = points.as_array().expect("points").iter().flat_map(|p| p.as_array().unwrap());
    numbers.map(|number_of| number(&number_of["d"])).max().expect("coordinates")
}

/// (p + u√d) joined to (q + v√d): the part without the root, and that with it.
fn surd_join([p, u]: [&[Q]; 2], [q, v]: [&[Q]; 2], d: &Q) -> [Vector; 2] {
    let (pq, uv, pv, uq) = (join(p, q), join(u, v), join(p, v), join(u, q));
    let zeros: Point = p.iter().map(|_| zero()).collect();
    let of_roots = join(&zeros, &vec_difference(v, u));
    let plain = std::array::from_fn(|i| match i {
        0..3 => pq[i].clone(),
        _ => &pq[i] + &uv[i] * d,
    });
    let root = std::array::from_fn(|i| match i {
        0..3 => of_roots[i].clone(),
        _ => &pv[i] + &uq[i],
    });
    [plain, root]
}

/// Meets every closed portal: by weak sides, or within its plane.
fn check_touching(portals: &[Vec<Point>], line: &Value) -> Result<(), String> {
    let ([p, u], [q, v]) = (surd_point(&line[0]), surd_point(&line[1]));
    let d = root_of(line);
    let [plain, root] = surd_join([&p, &u], [&q, &v], &d);
    let is_line = plain[..3].iter().chain(&root[..3]).any(|c| *c != zero());
    ensure(is_line, "the touching line has no direction")?;
    for portal in portals {
        let edges = edges(portal);
        let signs: Vec<i32> =
            edges.iter().map(|edge| sign(&[side(&plain, edge), side(&root, edge)], &d)).collect();
        let forward = signs.iter().all(|&sign| sign >= 0);
        let is_through = forward && signs.iter().any(|&sign| sign > 0);
        ensure(is_through || signs.iter().all(|&sign| sign == 0), "a side is negative")?;
        if is_through || portal[0].len() == 2 {
            continue;
        }
        // In the portal's plane: its vertices must not be strictly on one side.
        let n =
            join(&vec_difference(&portal[1], &portal[0]), &vec_difference(&portal[2], &portal[0]));
        let normal = [n[3].clone(), n[4].clone(), n[5].clone()];
        let end = |a: &[Q], v: &[Q], root: bool| -> Point {
            (0..3).map(|i| if root { a[i].clone() } else { &a[i] - &v[i] }).collect()
        };
        let places: Vec<i32> = portal
            .iter()
            .map(|vertex| {
                // det(normal, direction, vertex - point), expanded in √d.
                let (from, from_root) = (end(&p, vertex, false), end(&u, vertex, true));
                let (d0, d1) = (&plain[..3], &root[..3]);
                let det = |a: &[Q], b: &[Q]| -> Q {
                    let joined = join(a, b);
                    (0..3).map(|i| &normal[i] * &joined[i + 3]).sum()
                };
                let whole = det(d0, &from) + det(d1, &from_root) * &d;
                sign(&[whole, det(d0, &from_root) + det(d1, &from)], &d)
            })
            .collect();
        let apart = places.iter().all(|&s| s > 0) || places.iter().all(|&s| s < 0);
        ensure(!apart, "in a portal's plane, but past it")?;
    }
    Ok(())
}

fn vec_difference(a: &[Q], b: &[Q]) -> Point {
    a.iter().zip(b).map(|(a, b)| a - b).collect()
}

/// The portals of a graph in a sequence of cells from `from`, each turned the way it is crossed.
fn along(scene: &Value, numbers: &Value, from: &str) -> Result<Vec<Vec<Point>>, String> {
    let mut cell = from.to_owned();
    let mut portals = Vec::new();
    for number in numbers.as_array().ok_or("no portals")? {
        let portal = &scene["portals"][number.as_u64().ok_or("no number")? as usize];
        let polygon = portal.get("polygon").or(portal.get("segment")).ok_or("no such portal")?;
        let mut polygon: Vec<Point> = polygon.as_array().unwrap().iter().map(point).collect();
        let ends = ["from", "to"].map(|end| portal[end].as_str().unwrap_or_default());
        ensure(ends.contains(&cell.as_str()), "a portal does not leave the cell")?;
        if ends[0] != cell {
            polygon.reverse();
        }
        cell = ends[usize::from(ends[0] == cell)].to_owned();
        portals.push(polygon);
    }
    Ok(portals)
}

/// All sequences of portals between two cells that enter none twice.
fn simple(
    scene: &Value,
    at: &str,
    to: &str,
    path: &mut Vec<u64>,
    cells: &mut Vec<String>,
) -> Vec<Vec<u64>> {
    if at == to {
        return vec![path.clone()];
    }
    cells.push(at.to_owned());
    let mut all = Vec::new();
    for (portal, index) in scene["portals"].as_array().unwrap().iter().zip(0..) {
        let ends = ["from", "to"].map(|end| portal[end].as_str().unwrap().to_owned());
        for (here, there) in [(&ends[0], &ends[1]), (&ends[1], &ends[0])] {
            if here == at && !cells.contains(there) {
                path.push(index);
                all.extend(simple(scene, there, to, path, cells));
                path.pop();
            }
        }
    }
    cells.pop();
    all
}

fn check_eye(scene: &Value, test: &Test) -> Result<(), String> {
    let input = test.input.as_ref().ok_or("no eye")?;
    let eye = point(&input["at"]);
    let cells = test.cells.as_ref().ok_or("no cells")?;
    let names: Vec<&str> =
        scene["cells"].as_array().unwrap().iter().map(|c| c.as_str().unwrap()).collect();
    for cell in &cells[1..] {
        let place = names.iter().position(|name| name == cell).ok_or("no such cell")?;
        let target = point(&test.witness.as_ref().ok_or("no witness")?[cell]);
        let way: Value = (0..place).collect();
        check_witness(
            &along(scene, &way, names[0])?,
            &serde_json::json!([strings(&eye), strings(&target)]),
        )?;
    }
    let unseen = names.iter().filter(|name| !cells.iter().any(|cell| cell == *name));
    for name in unseen {
        let reason = &test.certificate.as_ref().ok_or("no certificate")?["unseen"][name];
        let axis = reason["axis"].as_u64().ok_or("no axis")? as usize;
        let [low, high] = ["low", "high"].map(|end| number(&reason[end]["slope"]));
        ensure(low >= high, "the slopes leave something")?;
        for (end, is_low) in [("low", true), ("high", false)] {
            let Some(opening) = reason[end]["opening"].as_u64() else { continue };
            let portal = &along(scene, &(0..=opening).collect(), names[0])?[opening as usize];
            let slope =
                |p: &Point| (&p[axis] - &eye[axis]) / (p.last().unwrap() - eye.last().unwrap());
            let slopes = portal.iter().map(slope);
            let bound = if is_low { slopes.min() } else { slopes.max() };
            ensure(bound == Some(number(&reason[end]["slope"])), "a slope is another")?;
        }
    }
    Ok(())
}

fn strings(point: &[Q]) -> Vec<String> {
    point.iter().map(ToString::to_string).collect()
}

/// Checks the line of a sequence that has one.
fn check_line(portals: &[Vec<Point>], test: &Test) -> Result<(), String> {
    match (test.class, &test.witness, &test.touching_line) {
        (Some(Class::Open), Some(line), None) => check_witness(portals, line),
        (Some(Class::Grazing), None, Some(line)) => check_touching(portals, line),
        (Some(Class::Blocked), None, None) => Ok(()),
        _ => Err("another proof than that of its class".to_owned()),
    }
}

fn check_graph(scene: &Value, test: &Test) -> Result<(), String> {
    let from = test.from.as_deref().ok_or("no `from`")?;
    let portals = match test.class {
        Some(Class::Blocked) => Vec::new(),
        _ => along(scene, &serde_json::json!(test.portals), from)?,
    };
    check_line(&portals, test)?;
    let Some(reason) = &test.certificate else { return Ok(()) };
    let to = test.to.as_deref().ok_or("no `to`")?;
    let told = reason["sequences"].as_array().ok_or("no sequences")?;
    for way in simple(scene, from, to, &mut vec![], &mut vec![]) {
        let way = serde_json::json!(way);
        let why = told.iter().find(|told| told["portals"] == way).ok_or("a way is left out")?;
        check_reason(&along(scene, &way, from)?, &why["reason"])?;
    }
    Ok(())
}

/// Checks a test's witness, touching line or certificate.
pub fn check(group: &Group, test: &Test) -> Result<(), String> {
    let scene = group.scene.as_ref().map_or(&Value::Null, |scene| &scene.input);
    match group.kind {
        Kind::Eye => check_eye(scene, test),
        Kind::Transversals => lines::check(test),
        Kind::Scene => scene::check(scene, test),
        Kind::Graph => check_graph(scene, test),
        Kind::Sequence => {
            let portals = polygons(&test.input.as_ref().ok_or("no input")?["portals"]);
            check_line(&portals, test)?;
            test.certificate.as_ref().map_or(Ok(()), |reason| check_reason(&portals, reason))
        }
    }
}
