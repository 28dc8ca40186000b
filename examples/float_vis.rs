//! The classic `vis` in floats: a program under test for the vectors, written from the public
//! description of the algorithm (windings are clipped to the planes that separate the first portal
//! from the one that was passed, with 0.1 units of tolerance on every plane test).
//!
//! `stabline vectors run --stream -- target/release/examples/float_vis`
//!
//! It answers portal graphs in space, one case a line, and skips everything else.

use serde_json::{Value, json};
use std::io::BufRead;

/// The tolerance of every plane test, in units.
const EPSILON: f64 = 0.1;

type Vector = [f64; 3];
type Winding = Vec<Vector>;

/// The plane n · x = c.
#[derive(Clone, Copy)]
struct Plane {
    normal: Vector,
    offset: f64,
}

/// A portal as it is left; its plane faces the cell that is entered.
struct Portal {
    from: String,
    to: String,
    winding: Winding,
    plane: Plane,
}

fn sub(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

impl Plane {
    /// The plane through three points; none where they are nearly on one line.
    fn through(a: Vector, b: Vector, c: Vector) -> Option<Plane> {
        let normal = cross(sub(b, a), sub(c, a));
        let length = dot(normal, normal).sqrt();
        if length < EPSILON {
            return None;
        }
        let normal = normal.map(|n| n / length);
        Some(Plane { normal, offset: dot(normal, a) })
    }

    fn height(&self, point: Vector) -> f64 {
        dot(self.normal, point) - self.offset
    }

    fn turned(self) -> Plane {
        Plane { normal: self.normal.map(|n| -n), offset: -self.offset }
    }

    /// What of the winding is in front; none where nothing is by more than the tolerance.
    fn clip(&self, winding: &Winding) -> Option<Winding> {
        let heights: Vec<f64> = winding.iter().map(|&p| self.height(p)).collect();
        if heights.iter().all(|&h| h <= EPSILON) {
            return None;
        }
        if heights.iter().all(|&h| h >= -EPSILON) {
            return Some(winding.clone());
        }
        let mut kept = Winding::new();
        for (i, &a) in winding.iter().enumerate() {
            let next = (i + 1) % winding.len();
            let (h, k, b) = (heights[i], heights[next], winding[next]);
            if h >= -EPSILON {
                kept.push(a);
            }
            if (h > EPSILON && k < -EPSILON) || (h < -EPSILON && k > EPSILON) {
                let t = h / (h - k);
                kept.push([0, 1, 2].map(|i| a[i] + t * (b[i] - a[i])));
            }
        }
        (kept.len() > 2).then_some(kept)
    }
}

/// The target, clipped to all planes through an edge of `source` and a vertex of `pass` that have
/// the one behind them and the other in front.
fn clip_to_separators(source: &Winding, pass: &Winding, target: Winding) -> Option<Winding> {
    let mut target = target;
    for (i, &a) in source.iter().enumerate() {
        let b = source[(i + 1) % source.len()];
        for &vertex in pass {
            let Some(plane) = Plane::through(a, b, vertex) else { continue };
            let far = source.iter().map(|&p| plane.height(p)).find(|h| h.abs() > EPSILON);
            let plane = match far {
                Some(height) if height > 0.0 => plane.turned(),
                Some(_) => plane,
                // Nothing of the source is off the plane.
                None => continue,
            };
            let heights: Vec<f64> = pass.iter().map(|&p| plane.height(p)).collect();
            let is_front = heights.iter().all(|&h| h >= -EPSILON);
            if is_front && heights.iter().any(|&h| h > EPSILON) {
                target = plane.clip(&target)?;
            }
        }
    }
    Some(target)
}

/// What has been crossed on the way.
struct Flow<'a> {
    portals: &'a [Portal],
    goal: &'a str,
    first: &'a Plane,
    crossed: Vec<String>,
}

impl Flow<'_> {
    /// Whether the goal can be seen on from a cell that was entered through `pass`.
    fn reaches(&mut self, cell: &str, source: &Winding, pass: Option<(&Winding, &Plane)>) -> bool {
        if cell == self.goal {
            return true;
        }
        self.crossed.push(cell.to_owned());
        let found = self.portals.iter().any(|portal| {
            portal.from == cell
                && !self.crossed.contains(&portal.to)
                && self.goes_on(portal, source, pass).is_some_and(|(source, target)| {
                    // Borrowed anew: the walk keeps its own list of cells.
                    let (portals, goal, first) = (self.portals, self.goal, self.first);
                    let mut next = Flow { portals, goal, first, crossed: self.crossed.clone() };
                    next.reaches(&portal.to, &source, Some((&target, &portal.plane)))
                })
        });
        self.crossed.pop();
        found
    }

    /// What is left of the first portal and of the next one.
    fn goes_on(
        &self,
        portal: &Portal,
        source: &Winding,
        pass: Option<(&Winding, &Plane)>,
    ) -> Option<(Winding, Winding)> {
        let target = self.first.clip(&portal.winding)?;
        let source = portal.plane.turned().clip(source)?;
        let Some((pass, plane)) = pass else { return Some((source, target)) };
        let target = plane.clip(&target)?;
        let target = clip_to_separators(&source, pass, target)?;
        let source = clip_to_separators(&target, pass, source)?;
        Some((source, target))
    }
}

fn number(value: &Value) -> Option<f64> {
    match value.as_str() {
        None => value.as_f64(),
        Some(text) => match text.split_once('/') {
            None => text.parse().ok(),
            Some((p, q)) => Some(p.parse::<f64>().ok()? / q.parse::<f64>().ok()?),
        },
    }
}

fn portal(value: &Value) -> Option<[Portal; 2]> {
    let point = |p: &Value| -> Option<Vector> {
        let point: Option<Vec<f64>> = p.as_array()?.iter().map(number).collect();
        point?.try_into().ok()
    };
    let winding: Option<Winding> = value["polygon"].as_array()?.iter().map(point).collect();
    let winding = winding?;
    let normal = (1..winding.len() - 1).fold([0.0; 3], |sum: Vector, i| {
        let n = cross(sub(winding[i], winding[0]), sub(winding[i + 1], winding[0]));
        [sum[0] + n[0], sum[1] + n[1], sum[2] + n[2]]
    });
    let length = dot(normal, normal).sqrt();
    let normal = normal.map(|n| n / length);
    let plane = Plane { normal, offset: dot(normal, winding[0]) };
    let name = |field: &str| value[field].as_str().unwrap_or_default().to_owned();
    let back = winding.iter().rev().copied().collect();
    Some([
        Portal { from: name("from"), to: name("to"), winding, plane },
        Portal { from: name("to"), to: name("from"), winding: back, plane: plane.turned() },
    ])
}

fn answer(case: &Value) -> Option<Value> {
    let [from, to] = [case["from"].as_str()?, case["to"].as_str()?];
    let portals: Option<Vec<[Portal; 2]>> =
        case["input"]["portals"].as_array()?.iter().map(portal).collect();
    let portals: Vec<Portal> = portals?.into_iter().flatten().collect();
    let sees = portals.iter().filter(|portal| portal.from == from).any(|portal| {
        let crossed = vec![from.to_owned()];
        let mut flow = Flow { portals: &portals, goal: to, first: &portal.plane, crossed };
        flow.reaches(&portal.to, &portal.winding, None)
    });
    Some(json!({ "class": if sees { "open" } else { "blocked" } }))
}

fn main() {
    for line in std::io::stdin().lock().lines().map_while(Result::ok) {
        let case: Value = serde_json::from_str(&line).unwrap_or_default();
        let answer = match case["kind"].as_str() {
            Some("graph") => answer(&case),
            _ => None,
        };
        println!("{}", answer.unwrap_or_else(|| json!({ "skip": "portal graphs in space only" })));
    }
}
