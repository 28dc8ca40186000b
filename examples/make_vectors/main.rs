//! Writes the test vectors: every file of `vectors/`, byte for byte as it is committed.
//!
//! `cargo run --release --example make_vectors -- vectors`

mod suite;

use std::path::PathBuf;
use std::process::ExitCode;

fn main() -> ExitCode {
    let Some(folder) = std::env::args_os().nth(1).map(PathBuf::from) else {
        eprintln!("usage: make_vectors FOLDER");
        return ExitCode::from(2);
    };
    for file in suite::NAMES.map(suite::file) {
        let path = folder.join(format!("{}.json", file.name));
        if let Err(error) = std::fs::write(&path, file.to_text()) {
            eprintln!("{}: {error}", path.display());
            return ExitCode::from(3);
        }
        println!("{}: {} tests", path.display(), file.number_of_tests);
    }
    ExitCode::SUCCESS
}
