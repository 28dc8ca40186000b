//! The picture of a visibility matrix: one square for each ordered pair of cells.

use super::palette::{EDGE, OUTSIDE, SIGHT, TEXT, VISIBLE};
use super::svg::{Place, Svg};

/// The width of the picture without its margins.
const SIDE: f64 = 720.0;

/// Room around the squares, the title above them.
const MARGIN: f64 = 24.0;

/// Draws the verdicts of all ordered pairs, row by row, as an SVG: open pairs blue, grazing ones
/// dark orange, those not open white, and undecided ones grey; row and column 0 are at the upper
/// left.
///
/// `rows` holds one code a pair as results do: 0 not open, 1 grazing, 2 open, 3 undecided. Linear
/// in the number of runs of equal verdicts within the rows.
pub fn draw_matrix(rows: &[Vec<u8>], title: &str) -> String {
    let size = SIDE / rows.len().max(1) as f64;
    let mut svg = Svg::default();
    let corner: Place = [MARGIN, 2.0 * MARGIN];
    for (fill, code) in [(VISIBLE, 2), (SIGHT, 1), (OUTSIDE, 3)] {
        svg.group(&[("fill", fill)], |svg| {
            for (y, row) in rows.iter().enumerate() {
                for (x, run) in runs(row, code) {
                    let place = [corner[0] + x as f64 * size, corner[1] + y as f64 * size];
                    svg.rectangle(place, [run as f64 * size, size]);
                }
            }
        });
    }
    svg.group(&[("fill", "none"), ("stroke", EDGE)], |svg| svg.rectangle(corner, [SIDE, SIDE]));
    svg.group(&[("fill", TEXT), ("font-size", "14")], |svg| {
        svg.text([MARGIN, 1.4 * MARGIN], title);
    });
    svg.finish(SIDE + 2.0 * MARGIN, SIDE + 3.0 * MARGIN, title)
}

/// Where the runs of a code begin, and their lengths.
fn runs(row: &[u8], code: u8) -> Vec<(usize, usize)> {
    let mut at = 0;
    let mut runs = Vec::new();
    for run in row.chunk_by(|a, b| a == b) {
        if run[0] == code {
            runs.push((at, run.len()));
        }
        at += run.len();
    }
    runs
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_are_drawn_as_one() {
        assert_eq!(runs(&[2, 2, 0, 2], 2), [(0, 2), (3, 1)]);
        let svg = draw_matrix(&[vec![2, 2, 0], vec![2, 2, 1], vec![0, 1, 2]], "three cells");
        assert_eq!(svg.matches("<rect").count(), 3 + 2 + 1 + 1);
        assert!(svg.contains("three cells"));
    }
}
