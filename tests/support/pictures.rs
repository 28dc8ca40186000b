//! Pictures, rendered, and where their text stands.

use resvg::{tiny_skia, usvg};
use stabline::draw::{Frame, Place};
use stabline::num::Rational;

/// The pixels of an SVG, without its text: there are no fonts.
pub struct Picture {
    pixels: tiny_skia::Pixmap,
}

impl Picture {
    /// Renders a picture, a pixel for a unit.
    pub fn render(svg: &str) -> Picture {
        let tree = usvg::Tree::from_str(svg, &usvg::Options::default()).expect("an SVG");
        let size = tree.size().to_int_size();
        let mut pixels = tiny_skia::Pixmap::new(size.width(), size.height()).expect("an area");
        resvg::render(&tree, tiny_skia::Transform::default(), &mut pixels.as_mut());
        Picture { pixels }
    }

    /// The colour of the pixel at a place, as `#rrggbb`.
    pub fn at(&self, [x, y]: Place) -> String {
        let pixel = self.pixels.pixel(x as u32, y as u32).expect("a place on the picture");
        let pixel = pixel.demultiply();
        format!("#{:02x}{:02x}{:02x}", pixel.red(), pixel.green(), pixel.blue())
    }

    /// The colour of the pixel at a point of the plane, given in halves of grid units.
    pub fn at_halves(&self, frame: &Frame, point: [i64; 2]) -> String {
        self.at(place(frame, point))
    }

    /// The same, if all pixels around it have it too.
    pub fn around_halves(&self, frame: &Frame, point: [i64; 2]) -> Option<String> {
        let [x, y] = place(frame, point);
        let colour = self.at([x, y]);
        let near = [-2.0, 0.0, 2.0].map(|dx| [-2.0, 0.0, 2.0].map(|dy| [x + dx, y + dy]));
        near.into_iter().flatten().all(|place| self.at(place) == colour).then_some(colour)
    }

    /// How many pixels have a colour.
    pub fn count(&self, colour: &str) -> usize {
        let (width, height) = (self.pixels.width(), self.pixels.height());
        let all = (0..width).flat_map(|x| (0..height).map(move |y| [f64::from(x), f64::from(y)]));
        all.filter(|&place| self.at(place) == colour).count()
    }

    /// Whether nothing is drawn on the outermost pixels.
    pub fn has_a_margin(&self) -> bool {
        let (width, height) = (self.pixels.width(), self.pixels.height());
        let rows = (0..width).flat_map(|x| [(x, 0), (x, height - 1)]);
        let columns = (0..height).flat_map(|y| [(0, y), (width - 1, y)]);
        rows.chain(columns).all(|(x, y)| self.at([f64::from(x), f64::from(y)]) == "#ffffff")
    }
}

fn place(frame: &Frame, halves: [i64; 2]) -> Place {
    frame.place(&halves.map(|c| Rational::new(c.into(), 2.into())))
}

/// A line of text: what it says, and the box that it will hardly leave.
#[derive(Debug)]
pub struct Label {
    pub text: String,
    pub low: Place,
    pub high: Place,
}

/// All text of a picture of ours: groups state the size, elements the place.
pub fn labels(svg: &str) -> Vec<Label> {
    let attribute = |line: &str, name: &str| -> Option<String> {
        let rest = line.split(&format!(" {name}=\"")).nth(1)?;
        rest.split('"').next().map(str::to_owned)
    };
    let (mut size, mut is_centred) = (0.0, false);
    let mut labels = Vec::new();
    for line in svg.lines() {
        if line.starts_with("<g") {
            size = attribute(line, "font-size").map_or(0.0, |size| size.parse().unwrap());
            is_centred = attribute(line, "text-anchor").is_some();
        }
        if !line.starts_with("<text") {
            continue;
        }
        let [x, y] = ["x", "y"].map(|name| attribute(line, name).unwrap().parse::<f64>().unwrap());
        let text = line.split(['<', '>']).nth(2).unwrap().to_owned();
        let width = 0.6 * size * text.chars().count() as f64;
        let left = if is_centred { x - width / 2.0 } else { x };
        labels.push(Label { text, low: [left, y - 0.75 * size], high: [left + width, y] });
    }
    labels
}

/// Asserts that all text lies on a picture and none over another.
pub fn assert_readable(svg: &str) {
    let size = svg.split("viewBox=\"0 0 ").nth(1).unwrap().split('"').next().unwrap();
    let size: Vec<f64> = size.split(' ').map(|side| side.parse().unwrap()).collect();
    let labels = labels(svg);
    assert!(!labels.is_empty(), "{svg}");
    for (index, one) in labels.iter().enumerate() {
        for axis in [0, 1] {
            assert!(one.low[axis] >= 0.0 && one.high[axis] <= size[axis], "{one:?} in {size:?}");
        }
        for other in &labels[..index] {
            let is_apart = |axis: usize| {
                one.high[axis] <= other.low[axis] || other.high[axis] <= one.low[axis]
            };
            assert!(is_apart(0) || is_apart(1), "{one:?} over {other:?}");
        }
    }
}
