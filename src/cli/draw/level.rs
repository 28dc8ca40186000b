//! Pictures of Doom levels.

use super::super::doom::DoomLevel;
use super::super::exit::Failure;
use super::super::plan::Planar;
use super::super::pvs::plan::{Wants, sights};
use crate::draw::{self, Floor, Shade, Sheet};
use crate::report::{Silent, Verdict};

/// Draws the lines and the leaves of a level.
pub(super) fn draw_leaves(level: &DoomLevel, sheet: Sheet, floor: &mut Floor) -> String {
    let shades = shades(level, |_| Shade::Plain);
    let count = shades.iter().filter(|shade| **shade == Shade::Plain).count();
    let plain = format!("{count} leaves, {} sectors", level.sectors);
    draw::draw_level(sheet, floor, &shades, true, ["in no sector", &plain, "", ""])
}

/// Draws the sectors that a sector sees.
pub(super) fn draw_sectors(
    file: &str,
    (planar, level): (&Planar, &DoomLevel),
    (sheet, floor): (Sheet, &mut Floor),
    from: &str,
) -> Result<String, Failure> {
    let source = from.parse().ok().filter(|&sector: &usize| sector < level.sectors);
    let source = source.ok_or_else(|| {
        let expected = format!("expected a number below {}", level.sectors);
        Failure::usage(format!("no sector {from:?} in {file}, {expected}"))
    })?;
    let wants = Wants { witnesses: false, grazing: false };
    let found = sights(planar, Some(level), wants, &Silent).ok_or(Failure::Interrupted)?;
    let is_seen = |sector: usize| found.matrix.get(source, sector) == Verdict::Open;
    let shades = shades(level, |sector| match sector as usize {
        sector if sector == source => Shade::Source,
        sector if is_seen(sector) => Shade::Visible,
        _ => Shade::Plain,
    });
    let others = (0..level.sectors).filter(|&sector| sector != source);
    let count = others.filter(|&sector| is_seen(sector)).count();
    let seen = format!("sees {count} of {} others", level.sectors - 1);
    let texts = ["in no sector", "", &seen, &format!("sector {source}")];
    Ok(draw::draw_level(sheet, floor, &shades, false, texts))
}

/// The shade of each leaf: the last one of its sectors'.
fn shades(level: &DoomLevel, of_sector: impl Fn(u32) -> Shade) -> Vec<Shade> {
    let leaves = 0..level.areas.of_leaf.len() as u32;
    let shade = |leaf| {
        let sectors = level.areas.sectors_of_leaf(leaf).iter();
        sectors.map(|&sector| of_sector(sector)).max().unwrap_or(Shade::Void)
    };
    leaves.map(shade).collect()
}
