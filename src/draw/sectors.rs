//! A Doom level: its lines, the leaves that it is divided into, and which sectors one sector sees.

use super::floor::Floor;
use super::palette;
use super::sheet::{Sample, Sheet};
use super::svg::number;
use crate::scene::CellId;

/// How a leaf of a level is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Shade {
    /// It is a part of no sector.
    Void,
    /// Nothing is said about it.
    Plain,
    /// It is a part of a sector that is seen.
    Visible,
    /// It is a part of the sector that looks.
    Source,
}

impl Shade {
    const ALL: [Shade; 4] = [Shade::Void, Shade::Plain, Shade::Visible, Shade::Source];

    fn colour(self) -> &'static str {
        match self {
            Shade::Void => palette::OUTSIDE,
            Shade::Plain => palette::CELL,
            Shade::Visible => palette::VISIBLE,
            Shade::Source => palette::SOURCE,
        }
    }
}

/// Draws a level's lines, black where they are walls and grey where they are not, over its leaves,
/// each in its shade; plain leaves have edges if `has_edges`.
///
/// `texts` are what the legend says of the shades, in their order; nothing of an empty one.
pub fn draw_level(
    mut sheet: Sheet,
    floor: &mut Floor,
    shades: &[Shade],
    has_edges: bool,
    texts: [&str; 4],
) -> String {
    floor.hint_name = "two-sided line";
    let hair = number(floor.sizes(&sheet).hair);
    for (shade, text) in Shade::ALL.into_iter().zip(texts) {
        let colour = shade.colour();
        // A stroke of the same colour closes the seams that smooth edges leave.
        let is_edged = has_edges && shade == Shade::Plain;
        let edge = if is_edged { palette::EDGE } else { colour };
        let style = [("fill", colour), ("stroke", edge), ("stroke-width", &hair)];
        let of_shade = |cell: &CellId| shades[cell.0 as usize] == shade;
        let own: Vec<CellId> = floor.cells().filter(of_shade).collect();
        sheet.svg.group(&style, |svg| svg.outlines(own.iter().map(|&cell| floor.outline(cell))));
        if !own.is_empty() && !text.is_empty() {
            sheet.explain(Sample::Area(colour), text);
        }
    }
    floor.draw_faces(&mut sheet);
    sheet.finish()
}
