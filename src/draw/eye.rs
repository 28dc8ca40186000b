//! What an eye sees under a cull (Teller and Séquin 1991, figures 9, 10, 11c and 11d).

use super::floor::Floor;
use super::palette;
use super::sheet::{Pen, Sample, Sheet};
use super::svg::{Place, number};
use crate::num::Rational;
use crate::predicates::PlanPoint;
use crate::scene::CellId;

/// What is to be drawn of an eye.
#[derive(Clone, Debug, Default)]
pub struct EyeDrawing {
    /// The directions of the view cone's right and left ray; none for all around.
    pub cone: Option<[[Rational; 2]; 2]>,
    /// The cells that are visible from the eye's cell.
    pub visible: Vec<CellId>,
    /// Those of them that the cull leaves.
    pub left: Vec<CellId>,
    /// What is seen exactly: convex polygons, in grid units.
    pub regions: Vec<Vec<PlanPoint>>,
    /// What the cull is called.
    pub cull: &'static str,
}

/// Draws an eye and its cone, the cells that the cull leaves in blue, those that it removes in
/// green, and what is seen exactly in blue-green.
pub fn draw_eye(mut sheet: Sheet, floor: &Floor, eye: &PlanPoint, drawing: &EyeDrawing) -> String {
    let mut colours = vec![palette::CELL; floor.names.len()];
    let layers = [(&drawing.visible, palette::CULLED), (&drawing.left, palette::VISIBLE_NOW)];
    for (cells, colour) in layers {
        cells.iter().for_each(|cell| colours[cell.0 as usize] = colour);
    }
    let count = |colour: &str| colours.iter().filter(|own| **own == colour).count();
    let [left, culled] = [palette::VISIBLE_NOW, palette::CULLED].map(count);
    floor.draw_cells(&mut sheet, |cell| colours[cell.0 as usize]);
    let sizes = floor.sizes(&sheet);
    let width = number(sizes.hair);
    let style = [("fill", palette::SEEN), ("stroke", palette::SEEN), ("stroke-width", &width)];
    let regions: Vec<Vec<Place>> = drawing
        .regions
        .iter()
        .map(|region| region.iter().map(|corner| sheet.frame.place_point(corner)).collect())
        .collect();
    sheet.svg.group(&style, |svg| svg.outlines(regions.iter().map(Vec::as_slice)));
    floor.draw_faces(&mut sheet);
    let place = sheet.frame.place_point(eye);
    let rays = rays(&sheet, eye, drawing.cone.as_ref());
    sheet.draw_segments(Pen::dashed(palette::EYE, sizes.line), &rays, "view cone");
    let radius = (3.0 * sizes.line).max(sheet.width() / 200.0);
    let ring = number(1.2 * sizes.line);
    let style = [("fill", palette::EYE), ("stroke", palette::CELL), ("stroke-width", &ring)];
    sheet.svg.group(&style, |svg| svg.circle(place, radius));
    sheet.explain(Sample::Dot(palette::EYE), "eye");
    sheet.explain(Sample::Area(palette::SEEN), "visible area");
    let text = format!("{left} cells left ({})", drawing.cull);
    sheet.explain(Sample::Area(palette::VISIBLE_NOW), text);
    if culled > 0 {
        sheet.explain(Sample::Area(palette::CULLED), format!("{culled} cells culled"));
    }
    sheet.finish()
}

/// The rays of a view cone, to the edge of the drawing.
fn rays(sheet: &Sheet, eye: &PlanPoint, cone: Option<&[[Rational; 2]; 2]>) -> Vec<[Place; 2]> {
    let [[x0, y0], [x1, y1]] = sheet.drawing();
    let paper = [[x0, y0], [x1, y0], [x1, y1], [x0, y1]];
    let sides = cone.into_iter().flatten();
    let rays = sides.filter_map(|along| {
        let ray = sheet.frame.ray_along(eye, along)?;
        let [_, leave] = ray.within(&paper)?;
        Some([ray.from, ray.at(leave.max(0.0))])
    });
    rays.collect()
}
