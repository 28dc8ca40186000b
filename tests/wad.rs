//! Doom levels, read from their bytes: every form, and what is wrong with those that are refused.

mod support;

use proptest::prelude::*;
use stabline::formats::wad::{Archive, DoomMap, MapForm, RejectError, RejectTable};
use stabline::num::Number;
use support::wads::{Level, archive, two_rooms};

const FORMS: [MapForm; 3] = [MapForm::Doom, MapForm::Hexen, MapForm::Udmf];

fn read(bytes: &[u8], map: &str) -> Result<DoomMap, String> {
    let archive = Archive::read(bytes).map_err(|error| error.to_string())?;
    archive.map(map).map_err(|error| error.to_string())
}

/// The archive of a level in which the content of `lump` is another, or the lump is missing.
fn with_lump(level: &Level, form: MapForm, lump: &str, content: Option<&[u8]>) -> Vec<u8> {
    let mut lumps = vec![("MAP01", Vec::new())];
    lumps.extend(level.lumps(form));
    match (content, lumps.iter().position(|(name, _)| *name == lump)) {
        (Some(content), Some(at)) => lumps[at].1 = content.to_vec(),
        (None, Some(at)) => drop(lumps.remove(at)),
        (_, None) => panic!("no lump {lump}"),
    }
    archive(&lumps)
}

/// The error of a map of which a lump is another, or missing.
fn lump_error(lump: &str, form: MapForm, content: Option<&[u8]>) -> String {
    read(&with_lump(&two_rooms(), form, lump, content), "MAP01").unwrap_err()
}

/// The error of a text.
fn text_error(text: &str) -> String {
    lump_error("TEXTMAP", MapForm::Udmf, Some(text.as_bytes()))
}

#[test]
fn every_form_of_a_map_says_the_same() {
    let level = two_rooms();
    let mut maps = FORMS.map(|form| {
        let map = read(&level.archive("E1M1", form), "e1m1").unwrap();
        assert_eq!((map.name.as_str(), map.form, map.sectors), ("E1M1", form, 2));
        assert_eq!(map.reject.as_deref(), Some(&[6][..]));
        map
    });
    let lines: Vec<_> = maps[2].linedefs.iter().map(|line| line.line.unwrap()).collect();
    assert_eq!(lines, [9, 13, 17, 21, 25, 29, 33]);
    for map in &mut maps {
        map.form = MapForm::Doom;
        map.linedefs.iter_mut().for_each(|line| line.line = None);
    }
    assert_eq!(maps[0], maps[1]);
    assert_eq!(maps[0], maps[2]);
    let [x, y] = &maps[0].vertices[4];
    assert_eq!((x, y), (&Number::Small(256, 1), &Number::Small(128, 1)));
    let last = maps[0].linedefs[6];
    assert_eq!((last.start, last.end, last.front, last.back), (3, 0, Some(6), Some(7)));
    assert!(last.is_flagged_two_sided && !maps[0].linedefs[0].is_flagged_two_sided);
    assert_eq!(maps[0].sidedefs, [0, 0, 0, 1, 1, 1, 0, 1]);
}

#[test]
fn maps_are_found_by_what_follows_their_markers() {
    let (level, other) = (two_rooms(), Level { sectors: 7, ..two_rooms() });
    let mut lumps = vec![("PLAYPAL", vec![1, 2, 3]), ("MAP01", Vec::new())];
    lumps.extend(level.lumps(MapForm::Doom));
    lumps.push(("tower", b"text".to_vec()));
    lumps.extend(level.lumps(MapForm::Udmf));
    lumps.push(("MAP02", Vec::new()));
    lumps.push(("MAP01", Vec::new()));
    lumps.extend(other.lumps(MapForm::Hexen));
    let bytes = archive(&lumps);
    assert_eq!(Archive::read(&bytes).unwrap().maps(), ["MAP01", "TOWER", "MAP01"]);
    assert_eq!(read(&bytes, "Tower").unwrap().form, MapForm::Udmf);
    let last = read(&bytes, "MAP01").unwrap();
    assert_eq!((last.form, last.sectors), (MapForm::Hexen, 7));
    let expected = "map MAP02: there is no such map; the archive has MAP01, TOWER, MAP01";
    assert_eq!(read(&bytes, "MAP02").unwrap_err(), expected);
    assert_eq!(
        read(&archive(&[]), "E1M1").unwrap_err(),
        "map E1M1: there is no such map; the archive has no map"
    );
}

#[test]
fn a_text_is_read_exactly() {
    let text = "VERTEX{x=-0.1;y=1e-3;}vertex { x = 1; x = 123456789012345678901.5; y = 0; z = 7; }\n\
        LineDef // from a { to b\n{ v1 = 0x0; V2 = 1; comment = \"a } \\\" ; // \";\nsideback = 0; \
        sidefront = -1; TwoSided = TRUE; user_x = a/b; }\
        /* sector { }\n*/ sidedef { sector = 0; } sector { } unknown { x = none; }\n";
    let lumps = [("M", vec![]), ("TEXTMAP", text.as_bytes().to_vec()), ("ZNODES", vec![])];
    let map = read(&archive(&lumps), "M").unwrap();
    let number = |text| Number::parse(text).unwrap();
    assert_eq!(map.vertices[0], [number("-1/10"), number("1/1000")]);
    assert_eq!(map.vertices[1], [number("123456789012345678901.5"), number("0")]);
    let line = map.linedefs[0];
    assert_eq!((line.start, line.end, line.front, line.back), (0, 1, None, Some(0)));
    assert_eq!((line.is_flagged_two_sided, line.line), (true, Some(2)));
    assert_eq!((map.sidedefs, map.sectors, map.reject), (vec![0], 1, None));
}

#[test]
fn errors_in_an_archive_name_the_byte() {
    let message = |bytes: &[u8]| Archive::read(bytes).unwrap_err().to_string();
    let bytes = two_rooms().archive("MAP01", MapForm::Doom);
    let changed = |at: usize, number: i32| {
        let mut bytes = bytes.clone();
        bytes[at..at + 4].copy_from_slice(&number.to_le_bytes());
        message(&bytes)
    };
    let (length, directory) = (bytes.len(), bytes.len() - 7 * 16);
    assert_eq!(message(b""), "byte 0: not an archive of Doom, expected IWAD or PWAD");
    assert_eq!(message(b"PWAD\x01"), "byte 5: the file ends inside its header of 12 bytes");
    for (at, number, count, offset) in [
        (4, i32::MAX, i32::MAX, directory as i32),
        (4, -1, -1, directory as i32),
        (8, -4, 7, -4),
        (8, directory as i32 + 1, 7, directory as i32 + 1),
    ] {
        let expected = format!(
            "byte 4: a directory of {count} lumps at byte {offset}, the file has {length} bytes"
        );
        assert_eq!(changed(at, number), expected);
    }
    for (at, number) in [(32, -1), (32, length as i32), (36, -1), (36, i32::MAX)] {
        let error = changed(directory + at, number);
        let start = format!("byte {}: lump LINEDEFS at byte ", directory + 32);
        assert!(error.starts_with(&start), "{error}");
        assert!(error.contains(&number.to_string()), "{error}");
    }
    // A marker needs no place.
    let mut lost = bytes;
    lost[directory..directory + 4].copy_from_slice(&(-1i32).to_le_bytes());
    assert!(read(&lost, "MAP01").is_ok());
}

#[test]
fn errors_in_records_name_the_record() {
    let level = two_rooms();
    for form in [MapForm::Doom, MapForm::Hexen] {
        for lump in ["LINEDEFS", "SIDEDEFS", "VERTEXES", "SECTORS"] {
            let error = lump_error(lump, form, None);
            assert_eq!(error, format!("map MAP01: the map has no lump {lump}"));
            let error = lump_error(lump, form, Some(&[0; 33]));
            let start = format!("map MAP01: lump {lump} has 33 bytes, expected a multiple of ");
            assert!(error.starts_with(&start), "{error}");
        }
        let (mut vertex, mut side, mut sector) = (level.clone(), level.clone(), level.clone());
        vertex.lines[2].end = 6;
        side.lines[6].back = Some(8);
        sector.sides[7] = 2;
        for (level, expected) in [
            (vertex, "LINEDEFS, record 2: names vertex 6, but there are 6, counted from 0"),
            (side, "LINEDEFS, record 6: names sidedef 8, but there are 8, counted from 0"),
            (sector, "SIDEDEFS, record 7: names sector 2, but there are 2, counted from 0"),
        ] {
            let error = read(&level.archive("M", form), "M").unwrap_err();
            assert_eq!(error, format!("map M, {expected}"));
            let error = read(&level.archive("M", MapForm::Udmf), "M").unwrap_err();
            let what = expected.split_once(": ").unwrap().1;
            assert!(error.starts_with("map M, TEXTMAP, line ") && error.ends_with(what), "{error}");
        }
    }
    let mut lumps = vec![("MAP01", Vec::new()), ("LEAFS", Vec::new())];
    lumps.extend(level.lumps(MapForm::Doom));
    let error = read(&archive(&lumps), "MAP01").unwrap_err();
    assert_eq!(error, "map MAP01: a map of Doom 64 (lump LEAFS), which is not read");
}

#[test]
fn errors_in_a_text_name_the_line() {
    for (text, expected) in [
        ("\n\n vertex { x = 1; }\n", "line 3: a vertex without `y`"),
        ("linedef {\n v1 = 0;\n }", "line 1: a linedef without `v2`"),
        ("sidedef { }", "line 1: a sidedef without `sector`"),
        ("vertex {\nx = nan;", "line 2: `x` = `nan`: not a decimal number or a ratio"),
        ("vertex {\nx = 1e9999;", "line 2: `x` = `1e9999`: the exponent is larger than 4096"),
        ("vertex { x = \"1\";", "line 1: expected a number, got a text in quotation marks"),
        ("linedef { v1 = 1.0;", "line 1: `v1` = `1.0`: expected an index, counted from 0"),
        ("linedef { sideback = -2;", "line 1: `sideback` = `-2`: expected an index"),
        ("linedef { v1 = 4294967296;", "line 1: `v1` = `4294967296`: expected an index"),
        ("sector", "line 1: expected `{` or `=`, got the end of the text"),
        ("sector {", "line 1: expected a field or `}`, got the end of the text"),
        ("sector { x { } }", "line 1: expected `=`, got `{`"),
        ("sector { x = ; }", "line 1: expected a value, got `;`"),
        ("sector { x = 1 }", "line 1: expected `;`, got `}`"),
        ("} sector", "line 1: expected the name of a block or a field, got `}`"),
        ("/* \n", "line 1: expected `*/`, got the end of the text"),
        ("a = \"\n", "line 2: expected a quotation mark, got the end of the text"),
        ("a = \0", "line 1: byte 0x00, expected a text"),
    ] {
        let (error, start) = (text_error(text), format!("map MAP01, TEXTMAP, {expected}"));
        assert!(error.starts_with(&start), "{text:?}: {error}");
    }
}

#[test]
fn a_reject_lump_is_bits_row_by_row() {
    let table = RejectTable::read(&[0b0000_0110, 0b1111_1110, 9], 3).unwrap();
    let pairs: Vec<_> = (0..9).map(|pair| table.rejects(pair / 3, pair % 3)).collect();
    let rejected: Vec<_> = (0..9).filter(|&pair| pairs[pair]).collect();
    assert_eq!((rejected, table.bytes()), (vec![1, 2], &[6, 0][..]));
    assert_eq!(RejectTable::read(&[], 3), Err(RejectError::Empty));
    let short = RejectError::Short { got: 1, expected: 2 };
    assert_eq!(RejectTable::read(&[0], 3), Err(short));
    assert!(RejectTable::read(&[], 0).is_ok() && RejectTable::new(0).bytes().is_empty());
}

proptest! {
    #[test]
    fn a_reject_table_reads_back(pairs in prop::collection::vec((0usize..13, 0usize..13), 0..60)) {
        let mut table = RejectTable::new(13);
        for &(from, to) in &pairs {
            table.reject(from, to);
        }
        let read = RejectTable::read(table.bytes(), 13).unwrap();
        prop_assert_eq!(&read, &table);
        for pair in (0..13).flat_map(|from| (0..13).map(move |to| (from, to))) {
            prop_assert_eq!(read.rejects(pair.0, pair.1), pairs.contains(&pair));
        }
    }

    #[test]
    fn damaged_archives_do_not_panic(
        form in 0usize..3,
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..6),
        end in any::<prop::sample::Index>(),
    ) {
        let mut bytes = two_rooms().archive("MAP01", FORMS[form]);
        for (at, byte) in &changes {
            let at = at.index(bytes.len());
            bytes[at] = *byte;
        }
        for bytes in [&bytes[..], &bytes[..end.index(bytes.len())]] {
            if let Ok(archive) = Archive::read(bytes) {
                archive.maps().into_iter().for_each(|map| drop(archive.map(map)));
            }
        }
    }
}

#[test]
fn truncated_archives_are_errors_and_truncated_lumps_never_read_as_whole() {
    for form in FORMS {
        let bytes = two_rooms().archive("MAP01", form);
        for end in 0..bytes.len() {
            assert!(Archive::read(&bytes[..end]).is_err(), "{end}");
        }
        let whole = read(&bytes, "MAP01").unwrap();
        for (lump, content) in two_rooms().lumps(form) {
            let needed = ["LINEDEFS", "SIDEDEFS", "VERTEXES", "SECTORS", "TEXTMAP", "REJECT"];
            if !needed.contains(&lump) {
                continue;
            }
            for end in 0..content.trim_ascii_end().len() {
                let bytes = with_lump(&two_rooms(), form, lump, Some(&content[..end]));
                match read(&bytes, "MAP01") {
                    Ok(map) => assert_ne!(map, whole, "{lump} {end}"),
                    Err(error) => assert!(error.starts_with("map MAP01"), "{error}"),
                }
            }
        }
    }
}
