//! Reading inputs whole, and writing outputs whole or not at all.
//!
//! Invariant: a file that the user named holds either what it held before or the complete output.
//! Output goes to a temporary name in the same folder and is renamed once everything is written.

use super::exit::Failure;
use super::{doom, interrupt};
use crate::report::PvsReport;
use crate::scene::{CellId, PortalGraph};
use std::fs::{self, File, OpenOptions};
use std::io::{self, BufWriter, Read, Write};
use std::path::{Path, PathBuf};

/// An input file in memory.
#[derive(Clone, Debug)]
pub(super) struct Input {
    /// The path as it was given, for error messages.
    pub name: String,
    /// The file's bytes.
    pub bytes: Vec<u8>,
    /// The map that was named, where the file is an archive of Doom.
    pub map: Option<String>,
}

impl Input {
    /// Reads the file at `path`, or standard input for `-`; `FILE:MAP` names a map of an archive.
    pub(super) fn read(path: &Path) -> Result<Input, Failure> {
        let (file, map) = doom::split_map(path);
        let bytes = if path == Path::new("-") {
            let mut bytes = Vec::new();
            io::stdin().lock().read_to_end(&mut bytes).map(|_| bytes)
        } else {
            fs::read(&file)
        };
        let bytes = bytes.map_err(|error| Failure::system("read", &file, &error))?;
        let name = path.display().to_string();
        doom::check_map(&bytes, map.as_deref()).map_err(|what| Failure::file(&name, what))?;
        Ok(Input { name, bytes, map })
    }

    /// The file's name without its folders: results carry no path of a machine.
    pub(super) fn file_name(&self) -> String {
        file_name(Path::new(&self.name))
    }

    /// The file as a result.
    pub(super) fn report(&self) -> Result<PvsReport, Failure> {
        PvsReport::read(&self.bytes).map_err(|error| match error.line() {
            Some(line) => Failure::file(&format!("{}:{line}", self.name), error.without_line()),
            None => Failure::file(&self.name, error),
        })
    }
}

/// The last part of a path.
pub(super) fn file_name(path: &Path) -> String {
    path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned()
}

/// The cell of the graph in `file` that an argument names: by its name, or by its number.
pub(super) fn cell(graph: &PortalGraph, file: &str, text: &str) -> Result<CellId, Failure> {
    cell_of(&graph.cells, file, text)
}

/// The same, of cells by their names.
pub(super) fn cell_of(cells: &[String], file: &str, text: &str) -> Result<CellId, Failure> {
    let by_name = cells.iter().position(|name| name == text);
    let by_number = || text.parse().ok().filter(|&index: &usize| index < cells.len());
    match by_name.or_else(by_number) {
        Some(index) => Ok(CellId(index as u32)),
        None => Err(Failure::usage(format!(
            "no cell {text:?} in {file}, expected a name or a number below {}",
            cells.len()
        ))),
    }
}

/// Writes an output to the file at `path`, or to standard output for `-` or without a path.
pub(super) fn write(
    path: Option<&Path>,
    content: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> Result<(), Failure> {
    match path {
        Some(path) if path != Path::new("-") => {
            write_file(path, content).map_err(|error| Failure::system("write", path, &error))
        }
        _ => write_standard_output(content),
    }
}

/// Checks the outputs that were asked for before the work for them begins: each could be written
/// now, and no two are one. Whether one of them is standard output, which then holds it alone.
pub(super) fn check_outputs<'a>(
    paths: impl IntoIterator<Item = &'a Option<PathBuf>>,
) -> Result<bool, Failure> {
    let paths: Vec<&Path> = paths.into_iter().filter_map(Option::as_deref).collect();
    for (index, path) in paths.iter().enumerate() {
        if paths[..index].contains(path) {
            return Err(Failure::usage(format!("{}: the name of two outputs", path.display())));
        }
        if *path != Path::new("-") {
            let checked = target(path).and_then(|target| match target {
                Target::Stream(_) => Ok(()),
                Target::File(path) => Temporary::create(&path).map(drop),
            });
            checked.map_err(|error| Failure::system("write", path, &error))?;
        }
    }
    Ok(paths.contains(&Path::new("-")))
}

/// Prints `text` to standard output.
pub(super) fn print(text: &str) -> Result<(), Failure> {
    write(None, |out| out.write_all(text.as_bytes()))
}

fn write_standard_output(
    content: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> Result<(), Failure> {
    let mut out = BufWriter::with_capacity(1 << 16, io::stdout().lock());
    match content(&mut out).and_then(|()| out.flush()) {
        Ok(()) => Ok(()),
        // The reader has seen enough, as `head` does: no error of ours.
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
        Err(error) => Err(Failure::system("write", Path::new("standard output"), &error)),
    }
}

/// What a path of an output names.
enum Target {
    /// A device or a pipe: it cannot be replaced by renaming, and holds nothing to protect.
    Stream(PathBuf),
    /// A file that is there and may be replaced, or is not there yet.
    File(PathBuf),
}

fn target(path: &Path) -> io::Result<Target> {
    // A link is written through, as every other program does.
    let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    match fs::metadata(&target) {
        Ok(found) if found.is_dir() => Err(io::Error::from(io::ErrorKind::IsADirectory)),
        Ok(found) if !found.is_file() => Ok(Target::Stream(target)),
        Ok(found) if found.permissions().readonly() => {
            Err(io::Error::new(io::ErrorKind::PermissionDenied, "the file is read-only"))
        }
        Ok(_) | Err(_) => Ok(Target::File(target)),
    }
}

fn write_file(
    path: &Path,
    content: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> io::Result<()> {
    match target(path)? {
        Target::Stream(target) => {
            let mut out = BufWriter::new(OpenOptions::new().write(true).open(&target)?);
            content(&mut out)?;
            out.flush()
        }
        Target::File(target) => {
            let mut temporary = Temporary::create(&target)?;
            content(&mut temporary.writer)?;
            temporary.commit(&target)
        }
    }
}

/// A file under a temporary name, removed when dropped.
struct Temporary {
    path: PathBuf,
    writer: BufWriter<File>,
}

impl Temporary {
    fn create(target: &Path) -> io::Result<Temporary> {
        let name = target.file_name().ok_or(io::ErrorKind::InvalidFilename)?.to_string_lossy();
        let path = target.with_file_name(format!(".{name}.{}.partial", std::process::id()));
        let file = OpenOptions::new().write(true).create_new(true).open(&path)?;
        interrupt::remember(&path);
        Ok(Temporary { path, writer: BufWriter::with_capacity(1 << 16, file) })
    }

    fn commit(mut self, target: &Path) -> io::Result<()> {
        self.writer.flush()?;
        fs::rename(&self.path, target)
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        // After `commit` the name is gone, and there is nothing to remove.
        let _ = fs::remove_file(&self.path);
        interrupt::forget(&self.path);
    }
}
