//! Words that must not stand in code, and where they may.

use crate::source::{Source, words};

/// A rule against words.
struct Ban {
    words: &'static [&'static str],
    why: &'static str,
    /// Starts of paths, or `/name` for a module of that name anywhere.
    homes: &'static [&'static str],
    /// Whether tests are searched too.
    in_tests: bool,
}

const BANS: &[Ban] = &[
    Ban {
        words: &["f32", "f64"],
        why: "floats decide nothing: only a filter with a proved bound, or a proposal, may use them",
        homes: &[
            "src/predicates/",
            "/propose",
            "src/draw/",
            // The nearest floats of exact values, which the filters read.
            "src/geom/point.rs",
            "src/geom/line.rs",
            "src/geom/plane.rs",
            // Files of meshes hold floats: written to the nearest, with the displacement told.
            "src/formats/mesh.rs",
            // For display.
            "src/num/surd.rs",
            // Shares, times and estimates, for display.
            "src/cli/",
            // Nearest floats with their error bounds, for the filters.
            "src/pvs/grid.rs",
            // Floats that are whole numbers, made exact.
            "src/pvs/sightline.rs",
        ],
        in_tests: false,
    },
    Ban {
        words: &["EPSILON", "epsilon", "tolerance", "eps", "approx_eq", "abs_diff_eq"],
        why: "there is no tolerance",
        // The unit roundoff, from which the filters' bounds are derived.
        homes: &["src/predicates/"],
        in_tests: false,
    },
    Ban {
        words: &["std::fs", "fs::", "std::env", "env::", "std::net", "std::process", "process::"],
        why: "only `cli` and `main` touch files and the environment",
        homes: &["src/cli/", "src/main.rs"],
        in_tests: false,
    },
    Ban {
        words: &["Instant", "SystemTime", "std::time", "thread::sleep"],
        why: "only `cli` reads the clock",
        homes: &["src/cli/"],
        in_tests: false,
    },
    Ban {
        words: &["print!", "println!", "eprint!", "eprintln!", "stdout", "stderr", "stdin"],
        why: "only `cli` reads and prints",
        homes: &["src/cli/"],
        in_tests: false,
    },
    Ban {
        words: &["HashMap", "HashSet", "RandomState"],
        why: "their order is random, and results have the same bytes everywhere: use `rustc_hash`",
        homes: &[],
        in_tests: false,
    },
    Ban {
        words: &["unsafe", "todo!", "unimplemented!", "dbg!", "#[ignore", "transmute"],
        why: "no unsafe code, no stubs, no tests that do not run",
        homes: &[],
        in_tests: true,
    },
];

/// The banned words of the file.
pub fn check(source: &Source) -> Vec<String> {
    let mut wrong = Vec::new();
    let numbers = 1..=source.code.len();
    let in_src = source.path.starts_with("src/");
    for ((number, line), test) in numbers.zip(&source.code).zip(&source.is_test) {
        for ban in BANS {
            let applies = ban.in_tests || (in_src && !test);
            if !applies || ban.homes.iter().any(|home| lives_in(&source.path, home)) {
                continue;
            }
            for word in ban.words.iter().filter(|word| words(line, word).next().is_some()) {
                wrong.push(format!("{}:{number}: `{word}`: {}", source.path, ban.why));
            }
        }
        let float_home = BANS[0].homes.iter().any(|home| lives_in(&source.path, home));
        if in_src && !test && !float_home && has_float_literal(line) {
            wrong.push(format!("{}:{number}: a float: {}", source.path, BANS[0].why));
        }
    }
    wrong
}

fn lives_in(path: &str, home: &str) -> bool {
    match home.strip_prefix('/') {
        None => path.starts_with(home),
        Some(module) => path.split('/').any(|part| part.trim_end_matches(".rs") == module),
    }
}

/// Whether a number with a decimal point or a negative exponent stands in the line. Fields of
/// tuples, `x.0.1`, and ranges, `0..1`, are none.
fn has_float_literal(line: &str) -> bool {
    let bytes = line.as_bytes();
    let mut at = 0;
    while at < bytes.len() {
        let starts = bytes[at].is_ascii_digit()
            && (at == 0 || !matches!(bytes[at - 1], b'.' | b'_' | b'a'..=b'z' | b'A'..=b'Z'));
        if !starts {
            at += 1;
            continue;
        }
        let rest = &line[at..];
        let digits =
            |text: &str| text.bytes().take_while(|b| b.is_ascii_digit() || *b == b'_').count();
        let length = digits(rest);
        let tail = &rest[length..];
        let fraction = tail.strip_prefix('.').map(digits);
        let range = tail.starts_with("..");
        if fraction.is_some_and(|digits| digits > 0) && !range || tail.starts_with("e-") {
            return true;
        }
        at += length;
    }
    false
}

/// Paths of a machine in a file of text.
pub fn machine_paths(path: &str, text: &str) -> Vec<String> {
    // In pieces, so that this file does not name them itself.
    let folders = ["work", "tmp", "home", "root", "Users"].map(|folder| format!("/{folder}/"));
    // A folder of the repository may have such a name; an absolute path has nothing before it.
    let absolute = |line: &str, at: usize| {
        !line[..at].ends_with(|c: char| c.is_alphanumeric() || "_-.}".contains(c))
    };
    let names = |line: &str| {
        folders.iter().any(|folder| line.match_indices(folder).any(|(at, _)| absolute(line, at)))
    };
    let named = text.lines().zip(1..).filter(|(line, _)| names(line));
    named.map(|(_, number)| format!("{path}:{number}: names a folder of a machine")).collect()
}

#[test]
fn banned_words_are_found() {
    let wrong = |path: &str, text: &str| check(&Source::new(path, text)).len();
    for bad in [
        "fn f(x: f64) {}",
        "let x = 0.5;",
        "let x = 1e-9;",
        "if d.abs() < EPSILON {}",
        "let t = std::fs::read(p);",
        "use std::time::Instant;",
        "println!();",
        "dbg!(x);",
        "let m: HashMap<u8, u8>;",
        "todo!()",
    ] {
        assert!(wrong("src/stab/cone.rs", bad) > 0, "{bad}");
    }
    assert_eq!(wrong("tests/a.rs", "#[ignore = \"slow\"]"), 1);
    assert!(!machine_paths("a.md", &format!("see {}tmp/x", '/')).is_empty());
}

#[test]
fn what_is_allowed_is_not_found() {
    let wrong = |path: &str, text: &str| check(&Source::new(path, text)).len();
    for fine in ["x.0.1 + y.1", "for i in 0..10 {}", "// f64", "let s = \"f64 0.5\";", "1u8..=2"] {
        assert_eq!(wrong("src/stab/cone.rs", fine), 0, "{fine}");
    }
    assert_eq!(wrong("src/pvs/propose/norm.rs", "let x: f64 = 0.5;"), 0);
    assert_eq!(wrong("src/cli/files.rs", "std::fs::read(p)"), 0);
    assert_eq!(wrong("src/stab/cone.rs", "#[cfg(test)]\nmod tests {\nlet x = 0.5f64;\n}"), 0);
    assert!(machine_paths("a.md", "src/work/tmp.rs").is_empty());
}
