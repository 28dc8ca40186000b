//! The portal graph as the search reads it: directed portals in flat arrays, world coordinates in
//! floats for the filters, grid coordinates for the exact stage.
//!
//! The planar portal `p` of the graph becomes two *directed portals*: `2p` crosses it from its
//! cell `from` to its cell `to`, `2p + 1` the other way. A directed portal's vertices are
//! counter-clockwise as seen from the cell that it enters.

use super::bits::Bits;
use super::grid::Grid;
use super::propose::Outline;
use crate::geom::BigPoint3;
use crate::num::{Int, Sign};
use crate::predicates::filtered::{Approx3, Bound, FilteredLine, FilteredPlane};
use crate::scene::{CellOrder, ObjectGraph, PortalGraph, PortalId};
use crate::stab::Portal3;
use num_integer::Integer;
use rustc_hash::FxHashMap;
use std::borrow::Cow;
use std::sync::OnceLock;

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
    /// Normal and offset in lowest terms, where the filter holds them exactly.
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

    /// Three vertices that the plane goes through, counter-clockwise as seen from its front.
    pub fn through(&self) -> [u32; 3] {
        self.through
    }

    /// The filter, for what proposes.
    pub fn filter(&self) -> &FilteredPlane {
        &self.filter
    }
}

/// Where a directed portal's vertices are in `Arena::ids`, and what it joins.
struct Span {
    first: u32,
    end: u32,
    from: u32,
    to: u32,
}

/// A directed portal for the exact stabber, each made when it is first asked for; `None` where its
/// vertices are off the grid.
#[derive(Default)]
struct ExactPortal {
    /// In world units.
    whole: OnceLock<Option<Portal3>>,
    /// In units of the grid.
    on_grid: OnceLock<Option<Portal3>>,
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
    /// Of each directed portal, three vertices that are not collinear, and their plane.
    planes: Vec<Plane>,
    outlines: Vec<Outline>,
    exact: Vec<ExactPortal>,
    /// The directed portals by the cell that they leave, and where each cell's begin.
    leaving: Vec<Directed>,
    leaving_of: Vec<u32>,
    cells: u32,
    /// The first of the cells that lines enter and do not leave: the objects.
    objects: u32,
    order: CellOrder,
    /// The input's number of each planar portal.
    sources: Vec<u32>,
}

impl Arena {
    pub fn new(graph: &PortalGraph) -> Arena {
        Arena::bounded(graph, CellOrder::new(graph), |points| Bound::of(points).doubled())
    }

    /// The same for cells and objects. The cells are convex and an object's portals lie in the
    /// closed cells, so a line that crosses two portals of a cell does so in order.
    pub fn with_objects(objects: &ObjectGraph) -> Arena {
        let order = CellOrder::default();
        let bound = |points: &[Approx3]| Bound::of(points).doubled();
        Arena { objects: objects.cells, ..Arena::bounded(&objects.graph, order, bound) }
    }

    /// The same, with filters that never decide.
    pub fn without_filters(graph: &PortalGraph) -> Arena {
        Arena::bounded(graph, CellOrder::new(graph), |_| Bound::NEVER)
    }

    fn bounded(
        graph: &PortalGraph,
        order: CellOrder,
        bound: impl Fn(&[Approx3]) -> Bound,
    ) -> Arena {
        let grid = Grid::new(graph);
        let points: Vec<Approx3> = graph.vertices.iter().map(Grid::approximate).collect();
        let mut arena = Arena {
            bound: bound(&points),
            points,
            grid,
            spans: Vec::new(),
            ids: Vec::new(),
            edges: Vec::new(),
            planes: Vec::new(),
            outlines: Vec::new(),
            exact: Vec::new(),
            leaving: Vec::new(),
            leaving_of: Vec::new(),
            cells: graph.cells.len() as u32,
            objects: graph.cells.len() as u32,
            order,
            sources: graph.portals.iter().map(|portal| portal.source).collect(),
        };
        for portal in &graph.portals {
            // A validated portal has no collinear vertices: any three of them span its plane.
            let [a, b, c] = [0, 1, 2].map(|i| portal.vertices[i]);
            arena.add(portal.vertices.iter().copied(), [a, b, c], [portal.from.0, portal.to.0]);
            let reversed = portal.vertices.iter().rev().copied();
            arena.add(reversed, [a, c, b], [portal.to.0, portal.from.0]);
        }
        arena.index_cells();
        arena
    }

    fn add(&mut self, vertices: impl Iterator<Item = u32>, corner: [u32; 3], cells: [u32; 2]) {
        let first = self.ids.len();
        self.ids.extend(vertices);
        let ids = &self.ids[first..];
        for (i, &vertex) in ids.iter().enumerate() {
            let [a, b] = [vertex, ids[(i + 1) % ids.len()]].map(|v| &self.points[v as usize]);
            self.edges.push(FilteredLine::through(a, b, self.bound));
        }
        self.outlines.push(Outline::of(ids.iter().map(|&v| &self.points[v as usize])));
        self.exact.push(ExactPortal::default());
        self.planes.push(self.plane(corner));
        let [from, to] = cells;
        self.spans.push(Span { first: first as u32, end: self.ids.len() as u32, from, to });
    }

    fn index_cells(&mut self) {
        let mut order: Vec<Directed> = (0..self.spans.len() as u32).collect();
        order.sort_by_key(|&portal| (self.from(portal), portal));
        let mut first = vec![0; self.cells as usize + 1];
        for &portal in &order {
            first[self.from(portal) as usize + 1] += 1;
        }
        for cell in 0..self.cells as usize {
            first[cell + 1] += first[cell];
        }
        self.leaving = order;
        self.leaving_of = first;
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

    /// The input's number of the portal that this is, or is a triangle of.
    pub fn source(&self, portal: Directed) -> u32 {
        self.sources[portal as usize / 2]
    }

    /// The directed portals that leave `cell`, in ascending order.
    pub fn leaving(&self, cell: u32) -> &[Directed] {
        let [first, end] = [cell, cell + 1].map(|i| self.leaving_of[i as usize] as usize);
        &self.leaving[first..end]
    }

    /// The directed portals through which a line goes on that has entered `cell`: those that leave
    /// it, or none where it is an object.
    pub fn onward(&self, cell: u32) -> &[Directed] {
        if self.is_object(cell) { &[] } else { self.leaving(cell) }
    }

    /// Whether lines end in `cell`.
    pub fn is_object(&self, cell: u32) -> bool {
        cell >= self.objects
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

    /// The points of some vertices.
    pub fn points<'a>(&'a self, vertices: &'a [u32]) -> impl Iterator<Item = &'a Approx3> {
        vertices.iter().map(|&vertex| self.point(vertex))
    }

    pub fn outline(&self, portal: Directed) -> &Outline {
        &self.outlines[portal as usize]
    }

    /// The bound of every point that takes part: twice the largest coordinate, so that the points
    /// of a sightline may lie somewhat outside the scene.
    pub fn bound(&self) -> Bound {
        self.bound
    }

    pub fn grid(&self) -> &Grid {
        &self.grid
    }

    pub fn plane_of(&self, portal: Directed) -> &Plane {
        &self.planes[portal as usize]
    }

    /// The order in which the line through two points, of world coordinates `points` · 2^-bits,
    /// crosses the planes of two portals; see [`Grid::compare_crossings`].
    pub fn compare_crossings(
        &self,
        points: [[i64; 3]; 2],
        bits: u32,
        portals: [Directed; 2],
    ) -> Option<Sign> {
        let planes = portals.map(|portal| self.planes[portal as usize].through);
        self.grid.compare_crossings(points, bits, planes)
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
        self.grid.orient([a, b, c, vertex])
    }

    /// Whether no vertex of `portal` is in front of `plane`.
    #[inline]
    pub fn wholly_behind(&self, plane: &Plane, portal: Directed) -> bool {
        self.vertices(portal).iter().all(|&v| match self.side(plane, v) {
            Sign::Positive => false,
            // A portal that only touches the plane from behind has its interior behind it.
            Sign::Zero | Sign::Negative => true,
        })
    }

    /// Whether a line through the directed portals `first` and then `second`, which leaves the
    /// cell that `first` enters, might cross them in the other order.
    pub fn needs_order(&self, first: Directed, second: Directed) -> bool {
        !self.order.is_implied(PortalId(first / 2), PortalId(second / 2))
    }

    /// Whether no line crosses `first` and then `second`, which leaves the cell that `first`
    /// enters, because both are of one plane.
    pub fn is_impossible(&self, first: Directed, second: Directed) -> bool {
        self.order.is_impossible(PortalId(first / 2), PortalId(second / 2))
    }

    /// The portals of a sequence for the exact stabber, and how many of their units make one world
    /// unit: world units if all of their vertices have whole coordinates there (small numbers are
    /// quick), else those of the grid, or where a vertex is off it, of the vertices' lowest common
    /// denominator.
    pub fn exact_portals(&self, path: &[Directed]) -> (Vec<Cow<'_, Portal3>>, Int) {
        let one = Int::from(1);
        let whole = |&portal: &Directed| {
            let made = &self.exact[portal as usize].whole;
            made.get_or_init(|| self.exact_portal(portal, &one)).as_ref().map(Cow::Borrowed)
        };
        if let Some(portals) = path.iter().map(whole).collect() {
            return (portals, one);
        }
        let grid = self.grid.denominator();
        let on_grid = |&portal: &Directed| {
            let made = &self.exact[portal as usize].on_grid;
            made.get_or_init(|| self.exact_portal(portal, grid)).as_ref().map(Cow::Borrowed)
        };
        if let Some(portals) = path.iter().map(on_grid).collect() {
            return (portals, grid.clone());
        }
        let vertices = path.iter().flat_map(|&portal| self.vertices(portal));
        let common = self.grid.denominator_of(vertices.copied());
        let scaled = |&portal: &Directed| self.exact_portal(portal, &common).map(Cow::Owned);
        let portals: Option<Vec<_>> = path.iter().map(scaled).collect();
        (portals.expect("a common denominator holds all vertices"), common)
    }

    /// A portal in units of `1 / denominator`, if its vertices are multiples of it.
    fn exact_portal(&self, portal: Directed, denominator: &Int) -> Option<Portal3> {
        let points = self.vertices(portal).iter().map(|&vertex| {
            let vertex = self.grid.vertex(vertex);
            denominator.is_multiple_of(vertex.denominator()).then(|| vertex.on_grid(denominator))
        });
        let points: Vec<BigPoint3> = points.collect::<Option<_>>()?;
        Some(Portal3::new(&points).expect("a validated graph has planar convex portals"))
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

/// A table over pairs of directed portals.
pub(crate) type PairTable<T> = FxHashMap<(Directed, Directed), T>;
