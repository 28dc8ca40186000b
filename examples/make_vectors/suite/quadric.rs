//! Sequences that no weighted sum of sides refutes, found by a search: the half-spaces of their
//! edges leave room, and only the Klein form, by products of two sides, leaves none. So no
//! hyperplane of Plücker space shows that no line passes.
//!
//! What is found is made small: coordinates go towards zero as long as the sequence stays what it
//! is. Its neighbours one unit away are those that differ in one coordinate of one vertex.

use super::book::of_portals;
use super::family::{Family, Seq};
use super::number::{Polygon, q};
use stabline::num::Random;
use stabline::vectors::Class::{self, Blocked, Grazing, Open};

type Vector = [i64; 3];
type Portals = Vec<Vec<Vector>>;

/// What is looked for.
struct Search {
    seed: u64,
    /// How many cases.
    cases: usize,
    /// How many portals each has.
    portals: usize,
    /// Whether they are parallelograms, else triangles.
    quads: bool,
    /// Whether each portal is in front of those before it, in planes two units apart; else they
    /// are anywhere in one small cube.
    is_row: bool,
    class: Class,
    /// How the refutation begins: `i`, one identity, or `s`, a split.
    refutation: char,
}

/// Three blocked triangles in a row; the other searches differ from it.
const TRIANGLES: Search = Search {
    seed: 1,
    cases: 16,
    portals: 3,
    quads: false,
    is_row: true,
    class: Blocked,
    refutation: 'i',
};

/// Rows of portals, which convex cells can have.
pub fn rows() -> Family {
    let row = TRIANGLES;
    let mut cases = row.run();
    cases.extend(Search { seed: 2, cases: 4, portals: 4, ..row }.run());
    cases.extend(Search { seed: 3, cases: 4, quads: true, ..row }.run());
    cases.extend(Search { seed: 4, cases: 4, class: Grazing, ..row }.run());
    Family::row("Rows of portals that only products of sides refute.", cases)
}

/// Portals anywhere.
pub fn loose() -> Family {
    let loose = Search { seed: 5, cases: 12, is_row: false, ..TRIANGLES };
    let mut cases = loose.run();
    cases.extend(Search { seed: 6, cases: 4, portals: 4, ..loose }.run());
    cases.extend(Search { seed: 7, cases: 4, quads: true, ..loose }.run());
    cases.extend(Search { seed: 8, cases: 6, refutation: 's', ..loose }.run());
    Family::loose("Portals in a small cube that only products of sides refute.", cases)
}

impl Search {
    fn run(&self) -> Vec<Seq> {
        let mut random = Random::new(self.seed);
        let mut cases = Vec::new();
        let mut found = 0;
        while found < self.cases {
            let portals = self.random_portals(&mut random);
            if !self.is_found(&portals) {
                continue;
            }
            let portals = self.smaller(portals);
            let neighbours = self.neighbours(&portals);
            // Without a neighbour that lines pass, the case is no near miss.
            if neighbours.iter().any(|case| case.class == Open) {
                found += 1;
                cases.push(self.case(&portals));
                cases.extend(neighbours);
            }
        }
        cases
    }

    fn random_portals(&self, random: &mut Random) -> Portals {
        let mut place = |base: i64, reach: i64| {
            let flat = |random: &mut Random| random.between(-reach, reach);
            match self.is_row {
                true => [flat(random), flat(random), base + random.between(0, 1)],
                false => [flat(random), flat(random), flat(random)],
            }
        };
        let portal = |index: usize| {
            let base = 2 * index as i64;
            let [a, b, c] = [(); 3].map(|()| place(base, 2));
            let mut portal = vec![a, b, c];
            if self.quads {
                portal.push([0, 1, 2].map(|i| a[i] + c[i] - b[i]));
            }
            // Upwards, which is forward for a row.
            if normal(&portal)[2] < 0 {
                portal.reverse();
            }
            portal
        };
        (0..self.portals).map(portal).collect()
    }

    fn is_valid(&self, portals: &Portals) -> bool {
        portals.iter().all(|portal| normal(portal) != [0; 3])
            && (!self.is_row || stands_in_row(portals))
    }

    fn is_found(&self, portals: &Portals) -> bool {
        if !self.is_valid(portals) {
            return false;
        }
        let test = of_portals(&polygons(portals));
        let refutation = test.certificate.as_ref().and_then(|why| why["refutation"].as_str());
        test.class == Some(self.class)
            && refutation.is_some_and(|text| text.starts_with(self.refutation))
    }

    /// Coordinates one after the other go towards zero, by all or by one.
    fn smaller(&self, mut portals: Portals) -> Portals {
        loop {
            let before = portals.clone();
            for (i, axis) in places(&before) {
                for step in [before[i.0][i.1][axis], before[i.0][i.1][axis].signum()] {
                    let tried = self.moved(&portals, i, axis, -step);
                    if step != 0 && sum(&tried) < sum(&portals) && self.is_found(&tried) {
                        portals = tried;
                    }
                }
            }
            if portals == before {
                return portals;
            }
        }
    }

    /// A vertex of a triangle moves alone; parallelograms move as a whole.
    fn moved(&self, portals: &Portals, (portal, vertex): At, axis: usize, by: i64) -> Portals {
        let mut portals = portals.clone();
        match self.quads {
            true => portals[portal].iter_mut().for_each(|vertex| vertex[axis] += by),
            false => portals[portal][vertex][axis] += by,
        }
        portals
    }

    /// One neighbour of each other class, the first of each.
    fn neighbours(&self, portals: &Portals) -> Vec<Seq> {
        let mut cases: Vec<Seq> = Vec::new();
        for (at, axis) in places(portals) {
            for by in [1, -1] {
                let moved = self.moved(portals, at, axis, by);
                if !self.is_valid(&moved) {
                    continue;
                }
                let polygons = polygons(&moved);
                let class = of_portals(&polygons).class.expect("a verdict");
                if class == self.class || cases.iter().any(|case| case.class == class) {
                    continue;
                }
                let what = match self.quads {
                    true => format!("portal {} is", at.0),
                    false => format!("vertex {} of portal {} is", at.1, at.0),
                };
                let how = match class {
                    Open => "lines pass",
                    Grazing => "a line only touches",
                    Blocked => "no line even touches",
                };
                let (axis, by) = (["x", "y", "z"][axis], format!("{by:+}"));
                let comment = format!(
                    "As a case that only products of sides refute, but {what} moved by {by} along \
                     {axis}: {how}."
                );
                cases.push(Seq::new(comment, &["Quadric", "OneUnit"], polygons, class));
            }
        }
        cases
    }

    fn case(&self, portals: &Portals) -> Seq {
        let shape = if self.quads { "parallelograms" } else { "triangles" };
        let how = match (self.refutation, self.class) {
            ('s', _) => "products of sides do, on either side of a hyperplane",
            (_, Grazing) => "products of sides do. But a line touches",
            (_, Open | Blocked) => "products of sides do, times weights",
        };
        let comment = format!(
            "{} small {shape}. No weighted sum of sides is zero, so nothing linear refutes them; \
             {how}.",
            ["Three", "Four"][self.portals - 3]
        );
        let flags = if self.class == Grazing { &["Quadric"][..] } else { &["Quadric", "OneUnit"] };
        Seq::new(comment, flags, polygons(portals), self.class)
    }
}

/// A portal and one of its vertices.
type At = (usize, usize);

/// Every coordinate.
fn places(portals: &Portals) -> Vec<(At, usize)> {
    let of = |(i, portal): (usize, &Vec<Vector>)| {
        (0..portal.len()).flat_map(move |j| (0..3).map(move |axis| ((i, j), axis)))
    };
    portals.iter().enumerate().flat_map(of).collect()
}

fn sum(portals: &Portals) -> i64 {
    portals.iter().flatten().flatten().map(|c| c.abs()).sum()
}

fn minus(a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|i| a[i] - b[i])
}

fn normal(portal: &[Vector]) -> Vector {
    let (u, v) = (minus(portal[1], portal[0]), minus(portal[2], portal[0]));
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| u[i] * v[j] - u[j] * v[i])
}

/// Whether each portal is in front of those before it, and they behind it.
fn stands_in_row(portals: &Portals) -> bool {
    let height = |of: &[Vector], point: Vector| -> i64 {
        let (n, p) = (normal(of), minus(point, of[0]));
        (0..3).map(|i| n[i] * p[i]).sum()
    };
    portals.windows(2).all(|pair| {
        pair[1].iter().all(|&p| height(&pair[0], p) > 0)
            && pair[0].iter().all(|&p| height(&pair[1], p) < 0)
    })
}

fn polygons(portals: &Portals) -> Vec<Polygon> {
    let polygon = |portal: &Vec<Vector>| portal.iter().map(|p| p.map(q).to_vec()).collect();
    portals.iter().map(polygon).collect()
}
