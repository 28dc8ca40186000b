//! Any file that holds a portal graph, told apart by its first bytes.

use super::{PortalGraph, RawGraph, RawPortal, SceneError};
use crate::formats::prt::{self, PrtError, PrtFile};

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
    #[error("the file is empty, expected a portal file or a JSON scene")]
    Empty,
    /// Not a portal file.
    #[error("{}", .0.kind)]
    Prt(PrtError),
    /// A portal file or a JSON scene whose portals break a rule.
    #[error(transparent)]
    Scene(Box<SceneError>),
}

impl InputError {
    /// The line of the file, counted from 1, where there is one.
    pub fn line(&self) -> Option<usize> {
        match &self.kind {
            InputErrorKind::Empty => None,
            InputErrorKind::Prt(error) => Some(error.line),
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
    let raw = RawGraph::from(prt::read(bytes).map_err(|e| error(InputErrorKind::Prt(e)))?);
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
