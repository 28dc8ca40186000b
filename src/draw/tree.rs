//! A stab tree over its plan (Teller and Séquin 1991, figures 8 and 11b), and by itself.

use super::floor::{Floor, mean};
use super::palette;
use super::sheet::{Pen, Sample, Sheet, SheetOptions, text_width};
use super::svg::{Place, number};
use super::visibility::Seen;
use crate::num::Rational;
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

/// Draws a tree in layers: the root on top, a node for each cell that a sequence reaches, an edge
/// for each portal.
///
/// `names` are those of the cells; `nodes` is as in [`draw_stab_tree`].
pub fn draw_tree_graph(names: &[String], nodes: &[TreeNode], options: &SheetOptions) -> String {
    let (columns, depths) = layers(nodes);
    let deepest = depths.iter().copied().max().unwrap_or(0) as f64;
    let slots = columns.iter().copied().fold(0.0, f64::max) + 1.0;
    // In units of a hundredth of the width.
    let slot = 100.0 / slots;
    let layer = slot.clamp(4.0, 12.0);
    let height = (layer * (deepest + 1.0)).ceil() as i64;
    let point = |x: i64, y: i64| [x, y].map(|c| Rational::from_integer(c.into()));
    let mut sheet = Sheet::new([point(0, 0), point(100, height)], options);
    let [[left, top], [right, bottom]] = sheet.drawing();
    let (slot, layer) = ((right - left) / slots, (bottom - top) / (deepest + 1.0));
    let places: Vec<Place> = columns
        .iter()
        .zip(&depths)
        .map(|(column, &depth)| {
            [left + (column + 0.5) * slot, top + (f64::from(depth) + 0.5) * layer]
        })
        .collect();
    let edges: Vec<([Place; 2], u32)> = nodes
        .iter()
        .zip(&places)
        .filter_map(|(node, &place)| {
            let (before, portal) = node.before?;
            Some(([places[before as usize], place], portal))
        })
        .collect();
    let line = sheet.width() / 900.0;
    let segments: Vec<[Place; 2]> = edges.iter().map(|(ends, _)| *ends).collect();
    sheet.draw_segments(Pen::round(palette::PORTAL, line), &segments, "portal, by its number");
    sheet.explain(Sample::Dot(palette::VISIBLE), "cell that a sequence of portals reaches");
    let name = |node: &TreeNode| names[node.cell.0 as usize].as_str();
    let longest = nodes.iter().map(|node| text_width(name(node), 1.0)).fold(1.2, f64::max);
    let font = (0.8 * slot / longest).min(0.28 * layer).min(sheet.font());
    let has_text = font >= sheet.width() / 160.0;
    let radius =
        if has_text { 0.5 * longest.min(2.2) * font + 0.35 * font } else { 0.3 * slot.min(layer) };
    draw_nodes(&mut sheet, nodes, &places, radius);
    if has_text {
        label(&mut sheet, nodes, &places, &name, font);
        let numbers: Vec<(Place, String)> = edges
            .iter()
            .map(|([from, to], portal)| {
                ([0, 1].map(|axis| 0.4 * from[axis] + 0.6 * to[axis]), portal.to_string())
            })
            .collect();
        label_edges(&mut sheet, &numbers, 0.85 * font);
    }
    sheet.finish()
}

fn draw_nodes(sheet: &mut Sheet, nodes: &[TreeNode], places: &[Place], radius: f64) {
    let width = number(sheet.width() / 900.0);
    for is_root in [true, false] {
        let colour = if is_root { palette::SOURCE } else { palette::VISIBLE };
        let style = [("fill", colour), ("stroke", palette::CELL), ("stroke-width", &width)];
        sheet.svg.group(&style, |svg| {
            let all = nodes.iter().zip(places);
            let own = all.filter(|(node, _)| node.before.is_none() == is_root);
            own.for_each(|(_, &place)| svg.circle(place, radius));
        });
    }
}

fn label<'n>(
    sheet: &mut Sheet,
    nodes: &'n [TreeNode],
    places: &[Place],
    name: &impl Fn(&'n TreeNode) -> &'n str,
    font: f64,
) {
    let size = number(font);
    for is_root in [true, false] {
        let colour = if is_root { palette::CELL } else { palette::TEXT };
        let style = [("fill", colour), ("font-size", &size), ("text-anchor", "middle")];
        sheet.svg.group(&style, |svg| {
            let all = nodes.iter().zip(places);
            for (node, [x, y]) in all.filter(|(node, _)| node.before.is_none() == is_root) {
                svg.text([*x, y + 0.35 * font], name(node));
            }
        });
    }
}

/// Numbers over lines, each on a patch of paper.
fn label_edges(sheet: &mut Sheet, numbers: &[(Place, String)], font: f64) {
    sheet.svg.group(&[("fill", palette::CELL)], |svg| {
        for ([x, y], text) in numbers {
            let width = text_width(text, font);
            svg.rectangle([x - width / 2.0, y - 0.5 * font], [width, font]);
        }
    });
    let size = number(font);
    let style = [("fill", palette::PORTAL), ("font-size", &size), ("text-anchor", "middle")];
    sheet.svg.group(&style, |svg| {
        numbers.iter().for_each(|([x, y], text)| svg.text([*x, y + 0.36 * font], text));
    });
}

/// The column and the depth of each node: leaves one beside the other in the order of the tree,
/// any other node above the middle of those that it leads to.
fn layers(nodes: &[TreeNode]) -> (Vec<f64>, Vec<u32>) {
    let mut depths = vec![0u32; nodes.len()];
    let mut children: Vec<Vec<usize>> = vec![Vec::new(); nodes.len()];
    for (index, node) in nodes.iter().enumerate() {
        if let Some((before, _)) = node.before {
            depths[index] = depths[before as usize] + 1;
            children[before as usize].push(index);
        }
    }
    let mut columns = vec![0.0; nodes.len()];
    let mut next = 0.0;
    // Depth first: a node is met a second time when all below it is placed.
    let mut stack: Vec<(usize, bool)> =
        if nodes.is_empty() { Vec::new() } else { vec![(0, false)] };
    while let Some((index, is_done)) = stack.pop() {
        match children[index].as_slice() {
            [] => {
                columns[index] = next;
                next += 1.0;
            }
            all if is_done => {
                let [first, last] = [all[0], all[all.len() - 1]];
                columns[index] = (columns[first] + columns[last]) / 2.0;
            }
            all => {
                stack.push((index, true));
                stack.extend(all.iter().rev().map(|&child| (child, false)));
            }
        }
    }
    (columns, depths)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn layers_of_a_tree_do_not_overlap() {
        let node =
            |before: Option<u32>| TreeNode { cell: CellId(0), before: before.map(|b| (b, 0)) };
        let tree = [None, Some(0), Some(1), Some(1), Some(0), Some(0)].map(node);
        let (columns, depths) = layers(&tree);
        assert_eq!(columns, [1.75, 0.5, 0.0, 1.0, 2.0, 3.0]);
        assert_eq!(depths, [0, 1, 2, 2, 1, 1]);
        assert_eq!(layers(&[]), (Vec::new(), Vec::new()));
    }
}
