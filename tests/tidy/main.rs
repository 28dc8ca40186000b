//! The rules of the house that a program can check; ARCHITECTURE.md gives their reasons.
//!
//! Each rule is a function from text to complaints, tested beside it on text that breaks it and on
//! text that does not; here the rules meet the repository.

mod layers;
mod packages;
mod papers;
mod shape;
mod source;
mod tokens;

use source::{files, read, root, sources};

/// Folders with Rust code of our own.
const CODE: &[&str] = &["src", "tests", "benches", "examples", "fuzz"];

fn assert_tidy(complaints: Vec<String>) {
    let count = complaints.len();
    assert!(complaints.is_empty(), "{count} complaints\n{}", complaints.join("\n"));
}

fn exists(path: &str) -> bool {
    root().join(path).exists()
}

#[test]
fn imports_point_down() {
    assert_tidy(sources(&["src"]).iter().flat_map(layers::check).collect());
    let gone = layers::LAYERS.iter().filter(|(layer, _)| !exists(&format!("src/{layer}")));
    assert_tidy(gone.map(|(layer, _)| format!("the table has `{layer}`, src has not")).collect());
    assert_tidy(papers::table_of_layers(&read("ARCHITECTURE.md")));
}

#[test]
fn banned_words_keep_to_their_homes() {
    assert_tidy(sources(CODE).iter().flat_map(tokens::check).collect());
}

#[test]
fn no_file_names_a_machine() {
    let endings = [".rs", ".md", ".toml", ".json", ".snap", ".svg", "run"];
    let paths = endings.iter().flat_map(|ending| files("", ending));
    assert_tidy(paths.flat_map(|path| tokens::machine_paths(&path, &read(&path))).collect());
}

#[test]
fn files_functions_and_lines_are_short() {
    assert_tidy(sources(CODE).iter().flat_map(shape::sizes).collect());
}

#[test]
fn predicates_state_their_contracts() {
    let sources = sources(&["src/predicates"]);
    assert!(!sources.is_empty());
    assert_tidy(sources.iter().flat_map(shape::contracts).collect());
}

#[test]
fn links_lead_somewhere() {
    let pages = files("", ".md");
    assert!(pages.iter().any(|page| page == "README.md"), "{pages:?}");
    assert_tidy(
        pages.iter().flat_map(|page| papers::dead_links(page, &read(page), exists)).collect(),
    );
}

#[test]
fn scenes_and_snapshots_are_used() {
    let programs: Vec<String> = ["tests", "examples", "benches"]
        .iter()
        .flat_map(|folder| files(folder, ".rs"))
        .chain(["README.md".to_owned()])
        .filter(|path| !path.starts_with("tests/tidy/"))
        .map(|path| read(&path))
        .collect();
    let of_format = |ending: &&str| files("scenes", &format!(".{ending}"));
    let scenes: Vec<String> = papers::SCENE_ENDINGS.iter().flat_map(of_format).collect();
    assert!(!scenes.is_empty());
    assert_tidy(
        scenes.iter().flat_map(|path| papers::scene(path, &read(path), &programs)).collect(),
    );
    let mut snapshots = files("snapshots", ".snap");
    snapshots.extend(files("snapshots", ".snap.new"));
    assert_tidy(papers::orphan_snapshots(&snapshots, exists));
}

#[test]
fn one_word_means_one_thing() {
    assert_tidy(papers::glossary_words(&read("docs/glossary.md"), &sources(&["src"])));
}

#[test]
fn the_default_build_runs_no_c_compiler() {
    assert_tidy(packages::native(&packages::tree("normal,build")));
}

#[test]
fn every_licence_is_permissive() {
    assert_tidy(packages::not_permissive(&packages::tree("normal,build,dev")));
}
