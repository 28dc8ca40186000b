//! The space that an eye sees of a world, as exact convex polyhedra, and the objects in it.
//!
//! Through one sequence of portals an eye sees of the reached cell what lies in the cone of the
//! sequence's directions; of its own cell, what lies in the frustum. Both are convex. In convex
//! cells a ray that meets no portal's edge has one sequence, so the cones of two sequences that
//! reach the same cell are disjoint, and the volumes of all regions add up to that of the seen
//! space.
//!
//! Source: Teller 1992, sections 8.4.3 and 8.4.4, where a convex hull algorithm intersects the
//! half-spaces; here the cell's polyhedron is cut by the sides of the cone, so that every vertex is
//! the meet of three planes: of cells, of sides of the frustum, or of the eye and a portal's edge.

use crate::construct::{Bounds, PlaneId, PlaneSet, Polyhedron};
use crate::geom::{AxialBox, BigPlane, RationalPoint3};
use crate::num::{Int, Rational};
use crate::portal::WorldCells;
use crate::predicates::Direction;
use crate::scene::world::Object;
use crate::scene::{CellId, PortalId};
use std::rc::Rc;

/// The seen space.
#[derive(Clone, Debug)]
pub struct SeenSpace {
    eye: RationalPoint3,
    /// The planes of the cells and of all cuts.
    planes: PlaneSet,
    /// The box around all cells.
    bounds: Bounds,
    /// The eye's own cells, then each sequence in the order of the search; disjoint.
    pub regions: Vec<SeenRegion>,
}

/// What is seen of a cell through one sequence.
#[derive(Clone, Debug)]
pub struct SeenRegion {
    /// The cell.
    pub cell: CellId,
    /// The sequence; empty for the eye's own cell.
    pub portals: Vec<PortalId>,
    /// The region, closed.
    pub polyhedron: Polyhedron,
}

/// A detail object that is seen.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SeenObject {
    /// The object, by its index.
    pub object: usize,
    /// The region in which it is seen first, by its index.
    pub region: usize,
    /// A point inside of both.
    pub point: RationalPoint3,
}

impl SeenSpace {
    pub(super) fn new(cells: &WorldCells, eye: &RationalPoint3) -> SeenSpace {
        let subdivision = &cells.subdivision;
        SeenSpace {
            eye: eye.clone(),
            planes: subdivision.planes.clone(),
            bounds: subdivision.bounds,
            regions: Vec::new(),
        }
    }

    /// Adds what of a cell lies in the directions on the positive side of all planes.
    pub(super) fn add<'d>(
        &mut self,
        cells: &WorldCells,
        cell: CellId,
        portals: &[usize],
        sides: impl IntoIterator<Item = &'d Rc<Direction>>,
    ) {
        let whole = cells.subdivision.leaf(cells.leaves[cell.0 as usize]).cell.clone();
        let cut = sides.into_iter().try_fold(whole, |part, side| {
            let plane = self.through_eye(side);
            part.inside(&self.planes, &self.bounds, plane)
        });
        // A frustum may look away from a cell that the eye only touches.
        let Some(polyhedron) = cut else { return };
        let portals = portals.iter().map(|&portal| PortalId(portal as u32)).collect();
        self.regions.push(SeenRegion { cell, portals, polyhedron });
    }

    /// The plane through the eye with its negative side where the normal is positive.
    fn through_eye(&mut self, inward: &Direction) -> PlaneId {
        let (n, e) = (inward.exact(), self.eye.numerators());
        let offset = (0..3).map(|i| &n[i] * &e[i]).sum();
        let normal = n.each_ref().map(|n| n * self.eye.denominator());
        let plane = self.planes.intern(&BigPlane { normal, offset });
        plane.expect("a side of a cone has a normal").flipped()
    }

    /// The volume of all that is seen.
    ///
    /// Its denominator may be as long as all regions' together.
    pub fn volume(&self) -> Rational {
        self.regions.iter().map(|region| region.polyhedron.volume()).sum()
    }

    /// The objects whose inside has a point in common with the inside of a region, in their order.
    ///
    /// Complexity: for each object one side test for each vertex of each region until one is found,
    /// and six splits for a region that no side of the box keeps apart.
    pub fn objects(&mut self, objects: &[Object]) -> Vec<SeenObject> {
        let mut seen = Vec::new();
        for (index, Object { bounds, .. }) in objects.iter().enumerate() {
            let sides = self.sides_of_box(bounds);
            let apart = |region: &SeenRegion| {
                let extent = |&side: &PlaneId| region.polyhedron.extent(&self.planes, side);
                sides.iter().any(|side| !extent(side).back)
            };
            let near = self.regions.iter().enumerate().filter(|(_, region)| !apart(region));
            let common = |(region, of): (usize, &SeenRegion)| {
                let cut = sides.iter().try_fold(of.polyhedron.clone(), |part, &side| {
                    part.inside(&self.planes, &self.bounds, side)
                })?;
                Some(SeenObject {
                    object: index,
                    region,
                    point: cut.short_inner_point(&self.planes),
                })
            };
            seen.extend(near.filter_map(common).next());
        }
        seen
    }

    /// The six planes of a box, outward.
    fn sides_of_box(&mut self, bounds: &AxialBox) -> [PlaneId; 6] {
        let mut plane = |axis: usize, at: &Rational| {
            let mut normal = [Int::ZERO, Int::ZERO, Int::ZERO];
            normal[axis] = at.denom().clone();
            let plane = self.planes.intern(&BigPlane { normal, offset: at.numer().clone() });
            plane.expect("a denominator is not zero")
        };
        let [a, b, c] = [0, 1, 2].map(|axis| plane(axis, &bounds.low[axis]).flipped());
        let [d, e, f] = [0, 1, 2].map(|axis| plane(axis, &bounds.high[axis]));
        [a, b, c, d, e, f]
    }
}
