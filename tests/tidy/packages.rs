//! The packages that the build uses: their licences, and what runs a C compiler.

use std::process::Command;

/// A package of the tree: its name and its licence expression.
pub struct Package {
    pub name: String,
    pub licence: String,
}

/// Packages whose purpose is to run a C compiler, or to find C libraries.
const NATIVE: &[&str] = &[
    "autotools",
    "bindgen",
    "cc",
    "cmake",
    "cxx-build",
    "meson",
    "nasm-rs",
    "pkg-config",
    "vcpkg",
];

const PERMISSIVE: &[&str] = &[
    "0BSD",
    "Apache-2.0",
    "Apache-2.0 WITH LLVM-exception",
    "BSD-2-Clause",
    "BSD-3-Clause",
    "BSL-1.0",
    "CC0-1.0",
    "ISC",
    "MIT",
    "MIT-0",
    "Unicode-3.0",
    "Unlicense",
    "Zlib",
];

/// What `cargo tree` lists along `edges`: for every platform where all packages are at hand, else
/// for this one.
pub fn tree(edges: &str) -> Vec<Package> {
    for target in [&["--target", "all"][..], &[]] {
        let output = Command::new(env!("CARGO"))
            .args(["tree", "--offline", "--locked", "--prefix", "none", "--format", "{p}|{l}"])
            .args(["--edges", edges])
            .args(target)
            .current_dir(crate::source::root())
            .output()
            .expect("cargo runs");
        if output.status.success() {
            let text = String::from_utf8(output.stdout).expect("cargo prints text");
            return parse(&text);
        }
    }
    panic!("cargo tree fails; run `cargo fetch` where the packages are not at hand");
}

fn parse(text: &str) -> Vec<Package> {
    let lines = text.lines().filter_map(|line| line.split_once('|'));
    lines
        .map(|(package, licence)| Package {
            name: package.split(' ').next().unwrap_or_default().to_owned(),
            licence: licence.trim_end_matches(" (*)").to_owned(),
        })
        .collect()
}

/// The packages of the tree that run a C compiler.
pub fn native(tree: &[Package]) -> Vec<String> {
    let found = tree.iter().filter(|package| NATIVE.contains(&package.name.as_str()));
    let mut names: Vec<String> = found.map(|package| package.name.clone()).collect();
    names.sort();
    names.dedup();
    names
}

/// The packages of the tree that are not offered under a permissive licence.
pub fn not_permissive(tree: &[Package]) -> Vec<String> {
    let refused = tree.iter().filter(|package| !is_permissive(&package.licence));
    refused.map(|package| format!("{}: {}", package.name, package.licence)).collect()
}

/// Whether every part of the expression that must be followed has a permissive alternative.
fn is_permissive(licence: &str) -> bool {
    licence.split(" AND ").all(|part| {
        let part = part.trim_matches(['(', ')']).replace('/', " OR ");
        part.split(" OR ").any(|one| PERMISSIVE.contains(&one.trim().trim_matches(['(', ')'])))
    })
}

#[test]
fn packages_are_judged() {
    let lines = [
        "stabline v0.1.0 (x)|MIT OR Apache-2.0",
        "cc v1.2.3|MIT OR Apache-2.0 (*)",
        "",
        "unicode-ident v1|(MIT OR Apache-2.0) AND Unicode-3.0",
        "bad v1|LGPL-3.0-only",
        "worse v1|MIT AND GPL-2.0",
        "old v1|Unlicense/MIT",
        "none v1|",
    ];
    let tree = parse(&lines.join("\n"));
    assert_eq!(tree.len(), 7);
    assert_eq!(native(&tree), ["cc"]);
    let refused = not_permissive(&tree);
    assert_eq!(refused, ["bad: LGPL-3.0-only", "worse: MIT AND GPL-2.0", "none: "]);
}
