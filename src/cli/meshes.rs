//! Meshes written for other programs, whose formats round.

use super::exit::Failure;
use super::files;
use crate::formats::mesh::MeshGroup;
use crate::num::Rational;
use std::io::{self, Write};
use std::path::Path;

/// A writer of a mesh's format; it returns how far it moved a coordinate at most.
pub(super) type Writer = fn(&[MeshGroup], &mut dyn Write) -> io::Result<Rational>;

/// Writes a mesh to a file; how far its coordinates were moved at most.
pub(super) fn write(path: &Path, groups: &[MeshGroup], write: Writer) -> Result<Rational, Failure> {
    let mut largest = Rational::default();
    files::write(Some(path), |out| {
        largest = write(groups, out)?;
        Ok(())
    })?;
    Ok(largest)
}
