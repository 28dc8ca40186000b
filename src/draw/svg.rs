//! The few elements of SVG that the pictures are made of.
//!
//! A writer of our own: six elements and one way to write a number, fewer lines than it takes to
//! bend a general writer to the same bytes everywhere.

use std::fmt::Write;

/// A place in a picture: units to the right and downwards from the upper left corner.
pub type Place = [f64; 2];

/// Elements of a picture, as text.
#[derive(Clone, Debug, Default)]
pub struct Svg {
    body: String,
}

/// Where a line of text within a path ends, at the next part.
const COLUMNS: usize = 72;

/// Attributes of a group, in the order in which they are written.
pub type Style<'a> = [(&'a str, &'a str)];

impl Svg {
    /// Elements that share a style; nothing is written where there is none.
    pub fn group(&mut self, style: &Style, fill: impl FnOnce(&mut Svg)) {
        let mut inside = Svg::default();
        fill(&mut inside);
        if inside.body.is_empty() {
            return;
        }
        self.body.push_str("<g");
        for (name, value) in style {
            self.put(format_args!(" {name}=\"{value}\""));
        }
        self.put(format_args!(">\n{}</g>\n", inside.body));
    }

    /// Closed outlines, as one element.
    pub fn outlines<'a>(&mut self, outlines: impl IntoIterator<Item = &'a [Place]>) {
        self.path(outlines, "Z");
    }

    /// Open lines, as one element.
    pub fn lines<'a>(&mut self, lines: impl IntoIterator<Item = &'a [Place]>) {
        self.path(lines, "");
    }

    /// One element for all parts, in lines of text that can be read; those of one point are nothing
    /// to draw.
    fn path<'a>(&mut self, parts: impl IntoIterator<Item = &'a [Place]>, end: &str) {
        let (mut data, mut line) = (String::new(), 0);
        for part in parts.into_iter().filter(|part| part.len() > 1) {
            if data.len() - line > COLUMNS {
                data.push('\n');
                line = data.len();
            }
            for (index, &[x, y]) in part.iter().enumerate() {
                data.push(if index == 0 { 'M' } else { 'L' });
                data.push_str(&number(x));
                data.push(' ');
                data.push_str(&number(y));
            }
            data.push_str(end);
        }
        if !data.is_empty() {
            self.put(format_args!("<path d=\"{data}\"/>\n"));
        }
    }

    /// A rectangle, by its upper left corner and its size.
    pub fn rectangle(&mut self, [x, y]: Place, [width, height]: [f64; 2]) {
        let [x, y, width, height] = [x, y, width, height].map(number);
        self.put(format_args!(
            "<rect x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\"/>\n"
        ));
    }

    /// A circle.
    pub fn circle(&mut self, [x, y]: Place, radius: f64) {
        let [x, y, radius] = [x, y, radius].map(number);
        self.put(format_args!("<circle cx=\"{x}\" cy=\"{y}\" r=\"{radius}\"/>\n"));
    }

    /// A line of text, where its baseline begins, or has its middle if the group's style says so.
    pub fn text(&mut self, [x, y]: Place, text: &str) {
        let [x, y] = [x, y].map(number);
        self.put(format_args!("<text x=\"{x}\" y=\"{y}\">{}</text>\n", escaped(text)));
    }

    /// The picture: all elements on white paper of this size.
    pub fn finish(self, width: f64, height: f64, about: &str) -> String {
        let [width, height] = [width, height].map(number);
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" \
             width=\"{width}\" height=\"{height}\" font-family=\"sans-serif\">\n\
             <title>{}</title>\n\
             <rect width=\"{width}\" height=\"{height}\" fill=\"#ffffff\"/>\n{}</svg>\n",
            escaped(about),
            self.body
        )
    }

    fn put(&mut self, text: std::fmt::Arguments) {
        self.body.write_fmt(text).expect("a string takes any text");
    }
}

/// A number to two decimals, the shortest way.
///
/// Half a hundredth is rounded away from zero; what no picture reaches is cut off.
pub fn number(value: f64) -> String {
    let hundredths = (value * 100.0).round() as i64;
    let (whole, part) = (hundredths.unsigned_abs() / 100, hundredths.unsigned_abs() % 100);
    let sign = if hundredths < 0 { "-" } else { "" };
    match part {
        0 => format!("{sign}{whole}"),
        part if part % 10 == 0 => format!("{sign}{whole}.{}", part / 10),
        part => format!("{sign}{whole}.{part:02}"),
    }
}

/// Text as it stands in XML, characters that XML has no place for left out.
fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            c if c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}') => escaped.push(' '),
            c => escaped.push(c),
        }
    }
    escaped
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short_and_have_no_negative_zero() {
        let shown: Vec<String> =
            [0.0, -0.001, 1.5, 2.005, -4.56789, 12.3, 7.0, f64::NAN].map(number).into();
        assert_eq!(shown, ["0", "0", "1.5", "2.01", "-4.57", "12.3", "7", "0"]);
    }

    #[test]
    fn empty_groups_and_single_points_leave_nothing_behind() {
        let mut svg = Svg::default();
        svg.group(&[("fill", "none")], |svg| svg.lines([[[1.0, 2.0]].as_slice()]));
        assert!(svg.body.is_empty());
    }

    #[test]
    fn text_of_any_file_is_text_of_xml() {
        let mut svg = Svg::default();
        svg.text([0.0, 0.0], "a<b> & \"c\"\u{1}");
        let expected = "<text x=\"0\" y=\"0\">a&lt;b&gt; &amp; &quot;c&quot; </text>\n";
        assert_eq!(svg.body, expected);
    }
}
