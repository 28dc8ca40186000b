//! Levels are made here by hand: a directory and the three lumps that visibility needs.

use super::*;

/// A Quake level of `leafs` leafs with visibility (and one of a moving part), whose lumps lie in
/// the order leafs, visibility, models, followed by a BSPX directory with one entry.
fn quake(magic: &[u8; 4], record: usize, leafs: usize, visdata: &[u8], offsets: &[i32]) -> Vec<u8> {
    let mut bytes = vec![0; 124];
    bytes[..4].copy_from_slice(magic);
    let lump = |bytes: &mut Vec<u8>, number: usize, data: &[u8]| {
        bytes.resize(bytes.len().next_multiple_of(4), 0);
        let entry = 4 + 8 * number;
        let place = bytes.len() as i32;
        bytes[entry..entry + 4].copy_from_slice(&place.to_le_bytes());
        bytes[entry + 4..entry + 8].copy_from_slice(&(data.len() as i32).to_le_bytes());
        bytes.extend_from_slice(data);
    };
    let mut leaf_lump = vec![0x55; record * (leafs + 2)];
    for (leaf, offset) in (0..).zip([-1i32].iter().chain(offsets).chain(&[-1])) {
        leaf_lump[leaf * record + 4..][..4].copy_from_slice(&offset.to_le_bytes());
    }
    lump(&mut bytes, 10, &leaf_lump);
    lump(&mut bytes, 4, visdata);
    let mut model = vec![0; 64];
    model[52..56].copy_from_slice(&(leafs as i32).to_le_bytes());
    lump(&mut bytes, 14, &model);
    let place = bytes.len() as i32 + 8 + 32;
    bytes.extend_from_slice(b"BSPX\x01\0\0\0");
    bytes.extend_from_slice(b"SOMETHING\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0");
    bytes.extend_from_slice(&place.to_le_bytes());
    bytes.extend_from_slice(&4i32.to_le_bytes());
    bytes.extend_from_slice(b"tail");
    bytes
}

/// Two rows for ten leafs: one sees leafs 0 and 9, the other nothing.
fn ten_leafs(magic: &[u8; 4], record: usize) -> Vec<u8> {
    quake(magic, record, 10, &[1, 2, 0, 2], &[0, 2, 2, 2, 2, 2, 2, 2, 2, -1])
}

const QUAKE_FORMATS: [(&[u8; 4], usize); 4] =
    [(b"\x1d\0\0\0", 28), (b"\x1e\0\0\0", 28), (b"BSP2", 44), (b"2PSB", 32)];

#[test]
fn quake_rows_are_read() {
    for (magic, record) in QUAKE_FORMATS {
        let visibility = Visibility::read(&ten_leafs(magic, record)).unwrap();
        let matrix = &visibility.matrix;
        assert_eq!((matrix.size(), visibility.rows_missing), (10, 1));
        for column in 0..10 {
            assert_eq!(matrix.get(0, column), column == 0 || column == 9);
            assert!(!matrix.get(3, column));
            assert!(matrix.get(9, column));
        }
        assert_eq!(matrix.row(9), [0xff, 0x03]);
    }
}

#[test]
fn what_is_written_reads_back_and_the_rest_is_kept() {
    for (magic, record) in QUAKE_FORMATS {
        let level = ten_leafs(magic, record);
        for density in [1, 3, 7, 1000] {
            let mut matrix = BitMatrix::new(10);
            for (row, column) in (0..100).map(|i| (i / 10, i % 10)) {
                if (row * 31 + column * 17) % density == 0 {
                    matrix.set(row, column);
                }
            }
            let written = write_visibility(&level, &matrix).unwrap();
            let read = Visibility::read(&written).unwrap();
            assert_eq!((read.matrix, read.rows_missing), (matrix.clone(), 0));
            assert_eq!(write_visibility(&written, &matrix).unwrap(), written);
            assert!(written.ends_with(b"tail"));
            let entry = written.len() - 4 - 8;
            assert_eq!(layout::int(&written, entry) as usize, written.len() - 4);
            // The model lump moved with its content.
            let models = layout::int(&written, 4 + 8 * 14) as usize;
            assert_eq!(models % 4, 0);
            assert_eq!(layout::int(&written, models + 52), 10);
            // Nothing before the visibility changed but the rows' offsets and the directory.
            let leafs = layout::int(&level, 4 + 8 * 10) as usize;
            for at in
                (leafs..leafs + record * 12).filter(|at| !(4..8).contains(&((at - leafs) % record)))
            {
                assert_eq!(written[at], level[at]);
            }
        }
    }
}

#[test]
fn a_level_without_visibility_gets_some() {
    let level = quake(b"BSP2", 44, 3, &[], &[-1, -1, -1]);
    let error = Visibility::read(&level).unwrap_err();
    assert_eq!(error.kind, BspErrorKind::NoVisibility);
    let mut matrix = BitMatrix::new(3);
    matrix.set(1, 2);
    let written = write_visibility(&level, &matrix).unwrap();
    assert_eq!(Visibility::read(&written).unwrap().matrix, matrix);
    assert!(written.ends_with(b"tail"));
}

#[test]
fn a_level_without_leafs_is_not_written() {
    let error = write_visibility(&quake(b"BSP2", 44, 0, &[0], &[]), &BitMatrix::new(0));
    assert_eq!(error.unwrap_err().kind, BspErrorKind::NoVisibility);
}

#[test]
fn visibility_that_lies_over_the_directory_is_not_replaced() {
    let mut level = quake(b"BSP2", 44, 4, &[1], &[0, 0, 0, 0]);
    level[4 + 8 * 4..][..4].copy_from_slice(&0i32.to_le_bytes());
    let matrix = Visibility::read(&level).unwrap().matrix;
    let error = write_visibility(&level, &matrix).unwrap_err();
    assert_eq!(error.kind, BspErrorKind::NotReadBack);
}

#[test]
fn long_runs_of_zeros_are_split() {
    let leafs = 8 * 600;
    let level = quake(b"BSP2", 44, leafs, &[0, 255, 0, 255, 0, 90], &vec![0; leafs]);
    let mut matrix = BitMatrix::new(leafs);
    assert_eq!(Visibility::read(&level).unwrap().matrix, matrix);
    matrix.set(7, 4000);
    let written = write_visibility(&level, &matrix).unwrap();
    assert_eq!(Visibility::read(&written).unwrap().matrix, matrix);
}

fn quake2(rows: &[u8], offsets: &[i32]) -> Vec<u8> {
    let mut lump = (offsets.len() as i32).to_le_bytes().to_vec();
    for offset in offsets {
        lump.extend_from_slice(&offset.to_le_bytes());
        lump.extend_from_slice(&0i32.to_le_bytes());
    }
    lump.extend_from_slice(rows);
    with_lump(b"IBSP\x26\0\0\0", 19, 3, &lump)
}

fn with_lump(magic: &[u8; 8], lumps: usize, number: usize, lump: &[u8]) -> Vec<u8> {
    let mut bytes = vec![0; 8 + 8 * lumps];
    bytes[..8].copy_from_slice(magic);
    let place = bytes.len() as i32;
    bytes[8 + 8 * number..][..4].copy_from_slice(&place.to_le_bytes());
    bytes[12 + 8 * number..][..4].copy_from_slice(&(lump.len() as i32).to_le_bytes());
    bytes.extend_from_slice(lump);
    bytes
}

#[test]
fn quake2_rows_are_read() {
    let level = quake2(&[1, 3, 2], &[28, 29, 30]);
    let matrix = Visibility::read(&level).unwrap().matrix;
    assert_eq!([0, 1, 2].map(|row| matrix.row(row)[0]), [1, 3, 2]);
}

/// The rows of what is heard, read through a level that has them in the place of what is seen.
fn quake2_heard(level: &[u8]) -> BitMatrix {
    let place = layout::int(level, 8 + 8 * 3) as usize;
    let mut swapped = level.to_vec();
    for cluster in 0..layout::int(level, place) as usize {
        let at = place + 4 + 8 * cluster;
        swapped[at..at + 4].copy_from_slice(&level[at + 4..at + 8]);
    }
    Visibility::read(&swapped).unwrap().matrix
}

#[test]
fn quake2_rows_are_written_with_what_is_heard() {
    // 1200 clusters in a row, each seeing its neighbours: so each hears two to either side.
    let clusters = 1200;
    let [mut seen, mut heard] = [BitMatrix::new(clusters), BitMatrix::new(clusters)];
    for (matrix, reach) in [(&mut seen, 1), (&mut heard, 2)] {
        for row in 0..clusters {
            (row.saturating_sub(reach)..(row + reach + 1).min(clusters))
                .for_each(|column| matrix.set(row, column));
        }
    }
    let all = vec![0xff; clusters / 8];
    let mut level = quake2(&all, &vec![4 + 8 * clusters as i32; clusters]);
    let behind = level.len() as i32;
    level.extend_from_slice(b"tail");
    level[8 + 8 * 11..][..4].copy_from_slice(&behind.to_le_bytes());
    level[12 + 8 * 11..][..4].copy_from_slice(&4i32.to_le_bytes());
    let written = write_visibility(&level, &seen).unwrap();
    assert_eq!(Visibility::read(&written).unwrap().matrix, seen);
    assert_eq!(quake2_heard(&written), heard);
    assert_eq!(write_visibility(&written, &seen).unwrap(), written);
    // What lies behind moved, and its entry followed.
    assert!(written.ends_with(b"tail"));
    assert_eq!(layout::int(&written, 8 + 8 * 11) as usize, written.len() - 4);

    // A cluster that does not even see itself hears itself.
    let written = write_visibility(&level, &BitMatrix::new(clusters)).unwrap();
    assert!((0..clusters).all(|cluster| quake2_heard(&written).get(cluster, cluster)));
    let other = write_visibility(&level, &BitMatrix::new(7)).unwrap_err();
    assert_eq!(other.kind, BspErrorKind::OtherLevel { expected: clusters, got: 7 });
}

#[test]
fn quake3_rows_are_read_and_written() {
    let lump = [&2i32.to_le_bytes()[..], &8i32.to_le_bytes(), &[0xff; 16]].concat();
    let level = with_lump(b"IBSP\x2e\0\0\0", 17, 16, &lump);
    assert_eq!(Visibility::read(&level).unwrap().matrix.row(1), [3]);
    let mut matrix = BitMatrix::new(2);
    matrix.set(1, 0);
    let written = write_visibility(&level, &matrix).unwrap();
    assert_eq!(written.len(), level.len());
    assert_eq!(Visibility::read(&written).unwrap().matrix, matrix);
}

#[test]
fn a_broken_rule_is_named_with_its_byte() {
    let good = ten_leafs(b"\x1d\0\0\0", 28);
    let patched = |at: usize, value: i32| {
        let mut bytes = good.clone();
        bytes[at..at + 4].copy_from_slice(&value.to_le_bytes());
        Visibility::read(&bytes).unwrap_err().to_string()
    };
    let models = layout::int(&good, 4 + 8 * 14) as usize;
    let leafs = layout::int(&good, 4 + 8 * 10) as usize;
    assert!(patched(0, 28).starts_with("byte 0: not a level of a known format"));
    assert!(patched(4 + 8 * 4, 1 << 20).contains("lump 4 (visibility) lies at 1048576"));
    assert!(patched(4 + 8 * 4, -1).contains("lump 4 (visibility) lies at -1"));
    assert!(patched(8 + 8 * 10, 27).contains("the lump of leafs has 27 bytes, expected 28 a leaf"));
    assert!(patched(8 + 8 * 14, 63).contains("the lump of models has 63 bytes"));
    assert!(patched(models + 52, 12).contains("12 leafs or clusters with visibility"));
    assert!(patched(models + 52, -1).contains("-1 leafs or clusters with visibility"));
    assert!(patched(models + 52, 0).contains("the level has no visibility data"));
    let row = leafs + 28 + 4;
    assert!(patched(row, 5).contains("the row of leaf or cluster 0 begins at 5"));
    assert!(patched(row, -2).contains("the row of leaf or cluster 0 begins at -2"));
    assert!(patched(row, 3).contains("the row of leaf or cluster 0 does not end after 2 bytes"));
    assert!(patched(row, 3).starts_with(&format!("byte {row}:")));
    assert!(Visibility::read(&good[..100]).unwrap_err().to_string().contains("list of lumps"));
    let other = write_visibility(&good, &BitMatrix::new(9)).unwrap_err();
    assert_eq!(other.kind, BspErrorKind::OtherLevel { expected: 10, got: 9 });
}

/// A level of three leafs with visibility, cut in two by x = 2, and the right half by y = -1/2.
fn with_tree(magic: &[u8; 4]) -> Vec<u8> {
    let (record, wide, node) = match magic {
        b"BSP2" => (44, true, 44),
        b"2PSB" => (32, true, 32),
        _ => (28, false, 24),
    };
    let mut bytes = quake(magic, record, 3, &[7, 7, 7], &[0, 1, 2]);
    let mut lump = |number: usize, data: &[u8]| {
        let (entry, place) = (4 + 8 * number, bytes.len() as i32);
        bytes[entry..entry + 4].copy_from_slice(&place.to_le_bytes());
        bytes[entry + 4..entry + 8].copy_from_slice(&(data.len() as i32).to_le_bytes());
        bytes.extend_from_slice(data);
    };
    let mut planes = Vec::new();
    for numbers in [[0.0f32, 1.0, 0.0, -0.5], [1.0, 0.0, 0.0, 2.0]] {
        numbers.iter().for_each(|number| planes.extend(number.to_le_bytes()));
        planes.extend([0; 4]);
    }
    lump(1, &planes);
    let mut nodes = Vec::new();
    for [plane, front, back] in [[1, 1, -2], [0, -3, -4]] {
        let start = nodes.len();
        nodes.extend(i32::to_le_bytes(plane));
        for child in [front, back] {
            match wide {
                true => nodes.extend(i32::to_le_bytes(child)),
                false => nodes.extend(i16::to_le_bytes(child as i16)),
            }
        }
        nodes.resize(start + node, 0);
    }
    lump(5, &nodes);
    bytes
}

/// Where a lump begins.
fn place_of(bytes: &[u8], lump: usize) -> usize {
    layout::int(bytes, 4 + 8 * lump) as usize
}

#[test]
fn trees_are_read() {
    use crate::num::Int;
    for (magic, _) in QUAKE_FORMATS {
        let bytes = with_tree(magic);
        let models = place_of(&bytes, 14);
        assert_eq!(layout::int(&bytes, models + 36), 0);
        let tree = LevelTree::read(&bytes).unwrap();
        assert_eq!(tree.root, LevelChild::Node(0));
        let [x, y] = &tree.nodes[..] else { panic!("two nodes") };
        assert_eq!((x.front, x.back), (LevelChild::Node(1), LevelChild::Leaf(1)));
        assert_eq!((y.front, y.back), (LevelChild::Leaf(2), LevelChild::Leaf(3)));
        assert_eq!(x.plane.offset, Int::from(2));
        assert_eq!(y.plane.normal, [0, 2, 0].map(Int::from));
        assert_eq!(y.plane.offset, Int::from(-1));
        // The solid outside, three leafs with visibility, and one of a moving part.
        assert_eq!(tree.contents, [0x5555_5555; 5]);
    }
}

#[test]
fn broken_trees_are_refused() {
    let bytes = with_tree(b"BSP2");
    let (planes, nodes) = (place_of(&bytes, 1), place_of(&bytes, 5));
    let error = |at: usize, value: i32| {
        let mut bytes = bytes.clone();
        bytes[at..at + 4].copy_from_slice(&value.to_le_bytes());
        let error = LevelTree::read(&bytes).unwrap_err();
        (error.offset, error.kind)
    };
    let nan = f32::NAN.to_bits().cast_signed();
    assert_eq!(error(planes + 24, nan), (planes + 20, BspErrorKind::NotFinite));
    let plane = |node, plane| BspErrorKind::NodePlane { node, plane };
    assert_eq!(error(nodes, 2), (nodes, plane(0, 2)));
    assert_eq!(error(nodes + 44, -1), (nodes + 44, plane(1, -1)));
    let child = |child, first| BspErrorKind::NodeChild { child, first, nodes: 2 };
    // A loop, a node too many, a leaf too many.
    assert_eq!(error(nodes + 44 + 4, 1), (nodes + 48, child(1, 2)));
    assert_eq!(error(nodes + 4, 2), (nodes + 4, child(2, 1)));
    assert_eq!(error(nodes + 8, -6), (nodes + 8, child(-6, 1)));
    assert_eq!(error(nodes + 8, i32::MIN).1, child(i32::MIN, 1));
    let models = place_of(&bytes, 14);
    assert_eq!(error(models + 36, 7), (models + 36, child(7, 0)));
    assert!(matches!(error(4 + 8 * 5 + 4, 87).1, BspErrorKind::LumpLength { what: "nodes", .. }));
    let quake2 = [&b"IBSP\x26\0\0\0"[..], &[0; 200]].concat();
    let kind = LevelTree::read(&quake2).unwrap_err().kind;
    assert_eq!(kind, BspErrorKind::NoTree(BspFormat::Quake2));
}
