//! Whether what a proof says is true, by rationals and the engine, and nothing of the checker.

use super::mutations::{Parts, cuts_of};
use super::witness::{Point, cross, crossing, dot, minus};
use num_traits::{Signed, Zero};
use stabline::num::{Int, Number, Rational};
use stabline::pvs::{self, Options};
use stabline::report::{Silent, Verdict};
use stabline::scene::{PortalGraph, RawGraph, RawPortal};

/// A directed portal's polygon, and the cells that it leaves and enters.
struct Way {
    cells: [usize; 2],
    polygon: Vec<Point>,
}

/// A proof's graph.
struct Stated {
    vertices: Vec<Point>,
    ways: Vec<Way>,
}

type Told<T> = Result<T, String>;

fn told(holds: bool, what: &str) -> Told<()> {
    if holds { Ok(()) } else { Err(what.to_owned()) }
}

fn integers(fields: &[&str]) -> Told<Vec<Int>> {
    let number = |field: &&str| field.parse().map_err(|_| format!("{field} is no number"));
    fields.iter().map(number).collect()
}

fn indices(fields: &[&str]) -> Told<Vec<usize>> {
    let number = |field: &&str| field.parse().map_err(|_| format!("{field} is no index"));
    fields.iter().map(number).collect()
}

fn point(fields: &[&str]) -> Told<Point> {
    let numbers = integers(fields)?;
    told(numbers.len() == 4 && numbers[3].is_positive(), "no vertex")?;
    Ok([0, 1, 2].map(|i| Rational::new(numbers[i].clone(), numbers[3].clone())))
}

impl Stated {
    fn of(parts: &Parts) -> Told<Stated> {
        let fields = |line: usize| parts.lines[line].split(' ').collect::<Vec<_>>();
        let vertices: Vec<Point> =
            parts.vertices.clone().map(|line| point(&fields(line))).collect::<Told<_>>()?;
        let mut ways = Vec::new();
        for line in parts.portals.clone() {
            let numbers = indices(&fields(line))?;
            let corner = |&at: &usize| vertices.get(at).cloned().ok_or("no such vertex");
            let polygon: Vec<Point> = numbers[3..].iter().map(corner).collect::<Result<_, _>>()?;
            let back = polygon.iter().rev().cloned().collect();
            ways.push(Way { cells: [numbers[0], numbers[1]], polygon });
            ways.push(Way { cells: [numbers[1], numbers[0]], polygon: back });
        }
        Ok(Stated { vertices, ways })
    }

    /// The graph as the engine reads it.
    fn graph(&self, cells: usize) -> Told<PortalGraph> {
        let portals = self.ways.iter().step_by(2).map(|way| RawPortal {
            cells: way.cells.map(|cell| cell as u32),
            vertices: way.polygon.iter().map(|p| p.each_ref().map(number)).collect(),
            line: None,
        });
        let raw = RawGraph {
            cells: (0..cells).map(|cell| cell.to_string()).collect(),
            portals: portals.collect(),
            leaf_to_cell: (0..cells as u32).collect(),
            declared_grid: None,
        };
        PortalGraph::from_raw(raw).map_err(|error| error.to_string())
    }

    /// The portals of a sequence from one cell to another.
    fn sequence(&self, fields: &[&str], [a, b]: [usize; 2]) -> Told<Vec<&Way>> {
        let mut cell = a;
        let mut sequence = Vec::new();
        for portal in indices(fields)? {
            let way = self.ways.get(portal).ok_or("no such portal")?;
            told(way.cells[0] == cell, "the portal is not of the cell")?;
            cell = way.cells[1];
            sequence.push(way);
        }
        told(cell == b, "the sequence ends elsewhere")?;
        Ok(sequence)
    }

    /// An open line crosses all portals inside, one after the other.
    fn open(&self, fields: &[&str], pair: [usize; 2]) -> Told<()> {
        let [p, q] = [point(&fields[3..7])?, point(&fields[7..11])?];
        let direction = minus(&q, &p);
        let mut last = None;
        for way in self.sequence(&fields[11..], pair)? {
            let at = crossing(&way.polygon, &p, &direction);
            told(at.is_some() && last < at, "the line does not cross the portals in order")?;
            last = at;
        }
        Ok(())
    }

    /// A grazing line without a root touches all portals.
    fn grazing(&self, fields: &[&str], pair: [usize; 2]) -> Told<()> {
        let numbers = integers(&fields[3..16])?;
        let has_root = !numbers[0].is_zero() && numbers[7..].iter().any(|y| !y.is_zero());
        told(!has_root, "a changed line with a root")?;
        let part = |at: usize| [0, 1, 2].map(|i| Rational::from_integer(numbers[at + i].clone()));
        let [d, m] = [part(1), part(4)];
        let square = dot(&d, &d);
        told(square.is_positive() && dot(&d, &m).is_zero(), "no line")?;
        let foot = cross(&d, &m).map(|c| c / &square);
        let touches = |way: &&Way| touches(&way.polygon, &foot, &d);
        told(self.sequence(&fields[16..], pair)?.iter().all(touches), "a portal is not touched")
    }

    /// All portals cut at a node are beyond a plane that the sequence has crossed for good.
    fn cuts(&self, sequence: &[usize], line: &str) -> Told<()> {
        let fields: Vec<&str> = line.split(' ').collect();
        for at in cuts_of(line) {
            let head =
                (0..at).rev().find(|&at| ["b", "p"].contains(&fields[at])).ok_or("no cut")?;
            let cut = self.ways.get(indices(&fields[at..=at])?[0]).ok_or("no such portal")?;
            let numbers = indices(&fields[head + 1..at])?;
            let crossed = |place: usize| sequence.get(place).map(|&portal| &self.ways[portal]);
            let before = crossed(numbers[0]).ok_or("no such place")?;
            if fields[head] == "b" {
                let is_behind = heights(&before.polygon[..3], cut).iter().all(|h| !h.is_positive());
                let is_before =
                    || heights(&cut.polygon[..3], before).iter().all(|h| !h.is_negative());
                told(is_behind || is_before(), "the portals do not exclude each other")?;
                continue;
            }
            let after = crossed(numbers[1]).ok_or("no such place")?;
            let corner = |&at: &usize| self.vertices.get(at).cloned().ok_or("no such vertex");
            let plane: Vec<Point> = numbers[2..5].iter().map(corner).collect::<Result<_, _>>()?;
            let [low, high, beyond] = [before, after, cut].map(|way| heights(&plane, way));
            let separates = low.iter().all(|h| !h.is_positive())
                && high.iter().all(|h| !h.is_negative())
                && low.iter().chain(&high).any(|h| !h.is_zero())
                && beyond.iter().all(|h| !h.is_positive());
            told(separates && numbers[0] < numbers[1], "the plane does not separate")?;
        }
        Ok(())
    }
}

fn number(c: &Rational) -> Number {
    Number::from(c.clone())
}

/// The heights of a portal's vertices above the plane through three points.
fn heights(plane: &[Point], way: &Way) -> Vec<Rational> {
    let normal = cross(&minus(&plane[1], &plane[0]), &minus(&plane[2], &plane[0]));
    way.polygon.iter().map(|v| dot(&normal, &minus(v, &plane[0]))).collect()
}

/// Whether the line foot + t·d meets the closed polygon, from behind or within its plane.
fn touches(polygon: &[Point], foot: &Point, d: &Point) -> bool {
    let normal = cross(&minus(&polygon[1], &polygon[0]), &minus(&polygon[2], &polygon[0]));
    let height = dot(&normal, &minus(&polygon[0], foot));
    let slope = dot(&normal, d);
    if slope.is_positive() {
        let hit = [0, 1, 2].map(|i| &foot[i] + &d[i] * &height / &slope);
        return (0..polygon.len()).all(|i| {
            let edge = minus(&polygon[(i + 1) % polygon.len()], &polygon[i]);
            !dot(&cross(&edge, &minus(&hit, &polygon[i])), &normal).is_negative()
        });
    }
    let left = cross(&normal, d);
    let offsets: Vec<Rational> = polygon.iter().map(|v| dot(&left, &minus(v, foot))).collect();
    let is_on_one_side =
        offsets.iter().all(Signed::is_positive) || offsets.iter().all(Signed::is_negative);
    slope.is_zero() && height.is_zero() && !is_on_one_side
}

/// Why a changed proof does not say the truth, or that it does: all its claims are true by the
/// engine, its open lines cross, its grazing lines touch, and the cuts of its changed lines hold.
/// A changed refutation has no excuse.
pub fn is_true(original: &Parts, changed: &Parts) -> Told<()> {
    let stated = Stated::of(changed)?;
    let cells = changed.cells();
    let graph = stated.graph(cells)?;
    let finished = pvs::compute(&graph, &Options::default(), Vec::new(), &|_| {}, &Silent);
    let matrix = pvs::assemble(&graph, &finished.rows);
    for (a, b) in (0..cells).flat_map(|a| (0..cells).map(move |b| (a, b))) {
        let is_open = matrix.get(a, b) == Verdict::Open;
        let is_right = match changed.claim([a, b]) {
            b'2' => is_open,
            b'0' | b'1' => !is_open,
            claim => claim == b'3',
        };
        told(is_right, &format!("a false claim of {a} and {b}"))?;
    }
    let is_new = |line: &String| !original.lines.contains(line);
    for line in &changed.lines[changed.shown.clone()] {
        let fields: Vec<&str> = line.split(' ').collect();
        let pair = indices(&fields[1..3])?;
        match fields[0] {
            "open" => stated.open(&fields, [pair[0], pair[1]])?,
            _ if is_new(line) => stated.grazing(&fields, [pair[0], pair[1]])?,
            _ => {}
        }
    }
    let mut sequence = Vec::new();
    for line in changed.nodes().map(|node| &changed.lines[node]) {
        let fields: Vec<&str> = line.split(' ').collect();
        let [depth, portal] = indices(&fields[..2])?[..] else { return Err("no node".to_owned()) };
        sequence.truncate(depth - 1);
        sequence.push(portal);
        let is_refuted = matches!(fields.get(2), Some(&("l" | "i" | "s")));
        told(!is_refuted || !is_new(line), "a changed refutation")?;
        stated.cuts(&sequence, line)?;
    }
    Ok(())
}
