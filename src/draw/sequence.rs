//! A sequence of segments with the hulls of its left and of its right ends, and a line that parts
//! them (Teller and Séquin 1991, figure 6).

use super::frame::{box_around, widened};
use super::palette;
use super::sheet::{Pen, Sample, Sheet, SheetOptions};
use super::svg::{Place, number};
use crate::num::{Rational, Sign};
use crate::predicates::{PlanPoint, compare_coordinates, turn_of_points};

/// How a line and a sequence are.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum SequenceLine {
    /// It passes strictly inside each portal; two points of it.
    Stabbing([[Rational; 2]; 2]),
    /// It meets each closed portal, but no line passes strictly inside all.
    Touching([[Rational; 2]; 2]),
    /// There is none.
    Blocked,
}

/// Draws segments, each with its left and its right end, in the order of the sequence; the hulls
/// of all left and of all right ends, which a stabbing line parts; and the line.
pub fn draw_sequence(
    portals: &[[[Rational; 2]; 2]],
    line: &SequenceLine,
    options: &SheetOptions,
) -> String {
    let portals: Vec<[PlanPoint; 2]> =
        portals.iter().map(|ends| ends.each_ref().map(PlanPoint::from_coordinates)).collect();
    let unit = || [Rational::from_integer(0.into()), Rational::from_integer(1.into())];
    let bounds = box_around(portals.iter().flatten()).unwrap_or_else(|| [unit(), unit()]);
    let mut sheet = Sheet::new(widened(bounds), options);
    let width = sheet.width() / 300.0;
    let sides = [(0, palette::GRAPH, "left ends"), (1, palette::SIGHT, "right ends")];
    for (side, colour, _) in sides {
        let hull = hull(portals.iter().map(|portal| &portal[side]));
        let hull: Vec<Place> = hull.iter().map(|corner| sheet.frame.place_point(corner)).collect();
        let hair = number(width / 3.0);
        let style = [
            ("fill", colour),
            ("fill-opacity", "0.15"),
            ("stroke", colour),
            ("stroke-width", hair.as_str()),
        ];
        sheet.svg.group(&style, |svg| svg.outlines([hull.as_slice()]));
    }
    let segments: Vec<[Place; 2]> = portals
        .iter()
        .map(|portal| portal.each_ref().map(|end| sheet.frame.place_point(end)))
        .collect();
    let pen = Pen::round(palette::WALL, width);
    sheet.draw_segments(pen, &segments, "portal, numbered in its order");
    let [[x0, y0], [x1, y1]] = sheet.drawing();
    let paper = [[x0, y0], [x1, y0], [x1, y1], [x0, y1]];
    let drawn = match line {
        SequenceLine::Stabbing(points) => {
            Some((points, Pen::round(palette::EYE, 0.7 * width), "stabbing line"))
        }
        SequenceLine::Touching(points) => {
            Some((points, Pen::dashed(palette::EYE, 0.7 * width), "touching line"))
        }
        SequenceLine::Blocked => None,
    };
    if let Some((points, pen, text)) = drawn
        && let Some(ray) = sheet.frame.ray(points)
        && let Some(ends) = ray.within(&paper)
    {
        sheet.draw_segments(pen, &[ends.map(|end| ray.at(end))], text);
    }
    for (side, colour, text) in sides {
        sheet.svg.group(&[("fill", colour)], |svg| {
            segments.iter().for_each(|ends| svg.circle(ends[side], 1.6 * width));
        });
        sheet.explain(Sample::Dot(colour), text);
    }
    number_portals(&mut sheet, &segments);
    sheet.finish()
}

/// The number of each portal beside its left end, away from its right one.
fn number_portals(sheet: &mut Sheet, segments: &[[Place; 2]]) {
    let font = sheet.font();
    let size = number(font);
    let style = [("fill", palette::TEXT), ("font-size", &size), ("text-anchor", "middle")];
    sheet.svg.group(&style, |svg| {
        for (index, [left, right]) in segments.iter().enumerate() {
            let away = [left[0] - right[0], left[1] - right[1]];
            let length = (away[0] * away[0] + away[1] * away[1]).sqrt();
            let [x, y] = [0, 1].map(|i| left[i] + 1.1 * font * away[i] / length.max(1.0));
            svg.text([x, y + 0.35 * font], &(index + 1).to_string());
        }
    });
}

/// The convex hull, counter-clockwise; a point or two where all are in line.
fn hull<'a>(points: impl Iterator<Item = &'a PlanPoint>) -> Vec<&'a PlanPoint> {
    let mut points: Vec<&PlanPoint> = points.collect();
    points.sort_by(|a, b| compare_coordinates(0, a, b).then(compare_coordinates(1, a, b)));
    points.dedup();
    let chain = |points: &mut dyn Iterator<Item = &'a PlanPoint>| {
        let mut chain: Vec<&PlanPoint> = Vec::new();
        for point in points {
            while let [.., a, b] = chain[..] {
                match turn_of_points(a, b, point) {
                    Sign::Positive => break,
                    // In line: the middle one is no corner.
                    Sign::Zero | Sign::Negative => chain.pop(),
                };
            }
            chain.push(point);
        }
        chain
    };
    let mut hull = chain(&mut points.iter().copied());
    let upper = chain(&mut points.iter().rev().copied());
    if upper.len() > 1 {
        hull.extend(&upper[1..upper.len() - 1]);
    }
    hull
}
