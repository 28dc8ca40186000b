//! The twin for portal sequences in space: open, grazing or blocked, straight from the definition.
//!
//! Nothing here knows Plücker space, cones or quadrics. A directed line is a point P and a
//! direction x; its side of an edge with direction d and moment m is x·(m + d×P), so for a fixed
//! point all conditions are linear in x. Two facts reduce P to a point of some portal's edge:
//!
//! - *Open.* The strict stabbing lines form an open set of lines, and so do the reversed ones,
//!   which are not in it. So its boundary has dimension three, while lines on two different edge
//!   lines at once have dimension two: if the set is not empty, some line of its boundary meets
//!   one edge line only, is strictly right of all others (which puts it through the inside of the
//!   edge), and conversely a small motion of such a line makes it strict everywhere.
//! - *Grazing.* If the sequence is not open, a line that meets every closed portal either runs in
//!   the plane of some portal, or crosses all portals and touches some edge.
//!
//! With P = A + t·B on an edge, whether a direction exists changes only at the roots of the 3×3
//! determinants of the condition vectors: quadratics in t, whose roots are the transversals of four
//! edges. Instead of sampling between all roots, each refutation ([`super::linear`]) is carried as
//! far as its weights keep their signs, and only what no refutation covers is asked about again.
//!
//! Lines in a portal's plane are the transversals of points and segments in the plane. One of them
//! can be moved, within the plane, until it passes through two distinct end points or lies in a
//! second portal's plane; all those candidates are tried against the definition.
//!
//! Complexity: for n edges at most O(n^4) refutations of O(n) each; a handful per edge in practice.

use super::linear::{self, Outcome, Quadratic};
use super::polynomial::Polynomial;
use crate::geom::BigPoint3;
use crate::num::{Int, Rational, Sign, Surd};
use num_integer::Integer;
use num_traits::{One, Zero};

type Vector = [Int; 3];

/// A line by two distinct points, in its direction.
pub type LinePoints = [[Surd; 3]; 2];

/// What is true of a sequence, with a line that shows it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Truth {
    /// Open: this rational line is strictly right of every edge.
    Open(LinePoints),
    /// Grazing: not open, and this line meets every closed portal in its direction.
    Grazing(LinePoints),
    /// Neither.
    Blocked,
}

/// An oriented edge, as the side product needs it.
struct Edge {
    from: Vector,
    direction: Vector,
    moment: Vector,
}

struct Portal {
    corners: Vec<Vector>,
    normal: Vector,
}

/// Decides a sequence of planar convex portals, each counter-clockwise as seen from the side to
/// which the line leaves.
pub fn classify(portals: &[Vec<BigPoint3>]) -> Truth {
    let portals: Vec<Portal> = portals.iter().map(|corners| Portal::new(corners)).collect();
    let edges: Vec<Edge> = portals.iter().flat_map(Portal::edges).collect();
    if let Some(line) = open_line(&edges, &[]) {
        return Truth::Open(line);
    }
    in_plane_line(&portals)
        .or_else(|| crossing_line(&portals, &edges))
        .map_or(Truth::Blocked, Truth::Grazing)
}

/// A line strictly right of every edge of the portals that crosses their planes strictly in their
/// order, or `None` where there is none.
///
/// Two consecutive planes cut a line in order iff the line is right of the line in which they
/// meet (the module `pvs` derives it), so a condition of order is one more edge, but of unbounded
/// extent. It needs no search of its own: through a line of the open set and a point of it inside
/// some portal there is a pencil on which such a condition changes its sign once, so the set's
/// boundary, too, has lines that meet a portal's edge and nothing else.
pub fn open_in_order(portals: &[Vec<BigPoint3>]) -> Option<LinePoints> {
    let portals: Vec<Portal> = portals.iter().map(|corners| Portal::new(corners)).collect();
    let edges: Vec<Edge> = portals.iter().flat_map(Portal::edges).collect();
    let orders = portals.windows(2).map(|pair| order_of_planes(&pair[0], &pair[1]));
    open_line(&edges, &orders.collect::<Option<Vec<Edge>>>()?)
}

/// The line in which two planes meet, directed so that the lines right of it that cross both
/// forwards cross the first plane first; its direction is zero for parallel planes. `None` for
/// the same plane twice, which no line crosses strictly in order.
fn order_of_planes(first: &Portal, second: &Portal) -> Option<Edge> {
    // From a point p in direction d, n·x = c is met at t = (c - n·p) / (n·d); with positive n·d,
    // t2 > t1 iff (c2 n1 - c1 n2)·d + (n1 × n2)·(p × d) > 0.
    let offset = |portal: &Portal| dot(&portal.normal, &portal.corners[0]);
    let direction = cross(&first.normal, &second.normal);
    let moment =
        sub(&scale(&first.normal, &offset(second)), &scale(&second.normal, &offset(first)));
    let zero = |v: &Vector| v.iter().all(Zero::is_zero);
    // An unbounded line has no start; `from` is only asked of edges that are searched along.
    let from = [(); 3].map(|()| Int::zero());
    (!zero(&direction) || !zero(&moment)).then_some(Edge { from, direction, moment })
}

impl Portal {
    fn new(corners: &[BigPoint3]) -> Portal {
        let corners: Vec<Vector> = corners.iter().map(|p| p.coordinates.clone()).collect();
        let normal = (0..corners.len())
            .map(|i| cross(&corners[i], &corners[(i + 1) % corners.len()]))
            .fold([(); 3].map(|()| Int::zero()), |sum, term| add(&sum, &term));
        Portal { corners, normal }
    }

    fn edges(&self) -> impl Iterator<Item = Edge> + '_ {
        (0..self.corners.len()).map(|i| {
            let (from, to) = (&self.corners[i], &self.corners[(i + 1) % self.corners.len()]);
            Edge { from: from.clone(), direction: sub(to, from), moment: cross(from, to) }
        })
    }

    fn height(&self, point: &Vector) -> Int {
        dot(&self.normal, &sub(point, &self.corners[0]))
    }
}

/// A condition vector that moves with the point A + t·B of an edge: `at + t·slope`.
struct Moving {
    at: Vector,
    slope: Vector,
}

impl Moving {
    /// The condition that a direction at the point is on the positive side of `other`.
    fn side(edge: &Edge, other: &Edge) -> Moving {
        Moving {
            at: add(&other.moment, &cross(&other.direction, &edge.from)),
            slope: cross(&other.direction, &edge.direction),
        }
    }

    fn constant(at: &Vector) -> Moving {
        Moving { at: at.clone(), slope: [(); 3].map(|()| Int::zero()) }
    }

    /// The vector at t, times a positive integer, over the radicand of t.
    fn value(&self, t: &Surd) -> linear::Vector {
        let (a, b) = (t.rational_part(), t.root_part());
        let common = a.denom().lcm(b.denom());
        let p = a.numer() * (&common / a.denom());
        let q = b.numer() * (&common / b.denom());
        [0, 1, 2].map(|i| Quadratic {
            p: &self.at[i] * &common + &self.slope[i] * &p,
            q: &self.slope[i] * &q,
        })
    }

    fn polynomials(&self) -> [Polynomial; 3] {
        [0, 1, 2].map(|i| Polynomial::linear(self.at[i].clone(), self.slope[i].clone()))
    }
}

/// A line strictly right of all edges and of all `orders`, lines of unbounded extent.
fn open_line(edges: &[Edge], orders: &[Edge]) -> Option<LinePoints> {
    for edge in edges {
        let mut strict = Vec::new();
        for other in edges.iter().chain(orders) {
            match same_line(edge, other) {
                // Two edges on one line that want a line on opposite sides of them.
                Some(Sign::Negative) => return None,
                // The same condition twice (the edge itself, or one collinear with it); an edge
                // has no zero direction.
                Some(Sign::Positive | Sign::Zero) => {}
                None => strict.push(Moving::side(edge, other)),
            }
        }
        let search = Search { edge, weak: Vec::new(), strict, closed: false };
        if let Some((t, direction)) = search.run() {
            let conditions = || edges.iter().chain(orders);
            return Some(nudged(conditions, edge, &t, &direction));
        }
    }
    None
}

/// From a line strictly right of all edges but those on the line of `edge`, which it meets at
/// parameter `t` in direction `direction`, a line strictly right of all.
fn nudged<'a, I: Iterator<Item = &'a Edge>>(
    conditions: impl Fn() -> I,
    edge: &Edge,
    t: &Surd,
    direction: &linear::Vector,
) -> LinePoints {
    let direction = [0, 1, 2].map(|i| direction[i].p.clone());
    let across = cross(&edge.direction, &direction);
    let start = [0, 1, 2].map(|i| {
        Rational::from(edge.from[i].clone())
            + t.rational_part() * Rational::from(edge.direction[i].clone())
    });
    let mut step = Rational::one();
    loop {
        for sign in [1, -1] {
            let shift = &step * Rational::from(Int::from(sign));
            let point = [0, 1, 2].map(|i| &start[i] + &shift * Rational::from(across[i].clone()));
            let common = point.iter().fold(Int::one(), |c, x| c.lcm(x.denom()));
            let base = [0, 1, 2].map(|i| point[i].numer() * (&common / point[i].denom()));
            let line = RationalLine { base, weight: common, direction: direction.clone() };
            if conditions().all(|e| line.side(e) == Sign::Positive) {
                return line.points();
            }
        }
        step /= Int::from(2);
    }
}

/// A line that crosses every portal's plane and touches some edge.
fn crossing_line(portals: &[Portal], edges: &[Edge]) -> Option<LinePoints> {
    for edge in edges {
        let weak = edges.iter().map(|other| Moving::side(edge, other)).collect();
        let strict = portals.iter().map(|p| Moving::constant(&p.normal)).collect();
        let search = Search { edge, weak, strict, closed: true };
        if let Some((t, direction)) = search.run() {
            let d = t.radicand();
            let coordinate = |i: usize| Surd::from(edge.from[i].clone());
            let from =
                [0, 1, 2].map(|i| &coordinate(i) + &(&t * &Surd::from(edge.direction[i].clone())));
            let to = [0, 1, 2].map(|i| {
                let Quadratic { p, q } = &direction[i];
                let step =
                    Surd::new(Rational::from(p.clone()), Rational::from(q.clone()), d.clone());
                &from[i] + &step
            });
            return Some([from, to]);
        }
    }
    None
}

/// The search for a point of an edge, at a parameter in [0, 1], and a direction there.
struct Search<'a> {
    edge: &'a Edge,
    weak: Vec<Moving>,
    strict: Vec<Moving>,
    /// Whether isolated parameters and the ends count; where all conditions are strict the good
    /// parameters form an open set, and they need not be looked at.
    closed: bool,
}

impl Search<'_> {
    fn run(&self) -> Option<(Surd, linear::Vector)> {
        debug_assert!(self.edge.direction.iter().any(|c| !c.is_zero()));
        let ends = [Int::zero(), Int::one()].map(Surd::from);
        if self.closed {
            for t in &ends {
                if let Outcome::Direction(x) = self.decide(t) {
                    return Some((t.clone(), x));
                }
            }
        }
        let [low, high] = ends;
        let mut todo = vec![(low, high)];
        while let Some((low, high)) = todo.pop() {
            let t = Surd::from(Surd::rational_between(&low, &high));
            let support = match self.decide(&t) {
                Outcome::Direction(x) => return Some((t, x)),
                Outcome::Relation(support) => support,
            };
            let Some(weights) = self.weights(&support, &t) else {
                // The relation holds at t only.
                todo.push((low, t.clone()));
                todo.push((t, high));
                continue;
            };
            let roots = weights.iter().flat_map(Polynomial::roots);
            let (below, above): (Vec<Surd>, Vec<Surd>) = roots.partition(|root| *root < t);
            let below = below.into_iter().max().filter(|root| *root > low);
            let above = above.into_iter().min().filter(|root| *root < high);
            for root in [&below, &above].into_iter().flatten() {
                if let Some(direction) = self.at_end(&support, &weights, root) {
                    return Some((root.clone(), direction));
                }
            }
            todo.extend(below.map(|root| (low, root)));
            todo.extend(above.map(|root| (root, high)));
        }
        None
    }

    fn decide(&self, t: &Surd) -> Outcome {
        let values =
            |moving: &[Moving]| moving.iter().map(|m| m.value(t)).collect::<Vec<linear::Vector>>();
        linear::decide(&values(&self.weak), &values(&self.strict), t.radicand())
    }

    /// At the end of a relation's range: a direction, unless the relation still holds there (its
    /// weights are not negative by continuity; a strict vector must have kept its own).
    fn at_end(
        &self,
        support: &[usize],
        weights: &[Polynomial],
        root: &Surd,
    ) -> Option<linear::Vector> {
        if !self.closed {
            return None;
        }
        let mut strict = support.iter().zip(weights).filter(|(i, _)| **i >= self.weak.len());
        if strict.any(|(_, weight)| !weight.vanishes_at(root)) {
            return None;
        }
        match self.decide(root) {
            Outcome::Direction(x) => Some(x),
            Outcome::Relation(_) => None,
        }
    }

    /// The weights of the one relation between the vectors of `support`, as polynomials in the
    /// parameter, up to a common factor and signs; `None` if there is no relation but at `t`.
    fn weights(&self, support: &[usize], t: &Surd) -> Option<Vec<Polynomial>> {
        let vectors: Vec<[Polynomial; 3]> = support
            .iter()
            .map(|&i| match i.checked_sub(self.weak.len()) {
                None => self.weak[i].polynomials(),
                Some(i) => self.strict[i].polynomials(),
            })
            .collect();
        let alive = |v: &[Polynomial; 3]| (0..3).find(|&c| !v[c].vanishes_at(t));
        match vectors.as_slice() {
            [v] => v.iter().all(Polynomial::is_zero).then(|| {
                // A zero vector among the strict ones: nothing satisfies it, anywhere.
                vec![Polynomial::linear(Int::one(), Int::zero())]
            }),
            [v, w] => {
                let parallel = poly_cross(v, w).iter().all(Polynomial::is_zero);
                let c = alive(v)?;
                parallel.then(|| vec![w[c].clone(), v[c].clone()])
            }
            [u, v, w] => {
                let planar = poly_dot(&poly_cross(u, v), w).is_zero();
                let c = alive(&poly_cross(u, v))?;
                planar.then(|| {
                    [(v, w), (w, u), (u, v)].map(|(a, b)| poly_cross(a, b)[c].clone()).to_vec()
                })
            }
            [a, b, c, d] => {
                let [ab, cd] = [poly_cross(a, b), poly_cross(c, d)];
                Some(vec![poly_dot(&cd, b), poly_dot(&cd, a), poly_dot(&ab, d), poly_dot(&ab, c)])
            }
            _ => unreachable!("a basic solution has one to four positive components"),
        }
    }
}

/// A line through `base / weight`, weight > 0.
struct RationalLine {
    base: Vector,
    weight: Int,
    direction: Vector,
}

impl RationalLine {
    fn side(&self, edge: &Edge) -> Sign {
        let moment = cross(&self.base, &self.direction);
        let product = &self.weight * dot(&self.direction, &edge.moment);
        Sign::of(&(product + dot(&moment, &edge.direction)))
    }

    /// Whether the line meets the closed portal, in its direction or within its plane.
    fn meets(&self, portal: &Portal) -> bool {
        match Sign::of(&dot(&self.direction, &portal.normal)) {
            Sign::Negative => false,
            Sign::Positive => portal.edges().all(|edge| self.side(&edge) != Sign::Negative),
            // Parallel to the plane: it has to lie in it and pass the polygon there.
            Sign::Zero => {
                if !portal.edges().all(|edge| self.side(&edge) == Sign::Zero) {
                    return false;
                }
                let across = cross(&portal.normal, &self.direction);
                let offset = dot(&across, &self.base);
                let sides = || {
                    let side = |p: &Vector| Sign::of(&(&self.weight * dot(&across, p) - &offset));
                    portal.corners.iter().map(side)
                };
                !sides().all(|s| s == Sign::Positive) && !sides().all(|s| s == Sign::Negative)
            }
        }
    }

    fn points(&self) -> LinePoints {
        let from = [0, 1, 2].map(|i| Rational::new(self.base[i].clone(), self.weight.clone()));
        let to = [0, 1, 2].map(|i| &from[i] + Rational::from(self.direction[i].clone()));
        [from.map(Surd::from), to.map(Surd::from)]
    }
}

/// A line in the plane of some portal that meets all closed portals.
fn in_plane_line(portals: &[Portal]) -> Option<LinePoints> {
    let passes = |line: &RationalLine| portals.iter().all(|portal| line.meets(portal));
    for portal in portals {
        let Some(contacts) = contacts(portal, portals) else { continue };
        for (i, (a, a_weight)) in contacts.iter().enumerate() {
            for (b, b_weight) in &contacts[..i] {
                let direction = sub(&scale(b, a_weight), &scale(a, b_weight));
                let line = RationalLine { base: a.clone(), weight: a_weight.clone(), direction };
                if let Some(line) = both_ways(line).into_iter().find(passes) {
                    return Some(line.points());
                }
            }
        }
        let meets = portals.iter().filter_map(|other| meet(portal, other));
        if let Some(line) = meets.flat_map(both_ways).find(passes) {
            return Some(line.points());
        }
    }
    None
}

fn both_ways(line: RationalLine) -> [RationalLine; 2] {
    let direction = line.direction.clone().map(|c| -c);
    let reversed = RationalLine { base: line.base.clone(), weight: line.weight.clone(), direction };
    [line, reversed]
}

/// The distinct end points of the portals' traces in the plane of `portal`, as (numerators,
/// positive denominator); `None` if some portal does not reach the plane.
fn contacts(portal: &Portal, portals: &[Portal]) -> Option<Vec<(Vector, Int)>> {
    let mut points: Vec<(Vector, Int)> = Vec::new();
    for other in portals {
        let before = points.len();
        let heights: Vec<Int> = other.corners.iter().map(|p| portal.height(p)).collect();
        for i in 0..heights.len() {
            let j = (i + 1) % heights.len();
            let (p, q) = (&other.corners[i], &other.corners[j]);
            match Sign::of(&heights[i]) * Sign::of(&heights[j]) {
                Sign::Negative => {
                    let numerator = sub(&scale(p, &heights[j]), &scale(q, &heights[i]));
                    points.push((numerator, &heights[j] - &heights[i]));
                }
                // A corner in the plane; the other end of the edge has its own turn.
                Sign::Zero if heights[i].is_zero() => points.push((p.clone(), Int::one())),
                Sign::Zero | Sign::Positive => {}
            }
        }
        if points.len() == before {
            return None;
        }
    }
    let mut points: Vec<(Vector, Int)> = points.into_iter().map(in_lowest_terms).collect();
    points.sort_unstable();
    points.dedup();
    Some(points)
}

fn in_lowest_terms((point, weight): (Vector, Int)) -> (Vector, Int) {
    let mut divisor = point.iter().fold(weight.clone(), |g, c| g.gcd(c));
    if weight < Int::zero() {
        divisor = -divisor;
    }
    (point.map(|c| c / &divisor), weight / &divisor)
}

/// The line in which two portals' planes meet.
fn meet(a: &Portal, b: &Portal) -> Option<RationalLine> {
    let direction = cross(&a.normal, &b.normal);
    let weight = dot(&direction, &direction);
    if weight.is_zero() {
        return None;
    }
    let first = scale(&cross(&b.normal, &direction), &dot(&a.normal, &a.corners[0]));
    let second = scale(&cross(&direction, &a.normal), &dot(&b.normal, &b.corners[0]));
    Some(RationalLine { base: add(&first, &second), weight, direction })
}

/// The sign of the ratio of two edges that lie on one line.
fn same_line(e: &Edge, f: &Edge) -> Option<Sign> {
    let parallel = cross(&e.direction, &f.direction).iter().all(Zero::is_zero);
    // A point of a line has the line's moment.
    let same = parallel && cross(&e.from, &f.direction) == f.moment;
    same.then(|| Sign::of(&dot(&e.direction, &f.direction)))
}

fn add(a: &Vector, b: &Vector) -> Vector {
    [0, 1, 2].map(|i| &a[i] + &b[i])
}

fn sub(a: &Vector, b: &Vector) -> Vector {
    [0, 1, 2].map(|i| &a[i] - &b[i])
}

fn scale(a: &Vector, k: &Int) -> Vector {
    [0, 1, 2].map(|i| &a[i] * k)
}

fn dot(a: &Vector, b: &Vector) -> Int {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

fn cross(a: &Vector, b: &Vector) -> Vector {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| &a[i] * &b[j] - &a[j] * &b[i])
}

fn poly_cross(a: &[Polynomial; 3], b: &[Polynomial; 3]) -> [Polynomial; 3] {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| a[i].times(&b[j]).minus(&a[j].times(&b[i])))
}

fn poly_dot(a: &[Polynomial; 3], b: &[Polynomial; 3]) -> Polynomial {
    a[0].times(&b[0]).plus(&a[1].times(&b[1])).plus(&a[2].times(&b[2]))
}

#[cfg(test)]
mod tests;
