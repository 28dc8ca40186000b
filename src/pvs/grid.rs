//! The exact stage behind the search's filters: the graph's vertices on its grid.

use crate::geom::{BigPlane, BigPoint3, Point3};
use crate::num::{Int, Rational, Sign};
use crate::predicates::filtered::Approx3;
use crate::predicates::{Budget, gordan, orient3d_big, orient3d_exact};
use crate::scene::PortalGraph;
use num_traits::ToPrimitive;

/// The vertices in grid units: small where all of them fit, unbounded otherwise.
enum Vertices {
    Small(Vec<Point3>, Budget),
    Big(Vec<BigPoint3>),
}

/// The vertices of a graph, for exact answers about them by index.
pub(crate) struct Grid {
    vertices: Vertices,
    /// Grid units in one world unit.
    denominator: Int,
}

impl Grid {
    pub fn new(graph: &PortalGraph) -> Grid {
        let small: Option<Vec<Point3>> = graph.vertices.iter().map(BigPoint3::to_small).collect();
        let vertices = match small {
            Some(points) => {
                let budget = Budget::of_points(&points).without_filters();
                Vertices::Small(points, budget)
            }
            None => Vertices::Big(graph.vertices.clone()),
        };
        Grid { vertices, denominator: graph.denominator.clone() }
    }

    /// The side of the plane through the first three on which the fourth lies.
    pub fn orient(&self, [a, b, c, d]: [u32; 4]) -> Sign {
        match &self.vertices {
            Vertices::Small(points, budget) => {
                let [a, b, c, d] = [a, b, c, d].map(|v| &points[v as usize]);
                orient3d_exact(a, b, c, d, budget)
            }
            Vertices::Big(points) => {
                let [a, b, c, d] = [a, b, c, d].map(|v| &points[v as usize]);
                orient3d_big(a, b, c, d)
            }
        }
    }

    /// The vertex in grid units.
    pub fn point(&self, vertex: u32) -> BigPoint3 {
        match &self.vertices {
            Vertices::Small(points, _) => points[vertex as usize].into(),
            Vertices::Big(points) => points[vertex as usize].clone(),
        }
    }

    /// Whether a positive combination of the edges' Plücker vectors vanishes, so that no line is
    /// on the positive side of them all; see [`gordan::exclude_each_other`].
    pub fn exclude_each_other(&self, edges: &[[u32; 2]]) -> bool {
        let big = || {
            let ends = |edge: &[u32; 2]| edge.map(|v| self.point(v).coordinates);
            edges.iter().map(ends).collect::<Vec<_>>()
        };
        match &self.vertices {
            Vertices::Small(points, _) => {
                let small: Vec<[Point3; 2]> =
                    edges.iter().map(|edge| edge.map(|v| points[v as usize])).collect();
                gordan::exclude_each_other(&small, big)
            }
            Vertices::Big(_) => gordan::exclude_each_other_exact(&big()),
        }
    }

    /// The plane through three vertices in units of `1 / scale` of the grid's.
    pub fn plane(&self, through: [u32; 3], scale: &Int) -> BigPlane {
        let [a, b, c] = through.map(|v| {
            let coordinates = self.point(v).coordinates.map(|c| c * scale);
            BigPoint3 { coordinates }
        });
        BigPlane::through(&a, &b, &c)
    }

    pub fn denominator(&self) -> &Int {
        &self.denominator
    }

    /// The world coordinates of a vertex, rounded to the nearest floats.
    pub fn approximate(&self, vertex: u32) -> Approx3 {
        let coordinates = self.point(vertex).coordinates;
        let small = |value: &Int| value.to_i64().filter(|v| v.unsigned_abs() <= 1 << 53);
        let nearest = |c: &Int| match (small(c), small(&self.denominator)) {
            // Both are floats exactly, and a division of floats rounds to the nearest.
            (Some(c), Some(d)) => c as f64 / d as f64,
            _ => {
                let ratio = Rational::new(c.clone(), self.denominator.clone());
                ratio.to_f64().unwrap_or(f64::NAN)
            }
        };
        let whole = coordinates.iter().all(|c| (c % &self.denominator) == Int::ZERO);
        let fits = coordinates.iter().all(|c| small(&(c / &self.denominator)).is_some());
        let floats = [0, 1, 2].map(|i| nearest(&coordinates[i]));
        if whole && fits { Approx3::exact(floats) } else { Approx3::rounded(floats) }
    }
}
