//! Ctrl-C: a flag for computations that can stop in good order, the end for all others.

use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};

static INTERRUPTED: AtomicBool = AtomicBool::new(false);
static WATCHED: AtomicBool = AtomicBool::new(false);
/// The temporary files that exist now.
static TEMPORARY: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// Installs the handler. The first interrupt raises the flag where a computation watches it;
/// otherwise, and the second time, temporary files are removed and the program ends with 130.
pub(super) fn install() {
    // Without a handler an interrupt ends the program at once, which is the worst that can happen.
    let _ = ctrlc::set_handler(|| {
        let before = INTERRUPTED.swap(true, Ordering::SeqCst);
        if before || !WATCHED.load(Ordering::SeqCst) {
            if let Ok(files) = TEMPORARY.lock() {
                for file in files.iter() {
                    let _ = std::fs::remove_file(file);
                }
            }
            std::process::exit(130);
        }
    });
}

/// From now on an interrupt only raises the flag.
pub(super) fn watch() {
    WATCHED.store(true, Ordering::SeqCst);
}

/// The computation that watched the flag is over.
pub(super) fn unwatch() {
    WATCHED.store(false, Ordering::SeqCst);
}

/// Whether an interrupt came.
pub(super) fn is_raised() -> bool {
    INTERRUPTED.load(Ordering::Relaxed)
}

/// Has `file` removed should the program be interrupted.
pub(super) fn remember(file: &Path) {
    if let Ok(mut files) = TEMPORARY.lock() {
        files.push(file.to_owned());
    }
}

/// The opposite of [`remember`].
pub(super) fn forget(file: &Path) {
    if let Ok(mut files) = TEMPORARY.lock() {
        files.retain(|other| other != file);
    }
}
