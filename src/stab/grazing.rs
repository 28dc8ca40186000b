//! Is a sequence that is not open grazing? Exactly, without square roots but in the answer.
//!
//! Weak signs alone are not the question: they accept lines at infinity, and lines in a portal's
//! plane that miss the portal. A line *touches* iff it is finite and, for each portal, either
//! crosses its plane forward with all sides >= 0, or lies in its plane and meets the polygon there.
//! The search for one has two parts.
//!
//! - Lines in the plane of some portal: such a line can be moved within the plane until it passes
//!   two points of the finite set of vertices in the plane and end points of the plane's traces
//!   on the other portals, or is the meet of two portals' planes. All of them are tried (step a).
//! - Lines that cross all planes forward lie in the cone of the edges' half-spaces, where the sum
//!   of its rays tells whether any vector crosses forward (step b). With lineality, the quadric can
//!   be reached along it iff it is not orthogonal to the whole cone (step c). Without, it is
//!   reached where it takes both signs; else only at isotropic rays and double roots on edges (step
//!   d).
//!
//! A search that walks many sequences ([`TouchingLine`]) first tries the lines through two vertices
//! and keeps the line found for as long as it touches what is pushed.
//!
//! Proofs: `docs/formats/stab.md`. For n edges and m portals, step a costs O(m n² · n).

use super::closed::ClosedPortal;
use super::engine::{Engine, Range};
use super::line::{ExactLine, StabLine, meet_of_planes, slope_of};
use super::quadric::{Vector, extremum_of_sign, quadric, side};
use super::sequence::{Frame, Portal3};
use super::stabber::{decide_open, rows_of};
use super::witness::{plus, zero};
use crate::geom::vector::{cross, dot};
use crate::num::{Int, Sign, Surd};

/// The portals' closed cone: all edges, no order, whether or not anything is strictly inside.
pub(super) struct ClosedCone {
    pub(super) rays: Vec<Vector>,
    pub(super) lineality: Vec<Vector>,
    /// The pairs of adjacent rays.
    pub(super) faces: Vec<[usize; 2]>,
    /// The point that the vectors take for the origin.
    pub(super) origin: [Int; 3],
}

impl ClosedCone {
    pub(super) fn new(portals: &[&Portal3]) -> ClosedCone {
        let origin = portals[0].vertices()[0].coordinates.clone();
        let frame = Frame::about(&origin);
        let rows: Vec<_> = portals.iter().flat_map(|p| rows_of(p, None, &frame)).collect();
        let range = Range::default().with(rows.iter().map(|(row, _)| row));
        let mut engine = Engine::everything().widened_for(range);
        for (row, _) in &rows {
            engine.push(row);
        }
        ClosedCone {
            rays: engine.rays(),
            lineality: engine.lineality(),
            faces: engine.faces(),
            origin,
        }
    }
}

/// A line that touches every portal, for a sequence that is not open; `None`: it is blocked.
pub(super) fn touching_line(portals: &[&Portal3], orders: &[bool]) -> Option<StabLine> {
    if orders.contains(&true)
        && let Some(witness) = decide_open(portals, &[])
    {
        // Only the order is violated, which a touching line need not keep.
        let surds = |point: [crate::num::Rational; 3]| point.map(Surd::from);
        return Some(StabLine { points: witness.points.map(surds) });
    }
    let closed: Vec<ClosedPortal> =
        portals.iter().map(|portal| ClosedPortal::new(portal)).collect();
    let closed: Vec<&ClosedPortal> = closed.iter().collect();
    Some(find(&closed)?.points(&closed))
}

/// A touching line by the steps a to d.
fn find(portals: &[&ClosedPortal]) -> Option<ExactLine> {
    let in_plane = portals.iter().find_map(|plane| line_in_plane(&plane.portal, portals));
    let line = in_plane.or_else(|| meet_line(portals)).or_else(|| line_across(portals))?;
    debug_assert!(line.touches_all(portals), "a touching line passes the direct check");
    Some(line)
}

/// A directed line at a finite place that touches every portal of a sequence: crosses its plane
/// forward and meets the closed polygon, or lies in its plane and meets it.
#[derive(Clone, Debug)]
pub struct TouchingLine(ExactLine);

impl TouchingLine {
    /// A line that touches all of `portals`, whether or not one passes strictly inside them; `None`
    /// where they are blocked. The order of the portals is not asked for.
    pub fn of(portals: &[&ClosedPortal]) -> Option<TouchingLine> {
        let (first, last) = (portals.first()?, portals.last()?);
        let quick = through_vertices(first, last).find(|line| line.touches_all(portals));
        quick.or_else(|| find(portals)).map(TouchingLine)
    }

    /// The same line on another grid: `from` units of this one's, and `to` of the other's, are as
    /// long as each other.
    pub fn on_grid(&self, from: &Int, to: &Int) -> TouchingLine {
        TouchingLine(self.0.on_grid(from, to))
    }

    /// Its Plücker vector: the rational part, the factor of the root, and the radicand.
    pub fn vector(&self) -> (Vector, Vector, Int) {
        self.0.parts()
    }

    /// Whether the line touches one more portal, of the same grid.
    pub fn touches(&self, portal: &ClosedPortal) -> bool {
        self.0.touches(portal)
    }
}

/// The lines through a vertex of each portal, in both directions.
fn through_vertices(first: &ClosedPortal, last: &ClosedPortal) -> impl Iterator<Item = ExactLine> {
    let places = |portal: &ClosedPortal| -> Vec<([Int; 3], Int)> {
        let vertices = portal.portal.vertices().iter();
        vertices.map(|vertex| (vertex.coordinates.clone(), Int::from(1))).collect()
    };
    let ends = places(last);
    places(first).into_iter().flat_map(move |p| {
        let lines: Vec<ExactLine> =
            ends.iter().map(|q| ExactLine::rational(through(&p, q))).collect();
        lines.into_iter().flat_map(|line| [line.reversed(), line])
    })
}

/// A touching line that crosses every portal's plane forward (steps b to d).
fn line_across(portals: &[&ClosedPortal]) -> Option<ExactLine> {
    let polygons: Vec<&Portal3> = portals.iter().map(|portal| &portal.portal).collect();
    let cone = ClosedCone::new(&polygons);
    let inside = cone.rays.iter().fold(zero(), |sum, ray| plus(&sum, ray));
    let forward = |p: &&Portal3| Sign::of(&slope_of(&inside, p.normal())) == Sign::Positive;
    if !polygons.iter().all(forward) {
        return None;
    }
    if !cone.lineality.is_empty() {
        return along_lineality(&inside, &cone).map(|line| line.moved(&cone.origin));
    }
    let found = between_signs(&inside, &cone).map(|line| line.moved(&cone.origin));
    let isolated = || isolated_lines(&cone).into_iter().map(|line| line.moved(&cone.origin));
    found.or_else(|| isolated().find(|line| line.touches_all(portals)))
}

/// A touching line through two vertices or trace ends in the portal's plane (step a).
fn line_in_plane(plane: &Portal3, portals: &[&ClosedPortal]) -> Option<ExactLine> {
    let mut points: Vec<([Int; 3], Int)> = Vec::new();
    for portal in portals {
        let ends = trace(plane, &portal.portal);
        if ends.is_empty() {
            return None;
        }
        points.extend(ends);
    }
    for (index, p) in points.iter().enumerate() {
        for q in &points[..index] {
            let line = ExactLine::rational(through(p, q));
            let both = [line.reversed(), line];
            let found = both.into_iter().find(|line| line.touches_all(portals));
            if found.is_some() {
                return found;
            }
        }
    }
    None
}

/// The vertices of the portal that lie in the plane and the points where its edges cross it, with
/// their denominators: nothing where the plane misses the portal.
fn trace(plane: &Portal3, portal: &Portal3) -> Vec<([Int; 3], Int)> {
    let places: Vec<&[Int; 3]> = portal.vertices().iter().map(|v| &v.coordinates).collect();
    let height = |p: &&[Int; 3]| dot(plane.normal(), p) - plane.offset();
    let heights: Vec<Int> = places.iter().map(height).collect();
    let mut points = Vec::new();
    for (i, (p, h)) in places.iter().zip(&heights).enumerate() {
        let next = (i + 1) % places.len();
        let (q, k) = (&places[next], &heights[next]);
        match Sign::of(h) {
            // The vertex lies in the plane.
            Sign::Zero => points.push(((*p).clone(), Int::from(1))),
            sign if Sign::of(k) == -sign => {
                // (k p - h q) / (k - h), with a positive denominator.
                let point: [Int; 3] = std::array::from_fn(|i| k * &p[i] - h * &q[i]);
                let divisor = k - h;
                match Sign::of(&divisor) {
                    Sign::Negative => points.push((point.map(|c| -c), -divisor)),
                    // Heights of opposite signs differ.
                    Sign::Positive | Sign::Zero => points.push((point, divisor)),
                }
            }
            Sign::Positive | Sign::Negative => {}
        }
    }
    points
}

/// The line through a / u and b / v, times u v.
fn through((a, u): &([Int; 3], Int), (b, v): &([Int; 3], Int)) -> Vector {
    let [mx, my, mz] = cross(a, b);
    let direction = |i: usize| u * &b[i] - v * &a[i];
    [direction(0), direction(1), direction(2), mx, my, mz]
}

/// A touching line in which two portals' planes meet (step a).
fn meet_line(portals: &[&ClosedPortal]) -> Option<ExactLine> {
    let pairs =
        portals.iter().enumerate().flat_map(|(i, a)| portals[..i].iter().map(move |b| (a, b)));
    let lines = pairs.map(|(a, b)| ExactLine::rational(meet_of_planes(&a.portal, &b.portal)));
    let mut both = lines.flat_map(|line| [line.reversed(), line]);
    both.find(|line| line.touches_all(portals))
}

/// Step c: from inside the cone along a line of the lineality space to the quadric.
fn along_lineality(inside: &Vector, cone: &ClosedCone) -> Option<ExactLine> {
    for line in &cone.lineality {
        for ray in std::iter::once(&zero()).chain(&cone.rays) {
            let start = plus(inside, ray);
            let slope = side(&start, line);
            let reached = match Sign::of(&slope) {
                Sign::Positive => (slope, -quadric(&start)),
                Sign::Negative => (-slope, quadric(&start)),
                // Tangent along this line: another point's plane may not be.
                Sign::Zero => continue,
            };
            let (scale, step) = reached;
            let vector = std::array::from_fn(|i| &scale * &start[i] + &step * &line[i]);
            return Some(ExactLine::rational(vector));
        }
    }
    None
}

/// Step d, first half: the quadric between a point inside the cone, where it is not zero, and one
/// where it has the other sign.
fn between_signs(inside: &Vector, cone: &ClosedCone) -> Option<ExactLine> {
    let here = Sign::of(&quadric(inside));
    if here == Sign::Zero {
        return Some(ExactLine::rational(inside.clone()));
    }
    let ray = cone.rays.iter().find(|ray| Sign::of(&quadric(ray)) == -here).cloned();
    let on_edge = |&[i, j]: &[usize; 2]| extremum_of_sign([&cone.rays[i], &cone.rays[j]], -here);
    let beyond = ray.or_else(|| cone.faces.iter().find_map(on_edge))?;
    ExactLine::between(inside, &beyond).into_iter().next()
}

/// Step d, second half: rays that are lines, and edges that touch the quadric in one point.
fn isolated_lines(cone: &ClosedCone) -> Vec<ExactLine> {
    let isotropic = cone.rays.iter().filter(|ray| quadric(ray) == Int::ZERO);
    let mut lines: Vec<ExactLine> = isotropic.cloned().map(ExactLine::rational).collect();
    for &[i, j] in &cone.faces {
        let (r, s) = (&cone.rays[i], &cone.rays[j]);
        let (rr, rs, ss) = (side(r, r), side(r, s), side(s, s));
        if rr != Int::ZERO && ss != Int::ZERO && &rs * &rs == rr * ss {
            lines.extend(ExactLine::between(r, s));
        }
    }
    lines
}
