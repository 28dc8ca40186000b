//! A sheet of paper: a title, a drawing, and a legend below it.

use super::frame::Frame;
use super::palette;
use super::svg::{Place, Svg, number};
use crate::num::Rational;

/// What a picture is told besides its content.
#[derive(Clone, Debug, PartialEq)]
pub struct SheetOptions {
    /// The line above the drawing.
    pub title: String,
    /// The width of the picture, in its units (pixels, where it is shown as it is).
    pub width: u32,
}

/// The least width, below which the legend is no more to be read.
pub const LEAST_WIDTH: u32 = 240;

/// The width unless stated.
pub const DEFAULT_WIDTH: u32 = 960;

/// How an entry of the legend is drawn before its text.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sample {
    /// A filled area.
    Area(&'static str),
    /// A line.
    Line(Pen),
    /// A dot.
    Dot(&'static str),
}

/// How lines are drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pen {
    /// Their colour.
    pub colour: &'static str,
    /// Their width, in units of the picture.
    pub width: f64,
    /// How they end and whether they are broken.
    pub tip: Tip,
}

/// The ends of lines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tip {
    /// Half a circle beyond the end.
    Round,
    /// At the end.
    Flat,
    /// At the end, and the line is broken into dashes.
    Dashed,
}

impl Pen {
    /// A pen whose lines end round.
    pub fn round(colour: &'static str, width: f64) -> Pen {
        Pen { colour, width, tip: Tip::Round }
    }

    /// A pen for broken lines.
    pub fn dashed(colour: &'static str, width: f64) -> Pen {
        Pen { colour, width, tip: Tip::Dashed }
    }

    /// Draws lines of two or more places.
    pub fn draw<'a>(self, svg: &mut Svg, lines: impl IntoIterator<Item = &'a [Place]>) {
        let (width, dashes) = (number(self.width), dashes(self.width));
        let mut style =
            vec![("fill", "none"), ("stroke", self.colour), ("stroke-width", width.as_str())];
        match self.tip {
            Tip::Round => style.extend([("stroke-linecap", "round"), ("stroke-linejoin", "round")]),
            Tip::Flat => {}
            Tip::Dashed => style.push(("stroke-dasharray", &dashes)),
        }
        svg.group(&style, |svg| svg.lines(lines));
    }
}

/// Dashes that suit a width.
fn dashes(width: f64) -> String {
    format!("{} {}", number(3.0 * width), number(2.0 * width))
}

/// A sheet that is being drawn on.
#[derive(Clone, Debug)]
pub struct Sheet {
    /// Where coordinates stand on it.
    pub frame: Frame,
    /// What is drawn, later things over earlier ones.
    pub svg: Svg,
    width: f64,
    margin: f64,
    title: String,
    legend: Vec<(Sample, String)>,
}

/// The width of a character, in heights of the font: more than that of most sans-serif fonts.
const CHARACTER: f64 = 0.6;

/// A width that text of a font's size will hardly exceed.
pub fn text_width(text: &str, font: f64) -> f64 {
    text.chars().count() as f64 * font * CHARACTER
}

impl Sheet {
    /// A sheet for what lies in a box of the plane.
    pub fn new(bounds: [[Rational; 2]; 2], options: &SheetOptions) -> Sheet {
        let width = f64::from(options.width.max(LEAST_WIDTH));
        let margin = width / 40.0;
        let top = margin + 1.9 * font(width);
        let room = [width - 2.0 * margin, 1.25 * width];
        let fitted = Frame::fit(bounds.clone(), [margin, top], room);
        // A drawing that is lower than the room ends where it ends.
        let [low, high] = fitted.corners();
        let frame = Frame::fit(bounds, [margin, top], [room[0], high[1] - low[1]]);
        let title = options.title.clone();
        Sheet { frame, svg: Svg::default(), width, margin, title, legend: Vec::new() }
    }

    /// An entry of the legend; those told twice stand there once.
    pub fn explain(&mut self, sample: Sample, text: impl Into<String>) {
        let entry = (sample, text.into());
        if !self.legend.contains(&entry) {
            self.legend.push(entry);
        }
    }

    /// Draws segments, and explains them if there are any.
    pub fn draw_segments(&mut self, pen: Pen, segments: &[[Place; 2]], text: &str) {
        pen.draw(&mut self.svg, segments.iter().map(<[Place; 2]>::as_slice));
        if !segments.is_empty() {
            self.explain(Sample::Line(pen), text);
        }
    }

    /// The width of the picture.
    pub fn width(&self) -> f64 {
        self.width
    }

    /// The size of the legend's font.
    pub fn font(&self) -> f64 {
        font(self.width)
    }

    /// The area of the drawing: its upper left and its lower right corner.
    pub fn drawing(&self) -> [Place; 2] {
        self.frame.corners()
    }

    /// The finished picture.
    pub fn finish(mut self) -> String {
        let font = self.font();
        let size = number(font);
        let room = self.width - 2.0 * self.margin;
        let title = shortened(&self.title, room, 1.15 * font);
        let base = self.margin + font;
        let title_size = number(1.15 * font);
        self.svg.group(&[("fill", palette::TEXT), ("font-size", &title_size)], |svg| {
            svg.text([self.margin, base], &title);
        });
        let bottom = self.frame.corners()[1][1] + self.margin;
        let (placed, height) = self.place_legend(bottom);
        for (entry, place) in self.legend.iter().zip(&placed) {
            draw_sample(&mut self.svg, entry.0, *place, font);
        }
        self.svg.group(&[("fill", palette::TEXT), ("font-size", &size)], |svg| {
            for ((_, text), [x, y]) in self.legend.iter().zip(&placed) {
                let text = shortened(text, self.width - self.margin - x - 2.2 * font, font);
                svg.text([x + 2.2 * font, y + 0.85 * font], &text);
            }
        });
        self.svg.finish(self.width, height + self.margin / 2.0, &self.title)
    }

    /// The upper left corner of each entry, row by row, and where the last row ends.
    fn place_legend(&self, top: f64) -> (Vec<Place>, f64) {
        let font = self.font();
        let end = self.width - self.margin;
        let [mut x, mut y] = [self.margin, top];
        let mut placed = Vec::new();
        for (_, text) in &self.legend {
            let width = 3.4 * font + text_width(text, font);
            if x + width > end && x > self.margin {
                [x, y] = [self.margin, y + 1.7 * font];
            }
            placed.push([x, y]);
            x += width;
        }
        (placed, y + 1.4 * font)
    }
}

/// The size of the legend's font on a sheet of this width.
fn font(width: f64) -> f64 {
    (width / 64.0).clamp(9.0, 30.0)
}

/// The text, or as much of it as there is room for.
fn shortened(text: &str, room: f64, font: f64) -> String {
    if text_width(text, font) <= room {
        return text.to_owned();
    }
    let count = (room / font / CHARACTER) as usize;
    let kept: String = text.chars().take(count.saturating_sub(1)).collect();
    format!("{kept}…")
}

/// A sample of a line, an area or a dot, in a field of two by one heights of the font.
fn draw_sample(svg: &mut Svg, sample: Sample, [x, y]: Place, font: f64) {
    let middle = y + font / 2.0;
    match sample {
        Sample::Area(colour) => {
            svg.group(&[("fill", colour), ("stroke", palette::EDGE)], |svg| {
                svg.rectangle([x, y], [1.6 * font, font]);
            });
        }
        Sample::Line(pen) => {
            pen.draw(svg, [[[x, middle], [x + 1.6 * font, middle]].as_slice()]);
        }
        Sample::Dot(colour) => {
            svg.group(&[("fill", colour)], |svg| svg.circle([x + 0.8 * font, middle], 0.4 * font));
        }
    }
}
