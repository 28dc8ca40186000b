//! The portal graph as the search reads it: directed portals in flat arrays, world coordinates in
//! floats for the filters, grid coordinates for the exact stage.
//!
//! The planar portal `p` of the graph becomes two *directed portals*: `2p` crosses it from its
//! cell `from` to its cell `to`, `2p + 1` the other way. A directed portal's vertices are
//! counter-clockwise as seen from the cell that it enters.

use super::bits::Bits;
use crate::geom::BigPoint3;
use crate::num::{Int, Rational, Sign};
use crate::predicates::filtered::{Approx3, Bound, FilteredLine, FilteredPlane};
use crate::scene::PortalGraph;
use num_integer::Integer;
use num_traits::ToPrimitive;

/// A portal with a direction of crossing.
pub(crate) type Directed = u32;

/// The same portal, crossed the other way.
pub(crate) fn reverse(portal: Directed) -> Directed {
    portal ^ 1
}

/// A plane through three vertices of the graph.
#[derive(Clone, Copy)]
pub(crate) struct Plane {
    filter: FilteredPlane,
    through: [u32; 3],
}

/// What tells planes apart: equal keys are the same plane, with the same front.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum PlaneKey {
    /// Normal and offset in lowest terms, where the floats hold them exactly.
    Reduced([i64; 4]),
    /// The vertices that the plane goes through.
    Through([u32; 3]),
}

impl Plane {
    /// The plane's key; the same plane through other vertices may have another key.
    pub fn key(&self) -> PlaneKey {
        match self.filter.integers() {
            Some(coefficients) => {
                let divisor = coefficients.iter().fold(0i64, |g, c| g.gcd(c)).max(1);
                PlaneKey::Reduced(coefficients.map(|c| c / divisor))
            }
            None => PlaneKey::Through(self.through),
        }
    }

    /// Whether the floats found the three vertices collinear; a hint, not a verdict.
    pub fn is_null(&self) -> bool {
        self.filter.normal() == [0.0; 3]
    }

    /// How far in front of the plane a point is, in floats and unscaled: a hint, not a verdict.
    pub fn hint(&self) -> ([f64; 3], f64) {
        (self.filter.normal(), self.filter.offset())
    }

    /// The three vertices that span the plane.
    pub fn through(&self) -> [u32; 3] {
        self.through
    }
}

struct Span {
    first: u32,
    end: u32,
    from: u32,
    to: u32,
    center: [f64; 3],
    radius: f64,
}

/// The search's view of a portal graph.
pub(crate) struct Arena {
    points: Vec<Approx3>,
    grid: Grid,
    bound: Bound,
    spans: Vec<Span>,
    ids: Vec<u32>,
    /// The edge from each vertex of `ids` to the next of its polygon.
    edges: Vec<FilteredLine>,
    planes: Vec<Plane>,
    leaving: Vec<Directed>,
    leaving_of: Vec<u32>,
    cells: u32,
}

impl Arena {
    pub fn new(graph: &PortalGraph) -> Arena {
        let points: Vec<Approx3> =
            graph.vertices.iter().map(|v| approximate(v, &graph.denominator)).collect();
        let bound = Bound::of(&points);
        let mut arena = Arena {
            points,
            grid: Grid::new(&graph.vertices),
            bound,
            spans: Vec::new(),
            ids: Vec::new(),
            edges: Vec::new(),
            planes: Vec::new(),
            leaving: Vec::new(),
            leaving_of: Vec::new(),
            cells: graph.cells.len() as u32,
        };
        for portal in &graph.portals {
            arena.add(portal.vertices.iter().copied(), portal.from.0, portal.to.0);
            arena.add(portal.vertices.iter().rev().copied(), portal.to.0, portal.from.0);
        }
        arena.index_cells();
        arena
    }

    fn add(&mut self, vertices: impl Iterator<Item = u32>, from: u32, to: u32) {
        let first = self.ids.len();
        self.ids.extend(vertices);
        let ids = &self.ids[first..];
        let mut center = [0.0; 3];
        for &v in ids {
            for (sum, c) in center.iter_mut().zip(self.points[v as usize].floats()) {
                *sum += c / ids.len() as f64;
            }
        }
        let radius = ids
            .iter()
            .map(|&v| glam::DVec3::from(self.points[v as usize].floats()).distance(center.into()))
            .fold(0.0, f64::max);
        let edges: Vec<FilteredLine> = (0..ids.len())
            .map(|i| {
                let [a, b] = [i, (i + 1) % ids.len()].map(|i| &self.points[ids[i] as usize]);
                FilteredLine::through(a, b, self.bound)
            })
            .collect();
        let plane = self.supporting_plane(ids);
        self.edges.extend(edges);
        self.planes.push(plane);
        self.spans.push(Span {
            first: first as u32,
            end: self.ids.len() as u32,
            from,
            to,
            center,
            radius,
        });
    }

    /// The plane through three vertices of a convex polygon that are not collinear: the widest of
    /// the corners at consecutive vertices, so that the filter decides most.
    fn supporting_plane(&self, ids: &[u32]) -> Plane {
        let n = ids.len();
        let corner = |i: usize| [ids[i], ids[(i + 1) % n], ids[(i + 2) % n]];
        let area = |c: &[u32; 3]| {
            let [a, b, c] = c.map(|v| glam::DVec3::from_array(self.points[v as usize].floats()));
            (b - a).cross(c - a).length_squared()
        };
        let widest = (0..n).map(corner).max_by(|a, b| area(a).total_cmp(&area(b)));
        self.plane(widest.expect("a portal has three vertices or more"))
    }

    fn index_cells(&mut self) {
        let mut order: Vec<Directed> = (0..self.spans.len() as u32).collect();
        order.sort_by_key(|&d| (self.from(d), d));
        self.leaving_of = vec![0; self.cells as usize + 1];
        for &d in &order {
            let from = self.from(d) as usize;
            self.leaving_of[from + 1] += 1;
        }
        for i in 0..self.cells as usize {
            self.leaving_of[i + 1] += self.leaving_of[i];
        }
        self.leaving = order;
    }

    pub fn cells(&self) -> u32 {
        self.cells
    }

    /// The number of directed portals.
    pub fn directed(&self) -> u32 {
        self.spans.len() as u32
    }

    pub fn from(&self, portal: Directed) -> u32 {
        self.spans[portal as usize].from
    }

    pub fn to(&self, portal: Directed) -> u32 {
        self.spans[portal as usize].to
    }

    /// The directed portals that leave `cell`, in ascending order.
    pub fn leaving(&self, cell: u32) -> &[Directed] {
        let [first, end] = [cell, cell + 1].map(|i| self.leaving_of[i as usize] as usize);
        &self.leaving[first..end]
    }

    pub fn vertices(&self, portal: Directed) -> &[u32] {
        let span = &self.spans[portal as usize];
        &self.ids[span.first as usize..span.end as usize]
    }

    /// The edges of `portal`, the first from its first vertex.
    pub fn edges(&self, portal: Directed) -> &[FilteredLine] {
        let span = &self.spans[portal as usize];
        &self.edges[span.first as usize..span.end as usize]
    }

    pub fn point(&self, vertex: u32) -> &Approx3 {
        &self.points[vertex as usize]
    }

    pub fn center(&self, portal: Directed) -> [f64; 3] {
        self.spans[portal as usize].center
    }

    pub fn radius(&self, portal: Directed) -> f64 {
        self.spans[portal as usize].radius
    }

    pub fn bound(&self) -> Bound {
        self.bound
    }

    pub fn plane_of(&self, portal: Directed) -> &Plane {
        &self.planes[portal as usize]
    }

    /// The plane through three vertices; the positive side sees them counter-clockwise.
    pub fn plane(&self, through: [u32; 3]) -> Plane {
        let [a, b, c] = through.map(|v| &self.points[v as usize]);
        Plane { filter: FilteredPlane::through(a, b, c, self.bound), through }
    }

    /// The side of `plane` on which `vertex` lies.
    #[inline]
    pub fn side(&self, plane: &Plane, vertex: u32) -> Sign {
        match plane.filter.side(&self.points[vertex as usize]) {
            Some(sign) => sign,
            None => self.side_exact(plane, vertex),
        }
    }

    #[cold]
    fn side_exact(&self, plane: &Plane, vertex: u32) -> Sign {
        let [a, b, c] = plane.through;
        self.grid.orient(a, b, c, vertex)
    }

    /// Whether no vertex of `portal` is in front of `plane`.
    #[inline]
    pub fn wholly_behind(&self, plane: &Plane, portal: Directed) -> bool {
        // A centre in front is reason enough to keep a portal; only to drop one takes proof.
        let (normal, offset) = plane.hint();
        let center = self.center(portal);
        if normal[0] * center[0] + normal[1] * center[1] + normal[2] * center[2] > offset {
            return false;
        }
        self.wholly_behind_exact(plane, portal)
    }

    pub fn wholly_behind_exact(&self, plane: &Plane, portal: Directed) -> bool {
        self.vertices(portal).iter().all(|&v| match self.side(plane, v) {
            Sign::Positive => false,
            // A portal that only touches the plane from behind has its interior behind it.
            Sign::Zero | Sign::Negative => true,
        })
    }

    /// Whether some vertex of `portal` is in front of `plane`.
    pub fn reaches_front(&self, plane: &Plane, portal: Directed) -> bool {
        !self.wholly_behind(plane, portal)
    }

    /// An empty set of directed portals.
    pub fn no_portals(&self) -> Bits {
        Bits::new(self.spans.len())
    }

    /// An empty set of cells.
    pub fn no_cells(&self) -> Bits {
        Bits::new(self.cells as usize)
    }
}
impl Arena {
    pub fn grid_point(&self, v: u32) -> [crate::num::Int; 3] {
        match &self.grid {
            Grid::Small(p) => p[v as usize].map(Into::into),
            Grid::Big(p) => p[v as usize].clone(),
        }
    }
}

/// The world coordinates of a grid point, rounded to the nearest floats.
fn approximate(point: &BigPoint3, denominator: &Int) -> Approx3 {
    let nearest = |c: &Int| -> f64 {
        let small = |value: &Int| value.to_i64().filter(|v| v.unsigned_abs() <= 1 << 53);
        match (small(c), small(denominator)) {
            // Both are exact floats, and a float division rounds to nearest.
            (Some(c), Some(d)) => c as f64 / d as f64,
            _ => Rational::new(c.clone(), denominator.clone()).to_f64().unwrap_or(f64::NAN),
        }
    };
    let floats = [0, 1, 2].map(|i| nearest(&point.coordinates[i]));
    let whole = point.coordinates.iter().all(|c| (c % denominator) == Int::ZERO);
    let fits = floats.iter().all(|c| c.abs() <= 9_007_199_254_740_992.0);
    if whole && fits { Approx3::exact(floats) } else { Approx3::rounded(floats) }
}

/// temp
pub enum Grid {
    /// small
    Small(Vec<[i64; 3]>),
    /// big
    Big(Vec<[Int; 3]>),
}
impl Grid {
    /// temp
    pub fn new(v: &[BigPoint3]) -> Grid {
        let small: Option<Vec<[i64; 3]>> = v
            .iter()
            .map(|p| {
                let c: Vec<i64> = p
                    .coordinates
                    .iter()
                    .filter_map(|c| c.to_i64().filter(|c| c.abs() < 1 << 38))
                    .collect();
                <[i64; 3]>::try_from(c).ok()
            })
            .collect();
        match small {
            Some(s) => Grid::Small(s),
            None => Grid::Big(v.iter().map(|p| p.coordinates.clone()).collect()),
        }
    }
    fn orient(&self, a: u32, b: u32, c: u32, d: u32) -> Sign {
        match self {
            Grid::Small(p) => {
                let a = p[a as usize];
                let f = |v: u32| {
                    let v = p[v as usize];
                    [0, 1, 2].map(|i| (v[i] - a[i]) as i128)
                };
                let (x, y, z) = (f(b), f(c), f(d));
                Sign::of(
                    &((x[1] * y[2] - x[2] * y[1]) * z[0]
                        + (x[2] * y[0] - x[0] * y[2]) * z[1]
                        + (x[0] * y[1] - x[1] * y[0]) * z[2]),
                )
            }
            Grid::Big(p) => {
                let a = &p[a as usize];
                let f = |v: u32| {
                    let v = &p[v as usize];
                    [0, 1, 2].map(|i| &v[i] - &a[i])
                };
                let (x, y, z) = (f(b), f(c), f(d));
                Sign::of(
                    &((&x[1] * &y[2] - &x[2] * &y[1]) * &z[0]
                        + (&x[2] * &y[0] - &x[0] * &y[2]) * &z[1]
                        + (&x[0] * &y[1] - &x[1] * &y[0]) * &z[2]),
                )
            }
        }
    }
}

impl Arena {
    /// Whether no line is strictly on the positive side of all edges, each from a vertex to
    /// another.
    pub fn excluded(&self, edges: &[[u32; 2]]) -> bool {
        match &self.grid {
            Grid::Small(points) => {
                let lines: Vec<[[f64; 3]; 2]> =
                    edges.iter().map(|e| e.map(|v| points[v as usize].map(|c| c as f64))).collect();
                crate::predicates::gordan::exclude_each_other(&lines, || {
                    edges.iter().map(|e| e.map(|v| self.grid_point(v))).collect()
                })
            }
            Grid::Big(_) => crate::predicates::gordan::exclude_each_other_exact(
                &edges.iter().map(|e| e.map(|v| self.grid_point(v))).collect::<Vec<_>>(),
            ),
        }
    }
}

impl Arena {
    pub fn exact_portals(&self, path: &[Directed]) -> Vec<crate::stab::Portal3> {
        let polys: Vec<Vec<[Int; 3]>> = path
            .iter()
            .map(|&p| self.vertices(p).iter().map(|&v| self.grid_point(v)).collect())
            .collect();
        let g = polys.iter().flatten().flatten().fold(Int::ZERO, |g, c| g.gcd(c));
        polys
            .into_iter()
            .map(|p| {
                crate::stab::Portal3::new(
                    &p.into_iter()
                        .map(|c| BigPoint3 { coordinates: c.map(|c| c / &g) })
                        .collect::<Vec<_>>(),
                )
                .unwrap()
            })
            .collect()
    }
}
