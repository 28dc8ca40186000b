//! `stabline golden`: reference results of many scenes, kept and compared.

mod index;

use super::exit::{Exit, Failure};
use super::files::{self, Input, file_name};
use super::progress::ProgressArgs;
use crate::draw::draw_matrix;
use crate::report::{Progress, PvsReport};
use crate::scene::world::InputKind;
use std::collections::BTreeMap;
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};

/// Keep the PVS, the proof, pictures and hashes of scenes in a folder, or report what has changed
///
/// An empty or new DIR is filled. In one that was filled before nothing is changed: files that
/// would come out otherwise are listed, pairs with another verdict by name, and the exit code is 1.
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    /// The folder
    directory: PathBuf,
    /// Scenes, or folders of scenes: all that `pvs` reads, as they are named below DIR
    #[arg(required = true)]
    scenes: Vec<PathBuf>,
    /// Split the pairs that are not open into grazing and blocked
    #[arg(long)]
    grazing: bool,
    /// Replace what is kept by what comes out now
    #[arg(long)]
    update: bool,
    #[command(flatten)]
    progress: ProgressArgs,
}

/// Files by their paths below the folder, with `/` between the parts on every system.
type Files = BTreeMap<String, Vec<u8>>;

pub(super) fn run(args: &Args) -> Result<Exit, Failure> {
    let scenes = scenes(&args.scenes)?;
    let reporter = args.progress.reporter();
    reporter.begin("scenes", scenes.len() as u64);
    let mut made = Files::new();
    let mut rows = Vec::new();
    for (name, path) in &scenes {
        if reporter.is_interrupted() {
            return Err(Failure::Interrupted);
        }
        let files = results(args, path)?;
        rows.push(index::Row::of(name, path, &files));
        made.extend(files.into_iter().map(|(file, bytes)| (format!("{name}/{file}"), bytes)));
        reporter.advance(1);
    }
    drop(reporter);
    made.insert("index.md".to_owned(), index::page(&rows).into_bytes());
    let hashes = index::hashes(&made);
    made.insert(index::HASHES.to_owned(), hashes.into_bytes());
    let kept = kept(&args.directory)?;
    if kept.is_empty() || args.update {
        replace(&args.directory, &kept, &made)?;
        files::print(&format!(
            "{}: {} files of {} scenes\n",
            args.directory.display(),
            made.len(),
            rows.len()
        ))?;
        return Ok(Exit::Done);
    }
    let drift = index::drift(&kept, &made);
    files::print(&drift.text())?;
    Ok(if drift.is_none() { Exit::Done } else { Exit::Drift })
}

/// The scenes, by the names that they have in the folder: those of the arguments, or their paths
/// below the folder that is an argument, without their extensions.
fn scenes(arguments: &[PathBuf]) -> Result<BTreeMap<String, PathBuf>, Failure> {
    let mut scenes = BTreeMap::new();
    for argument in arguments {
        let mut found = Vec::new();
        if argument.is_dir() {
            walk(argument, &mut found)
                .map_err(|error| Failure::system("read", argument, &error))?;
        } else {
            found.push(argument.clone());
        }
        for path in found {
            let below = path.strip_prefix(argument).unwrap_or(&path);
            let below = if argument.is_dir() {
                below
            } else {
                Path::new(path.file_name().unwrap_or_default())
            };
            let parts: Vec<_> = below.iter().map(|part| part.to_string_lossy()).collect();
            let name = parts.join("/").replace(':', "_");
            // The extension stays where another scene has the same name without.
            let stem = name.rsplit_once('.').map_or(name.as_str(), |(stem, _)| stem).to_owned();
            let name = if scenes.contains_key(&stem) { name } else { stem };
            if let Some(other) = scenes.insert(name.clone(), path.clone()) {
                return Err(Failure::usage(format!(
                    "{} and {} have both the name {name}",
                    other.display(),
                    path.display()
                )));
            }
        }
    }
    Ok(scenes)
}

/// The files below a folder that are scenes, in the order of their names.
fn walk(folder: &Path, found: &mut Vec<PathBuf>) -> std::io::Result<()> {
    let entries: Result<Vec<_>, _> = fs::read_dir(folder)?.collect();
    let mut paths: Vec<PathBuf> = entries?.into_iter().map(|entry| entry.path()).collect();
    paths.sort();
    for path in paths {
        if path.is_dir() {
            walk(&path, found)?;
        } else if is_scene(&path)? {
            found.push(path);
        }
    }
    Ok(())
}

/// Whether `pvs` reads files like this one; archives of Doom have to be named with their map.
fn is_scene(path: &Path) -> std::io::Result<bool> {
    let extension = path.extension().and_then(|extension| extension.to_str()).unwrap_or_default();
    Ok(match extension {
        "prt" | "map" | "obj" | "gltf" | "glb" => true,
        "json" => {
            let bytes = fs::read(path)?;
            let kind = InputKind::of(&path.display().to_string(), &bytes);
            let known = kind.is_ok_and(|kind| {
                matches!(kind, InputKind::Graph | InputKind::Plan | InputKind::Geometry)
            });
            let text: serde_json::Result<serde_json::Value> = serde_json::from_slice(&bytes);
            known && text.is_ok_and(|text| text["format"] == "stabline-scene/1")
        }
        _ => false,
    })
}

/// What comes out of one scene; where it is refused, the refusal.
fn results(args: &Args, path: &Path) -> Result<Files, Failure> {
    let work = tempfile_folder(&args.directory)?;
    let in_work = |name: &str| work.0.join(name).into_os_string();
    let mut words: Vec<OsString> =
        vec!["pvs".into(), path.into(), "-o".into(), in_work("pvs.json")];
    words.extend([
        "--proof".into(),
        work.0.clone().into_os_string(),
        "--progress".into(),
        "none".into(),
    ]);
    let input = Input::read(path)?;
    let is_plan = super::plan::is_plan(&input);
    if args.grazing {
        words.push("--grazing".into());
    }
    if input.map.is_some() {
        words.extend(["--cells".into(), "subsectors".into()]);
    }
    let mut files = Files::new();
    match super::run_command(&words) {
        Ok(_) => {}
        Err(Failure::Input(what)) => {
            // What is wrong with a scene says where, but not in which folder it lies.
            let what = what.replace(&path.display().to_string(), &file_name(path));
            files.insert("refused.txt".to_owned(), format!("{what}\n").into_bytes());
            return Ok(files);
        }
        Err(failure) => return Err(failure),
    }
    if is_plan {
        let words = ["draw".into(), path.into(), "-o".into(), in_work("plan.svg")];
        super::run_command(&words)?;
    }
    for entry in fs::read_dir(&work.0).map_err(|error| Failure::system("read", &work.0, &error))? {
        let path = entry.map_err(|error| Failure::system("read", &work.0, &error))?.path();
        let bytes = fs::read(&path).map_err(|error| Failure::system("read", &path, &error))?;
        files.insert(file_name(&path), bytes);
    }
    let report = index::report(&files)
        .ok_or_else(|| Failure::file(&path.display().to_string(), "no result came out"))?;
    if report.cells.len() <= MOST_CELLS {
        files.insert("matrix.svg".to_owned(), matrix(&report).into_bytes());
    }
    Ok(files)
}

/// The most cells whose matrix is drawn: beyond, a cell is thinner than a line.
const MOST_CELLS: usize = 1024;

fn matrix(report: &PvsReport) -> String {
    let rows: Vec<Vec<u8>> = (0..report.matrix.size())
        .map(|cell| report.matrix.row(cell).iter().map(|verdict| *verdict as u8).collect())
        .collect();
    draw_matrix(&rows, &format!("{}: {} cells", report.input.name, report.cells.len()))
}

/// A folder that vanishes with its content.
struct Work(PathBuf);

impl Drop for Work {
    fn drop(&mut self) {
        // What cannot be removed stays under a name that says what it is.
        let _ = fs::remove_dir_all(&self.0);
    }
}

fn tempfile_folder(beside: &Path) -> Result<Work, Failure> {
    let name = format!("{}.{}.partial", file_name(beside), std::process::id());
    let path = beside.with_file_name(format!(".{name}"));
    fs::create_dir_all(&path).map_err(|error| Failure::system("write", &path, &error))?;
    Ok(Work(path))
}

/// The files that the folder holds.
fn kept(folder: &Path) -> Result<Files, Failure> {
    let mut kept = Files::new();
    let mut folders = vec![(folder.to_owned(), String::new())];
    while let Some((path, prefix)) = folders.pop() {
        if !path.exists() {
            continue;
        }
        let unreadable = |error: std::io::Error| Failure::system("read", &path, &error);
        for entry in fs::read_dir(&path).map_err(unreadable)? {
            let inner = entry.map_err(unreadable)?.path();
            let name = format!("{prefix}{}", file_name(&inner));
            if inner.is_dir() {
                folders.push((inner, format!("{name}/")));
            } else {
                kept.insert(name, fs::read(&inner).map_err(unreadable)?);
            }
        }
    }
    Ok(kept)
}

/// Writes what was made and removes what it does not have any more; only what an earlier run
/// listed is ever removed.
fn replace(folder: &Path, kept: &Files, made: &Files) -> Result<(), Failure> {
    for (name, bytes) in made.iter().filter(|(name, bytes)| kept.get(*name) != Some(*bytes)) {
        let path = folder.join(name);
        let parent = path.parent().unwrap_or(folder);
        fs::create_dir_all(parent).map_err(|error| Failure::system("write", parent, &error))?;
        files::write(Some(&path), |out| out.write_all(bytes))?;
    }
    let listed = kept.get(index::HASHES).map(|bytes| index::listed(bytes)).unwrap_or_default();
    for name in listed.iter().filter(|name| kept.contains_key(*name) && !made.contains_key(*name)) {
        let path = folder.join(name);
        fs::remove_file(&path).map_err(|error| Failure::system("write", &path, &error))?;
    }
    Ok(())
}
