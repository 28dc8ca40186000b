//! Levels: what is written into a level reads back.
#![no_main]

use libfuzzer_sys::fuzz_target;
use stabline::formats::bsp::{BspErrorKind, Visibility, write_visibility};

fuzz_target!(|bytes: &[u8]| {
    let Ok(read) = Visibility::read(bytes) else { return };
    match write_visibility(bytes, &read.matrix) {
        Ok(written) => {
            let again = Visibility::read(&written).unwrap();
            assert_eq!(again.matrix, read.matrix);
            assert_eq!(again.rows_missing, 0);
        }
        Err(error) => assert!(matches!(
            error.kind,
            BspErrorKind::ReadOnlyFormat(_)
                | BspErrorKind::Overlap(_)
                | BspErrorKind::NotReadBack
                | BspErrorKind::LumpOutside { .. }
        )),
    }
});
