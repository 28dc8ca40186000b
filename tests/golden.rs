//! Golden folders: ours equals a fresh run, every proof in it holds, and drift is told.

mod support;

use stabline::verify::verify;
use std::fs;
use std::path::{Path, PathBuf};
use support::{root, stabline, stderr, stdout};

fn proofs(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            proofs(&path, found);
        } else if path.file_name().is_some_and(|name| name == "proof.txt") {
            found.push(path);
        }
    }
}

#[test]
fn ours_is_what_comes_out() {
    let output = stabline(root(), &["golden", "snapshots/golden", "scenes", "--grazing"]);
    assert_eq!(output.status.code(), Some(0), "{}{}", stdout(&output), stderr(&output));
    assert!(stdout(&output).starts_with("no drift: "), "{}", stdout(&output));
}

#[test]
fn our_proofs_hold() {
    let mut found = Vec::new();
    proofs(&root().join("snapshots/golden"), &mut found);
    assert!(found.len() > 40, "{} proofs", found.len());
    for path in found {
        let text = fs::read(&path).unwrap();
        let verified = verify(text.as_slice());
        let verified = verified.unwrap_or_else(|flaw| panic!("{}: {flaw}", path.display()));
        assert_eq!(verified.pairs[3], 0, "{}", path.display());
    }
}

#[test]
fn drift_is_told_and_accepted() {
    let folder = tempfile::tempdir().unwrap();
    let golden = folder.path().join("golden");
    let golden = golden.to_str().unwrap();
    let scenes = ["scenes/pvs/gallery_nine_rooms.json", "scenes/world/room_open_leak.json"];
    let run = |more: &[&str]| {
        let output = stabline(root(), &[&["golden", golden], &scenes[..], more].concat());
        (output.status.code(), stdout(&output))
    };
    assert_eq!(run(&[]).0, Some(0));
    let refused = Path::new(golden).join("room_open_leak/refused.txt");
    assert!(fs::read_to_string(refused).unwrap().starts_with("room_open_leak.json: "));
    let kept = |name: &str| fs::read(Path::new(golden).join(name)).unwrap();
    let first = kept("hashes.txt");
    assert!(run(&[]).1.starts_with("no drift: "));
    // Grazing pairs were not told apart; now they are.
    let (code, told) = run(&["--grazing"]);
    assert_eq!(code, Some(1));
    assert!(told.contains("changed: gallery_nine_rooms/pvs.json\n"), "{told}");
    assert!(told.contains(": NotOpen, now Grazing\n"), "{told}");
    assert_eq!(kept("hashes.txt"), first, "nothing was changed");
    // A file that is not ours stays; one that is missing is told.
    fs::write(Path::new(golden).join("notes.txt"), "mine").unwrap();
    fs::remove_file(Path::new(golden).join("gallery_nine_rooms/matrix.svg")).unwrap();
    let (code, told) = run(&[]);
    assert_eq!(code, Some(1));
    assert!(told.contains("gallery_nine_rooms/matrix.svg"), "{told}");
    assert_eq!(run(&["--grazing", "--update"]).0, Some(0));
    assert_eq!(run(&["--grazing"]).0, Some(0));
    assert_eq!(kept("notes.txt"), b"mine");
}
