//! `docs/predicates.md` says what the code does: ranges, contracts, error bounds.

use stabline::predicates::{RANGES, Range};
use std::fs;
use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The cells of the table rows under a heading of the page.
fn table(heading: &str) -> Vec<Vec<String>> {
    let page = read(&root().join("docs/predicates.md"));
    let section = page.split("\n## ").find(|section| section.starts_with(heading)).unwrap();
    let rows = section.lines().filter(|line| line.starts_with("| "));
    let cells = |row: &str| row.trim_matches('|').split('|').map(|c| c.trim().to_owned()).collect();
    rows.skip(1).map(cells).collect()
}

#[test]
fn ranges_are_those_of_the_code() {
    let row = |range: &Range| -> Vec<String> {
        let value = format!("2^({}b+{})", range.slope, range.constant);
        let mut cells = vec![format!("`{}`", range.predicate), range.degree.to_string(), value];
        cells.extend([64, 128, 256, 320].map(|width| range.largest_grid(width).to_string()));
        cells
    };
    assert_eq!(table("Ranges"), RANGES.iter().map(row).collect::<Vec<_>>());
}

#[test]
fn every_predicate_states_its_contract() {
    let folder = root().join("src/predicates");
    let sources: Vec<String> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "rs"))
        .map(|path| read(&path))
        .collect();
    for range in RANGES {
        let head = format!("pub fn {}(", range.predicate);
        let docs = sources.iter().find_map(|source| source.split_once(&head)).unwrap().0;
        let docs = docs.rsplit("\n\n").next().unwrap();
        let contract = format!("/// Contract: exact, degree {}, unperturbed\n", range.degree);
        for part in
            [contract.as_str(), "/// Positive: ", "/// 1. ", "/// Requires: ", "/// Source: "]
        {
            assert!(docs.contains(part), "{} does not say {part:?}", range.predicate);
        }
    }
}

#[test]
fn error_bounds_are_those_of_the_code() {
    let rows = table("Float stages");
    assert_eq!(rows.len(), 15);
    for row in rows {
        let [stage, _, file, expression] = row.as_slice() else {
            panic!("a row of another length: {row:?}");
        };
        let source = read(&root().join("src/predicates").join(file.trim_matches('`')));
        let expression = expression.trim_matches('`');
        assert!(source.contains(expression), "{stage}: {file} does not contain {expression}");
    }
}
