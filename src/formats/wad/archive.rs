//! The header, the directory, and which lumps are maps.

use super::{DoomMap, MapForm, WadError, WadErrorKind, WadPlace, binary, udmf};

/// The bytes of the header.
const HEADER: usize = 12;
/// The bytes of an entry of the directory: offset, length, and eight of the name.
const ENTRY: usize = 16;

/// The lumps that belong to the marker before them. Only the binary forms have all but the first.
const MAP_LUMPS: &[&str] = &[
    "TEXTMAP", "THINGS", "LINEDEFS", "SIDEDEFS", "VERTEXES", "SEGS", "SSECTORS", "NODES",
    "SECTORS", "REJECT", "BLOCKMAP", "BEHAVIOR", "SCRIPTS", "LEAFS", "LIGHTS", "MACROS",
];

/// Lumps that only maps of Doom 64 have.
const DOOM64_LUMPS: &[&str] = &["LEAFS", "LIGHTS"];

/// A named run of bytes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Lump<'a> {
    /// Its name, in upper case; bytes that are not printable ASCII are escaped.
    pub name: String,
    /// Its bytes.
    pub bytes: &'a [u8],
}

/// An archive: lumps in the order of its directory.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Archive<'a> {
    /// The lumps.
    pub lumps: Vec<Lump<'a>>,
}

impl<'a> Archive<'a> {
    /// Whether `bytes` begin as an archive does.
    pub fn is_archive(bytes: &[u8]) -> bool {
        bytes.starts_with(b"IWAD") || bytes.starts_with(b"PWAD")
    }

    /// Reads the header and the directory.
    ///
    /// # Errors
    /// [`WadError`] names the byte and the rule broken. An empty lump may lie anywhere: markers
    /// often have no place.
    pub fn read(bytes: &'a [u8]) -> Result<Archive<'a>, WadError> {
        let error = |byte, kind| WadError { place: WadPlace::Byte(byte), kind };
        if !Archive::is_archive(bytes) {
            return Err(error(0, WadErrorKind::Magic));
        }
        if bytes.len() < HEADER {
            return Err(error(bytes.len(), WadErrorKind::HeaderEnds));
        }
        let (count, offset) = (int(bytes, 4), int(bytes, 8));
        let length = count.checked_mul(ENTRY as i32).unwrap_or(-1);
        let Some(directory) = run(bytes, offset, length) else {
            return Err(error(4, WadErrorKind::Directory { count, offset, file: bytes.len() }));
        };
        // Of an empty directory any place is as good.
        let start = usize::try_from(offset).unwrap_or(0);
        let mut lumps = Vec::with_capacity(directory.len() / ENTRY);
        for (index, entry) in directory.chunks_exact(ENTRY).enumerate() {
            let (offset, length) = (int(entry, 0), int(entry, 4));
            let name = lump_name(&entry[8..]);
            match run(bytes, offset, length) {
                Some(bytes) => lumps.push(Lump { name, bytes }),
                None => {
                    let file = bytes.len();
                    let kind = WadErrorKind::LumpOutside { name, offset, length, file };
                    return Err(error(start + index * ENTRY, kind));
                }
            }
        }
        Ok(Archive { lumps })
    }

    /// The names of the maps, in the order of the directory. A name may come twice.
    pub fn maps(&self) -> Vec<&str> {
        let starts = (0..self.lumps.len()).filter(|&index| self.is_marker(index));
        starts.map(|index| self.lumps[index].name.as_str()).collect()
    }

    /// Reads a map, by its name in upper or lower case; of several with that name the last, which
    /// is the one that games play.
    ///
    /// # Errors
    /// [`WadError`] names the map, the lump with the record or line, and the rule broken.
    pub fn map(&self, name: &str) -> Result<DoomMap, WadError> {
        let named = |&index: &usize| {
            self.lumps[index].name.eq_ignore_ascii_case(name) && self.is_marker(index)
        };
        let Some(marker) = (0..self.lumps.len()).rev().find(named) else {
            let maps = self.maps();
            let known = if maps.is_empty() { "no map".to_owned() } else { shortened(&maps) };
            let place = WadPlace::Map(name.escape_debug().take(32).collect());
            return Err(WadError { place, kind: WadErrorKind::NoMap(known) });
        };
        let lumps = MapLumps { name: &self.lumps[marker].name, lumps: self.lumps_of(marker) };
        if let Some(lump) = DOOM64_LUMPS.iter().find(|lump| lumps.find(lump).is_some()) {
            return Err(lumps.error(WadErrorKind::OtherForm(lump)));
        }
        if let Some(text) = lumps.find("TEXTMAP") {
            return udmf::read(&lumps, text);
        }
        let is_hexen = lumps.find("BEHAVIOR").is_some();
        binary::read(&lumps, if is_hexen { MapForm::Hexen } else { MapForm::Doom })
    }

    /// Whether a lump is a map's marker: the next is a map's lump, and it is none itself.
    fn is_marker(&self, index: usize) -> bool {
        let is_map_lump = |lump: &Lump<'_>| MAP_LUMPS.contains(&lump.name.as_str());
        !is_map_lump(&self.lumps[index]) && self.lumps.get(index + 1).is_some_and(is_map_lump)
    }

    /// The lumps of the map with this marker: those up to ENDMAP after a TEXTMAP, else those
    /// behind it that are a map's.
    fn lumps_of(&self, marker: usize) -> &[Lump<'a>] {
        let behind = &self.lumps[marker + 1..];
        let is_text = behind.first().is_some_and(|lump| lump.name == "TEXTMAP");
        let ends = |lump: &Lump<'_>| match is_text {
            true => lump.name == "ENDMAP",
            false => !MAP_LUMPS.contains(&lump.name.as_str()),
        };
        &behind[..behind.iter().position(ends).unwrap_or(behind.len())]
    }
}

/// The lumps of one map.
pub(super) struct MapLumps<'w, 'a> {
    /// The name of the map.
    pub name: &'w str,
    lumps: &'w [Lump<'a>],
}

impl<'a> MapLumps<'_, 'a> {
    /// The first lump of a name.
    pub(super) fn find(&self, name: &str) -> Option<&'a [u8]> {
        self.lumps.iter().find(|lump| lump.name == name).map(|lump| lump.bytes)
    }

    /// An error of the map as a whole.
    pub(super) fn error(&self, kind: WadErrorKind) -> WadError {
        WadError { place: WadPlace::Map(self.name.to_owned()), kind }
    }
}

/// The little-endian number at a place that is known to exist.
fn int(bytes: &[u8], at: usize) -> i32 {
    let mut word = [0; 4];
    word.copy_from_slice(&bytes[at..at + 4]);
    i32::from_le_bytes(word)
}

/// The bytes at a stated place, if they are there; none need no place.
fn run(bytes: &[u8], offset: i32, length: i32) -> Option<&[u8]> {
    if length == 0 {
        return Some(&[]);
    }
    let start = usize::try_from(offset).ok()?;
    let end = start.checked_add(usize::try_from(length).ok()?)?;
    bytes.get(start..end)
}

/// A name of up to eight bytes.
fn lump_name(bytes: &[u8]) -> String {
    let name = bytes.split(|&byte| byte == 0).next().unwrap_or_default();
    name.to_ascii_uppercase().escape_ascii().to_string()
}

/// A list of names that an error can show.
fn shortened(names: &[&str]) -> String {
    const SHOWN: usize = 8;
    let start = names[..names.len().min(SHOWN)].join(", ");
    match names.len().checked_sub(SHOWN) {
        Some(rest) if rest > 0 => format!("{start} and {rest} more"),
        _ => start,
    }
}
