//! A subdivision with its portals and its adjacency graph (Teller and Séquin 1991, figure 5).

use super::floor::{Floor, mean};
use super::palette;
use super::sheet::{Pen, Sample, Sheet, text_width};
use super::svg::{Place, number};

/// Draws faces, cells, portals and the adjacency graph: a node in the middle of each cell, and an
/// edge for each portal, through its middle.
pub fn draw_cells(mut sheet: Sheet, floor: &Floor) -> String {
    let sizes = floor.sizes(&sheet);
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
    sheet.draw_segments(Pen::round(palette::GRAPH, sizes.line), &edges, "adjacency graph");
    draw_nodes(&mut sheet, floor);
    sheet.explain(Sample::Area(palette::CELL), format!("{} cells", floor.names.len()));
    sheet.finish()
}

/// The nodes of the graph: around the names where those are short, else dots with the names below.
fn draw_nodes(sheet: &mut Sheet, floor: &Floor) {
    let sizes = floor.sizes(sheet);
    let longest = floor.names.iter().map(|name| text_width(name, sizes.font)).fold(0.0, f64::max);
    let width = number(sizes.line);
    if floor.has_names(sheet) && longest < 3.0 * sizes.font {
        let radius = (longest / 2.0).max(0.75 * sizes.font);
        let style = [("fill", palette::CELL), ("stroke", palette::GRAPH), ("stroke-width", &width)];
        sheet.svg.group(&style, |svg| {
            floor.middles.iter().for_each(|&middle| svg.circle(middle, radius));
        });
        floor.draw_names(sheet, 0.0, |_| [palette::TEXT, palette::CELL]);
        return;
    }
    sheet.svg.group(&[("fill", palette::GRAPH)], |svg| {
        floor.middles.iter().for_each(|&middle| svg.circle(middle, 0.6 * sizes.node));
    });
    floor.draw_names(sheet, 0.6 * sizes.node + sizes.font, |_| [palette::TEXT, palette::CELL]);
}
