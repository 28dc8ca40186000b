//! A subdivision with its portals and its adjacency graph (Teller and Séquin 1991, figure 5).

use super::floor::{Floor, mean, stroke};
use super::palette;
use super::sheet::{Sample, Sheet, text_width};
use super::svg::{Place, number};

/// Draws faces, cells, portals and the adjacency graph: a node in the middle of each cell, and an
/// edge for each portal, through its middle.
pub fn draw_cells(mut sheet: Sheet, floor: &Floor) -> String {
    let pens = floor.pens(&sheet);
    floor.draw_cells(&mut sheet, |_| palette::CELL);
    floor.draw_portals(&mut sheet);
    floor.draw_faces(&mut sheet);
    let edges: Vec<[Place; 2]> = floor
        .portals
        .iter()
        .zip(&floor.sides)
        .flat_map(|(portal, sides)| {
            let through = mean(portal);
            sides.map(|side| [floor.middles[side.0 as usize], through])
        })
        .collect();
    stroke(&mut sheet.svg, (palette::GRAPH, pens.line, ""), &edges);
    let longest = floor.names.iter().map(|name| text_width(name, pens.font)).fold(0.0, f64::max);
    let has_names = pens.font >= sheet.width() / 140.0 && longest < 3.0 * pens.font;
    let width = number(pens.line);
    let style = match has_names {
        true => [("fill", "#ffffff"), ("stroke", palette::GRAPH), ("stroke-width", &width)],
        false => [("fill", palette::GRAPH), ("stroke", "none"), ("stroke-width", "0")],
    };
    let radius = if has_names { (longest / 2.0).max(0.75 * pens.font) } else { pens.node };
    sheet.svg.group(&style[..if has_names { 3 } else { 1 }], |svg| {
        floor.middles.iter().for_each(|&middle| svg.circle(middle, radius));
    });
    if has_names {
        floor.draw_names(&mut sheet, |_| palette::TEXT);
    }
    sheet.explain(Sample::Line(palette::GRAPH, pens.line, ""), "adjacency graph");
    sheet.explain(Sample::Area(palette::CELL), format!("{} cells", floor.names.len()));
    sheet.finish()
}
