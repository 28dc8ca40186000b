//! A stab tree over its plan (Teller and Séquin 1991, figures 8 and 11b).

use super::floor::{Floor, mean};
use super::palette;
use super::sheet::{Pen, Sample, Sheet};
use super::svg::{Place, number};
use super::visibility::Seen;
use crate::scene::CellId;

/// A node of a stab tree: a cell reached through one sequence of portals.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TreeNode {
    /// The cell.
    pub cell: CellId,
    /// The node before it, by its index, and the portal between them; none for the root.
    pub before: Option<(u32, u32)>,
}

/// Draws a tree over the cells that it visits: an edge runs through its portal, and a cell that is
/// visited through several portals has a node near each of them.
///
/// `nodes` begins with the root, and has each node after the one before it.
pub fn draw_stab_tree(mut sheet: Sheet, floor: &Floor, nodes: &[TreeNode]) -> String {
    let Some(root) = nodes.first() else { return sheet.finish() };
    let visible: Vec<CellId> = nodes.iter().map(|node| node.cell).collect();
    let seen = Seen::new(floor, root.cell, &visible);
    seen.draw(&mut sheet, floor);
    let sizes = floor.sizes(&sheet);
    floor.draw_faces(&mut sheet);
    let mut places: Vec<Place> = Vec::with_capacity(nodes.len());
    let mut edges: Vec<[Place; 3]> = Vec::with_capacity(nodes.len());
    for node in nodes {
        let middle = floor.middles[node.cell.0 as usize];
        let Some((before, portal)) = node.before else {
            places.push(middle);
            continue;
        };
        let through = mean(&floor.portals[portal as usize]);
        let place = [0, 1].map(|axis| 0.65 * middle[axis] + 0.35 * through[axis]);
        edges.push([places[before as usize], through, place]);
        places.push(place);
    }
    let width = number(sizes.line);
    let pen = Pen::round(palette::SIGHT, sizes.line);
    pen.draw(&mut sheet.svg, edges.iter().map(<[Place; 3]>::as_slice));
    let style = [("fill", palette::SIGHT), ("stroke", palette::CELL), ("stroke-width", &width)];
    let radius = (2.2 * sizes.line).min(sizes.node);
    sheet.svg.group(&style, |svg| places.iter().for_each(|&place| svg.circle(place, radius)));
    let what = format!("stab tree, {} nodes", nodes.len());
    sheet.explain(Sample::Line(pen), what);
    sheet.finish()
}
