//! Reading the files of vectors.

use crate::cli::exit::Failure;
use crate::cli::files::Input;
use crate::formats::blake3;
use crate::vectors::{ScoredFile, VectorsFile};
use std::path::{Path, PathBuf};

/// A file of vectors, read.
pub(super) struct Loaded {
    /// What results call it.
    pub scored: ScoredFile,
    /// What it holds.
    pub vectors: VectorsFile,
}

/// Reads and checks a file.
pub(super) fn load(path: &Path) -> Result<Loaded, Failure> {
    let input = Input::read(path)?;
    let vectors =
        VectorsFile::read(&input.bytes).map_err(|error| Failure::file(&input.name, error))?;
    let scored = ScoredFile { name: input.file_name(), blake3: blake3::hex(&input.bytes) };
    Ok(Loaded { scored, vectors })
}

/// The files that are named, or those in the folder `vectors`.
pub(super) fn load_all(named: &[PathBuf]) -> Result<Vec<Loaded>, Failure> {
    let mut paths = named.to_vec();
    if paths.is_empty() {
        let folder = Path::new("vectors");
        let entries = std::fs::read_dir(folder).map_err(|error| {
            let what = format!("vectors: {error}; name files of vectors with --file");
            Failure::usage(what)
        })?;
        let found = entries.filter_map(Result::ok).map(|entry| entry.path());
        paths.extend(found.filter(|path| path.extension().is_some_and(|ending| ending == "json")));
        paths.sort();
    }
    paths.iter().map(|path| load(path)).collect()
}
