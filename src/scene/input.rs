//! Any file that holds a portal graph, told apart by its first bytes.

use super::plan::PlanError;
use super::world::StatementError;
use super::{PortalGraph, RawGraph, RawPortal, SceneError};
use crate::formats::gltf::GltfError;
use crate::formats::json::{SceneFile, SceneFileError, SceneKind};
use crate::formats::map::MapError;
use crate::formats::obj::ObjError;
use crate::formats::prt::{self, PrtError, PrtFile};
use crate::formats::wad::Archive;
use rustc_hash::FxHashMap;

/// What is wrong with an input file, and where; shown as `NAME:LINE: what`.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{name}{}: {kind}", self.line().map(|line| format!(":{line}")).unwrap_or_default())]
pub struct InputError {
    /// The file's name, as it was given.
    pub name: String,
    /// The rule broken.
    pub kind: InputErrorKind,
}

/// The ways in which an input file can be wrong.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum InputErrorKind {
    /// A file of 0 bytes.
    #[error("the file is empty")]
    Empty,
    /// Not a portal file.
    #[error("{}", .0.kind)]
    Prt(PrtError),
    /// Not a level's source.
    #[error("{}", .0.kind)]
    Map(MapError),
    /// Not a `.obj`.
    #[error("{}", .0.kind)]
    Obj(ObjError),
    /// Not a glTF file.
    #[error("{0}")]
    Gltf(GltfError),
    /// Geometry that breaks a rule.
    #[error("{0}")]
    Statement(Box<StatementError>),
    /// A portal graph where geometry is asked for.
    #[error("the file states no geometry, but cells and portals or nothing known")]
    NoGeometry,
    /// Geometry where a portal graph is asked for.
    #[error("the scene states geometry, but cells and portals are asked for")]
    NoGraph,
    /// Two dimensions where three are asked for.
    #[error("the scene lies in the plane, but one in space is asked for")]
    InThePlane,
    /// Three dimensions where two are asked for.
    #[error("the scene lies in space, but a floorplan is asked for")]
    InSpace,
    /// A floorplan that breaks a rule.
    #[error("{0}")]
    Plan(Box<PlanError>),
    /// Not a JSON scene.
    #[error("{}", .0.without_line())]
    Json(SceneFileError),
    /// A name that two cells of a JSON scene have.
    #[error("cells[{second}]: `{name}` is the name of cells[{first}] too")]
    CellTwice {
        /// The name.
        name: String,
        /// The index of the one cell.
        first: usize,
        /// The index of the other.
        second: usize,
    },
    /// A portal of a JSON scene names a cell that the scene does not have.
    #[error("portals[{portal}].{field}: there is no cell `{name}`")]
    UnknownCell {
        /// The portal.
        portal: usize,
        /// Which of its two cells.
        field: &'static str,
        /// The name.
        name: String,
    },
    /// A portal file or a JSON scene whose portals break a rule.
    #[error("{0}")]
    Scene(Box<SceneError>),
}

impl InputError {
    /// The line of the file, counted from 1, where there is one.
    pub fn line(&self) -> Option<usize> {
        match &self.kind {
            InputErrorKind::Prt(error) => Some(error.line),
            InputErrorKind::Map(error) => Some(error.line),
            InputErrorKind::Json(error) => Some(error.line),
            InputErrorKind::Obj(error) => Some(error.line),
            InputErrorKind::Statement(error) => error.line,
            InputErrorKind::Empty
            | InputErrorKind::Gltf(_)
            | InputErrorKind::NoGeometry
            | InputErrorKind::NoGraph
            | InputErrorKind::InThePlane
            | InputErrorKind::InSpace
            | InputErrorKind::Plan(_)
            | InputErrorKind::CellTwice { .. }
            | InputErrorKind::UnknownCell { .. } => None,
            InputErrorKind::Scene(error) => error.line,
        }
    }
}

/// Reads a portal graph from the bytes of a file called `name`.
///
/// # Errors
/// [`InputError`] names the file, the place and the rule broken.
pub fn read_graph(name: &str, bytes: &[u8]) -> Result<PortalGraph, InputError> {
    let error = |kind| InputError { name: name.to_owned(), kind };
    if bytes.is_empty() {
        return Err(error(InputErrorKind::Empty));
    }
    if Archive::is_archive(bytes) {
        return Err(error(InputErrorKind::InThePlane));
    }
    let raw = if bytes.trim_ascii_start().first() == Some(&b'{') {
        let json = |e| error(InputErrorKind::Json(e));
        match SceneKind::of(bytes).map_err(json)? {
            SceneKind::Graph => {}
            SceneKind::Geometry => return Err(error(InputErrorKind::NoGraph)),
            SceneKind::Plan | SceneKind::PlanGraph => {
                return Err(error(InputErrorKind::InThePlane));
            }
        }
        let file = SceneFile::read(bytes).map_err(json)?;
        named_cells(file).map_err(error)?
    } else {
        RawGraph::from(prt::read(bytes).map_err(|e| error(InputErrorKind::Prt(e)))?)
    };
    PortalGraph::from_raw(raw).map_err(|e| error(InputErrorKind::Scene(Box::new(e))))
}

impl From<PrtFile> for RawGraph {
    fn from(file: PrtFile) -> RawGraph {
        let portals = file.portals.into_iter().map(|portal| RawPortal {
            cells: portal.cells,
            vertices: portal.vertices,
            line: Some(portal.line),
        });
        RawGraph {
            cells: (0..file.cells).map(|cell| cell.to_string()).collect(),
            portals: portals.collect(),
            leaf_to_cell: file.leaf_to_cell,
            declared_grid: None,
        }
    }
}

/// A JSON scene with its cells by number.
fn named_cells(file: SceneFile) -> Result<RawGraph, InputErrorKind> {
    let mut numbers = FxHashMap::default();
    for (second, name) in file.cells.iter().enumerate() {
        if let Some(first) = numbers.insert(name.clone(), second) {
            return Err(InputErrorKind::CellTwice { name: name.clone(), first, second });
        }
    }
    let mut portals = Vec::with_capacity(file.portals.len());
    for (index, portal) in file.portals.into_iter().enumerate() {
        let number = |field, name: String| match numbers.get(&name) {
            Some(&number) => Ok(number as u32),
            None => Err(InputErrorKind::UnknownCell { portal: index, field, name }),
        };
        let cells = [number("from", portal.from)?, number("to", portal.to)?];
        let vertices = portal.polygon.into_iter().map(|vertex| vertex.map(|c| c.0)).collect();
        portals.push(RawPortal { cells, vertices, line: None });
    }
    Ok(RawGraph {
        leaf_to_cell: (0..file.cells.len() as u32).collect(),
        cells: file.cells,
        portals,
        declared_grid: file.grid.map(|grid| grid.0),
    })
}
