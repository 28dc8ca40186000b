//! Doom levels: any bytes give an archive or an error, a map names only what it has, and a REJECT
//! table reads back.
#![no_main]

use libfuzzer_sys::fuzz_target;
use stabline::formats::wad::{Archive, RejectTable};

fuzz_target!(|bytes: &[u8]| {
    let Ok(archive) = Archive::read(bytes) else { return };
    for map in archive.maps().into_iter().flat_map(|name| archive.map(name)) {
        let count = |len: usize| move |&index: &u32| (index as usize) < len;
        assert!(map.sidedefs.iter().all(count(map.sectors)));
        for line in &map.linedefs {
            assert!([line.start, line.end].iter().all(count(map.vertices.len())));
            assert!([line.front, line.back].iter().flatten().all(count(map.sidedefs.len())));
        }
        if let Some(Ok(table)) = map.reject.map(|lump| RejectTable::read(&lump, map.sectors)) {
            assert_eq!(RejectTable::read(table.bytes(), map.sectors), Ok(table));
        }
    }
});
