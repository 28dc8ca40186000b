//! Doom levels (`.wad`): the archive, the maps in it, and what of a map visibility depends on.
//!
//! An archive is a header, lumps of bytes, and a directory of their names. A map is a *marker*, a
//! lump of any name (`E1M1`, `MAP01`), with the map's own lumps behind it:
//!
//! ```text
//! Doom    LINEDEFS (14 bytes), SIDEDEFS (30), VERTEXES (4), SECTORS (26), perhaps REJECT
//! Hexen   the same with LINEDEFS of 16 bytes, and BEHAVIOR
//! UDMF    TEXTMAP, a text of blocks, …, ENDMAP
//! ```
//!
//! Numbers are little-endian, coordinates of the binary forms whole; those of UDMF are decimals
//! and kept exactly. Nodes, segs and block maps are not looked at: they were made by rounding.
//!
//! Published readers give 32-bit floats, or panic on indices that name nothing, or read one of the
//! three forms; the records are few and small, so this reader is our own. It is linear in the
//! size of the file, and a lying count costs nothing.

mod archive;
mod binary;
mod reject;
mod udmf;

use crate::num::{DecimalError, Number};
use std::fmt;

pub use archive::{Archive, Lump};
pub use reject::{RejectError, RejectTable};

/// The most sectors that a map may have; the largest levels have some thousands.
pub const MAX_SECTORS: usize = 1 << 16;

/// How a map is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MapForm {
    /// Binary, linedefs of 14 bytes.
    Doom,
    /// Binary, linedefs of 16 bytes.
    Hexen,
    /// Text.
    Udmf,
}

/// A map: what of it visibility depends on.
///
/// Invariant: linedefs name vertices and sidedefs that exist, sidedefs sectors that exist.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DoomMap {
    /// The name of its marker.
    pub name: String,
    /// How it is written.
    pub form: MapForm,
    /// The vertices.
    pub vertices: Vec<[Number; 2]>,
    /// The linedefs.
    pub linedefs: Vec<Linedef>,
    /// The sector of each sidedef.
    pub sidedefs: Vec<u32>,
    /// The number of sectors.
    pub sectors: usize,
    /// The bytes of the REJECT lump, where there is one; see [`RejectTable::read`].
    pub reject: Option<Vec<u8>>,
}

impl DoomMap {
    /// Refuses records that name others that do not exist; `place` tells where the record of a
    /// lump stands.
    fn check_indices(
        &self,
        place: impl Fn(&'static str, usize) -> WadPlace,
    ) -> Result<(), WadError> {
        let check = |lump, record, what, got: u32, count| {
            if (got as usize) < count {
                return Ok(());
            }
            let kind = WadErrorKind::Missing { what, got, count };
            Err(WadError { place: place(lump, record), kind })
        };
        for (record, &sector) in self.sidedefs.iter().enumerate() {
            check("SIDEDEFS", record, "sector", sector, self.sectors)?;
        }
        for (record, line) in self.linedefs.iter().enumerate() {
            for vertex in [line.start, line.end] {
                check("LINEDEFS", record, "vertex", vertex, self.vertices.len())?;
            }
            for side in [line.front, line.back].into_iter().flatten() {
                check("LINEDEFS", record, "sidedef", side, self.sidedefs.len())?;
            }
        }
        Ok(())
    }
}

/// A line of a map, directed; its front is on its right.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Linedef {
    /// The vertex where it starts.
    pub start: u32,
    /// The vertex where it ends.
    pub end: u32,
    /// Whether its flags say that it has two sides. Its sidedefs may say otherwise.
    pub is_flagged_two_sided: bool,
    /// The sidedef on its right. Some maps have lines without one.
    pub front: Option<u32>,
    /// The sidedef on its left.
    pub back: Option<u32>,
    /// In a text, the line of its block, counted from 1.
    pub line: Option<usize>,
}

/// What is wrong with an archive or a map, and where.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{place}: {kind}")]
pub struct WadError {
    /// The place.
    pub place: WadPlace,
    /// The rule broken.
    pub kind: WadErrorKind,
}

/// A place in an archive.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum WadPlace {
    /// A byte of the file, counted from 0.
    Byte(usize),
    /// A map.
    Map(String),
    /// A record of a map's lump, counted from 0.
    Record {
        /// The map.
        map: String,
        /// The lump.
        lump: &'static str,
        /// The record.
        record: usize,
    },
    /// A line of a map's text, counted from 1.
    Line {
        /// The map.
        map: String,
        /// The line.
        line: usize,
    },
}

impl fmt::Display for WadPlace {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            WadPlace::Byte(byte) => write!(f, "byte {byte}"),
            WadPlace::Map(map) => write!(f, "map {map}"),
            WadPlace::Record { map, lump, record } => {
                write!(f, "map {map}, {lump}, record {record}")
            }
            WadPlace::Line { map, line } => write!(f, "map {map}, TEXTMAP, line {line}"),
        }
    }
}

/// The rules of archives and maps.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum WadErrorKind {
    /// The file does not begin as an archive does.
    #[error("not an archive of Doom, expected IWAD or PWAD")]
    Magic,
    /// The file ends inside the header.
    #[error("the file ends inside its header of 12 bytes")]
    HeaderEnds,
    /// The directory reaches past the end of the file, or has a negative place or count.
    #[error("a directory of {count} lumps at byte {offset}, the file has {file} bytes")]
    Directory {
        /// The number of lumps, as stated.
        count: i32,
        /// The directory's offset, as stated.
        offset: i32,
        /// The size of the file.
        file: usize,
    },
    /// A lump that reaches past the end of the file, or has a negative place.
    #[error("lump {name} at byte {offset} with {length} bytes, the file has {file}")]
    LumpOutside {
        /// The lump's name.
        name: String,
        /// Its offset, as stated.
        offset: i32,
        /// Its length, as stated.
        length: i32,
        /// The size of the file.
        file: usize,
    },
    /// No map has this name.
    #[error("there is no such map; the archive has {0}")]
    NoMap(String),
    /// A form of maps that is not read.
    #[error("a map of Doom 64 (lump {0}), which is not read")]
    OtherForm(&'static str),
    /// A lump that a map must have.
    #[error("the map has no lump {0}")]
    MissingLump(&'static str),
    /// A lump that is no whole number of records.
    #[error("lump {lump} has {length} bytes, expected a multiple of {record}")]
    LumpLength {
        /// The lump.
        lump: &'static str,
        /// Its length.
        length: usize,
        /// The length of a record.
        record: usize,
    },
    /// More sectors than are read.
    #[error("{got} sectors, at most {MAX_SECTORS} are read")]
    TooManySectors {
        /// How many there are.
        got: usize,
    },
    /// An index that names nothing.
    #[error("names {what} {got}, but there are {count}, counted from 0")]
    Missing {
        /// What is named.
        what: &'static str,
        /// The index.
        got: u32,
        /// How many there are.
        count: usize,
    },
    /// A byte that cannot stand in a text.
    #[error("byte {0:#04x}, expected a text")]
    NotText(u8),
    /// Something else is due.
    #[error("expected {expected}, got {got}")]
    Expected {
        /// What is due.
        expected: &'static str,
        /// What stands there.
        got: String,
    },
    /// A block that lacks a field.
    #[error("a {block} without `{field}`")]
    MissingField {
        /// The kind of block.
        block: &'static str,
        /// The field.
        field: &'static str,
    },
    /// A coordinate that is not a number.
    #[error("`{field}` = `{got}`: {source}")]
    Coordinate {
        /// The field.
        field: &'static str,
        /// What stands there.
        got: String,
        /// What is wrong with it.
        source: DecimalError,
    },
    /// An index that is no whole number.
    #[error("`{field}` = `{got}`: expected an index, counted from 0")]
    Index {
        /// The field.
        field: &'static str,
        /// What stands there.
        got: String,
    },
}
