//! Sizes of files and functions, and the contracts of predicates.

use crate::source::{Source, end_of_item, words};

const FILE_LINES: usize = 600;
const FUNCTION_LINES: usize = 70;
const COLUMNS: usize = 100;

/// What is too long.
pub fn sizes(source: &Source) -> Vec<String> {
    let mut wrong = Vec::new();
    let path = &source.path;
    let lines = source.production().count();
    if lines > FILE_LINES {
        wrong.push(format!("{path}: {lines} lines without tests, at most {FILE_LINES}"));
    }
    for (line, number) in source.lines.iter().zip(1..) {
        let columns = line.chars().count();
        // A string that is compared with output cannot always be broken.
        if columns > COLUMNS && !line.contains('"') {
            wrong.push(format!("{path}:{number}: {columns} columns, at most {COLUMNS}"));
        }
    }
    for (start, line) in source.code.iter().enumerate() {
        let Some(at) = words(line, "fn").next() else { continue };
        let name: String = line[at + 2..].trim_start().chars().take_while(is_name).collect();
        let lines = end_of_item(&source.code, start) - start + 1;
        if !name.is_empty() && lines > FUNCTION_LINES {
            wrong.push(format!(
                "{path}:{}: `{name}` has {lines} lines, at most {FUNCTION_LINES}",
                start + 1
            ));
        }
    }
    wrong
}

fn is_name(c: &char) -> bool {
    c.is_alphanumeric() || *c == '_'
}

/// Public predicates whose documentation lacks the line `Contract: exact, degree …, unperturbed`.
/// Stages (`_filter`, `_exact`, `_big`) are documented by the predicate whose name they keep.
pub fn contracts(source: &Source) -> Vec<String> {
    let mut wrong = Vec::new();
    if !source.path.starts_with("src/predicates/") {
        return wrong;
    }
    for (number, line) in source.production() {
        let Some(rest) = line.strip_prefix("pub fn ") else { continue };
        let name: String = rest.chars().take_while(is_name).collect();
        let signature: String = source.code[number - 1..].iter().flat_map(|l| l.chars()).collect();
        let result = signature.split('{').next().unwrap_or_default();
        let stage = ["_filter", "_exact", "_big"].iter().any(|stage| name.ends_with(stage));
        if !result.trim_end().ends_with("-> Sign") || stage {
            continue;
        }
        let above = source.lines[..number - 1].iter().rev();
        let mut docs = above.take_while(|l| l.starts_with("///") || l.starts_with("#["));
        let states = |l: &String| {
            l.starts_with("/// Contract: exact, degree ") && l.contains(", unperturbed")
        };
        if !docs.any(states) {
            wrong.push(format!("{}:{number}: `{name}` states no contract", source.path));
        }
    }
    wrong
}

#[test]
fn long_functions_files_and_lines_are_found() {
    let body = "    call();\n".repeat(69);
    let long = format!("fn f() {{\n{body}}}\n");
    let found = sizes(&Source::new("src/a.rs", &long));
    assert_eq!(found, ["src/a.rs:1: `f` has 71 lines, at most 70"]);
    assert!(sizes(&Source::new("src/a.rs", &long.replacen("    call();\n", "", 1))).is_empty());
    assert_eq!(sizes(&Source::new("src/a.rs", &"\n".repeat(601))).len(), 1);
    assert_eq!(sizes(&Source::new("src/a.rs", &"x".repeat(101))).len(), 1);
    assert!(sizes(&Source::new("src/a/tests.rs", &"\n".repeat(601))).is_empty());
}

#[test]
fn predicates_without_a_contract_are_found() {
    let wrong = |text: &str| contracts(&Source::new("src/predicates/a.rs", text));
    let bare = "/// The side.\npub fn side(\n    a: &P,\n) -> Sign {\n}";
    assert_eq!(wrong(bare), ["src/predicates/a.rs:2: `side` states no contract"]);
    assert!(wrong(&format!("/// Contract: exact, degree 3, unperturbed\n{bare}")).is_empty());
    assert!(wrong(&bare.replace("side", "side_exact")).is_empty());
}
