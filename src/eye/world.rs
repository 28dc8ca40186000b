//! Eyes in a world, whose cells are closed polyhedra: nothing about the eye's place is left open.
//!
//! An eye belongs to every cell whose closed polyhedron holds it, and looks from it into each of
//! them: into the directions that lead from the eye to the cell's inside. An eye on a wall, in an
//! edge, a corner or a portal is no special case. As all closed cells count, an eye that lies in a
//! wall without thickness, in its corner or on its rim sees what is on both sides of it.

use super::search::{Start, search, sides};
use super::view::View;
use super::{Answer, Cull, EyeGraph, Query, SeenSpace};
use crate::geom::{BigPlane, RationalPoint3};
use crate::num::Sign;
use crate::portal::WorldCells;
use crate::predicates::{Direction, VertexPlane, side_of_point};
use crate::scene::CellId;
use crate::scene::world::{Place, World, WorldSolid};
use std::rc::Rc;

/// A world, prepared for eyes anywhere in it.
pub struct EyeWorld<'w> {
    world: &'w World,
    cells: &'w WorldCells,
    graph: EyeGraph<'w>,
}

/// Why an eye is in no cell.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum PlaceError {
    /// A closed solid holds it, and no closed cell does.
    #[error("the eye is in or on a solid and in no cell: {place}")]
    InSolid {
        /// Where the solid is stated: one that has the eye inside, if any has.
        place: Place,
    },
    /// It is in free space that the world does not ask about.
    #[error("the eye is outside of the level: nothing that marks the inside is joined to it")]
    Outside,
    /// It is not even in the box around the world.
    #[error("the eye is outside of the box around the level")]
    OutOfBox,
}

/// What an eye sees of a world.
#[derive(Clone, Debug)]
pub struct WorldAnswer {
    /// The cells; its `regions` are empty.
    pub answer: Answer,
    /// The seen part of each cell, if asked for.
    pub space: Option<SeenSpace>,
}

impl<'w> EyeWorld<'w> {
    /// Prepares the cells of a world.
    pub fn new(world: &'w World, cells: &'w WorldCells) -> EyeWorld<'w> {
        EyeWorld { world, cells, graph: EyeGraph::new(&cells.graph) }
    }

    /// Answers a query; its `cell` is not needed.
    ///
    /// Complexity: that of [`EyeGraph::look`], and for each region one split for each side of its
    /// cone.
    ///
    /// # Errors
    /// [`PlaceError`] where the eye is in no closed cell.
    pub fn look(&self, query: &Query, cull: Cull) -> Result<WorldAnswer, PlaceError> {
        let view = View::new(&self.graph, query.eye);
        let sides = sides(query.frustum);
        let starts = self.cells_of_eye(query.eye)?.into_iter().map(|cell| {
            let limits = sides.iter().cloned().chain(self.planes_at_eye(query.eye, cell));
            Start { cell, limits: limits.collect() }
        });
        let starts: Vec<Start> = starts.collect();
        let mut space = (query.regions && cull == Cull::Exact).then(|| {
            let mut space = SeenSpace::new(self.cells, query.eye);
            starts.iter().for_each(|start| space.add(self.cells, start.cell, &[], &sides));
            space
        });
        let answer = search(&view, query.frustum, cull, &starts, |cell, portals, cone| {
            if let Some(space) = &mut space {
                space.add(self.cells, cell, portals, cone.planes());
            }
        });
        Ok(WorldAnswer { answer, space })
    }

    /// The cells whose closed polyhedra hold the eye, in ascending order.
    fn cells_of_eye(&self, eye: &RationalPoint3) -> Result<Vec<CellId>, PlaceError> {
        let WorldCells { subdivision, leaves, .. } = self.cells;
        let located = subdivision.locate(eye);
        if located.is_empty() {
            return Err(PlaceError::OutOfBox);
        }
        let cell = |leaf| leaves.binary_search(leaf).ok().map(|cell| CellId(cell as u32));
        let cells: Vec<CellId> = located.iter().filter_map(cell).collect();
        if cells.is_empty() {
            return Err(self.without_cell(eye));
        }
        Ok(cells)
    }

    fn without_cell(&self, eye: &RationalPoint3) -> PlaceError {
        let deepest = self.world.solids.iter().map(|solid| (depth(solid, eye), solid));
        let deepest = deepest.filter(|(depth, _)| *depth > Depth::Outside);
        // The first of those that are equally deep.
        match deepest.rev().max_by_key(|(depth, _)| *depth) {
            Some((_, solid)) => PlaceError::InSolid { place: solid.place.clone() },
            None => PlaceError::Outside,
        }
    }

    /// The planes of a cell's faces that the eye, in the closed cell, lies in, positive inside.
    fn planes_at_eye(
        &self,
        eye: &RationalPoint3,
        cell: CellId,
    ) -> impl Iterator<Item = Rc<Direction>> {
        let subdivision = &self.cells.subdivision;
        let faces = subdivision.leaf(self.cells.leaves[cell.0 as usize]).cell.faces().iter();
        let planes = faces.map(|face| subdivision.planes.get(face.support()));
        planes.filter_map(|plane| match side_of_point(plane, eye) {
            Sign::Zero => {
                let BigPlane { normal, .. } = plane.plane();
                Some(Rc::new(Direction::new(normal.each_ref().map(|n| -n))))
            }
            Sign::Negative | Sign::Positive => None,
        })
    }
}

/// Where a point is with respect to a solid.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Depth {
    Outside,
    On,
    Inside,
}

fn depth(solid: &WorldSolid, point: &RationalPoint3) -> Depth {
    let of_plane = |plane: &BigPlane| match side_of_point(&VertexPlane::new(plane.clone()), point) {
        Sign::Positive => Depth::Outside,
        // On the boundary, unless another plane has it outside.
        Sign::Zero => Depth::On,
        Sign::Negative => Depth::Inside,
    };
    solid.planes.iter().map(of_plane).min().unwrap_or(Depth::Outside)
}
