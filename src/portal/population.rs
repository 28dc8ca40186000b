//! Which cells hold a part of an object, and through which polygons a sightline enters it.
//!
//! An object is a box. Pushed down the tree and cut by its planes, it falls into its pieces, one a
//! leaf whose inside it meets: with exact signs this decides the linear program of each leaf's and
//! the box's half-spaces (Teller 1992, section 8.2.3), and yields the common part as well.
//!
//! A sightline meets the box's inside iff it starts there, or enters it through a face. The
//! faces, pushed down the tree, fall into polygons inside cells, each entered from its cell; where
//! a face lies in a splitting plane, a line comes through that plane: from the cell outside the
//! face, through a portal, and is in the box at once. That polygon is the part of the face in the
//! portal, and is entered from the outer cell; where there is no portal, nothing enters.
//!
//! Complexity: with k objects in a tree of depth d that meet p leaves in all, O((k + p) · d)
//! extents of polyhedra, and as many splits as there are pieces.

use super::{Portal, WorldCells};
use crate::construct::{PlaneId, PlaneSet, Polygon, Polyhedron};
use crate::geom::{AxialBox, BigPlane};
use crate::num::{Int, Number, Rational};
use crate::scene::world::Object;
use crate::scene::{CellId, ObjectGraph, PortalGraph, RawGraph, RawPortal, SceneError};
use crate::subdivision::{Child, LeafId, Subdivision};

/// The part of an object in one cell.
#[derive(Clone, Debug)]
pub struct Piece {
    /// The object, by index.
    pub object: u32,
    /// The cell whose inside it meets.
    pub cell: CellId,
    /// The common part of the box and the closed cell.
    pub solid: Polyhedron,
}

/// A polygon through which lines enter an object.
#[derive(Clone, Debug)]
pub struct Entry {
    /// The object, by index.
    pub object: u32,
    /// The cell that the lines come from.
    pub cell: CellId,
    /// A part of a face of the box, in the closed cell; its support is positive outside of the box.
    pub polygon: Polygon,
}

/// Objects among cells.
#[derive(Clone, Debug, Default)]
pub struct Population {
    /// The pieces, by object, then by cell; each pair at most once.
    pub pieces: Vec<Piece>,
    /// The polygons through which lines enter, by object, then by cell.
    pub entries: Vec<Entry>,
    /// The objects that have no piece, being in solids or outside, ascending.
    pub nowhere: Vec<u32>,
}

impl Population {
    /// Finds the parts of `objects`, each of which has volume, in the cells of a world; their
    /// planes are added to the subdivision's.
    pub fn of(objects: &[Object], cells: &mut WorldCells) -> Population {
        let mut population = Population::default();
        for (object, stated) in (0..).zip(objects) {
            let sides = box_planes(&mut cells.subdivision.planes, &stated.bounds);
            population.add(object, &sides, cells);
        }
        population
    }

    fn add(&mut self, object: u32, sides: &[PlaneId; 6], cells: &WorldCells) {
        let subdivision = &cells.subdivision;
        let (planes, bounds) = (&subdivision.planes, &subdivision.bounds);
        let cell = |leaf: LeafId| cells.leaves.binary_search(&leaf).ok().map(|i| CellId(i as u32));
        let Some(solid) = Polyhedron::of_half_spaces(planes, bounds, sides) else {
            self.nowhere.push(object);
            return;
        };
        // In the boundary of all cells there is no way in.
        let ends = bounds.planes().map(PlaneId::undirected);
        let faces = solid.faces().iter().filter(|f| !ends.contains(&f.support().undirected()));
        let mut entries: Vec<Entry> = faces
            .flat_map(|face| ways_in(cells, face.clone()))
            .filter_map(|(leaf, polygon)| Some(Entry { object, cell: cell(leaf)?, polygon }))
            .collect();
        let mut pieces: Vec<Piece> = divide(subdivision, solid)
            .into_iter()
            .filter_map(|(leaf, solid)| Some(Piece { object, cell: cell(leaf)?, solid }))
            .collect();
        if pieces.is_empty() {
            self.nowhere.push(object);
        }
        pieces.sort_by_key(|piece| piece.cell);
        entries.sort_by_key(|entry| entry.cell);
        self.pieces.append(&mut pieces);
        self.entries.append(&mut entries);
    }

    /// The graph of the cells, of which this is the population, with the objects.
    ///
    /// # Errors
    /// None but that of a polygon whose coordinates have too many digits.
    pub fn graph(
        &self,
        objects: &[Object],
        cells: &PortalGraph,
    ) -> Result<ObjectGraph, SceneError> {
        let between = cells.portals.iter().map(|portal| RawPortal {
            cells: [portal.from.0, portal.to.0],
            vertices: cells.corners(portal).map(<[Number; 3]>::from).collect(),
            line: None,
        });
        let first = cells.cells.len() as u32;
        let into = self.entries.iter().map(|entry| RawPortal {
            cells: [entry.cell.0, first + entry.object],
            vertices: entry.polygon.flipped().points().iter().map(<[Number; 3]>::from).collect(),
            line: None,
        });
        let names = objects.iter().map(|object| object.place.to_string());
        let graph = PortalGraph::from_raw(RawGraph {
            cells: cells.cells.iter().cloned().chain(names).collect(),
            portals: between.chain(into).collect(),
            leaf_to_cell: (0..first).collect(),
            declared_grid: None,
        })?;
        let mut held_by = vec![Vec::new(); objects.len()];
        for piece in &self.pieces {
            held_by[piece.object as usize].push(piece.cell);
        }
        Ok(ObjectGraph { graph, cells: first, held_by })
    }
}

/// The six planes of a box, outward.
fn box_planes(planes: &mut PlaneSet, bounds: &AxialBox) -> [PlaneId; 6] {
    let mut axial = |axis: usize, at: &Rational| {
        let mut normal = [Int::ZERO, Int::ZERO, Int::ZERO];
        normal[axis] = at.denom().clone();
        let plane = BigPlane { normal, offset: at.numer().clone() };
        planes.intern(&plane).expect("a denominator is not zero")
    };
    let low = [0, 1, 2].map(|axis| axial(axis, &bounds.low[axis]).flipped());
    let high = [0, 1, 2].map(|axis| axial(axis, &bounds.high[axis]));
    let ([a, b, c], [d, e, f]) = (low, high);
    [a, b, c, d, e, f]
}

/// The parts of a polyhedron in the leaves whose insides it meets.
fn divide(subdivision: &Subdivision, solid: Polyhedron) -> Vec<(LeafId, Polyhedron)> {
    let planes = &subdivision.planes;
    let (mut parts, mut stack) = (Vec::new(), vec![(subdivision.root, solid)]);
    while let Some((child, solid)) = stack.pop() {
        let node = match child {
            Child::Leaf(leaf) => {
                parts.push((leaf, solid));
                continue;
            }
            Child::Node(node) => &subdivision.nodes[node as usize],
        };
        let plane = node.section.support();
        let extent = solid.extent(planes, plane);
        match (extent.front, extent.back) {
            (true, true) => {
                let section = solid.section(planes, &subdivision.bounds, plane);
                let [front, back] = solid.split(planes, &section);
                stack.push((node.back, back));
                stack.push((node.front, front));
            }
            (true, false) => stack.push((node.front, solid)),
            (false, true) => stack.push((node.back, solid)),
            (false, false) => unreachable!("a polyhedron has volume"),
        }
    }
    parts
}

/// The parts of a box's face through which lines enter the box, each with the leaf that they come
/// from: those in a leaf's inside, and those in a portal between a leaf outside of the box and one
/// inside.
fn ways_in(cells: &WorldCells, face: Polygon) -> Vec<(LeafId, Polygon)> {
    let (subdivision, mut ways) = (&cells.subdivision, Vec::new());
    for (outer, polygon) in subdivision.looking_into(subdivision.root, face) {
        for (inner, flipped) in subdivision.looking_into(subdivision.root, polygon.flipped()) {
            let polygon = flipped.flipped();
            if inner == outer {
                ways.push((outer, polygon));
            } else {
                let portals = portals_between(&cells.shared, inner, outer).iter();
                ways.extend(portals.filter_map(|portal| {
                    let mut cuts = portal.polygon.cuts();
                    let within = |rest: Polygon, cut| rest.inside(&subdivision.planes, cut);
                    Some((outer, cuts.try_fold(polygon.clone(), within)?))
                }));
            }
        }
    }
    ways
}

/// The portals of two leaves, among all by `from`, then `to`.
fn portals_between(portals: &[Portal], a: LeafId, b: LeafId) -> &[Portal] {
    let of = |pair: (LeafId, LeafId)| {
        let key = |portal: &Portal| (portal.from, portal.to);
        let first = portals.partition_point(|portal| key(portal) < pair);
        &portals[first..portals.partition_point(|portal| key(portal) <= pair)]
    };
    if of((a, b)).is_empty() { of((b, a)) } else { of((a, b)) }
}
