//! Bad input and bad output places: one clear line, the right exit code, nothing left behind.

mod support;

use std::fs;
use std::path::Path;
use support::{THREE_ROOMS, assert_fails, level, root, stabline, stdout, three_rooms_result};

/// The names in a folder.
fn names(at: &Path) -> Vec<String> {
    let mut names: Vec<String> = fs::read_dir(at)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

#[test]
fn usage_errors_are_one_line_with_code_2() {
    let folder = tempfile::tempdir().unwrap();
    let run = |arguments: &[&str]| stabline(folder.path(), arguments);
    assert_fails(&run(&["chek"]), 2, "unrecognized subcommand 'chek'");
    assert_fails(&run(&["check", "a"]), 2, "<CANDIDATE>");
    assert_fails(&run(&["check", "a", "b", "--policy", "half"]), 2, "invalid value 'half'");
    let help = run(&["--help"]);
    assert_eq!(help.status.code(), Some(0));
    assert!(stdout(&help).contains("check") && help.stderr.is_empty());
    let version = run(&["--version"]);
    assert_eq!(stdout(&version), concat!("stabline ", env!("CARGO_PKG_VERSION"), "\n"));
}

#[test]
fn unreadable_files_are_named() {
    let folder = tempfile::tempdir().unwrap();
    let run = |arguments: &[&str]| stabline(folder.path(), arguments);
    assert_fails(&run(&["check", "none.json", "b"]), 3, "none.json: cannot read: No such file");
    assert_fails(&run(&["check", ".", "b"]), 3, ".: cannot read: Is a directory");
}

#[test]
fn bad_files_are_named_with_their_place() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    fs::write(at.join("good.json"), three_rooms_result()).unwrap();
    fs::write(at.join("good.bsp"), level([15; 4])).unwrap();
    let header = "{'descr': '|u1', 'fortran_order': False, 'shape': (3, 3), }\n";
    let npy =
        [b"\x93NUMPY\x01\0", &[header.len() as u8, 0][..], header.as_bytes(), &[2; 9]].concat();
    fs::write(at.join("good.npy"), &npy).unwrap();
    fs::write(at.join("good.prt"), THREE_ROOMS).unwrap();
    let cut = |bytes: &[u8]| bytes[..bytes.len() - 3].to_vec();
    let result = three_rooms_result();
    let garbled = |from: &str, to: &str| result.replace(from, to).into_bytes();
    let candidates: [(&str, Vec<u8>, &str); 12] = [
        ("empty", Vec::new(), "empty: the file is empty"),
        ("cut.json", cut(result.as_bytes()), "cut.json:14: column"),
        ("cut.bsp", cut(&level([15; 4])), "cut.bsp: byte 116: lump 14 (models)"),
        ("cut.npy", cut(&npy), "cut.npy: byte 70: 3 x 3 entries expected, got 6 bytes"),
        ("noise", b"\x01\x02\x03".to_vec(), "noise: not a result, an .npy matrix or a .bsp"),
        ("counts.json", garbled("\"open\": 7", "\"open\": 8"), "counts.open: states 8"),
        ("rows.json", garbled("\"220\"", "\"22\""), "rows[0]: expected 3 digits, got 2"),
        ("digit.json", garbled("\"220\"", "\"229\""), "rows[0]: expected digits 0 to 3"),
        ("types.json", garbled("7, \"gr", "\"7\", \"gr"), "types.json:8: column"),
        ("format.json", garbled("pvs/1", "pvs/9"), "format: expected `stabline-pvs/1`"),
        ("code.npy", [&cut(&npy)[..], &[2, 4, 2]].concat(), "entry (2, 1): expected 0 to 3, got 4"),
        (
            "unvised.bsp",
            {
                let mut bytes = level([15; 4]);
                bytes[4 + 8 * 4 + 4] = 0;
                bytes
            },
            "unvised.bsp: byte 36: the level has no visibility data",
        ),
    ];
    for (name, bytes, expected) in candidates {
        fs::write(at.join(name), bytes).unwrap();
        assert_fails(&stabline(at, &["check", "good.json", name]), 3, expected);
    }
    let inputs: [(&str, &[u8], &str); 8] = [
        ("empty.prt", b"", "empty.prt: the file is empty"),
        ("cut.prt", &cut(THREE_ROOMS.as_bytes()), "cut.prt:9: expected the cluster's leafs"),
        ("shy.prt", b"PRT1\n2\n2\n", "shy.prt:4: the file ends, expected another portal"),
        ("cell.prt", b"PRT1\n2\n1\n3 0 2 (0 0 0 ) (1 0 0 ) (0 1 0 )\n", "portal names cell 2"),
        ("flat.prt", b"PRT1\n2\n1\n3 0 1 (0 0 0 ) (1 0 0 ) (2 0 0 )\n", "zero area"),
        ("nan.prt", b"PRT1\n2\n1\n3 0 1 (0 0 nan ) (1 0 0 ) (0 1 0 )\n", "nan.prt:4: vertex 0"),
        ("noise.prt", b"\xff\xfe", "noise.prt:1: not a text of ASCII characters"),
        ("scene.json", b"{\"about\": 1}", "scene.json:1: column 11: invalid type"),
    ];
    for (name, bytes, expected) in inputs {
        fs::write(at.join(name), bytes).unwrap();
        let check = ["check", "good.npy", "good.bsp", "--input", name];
        assert_fails(&stabline(at, &check), 3, expected);
    }
}

#[test]
fn a_failed_export_leaves_nothing_and_overwrites_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    fs::write(at.join("good.json"), three_rooms_result()).unwrap();
    fs::write(at.join("good.bsp"), level([15; 4])).unwrap();
    fs::write(at.join("cut.bsp"), &level([15; 4])[..200]).unwrap();
    fs::write(at.join("kept.bsp"), "precious").unwrap();
    fs::create_dir(at.join("folder")).unwrap();
    let before = names(at);
    let export = |level: &str, output: &str| {
        stabline(at, &["export", "good.json", "--bsp", level, "-o", output])
    };
    assert_fails(&export("cut.bsp", "kept.bsp"), 3, "cut.bsp: byte");
    assert_fails(&export("good.bsp", "none/out.bsp"), 3, "none/out.bsp: cannot write: No such");
    assert_fails(&export("good.bsp", "folder"), 3, "folder: cannot write");
    let mut permissions = fs::metadata(at.join("kept.bsp")).unwrap().permissions();
    permissions.set_readonly(true);
    fs::set_permissions(at.join("kept.bsp"), permissions).unwrap();
    assert_fails(&export("good.bsp", "kept.bsp"), 3, "cannot write: the file is read-only");
    assert_eq!(fs::read(at.join("kept.bsp")).unwrap(), b"precious");
    assert_eq!(names(at), before);
}

#[test]
fn a_folder_that_is_a_file_is_an_error() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    fs::write(at.join("rooms.prt"), THREE_ROOMS).unwrap();
    fs::write(at.join("file"), "precious").unwrap();
    for option in ["-o", "--npy", "--stab-tree", "--resume"] {
        let run = stabline(at, &["pvs", "rooms.prt", option, "file/out"]);
        assert_fails(&run, 3, "Not a directory");
    }
    assert_eq!(fs::read(at.join("file")).unwrap(), b"precious");
    assert_eq!(names(at), ["file", "rooms.prt"]);
}

/// In a namespace of its own, where that is allowed, the folder is mounted read-only: permission
/// bits alone would not stop a privileged user.
#[cfg(target_os = "linux")]
#[test]
fn a_read_only_disk_is_an_error() {
    use std::process::Command;
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    fs::write(at.join("rooms.prt"), THREE_ROOMS).unwrap();
    fs::write(at.join("kept.json"), "precious").unwrap();
    let before = names(at);
    let read_only = |command: &[&str]| {
        let script = "mount --bind . . && mount -o remount,ro,bind . && cd \"$PWD\" && exec \"$@\"";
        let namespace = ["--user", "--map-root-user", "--mount", "sh", "-c", script, "sh"];
        Command::new("unshare").args(namespace).args(command).current_dir(at).output()
    };
    match read_only(&["true"]) {
        Ok(output) if output.status.success() => {}
        _ => {
            eprintln!("skipped: no namespace in which to mount a folder read-only");
            return;
        }
    }
    for (option, output) in [
        ("-o", "kept.json"),
        ("-o", "new.json"),
        ("--npy", "new.npy"),
        ("--stab-tree", "new.json"),
        ("--resume", "new"),
    ] {
        let program = env!("CARGO_BIN_EXE_stabline");
        let run = read_only(&[program, "pvs", "rooms.prt", option, output]).unwrap();
        assert_fails(&run, 3, &format!("{output}: cannot write: Read-only file system"));
    }
    assert_eq!(fs::read(at.join("kept.json")).unwrap(), b"precious");
    assert_eq!(names(at), before);
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_an_error_and_a_closed_pipe_is_none() {
    use std::process::{Command, Stdio};
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    fs::write(at.join("good.json"), three_rooms_result()).unwrap();
    fs::write(at.join("good.bsp"), level([15; 4])).unwrap();
    let full = Path::new("/dev/full");
    if full.exists() {
        let export = ["export", "good.json", "--bsp", "good.bsp", "-o", "/dev/full"];
        assert_fails(&stabline(at, &export), 3, "/dev/full: cannot write: No space left");
        let device = fs::OpenOptions::new().write(true).open(full).unwrap();
        let output = Command::new(env!("CARGO_BIN_EXE_stabline"))
            .args(["schema"])
            .stdout(device)
            .stderr(Stdio::piped())
            .output()
            .unwrap();
        assert_fails(&output, 3, "standard output: cannot write: No space left");
    }
    let (reader, writer) = std::io::pipe().unwrap();
    drop(reader);
    let output = Command::new(env!("CARGO_BIN_EXE_stabline"))
        .args(["schema", "pvs"])
        .stdout(writer)
        .stderr(Stdio::piped())
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(0));
    assert!(output.stderr.is_empty());
}

/// A scene with geometry, of these fields.
fn geometry(fields: &str) -> Vec<u8> {
    format!("{{\"about\": \"x\", \"format\": \"stabline-scene/1\",\n{fields}}}").into_bytes()
}

/// What is wrong with each input is told by `bsp` and by `pvs`, and no output is left.
fn assert_refused(cases: &[(&str, Vec<u8>, &str)]) {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    for (name, bytes, expected) in cases {
        fs::write(at.join(name), bytes).unwrap();
        let run = stabline(at, &["bsp", name, "--prt", "out.prt", "--pts", "out.pts"]);
        assert_fails(&run, 3, expected);
        assert_fails(&stabline(at, &["pvs", name, "-o", "out.json"]), 3, expected);
    }
    assert_eq!(names(at).len(), cases.len());
}

fn polygon(vertices: &str) -> Vec<u8> {
    geometry(&format!("\"polygons\": [{{\"polygon\": {vertices}}}]"))
}

fn brush(shape: &str) -> Vec<u8> {
    geometry(&format!("\"brushes\": [{{\"name\": \"b\", {shape}}}]"))
}

/// A brush of three planes through the origin, and more.
fn planes(more: &str) -> Vec<u8> {
    let three = "{\"normal\": [-1,0,0], \"offset\": 0}, {\"normal\": [0,-1,0], \"offset\": 0}, \
                 {\"normal\": [0,0,-1], \"offset\": 0}";
    brush(&format!("\"planes\": [{three}{more}]"))
}

#[test]
fn bad_polygons_and_brushes_are_named_with_their_place() {
    assert_refused(&[
        ("a.json", geometry("\"polygons\": ["), "a.json:2: column"),
        ("b.json", polygon("[[0,0,NaN],[1,0,0],[0,1,0]]"), "b.json:2: column"),
        ("c.json", polygon("[[0,0,\"nan\"],[1,0,0],[0,1,0]]"), "coordinate `nan`: not a decimal"),
        ("d.json", polygon("[[0,0,1e9999],[1,0,0],[0,1,0]]"), "the exponent is larger than 4096"),
        ("e.json", polygon("[[0,0,0],[1,0,0],[2,0,0]]"), "polygons[0]: the polygon has zero area"),
        ("f.json", polygon("[[0,0,0],[1,0,0]]"), "polygons[0]: 2 distinct vertices in a row"),
        (
            "g.json",
            polygon("[[0,0,0],[4,4,0],[4,0,0],[0,3,0]]"),
            "g.json: polygons[0]: not convex, and its outline crosses or touches itself",
        ),
        ("h.json", planes(""), "h.json: brushes[0]: 3 distinct planes, expected four or more"),
        (
            "i.json",
            planes(", {\"normal\": [0,0,1], \"offset\": 1}"),
            "i.json: brushes[0]: the planes do not close it",
        ),
        (
            "j.json",
            planes(", {\"normal\": [1,1,1], \"offset\": 0}"),
            "brushes[0]: the planes leave it no volume",
        ),
        (
            "k.json",
            planes(", {\"normal\": [0,0,0], \"offset\": 1}"),
            "brushes[0]: plane 3: the normal is zero",
        ),
        (
            "l.json",
            planes(", {\"points\": [[0,0,0],[1,1,1],[3,3,3]]}"),
            "brushes[0]: plane 3: its three points are on one line",
        ),
    ]);
}

#[test]
fn bad_scenes_of_geometry_are_named_with_their_place() {
    assert_refused(&[
        (
            "m.json",
            planes(", {\"normal\": [1,1,1]}"),
            "m.json:2: column 162: a plane: expected `normal` and `offset`, or `points`",
        ),
        ("n.json", brush("\"box\": [[0,0,0],[1,0,1]]"), "brushes[0]: the first corner of a box"),
        (
            "o.json",
            brush("\"points\": [[0,0,0],[1,0,0],[0,1,0],[1,1,0]]"),
            "brushes[0]: its points lie in one plane",
        ),
        (
            "p.json",
            brush("\"points\": [], \"box\": [[0,0,0],[1,1,1]]"),
            "a brush: expected one of `planes`, `points` and `box`",
        ),
        (
            "q.json",
            geometry(
                "\"brushes\": [{\"name\": \"b\", \"box\": [[0,0,0],[1,1,1]]}], \
                 \"objects\": [{\"box\": [[0,0,0],[1,1,1]]}, {\"name\": \"b\", \
                 \"box\": [[0,0,0],[1,1,1]]}]",
            ),
            "q.json: objects[1].name: `b` is the name of brushes[0] too",
        ),
        (
            "r.json",
            geometry("\"grid\": 2, \"polygons\": [{\"polygon\": [[0,0,0],[1,0.25,0],[0,1,0]]}]"),
            "polygons[0].polygon[1]: coordinate 1/4 is not a multiple of the declared grid unit 1/2",
        ),
        ("s.json", geometry("\"brushes\": []"), "s.json: scene: nothing occludes"),
        (
            "t.json",
            geometry("\"cells\": [],\n\"view\": [[0,0,0],[1,1,1]]"),
            "t.json:3: column 9: `view` states geometry and `cells` a portal graph",
        ),
        ("u.json", geometry("\"brushes\": [], \"walls\": []"), "unknown field `walls`"),
        ("v.json", geometry("\"brushes\": [], \"brushes\": []"), "duplicate field `brushes`"),
        (
            "w.json",
            geometry("\"brushes\": [{\"box\": [[0,0,0],[1,1,1]]}], \"view\": [[0,0,0],[1,1,0]]"),
            "w.json: view: the first corner of a box",
        ),
    ]);
}

#[test]
fn bad_soup_is_named_with_its_place() {
    assert_refused(&[
        (
            "a.obj",
            b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n".to_vec(),
            "a.obj:4: corner 4: there are 3",
        ),
        ("b.obj", b"# nothing\n".to_vec(), "b.obj: faces: nothing occludes"),
        ("c.obj", b"v 0 0 1e5000\n".to_vec(), "c.obj:1: coordinate `1e5000`: the exponent"),
        (
            "d.obj",
            b"v 0 0 0\nv 4 4 0\nv 4 0 0\nv 0 3 0\n\no bow\nf 1 2 3 4\n".to_vec(),
            "d.obj:7: `bow`: not convex, and its outline crosses or touches itself",
        ),
        ("e.obj", b"v 0 0\n".to_vec(), "e.obj:1: a vertex of 2 numbers"),
        ("f.obj", Vec::new(), "f.obj: the file is empty"),
        ("a.glb", glb()[..99].to_vec(), "a.glb: header: states"),
        ("b.glb", b"glTF".to_vec(), "b.glb: header: 12 bytes expected"),
        ("c.gltf", b"{\"asset\": ".to_vec(), "c.gltf: JSON: "),
        (
            "d.gltf",
            b"{\"asset\": {\"version\": \"2.0\"}}".to_vec(),
            "d.gltf: scenes: the file has no",
        ),
        (
            "e.gltf",
            beside("../secret.bin"),
            "`../secret.bin` is not a file in the folder of the input",
        ),
        ("f.gltf", beside("none.bin"), "f.gltf: buffers[0]: the buffer's bytes are not at hand"),
    ]);
}

fn glb() -> Vec<u8> {
    fs::read(root().join("scenes/world/panels_cross_turned.glb")).unwrap()
}

/// A file whose only buffer is another file.
fn beside(uri: &str) -> Vec<u8> {
    format!(
        "{{\"asset\": {{\"version\": \"2.0\"}}, \"scenes\": [{{\"nodes\": []}}],\
         \"buffers\": [{{\"uri\": \"{uri}\", \"byteLength\": 4}}]}}"
    )
    .into_bytes()
}

/// Outputs are checked together before the work: none is written where another cannot be, and one
/// place holds one output.
#[test]
fn outputs_are_checked_before_any_is_written() {
    let folder = tempfile::tempdir().unwrap();
    let scene = |name: &str| root().join("scenes").join(name).display().to_string();
    let (level, body) = (scene("bsp/two_rooms_door_slab.map"), scene("csg/boxes_frame.json"));
    let (bsp, csg, pvs) = (["bsp", &level], ["csg", &body], ["pvs", &level]);
    for (command, outputs) in [
        (bsp, ["--prt", "same", "--cells", "same"]),
        (csg, ["--obj", "same", "--glb", "same"]),
        (pvs, ["-o", "-", "--npy", "-"]),
    ] {
        let run = stabline(folder.path(), &[&command[..], &outputs[..]].concat());
        assert_fails(&run, 2, "the name of two outputs");
    }
    for (command, outputs) in [
        (bsp, ["--prt", "kept.prt", "--cells", "no/folder.json"]),
        (csg, ["-o", "kept.json", "--bsp", "no/folder.json"]),
    ] {
        let run = stabline(folder.path(), &[&command[..], &outputs[..]].concat());
        assert_fails(&run, 3, "cannot write");
    }
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
    let run = stabline(folder.path(), &["csg", &body, "--json", "--obj", "-"]);
    assert!(stdout(&run).starts_with('#') && !stdout(&run).contains('{'), "{}", stdout(&run));
}

#[test]
fn a_level_without_a_name_is_told_by_its_text() {
    let folder = tempfile::tempdir().unwrap();
    let source = root().join("scenes/bsp/two_rooms_door_slab.map");
    fs::copy(&source, folder.path().join("level")).unwrap();
    let run = stabline(folder.path(), &["bsp", "level"]);
    assert!(stdout(&run).contains("6 cells inside, 7 portals"), "{}", support::stderr(&run));
}
