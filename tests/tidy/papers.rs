//! Documents, scenes and snapshots: links lead somewhere, scenes and snapshots belong to each
//! other, the glossary's words are used and its refused words are not.

use crate::layers::LAYERS;
use crate::source::{Source, words};
use std::path::{Component, Path, PathBuf};

/// Relative links of a Markdown text that lead nowhere.
pub fn dead_links(path: &str, text: &str, exists: impl Fn(&str) -> bool) -> Vec<String> {
    let mut wrong = Vec::new();
    for (at, _) in text.match_indices("](") {
        let target = text[at + 2..].split(')').next().unwrap_or_default();
        let file = target.split('#').next().unwrap_or_default();
        if file.is_empty() || target.contains("://") {
            continue;
        }
        let folder = Path::new(path).parent().unwrap_or(Path::new(""));
        if !exists(&normal(&folder.join(file))) {
            wrong.push(format!("{path}: the link to {target} leads nowhere"));
        }
    }
    wrong
}

/// The path without `..`.
fn normal(path: &Path) -> String {
    let mut parts: Vec<String> = Vec::new();
    for component in path.components() {
        match component {
            Component::ParentDir => drop(parts.pop()),
            Component::Normal(part) => parts.push(part.to_string_lossy().into_owned()),
            Component::CurDir | Component::RootDir | Component::Prefix(_) => {}
        }
    }
    parts.join("/")
}

/// The formats of scenes.
pub const SCENE_ENDINGS: &[&str] = &["json", "map", "obj", "glb"];

/// Snapshots without their scene, and snapshots that wait for a review. Several of one scene have
/// a suffix: `name@suffix.snap`.
pub fn orphan_snapshots(snapshots: &[String], exists: impl Fn(&str) -> bool) -> Vec<String> {
    let mut wrong = Vec::new();
    for path in snapshots {
        let scene = PathBuf::from(path.replacen("snapshots/", "scenes/", 1));
        let stem = scene.with_extension("").to_string_lossy().into_owned();
        let stem = stem.split('@').next().unwrap_or_default().to_owned();
        let of = |ending: &str| normal(Path::new(&format!("{stem}.{ending}")));
        if path.ends_with(".new") {
            wrong.push(format!("{path}: review it (`cargo insta review`)"));
        } else if !SCENE_ENDINGS.iter().any(|ending| exists(&of(ending))) {
            wrong.push(format!("{path}: {} is gone", of("json")));
        }
    }
    wrong
}

/// What is wrong with a scene: its name, its first field, or that no program reads it.
pub fn scene(path: &str, text: &str, programs: &[String]) -> Vec<String> {
    let mut wrong = Vec::new();
    let (folder, name) = path.rsplit_once('/').unwrap_or(("", path));
    let (stem, ending) = name.rsplit_once('.').unwrap_or((name, ""));
    let fine = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || "_-".contains(c);
    if !stem.chars().all(fine) || !stem.contains('_') {
        wrong.push(format!("{path}: expected a name <subject>_<situation>[_<degeneracy>].json"));
    }
    let first = text.trim_start().strip_prefix('{').unwrap_or_default().trim_start();
    let opening = match ending {
        "map" if !text.starts_with("// ") => "does not open with a comment",
        "obj" if !text.starts_with("# ") => "does not open with a comment",
        "json" if !first.starts_with("\"about\": \"") => "does not open with the field `about`",
        // Bytes hold no comment; the test that reads them does.
        _ => "",
    };
    if !opening.is_empty() {
        wrong.push(format!("{path}: it {opening}"));
    }
    let whole_folder = format!("\"{folder}\"");
    let reads = |program: &String| program.contains(path) || program.contains(&whole_folder);
    if !programs.iter().any(reads) {
        wrong.push(format!("{path}: no test, example or page reads it"));
    }
    wrong
}

/// A row of `docs/glossary.md`.
struct Entry<'a> {
    word: &'a str,
    refused: Vec<&'a str>,
}

/// The rows `| word | meaning | refused words in backticks |`.
fn glossary(text: &str) -> Vec<Entry<'_>> {
    let rows = text.lines().filter(|line| line.starts_with("| ") && !line.starts_with("| word |"));
    rows.filter_map(|row| {
        let cells: Vec<&str> = row.trim_matches('|').split('|').map(str::trim).collect();
        let [word, _, refused] = cells.as_slice() else { return None };
        Some(Entry { word, refused: refused.split('`').skip(1).step_by(2).collect() })
    })
    .collect()
}

/// Words of the glossary out of order or unused, and words that it refuses.
pub fn glossary_words(text: &str, sources: &[Source]) -> Vec<String> {
    let entries = glossary(text);
    let mut wrong = Vec::new();
    if entries.is_empty() {
        wrong.push("docs/glossary.md: no row was understood".to_owned());
    }
    for pair in entries.windows(2) {
        if pair[0].word.to_lowercase() >= pair[1].word.to_lowercase() {
            wrong.push(format!("docs/glossary.md: `{}` is out of order", pair[1].word));
        }
    }
    let lower: Vec<(&str, Vec<String>)> = sources
        .iter()
        .filter(|source| source.path.starts_with("src/"))
        .map(|source| {
            (source.path.as_str(), source.lines.iter().map(|l| l.to_lowercase()).collect())
        })
        .collect();
    for entry in &entries {
        let word = entry.word.to_lowercase();
        if !lower.iter().any(|(_, lines)| lines.iter().any(|line| line.contains(&word))) {
            wrong.push(format!("docs/glossary.md: nothing in src speaks of `{}`", entry.word));
        }
        for (path, lines) in &lower {
            for (line, number) in lines.iter().zip(1..) {
                for refused in entry.refused.iter().filter(|w| words(line, w).next().is_some()) {
                    let word = entry.word;
                    wrong.push(format!("{path}:{number}: `{refused}` is called `{word}` here"));
                }
            }
        }
    }
    wrong
}

/// Rows of the import table that ARCHITECTURE.md does not have, as `| `a` | b, c |`.
pub fn table_of_layers(text: &str) -> Vec<String> {
    let rows = LAYERS.iter().map(|(layer, allowed)| {
        let allowed = if allowed.is_empty() { "nothing".to_owned() } else { allowed.join(", ") };
        format!("| `{layer}` | {allowed} |")
    });
    let missing = rows.filter(|row| !text.contains(row.as_str()));
    missing.map(|row| format!("ARCHITECTURE.md: the import table lacks {row}")).collect()
}

#[test]
fn links_orphans_and_scenes_are_judged() {
    let exists = |path: &str| path == "docs/a.md";
    let text = "[a](docs/a.md#x) [b](docs/b.md) [c](https://x) [d](#y)";
    assert_eq!(dead_links("README.md", text, exists).len(), 1);
    assert!(dead_links("docs/formats/x.md", "[a](../a.md)", exists).is_empty());

    let exists = |path: &str| path == "scenes/pvs/a_b.json";
    let snapshots = [
        "snapshots/pvs/a_b.snap",
        "snapshots/pvs/a_b@more.snap",
        "snapshots/pvs/c.snap",
        "snapshots/pvs/c@a_b.snap",
        "snapshots/pvs/d.snap.new",
    ];
    assert_eq!(orphan_snapshots(&snapshots.map(str::to_owned), exists).len(), 3);

    let programs = ["read(\"scenes/pvs\")".to_owned()];
    assert!(scene("scenes/pvs/a_b.json", "{\"about\": \"x\"}", &programs).is_empty());
    assert_eq!(scene("scenes/pvs/case17.json", "{\"about\": \"x\"}", &programs).len(), 1);
    assert_eq!(scene("scenes/pvs/a_b.json", "{\"cells\": []}", &programs).len(), 1);
    assert_eq!(scene("scenes/stab/a_b.json", "{\"about\": \"x\"}", &programs).len(), 1);
}

#[test]
fn the_glossary_is_judged() {
    let text =
        "| word | meaning | not |\n|---|---|---|\n| cell | a | `area` |\n| portal | b | `gate` |";
    let judged = |code: &str| glossary_words(text, &[Source::new("src/a.rs", code)]);
    assert!(judged("// The cell's portals.").is_empty());
    assert_eq!(judged("// The cell's portals: an area with a gate.").len(), 2);
    assert_eq!(judged("// The cell.").len(), 1);
    assert_eq!(table_of_layers("").len(), LAYERS.len());
}
