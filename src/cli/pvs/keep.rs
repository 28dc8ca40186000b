//! Finished cells on disk: kept as they come, taken over by the next run.

use super::super::exit::{Exit, Failure};
use super::super::files::{self, Input};
use super::Args;
use crate::pvs::{Finished, Part, PartHeader, Row};
use crate::scene::PortalGraph;
use std::collections::BTreeMap;
use std::fs::{self, File, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::Mutex;

/// The rows that earlier runs finished, and where this run's are kept.
pub(super) struct Keeper {
    done: Vec<Row>,
    kept: Option<Mutex<Kept>>,
}

struct Kept {
    path: PathBuf,
    file: File,
    /// The first error of writing; nothing is written after it.
    failed: Option<io::Error>,
}

impl Keeper {
    /// Reads the parts named by `--merge` and those in the folder of `--resume`, and opens a new
    /// part there.
    pub(super) fn open(
        args: &Args,
        header: &PartHeader,
        graph: &PortalGraph,
    ) -> Result<Keeper, Failure> {
        let mut parts = args.merge.clone();
        if let Some(folder) = &args.resume {
            parts.extend(parts_in(folder)?);
        }
        let mut rows = BTreeMap::new();
        for path in &parts {
            for row in read_part(path, header, graph)? {
                rows.insert(row.source, row);
            }
        }
        let kept = match &args.resume {
            Some(folder) => Some(Mutex::new(Kept::create(folder, header)?)),
            None => None,
        };
        Ok(Keeper { done: rows.into_values().collect(), kept })
    }

    /// The rows that are there already.
    pub(super) fn done(&self) -> Vec<Row> {
        self.done.clone()
    }

    /// Keeps a row, if a folder was named.
    pub(super) fn keep(&self, row: &Row) {
        let Some(Ok(mut kept)) = self.kept.as_ref().map(Mutex::lock) else { return };
        if kept.failed.is_none() {
            let line = row.to_line().map_err(io::Error::from);
            let written = line.and_then(|line| kept.file.write_all(line.as_bytes()));
            kept.failed = written.err();
        }
    }

    /// Whether everything was kept.
    pub(super) fn check(&self) -> Result<(), Failure> {
        match self.kept.as_ref().map(Mutex::lock) {
            Some(Ok(kept)) => match &kept.failed {
                Some(error) => Err(Failure::system("write", &kept.path, error)),
                None => Ok(()),
            },
            Some(Err(_)) | None => Ok(()),
        }
    }

    /// Ends an interrupted run: without a folder of `--resume`, the finished rows go into a part
    /// beside the output that was asked for.
    pub(super) fn interrupted(
        &self,
        args: &Args,
        header: &PartHeader,
        finished: &Finished,
    ) -> Result<Exit, Failure> {
        let rows = finished.rows.len();
        let how = match &args.resume {
            Some(folder) => format!("--resume {}", folder.display()),
            None => {
                let beside = args.output.as_ref().or(args.npy.as_ref()).unwrap_or(&args.input);
                let folder = match beside == &args.input {
                    true => Path::new(""),
                    false => beside.parent().unwrap_or(Path::new("")),
                };
                let path = folder.join(format!("{}.part.jsonl", files::file_name(beside)));
                write_part(Some(&path), header, &finished.rows)?;
                format!("--merge {}", path.display())
            }
        };
        let message = format!("interrupted: {rows} finished cells are kept; go on with {how}");
        // Nothing is left to be told if standard error is closed as well.
        let _ = writeln!(io::stderr(), "{message}");
        Ok(Exit::Interrupted)
    }
}

impl Kept {
    fn create(folder: &Path, header: &PartHeader) -> Result<Kept, Failure> {
        let failed = |path: &Path, error: io::Error| Failure::system("write", path, &error);
        fs::create_dir_all(folder).map_err(|error| failed(folder, error))?;
        let mut number = 0;
        let (path, mut file) = loop {
            let path = folder.join(format!("part-{number:04}.jsonl"));
            match OpenOptions::new().write(true).create_new(true).open(&path) {
                Ok(file) => break (path, file),
                // Another run, an earlier one or one at the same time, has this number.
                Err(error) if error.kind() == io::ErrorKind::AlreadyExists => number += 1,
                Err(error) => return Err(failed(&path, error)),
            }
        };
        let line = header.to_line().map_err(io::Error::from);
        line.and_then(|line| file.write_all(line.as_bytes()))
            .map_err(|error| failed(&path, error))?;
        Ok(Kept { path, file, failed: None })
    }
}

fn parts_in(folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    let entries = match fs::read_dir(folder) {
        Ok(entries) => entries,
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(Vec::new()),
        Err(error) => return Err(Failure::system("read", folder, &error)),
    };
    let mut paths = Vec::new();
    for entry in entries {
        let path = entry.map_err(|error| Failure::system("read", folder, &error))?.path();
        if path.extension().is_some_and(|extension| extension == "jsonl") {
            paths.push(path);
        }
    }
    paths.sort();
    Ok(paths)
}

fn read_part(path: &Path, header: &PartHeader, graph: &PortalGraph) -> Result<Vec<Row>, Failure> {
    let input = Input::read(path)?;
    let text = std::str::from_utf8(&input.bytes)
        .map_err(|_| Failure::file(&input.name, "not text, expected the lines of a part"))?;
    if !text.contains('\n') {
        // A run that was ended before its first line was out has kept nothing.
        return Ok(Vec::new());
    }
    let part = Part::read(text, graph)
        .map_err(|error| Failure::file(&format!("{}:{}", input.name, error.line), error))?;
    if part.header.input.blake3 != header.input.blake3
        || part.header.reading != header.reading
        || part.header.budget != header.budget
        || part.header.program != header.program
    {
        return Err(Failure::file(
            &format!("{}:1", input.name),
            "the part of another input, read or divided otherwise, of another budget or another version \
             of the program",
        ));
    }
    Ok(part.rows)
}

/// Writes rows as a part, to a file or to standard output.
pub(super) fn write_part(
    path: Option<&Path>,
    header: &PartHeader,
    rows: &[Row],
) -> Result<(), Failure> {
    files::write(path, |out| {
        out.write_all(header.to_line()?.as_bytes())?;
        rows.iter().try_for_each(|row| out.write_all(row.to_line()?.as_bytes()))
    })
}
