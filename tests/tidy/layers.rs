//! The direction of imports.

use crate::source::Source;

/// Each folder of `src`, lowest first, and what it may import. The same table stands in
/// ARCHITECTURE.md.
pub const LAYERS: &[(&str, &[&str])] = &[
    ("num", &[]),
    ("geom", &["num"]),
    ("predicates", &["num", "geom"]),
    ("formats", &["num", "geom"]),
    ("construct", &["num", "geom", "predicates"]),
    ("stab", &["num", "geom", "predicates"]),
    ("csg", &["num", "geom", "construct", "formats"]),
    ("scene", &["num", "geom", "predicates", "construct", "stab", "formats", "csg"]),
    ("report", &["num", "geom", "construct", "stab", "csg", "scene", "formats"]),
    ("subdivision", &["num", "geom", "predicates", "construct", "scene", "report"]),
    ("portal", &["num", "geom", "predicates", "construct", "scene", "report", "subdivision"]),
    ("pvs", &["num", "geom", "predicates", "stab", "scene", "report"]),
    (
        "eye",
        &["num", "geom", "predicates", "construct", "scene", "subdivision", "portal", "report"],
    ),
    ("motion", &["num", "geom", "construct", "scene", "subdivision", "portal", "report"]),
    ("audit", &["num", "geom", "scene", "report"]),
    ("verify", &[]),
    (
        "vectors",
        &[
            "num",
            "geom",
            "predicates",
            "formats",
            "stab",
            "scene",
            "subdivision",
            "portal",
            "report",
            "pvs",
            "eye",
        ],
    ),
    (
        "forge",
        &[
            "num",
            "geom",
            "formats",
            "stab",
            "scene",
            "subdivision",
            "portal",
            "report",
            "pvs",
            "vectors",
            "oracle",
        ],
    ),
    ("draw", &["num", "predicates", "scene", "subdivision", "portal"]),
    ("oracle", &["num", "geom"]),
    (
        "cli",
        &[
            "num",
            "geom",
            "formats",
            "construct",
            "stab",
            "scene",
            "subdivision",
            "portal",
            "csg",
            "report",
            "pvs",
            "eye",
            "motion",
            "audit",
            "vectors",
            "draw",
            "verify",
            "forge",
        ],
    ),
];

/// What the file imports against the table.
pub fn check(source: &Source) -> Vec<String> {
    let module = source.module();
    let Some(layer) = module.first() else { return Vec::new() };
    let Some((_, allowed)) = LAYERS.iter().find(|(name, _)| name == layer) else {
        return vec![format!("{}: `{layer}` has no row in the table of layers", source.path)];
    };
    let code: String = source.production().flat_map(|(_, line)| [line, "\n"]).collect();
    let mut wrong: Vec<String> = roots(&code, module.len())
        .into_iter()
        .filter(|root| root != layer && !allowed.contains(&root.as_str()))
        .map(|root| format!("{}: `{layer}` must not import `{root}`", source.path))
        .collect();
    wrong.dedup();
    wrong
}

/// The modules directly below the crate that the code names, in a module `depth` below the crate.
fn roots(code: &str, depth: usize) -> Vec<String> {
    let climb = "super::".repeat(depth);
    let mut roots = Vec::new();
    for prefix in ["crate::", "stabline::", climb.as_str()] {
        for at in crate::source::words(code, prefix) {
            // Fewer or more `super::` before this one make it another path.
            if prefix == climb && code[..at].ends_with("super::") {
                continue;
            }
            roots.extend(heads(&code[at + prefix.len()..]));
        }
    }
    roots
}

/// The first segments of a path or of a group of paths: `a` of `a::b`, `a` and `c` of `{a::b, c}`.
fn heads(path: &str) -> Vec<String> {
    let name = |text: &str| -> String {
        text.trim_start().chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect()
    };
    let Some(group) = path.strip_prefix('{') else { return vec![name(path)] };
    let mut heads = Vec::new();
    let (mut depth, mut start) = (1, 0);
    for (at, c) in group.char_indices() {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            _ => {}
        }
        if depth == 0 || (depth == 1 && c == ',') {
            heads.push(name(&group[start..at]));
            start = at + 1;
        }
        if depth == 0 {
            break;
        }
    }
    heads.retain(|head| !head.is_empty());
    heads
}

#[test]
fn imports_against_the_table_are_found() {
    let wrong = |path: &str, text: &str| check(&Source::new(path, text));
    assert_eq!(
        wrong("src/geom/line.rs", "use crate::stab::Stabber;"),
        ["src/geom/line.rs: `geom` must not import `stab`"]
    );
    assert_eq!(wrong("src/geom/line.rs", "use crate::{num::Sign, pvs::{a, b}, scene};").len(), 2);
    assert_eq!(wrong("src/geom/line.rs", "let x = super::super::pvs::run();").len(), 1);
    assert_eq!(wrong("src/geom/mod.rs", "use super::pvs;").len(), 1);
    assert_eq!(wrong("src/oracle/a.rs", "fn f(x: crate::predicates::Budget) {}").len(), 1);
    assert_eq!(wrong("src/newcomer/mod.rs", "").len(), 1);
}

#[test]
fn imports_along_the_table_are_fine() {
    let wrong = |path: &str, text: &str| check(&Source::new(path, text));
    assert!(wrong("src/geom/line.rs", "use crate::num::Int;\nuse super::Point3;").is_empty());
    assert!(wrong("src/stab/a/b.rs", "use super::super::cone;\n// use crate::cli").is_empty());
    let tests = "#[cfg(test)]\nmod tests {\n use crate::oracle;\n}";
    assert!(wrong("src/stab/a.rs", tests).is_empty());
}
