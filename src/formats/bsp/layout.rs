//! Where each format keeps its lumps and the fields that visibility needs.

use super::{BspError, BspErrorKind};
use std::fmt;
use std::ops::Range;

/// A format of level files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BspFormat {
    /// Quake, version 29.
    Quake29,
    /// GoldSrc, version 30.
    GoldSrc30,
    /// Quake with wide indices and float boxes.
    Bsp2,
    /// Quake with wide indices, an earlier attempt.
    Psb2,
    /// Quake 2, IBSP version 38.
    Quake2,
    /// Quake 3, IBSP version 46.
    Quake3,
}

impl fmt::Display for BspFormat {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            BspFormat::Quake29 => "Quake (version 29)",
            BspFormat::GoldSrc30 => "GoldSrc (version 30)",
            BspFormat::Bsp2 => "Quake (BSP2)",
            BspFormat::Psb2 => "Quake (2PSB)",
            BspFormat::Quake2 => "Quake 2 (IBSP 38)",
            BspFormat::Quake3 => "Quake 3 (IBSP 46)",
        })
    }
}

/// A lump's number and what it holds, for error messages.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Lump(pub usize, pub &'static str);

pub(super) const QUAKE_LEAFS: Lump = Lump(10, "leafs");
pub(super) const QUAKE_MODELS: Lump = Lump(14, "models");
/// The bytes of a model's record in Quake, and where in it the number of leafs with a row is.
pub(super) const QUAKE_MODEL: usize = 64;
pub(super) const QUAKE_MODEL_LEAFS: usize = 52;
/// Where a leaf's record in Quake has the offset of its row.
pub(super) const QUAKE_LEAF_ROW: usize = 4;

/// A level file: its bytes, its format, and the places of its lumps, checked when asked for.
#[derive(Clone, Copy, Debug)]
pub(super) struct Level<'a> {
    pub bytes: &'a [u8],
    pub format: BspFormat,
}

impl<'a> Level<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Result<Level<'a>, BspError> {
        let word = |at: usize| bytes.get(at..at + 4);
        let format = match (word(0), word(4)) {
            (Some(b"\x1d\0\0\0"), _) => BspFormat::Quake29,
            (Some(b"\x1e\0\0\0"), _) => BspFormat::GoldSrc30,
            (Some(b"BSP2"), _) => BspFormat::Bsp2,
            (Some(b"2PSB"), _) => BspFormat::Psb2,
            (Some(b"IBSP"), Some(b"\x26\0\0\0")) => BspFormat::Quake2,
            (Some(b"IBSP"), Some(b"\x2e\0\0\0")) => BspFormat::Quake3,
            _ => return Err(BspError { offset: 0, kind: BspErrorKind::UnknownFormat }),
        };
        let level = Level { bytes, format };
        if bytes.len() < level.header_end() {
            return Err(BspError { offset: bytes.len(), kind: BspErrorKind::HeaderEnds });
        }
        Ok(level)
    }

    pub(super) fn lump_count(&self) -> usize {
        match self.format {
            BspFormat::Quake29 | BspFormat::GoldSrc30 | BspFormat::Bsp2 | BspFormat::Psb2 => 15,
            BspFormat::Quake2 => 19,
            BspFormat::Quake3 => 17,
        }
    }

    /// Where the directory has a lump's offset, followed by its length.
    pub(super) fn lump_entry(&self, lump: usize) -> usize {
        let directory = match self.format {
            BspFormat::Quake29 | BspFormat::GoldSrc30 | BspFormat::Bsp2 | BspFormat::Psb2 => 4,
            BspFormat::Quake2 | BspFormat::Quake3 => 8,
        };
        directory + 8 * lump
    }

    fn header_end(&self) -> usize {
        self.lump_entry(self.lump_count())
    }

    pub(super) fn visibility_lump(&self) -> Lump {
        let lump = match self.format {
            BspFormat::Quake29 | BspFormat::GoldSrc30 | BspFormat::Bsp2 | BspFormat::Psb2 => 4,
            BspFormat::Quake2 => 3,
            BspFormat::Quake3 => 16,
        };
        Lump(lump, "visibility")
    }

    /// The bytes of a leaf's record, where the leafs are looked at.
    pub(super) fn leaf_record(&self) -> usize {
        match self.format {
            BspFormat::Quake29 | BspFormat::GoldSrc30 => 28,
            BspFormat::Bsp2 => 44,
            BspFormat::Psb2 => 32,
            BspFormat::Quake2 => 28,
            BspFormat::Quake3 => 48,
        }
    }

    /// The little-endian number at a place that is known to exist.
    pub(super) fn int(&self, at: usize) -> i32 {
        int(self.bytes, at)
    }

    /// The place of a lump.
    pub(super) fn lump(&self, Lump(lump, what): Lump) -> Result<Range<usize>, BspError> {
        let entry = self.lump_entry(lump);
        let (offset, length) = (self.int(entry), self.int(entry + 4));
        let file = self.bytes.len();
        let range = usize::try_from(offset).ok().zip(usize::try_from(length).ok());
        match range.map(|(offset, length)| (offset, offset.checked_add(length))) {
            Some((start, Some(end))) if end <= file => Ok(start..end),
            // An empty lump needs no place.
            Some(_) if length == 0 => Ok(0..0),
            _ => {
                let kind = BspErrorKind::LumpOutside { lump, what, offset, length, file };
                Err(BspError { offset: entry, kind })
            }
        }
    }

    /// The leafs of a Quake level that have a row each: how many, and the place of the leafs'
    /// records, of which the first is the solid outside and has none.
    pub(super) fn quake_leafs(&self) -> Result<(usize, Range<usize>), BspError> {
        let models = self.lump(QUAKE_MODELS)?;
        if models.len() < QUAKE_MODEL {
            let (what, got) = (QUAKE_MODELS.1, models.len());
            let expected = format!("{QUAKE_MODEL} a model, one or more");
            let kind = BspErrorKind::LumpLength { what, got, expected };
            return Err(BspError { offset: models.start, kind });
        }
        let leafs = self.lump(QUAKE_LEAFS)?;
        let record = self.leaf_record();
        if leafs.is_empty() || !leafs.len().is_multiple_of(record) {
            let (what, got) = (QUAKE_LEAFS.1, leafs.len());
            let kind = BspErrorKind::LumpLength { what, got, expected: format!("{record} a leaf") };
            return Err(BspError { offset: leafs.start, kind });
        }
        let at = models.start + QUAKE_MODEL_LEAFS;
        let limit = (leafs.len() / record - 1).min(super::read::MAX_ROWS);
        let count = count(self.int(at), limit).map_err(|kind| BspError { offset: at, kind })?;
        Ok((count, leafs))
    }
}

pub(super) fn int(bytes: &[u8], at: usize) -> i32 {
    let mut word = [0; 4];
    word.copy_from_slice(&bytes[at..at + 4]);
    i32::from_le_bytes(word)
}

/// A count of rows, if it is positive and not above `limit`.
pub(super) fn count(stated: i32, limit: usize) -> Result<usize, BspErrorKind> {
    match usize::try_from(stated) {
        Ok(0) => Err(BspErrorKind::NoVisibility),
        Ok(count) if count <= limit => Ok(count),
        _ => Err(BspErrorKind::Count { got: stated.into(), limit }),
    }
}
