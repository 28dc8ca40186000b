//! From a level's brushes to the cells and portals of its inside.

use super::{Cells, Flood, Leak, enumerate, flood};
use crate::geom::{BigPlane, RationalPoint3};
use crate::num::Number;
use crate::scene::level::{Brush, Level, Role};
use crate::scene::{PortalGraph, RawGraph, RawPortal, SceneError};
use crate::subdivision::{self, DivisionError, LeafId, Options, Subdivision};

/// The inside of a level.
#[derive(Clone, Debug)]
pub struct LevelCells {
    /// The division of the space around the level's solids.
    pub subdivision: Subdivision,
    /// The leaf of each cell, ascending: the empty leaves that are inside.
    pub leaves: Vec<LeafId>,
    /// The portals between the cells; cell `i` is leaf `leaves[i]`.
    pub graph: PortalGraph,
    /// The entities whose place is inside no empty leaf, by their index in the level.
    pub buried: Vec<usize>,
}

/// Why a level has no inside.
#[derive(Clone, Debug, thiserror::Error)]
pub enum LevelError {
    /// Its solids cannot be divided.
    #[error(transparent)]
    Division(#[from] DivisionError),
    /// Nothing marks the inside.
    #[error("no entity marks the inside: expected a point entity with an `origin`")]
    NoMark,
    /// All marks are inside solids.
    #[error("all {0} point entities are inside solids, so none marks the inside")]
    AllBuried(usize),
    /// The outside is reached from within.
    #[error(
        "line {line}: a leak: from the entity `{class}` a way of {} points leads outside",
        .leak.path.len()
    )]
    Leak {
        /// The way out.
        leak: Box<Leak>,
        /// The class of the entity where it begins.
        class: String,
        /// The entity's line.
        line: usize,
    },
    /// The portals make no graph.
    #[error(transparent)]
    Graph(#[from] SceneError),
}

/// Divides the space around the level's solids, and keeps what its point entities can reach.
///
/// Solids occlude; hints split; all else is seen through.
///
/// # Errors
/// [`LevelError`]; a leak with its shortest way, counted in portals.
pub fn cells_of_level(level: &Level, options: &Options) -> Result<LevelCells, LevelError> {
    let of_role = |role: Role| level.brushes.iter().filter(move |brush| brush.role == role);
    let planes =
        |brush: &Brush| -> Vec<BigPlane> { brush.faces.iter().map(|f| f.plane.clone()).collect() };
    let solids: Vec<_> = of_role(Role::Solid).map(planes).collect();
    let splits = |brush: &Brush| brush.faces.iter().map(|face| face.splits).collect();
    let hints: Vec<_> = of_role(Role::Hint).map(|brush| (planes(brush), splits(brush))).collect();
    let (places, points): (Vec<usize>, Vec<RationalPoint3>) = level
        .entities
        .iter()
        .enumerate()
        .filter(|(_, entity)| entity.is_point)
        .filter_map(|(index, entity)| Some((index, entity.origin.clone()?)))
        .unzip();
    if points.is_empty() {
        return Err(LevelError::NoMark);
    }
    let subdivision = subdivision::build(&solids, &hints, options)?;
    let portals = enumerate(&subdivision);
    let Flood { inside, buried, leak } = flood(&subdivision, &portals, &points);
    if buried.len() == points.len() {
        return Err(LevelError::AllBuried(points.len()));
    }
    if let Some(leak) = leak {
        let entity = &level.entities[places[leak.start]];
        let (class, line) = (entity.class.clone(), entity.line);
        return Err(LevelError::Leak { leak: Box::new(leak), class, line });
    }
    // Without what lies outside, the same space inside takes fewer cells.
    let subdivision = subdivision.filled(&inside, options);
    let portals = enumerate(&subdivision);
    let Flood { inside, buried, .. } = flood(&subdivision, &portals, &points);
    let Cells { leaves, portals } = Cells::of(&subdivision, &portals, &inside);
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
    let buried = buried.into_iter().map(|point| places[point]).collect();
    Ok(LevelCells { subdivision, leaves, graph, buried })
}
