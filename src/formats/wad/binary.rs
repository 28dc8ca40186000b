//! Maps in records: Doom's form and Hexen's.

use super::archive::MapLumps;
use super::{DoomMap, Linedef, MAX_SECTORS, MapForm, WadError, WadErrorKind, WadPlace};
use crate::num::Number;

/// The index that means none.
const NONE: u16 = 0xffff;
/// The bit of a linedef's flags that says that it has two sides.
const TWO_SIDED: u16 = 4;

/// Reads a map.
///
/// # Errors
/// [`WadError`] names the lump, the record and the rule broken.
pub(super) fn read(lumps: &MapLumps<'_, '_>, form: MapForm) -> Result<DoomMap, WadError> {
    let vertices = records(lumps, "VERTEXES", 4)?;
    let vertices = vertices.map(|record| [0, 2].map(|at| coordinate(record, at))).collect();
    let sectors = records(lumps, "SECTORS", 26)?.count();
    if sectors > MAX_SECTORS {
        return Err(lumps.error(WadErrorKind::TooManySectors { got: sectors }));
    }
    let sidedefs = records(lumps, "SIDEDEFS", 30)?;
    let sidedefs = sidedefs.map(|record| u32::from(word(record, 28))).collect();
    let record_bytes = if form == MapForm::Hexen { 16 } else { 14 };
    let linedefs = records(lumps, "LINEDEFS", record_bytes)?.map(linedef).collect();
    let reject = lumps.find("REJECT").map(<[u8]>::to_vec);
    let name = lumps.name.to_owned();
    let map = DoomMap { name, form, vertices, linedefs, sidedefs, sectors, reject };
    let place = |lump, record| WadPlace::Record { map: lumps.name.to_owned(), lump, record };
    map.check_indices(place)?;
    Ok(map)
}

/// The records of a lump.
fn records<'a>(
    lumps: &MapLumps<'_, 'a>,
    lump: &'static str,
    record: usize,
) -> Result<std::slice::ChunksExact<'a, u8>, WadError> {
    let bytes = lumps.find(lump).ok_or_else(|| lumps.error(WadErrorKind::MissingLump(lump)))?;
    match bytes.len().is_multiple_of(record) {
        true => Ok(bytes.chunks_exact(record)),
        false => Err(lumps.error(WadErrorKind::LumpLength { lump, length: bytes.len(), record })),
    }
}

fn word(record: &[u8], at: usize) -> u16 {
    u16::from_le_bytes([record[at], record[at + 1]])
}

fn coordinate(record: &[u8], at: usize) -> Number {
    Number::Small(i64::from(i16::from_le_bytes([record[at], record[at + 1]])), 1)
}

/// Either form has the vertices and flags first and the sidedefs last.
fn linedef(record: &[u8]) -> Linedef {
    let side = |at| Some(word(record, at)).filter(|&side| side != NONE).map(u32::from);
    Linedef {
        start: word(record, 0).into(),
        end: word(record, 2).into(),
        is_flagged_two_sided: word(record, 4) & TWO_SIDED != 0,
        front: side(record.len() - 4),
        back: side(record.len() - 2),
        line: None,
    }
}
