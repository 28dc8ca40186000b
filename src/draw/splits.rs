//! The lines that divide a plan, in the order of the tree (after Teller and Séquin 1991, figures 3
//! and 4).

use super::floor::Floor;
use super::palette;
use super::sheet::{Pen, Sample, Sheet, Tip, text_width};
use super::svg::{Place, number};
use crate::subdivision::plan::{Branch, PlanTree};

/// Up to so many splits are numbered.
const NUMBERED: usize = 120;

/// Draws each split as far as it divides a cell: the first ones widest, and numbered in the order
/// of depth.
pub fn draw_splits(mut sheet: Sheet, floor: &Floor, tree: &PlanTree) -> String {
    let sizes = floor.sizes(&sheet);
    floor.draw_cells(&mut sheet, |_| palette::CELL);
    let splits = splits(&sheet, tree);
    let text = format!("{} splits of depth {}, the first ones wide", splits.len(), tree.depth());
    for same in splits.chunk_by(|one, other| one.0 == other.0) {
        let own: Vec<[Place; 2]> = same.iter().map(|split| split.1).collect();
        let width = sizes.face * (1.2 + 2.0 / (1.0 + 0.5 * same[0].0 as f64));
        let pen = Pen { colour: palette::SPLIT, width, tip: Tip::Flat };
        pen.draw(&mut sheet.svg, own.iter().map(<[Place; 2]>::as_slice));
    }
    floor.draw_faces(&mut sheet);
    if splits.len() <= NUMBERED {
        let font = (0.8 * sizes.font).min(0.85 * sheet.font()).max(sheet.width() / 120.0);
        number_splits(&mut sheet, &splits, font);
    }
    sheet.explain(Sample::Line(Pen::round(palette::SPLIT, 2.0 * sizes.face)), text);
    sheet.finish()
}

/// The splits by depth, then from left to right in the tree: their depths and their ends.
fn splits(sheet: &Sheet, tree: &PlanTree) -> Vec<(usize, [Place; 2])> {
    let places = sheet.frame.place_all(&tree.points);
    let [[x0, y0], [x1, y1]] = sheet.drawing();
    let whole = vec![[x0, y1], [x1, y1], [x1, y0], [x0, y0]];
    let mut splits = Vec::with_capacity(tree.nodes.len());
    let mut layer = vec![(tree.root, whole)];
    let mut depth = 0;
    while !layer.is_empty() {
        let mut next = Vec::new();
        for (branch, outline) in layer {
            let Branch::Node(number) = branch else { continue };
            let node = &tree.nodes[number as usize];
            let line = tree.lines.through(node.line).map(|end| places[end as usize]);
            // Pictures have y downwards, so what is left in the plane is right here.
            let (right, left) = (part(&outline, line, 1.0), part(&outline, line, -1.0));
            splits.extend(ends(&right, line).map(|ends| (depth, ends)));
            next.extend([(node.left, left), (node.right, right)]);
        }
        layer = next;
        depth += 1;
    }
    splits
}

/// How far to one side of a line a place is, times the distance of the line's two places.
fn height([a, b]: [Place; 2], [x, y]: Place) -> f64 {
    (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])
}

/// The part of a convex polygon on one side of a line.
fn part(outline: &[Place], line: [Place; 2], side: f64) -> Vec<Place> {
    let mut part = Vec::with_capacity(outline.len() + 1);
    for (index, &a) in outline.iter().enumerate() {
        let b = outline[(index + 1) % outline.len()];
        let (from, to) = (side * height(line, a), side * height(line, b));
        if from >= 0.0 {
            part.push(a);
        }
        if (from > 0.0 && to < 0.0) || (from < 0.0 && to > 0.0) {
            let t = from / (from - to);
            part.push([0, 1].map(|axis| a[axis] + t * (b[axis] - a[axis])));
        }
    }
    part
}

/// The ends of the edge of a polygon that lies along a line: the two corners nearest to it.
fn ends(outline: &[Place], line: [Place; 2]) -> Option<[Place; 2]> {
    let mut near = outline.to_vec();
    near.sort_by(|a, b| height(line, *a).abs().total_cmp(&height(line, *b).abs()));
    Some([*near.first()?, *near.get(1)?])
}

/// The number of each split on a patch at its middle.
fn number_splits(sheet: &mut Sheet, splits: &[(usize, [Place; 2])], font: f64) {
    let labels: Vec<(Place, String)> = splits
        .iter()
        .enumerate()
        .map(|(index, (_, ends))| (super::floor::mean(ends), (index + 1).to_string()))
        .collect();
    let width = number(font / 14.0);
    let style = [("fill", palette::CELL), ("stroke", palette::PORTAL), ("stroke-width", &width)];
    sheet.svg.group(&style, |svg| {
        for (place, text) in &labels {
            let half = text_width(text, font) / 2.0 + 0.2 * font;
            svg.rectangle([place[0] - half, place[1] - 0.62 * font], [2.0 * half, 1.24 * font]);
        }
    });
    let size = number(font);
    let style = [("fill", palette::TEXT), ("font-size", &size), ("text-anchor", "middle")];
    sheet.svg.group(&style, |svg| {
        labels.iter().for_each(|([x, y], text)| svg.text([*x, y + 0.36 * font], text));
    });
}
