//! The files of the repository, and Rust code without its comments and strings.

use std::path::{Path, PathBuf};

/// The repository's folder.
pub fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// A Rust file, by lines.
pub struct Source {
    /// Relative to the repository, with forward slashes.
    pub path: String,
    /// The lines as they stand.
    pub lines: Vec<String>,
    /// The same lines with comments and the insides of strings blanked.
    pub code: Vec<String>,
    /// Which lines are tests: `#[cfg(test)]` items, and whole files of tests.
    pub is_test: Vec<bool>,
}

impl Source {
    pub fn new(path: &str, text: &str) -> Source {
        let lines: Vec<String> = text.lines().map(str::to_owned).collect();
        let mut code: Vec<String> = blanked(text).lines().map(str::to_owned).collect();
        code.resize(lines.len(), String::new());
        let is_test = test_lines(path, &code);
        Source { path: path.to_owned(), lines, code, is_test }
    }

    /// The lines of code that are not tests, with their numbers counted from 1.
    pub fn production(&self) -> impl Iterator<Item = (usize, &str)> {
        let lines = self.code.iter().zip(&self.is_test).enumerate();
        lines.filter(|(_, (_, test))| !**test).map(|(index, (line, _))| (index + 1, line.as_str()))
    }

    /// The module that the file belongs to: `["pvs", "search"]` for `src/pvs/search.rs`.
    pub fn module(&self) -> Vec<&str> {
        let inside = self.path.strip_prefix("src/").unwrap_or_default();
        let mut segments: Vec<&str> = inside.trim_end_matches(".rs").split('/').collect();
        if matches!(segments.last(), Some(&"mod" | &"lib" | &"main")) {
            segments.pop();
        }
        segments
    }
}

/// Every file below `folder` whose name ends in `ending`, sorted, relative to the repository.
pub fn files(folder: &str, ending: &str) -> Vec<String> {
    let mut found = Vec::new();
    let mut open: Vec<PathBuf> = vec![root().join(folder)];
    while let Some(folder) = open.pop() {
        let Ok(entries) = std::fs::read_dir(&folder) else { continue };
        for path in entries.map(|entry| entry.unwrap().path()) {
            let name = path.file_name().unwrap().to_string_lossy().into_owned();
            let built = ["target", "corpus", "artifacts"].contains(&name.as_str());
            if path.is_dir() && !built && name != ".git" {
                open.push(path);
            } else if path.is_file() && name.ends_with(ending) {
                let inside = path.strip_prefix(root()).unwrap().components();
                let parts: Vec<_> = inside.map(|c| c.as_os_str().to_string_lossy()).collect();
                found.push(parts.join("/"));
            }
        }
    }
    found.sort();
    found
}

/// The text of a file of the repository.
pub fn read(path: &str) -> String {
    let bytes = std::fs::read(root().join(path)).unwrap_or_else(|e| panic!("{path}: {e}"));
    String::from_utf8_lossy(&bytes).into_owned()
}

/// Every Rust file below the folders.
pub fn sources(folders: &[&str]) -> Vec<Source> {
    let paths = folders.iter().flat_map(|folder| files(folder, ".rs"));
    paths.map(|path| Source::new(&path, &read(&path))).collect()
}

/// The text with comments, and the insides of strings and characters, replaced by blanks.
fn blanked(text: &str) -> String {
    let chars: Vec<char> = text.chars().collect();
    let mut out = String::with_capacity(text.len());
    let mut at = 0;
    while at < chars.len() {
        let end = token_to_blank(&chars, at);
        if end == at {
            out.push(chars[at]);
            at += 1;
        }
        while at < end {
            out.push(if chars[at] == '\n' { '\n' } else { ' ' });
            at += 1;
        }
    }
    out
}

/// Where the comment, string or character that starts at `at` ends; `at` itself if none does.
fn token_to_blank(chars: &[char], at: usize) -> usize {
    let peek = |offset: usize| chars.get(at + offset).copied().unwrap_or('\0');
    let until = |from: usize, stop: &dyn Fn(usize) -> bool| {
        (from..chars.len()).find(|&i| stop(i)).unwrap_or(chars.len())
    };
    match (chars[at], peek(1)) {
        ('/', '/') => until(at, &|i| chars[i] == '\n'),
        ('/', '*') => {
            let mut depth = 0;
            let mut i = at;
            while i < chars.len() {
                match (chars[i], chars.get(i + 1)) {
                    ('/', Some('*')) => (depth, i) = (depth + 1, i + 2),
                    ('*', Some('/')) => (depth, i) = (depth - 1, i + 2),
                    _ => i += 1,
                }
                if depth == 0 {
                    break;
                }
            }
            i
        }
        ('"', _) => {
            let mut i = at + 1;
            while i < chars.len() && chars[i] != '"' {
                i += if chars[i] == '\\' { 2 } else { 1 };
            }
            (i + 1).min(chars.len())
        }
        ('r', '"' | '#') if at == 0 || !is_word(chars[at - 1]) || chars[at - 1] == 'b' => {
            let hashes = chars[at + 1..].iter().take_while(|&&c| c == '#').count();
            if peek(1 + hashes) != '"' {
                return at;
            }
            let closes = |i: usize| {
                chars[i] == '"'
                    && chars[i + 1..].iter().take(hashes).filter(|&&c| c == '#').count() == hashes
            };
            (until(at + 2 + hashes, &closes) + 1 + hashes).min(chars.len())
        }
        ('\'', '\\') => (until(at + 3, &|i| chars[i] == '\'') + 1).min(chars.len()),
        ('\'', _) if peek(2) == '\'' => at + 3,
        _ => at,
    }
}

fn is_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// Which lines belong to tests.
fn test_lines(path: &str, code: &[String]) -> Vec<bool> {
    if path.ends_with("/tests.rs") || path.contains("/tests/") || path.starts_with("tests/") {
        return vec![true; code.len()];
    }
    let mut is_test = vec![false; code.len()];
    for start in 0..code.len() {
        if code[start].trim() == "#[cfg(test)]" {
            is_test[start..=end_of_item(code, start + 1)].fill(true);
        }
    }
    is_test
}

/// The last line of the item that starts on `start`: the one of its closing brace, or of its
/// semicolon where that comes first.
pub fn end_of_item(code: &[String], start: usize) -> usize {
    let (mut braces, mut others) = (0, 0);
    for (index, line) in code.iter().enumerate().skip(start) {
        for c in line.chars() {
            match c {
                '{' => braces += 1,
                '}' => braces -= 1,
                '(' | '[' => others += 1,
                ')' | ']' => others -= 1,
                _ => {}
            }
            if braces == 0 && others == 0 && (c == '}' || c == ';') {
                return index;
            }
        }
    }
    code.len().saturating_sub(1)
}

/// The places in `line` where `word` stands on its own.
pub fn words<'a>(line: &'a str, word: &'a str) -> impl Iterator<Item = usize> + 'a {
    line.match_indices(word).map(|(at, _)| at).filter(move |&at| {
        let before = line[..at].chars().next_back();
        let after = line[at + word.len()..].chars().next();
        let inside = |c: Option<char>| c.is_some_and(is_word);
        let goes_on =
            word.starts_with(is_word) && inside(before) || word.ends_with(is_word) && inside(after);
        !goes_on
    })
}

#[test]
fn comments_and_strings_are_no_code() {
    let text = "let a = \"x // f64\"; // f64\n/* f64 /* f64 */ f64 */ let b = r#\"f64\" f64\"#;\n\
                let c = '\"'; let d = b\"f64\\\"f64\"; fn e<'a>(x: &'a str) -> char { '\\'' }";
    let code = Source::new("src/a.rs", text).code.join("\n");
    assert!(!code.contains("f64"), "{code}");
    for kept in ["let a", "let b", "let c", "let d", "fn e<'a>(x: &'a str)"] {
        assert!(code.contains(kept), "{kept}: {code}");
    }
}

#[test]
fn tests_are_told_from_production() {
    let text =
        "fn a() {}\n#[cfg(test)]\nmod tests {\n fn b() {}\n}\nfn c() {}\n#[cfg(test)]\nmod d;";
    let source = Source::new("src/a.rs", text);
    let numbers: Vec<usize> = source.production().map(|(number, _)| number).collect();
    assert_eq!(numbers, [1, 6]);
    assert_eq!(Source::new("src/a/tests.rs", "fn a() {}").production().count(), 0);
}

#[test]
fn words_stand_alone() {
    assert_eq!(words("f64 xf64 f64x (f64)", "f64").collect::<Vec<_>>(), [0, 15]);
    assert_eq!(words("eprintln!() println!()", "println!").collect::<Vec<_>>(), [12]);
}
