//! Reading visibility.

use super::layout::{Level, QUAKE_LEAF_ROW, count};
use super::{BitMatrix, BspError, BspErrorKind, BspFormat, Visibility};

/// A matrix of this size takes half a gigabyte; the largest levels have a quarter of it.
pub(super) const MAX_ROWS: usize = 1 << 16;

impl Visibility {
    /// Whether `bytes` begin as a level of a known format does.
    pub fn is_bsp(bytes: &[u8]) -> bool {
        match Level::new(bytes) {
            Ok(_) => true,
            Err(error) => error.kind != BspErrorKind::UnknownFormat,
        }
    }

    /// Reads the visibility of a level.
    ///
    /// # Errors
    /// [`BspError`] names the byte and the rule broken; a level without visibility data is one.
    pub fn read(bytes: &[u8]) -> Result<Visibility, BspError> {
        let level = Level::new(bytes)?;
        match level.format {
            BspFormat::Quake29 | BspFormat::GoldSrc30 | BspFormat::Bsp2 | BspFormat::Psb2 => {
                read_quake(level)
            }
            BspFormat::Quake2 => read_quake2(level),
            BspFormat::Quake3 => read_quake3(level),
        }
    }
}

fn read_quake(level: Level<'_>) -> Result<Visibility, BspError> {
    let (rows, leafs) = level.quake_leafs()?;
    let place = level.lump(level.visibility_lump())?;
    if place.is_empty() {
        let offset = level.lump_entry(level.visibility_lump().0);
        return Err(BspError { offset, kind: BspErrorKind::NoVisibility });
    }
    let mut matrix = BitMatrix::new(rows);
    let mut rows_missing = 0;
    let mut row = Vec::with_capacity(matrix.row_bytes);
    for leaf in 0..rows {
        let at = leafs.start + (leaf + 1) * level.leaf_record() + QUAKE_LEAF_ROW;
        let start = level.int(at);
        if start == -1 {
            rows_missing += 1;
            row.clear();
            row.resize(matrix.row_bytes, 0xff);
        } else {
            decode(level.bytes, &place, i64::from(start), leaf, matrix.row_bytes, &mut row)
                .map_err(|kind| BspError { offset: at, kind })?;
        }
        matrix.set_row(leaf, &row);
    }
    Ok(Visibility { format: level.format, matrix, rows_missing })
}

fn read_quake2(level: Level<'_>) -> Result<Visibility, BspError> {
    let (rows, place) = quake2_rows(level)?;
    let mut matrix = BitMatrix::new(rows);
    let mut row = Vec::with_capacity(matrix.row_bytes);
    for cluster in 0..rows {
        let at = place.start + 4 + 8 * cluster;
        let start = i64::from(level.int(at));
        decode(level.bytes, &place, start, cluster, matrix.row_bytes, &mut row)
            .map_err(|kind| BspError { offset: at, kind })?;
        matrix.set_row(cluster, &row);
    }
    Ok(Visibility { format: level.format, matrix, rows_missing: 0 })
}

/// The number of clusters of a Quake 2 level, and the place of its visibility.
pub(super) fn quake2_rows(level: Level<'_>) -> Result<(usize, std::ops::Range<usize>), BspError> {
    let place = visibility_with_header(level, 4)?;
    let limit = ((place.len() - 4) / 8).min(MAX_ROWS);
    let rows = count(level.int(place.start), limit)
        .map_err(|kind| BspError { offset: place.start, kind })?;
    Ok((rows, place))
}

fn read_quake3(level: Level<'_>) -> Result<Visibility, BspError> {
    let (rows, row_bytes, data) = quake3_rows(level)?;
    let mut matrix = BitMatrix::new(rows);
    for cluster in 0..rows {
        let row = &level.bytes[data + cluster * row_bytes..][..matrix.row_bytes];
        matrix.set_row(cluster, row);
    }
    Ok(Visibility { format: level.format, matrix, rows_missing: 0 })
}

/// The number of clusters of a Quake 3 level, the bytes of a row, and where the rows begin.
pub(super) fn quake3_rows(level: Level<'_>) -> Result<(usize, usize, usize), BspError> {
    let place = visibility_with_header(level, 8)?;
    let data = place.len() - 8;
    let rows = count(level.int(place.start), MAX_ROWS)
        .map_err(|kind| BspError { offset: place.start, kind })?;
    let row_bytes = usize::try_from(level.int(place.start + 4)).unwrap_or(0);
    let needed = rows.checked_mul(row_bytes);
    if row_bytes < rows.div_ceil(8) || needed.is_none_or(|needed| needed > data) {
        let expected = format!("{rows} rows of {} bytes or more after 8", rows.div_ceil(8));
        let kind = BspErrorKind::LumpLength { what: "visibility", got: place.len(), expected };
        return Err(BspError { offset: place.start, kind });
    }
    Ok((rows, row_bytes, place.start + 8))
}

/// The place of a visibility lump that begins with a header.
fn visibility_with_header(
    level: Level<'_>,
    header: usize,
) -> Result<std::ops::Range<usize>, BspError> {
    let place = level.lump(level.visibility_lump())?;
    let offset = level.lump_entry(level.visibility_lump().0);
    if place.is_empty() {
        return Err(BspError { offset, kind: BspErrorKind::NoVisibility });
    }
    if place.len() < header {
        let expected = format!("{header} or more");
        let kind = BspErrorKind::LumpLength { what: "visibility", got: place.len(), expected };
        return Err(BspError { offset, kind });
    }
    Ok(place)
}

/// Decodes the row that begins `start` bytes into the lump at `place`.
fn decode(
    bytes: &[u8],
    place: &std::ops::Range<usize>,
    start: i64,
    leaf: usize,
    expected: usize,
    row: &mut Vec<u8>,
) -> Result<(), BspErrorKind> {
    let lump = &bytes[place.clone()];
    let outside = BspErrorKind::RowOutside { leaf, start, length: lump.len() };
    let begin = usize::try_from(start).map_err(|_| outside.clone())?;
    let mut code = lump.get(begin..).ok_or(outside)?.iter();
    let length_error = BspErrorKind::RowLength { leaf, expected };
    row.clear();
    while row.len() < expected {
        match code.next() {
            Some(0) => {
                let run = usize::from(*code.next().ok_or_else(|| length_error.clone())?);
                // A run of no zeros would never end, and no writer makes one.
                if run == 0 || row.len() + run > expected {
                    return Err(length_error);
                }
                row.resize(row.len() + run, 0);
            }
            Some(&byte) => row.push(byte),
            None => return Err(length_error),
        }
    }
    Ok(())
}
