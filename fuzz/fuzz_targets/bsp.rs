//! Levels: every way down a tree ends in a leaf, and what is written into a level reads back.
#![no_main]

use libfuzzer_sys::fuzz_target;
use stabline::formats::bsp::{BspErrorKind, LevelChild, LevelTree, Visibility, write_visibility};

fuzz_target!(|bytes: &[u8]| {
    if let Ok(tree) = LevelTree::read(bytes) {
        for (index, node) in tree.nodes.iter().enumerate() {
            for child in [node.front, node.back] {
                match child {
                    LevelChild::Node(child) => assert!(child as usize > index),
                    LevelChild::Leaf(leaf) => assert!((leaf as usize) < tree.contents.len()),
                }
            }
        }
    }
    let Ok(read) = Visibility::read(bytes) else { return };
    match write_visibility(bytes, &read.matrix) {
        Ok(written) => {
            let again = Visibility::read(&written).unwrap();
            assert_eq!(again.matrix, read.matrix);
            assert_eq!(again.rows_missing, 0);
        }
        Err(error) => assert!(matches!(
            error.kind,
            BspErrorKind::Overlap(_)
                | BspErrorKind::NotReadBack
                | BspErrorKind::LumpOutside { .. }
        )),
    }
});
