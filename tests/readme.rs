//! The README's examples: every `$ stabline …` prints what the README shows below it.

mod support;

use stabline::formats::wad::MapForm;
use std::path::Path;
use support::wads::four_rooms;
use support::{level, root, stabline, three_rooms_result};

/// The commands of the console blocks, with the output that follows each.
fn examples(readme: &str) -> Vec<(Vec<&str>, String)> {
    let blocks = readme.split("```console\n").skip(1);
    let lines = blocks.flat_map(|rest| rest.split("```").next().unwrap_or_default().lines());
    let mut examples: Vec<(Vec<&str>, String)> = Vec::new();
    for line in lines {
        if let Some(command) = line.strip_prefix("$ stabline ") {
            examples.push((command.split(' ').collect(), String::new()));
        } else if let Some((_, output)) = examples.last_mut() {
            output.push_str(line);
            output.push('\n');
        }
    }
    examples
}

/// A table with one hole and two pairs of waste, made of the exact one for the gallery.
fn spoil(exact: &Path, spoiled: &Path) {
    let mut bytes = std::fs::read(exact).unwrap();
    let start = bytes.len() - 9 * 9;
    for (row, column, digit) in [(2, 7, 2), (7, 2, 2), (3, 4, 0)] {
        bytes[start + 9 * row + column] = digit;
    }
    std::fs::write(spoiled, bytes).unwrap();
}

#[test]
fn every_example_prints_what_the_readme_shows() {
    let root = root();
    let readme = std::fs::read_to_string(root.join("README.md")).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    std::fs::write(at.join("result.json"), three_rooms_result()).unwrap();
    let rooms = four_rooms().archive("MAP01", MapForm::Doom);
    std::fs::write(at.join("rooms.wad"), rooms).unwrap();
    std::fs::write(at.join("level.bsp"), level([0b11, 0b111, 0b111, 0b110])).unwrap();
    let examples = examples(&readme);
    assert!(examples.len() >= 5, "{examples:?}");
    for (command, expected) in examples {
        if command.contains(&"other.npy") {
            spoil(&at.join("gallery.npy"), &at.join("other.npy"));
        }
        // The command runs beside its outputs; these folders are the repository's.
        let is_ours = |part: &str| {
            let folder = part.split_once('/').map_or(part, |(folder, _)| folder);
            folder == "scenes" || (part != folder && ["snapshots", "vectors"].contains(&folder))
        };
        let absolute = |part: &&str| match is_ours(part) {
            true => root.join(part).to_string_lossy().into_owned(),
            false => (*part).to_owned(),
        };
        let arguments: Vec<String> = command.iter().map(absolute).collect();
        let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
        let output = stabline(at, &arguments);
        let holes = command[0] == "check";
        assert_eq!(output.status.code(), Some(i32::from(holes)), "{command:?}: {output:?}");
        assert_eq!(support::stdout(&output), expected, "{command:?}");
    }
}
