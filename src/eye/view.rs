//! A portal graph as it looks from one point.
//!
//! Positions are taken relative to the eye: a vertex becomes the direction to it, a portal the
//! planes through the eye and its edges. The eye strictly behind a portal's plane can look through
//! it one way only, from the cell on the eye's side into the other; an eye in the plane looks
//! through it no way at all (semantics: crossing means d·n > 0 with the eye before the crossing).
//!
//! Everything is computed when it is first asked for, and kept: a query touches few portals.

use crate::geom::{BigPlane, BigPoint3, RationalPoint3};
use crate::num::{Int, Sign};
use crate::predicates::{Direction, side_of_direction};
use crate::scene::{CellId, CellOrder, Portal, PortalGraph, PortalId};
use num_integer::Integer;
use num_traits::Signed;
use std::cell::OnceCell;
use std::rc::Rc;

/// A portal graph, prepared for eyes anywhere in it.
pub struct EyeGraph<'g> {
    pub(super) graph: &'g PortalGraph,
    /// Which consecutive portals need their order of crossing as a condition.
    pub(super) order: CellOrder,
    /// The portals of each cell, in ascending order.
    pub(super) portals_of: Vec<Vec<usize>>,
    /// Each portal's plane in world coordinates, normal from its cell `from` into `to`.
    planes: Vec<BigPlane>,
}

/// The place of a vertex in world coordinates.
fn world(graph: &PortalGraph, vertex: u32) -> &RationalPoint3 {
    &graph.vertices[vertex as usize]
}

impl<'g> EyeGraph<'g> {
    /// Prepares `graph`.
    pub fn new(graph: &'g PortalGraph) -> EyeGraph<'g> {
        let mut portals_of = vec![Vec::new(); graph.cells.len()];
        for (index, portal) in graph.portals.iter().enumerate() {
            portals_of[portal.from.0 as usize].push(index);
            portals_of[portal.to.0 as usize].push(index);
        }
        let planes = graph.portals.iter().map(|portal| plane(graph, portal)).collect();
        EyeGraph { graph, order: CellOrder::new(graph), portals_of, planes }
    }

    /// Whether the closed inner half-space of the portal's plane holds all portals of its cell
    /// `cell`, so that the plane bounds the cell. In a convex cell every portal's does.
    pub(super) fn bounds(&self, portal: usize, cell: CellId) -> bool {
        let inner = self.inner(portal, cell);
        let others = self.portals_of[cell.0 as usize].iter();
        let vertices = others.flat_map(|&other| &self.graph.portals[other].vertices);
        let mut sides = vertices.map(|&v| side(&self.planes[portal], world(self.graph, v)));
        sides.all(|side| side != -inner)
    }

    /// The side of the portal's plane on which `cell`, one of its two cells, lies.
    pub(super) fn inner(&self, portal: usize, cell: CellId) -> Sign {
        if self.graph.portals[portal].from == cell { Sign::Negative } else { Sign::Positive }
    }

    /// The cell on the other side of a portal of `cell`.
    pub(super) fn beyond(&self, portal: usize, cell: CellId) -> CellId {
        let Portal { from, to, .. } = self.graph.portals[portal];
        if from == cell { to } else { from }
    }
}

/// The plane of a portal in world coordinates, in lowest terms.
fn plane(graph: &PortalGraph, portal: &Portal) -> BigPlane {
    let corners = [0, 1, 2].map(|i| world(graph, portal.vertices[i]));
    let common = corners.iter().fold(Int::from(1), |c, p| c.lcm(p.denominator()));
    let [a, b, c] = corners.map(|p| {
        let scale = &common / p.denominator();
        BigPoint3 { coordinates: p.numerators().each_ref().map(|c| c * &scale) }
    });
    let BigPlane { normal, offset } = BigPlane::through(&a, &b, &c);
    let normal = normal.map(|n| n * &common);
    let divisor = normal.iter().fold(offset.clone(), |g, n| g.gcd(n));
    BigPlane { normal: normal.map(|n| n / &divisor), offset: offset / divisor }
}

/// n·v - o times the point's denominator.
fn height(plane: &BigPlane, point: &RationalPoint3) -> Int {
    let [n, v] = [&plane.normal, point.numerators()];
    &n[0] * &v[0] + &n[1] * &v[1] + &n[2] * &v[2] - &plane.offset * point.denominator()
}

fn side(plane: &BigPlane, point: &RationalPoint3) -> Sign {
    Sign::of(&height(plane, point))
}

/// A graph from one point.
pub(super) struct View<'a> {
    pub(super) graph: &'a EyeGraph<'a>,
    pub(super) eye: &'a RationalPoint3,
    directions: Vec<OnceCell<Rc<Direction>>>,
    heights: Vec<OnceCell<Int>>,
    portals: Vec<OnceCell<Seen>>,
}

/// A portal from one point.
pub(super) struct Seen {
    /// The directions of the vertices, counter-clockwise as seen from behind the portal; and the
    /// planes that each spans with the next one, positive inside. Empty for an eye in its plane.
    pub(super) rays: Vec<Rc<Direction>>,
    pub(super) planes: Vec<Rc<Direction>>,
}

impl<'a> View<'a> {
    pub(super) fn new(graph: &'a EyeGraph<'a>, eye: &'a RationalPoint3) -> View<'a> {
        View {
            graph,
            eye,
            directions: vec![OnceCell::new(); graph.graph.vertices.len()],
            heights: vec![OnceCell::new(); graph.planes.len()],
            portals: std::iter::repeat_with(OnceCell::new).take(graph.planes.len()).collect(),
        }
    }

    /// From the eye to a vertex.
    fn direction(&self, vertex: u32) -> &Rc<Direction> {
        self.directions[vertex as usize].get_or_init(|| {
            let to = world(self.graph.graph, vertex);
            let (e, v) = (self.eye.numerators(), to.numerators());
            let (f, d) = (self.eye.denominator(), to.denominator());
            // (v/d - e/f)·d·f
            Rc::new(Direction::new([0, 1, 2].map(|i| &v[i] * f - &e[i] * d)))
        })
    }

    /// n·eye - o for a portal's plane, times the eye's denominator.
    fn height(&self, portal: usize) -> &Int {
        self.heights[portal].get_or_init(|| height(&self.graph.planes[portal], self.eye))
    }

    /// The side of a portal's plane on which the eye is.
    pub(super) fn side(&self, portal: usize) -> Sign {
        Sign::of(self.height(portal))
    }

    /// A portal as it looks from the eye.
    pub(super) fn seen(&self, portal: usize) -> &Seen {
        self.portals[portal].get_or_init(|| {
            let vertices = &self.graph.graph.portals[portal].vertices;
            let mut rays: Vec<_> = vertices.iter().map(|&v| Rc::clone(self.direction(v))).collect();
            match self.side(portal) {
                Sign::Negative => {}
                // The eye is on the side of `to`: the polygon is crossed against its normal.
                Sign::Positive => rays.reverse(),
                // No direction crosses a plane that the eye lies in.
                Sign::Zero => rays.clear(),
            }
            let after = rays.iter().cycle().skip(1);
            let planes = rays.iter().zip(after).map(|(a, b)| Rc::new(Direction::cross(a, b)));
            let planes = planes.collect();
            Seen { rays, planes }
        })
    }

    /// Whether the eye, in `cell`'s closed half-space of the portal's plane, looks through it.
    pub(super) fn leaves(&self, portal: usize, cell: CellId) -> bool {
        // An eye in the plane is on neither cell's side, and sees nothing through the portal.
        self.side(portal) == self.graph.inner(portal, cell)
    }

    /// Whether the eye is strictly outside `cell` by the plane of one of its portals.
    pub(super) fn is_outside(&self, portal: usize, cell: CellId) -> bool {
        self.side(portal) == -self.graph.inner(portal, cell)
    }

    /// Whether the eye is in the closed portal.
    pub(super) fn is_in_portal(&self, portal: usize) -> bool {
        if self.side(portal) != Sign::Zero {
            return false;
        }
        let normal = self.normal(portal, Sign::Positive);
        let vertices = &self.graph.graph.portals[portal].vertices;
        let after = vertices.iter().cycle().skip(1);
        vertices.iter().zip(after).all(|(&v, &w)| {
            let spanned = Direction::cross(self.direction(v), self.direction(w));
            match side_of_direction(&normal, &spanned) {
                Sign::Positive => true,
                // On the line of an edge: in the closed portal unless another edge says no.
                Sign::Zero => true,
                Sign::Negative => false,
            }
        })
    }

    /// The planes of a cell's portals that bound it and that the eye lies in, positive inside.
    pub(super) fn planes_at_eye(&self, cell: CellId) -> impl Iterator<Item = Rc<Direction>> {
        let portals = self.graph.portals_of[cell.0 as usize].iter().copied();
        let at_eye = portals.filter(move |&portal| {
            self.side(portal) == Sign::Zero && self.graph.bounds(portal, cell)
        });
        at_eye.map(move |portal| Rc::new(self.normal(portal, self.graph.inner(portal, cell))))
    }

    /// The normal of a portal's plane, turned so that the given side is its positive one.
    pub(super) fn normal(&self, portal: usize, side: Sign) -> Direction {
        let normal = self.graph.planes[portal].normal.clone();
        Direction::new(match side {
            Sign::Positive | Sign::Zero => normal,
            Sign::Negative => normal.map(|n| -n),
        })
    }

    /// The directions that cross `first` before `second`, as a plane's positive side, where that
    /// is not implied.
    ///
    /// With forward normals n and the depths h > 0 of the planes before the eye, a direction v
    /// crosses them at h1/(n1·v) and h2/(n2·v), so the first is first iff (h2·n1 - h1·n2)·v > 0.
    pub(super) fn order(&self, first: usize, second: usize) -> Option<Rc<Direction>> {
        let ids = [first, second].map(|portal| PortalId(portal as u32));
        if self.graph.order.is_implied(ids[0], ids[1]) {
            return None;
        }
        let forward = |portal: usize| {
            let normal = self.normal(portal, -self.side(portal));
            (normal.exact().clone(), self.height(portal).abs())
        };
        let ((n1, h1), (n2, h2)) = (forward(first), forward(second));
        Some(Rc::new(Direction::new([0, 1, 2].map(|i| &h2 * &n1[i] - &h1 * &n2[i]))))
    }

    /// Where the eye sees the portal's plane in a direction that crosses it: eye + t·v with
    /// t = -(n·eye - o)/(n·v).
    pub(super) fn meet(&self, portal: usize, v: &[Int; 3]) -> RationalPoint3 {
        let n = &self.graph.planes[portal].normal;
        let slope = &n[0] * &v[0] + &n[1] * &v[1] + &n[2] * &v[2];
        let (e, f) = (self.eye.numerators(), self.eye.denominator());
        let height = self.height(portal);
        // `height` holds the eye's denominator as a factor, as e does.
        RationalPoint3::new([0, 1, 2].map(|i| &e[i] * &slope - height * &v[i]), slope * f)
    }
}
