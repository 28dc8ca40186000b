//! Maps of Doom archives: named on the command line, divided, and their REJECT lumps.

use super::exit::Failure;
use super::files::Input;
use super::plan::PlanArgs;
use crate::formats::wad::{Archive, DoomMap, RejectTable, WadError};
use crate::portal::doom::DoomAreas;
use crate::portal::plan::{PlanCells, cells_of_plan};
use crate::pvs::plan::Cover;
use crate::report::{Matrix, Progress, Verdict};
use crate::scene::plan::{DoomOddity, Plan, plan_of_map};
use std::path::{Path, PathBuf};

/// What a map has that other plans do not.
pub(super) struct DoomLevel {
    /// The number of its sectors.
    pub(super) sectors: usize,
    /// Which leaves are parts of which sectors, and what should not be.
    pub(super) areas: DoomAreas,
}

impl DoomLevel {
    /// The sectors as sets of leaves. The leaves are the cells, by the same numbers.
    pub(super) fn cover(&self) -> Cover {
        let leaves = 0..self.areas.of_leaf.len() as u32;
        Cover::new(self.sectors, leaves.map(|leaf| self.areas.sectors_of_leaf(leaf)))
    }

    /// What should not be in the map, a line a kind, with its first few.
    pub(super) fn print_oddities(&self, name: &str) {
        const SHOWN: usize = 4;
        for kind in self.kinds() {
            let shown: Vec<String> = kind.iter().take(SHOWN).map(ToString::to_string).collect();
            let more = if kind.len() > SHOWN { "; …" } else { "" };
            let (count, rule, shown) = (kind.len(), kind[0].rule(), shown.join("; "));
            eprintln!("{name}: {count} {rule}: {shown}{more}");
        }
    }

    /// The oddities of each kind.
    fn kinds(&self) -> impl Iterator<Item = &[DoomOddity]> {
        self.areas.oddities.chunk_by(|one, other| one.kind() == other.kind())
    }

    /// The oddities in JSON: for each kind its rule, and each with its linedefs and sectors.
    pub(super) fn oddities_as_json(&self) -> serde_json::Value {
        let kind = |kind: &[DoomOddity]| {
            let each = |oddity: &DoomOddity| {
                let (lines, sectors) = (oddity.lines(), oddity.sectors());
                serde_json::json!({"text": oddity.to_string(), "lines": lines, "sectors": sectors})
            };
            let all: Vec<serde_json::Value> = kind.iter().map(each).collect();
            let (name, rule) = (kind[0].kind(), kind[0].rule());
            serde_json::json!({"kind": name, "rule": rule, "count": kind.len(), "all": all})
        };
        self.kinds().map(kind).collect()
    }
}

/// A path that may name a map, `FILE:MAP`: the part after the last colon, if the whole is no file
/// and the part before it is one or ends in `.wad`.
pub(super) fn split_map(path: &Path) -> (PathBuf, Option<String>) {
    let whole = || (path.to_owned(), None);
    let Some((file, map)) = path.to_str().and_then(|text| text.rsplit_once(':')) else {
        return whole();
    };
    let is_archive = file.to_ascii_lowercase().ends_with(".wad");
    if path.exists() || !(is_archive || Path::new(file).is_file()) {
        return whole();
    }
    (PathBuf::from(file), Some(map.to_owned()))
}

/// Refuses an archive without a map, and a map of what is none.
pub(super) fn check_map(bytes: &[u8], map: Option<&str>) -> Result<(), String> {
    match (Archive::is_archive(bytes), map) {
        (true, Some(_)) | (false, None) => Ok(()),
        (false, Some(map)) => Err(format!("not an archive of Doom, so it has no map {map}")),
        (true, None) => {
            let archive = Archive::read(bytes).map_err(|error| error.to_string())?;
            let maps = archive.maps();
            match maps.first() {
                None => Err("an archive of Doom without a map".to_owned()),
                Some(first) => {
                    let count = maps.len();
                    Err(format!("an archive of {count} maps, expected one, such as FILE:{first}"))
                }
            }
        }
    }
}

/// The map that an input names.
pub(super) fn map_of(input: &Input) -> Result<DoomMap, Failure> {
    let failure = |error: WadError| Failure::file(&input.name, error);
    let archive = Archive::read(&input.bytes).map_err(failure)?;
    archive.map(input.map.as_deref().unwrap_or_default()).map_err(failure)
}

/// Reads a map, and divides it.
pub(super) fn read(
    input: &Input,
    args: &PlanArgs,
    progress: &dyn Progress,
) -> Result<(Plan, PlanCells, DoomLevel), Failure> {
    let map = map_of(input)?;
    let doom = plan_of_map(&map).map_err(|error| Failure::file(&input.name, error))?;
    let tree = args.divide(input, &doom.plan, progress)?;
    let cells =
        cells_of_plan(&doom.plan, tree, false).map_err(|leak| Failure::file(&input.name, leak))?;
    let areas = DoomAreas::of(&doom, &cells);
    let level = DoomLevel { sectors: doom.sectors, areas };
    level.print_oddities(&input.name);
    Ok((doom.plan, cells, level))
}

/// The REJECT table of a result: the pairs of sectors that are not visible. Pairs that are
/// undecided, or grazing, may see each other.
pub(super) fn reject_table(matrix: &Matrix) -> RejectTable {
    let mut table = RejectTable::new(matrix.size());
    for from in 0..matrix.size() {
        for (to, verdict) in matrix.row(from).iter().enumerate() {
            match verdict {
                Verdict::NotOpen => table.reject(from, to),
                Verdict::Grazing | Verdict::Open | Verdict::Undecided => {}
            }
        }
    }
    table
}

/// The REJECT table of a map, and what to call it; without one every sector may see every other.
pub(super) fn shipped_table(map: &DoomMap) -> (RejectTable, String) {
    match map.reject.as_deref().map(|lump| RejectTable::read(lump, map.sectors)) {
        Some(Ok(table)) => (table, "REJECT".to_owned()),
        Some(Err(error)) => (RejectTable::new(map.sectors), error.to_string()),
        None => {
            let what = "no REJECT lump: every sector may see every other";
            (RejectTable::new(map.sectors), what.to_owned())
        }
    }
}
