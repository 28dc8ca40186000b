//! What one cell sees, with the lines that show it (Teller and Séquin 1991, figures 7 and 11a).

use super::floor::{Floor, Sizes};
use super::palette;
use super::sheet::{Pen, Sample, Sheet};
use super::svg::{Place, number};
use crate::num::Rational;
use crate::scene::CellId;

/// A line that two cells see each other along.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sightline {
    /// The cell that it starts in.
    pub from: CellId,
    /// The cell that it ends in.
    pub to: CellId,
    /// The portals that it crosses between them.
    pub portals: Vec<u32>,
    /// Two distinct points of it, in grid units.
    pub line: [[Rational; 2]; 2],
}

/// Draws a cell dark, the cells that it sees light, and a line for each of them.
pub fn draw_visibility(
    mut sheet: Sheet,
    floor: &Floor,
    source: CellId,
    visible: &[CellId],
    lines: &[Sightline],
) -> String {
    let seen = Seen::new(floor, source, visible);
    seen.draw(&mut sheet, floor);
    let sizes = floor.sizes(&sheet);
    floor.draw_faces(&mut sheet);
    if floor.outlines.iter().any(Vec::is_empty) {
        let pen = Pen::round(palette::GRAPH, sizes.line);
        sheet.draw_segments(pen, &floor.portals, "portal");
    }
    let drawn: Vec<(&Sightline, [Place; 2])> =
        lines.iter().filter_map(|line| Some((line, between(&sheet, floor, line)?))).collect();
    let segments: Vec<[Place; 2]> = drawn.iter().map(|(_, ends)| *ends).collect();
    sheet.draw_segments(Pen::round(palette::SIGHT, sizes.line), &segments, "stabbing line");
    sheet.svg.group(&[("fill", palette::SIGHT)], |svg| {
        for (line, ends) in &drawn {
            let far = if line.from == source { 1 } else { 0 };
            svg.circle(ends[far], 1.8 * sizes.line);
        }
    });
    seen.draw_shapeless(&mut sheet, floor);
    floor.draw_names(&mut sheet, 2.0 * sizes.font, |cell| seen.name_colours(floor, cell));
    sheet.finish()
}

/// The colours of the cell that looks, of those that it sees, and of the others.
pub(super) struct Seen {
    source: CellId,
    colours: Vec<&'static str>,
}

impl Seen {
    /// The colours for a source and what it sees, which may hold itself.
    pub(super) fn new(floor: &Floor, source: CellId, visible: &[CellId]) -> Seen {
        let mut colours = vec![palette::CELL; floor.names.len()];
        visible.iter().for_each(|cell| colours[cell.0 as usize] = palette::VISIBLE);
        colours[source.0 as usize] = palette::SOURCE;
        Seen { source, colours }
    }

    /// Draws the cells and explains them.
    pub(super) fn draw(&self, sheet: &mut Sheet, floor: &Floor) {
        floor.draw_cells(sheet, |cell| self.colours[cell.0 as usize]);
        let count = self.colours.iter().filter(|colour| **colour == palette::VISIBLE).count();
        let others = floor.names.len() - 1;
        sheet.explain(Sample::Area(palette::SOURCE), format!("cell {}", floor.name(self.source)));
        sheet.explain(Sample::Area(palette::VISIBLE), format!("sees {count} of {others} others"));
    }

    /// Draws cells without a shape, as dots.
    pub(super) fn draw_shapeless(&self, sheet: &mut Sheet, floor: &Floor) {
        let Sizes { node, hair, .. } = floor.sizes(sheet);
        let width = number(hair);
        for cell in floor.cells().filter(|&cell| floor.outline(cell).is_empty()) {
            let colour = self.colours[cell.0 as usize];
            let style = [("fill", colour), ("stroke", palette::TEXT), ("stroke-width", &width)];
            sheet.svg.group(&style, |svg| svg.circle(floor.middles[cell.0 as usize], node));
        }
    }

    /// The colours of a cell's name, and of what it stands on.
    fn name_colours(&self, floor: &Floor, cell: CellId) -> [&'static str; 2] {
        if floor.outline(cell).is_empty() {
            return [palette::TEXT, palette::CELL];
        }
        let text = if cell == self.source { palette::CELL } else { palette::TEXT };
        [text, self.colours[cell.0 as usize]]
    }
}

/// The part of a line from the middle of its way through the one cell to that through the other;
/// between cells without a shape, from a little before its first portal to a little after its
/// last.
fn between(sheet: &Sheet, floor: &Floor, sight: &Sightline) -> Option<[Place; 2]> {
    let line = sheet.frame.ray(&sight.line)?;
    let middle = |cell: CellId| line.within(floor.outline(cell)).map(|[a, b]| (a + b) / 2.0);
    if let (Some(from), Some(to)) = (middle(sight.from), middle(sight.to)) {
        return Some([line.at(from), line.at(to)]);
    }
    let crossed = |&portal: &u32| line.crosses(floor.portals[portal as usize]);
    let (first, last) = (sight.portals.first().map(crossed)?, sight.portals.last().map(crossed)?);
    let more = sheet.width() / 24.0;
    Some([line.at(first.min(last) - more), line.at(first.max(last) + more)])
}
