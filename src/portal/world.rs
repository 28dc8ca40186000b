//! From a world to its cells and portals.

use super::{Cells, Flood, Leak, Portal, enumerate, flood};
use crate::geom::RationalPoint3;
use crate::num::Number;
use crate::report::{Progress, Silent};
use crate::scene::world::{Inside, Mark, Place, World, WorldHint};
use crate::scene::{PortalGraph, RawGraph, RawPortal, SceneError};
use crate::subdivision::{
    self, DivisionError, Hint, LeafId, Occluders, Options, PortalShape, Subdivision,
};

/// The cells of a world.
#[derive(Clone, Debug)]
pub struct WorldCells {
    /// The division of the world's box.
    pub subdivision: Subdivision,
    /// The leaf of each cell, ascending.
    pub leaves: Vec<LeafId>,
    /// All portals of the division.
    pub shared: Vec<Portal>,
    /// The portals between the cells; cell `i` is leaf `leaves[i]`.
    pub graph: PortalGraph,
    /// The marks that lie in no empty leaf, by index.
    pub buried: Vec<usize>,
}

/// Why a world has no cells.
#[derive(Clone, Debug, thiserror::Error)]
pub enum WorldError {
    /// Its solids cannot be divided.
    #[error(transparent)]
    Division(#[from] DivisionError),
    /// Nothing marks the inside.
    #[error("no entity marks the inside: expected a point entity with an `origin`")]
    NoMark,
    /// All marks are inside solids.
    #[error("all {0} marks of the inside are in solids or out of the box")]
    AllBuried(usize),
    /// The outside is reached from within.
    #[error("{place}: a leak: from here a way of {} points leads outside", .leak.path.len())]
    Leak {
        /// The way out.
        leak: Box<Leak>,
        /// The mark where it begins.
        place: Place,
    },
    /// The portals make no graph.
    #[error(transparent)]
    Graph(#[from] SceneError),
}

/// What divides a world's space.
pub fn occluders_of(world: &World) -> Occluders {
    let hint = |hint: &WorldHint| Hint { planes: hint.planes.clone(), splits: hint.splits.clone() };
    Occluders {
        solids: world.solids.iter().map(|solid| solid.planes.clone()).collect(),
        polygons: world.polygons.iter().map(|polygon| polygon.vertices.clone()).collect(),
        hints: world.hints.iter().map(hint).collect(),
        view: world.view.clone(),
    }
}

/// [`divide_world`] without telling of its progress.
///
/// # Errors
/// As there.
pub fn cells_of_world(world: &World, options: &Options) -> Result<WorldCells, WorldError> {
    divide_world(world, options, &Silent)
}

/// Divides a world's box, and keeps the empty leaves that are asked about.
///
/// # Errors
/// [`WorldError`]; a leak with its shortest way, counted in portals.
pub fn divide_world(
    world: &World,
    options: &Options,
    progress: &dyn Progress,
) -> Result<WorldCells, WorldError> {
    let subdivision = subdivision::build(&occluders_of(world), options, progress)?;
    let (mut subdivision, chosen, buried) = match &world.inside {
        Inside::Everywhere => {
            let chosen = vec![true; subdivision.leaves.len()];
            (subdivision, chosen, Vec::new())
        }
        Inside::Reached(marks) => reached(world, marks, subdivision, options, progress)?,
    };
    progress.begin("portals", 0);
    let shared = enumerate(&mut subdivision, options.portals);
    progress.begin("graph", 0);
    let Cells { leaves, portals } = Cells::of(&subdivision, &shared, &chosen);
    let portals = portals.into_iter().map(|portal| RawPortal {
        cells: [portal.from, portal.to],
        vertices: portal.polygon.iter().map(<[Number; 3]>::from).collect(),
        line: None,
    });
    let graph = PortalGraph::from_raw(RawGraph {
        cells: (0..leaves.len()).map(|cell| cell.to_string()).collect(),
        portals: portals.collect(),
        leaf_to_cell: (0..leaves.len() as u32).collect(),
        declared_grid: None,
    })?;
    Ok(WorldCells { subdivision, leaves, shared, graph, buried })
}

/// A division, for each leaf whether it is inside, and the buried marks.
type Chosen = (Subdivision, Vec<bool>, Vec<usize>);

/// Keeps what the marks reach; without what lies outside, the same space takes fewer cells.
fn reached(
    world: &World,
    marks: &[Mark],
    mut subdivision: Subdivision,
    options: &Options,
    progress: &dyn Progress,
) -> Result<Chosen, WorldError> {
    if marks.is_empty() {
        return Err(WorldError::NoMark);
    }
    let points: Vec<RationalPoint3> = marks.iter().map(|mark| mark.point.clone()).collect();
    progress.begin("flood", 0);
    let portals = enumerate(&mut subdivision, PortalShape::Exact);
    let Flood { inside, buried, leak } = flood(&subdivision, &portals, &points);
    if buried.len() == points.len() {
        return Err(WorldError::AllBuried(points.len()));
    }
    if let (Some(leak), None) = (leak, &world.view) {
        let place = marks[leak.start].place.clone();
        return Err(WorldError::Leak { leak: Box::new(leak), place });
    }
    let subdivision = subdivision.filled(&inside, options, progress)?;
    // All that is not reached is filled.
    let inside = subdivision.leaves.iter().map(|leaf| !leaf.solid).collect();
    Ok((subdivision, inside, buried))
}
