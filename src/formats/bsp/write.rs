//! Writing visibility into a level, every other byte kept.
//!
//! Quake: the rows are run-length coded anew, equal rows once, and take the place of the old
//! ones; what lies behind them in the file moves, and the directories (the level's own, and the
//! BSPX directory that newer compilers put behind the last lump) follow. Quake 2: the same, with
//! rows of what can be heard that are computed anew: a cluster hears what the clusters that it
//! sees see. Quake 3: plain rows are overwritten in place.

use super::layout::{Level, Lump, QUAKE_LEAF_ROW, int};
use super::read::{quake2_rows, quake3_rows};
use super::{BitMatrix, BspError, BspErrorKind, BspFormat, Visibility};
use std::collections::BTreeMap;

/// The bytes of an entry of the BSPX directory: a name of 24 bytes, offset, length.
const BSPX_ENTRY: usize = 32;

/// The level `bytes` with `matrix` as its visibility.
///
/// # Errors
/// [`BspError`], among them a matrix of another size than the level's.
pub fn write_visibility(bytes: &[u8], matrix: &BitMatrix) -> Result<Vec<u8>, BspError> {
    let level = Level::new(bytes)?;
    let written = match level.format {
        BspFormat::Quake29 | BspFormat::GoldSrc30 | BspFormat::Bsp2 | BspFormat::Psb2 => {
            write_quake(level, matrix)?
        }
        BspFormat::Quake2 => write_quake2(level, matrix)?,
        BspFormat::Quake3 => write_quake3(level, matrix)?,
    };
    // A garbled level may have its lumps lie over one another, or over their own directory.
    match Visibility::read(&written) {
        Ok(read) if read.matrix == *matrix => Ok(written),
        Ok(_) | Err(_) => Err(BspError { offset: 0, kind: BspErrorKind::NotReadBack }),
    }
}

fn check_size(expected: usize, matrix: &BitMatrix, offset: usize) -> Result<(), BspError> {
    let got = matrix.size();
    if expected == got {
        return Ok(());
    }
    Err(BspError { offset, kind: BspErrorKind::OtherLevel { expected, got } })
}

fn write_quake3(level: Level<'_>, matrix: &BitMatrix) -> Result<Vec<u8>, BspError> {
    let (rows, row_bytes, data) = quake3_rows(level)?;
    check_size(rows, matrix, data)?;
    let mut bytes = level.bytes.to_vec();
    for cluster in 0..rows {
        let row = &mut bytes[data + cluster * row_bytes..][..row_bytes];
        row.fill(0);
        row[..matrix.row_bytes].copy_from_slice(matrix.row(cluster));
    }
    Ok(bytes)
}

fn write_quake2(level: Level<'_>, matrix: &BitMatrix) -> Result<Vec<u8>, BspError> {
    let (clusters, place) = quake2_rows(level)?;
    check_size(clusters, matrix, place.start)?;
    let heard = heard(matrix);
    let rows = [matrix, &heard].into_iter();
    let rows = rows.flat_map(|matrix| (0..clusters).map(move |cluster| matrix.row(cluster)));
    let (code, starts) = encode(rows);
    let mut data = (clusters as i32).to_le_bytes().to_vec();
    for cluster in 0..clusters {
        for start in [starts[cluster], starts[clusters + cluster]] {
            data.extend_from_slice(&((4 + 8 * clusters + start) as i32).to_le_bytes());
        }
    }
    data.extend_from_slice(&code);
    replace_visibility(level, level.bytes.to_vec(), &data)
}

/// What each cluster hears: itself, what it sees, and what those see.
fn heard(seen: &BitMatrix) -> BitMatrix {
    let mut heard = BitMatrix::new(seen.size());
    for cluster in 0..seen.size() {
        let mut row = seen.row(cluster).to_vec();
        for other in (0..seen.size()).filter(|&other| seen.get(cluster, other)) {
            for (byte, more) in row.iter_mut().zip(seen.row(other)) {
                *byte |= more;
            }
        }
        heard.set_row(cluster, &row);
        heard.set(cluster, cluster);
    }
    heard
}

fn write_quake(level: Level<'_>, matrix: &BitMatrix) -> Result<Vec<u8>, BspError> {
    let (rows, leafs) = level.quake_leafs()?;
    check_size(rows, matrix, leafs.start)?;
    let (data, starts) = encode((0..rows).map(|row| matrix.row(row)));
    // The rows' offsets, written before anything moves.
    let mut bytes = level.bytes.to_vec();
    let leaf_count = leafs.len() / level.leaf_record();
    for leaf in 0..leaf_count {
        let at = leafs.start + leaf * level.leaf_record() + QUAKE_LEAF_ROW;
        let start = match leaf.checked_sub(1).and_then(|row| starts.get(row)) {
            Some(&start) => start as i32,
            // The solid outside and the leafs of moving parts have no row of their own: 0 or -1
            // stays, and any other offset would point into data that is gone.
            None => level.int(at).min(0),
        };
        bytes[at..at + 4].copy_from_slice(&start.to_le_bytes());
    }
    replace_visibility(level, bytes, &data)
}

/// The run-length coded rows, equal rows once, and where each begins.
fn encode<'a>(rows: impl Iterator<Item = &'a [u8]>) -> (Vec<u8>, Vec<usize>) {
    let mut data = Vec::new();
    let mut known: BTreeMap<&[u8], usize> = BTreeMap::new();
    let mut starts = Vec::new();
    for row in rows {
        starts.push(*known.entry(row).or_insert_with(|| {
            let start = data.len();
            let mut rest = row;
            while let Some(&byte) = rest.first() {
                data.push(byte);
                let run = match byte {
                    0 => rest.iter().take(255).take_while(|&&byte| byte == 0).count(),
                    _ => 1,
                };
                if byte == 0 {
                    data.push(run as u8);
                }
                rest = &rest[run..];
            }
            start
        }));
    }
    (data, starts)
}

/// Puts `data` where the visibility lump of `level` is, in a copy `bytes` of its file.
fn replace_visibility(
    level: Level<'_>,
    mut bytes: Vec<u8>,
    data: &[u8],
) -> Result<Vec<u8>, BspError> {
    let mut old = level.lump(level.visibility_lump())?;
    let mut lumps_end = 0;
    for lump in 0..level.lump_count() {
        lumps_end = lumps_end.max(level.lump(Lump(lump, "other data"))?.end);
    }
    if old.is_empty() {
        // No place of its own yet: behind the last lump, where the BSPX directory begins.
        let end = lumps_end.next_multiple_of(4).min(bytes.len());
        old = end..end;
    }
    for lump in 0..level.lump_count() {
        let place = level.lump(Lump(lump, "other data"))?;
        let own = lump == level.visibility_lump().0;
        if !own && !place.is_empty() && place.start < old.end && old.start < place.end {
            let offset = level.lump_entry(lump);
            return Err(BspError { offset, kind: BspErrorKind::Overlap(lump) });
        }
    }
    let bspx = bspx_directory(&bytes, lumps_end);
    // Lumps begin at multiples of four; padding keeps what follows at its place modulo four.
    let gap = old.len() % 4;
    let padding = (gap + 4 - data.len() % 4) % 4;
    let moved = |offset: i32| -> i32 {
        if offset as i64 >= old.end as i64 && !(old.is_empty() && offset as usize == 0) {
            (offset as i64 + (data.len() + padding) as i64 - old.len() as i64) as i32
        } else {
            offset
        }
    };
    let size = bytes.len() - old.len() + data.len() + padding;
    if i32::try_from(size).is_err() {
        return Err(BspError { offset: 0, kind: BspErrorKind::TooLarge(size) });
    }
    let mut put = |at: usize, value: i32| bytes[at..at + 4].copy_from_slice(&value.to_le_bytes());
    for lump in 0..level.lump_count() {
        let entry = level.lump_entry(lump);
        put(entry, moved(level.int(entry)));
    }
    let entry = level.lump_entry(level.visibility_lump().0);
    put(entry, old.start as i32);
    put(entry + 4, data.len() as i32);
    for entry in bspx {
        put(entry + 24, moved(int(level.bytes, entry + 24)));
    }
    let filled = data.iter().copied().chain(std::iter::repeat_n(0, padding));
    bytes.splice(old, filled);
    Ok(bytes)
}

/// The places of the entries of the BSPX directory behind the last lump, if there is one.
fn bspx_directory(bytes: &[u8], lumps_end: usize) -> Vec<usize> {
    let start = lumps_end.next_multiple_of(4);
    if bytes.get(start..start + 4) != Some(b"BSPX") || bytes.len() < start + 8 {
        return Vec::new();
    }
    let count = usize::try_from(int(bytes, start + 4)).unwrap_or(0);
    let first = start + 8;
    let room = (bytes.len() - first) / BSPX_ENTRY;
    (0..count.min(room)).map(|index| first + index * BSPX_ENTRY).collect()
}
