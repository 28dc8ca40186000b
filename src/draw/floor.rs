//! A floorplan or a graph of the plane in the places of a picture: what every picture is drawn
//! upon.

use super::frame::{Frame, box_around, widened};
use super::palette;
use super::sheet::{Pen, Sample, Sheet, SheetOptions, text_width};
use super::svg::{Place, number};
use crate::num::Rational;
use crate::portal::plan::PlanCells;
use crate::scene::CellId;
use crate::scene::plan::{Plan, PlanGraph};

/// What a picture shows of a plan, by places.
///
/// Invariant: as many outlines and middles as cells; an outline is empty where the input states
/// cells without their shape.
#[derive(Clone, Debug)]
pub struct Floor {
    /// The faces: opaque segments.
    pub faces: Vec<[Place; 2]>,
    /// Segments that split cells and hide nothing.
    pub hints: Vec<[Place; 2]>,
    /// What the legend calls them.
    pub hint_name: &'static str,
    /// The names of the cells.
    pub names: Vec<String>,
    /// The cells' corners.
    pub outlines: Vec<Vec<Place>>,
    /// A place inside each cell.
    pub middles: Vec<Place>,
    /// The portals' ends.
    pub portals: Vec<[Place; 2]>,
    /// The cells on both sides of each portal.
    pub sides: Vec<[CellId; 2]>,
    /// Whether there is a box of which not all is cells.
    pub has_outside: bool,
}

/// Widths and sizes that suit a floor's cells, in units of the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sizes {
    /// Of faces.
    pub face: f64,
    /// Of portals and of lines that are looked at.
    pub line: f64,
    /// Of edges and lines of which there are many.
    pub hair: f64,
    /// The radius of a node of a graph.
    pub node: f64,
    /// The size of the font of names in cells.
    pub font: f64,
}

impl Floor {
    /// A sheet for a divided plan, and the plan on it.
    pub fn of_plan(plan: &Plan, cells: &PlanCells, options: &SheetOptions) -> (Sheet, Floor) {
        let corner = |i: usize| plan.points.get(plan.bounds[i]).coordinates();
        let sheet = Sheet::new([corner(0), corner(2)], options);
        let places = sheet.frame.place_all(&plan.points);
        let mut floor = Floor::of_cells(&cells.graph, &sheet.frame);
        for segment in &plan.segments {
            let ends = segment.ends.map(|end| places[end as usize]);
            if segment.is_opaque { &mut floor.faces } else { &mut floor.hints }.push(ends);
        }
        floor.has_outside = cells.cell_of_leaf.iter().any(Option::is_none);
        (sheet, floor)
    }

    /// A sheet for a graph that states no more than portals, and the graph on it.
    pub fn of_graph(graph: &PlanGraph, options: &SheetOptions) -> (Sheet, Floor) {
        let ends = graph.portals.iter().flat_map(|portal| [portal.left, portal.right]);
        let corners = graph.polygons.iter().flatten().copied();
        let points = ends.chain(corners).map(|number| graph.points.get(number));
        let unit = || [Rational::from_integer(0.into()), Rational::from_integer(1.into())];
        let bounds = box_around(points).unwrap_or_else(|| [unit(), unit()]);
        let sheet = Sheet::new(widened(bounds), options);
        let floor = Floor::of_cells(graph, &sheet.frame);
        (sheet, floor)
    }

    fn of_cells(graph: &PlanGraph, frame: &Frame) -> Floor {
        let places = frame.place_all(&graph.points);
        let place = |&number: &u32| places[number as usize];
        let mut outlines: Vec<Vec<Place>> =
            graph.polygons.iter().map(|polygon| polygon.iter().map(place).collect()).collect();
        outlines.resize(graph.cells.len(), Vec::new());
        let portals: Vec<[Place; 2]> = graph
            .portals
            .iter()
            .map(|portal| [portal.left, portal.right].map(|e| place(&e)))
            .collect();
        let sides: Vec<[CellId; 2]> =
            graph.portals.iter().map(|portal| [portal.from, portal.to]).collect();
        let mut middles: Vec<Place> = outlines.iter().map(|outline| centroid(outline)).collect();
        for (cell, middle) in middles.iter_mut().enumerate() {
            if outlines[cell].is_empty() {
                let beside = |sides: &[CellId; 2]| sides.iter().any(|side| side.0 as usize == cell);
                let own = portals.iter().zip(&sides).filter(|(_, sides)| beside(sides));
                *middle = mean(&own.map(|(ends, _)| mean(ends)).collect::<Vec<_>>());
            }
        }
        Floor {
            faces: Vec::new(),
            hints: Vec::new(),
            hint_name: "hint",
            names: graph.cells.clone(),
            outlines,
            middles,
            portals,
            sides,
            has_outside: false,
        }
    }

    /// Sizes for this floor on this sheet.
    pub fn sizes(&self, sheet: &Sheet) -> Sizes {
        let [[x0, y0], [x1, y1]] = sheet.drawing();
        let cells = self.outlines.len().max(1) as f64;
        let typical = ((x1 - x0) * (y1 - y0) / cells).sqrt();
        let width = sheet.width();
        let unit = (typical / 40.0).clamp(width / 900.0, width / 270.0);
        Sizes {
            face: unit,
            line: (0.6 * unit).max(width / 1000.0),
            hair: (0.3 * unit).max(width / 2400.0),
            node: (typical / 14.0).clamp(width / 600.0, width / 60.0),
            font: (typical / 7.0).clamp(0.0, sheet.font()),
        }
    }

    /// The name of a cell.
    pub fn name(&self, cell: CellId) -> &str {
        &self.names[cell.0 as usize]
    }

    /// The corners of a cell.
    pub fn outline(&self, cell: CellId) -> &[Place] {
        &self.outlines[cell.0 as usize]
    }

    /// The lowest layer: the box and the cells, each in the colour that `colour` gives it.
    pub fn draw_cells(&self, sheet: &mut Sheet, colour: impl Fn(CellId) -> &'static str) {
        let sizes = self.sizes(sheet);
        if self.has_outside {
            let [low, high] = sheet.drawing();
            sheet.svg.group(&[("fill", palette::OUTSIDE)], |svg| {
                svg.rectangle(low, [high[0] - low[0], high[1] - low[1]]);
            });
            sheet.explain(Sample::Area(palette::OUTSIDE), "no cell");
        }
        let mut colours: Vec<&'static str> = Vec::new();
        let all: Vec<&'static str> = self.cells().map(&colour).collect();
        all.iter().for_each(|one| {
            if !colours.contains(one) {
                colours.push(one);
            }
        });
        let width = number(sizes.hair);
        for colour in colours {
            let style = [("fill", colour), ("stroke", palette::EDGE), ("stroke-width", &width)];
            sheet.svg.group(&style, |svg| {
                let own = self.outlines.iter().zip(&all).filter(|(_, own)| **own == colour);
                svg.outlines(own.map(|(outline, _)| outline.as_slice()));
            });
        }
    }

    /// The faces, over whatever is there.
    pub fn draw_faces(&self, sheet: &mut Sheet) {
        let sizes = self.sizes(sheet);
        sheet.draw_segments(Pen::round(palette::HINT, sizes.line), &self.hints, self.hint_name);
        sheet.draw_segments(Pen::round(palette::WALL, sizes.face), &self.faces, "face");
    }

    /// All portals.
    pub fn draw_portals(&self, sheet: &mut Sheet) {
        let width = self.sizes(sheet).line;
        sheet.draw_segments(Pen::round(palette::PORTAL, width), &self.portals, "portal");
    }

    /// Names of cells: each in the middle of its cell, if there is room for it, or so far below the
    /// place of a cell without a shape. `colour` is that of a name and of what it stands on.
    pub fn draw_names(
        &self,
        sheet: &mut Sheet,
        below: f64,
        colour: impl Fn(CellId) -> [&'static str; 2],
    ) {
        let font = self.sizes(sheet).font;
        if !self.has_names(sheet) {
            return;
        }
        let [size, halo] = [font, 0.3 * font].map(number);
        let mut names: Vec<([&'static str; 2], Place, &str)> = Vec::new();
        for cell in self.cells() {
            let (name, middle) = (self.name(cell), self.middles[cell.0 as usize]);
            let half = [text_width(name, font) / 2.0, font / 2.0];
            let outline = self.outline(cell);
            let [x, y] = middle;
            if outline.is_empty() {
                names.push((colour(cell), [x, y + below + 0.35 * font], name));
            } else if holds_box(outline, middle, half) {
                names.push((colour(cell), [x, y + 0.35 * font], name));
            }
        }
        names.sort_by_key(|(colours, _, _)| *colours);
        for same in names.chunk_by(|a, b| a.0 == b.0) {
            let [colour, under] = same[0].0;
            let style = [
                ("fill", colour),
                ("stroke", under),
                ("stroke-width", &halo),
                ("paint-order", "stroke"),
                ("font-size", &size),
                ("text-anchor", "middle"),
            ];
            sheet.svg.group(&style, |svg| {
                same.iter().for_each(|(_, place, name)| svg.text(*place, name));
            });
        }
    }

    /// Whether cells are large enough for names.
    pub fn has_names(&self, sheet: &Sheet) -> bool {
        self.sizes(sheet).font >= sheet.width() / 140.0
    }

    /// All cells.
    pub fn cells(&self) -> impl Iterator<Item = CellId> + use<> {
        (0..self.names.len() as u32).map(CellId)
    }
}

/// The mean of places; the corner of the picture for none.
pub fn mean(places: &[Place]) -> Place {
    let count = places.len().max(1) as f64;
    [0, 1].map(|axis| places.iter().map(|place| place[axis]).sum::<f64>() / count)
}

/// The centroid of a convex polygon's area; the mean of its corners where it is too thin to have
/// one in floats.
pub fn centroid(outline: &[Place]) -> Place {
    let middle = mean(outline);
    let (mut area, mut moment) = (0.0, [0.0; 2]);
    for (index, a) in outline.iter().enumerate() {
        let b = outline[(index + 1) % outline.len()];
        let [a, b] = [*a, b].map(|corner| [corner[0] - middle[0], corner[1] - middle[1]]);
        let twice = a[0] * b[1] - a[1] * b[0];
        area += twice;
        moment = [0, 1].map(|axis| moment[axis] + twice * (a[axis] + b[axis]));
    }
    let shift = moment.map(|m| m / (3.0 * area));
    if shift.iter().all(|s| s.is_finite())
        && holds(outline, [middle[0] + shift[0], middle[1] + shift[1]])
    {
        [middle[0] + shift[0], middle[1] + shift[1]]
    } else {
        middle
    }
}

/// Whether a place lies in a convex polygon, whichever way around that is.
pub fn holds(outline: &[Place], [x, y]: Place) -> bool {
    let (mut left, mut right) = (false, false);
    for (index, a) in outline.iter().enumerate() {
        let b = outline[(index + 1) % outline.len()];
        let turn = (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
        left |= turn > 0.0;
        right |= turn < 0.0;
    }
    !(left && right)
}

/// Whether a convex polygon holds a box around a place.
fn holds_box(outline: &[Place], [x, y]: Place, [w, h]: [f64; 2]) -> bool {
    [[x - w, y - h], [x + w, y - h], [x + w, y + h], [x - w, y + h]]
        .into_iter()
        .all(|corner| holds(outline, corner))
}
