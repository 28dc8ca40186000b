//! The twin of visibility among convex cells of the plane: every line there is, up to moving it.
//!
//! What a line meets changes only where it passes a vertex: a corner of a cell or an end of a
//! portal. All lines between are of finitely many kinds, and each kind has lines as close as one
//! likes to some line through two vertices. So all lines through two vertices are taken, each moved
//! a little in every way that tells the vertices on it apart (to one side of all, or turned between
//! two neighbours, either way), by rationals small enough not to pass any other vertex. Along such
//! a line, two cells that it meets see each other iff it crosses portals all the way between them.
//!
//! Nothing is asked about sequences, and no half-spaces are cut.
//!
//! Complexity: O(n³) for the lines of n vertices with up to n moves, times n signs for each.

use crate::num::{Int, Rational, Sign};
use num_integer::Integer;
use num_traits::{Signed, Zero};

/// A point of the plane.
type Point = [Rational; 2];

/// A segment between two cells.
#[derive(Clone, Debug)]
pub struct Door {
    /// The two cells.
    pub cells: [usize; 2],
    /// Its ends.
    pub ends: [Point; 2],
}

/// The cells of a plan, as convex polygons counter-clockwise, and the segments between them.
#[derive(Clone, Debug)]
pub struct Flat {
    /// The corners of each cell.
    pub cells: Vec<Vec<Point>>,
    /// What lines may cross.
    pub doors: Vec<Door>,
}

/// Whether each ordered pair of cells sees each other, row by row.
pub fn flat_pairs(flat: &Flat) -> Vec<Vec<bool>> {
    let n = flat.cells.len();
    let mut seen: Vec<Vec<bool>> = (0..n).map(|i| (0..n).map(|j| i == j).collect()).collect();
    let grid = Grid::of(flat, &[]);
    grid.each_line(|line| {
        for chain in grid.chains(line) {
            for &i in &chain {
                chain.iter().for_each(|&j| seen[i][j] = true);
            }
        }
    });
    seen
}

/// Whether each cell sees a convex polygon: some segment from inside the cell to inside the
/// polygon crosses nothing but doors.
pub fn flat_seers(flat: &Flat, polygon: &[Point]) -> Vec<bool> {
    let mut seers = vec![false; flat.cells.len()];
    let grid = Grid::of(flat, polygon);
    grid.each_line(|line| {
        let Some(inside) = grid.interval(line, &grid.polygon) else { return };
        for chain in grid.chains(line) {
            let meets = |&cell: &usize| {
                let cell = grid.interval(line, &grid.cells[cell]).expect("a cell on the line");
                cell[0] < inside[1] && inside[0] < cell[1]
            };
            if chain.iter().any(meets) {
                chain.iter().for_each(|&cell| seers[cell] = true);
            }
        }
    });
    seers
}

/// Everything with integer coordinates, by number.
struct Grid {
    vertices: Vec<[Int; 2]>,
    cells: Vec<Vec<usize>>,
    polygon: Vec<usize>,
    doors: Vec<([usize; 2], [usize; 2])>,
}

/// a·x + b·y + c, none of whose zeros is a vertex, and its values at the vertices.
struct Line {
    normal: [Int; 2],
    values: Vec<Int>,
}

impl Grid {
    fn of(flat: &Flat, polygon: &[Point]) -> Grid {
        let mut points: Vec<Point> = Vec::new();
        let mut number = |point: &Point| match points.iter().position(|other| other == point) {
            Some(number) => number,
            None => {
                points.push(point.clone());
                points.len() - 1
            }
        };
        let cells = flat.cells.iter().map(|cell| cell.iter().map(&mut number).collect()).collect();
        let doors = flat.doors.iter();
        let doors = doors.map(|d| (d.cells, d.ends.each_ref().map(&mut number))).collect();
        // Where the polygon's edges meet those of cells, what a line has of it inside may end.
        for [p, q] in sides(polygon) {
            for [r, s] in flat.cells.iter().flat_map(|cell| sides(cell)) {
                meet(p, q, r, s).iter().for_each(|point| {
                    number(point);
                });
            }
        }
        let polygon = polygon.iter().map(&mut number).collect();
        let common = points.iter().flatten().fold(Int::from(1), |all, c| all.lcm(c.denom()));
        let whole = |c: &Rational| c.numer() * (&common / c.denom());
        let vertices = points.iter().map(|point| point.each_ref().map(whole)).collect();
        Grid { vertices, cells, polygon, doors }
    }

    /// Calls `see` with a line of every kind.
    fn each_line(&self, mut see: impl FnMut(&Line)) {
        for (i, p) in self.vertices.iter().enumerate() {
            for (j, q) in self.vertices.iter().enumerate().skip(i + 1) {
                let along = [&q[0] - &p[0], &q[1] - &p[1]];
                let normal = [-&along[1], along[0].clone()];
                let level = |n: &[Int; 2], v: &[Int; 2]| &n[0] * &v[0] + &n[1] * &v[1];
                let offset = level(&normal, p);
                let values: Vec<Int> =
                    self.vertices.iter().map(|v| level(&normal, v) - &offset).collect();
                let mut on: Vec<usize> =
                    (0..values.len()).filter(|&k| values[k].is_zero()).collect();
                if on[..2] != [i, j] {
                    // Another pair of vertices has this line as well.
                    continue;
                }
                on.sort_by_key(|&k| level(&along, &self.vertices[k]));
                // Moves by what is positive on all, and by what changes its sign between two.
                let mut moves = vec![([Int::zero(), Int::zero()], Int::from(1))];
                for pair in on.windows(2) {
                    let middle: Int = pair.iter().map(|&k| level(&along, &self.vertices[k])).sum();
                    moves.push((along.each_ref().map(|c| c * 2), -middle));
                }
                for (slope, shift) in moves {
                    let by: Vec<Int> =
                        self.vertices.iter().map(|v| level(&slope, v) + &shift).collect();
                    let most = by.iter().map(|b| b.abs()).max().unwrap_or_default() + 1;
                    for sign in [1, -1] {
                        let moved = |value: &Int, by: &Int| value * &most + by * sign;
                        see(&Line {
                            normal: [0, 1].map(|k| moved(&normal[k], &slope[k])),
                            values: values.iter().zip(&by).map(|(v, b)| moved(v, b)).collect(),
                        });
                    }
                }
            }
        }
    }

    /// The cells on a line, in sets that portals join along it.
    fn chains(&self, line: &Line) -> Vec<Vec<usize>> {
        let mut chains: Vec<Vec<usize>> = (0..self.cells.len())
            .filter(|&cell| line.divides(&self.cells[cell]))
            .map(|cell| vec![cell])
            .collect();
        for (cells, ends) in &self.doors {
            if !line.divides(ends) {
                continue;
            }
            let [one, other] =
                cells.map(|cell| chains.iter().position(|chain| chain.contains(&cell)));
            let (Some(one), Some(other)) = (one, other) else {
                unreachable!("a line through a door meets both cells");
            };
            if one != other {
                let moved = chains[other].clone();
                chains[one].extend(moved);
                chains.swap_remove(other);
            }
        }
        chains
    }

    /// Where along the line a convex polygon begins and ends, if it is met.
    fn interval(&self, line: &Line, polygon: &[usize]) -> Option<[Rational; 2]> {
        let n = polygon.len();
        let mut found: Vec<Rational> = Vec::new();
        for (i, j) in (0..n).map(|k| (polygon[k], polygon[(k + 1) % n])) {
            if line.divides(&[i, j]) {
                let along = |v: &[Int; 2]| &v[0] * &line.normal[1] - &v[1] * &line.normal[0];
                let [u, v] = [i, j].map(|k| line.values[k].abs());
                let place = along(&self.vertices[i]) * &v + along(&self.vertices[j]) * &u;
                found.push(Rational::new(place, u + v));
            }
        }
        found.sort();
        <[Rational; 2]>::try_from(found).ok()
    }
}

impl Line {
    fn divides(&self, vertices: &[usize]) -> bool {
        let is_left = |&vertex: &usize| Sign::of(&self.values[vertex]) == Sign::Positive;
        vertices.iter().any(is_left) && !vertices.iter().all(is_left)
    }
}

fn sides(polygon: &[Point]) -> impl Iterator<Item = [&Point; 2]> {
    (0..polygon.len()).map(|i| [&polygon[i], &polygon[(i + 1) % polygon.len()]])
}

/// The point where the lines pq and rs meet, if they are not parallel.
fn meet(p: &Point, q: &Point, r: &Point, s: &Point) -> Option<Point> {
    let minus = |a: &Point, b: &Point| [&a[0] - &b[0], &a[1] - &b[1]];
    let cross = |a: &Point, b: &Point| &a[0] * &b[1] - &a[1] * &b[0];
    let (along, other) = (minus(q, p), minus(s, r));
    let scale = cross(&along, &other);
    if scale.is_zero() {
        return None;
    }
    let part = cross(&minus(r, p), &other) / scale;
    Some([0, 1].map(|k| &p[k] + &along[k] * &part))
}
