//! The exact stage behind the search's filters: the graph's vertices without rounding.
//!
//! Where all vertices have a common grid on which they are small, as those of files have, every
//! question is asked there. Vertices that are meets of planes have denominators that have nothing
//! to do with each other, and a common one would be as long as the map; so there each question is
//! asked on the grid of the few vertices that it is about, or of world units where they are whole.
//! Every predicate here is unchanged by scaling all that takes part, which is why the grids need
//! not be the same.

use crate::geom::{BigPlane, BigPoint3, Point3, RationalPoint3};
use crate::num::{Int, Rational, Sign};
use crate::predicates::filtered::Approx3;
use crate::predicates::{
    Budget, compare_crossings_big, gordan, orient3d_big, orient3d_exact, orient3d_rational,
};
use crate::scene::PortalGraph;
use num_traits::ToPrimitive;

/// The vertices of a graph, for exact answers about them by index.
pub(crate) struct Grid {
    /// In world units.
    vertices: Vec<RationalPoint3>,
    /// Grid units in one world unit: of the common grid, or else 1.
    denominator: Int,
    /// Where the vertices are on that grid; `None` for those that are not on it, or not small
    /// there. All are where there is a common grid.
    points: Vec<Option<Point3>>,
    /// Of `points`.
    budget: Budget,
}

impl Grid {
    pub fn new(graph: &PortalGraph) -> Grid {
        let (denominator, points) = match graph.small_grid() {
            Some(grid) => (grid.denominator, grid.points.into_iter().map(Some).collect()),
            None => (Int::from(1), graph.vertices.iter().map(small_world_point).collect()),
        };
        let points: Vec<Option<Point3>> = points;
        let budget = Budget::of_points(points.iter().flatten()).without_filters();
        Grid { vertices: graph.vertices.clone(), denominator, points, budget }
    }

    /// Whether all vertices are on the grid.
    pub fn is_common(&self) -> bool {
        self.points.iter().all(Option::is_some)
    }

    /// Grid units in one world unit.
    pub fn denominator(&self) -> &Int {
        &self.denominator
    }

    pub fn vertex(&self, vertex: u32) -> &RationalPoint3 {
        &self.vertices[vertex as usize]
    }

    /// The side of the plane through the first three on which the fourth lies.
    pub fn orient(&self, vertices: [u32; 4]) -> Sign {
        if let [Some(a), Some(b), Some(c), Some(d)] = vertices.map(|v| &self.points[v as usize]) {
            return orient3d_exact(a, b, c, d, &self.budget);
        }
        let [a, b, c, d] = vertices.map(|v| self.vertex(v));
        orient3d_rational(a, b, c, d)
    }

    /// The lowest common denominator of some vertices: of all, where there is a common grid.
    pub fn denominator_of(&self, vertices: impl Iterator<Item = u32> + Clone) -> Int {
        match vertices.clone().all(|v| self.points[v as usize].is_some()) {
            true => self.denominator.clone(),
            false => RationalPoint3::common_denominator(vertices.map(|v| self.vertex(v))),
        }
    }

    /// The side of the line through two points, of world coordinates `points` · 2^-bits, on which
    /// an edge passes.
    pub fn side_of_edge(&self, points: [[i64; 3]; 2], bits: u32, edge: [u32; 2]) -> Sign {
        if let Some([p, q, u, v]) = self.small_fine(points, bits, edge) {
            return orient3d_exact(&p, &q, &u, &v, &Budget::FULL);
        }
        let denominator = self.denominator_of(edge.into_iter());
        let [p, q] = points.map(|point| fine_point(point, &denominator));
        let scale = Int::from(1u64 << bits);
        let [u, v] = edge.map(|vertex| self.scaled_point(vertex, &denominator, &scale));
        orient3d_big(&p, &q, &u, &v)
    }

    /// Points and an edge's ends in units of 2^-bits of the grid's, if all are small.
    fn small_fine(&self, points: [[i64; 3]; 2], bits: u32, edge: [u32; 2]) -> Option<[Point3; 4]> {
        let denominator = self.denominator.to_i64()?;
        let scaled = |[x, y, z]: [i64; 3], scale: i64| {
            let times = |c: i64| c.checked_mul(scale);
            Point3::new(times(x)?, times(y)?, times(z)?)
        };
        let vertex = |v: Point3| scaled(v.integers(), 1i64.checked_shl(bits)?);
        let [p, q] = points.map(|point| scaled(point, denominator));
        let [u, v] = edge.map(|v| self.points[v as usize].and_then(vertex));
        Some([p?, q?, u?, v?])
    }

    /// The order in which the line through two points, of world coordinates `points` · 2^-bits,
    /// crosses two planes, each through three vertices; see [`compare_crossings_big`].
    pub fn compare_crossings(
        &self,
        points: [[i64; 3]; 2],
        bits: u32,
        planes: [[u32; 3]; 2],
    ) -> Option<Sign> {
        let denominator = self.denominator_of(planes.into_iter().flatten());
        let scale = Int::from(1u64 << bits);
        let [first, second] = planes.map(|through| {
            let [a, b, c] = through.map(|v| self.scaled_point(v, &denominator, &scale));
            BigPlane::through(&a, &b, &c)
        });
        let [p, q] = points.map(|point| fine_point(point, &denominator));
        compare_crossings_big(&p, &q, &first, &second)
    }

    /// A vertex in units of `1 / (denominator · scale)`.
    fn scaled_point(&self, vertex: u32, denominator: &Int, scale: &Int) -> BigPoint3 {
        let coordinates = self.vertex(vertex).on_grid(denominator).coordinates.map(|c| c * scale);
        BigPoint3 { coordinates }
    }

    /// Whether a positive combination of the edges' Plücker vectors vanishes, so that no line is
    /// on the positive side of them all; see [`gordan::exclude_each_other`].
    pub fn exclude_each_other(&self, edges: &[[u32; 2]]) -> bool {
        let small = |&[u, v]: &[u32; 2]| Some([self.points[u as usize]?, self.points[v as usize]?]);
        match edges.iter().map(small).collect::<Option<Vec<[Point3; 2]>>>() {
            Some(lines) => gordan::exclude_each_other(&lines),
            None => gordan::exclude_each_other_rational(
                edges.iter().map(|edge| edge.map(|v| self.vertex(v))),
            ),
        }
    }

    /// The world coordinates of a vertex, rounded to the nearest floats.
    pub fn approximate(vertex: &RationalPoint3) -> Approx3 {
        let denominator = vertex.denominator();
        let small = |value: &Int| value.to_i64().filter(|v| v.unsigned_abs() <= 1 << 53);
        let nearest = |c: &Int| match (small(c), small(denominator)) {
            // Both are floats exactly, and a division of floats rounds to the nearest.
            (Some(c), Some(d)) => c as f64 / d as f64,
            _ => Rational::new(c.clone(), denominator.clone()).to_f64().unwrap_or(f64::NAN),
        };
        let floats = vertex.numerators().each_ref().map(nearest);
        match small_world_point(vertex) {
            Some(_) => Approx3::exact(floats),
            None => Approx3::rounded(floats),
        }
    }
}

/// The vertex in world units, if its coordinates are whole and small there.
fn small_world_point(vertex: &RationalPoint3) -> Option<Point3> {
    let one = Int::from(1);
    if *vertex.denominator() == one { vertex.on_grid(&one).to_small() } else { None }
}

/// A point of world coordinates `point` · 2^-bits, in units of 2^-bits of a grid's.
fn fine_point(point: [i64; 3], denominator: &Int) -> BigPoint3 {
    BigPoint3 { coordinates: point.map(|c| denominator * c) }
}
