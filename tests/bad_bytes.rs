//! Every parser on arbitrary and on damaged bytes: an error or a value, never a panic, and never
//! an allocation that the bytes do not pay for (a lying header would abort these tests).

mod support;

use proptest::prelude::*;
use stabline::forge::Input;
use stabline::formats::bsp::{BitMatrix, LevelTree, Visibility, write_visibility};
use stabline::formats::json::{GeometryFile, SceneFile};
use stabline::formats::lines::LinesFile;
use stabline::formats::npy::NpyMatrix;
use stabline::formats::sequence::SequenceFile;
use stabline::formats::wad::{Archive, MapForm};
use stabline::formats::{gltf, obj, prt};
use stabline::report::PvsReport;
use stabline::scene::{
    CellOrder, LevelOptions, PortalGraph, WorldOptions, read_graph, read_level, read_world,
};
use stabline::vectors::{Case, VectorsFile};
use stabline::verify::verify;
use support::wads::two_rooms;
use support::{THREE_ROOMS, level, root, three_rooms_result};

/// Every field of a scene with geometry, and every form of a brush.
const GEOMETRY: &str = r#"{"about": "a", "format": "stabline-scene/1", "grid": 4,
"view": [[0,0,0],[8,8,4]], "polygons": [{"name": "p", "polygon": [[5,0,0],[5,5,0],[5,5,3],[6,0,3]]}],
"brushes": [{"box": [[2,2,0],[3,3,4]]}, {"points": [[0,6,0],[4,6,0],[0,8,0],[0,6,"3/2"],[1,6.5,0]]},
{"planes": [{"normal": [0,0,-1], "offset": 0}, {"normal": [-1,0,0], "offset": -6},
{"points": [[6,0,0],[7,0,0],[6,0,1]]}, {"normal": [1,1,1], "offset": 17}]}],
"objects": [{"name": "o", "box": [[6,6,0],[7,7,1]]}], "inside": [[1,1,1]],
"hints": [{"box": [[0,0,0],[1,1,1]]}]}"#;

const OBJ: &str =
    "o a b\nv 0 0 0 # c\nv 1.5 0 1e0\nv 1 1/3 \\\n 0\nvn 0 0 1\nf -3 2/1 3//1\nf 1 2 3\n";

const SCENE: &str = r#"{"about": "a door", "format": "stabline-scene/1", "grid": 2,
"cells": ["hall", "yard"], "portals": [
{"from": "yard", "to": "hall", "polygon": [[0, 0, 0], ["7/2", 0, 1e0], [0, -2.5, 0], [0, -2.5, 0]]}]}"#;

/// A wedge in both forms of faces, with flags, a curved surface, comments and a place.
const MAP: &str = r#"// a comment
{ "classname" "worldspawn" "message" "a \"word\""
{ (0 0 0) (0 1 0) (0 0 1) wall 0 0 0 1 1
(0 0 0) (0 0 1) (1 0 0) *water [ 1 0 0 0 ] [ 0 -1 0 .5 ] 0 1 1
(0 0 0) (1 0 0) (0 1 0) hint 0 0 0 1 1 134217728 256 0
(8.5 0 0) (0 0 8) (0 8 0) {x 0 0 nan 1 1 // more
} { patchDef2 { some/texture ( 3 3 0 0 0 ) } } }
{ "classname" "light" "origin" "1 -2.5 1e1" }
"#;

/// What every graph promises, whatever it was read from.
fn assert_valid(graph: &PortalGraph) {
    for portal in &graph.portals {
        assert!(portal.from != portal.to);
        assert!(portal.vertices.len() >= 3);
        assert!(portal.vertices.iter().all(|&v| (v as usize) < graph.vertices.len()));
        for cell in [portal.from, portal.to] {
            assert!((cell.0 as usize) < graph.cells.len());
        }
    }
    assert!(graph.leaf_to_cell.iter().all(|cell| (cell.0 as usize) < graph.cells.len()));
    CellOrder::new(graph);
}

const SEQUENCE: &str = r#"{"about": "a", "format": "stabline-sequence/1",
 "portals": [[[0, 0, 0], [1, "1/2", 0], [0, 1, 0]], [[0, 0, 3], [1, 0, 3], [0, 1.5, 3]]]}"#;

const LINES: &str = r#"{"format": "stabline-lines/1", "lines": [[[0, 0, 0], [1, "1/2", 0]],
 [[0, 0, 1], [0, 1, 1]], [[1, 1, 2], [2, 5, 2]], [[3, 1, 2], [2, 5, 4]]]}"#;

const CASE: &str = r#"{"tcId": 4, "kind": "graph", "from": "a", "to": "b", "input": {"about": "",
 "format": "stabline-scene/1", "cells": ["a", "b"], "portals": [{"from": "a", "to": "b",
 "polygon": [[0, 0, 0], [0, "4/3", 0], [0, 1, 1]]}]}}"#;

const PROOF: &str = "snapshots/golden/draw/three_cells_graph/proof.txt";

/// All parsers on the same bytes.
fn parse(bytes: &[u8]) {
    if let Err(error) = prt::read(bytes) {
        assert!(error.line >= 1 && !error.to_string().contains('\n'));
    }
    match read_level("x", bytes, LevelOptions::default()) {
        Ok(level) => {
            for brush in &level.brushes {
                assert!(brush.faces.len() >= 4 && brush.entity < level.entities.len());
            }
            assert!(level.warnings.iter().all(|w| w.line >= 1 && !w.to_string().contains('\n')));
        }
        Err(error) => assert!(error.line().is_some() && !error.to_string().contains('\n')),
    }
    let _ = SceneFile::read(bytes);
    let _ = GeometryFile::read(bytes);
    if let Err(error) = obj::read(bytes) {
        assert!(error.line >= 1 && !error.to_string().contains('\n'));
    }
    if let Ok(file) = gltf::read(bytes, &mut |_| Ok(vec![0; 64])) {
        for part in &file.parts {
            let corners = part.triangles.as_flattened();
            assert!(corners.iter().all(|&corner| (corner as usize) < part.vertices.len()));
        }
    }
    for (name, snap) in [("x", None), ("x.obj", Some(0)), ("x.glb", None)] {
        match read_world(name, bytes, &WorldOptions { snap, ..WorldOptions::default() }) {
            Ok((world, _)) => {
                assert!(world.polygons.iter().all(|polygon| polygon.vertices.len() >= 3));
                assert!(world.solids.iter().all(|solid| solid.planes.len() >= 4));
                assert!(world.objects.iter().all(|object| object.bounds.has_volume()));
            }
            Err(error) => assert!(error.to_string().starts_with(name)),
        }
    }
    let _ = SequenceFile::read(bytes).and_then(|file| file.points());
    let _ = LinesFile::read(bytes).and_then(|file| file.lines());
    if let Ok(case) = Case::read(bytes) {
        assert_eq!(Case::read(case.to_line().as_bytes()).unwrap(), case);
        let _ = Input::of_case(&case);
    }
    let _ = VectorsFile::read(bytes);
    let _ = verify(bytes);
    let _ = PvsReport::read(bytes);
    let _ = NpyMatrix::read(bytes);
    let _ = LevelTree::read(bytes);
    if let Ok(archive) = Archive::read(bytes) {
        for map in archive.maps().into_iter().flat_map(|name| archive.map(name)) {
            assert!(map.sidedefs.iter().all(|&sector| (sector as usize) < map.sectors));
        }
    }
    if let Ok(read) = Visibility::read(bytes) {
        assert!(read.rows_missing <= read.matrix.size());
        // What can be read can be replaced, or is refused; it is never another matrix.
        if let Ok(written) = write_visibility(bytes, &read.matrix) {
            assert_eq!(Visibility::read(&written).unwrap().matrix, read.matrix);
        }
    }
    let _ = write_visibility(bytes, &BitMatrix::new(4));
    if let Ok(graph) = read_graph("x", bytes) {
        assert_valid(&graph);
    }
}

/// A whole valid file of each format.
fn files() -> Vec<Vec<u8>> {
    let header = "{'descr': '|u1', 'fortran_order': False, 'shape': (3, 3), }\n";
    let npy =
        [b"\x93NUMPY\x01\0", &[header.len() as u8, 0][..], header.as_bytes(), &[2; 9]].concat();
    let mut quake2 = vec![0; 8 + 8 * 19];
    quake2[..8].copy_from_slice(b"IBSP\x26\0\0\0");
    quake2[32] = 160;
    quake2[36] = 13;
    quake2.extend_from_slice(&[1, 0, 0, 0, 12, 0, 0, 0, 12, 0, 0, 0, 1]);
    let mut quake3 = vec![0; 8 + 8 * 17];
    quake3[..8].copy_from_slice(b"IBSP\x2e\0\0\0");
    quake3[136] = 144;
    quake3[140] = 10;
    quake3.extend_from_slice(&[2, 0, 0, 0, 1, 0, 0, 0, 3, 3]);
    let q3 = "PRT1\n2\n1\n1\n3 0 1 0 (0 0 0 ) (1 0 0 ) (0 1 0 )\n3 1 (0 0 0 ) (1 0 0 ) (0 1 0 )\n";
    let am = "PRT1-AM\n2\n1\n2\n3 0 1 (0 0 0 ) (1 0 .5 ) (0 1 0 )\n0\n1\n";
    let headless = "2\n1\n1\n2\n3 0 1 (0 0 0 ) (1 0 0 ) (0 1 0 )\n";
    let texts = [THREE_ROOMS, SCENE, q3, am, headless, &three_rooms_result(), MAP, GEOMETRY, OBJ];
    let mut files: Vec<Vec<u8>> = texts.iter().map(|text| text.as_bytes().to_vec()).collect();
    files.extend([SEQUENCE, LINES, CASE].map(|text| text.as_bytes().to_vec()));
    files.push(std::fs::read(root().join(PROOF)).unwrap());
    let glb = std::fs::read(root().join("scenes/world/panels_cross_turned.glb")).unwrap();
    files.extend([npy, level([1, 3, 7, 15]), quake2, quake3, glb]);
    let forms = [MapForm::Doom, MapForm::Hexen, MapForm::Udmf];
    files.extend(forms.map(|form| two_rooms().archive("MAP01", form)));
    files
}

/// A level of each format, of 20 leafs or clusters, with a lump behind the visibility.
fn levels() -> Vec<Vec<u8>> {
    let leafs = 20usize;
    let rows = [255, 255, 15].repeat(leafs);
    let word = |value: usize| (value as u32).to_le_bytes();
    let level = |start: &[u8], lumps: usize, content: &[(usize, &[u8])]| {
        let directory = start.len();
        let mut bytes = [start, &vec![0; 8 * lumps]].concat();
        for (lump, data) in content {
            let entry = directory + 8 * lump;
            let place = bytes.len();
            bytes[entry..entry + 4].copy_from_slice(&word(place));
            bytes[entry + 4..entry + 8].copy_from_slice(&word(data.len()));
            bytes.extend_from_slice(data);
        }
        bytes
    };
    let quake = |magic: &[u8], record: usize| {
        let mut records = vec![0; record * (leafs + 1)];
        for leaf in 0..leafs {
            records[record * (leaf + 1) + 4..][..4].copy_from_slice(&word(3 * leaf));
        }
        let mut model = [0; 64];
        model[52] = leafs as u8;
        level(magic, 15, &[(10, &records), (4, &rows), (14, &model)])
    };
    let mut quake2 = word(leafs).to_vec();
    for cluster in 0..2 * leafs {
        quake2.extend_from_slice(&word(4 + 8 * leafs + 3 * (cluster / 2)));
    }
    quake2.extend_from_slice(&rows);
    let quake3 = [&word(leafs)[..], &word(3), &rows].concat();
    vec![
        quake(b"\x1d\0\0\0", 28),
        quake(b"\x1e\0\0\0", 28),
        quake(b"BSP2", 44),
        quake(b"2PSB", 32),
        level(b"IBSP\x26\0\0\0", 19, &[(3, &quake2), (11, b"tail")]),
        level(b"IBSP\x2e\0\0\0", 17, &[(16, &quake3), (2, b"tail")]),
    ]
}

#[test]
fn the_undamaged_levels_are_read_and_rewritten() {
    for level in levels() {
        let matrix = Visibility::read(&level).unwrap().matrix;
        assert_eq!(matrix.size(), 20);
        assert!((0..20).all(|row| (0..20).all(|column| matrix.get(row, column))));
        assert!(write_visibility(&level, &matrix).is_ok());
    }
}

#[test]
fn the_undamaged_files_are_read() {
    let files = files();
    let graphs = files.iter().filter(|bytes| read_graph("x", bytes).is_ok()).count();
    let levels = files.iter().filter(|bytes| Visibility::read(bytes).is_ok()).count();
    let others = files.iter().filter(|b| PvsReport::read(b).is_ok() || NpyMatrix::read(b).is_ok());
    assert_eq!((graphs, levels, others.count()), (5, 3, 2));
    assert_eq!(files.iter().filter(|bytes| verify(bytes.as_slice()).is_ok()).count(), 1);
    assert_eq!(files.iter().filter(|bytes| Case::read(bytes).is_ok()).count(), 1);
    let portals = files.iter().flat_map(|b| SequenceFile::read(b).and_then(|file| file.points()));
    let lines = files.iter().flat_map(|b| LinesFile::read(b).and_then(|file| file.lines()));
    assert_eq!((portals.count(), lines.count()), (1, 1));
    let source = read_level("x", MAP.as_bytes(), LevelOptions::default()).unwrap();
    assert_eq!((source.brushes.len(), source.warnings.len()), (1, 2));
    let count = |name: &str| {
        let worlds = files.iter().map(|f| read_world(name, f, &WorldOptions::default()));
        worlds.flatten().map(|(world, _)| world.solids.len() + world.polygons.len()).sum::<usize>()
    };
    // Three brushes, a skew quad and two panels; one face that is there twice and two panels.
    assert_eq!((count("x"), count("x.obj")), (3 + 2 + 4, 1 + 4));
}

#[test]
fn truncated_files_do_not_panic() {
    for file in files() {
        for end in 0..file.len() {
            parse(&file[..end]);
        }
    }
}

#[test]
fn lying_numbers_do_not_panic() {
    // Every four bytes of a binary file, and every digit of a text, say something else.
    for file in files() {
        for at in 0..file.len() {
            if file[at].is_ascii_digit() {
                for number in ["", "-1", "99999999", "4294967296", "18446744073709551616", "1/0"] {
                    parse(&[&file[..at], number.as_bytes(), &file[at + 1..]].concat());
                }
            }
            for number in [-1i32, 0, 1, 255, i32::MAX, i32::MIN, i32::MAX - 3] {
                let mut lying = file.clone();
                for (byte, new) in lying[at..].iter_mut().zip(number.to_le_bytes()) {
                    *byte = new;
                }
                parse(&lying);
            }
        }
    }
}

/// The words that the text formats are made of.
fn word() -> impl Strategy<Value = &'static str> {
    prop::sample::select(vec![
        "PRT1",
        "PRT2",
        "PRT1-AM",
        "\n",
        " ",
        "0",
        "1",
        "2",
        "3",
        "-1",
        "(",
        ")",
        "(0 0 0 )",
        "(1 0 0 )",
        "(0 1 0 )",
        "(0 .5 1e-3 )",
        "1/3",
        "1e4096",
        "-0.000001",
        "{",
        "}",
        "[",
        "]",
        ",",
        ":",
        "\"",
        "\"about\"",
        "\"origin\"",
        "patchDef2",
        "brushDef",
        "(0 0 0) (0 1 0) (0 0 1) hint 0 0 0 1 1",
        "//",
        "\"format\"",
        "\"stabline-scene/1\"",
        "\"cells\"",
        "\"portals\"",
        "null",
        "true",
        "1e99999",
        "99999999999999999999",
        "\u{e4}",
    ])
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 512,
        failure_persistence: None,
        ..ProptestConfig::default()
    })]

    #[test]
    fn arbitrary_bytes_do_not_panic(bytes in prop::collection::vec(any::<u8>(), 0..400)) {
        parse(&bytes);
    }

    #[test]
    fn arbitrary_words_do_not_panic(words in prop::collection::vec(word(), 0..60)) {
        parse(words.concat().as_bytes());
        parse(words.join(" ").as_bytes());
    }

    /// Numbers of a level replaced by others that are almost right, or far out.
    #[test]
    fn damaged_levels_do_not_panic(
        level in prop::sample::select(levels()),
        damage in prop::collection::vec(
            (any::<prop::sample::Index>(), 0usize..8, -5i32..6, any::<bool>()), 1..5),
        end in any::<prop::sample::Index>(),
    ) {
        let mut damaged = level.clone();
        for (at, base, offset, in_header) in damage {
            let words = if in_header { 40 } else { level.len() / 4 };
            let at = 4 * at.index(words);
            let old = i32::from_le_bytes(damaged[at..at + 4].try_into().unwrap());
            let end = level.len() as i32;
            let bases = [0, old, end, i32::MAX - 5, i32::MIN + 5, 1 << 16, 20, 1 << 29];
            let number = bases[base].wrapping_add(offset);
            damaged[at..at + 4].copy_from_slice(&number.to_le_bytes());
        }
        parse(&damaged);
        parse(&damaged[..end.index(damaged.len())]);
    }

    #[test]
    fn damaged_files_do_not_panic(
        file in prop::sample::select(files()),
        damage in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..6),
        cut in any::<prop::sample::Index>(),
        splice in any::<prop::sample::Index>(),
    ) {
        let mut damaged = file.clone();
        for (at, byte) in damage {
            damaged[at.index(file.len())] = byte;
        }
        parse(&damaged);
        let (a, b) = (cut.index(file.len()), splice.index(file.len()));
        parse(&[&damaged[..a], &damaged[b..]].concat());
    }
}
