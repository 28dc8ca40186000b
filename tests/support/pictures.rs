//! Pictures, rendered.

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

    /// The colour of the pixel at a point of the plane, given in grid units.
    pub fn at_point(&self, frame: &Frame, point: [i64; 2]) -> String {
        self.at(frame.place(&point.map(|c| Rational::from_integer(c.into()))))
    }

    /// Whether nothing is drawn on the outermost pixels.
    pub fn has_a_margin(&self) -> bool {
        let (width, height) = (self.pixels.width(), self.pixels.height());
        let rows = (0..width).flat_map(|x| [(x, 0), (x, height - 1)]);
        let columns = (0..height).flat_map(|y| [(0, y), (width - 1, y)]);
        rows.chain(columns).all(|(x, y)| self.at([f64::from(x), f64::from(y)]) == "#ffffff")
    }
}
