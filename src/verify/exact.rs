//! Points, planes and lines in unbounded integers; the portal graph.

use super::text::{Checked, Fields, Reader, ensure};
use num_bigint::{BigInt, Sign};
use num_traits::Signed;
use std::io::BufRead;

/// A point (X, Y, Z, W), or a plane (N, -D): the product of the two is the point's height.
pub type Four = [BigInt; 4];

/// A direction, then a moment.
pub type Vector = [BigInt; 6];

/// The line from a point to another.
pub fn join(p: &Four, q: &Four) -> Vector {
    let arm = |i: usize| &p[3] * &q[i] - &q[3] * &p[i];
    let turn = |i: usize, j: usize| &p[i] * &q[j] - &p[j] * &q[i];
    [arm(0), arm(1), arm(2), turn(1, 2), turn(2, 0), turn(0, 1)]
}

/// d_x · m_y + m_x · d_y.
pub fn side(x: &Vector, y: &Vector) -> BigInt {
    (0..6).map(|i| &x[i] * &y[(i + 3) % 6]).sum()
}

/// The plane through three points; its front sees them counter-clockwise.
pub fn plane([a, b, c]: [&Four; 3]) -> Four {
    let line = join(a, b);
    let turn = |i: usize, j: usize| &line[i] * &c[j] - &line[j] * &c[i];
    let normal = |k: usize| &c[3] * &line[3 + k] + turn((k + 1) % 3, (k + 2) % 3);
    let offset: BigInt = (0..3).map(|k| &line[3 + k] * &c[k]).sum();
    [normal(0), normal(1), normal(2), -offset]
}

/// The sign of a + b√r, for r that is not negative: that of a |a| + b |b| r.
pub fn sign_of_surd(a: &BigInt, b: &BigInt, r: &BigInt) -> Sign {
    (a * a.abs() + b * b.abs() * r).sign()
}

/// The least and the greatest of some signs.
pub fn range(signs: impl Iterator<Item = Sign>) -> [Sign; 2] {
    signs.fold([Sign::Plus, Sign::Minus], |[low, high], sign| [low.min(sign), high.max(sign)])
}

/// The order vector of two planes: dual to the line through two points.
pub fn order(first: &Four, second: &Four) -> Vector {
    let dual = join(first, second);
    std::array::from_fn(|i| dual[(i + 3) % 6].clone())
}

/// A portal in one of its two directions.
pub struct Directed {
    pub from: usize,
    pub to: usize,
    /// Counter-clockwise as seen from the cell entered.
    pub corners: Vec<Four>,
    pub edges: Vec<Vector>,
    /// The lines through the corners that are normal to the plane.
    pub normals: Vec<Vector>,
    pub plane: Four,
}

impl Directed {
    fn new(from: usize, to: usize, corners: Vec<Four>) -> Checked<Directed> {
        let count = corners.len();
        ensure(from != to && count > 2, "a portal joins two cells and has three vertices")?;
        let plane = plane([&corners[0], &corners[1], &corners[2]]);
        let front = [plane[0].clone(), plane[1].clone(), plane[2].clone(), BigInt::ZERO];
        let edge = |i: usize| join(&corners[i], &corners[(i + 1) % count]);
        let edges: Vec<_> = (0..count).map(edge).collect();
        let normals: Vec<_> = corners.iter().map(|corner| join(corner, &front)).collect();
        // Every other corner is strictly on the inner side of each edge.
        let is_inside = |i: usize, j: usize| side(&edges[i], &normals[j]).sign() == Sign::Plus;
        let mut others = (0..count * (count - 2)).map(|n| (n / (count - 2), n % (count - 2) + 2));
        let is_convex = others.all(|(i, step)| is_inside(i, (i + step) % count));
        let portal = Directed { from, to, corners, edges, normals, plane };
        let is_flat = portal.heights(&portal.plane) == [Sign::NoSign; 2];
        ensure(is_flat && is_convex, "the portal is not planar and convex").map(|()| portal)
    }

    /// The range of the signs of the vertices' heights.
    pub fn heights(&self, plane: &Four) -> [Sign; 2] {
        let height = |corner: &Four| (0..4).map(|i| &plane[i] * &corner[i]).sum::<BigInt>();
        range(self.corners.iter().map(|corner| height(corner).sign()))
    }
}

/// A portal graph.
#[derive(Default)]
pub struct Graph {
    pub points: Vec<Four>,
    pub portals: Vec<Directed>,
    /// The directed portals that leave each cell.
    pub leaving: Vec<Vec<usize>>,
}

impl Graph {
    pub fn read(reader: &mut Reader<impl BufRead>) -> Checked<Graph> {
        let mut graph = Graph::default();
        for word in ["cells", "vertices", "portals"] {
            let mut head = reader.next()?;
            head.word(word)?;
            let count = head.index(usize::MAX).and_then(|count| head.end().map(|()| count))?;
            for _ in 0..count {
                let mut fields = reader.next()?;
                match word {
                    "cells" => graph.leaving.push(Vec::new()), // The line is its name.
                    "vertices" => graph.points.push(fields.point()?),
                    _ => graph.read_portal(&mut fields)?,
                }
            }
        }
        Ok(graph)
    }

    fn read_portal(&mut self, fields: &mut Fields) -> Checked<()> {
        let [from, to] = [fields.index(self.leaving.len())?, fields.index(self.leaving.len())?];
        fields.index(usize::MAX)?;
        let ids = fields.indices(self.points.len())?;
        let forwards: Vec<Four> = ids.iter().map(|&id| self.points[id].clone()).collect();
        let backwards = forwards.iter().rev().cloned().collect();
        for (from, to, corners) in [(from, to, forwards), (to, from, backwards)] {
            self.leaving[from].push(self.portals.len());
            self.portals.push(Directed::new(from, to, corners)?);
        }
        fields.end()
    }

    /// The rest of the fields: a sequence from one cell to another.
    pub fn sequence(&self, fields: &mut Fields, [a, b]: [usize; 2]) -> Checked<Vec<&Directed>> {
        let mut crossed = vec![a];
        let mut sequence = Vec::new();
        for portal in fields.indices(self.portals.len())? {
            let portal = &self.portals[portal];
            let goes_on = crossed.last() == Some(&portal.from) && !crossed.contains(&portal.to);
            ensure(goes_on, "a portal does not go on from the cell before into a new one")?;
            crossed.push(portal.to);
            sequence.push(portal);
        }
        ensure(crossed.last() == Some(&b), "the sequence does not end in the pair's cell")?;
        fields.end().map(|()| sequence)
    }
}
