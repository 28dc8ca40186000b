//! Draws `docs/picture.svg`: a floor of nine rooms seen from above, what its rooms see of each
//! other, and the lines that prove it.
//!
//! The verdicts come from the library alone: every simple portal sequence that leaves a room is
//! pushed onto a [`Stabber`], portal by portal, and given up where no line passes. This is the
//! plainest use of the library, and enough for a scene of this size; `stabline pvs` is for levels.
//! Floats place marks on the drawing and decide nothing.
//!
//! Run with `cargo run --release --example draw_rooms > docs/picture.svg`.

use num_traits::ToPrimitive;
use stabline::geom::RationalPoint3;
use stabline::num::{Int, Rational, Surd};
use stabline::scene::{CellId, PortalGraph, read_graph};
use stabline::stab::{Portal3, Stabber, Verdict};
use std::fmt::Write;

const SCENE: &str = include_str!("../scenes/pvs/gallery_nine_rooms.json");

/// The rooms' outlines, counter-clockwise from above, in the order of the scene's cells. The scene
/// holds portals only; a test keeps the two in step.
const OUTLINES: [&[[f64; 2]]; 9] = [
    &[[8., 4.], [12., 4.], [14., 6.], [14., 10.], [12., 12.], [8., 12.], [6., 10.], [6., 6.]],
    &[[0., 4.], [6., 4.], [6., 12.], [0., 12.]],
    &[[14., 5.], [20., 5.], [20., 12.], [14., 12.]],
    &[[7., 12.], [13., 12.], [13., 18.], [7., 18.]],
    &[[6., -2.], [14., -2.], [14., 4.], [6., 4.]],
    &[[0., 12.], [7., 12.], [7., 18.], [0., 18.]],
    &[[13., 12.], [20., 12.], [20., 18.], [13., 18.]],
    &[[0., -2.], [6., -2.], [6., 4.], [0., 4.]],
    &[[14., -2.], [20., -2.], [20., 5.], [14., 5.]],
];

const OPEN: &str = "#1a7f37";
const GRAZING: &str = "#9a6700";
const BLOCKED: &str = "#d0d7de";
const WALL: &str = "#24292f";

/// Two points of a line, in its direction, seen from above.
type Line = [[f64; 2]; 2];

/// What one room sees of another, with a line where there is one.
#[derive(Clone, Debug, Default)]
enum Sight {
    #[default]
    Blocked,
    Grazing {
        line: Line,
    },
    Open {
        line: Line,
        doors: usize,
    },
}

/// The sights of one room: a depth-first search over all sequences that stay out of rooms that
/// they have left.
struct Search<'a> {
    graph: &'a PortalGraph,
    stabber: Stabber,
    visited: Vec<bool>,
    sights: Vec<Sight>,
}

impl Search<'_> {
    fn from_room(graph: &PortalGraph, room: CellId) -> Vec<Sight> {
        let rooms = graph.cells.len();
        let (visited, sights) = (vec![false; rooms], vec![Sight::default(); rooms]);
        let mut search = Search { graph, stabber: Stabber::new(), visited, sights };
        search.enter(room);
        search.sights
    }

    fn enter(&mut self, room: CellId) {
        self.visited[room.0 as usize] = true;
        for (next, portal) in ways_out(self.graph, room) {
            if self.visited[next.0 as usize] {
                continue;
            }
            self.stabber.push(&portal, false);
            let verdict = self.stabber.verdict();
            let blocked = matches!(verdict, Verdict::Blocked { .. });
            self.record(next, verdict);
            // Where no line touches all portals so far, none touches more of them.
            if !blocked {
                self.enter(next);
            }
            self.stabber.pop();
        }
        self.visited[room.0 as usize] = false;
    }

    fn record(&mut self, room: CellId, verdict: Verdict) {
        let sight = &mut self.sights[room.0 as usize];
        match (verdict, &sight) {
            (Verdict::Blocked { .. }, _) | (_, Sight::Open { .. }) => {}
            (Verdict::Grazing { touching_line, .. }, _) => {
                let line = touching_line.points.each_ref();
                let line =
                    line.map(|p| from_above(self.graph, p.each_ref().map(Surd::approximate)));
                *sight = Sight::Grazing { line };
            }
            (Verdict::Open { witness }, _) => {
                let line = witness
                    .points
                    .each_ref()
                    .map(|p| from_above(self.graph, p.each_ref().map(float)));
                *sight = Sight::Open { line, doors: self.stabber.depth() };
            }
        }
    }
}

/// The portals of a room, as a line crosses them that leaves it, and the rooms behind them.
fn ways_out(graph: &PortalGraph, room: CellId) -> Vec<(CellId, Portal3)> {
    let mut ways = Vec::new();
    let unit = unit(graph);
    for portal in &graph.portals {
        let corners = graph.corners(portal).map(|corner| corner.on_grid(&unit));
        let polygon = Portal3::new(&corners.collect::<Vec<_>>()).expect("a validated portal");
        if portal.from == room {
            ways.push((portal.to, polygon));
        } else if portal.to == room {
            ways.push((portal.from, polygon.reversed()));
        }
    }
    ways
}

/// Grid units in one world unit.
fn unit(graph: &PortalGraph) -> Int {
    RationalPoint3::common_denominator(&graph.vertices)
}

/// The place in the floor plan of a point in grid units.
fn from_above(graph: &PortalGraph, [x, y, _]: [f64; 3]) -> [f64; 2] {
    let unit = unit(graph).to_f64().expect("a small grid");
    [x / unit, y / unit]
}

fn float(value: &Rational) -> f64 {
    value.to_f64().expect("a coordinate of the scene")
}

/// Every room's sights.
fn all_sights(graph: &PortalGraph) -> Vec<Vec<Sight>> {
    (0..graph.cells.len() as u32).map(|room| Search::from_room(graph, CellId(room))).collect()
}

/// From where the line enters a convex outline to where it leaves it, in multiples of the line's
/// two points' distance.
fn span([p, q]: [[f64; 2]; 2], outline: &[[f64; 2]]) -> [f64; 2] {
    let mut span = [f64::NEG_INFINITY, f64::INFINITY];
    for (index, a) in outline.iter().enumerate() {
        let b = outline[(index + 1) % outline.len()];
        let inward = [a[1] - b[1], b[0] - a[0]];
        let height =
            |point: [f64; 2]| inward[0] * (point[0] - a[0]) + inward[1] * (point[1] - a[1]);
        let (start, slope) = (height(p), height(q) - height(p));
        if slope > 0. {
            span[0] = span[0].max(-start / slope);
        } else if slope < 0. {
            span[1] = span[1].min(-start / slope);
        }
    }
    span
}

/// The drawing's place of a point of the floor.
fn place([x, y]: [f64; 2]) -> [f64; 2] {
    [30. + 26. * x, 30. + 26. * (18. - y)]
}

fn draw_rooms(svg: &mut String, graph: &PortalGraph) {
    for (outline, name) in OUTLINES.iter().zip(&graph.cells) {
        let corners = outline.iter().map(|&corner| {
            let [x, y] = place(corner);
            format!("{x:.0},{y:.0}")
        });
        let corners = corners.collect::<Vec<_>>().join(" ");
        line(
            svg,
            format_args!(
                r##"<polygon points="{corners}" fill="#ffffff" stroke="{WALL}" stroke-width="5" stroke-linejoin="round"/>"##
            ),
        );
        let middle = |i: usize| outline.iter().map(|c| c[i]).sum::<f64>() / outline.len() as f64;
        let [x, y] = place([middle(0), middle(1)]);
        line(
            svg,
            format_args!(
                r##"<text x="{x:.0}" y="{y:.0}" fill="#57606a" text-anchor="middle">{name}</text>"##
            ),
        );
    }
    for portal in &graph.portals {
        let corners = graph.corners(portal).map(|corner| {
            let [x, y, _] = corner.coordinates();
            place([float(&x), float(&y)])
        });
        let corners: Vec<[f64; 2]> = corners.collect();
        let high = graph.vertices[portal.vertices[0] as usize].numerators()[2] > 0.into();
        let (from, to) = (corners[0], corners[2]);
        let color = if high { "#54aeff" } else { "#ffffff" };
        segment(svg, from, to, color, 7., "");
    }
}

fn draw_sights(svg: &mut String, sights: &[Vec<Sight>]) {
    for (a, row) in sights.iter().enumerate() {
        for (b, sight) in row.iter().enumerate().skip(a + 1) {
            let (points, color, dashes) = match sight {
                Sight::Open { line, doors } if *doors > 1 => (line, OPEN, ""),
                Sight::Grazing { line } => (line, GRAZING, r#" stroke-dasharray="6 4""#),
                Sight::Open { .. } | Sight::Blocked => continue,
            };
            let at =
                |t: f64| place([0, 1].map(|i| points[0][i] + t * (points[1][i] - points[0][i])));
            // From the middle of its way through the first room to the middle of the last.
            let ends = [OUTLINES[a], OUTLINES[b]].map(|outline| span(*points, outline));
            let [first, last] = ends.map(|[enter, leave]| at((enter + leave) / 2.));
            segment(svg, first, last, color, 1.5, dashes);
            for [x, y] in [first, last] {
                line(
                    svg,
                    format_args!(r##"<circle cx="{x:.1}" cy="{y:.1}" r="3" fill="{color}"/>"##),
                );
            }
        }
    }
}

fn draw_table(svg: &mut String, graph: &PortalGraph, sights: &[Vec<Sight>]) {
    let (left, top, size) = (710., 130., 24.);
    let mut counts = [0; 3];
    for (a, name) in graph.cells.iter().enumerate() {
        let [x, y] = [left + size * a as f64, top + size * a as f64];
        line(
            svg,
            format_args!(
                r##"<text x="{:.0}" y="{:.0}" text-anchor="end">{name}</text>"##,
                left - 8.,
                y + 16.
            ),
        );
        line(
            svg,
            format_args!(
                r##"<text transform="translate({:.0} {:.0}) rotate(-60)">{name}</text>"##,
                x + 14.,
                top - 8.
            ),
        );
        for (b, sight) in sights[a].iter().enumerate() {
            let kind = match sight {
                _ if a == b => 0,
                Sight::Open { .. } => 0,
                Sight::Grazing { .. } => 1,
                Sight::Blocked => 2,
            };
            counts[kind] += usize::from(a < b);
            let color = [OPEN, GRAZING, BLOCKED][kind];
            line(
                svg,
                format_args!(
                    r##"<rect x="{:.0}" y="{:.0}" width="22" height="22" fill="{color}"/>"##,
                    left + size * b as f64 + 1.,
                    y + 1.
                ),
            );
        }
    }
    let [open, grazing, blocked] = counts;
    let legend = [
        (OPEN, format!("open: {open} pairs, each with a sightline")),
        (GRAZING, format!("grazing: {grazing}, lines only touch")),
        (BLOCKED, format!("blocked: {blocked}")),
        ("#54aeff", "window under the ceiling".to_owned()),
    ];
    for (row, (color, text)) in legend.iter().enumerate() {
        let y = top + size * (10. + row as f64);
        line(
            svg,
            format_args!(r##"<rect x="612" y="{y:.0}" width="14" height="14" fill="{color}"/>"##),
        );
        line(svg, format_args!(r##"<text x="634" y="{:.0}">{text}</text>"##, y + 12.));
    }
}

fn segment(
    svg: &mut String,
    [x1, y1]: [f64; 2],
    [x2, y2]: [f64; 2],
    color: &str,
    width: f64,
    more: &str,
) {
    line(
        svg,
        format_args!(
            r##"<line x1="{x1:.1}" y1="{y1:.1}" x2="{x2:.1}" y2="{y2:.1}" stroke="{color}" stroke-width="{width}"{more}/>"##
        ),
    );
}

fn line(svg: &mut String, text: std::fmt::Arguments) {
    writeln!(svg, "{text}").expect("a string takes any text");
}

/// The picture.
fn picture() -> String {
    let graph = read_graph("gallery_nine_rooms.json", SCENE.as_bytes()).expect("a valid scene");
    let sights = all_sights(&graph);
    let mut svg = String::from(concat!(
        r##"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 960 580" width="960" height="580" "##,
        r##"font-family="sans-serif" font-size="13" fill="#24292f">"##,
        "\n",
        r##"<rect width="960" height="580" fill="#f6f8fa"/>"##,
        "\n",
    ));
    draw_rooms(&mut svg, &graph);
    draw_sights(&mut svg, &sights);
    draw_table(&mut svg, &graph, &sights);
    svg.push_str("</svg>\n");
    svg
}

fn main() {
    print!("{}", picture());
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_picture_is_up_to_date() {
        assert_eq!(picture(), include_str!("../docs/picture.svg"), "run the example again");
    }

    #[test]
    fn every_portal_lies_on_the_outlines_of_both_its_rooms() {
        let graph = read_graph("gallery", SCENE.as_bytes()).unwrap();
        let on_edge = |outline: &[[f64; 2]], [x, y]: [f64; 2]| {
            (0..outline.len()).any(|i| {
                let ([ax, ay], [bx, by]) = (outline[i], outline[(i + 1) % outline.len()]);
                // Doors lie on walls along x or y, whose outlines are whole numbers.
                (ax == bx && x == ax && (y - ay) * (y - by) <= 0.)
                    || (ay == by && y == ay && (x - ax) * (x - bx) <= 0.)
            })
        };
        for portal in &graph.portals {
            for corner in graph.corners(portal) {
                let [x, y, _] = corner.coordinates();
                let point = [float(&x), float(&y)];
                for room in [portal.from, portal.to] {
                    let name = &graph.cells[room.0 as usize];
                    assert!(on_edge(OUTLINES[room.0 as usize], point), "{name} {point:?}");
                }
            }
        }
    }
}
