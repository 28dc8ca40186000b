//! A stab tree by itself, in layers (Teller and Séquin 1991, figure 8).

use super::palette;
use super::sheet::{Pen, Sample, Sheet, SheetOptions, text_width};
use super::svg::{Place, number};
use super::tree::TreeNode;
use crate::num::Rational;

/// Draws a tree in layers: the root on top, a node for each cell that a sequence reaches, an edge
/// for each portal. Where there is room, nodes have the names of their cells and edges the numbers
/// of their portals.
///
/// `names` are those of the cells; `nodes` begins with the root, and has each node after the one
/// before it.
pub fn draw_tree_graph(names: &[String], nodes: &[TreeNode], options: &SheetOptions) -> String {
    let (columns, depths) = layers(nodes);
    let slots = columns.iter().copied().fold(0.0, f64::max) + 1.0;
    let layers = f64::from(depths.iter().copied().max().unwrap_or(0)) + 1.0;
    // The drawing in hundredths of its width: layers are as high as slots are wide, within reason.
    let height = ((100.0 / slots).clamp(4.0, 12.0) * layers).ceil() as i64;
    let point = |x: i64, y: i64| [x, y].map(|c| Rational::from_integer(c.into()));
    let mut sheet = Sheet::new([point(0, 0), point(100, height)], options);
    let [[left, top], [right, bottom]] = sheet.drawing();
    let [slot, layer] = [(right - left) / slots, (bottom - top) / layers];
    let places = columns.iter().zip(&depths).map(|(column, &depth)| {
        [left + (column + 0.5) * slot, top + (f64::from(depth) + 0.5) * layer]
    });
    let tree = Diagram { names, nodes, places: places.collect() };
    let line = sheet.width() / 900.0;
    let edges: Vec<[Place; 2]> = tree.edges().map(|(ends, _)| ends).collect();
    sheet.draw_segments(Pen::round(palette::PORTAL, line), &edges, "portal, by its number");
    sheet.explain(Sample::Dot(palette::VISIBLE), "cell that a sequence of portals reaches");
    let font = tree.font(slot).min(0.28 * layer).min(sheet.font());
    if font < sheet.width() / 160.0 {
        tree.draw_nodes(&mut sheet, 0.3 * slot.min(layer));
    } else {
        tree.draw_nodes(&mut sheet, (0.35 + 0.5 * tree.longest_name()) * font);
        tree.draw_names(&mut sheet, font);
        tree.draw_numbers(&mut sheet, NUMBER * font);
    }
    sheet.finish()
}

/// The font of an edge's number, where that of a node's name is 1.
const NUMBER: f64 = 0.85;

/// How far along an edge its number stands.
const ALONG: f64 = 0.6;

/// A tree whose nodes have their places.
struct Diagram<'a> {
    names: &'a [String],
    nodes: &'a [TreeNode],
    places: Vec<Place>,
}

impl Diagram<'_> {
    fn name(&self, node: &TreeNode) -> &str {
        &self.names[node.cell.0 as usize]
    }

    /// The ends and the portal of each edge.
    fn edges(&self) -> impl Iterator<Item = ([Place; 2], u32)> + '_ {
        self.nodes.iter().zip(&self.places).filter_map(|(node, &place)| {
            let (before, portal) = node.before?;
            Some(([self.places[before as usize], place], portal))
        })
    }

    /// The width of the longest name in a font of size 1.
    fn longest_name(&self) -> f64 {
        self.nodes.iter().map(|node| text_width(self.name(node), 1.0)).fold(1.2, f64::max)
    }

    /// The size of a font in which names keep to slots of this width; and so do the numbers of
    /// edges, which are nearer to each other than the nodes below them.
    fn font(&self, slot: f64) -> f64 {
        let numbers = self.edges().map(|(_, portal)| text_width(&portal.to_string(), NUMBER));
        let longest_number = numbers.fold(0.0, f64::max);
        (0.8 * slot / self.longest_name()).min(0.9 * ALONG * slot / longest_number)
    }

    /// The nodes and their places: the root, or all others.
    fn of_kind(&self, is_root: bool) -> impl Iterator<Item = (&TreeNode, Place)> {
        let all = self.nodes.iter().zip(self.places.iter().copied());
        all.filter(move |(node, _)| node.before.is_none() == is_root)
    }

    fn draw_nodes(&self, sheet: &mut Sheet, radius: f64) {
        let width = number(sheet.width() / 900.0);
        for (is_root, colour) in [(true, palette::SOURCE), (false, palette::VISIBLE)] {
            let style = [("fill", colour), ("stroke", palette::CELL), ("stroke-width", &width)];
            sheet.svg.group(&style, |svg| {
                self.of_kind(is_root).for_each(|(_, place)| svg.circle(place, radius));
            });
        }
    }

    fn draw_names(&self, sheet: &mut Sheet, font: f64) {
        let size = number(font);
        for (is_root, colour) in [(true, palette::CELL), (false, palette::TEXT)] {
            let style = [("fill", colour), ("font-size", &size), ("text-anchor", "middle")];
            sheet.svg.group(&style, |svg| {
                for (node, [x, y]) in self.of_kind(is_root) {
                    svg.text([x, y + 0.35 * font], self.name(node));
                }
            });
        }
    }

    /// The numbers of portals, each on a patch of paper over its edge.
    fn draw_numbers(&self, sheet: &mut Sheet, font: f64) {
        let numbers: Vec<(Place, String)> = self
            .edges()
            .map(|([from, to], portal)| {
                let place = [0, 1].map(|axis| from[axis] + ALONG * (to[axis] - from[axis]));
                (place, portal.to_string())
            })
            .collect();
        sheet.svg.group(&[("fill", palette::CELL)], |svg| {
            for ([x, y], text) in &numbers {
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
    use crate::scene::CellId;

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
