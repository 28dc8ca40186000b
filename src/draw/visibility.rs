//! What one cell sees, with the lines that show it (Teller and Séquin 1991, figures 7 and 11a).

use super::floor::{Floor, Pens, stroke};
use super::frame::{Frame, Ray};
use super::palette;
use super::sheet::{Sample, Sheet};
use super::svg::{Place, number};
use crate::num::Rational;
use crate::scene::CellId;

/// A line that two cells see each other along.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sightline {
    /// A cell that it passes.
    pub from: CellId,
    /// Another one.
    pub to: CellId,
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
    draw_seen(&mut sheet, floor, source, visible);
    let pens = floor.pens(&sheet);
    floor.draw_faces(&mut sheet);
    let drawn: Vec<[Place; 2]> =
        lines.iter().filter_map(|line| between(&sheet.frame, floor, line)).collect();
    stroke(&mut sheet.svg, (palette::SIGHT, pens.line, ""), &drawn);
    sheet.svg.group(&[("fill", palette::SIGHT)], |svg| {
        drawn.iter().flatten().for_each(|&end| svg.circle(end, 1.8 * pens.line));
    });
    floor.draw_names(&mut sheet, |cell| name_colour(cell, source));
    if !drawn.is_empty() {
        sheet.explain(Sample::Line(palette::SIGHT, pens.line, ""), "stabbing line");
    }
    sheet.finish()
}

/// The cells: the one that looks, those that it sees, and the others.
pub(super) fn draw_seen(sheet: &mut Sheet, floor: &Floor, source: CellId, visible: &[CellId]) {
    let mut is_visible = vec![false; floor.names.len()];
    visible.iter().for_each(|cell| is_visible[cell.0 as usize] = true);
    is_visible[source.0 as usize] = false;
    let count = is_visible.iter().filter(|is_visible| **is_visible).count();
    floor.draw_cells(sheet, |cell| match cell {
        cell if cell == source => palette::SOURCE,
        cell if is_visible[cell.0 as usize] => palette::VISIBLE,
        _ => palette::CELL,
    });
    draw_shapeless(sheet, floor, source, &is_visible);
    sheet.explain(Sample::Area(palette::SOURCE), format!("cell {}", floor.name(source)));
    let others = floor.names.len() - 1;
    sheet.explain(Sample::Area(palette::VISIBLE), format!("sees {count} of {others} others"));
}

/// Cells without a shape as dots.
fn draw_shapeless(sheet: &mut Sheet, floor: &Floor, source: CellId, is_visible: &[bool]) {
    let Pens { font, hair, .. } = floor.pens(sheet);
    let width = number(hair);
    for cell in floor.cells().filter(|&cell| floor.outline(cell).is_empty()) {
        let colour = match cell {
            cell if cell == source => palette::SOURCE,
            cell if is_visible[cell.0 as usize] => palette::VISIBLE,
            _ => palette::CELL,
        };
        let style = [("fill", colour), ("stroke", palette::EDGE), ("stroke-width", &width)];
        sheet.svg.group(&style, |svg| svg.circle(floor.middles[cell.0 as usize], 1.5 * font));
    }
}

/// The colour of a name on a cell as [`draw_seen`] draws it.
pub(super) fn name_colour(cell: CellId, source: CellId) -> &'static str {
    if cell == source { palette::CELL } else { palette::TEXT }
}

/// The part of a line from the middle of its way through the one cell to that through the other.
fn between(frame: &Frame, floor: &Floor, sight: &Sightline) -> Option<[Place; 2]> {
    let line = frame.ray(&sight.line)?;
    let middle = |cell: CellId| line.middle_within(floor.outline(cell));
    match (middle(sight.from), middle(sight.to)) {
        (Some(from), Some(to)) => Some([from, to]),
        // Without shapes, what the line joins are the cells' own places.
        _ => Some([sight.from, sight.to].map(|cell| floor.middles[cell.0 as usize])),
    }
}

impl Ray {
    /// The middle of the line's way through a convex polygon, if it passes that.
    fn middle_within(&self, outline: &[Place]) -> Option<Place> {
        let [enter, leave] = self.within(outline)?;
        Some(self.at((enter + leave) / 2.0))
    }
}
