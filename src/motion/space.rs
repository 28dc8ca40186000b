//! A world prepared for moves: each cell with its faces, its portals, and the bodies near it.

use super::Obstacle;
use super::body::{Body, plane_through, planes_of_box};
use super::path::Path;
use crate::construct::{IntegerBox, Limits, PlaneId, PlaneSet};
use crate::geom::vector::{cross, difference, dot};
use crate::geom::{AxialBox, BigPlane, RationalPoint3};
use crate::portal::WorldCells;
use crate::scene::{CellId, World};
use crate::subdivision::{LeafId, Subdivision};

/// A world and its cells, prepared for moves.
///
/// Preparing takes one test of two boxes for every cell and obstacle, and for every solid O(e·v)
/// products for its e edges and v vertices; every move after that pays for what it meets only.
#[derive(Clone, Debug)]
pub struct Space<'a> {
    subdivision: &'a Subdivision,
    /// The leaf of each cell, ascending.
    leaves: &'a [LeafId],
    /// The planes of the subdivision, of the solids and of the polygons.
    pub(super) planes: PlaneSet,
    pub(super) cells: Vec<Cell>,
    pub(super) gates: Vec<Gate>,
    pub(super) bodies: Vec<Body>,
}

/// A cell as a moving point meets it.
#[derive(Clone, Debug)]
pub(super) struct Cell {
    /// The planes of its faces, outward.
    pub(super) faces: Vec<PlaneId>,
    /// Its portals, by index.
    pub(super) gates: Vec<u32>,
    /// The bodies that may touch the closed cell, by index: all that do, and some more.
    pub(super) near: Vec<u32>,
}

/// A portal as a moving point meets it.
#[derive(Clone, Debug)]
pub(super) struct Gate {
    cells: [CellId; 2],
    /// Half-spaces whose intersection is the closed polygon.
    pub(super) polygon: Vec<BigPlane>,
    /// The half-spaces of the least axial box around it.
    pub(super) around: Vec<BigPlane>,
}

impl Gate {
    /// Where the portal leads from a cell of it.
    pub(super) fn beyond(&self, cell: CellId) -> CellId {
        if self.cells[0] == cell { self.cells[1] } else { self.cells[0] }
    }

    fn new(cells: [CellId; 2], vertices: &[RationalPoint3]) -> Gate {
        let plane = plane_through(vertices);
        let grid = RationalPoint3::common_denominator(vertices);
        let corners: Vec<_> = vertices.iter().map(|v| v.on_grid(&grid).coordinates).collect();
        let back = plane.normal.each_ref().map(|n| -n);
        let edges = corners.iter().zip(corners.iter().cycle().skip(1)).map(|(a, b)| {
            // Counter-clockwise about the normal, so that this points out of the polygon.
            let outward = cross(&difference(b, a), &plane.normal);
            let offset = dot(&outward, a);
            BigPlane { normal: outward.map(|c| c * &grid), offset }
        });
        let edges: Vec<BigPlane> = edges.collect();
        let mut polygon = vec![BigPlane { normal: back, offset: -&plane.offset }, plane];
        polygon.extend(edges);
        let around = AxialBox::around(vertices).expect("a portal has vertices");
        Gate { cells, polygon, around: planes_of_box(&around) }
    }
}

impl Space<'_> {
    /// Prepares a world and its cells, which must be those of
    /// [`cells_of_world`](crate::portal::cells_of_world).
    pub fn new<'a>(world: &World, cells: &'a WorldCells) -> Space<'a> {
        let subdivision = &cells.subdivision;
        let mut planes = subdivision.planes.clone();
        let bodies = bodies(world, &mut planes);
        let graph = &cells.graph;
        let gates: Vec<Gate> = (graph.portals.iter())
            .map(|portal| {
                let vertices: Vec<_> = graph.corners(portal).cloned().collect();
                Gate::new([portal.from, portal.to], &vertices)
            })
            .collect();
        let ends = subdivision.bounds.planes();
        let first_end = bodies.len() as u32;
        let mut all: Vec<Cell> = (cells.leaves.iter())
            .map(|&leaf| {
                let solid = &subdivision.leaf(leaf).cell;
                let faces: Vec<PlaneId> = solid.faces().iter().map(|f| f.support()).collect();
                let points: Vec<_> = solid.faces().iter().flat_map(|f| f.points()).collect();
                let around = IntegerBox::around(&points).expect("a leaf has vertices");
                let touched = bodies.iter().zip(0u32..);
                let touched = touched.filter(|((_, other), _)| around.touches(other));
                let mut near: Vec<u32> = touched.map(|(_, index)| index).collect();
                let at_end = (first_end..).zip(ends).filter(|(_, end)| faces.contains(end));
                near.extend(at_end.map(|(index, _)| index));
                Cell { faces, gates: Vec::new(), near }
            })
            .collect();
        for (gate, index) in gates.iter().zip(0u32..) {
            gate.cells.iter().for_each(|cell| all[cell.0 as usize].gates.push(index));
        }
        let mut bodies: Vec<Body> = bodies.into_iter().map(|(body, _)| body).collect();
        bodies.extend(ends.map(|plane| Body::beyond(&planes, plane)));
        Space { subdivision, leaves: &cells.leaves, planes, cells: all, gates, bodies }
    }

    /// The cells whose closures contain the point.
    pub(super) fn locate(&self, point: &RationalPoint3) -> Vec<CellId> {
        let leaves = self.subdivision.locate(point);
        let cell = |leaf| self.leaves.binary_search(&leaf).ok();
        leaves.into_iter().filter_map(cell).map(|cell| CellId(cell as u32)).collect()
    }

    /// The first of the solids that contains the point.
    pub(super) fn solid_at(&self, point: &RationalPoint3) -> Option<Obstacle> {
        let path = Path::of_point(point, point);
        let solid = |body: &&Body| matches!(body.obstacle, Obstacle::Solid(_));
        let holds = |body: &&Body| path.within(body.half_spaces()).is_some();
        self.bodies.iter().filter(solid).find(holds).map(|body| body.obstacle)
    }
}

/// The solids with volume and the polygons, each with its box.
fn bodies(world: &World, planes: &mut PlaneSet) -> Vec<(Body, IntegerBox)> {
    let interned: Vec<Vec<PlaneId>> = (world.solids.iter())
        .map(|solid| planes.intern_all(&solid.planes).expect("a divided world has normals"))
        .collect();
    let limits = Limits::new(planes);
    let mut bodies = Vec::new();
    for (index, half_spaces) in interned.iter().enumerate() {
        // A solid without volume has no inside that could be entered.
        if let Ok(cut) = limits.cut_out(planes, half_spaces) {
            let body = Body::of_solid(planes, index, &cut.solid);
            bodies.push((body, cut.around));
        }
    }
    for (index, polygon) in world.polygons.iter().enumerate() {
        let body = Body::of_polygon(planes, index, &polygon.vertices);
        let around = IntegerBox::around(&polygon.vertices).expect("a polygon has vertices");
        bodies.push((body, around));
    }
    bodies
}
