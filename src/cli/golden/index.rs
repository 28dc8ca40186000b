//! The index of a golden folder, its hashes, and what has changed in it.

use super::Files;
use crate::formats::blake3;
use crate::report::PvsReport;
use std::path::Path;

/// The list of all other files with their hashes.
pub(super) const HASHES: &str = "hashes.txt";

/// One scene on the index page.
pub(super) struct Row {
    name: String,
    input: String,
    /// Cells, and the counts of ordered pairs; or why the scene was refused.
    result: Result<String, String>,
    /// The bytes of the proof as it is kept.
    proof: Option<(String, usize)>,
    pictures: Vec<String>,
}

impl Row {
    pub(super) fn of(name: &str, path: &Path, files: &Files) -> Row {
        let refused = files.get("refused.txt");
        let result = match (report(files), refused) {
            (Some(report), _) => Ok(counts(&report)),
            (None, refused) => {
                let what = refused.map(|what| String::from_utf8_lossy(what).trim().to_owned());
                Err(what.unwrap_or_default())
            }
        };
        let proof = ["proof.txt", "proof.txt.gz"].into_iter().find_map(|proof| {
            files.get(proof).map(|bytes| (format!("{name}/{proof}"), bytes.len()))
        });
        let pictures = files.keys().filter(|file| file.ends_with(".svg"));
        let pictures = pictures.map(|file| format!("{name}/{file}")).collect();
        Row { name: name.to_owned(), input: super::file_name(path), result, proof, pictures }
    }
}

/// The result among the files of a scene.
pub(super) fn report(files: &Files) -> Option<PvsReport> {
    PvsReport::read(files.get("pvs.json")?).ok()
}

/// The middle columns of a row.
fn counts(report: &PvsReport) -> String {
    let counts = report.matrix.counts();
    let cells = report.cells.len();
    match report.grazing_classified {
        true => format!("{cells} | {} | {} | {}", counts.open, counts.grazing, counts.not_open),
        false => format!("{cells} | {} | | {}", counts.open, counts.not_open),
    }
}

/// The index page: a table of all scenes.
pub(super) fn page(rows: &[Row]) -> String {
    let mut page = String::from(
        "# Golden results\n\n\
         Made by `stabline golden`. Ordered pairs of cells, each cell with itself included; where \
         no grazing pairs are told, they are among those not open. `hashes.txt` lists BLAKE3 \
         hashes.\n\n\
         | scene | cells | open | grazing | not open | proof, bytes | pictures |\n\
         |---|---|---|---|---|---|---|\n",
    );
    for row in rows {
        let shown = row.result.clone().unwrap_or_else(|what| format!("refused: {what} | | |"));
        let scene = match &row.result {
            Ok(_) => format!("[{}]({}/pvs.json)", row.input, row.name),
            Err(_) => row.input.clone(),
        };
        let proof = row.proof.as_ref().map(|(path, size)| format!("[{size}]({path})"));
        let picture = |path: &String| format!("[{}]({path})", super::file_name(Path::new(path)));
        let pictures: Vec<String> = row.pictures.iter().map(picture).collect();
        let (proof, pictures) = (proof.unwrap_or_default(), pictures.join(" "));
        page.push_str(&format!("| {scene} | {shown} | {proof} | {pictures} |\n"));
    }
    page
}

/// One line a file: its hash and its path.
pub(super) fn hashes(files: &Files) -> String {
    files.iter().map(|(name, bytes)| format!("{}  {name}\n", blake3::hex(bytes))).collect()
}

/// The paths in a list of hashes.
pub(super) fn listed(hashes: &[u8]) -> Vec<String> {
    let text = String::from_utf8_lossy(hashes);
    text.lines().filter_map(|line| line.split_once("  ")).map(|(_, name)| name.to_owned()).collect()
}

/// What differs between what is kept and what comes out.
pub(super) struct Drift {
    lines: Vec<String>,
    files: usize,
}

impl Drift {
    pub(super) fn is_none(&self) -> bool {
        self.lines.is_empty()
    }

    pub(super) fn text(&self) -> String {
        if self.is_none() {
            return format!("no drift: {} files are as they were\n", self.files);
        }
        self.lines.iter().map(|line| format!("{line}\n")).collect()
    }
}

/// Compares the two; files that no earlier run made are nothing of ours.
pub(super) fn drift(kept: &Files, made: &Files) -> Drift {
    let mut lines = Vec::new();
    for (name, bytes) in made {
        match kept.get(name) {
            None => lines.push(format!("new: {name}")),
            Some(old) if old == bytes => {}
            // The list differs because of others.
            Some(_) if name == HASHES => {}
            Some(old) => {
                lines.push(format!("changed: {name}"));
                if name.ends_with("pvs.json") {
                    lines.extend(changed_pairs(old, bytes));
                }
            }
        }
    }
    let listed = kept.get(HASHES).map(|hashes| listed(hashes)).unwrap_or_default();
    let gone = listed.iter().filter(|name| !made.contains_key(*name));
    lines.extend(gone.map(|name| format!("gone: {name}")));
    let lost = made.keys().filter(|name| listed.contains(name) && !kept.contains_key(*name));
    lines.extend(lost.map(|name| format!("lost: {name} is listed and not there")));
    Drift { lines, files: made.len() }
}

/// The most pairs that are named.
const MOST_PAIRS: usize = 20;

fn changed_pairs(old: &[u8], new: &[u8]) -> Vec<String> {
    let (Ok(old), Ok(new)) = (PvsReport::read(old), PvsReport::read(new)) else {
        return vec!["  what is kept is no result".to_owned()];
    };
    if old.cells != new.cells {
        return vec![format!("  {} cells, now {}", old.cells.len(), new.cells.len())];
    }
    let cells = old.cells.len();
    let pairs = (0..cells).flat_map(|a| (0..cells).map(move |b| (a, b)));
    let changed: Vec<(usize, usize)> =
        pairs.filter(|&(a, b)| old.matrix.get(a, b) != new.matrix.get(a, b)).collect();
    let shown = changed.iter().take(MOST_PAIRS).map(|&(a, b)| {
        let (was, is) = (old.matrix.get(a, b), new.matrix.get(a, b));
        format!("  {} -> {}: {was:?}, now {is:?}", old.cells[a], old.cells[b])
    });
    let mut lines: Vec<String> = shown.collect();
    if changed.len() > MOST_PAIRS {
        lines.push(format!("  and {} pairs more", changed.len() - MOST_PAIRS));
    }
    lines
}
