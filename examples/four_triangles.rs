//! The lines tangent to four triangles, counted exactly at several precisions of their input.
//!
//! Brönnimann, Devillers, Lazard and Sottile gave four disjoint triangles with 62 common tangent
//! lines. The configuration is so close to degenerate that rounding its coordinates changes the
//! count. For each choice of one edge a triangle (81 of them) this program takes the lines that
//! meet the four edges' lines and keeps those that pass through all four closed edges; everything
//! is decided over Q(√d).
//!
//! Run with `cargo run --release --example four_triangles`.

use stabline::geom::BigLine;
use stabline::num::{Int, Rational, parse_decimal};
use stabline::stab::transversals::{meets_segment, transversals};

type Point = [Rational; 3];
type Triangle = [Point; 3];

/// The coordinates with 26 decimals.
const TRIANGLES: [[[&str; 3]; 3]; 4] = [
    [
        ["-10.5", "1", "-10.5"],
        [".5628568345479573470378601", "1", ".5628568345479573470378601"],
        [
            ".56285683454726874605620706",
            ".99999999999822994290647247",
            ".56285683454726874605620706",
        ],
    ],
    [
        ["-10.5", "-1", "10.5"],
        ["1.394218989475", "-1", "-1.394218989475"],
        [
            "1.3942406911811439954597161",
            "-1.0000237884694881275439271",
            "-1.3942406911811439954597161",
        ],
    ],
    [
        ["-9.5", "-9.5", ".25"],
        [".685825", ".685825", ".25"],
        [
            ".69121730616063647303519136",
            ".69121730616063647303519136",
            ".26069756890079842876805653",
        ],
    ],
    [
        ["9.5", "0", "0"],
        ["-.51", "0", "0"],
        ["-1.0873912730501133759642956", "0", "-.51645811088049333541289247"],
    ],
];

/// The triangles with every coordinate passed through `read`.
fn triangles(read: impl Fn(&str) -> Rational) -> [Triangle; 4] {
    TRIANGLES.map(|triangle| triangle.map(|point| point.map(&read)))
}

/// Cut off after this many decimals.
fn cut_off(text: &str, decimals: u32) -> Rational {
    let scale = Rational::from(Int::from(10).pow(decimals));
    (exact(text) * &scale).trunc() / scale
}

/// The nearest double, which is a rational number too.
fn nearest_double(text: &str) -> Rational {
    let double: f64 = text.parse().expect("a decimal");
    Rational::from_float(double).expect("a finite number")
}

fn exact(text: &str) -> Rational {
    parse_decimal(text).expect("a decimal")
}

/// How many lines pass through one closed edge of each triangle, summed over the 81 choices.
fn count(triangles: &[Triangle; 4]) -> usize {
    let mut count = 0;
    for choice in 0..81usize {
        let edges = [0, 1, 2, 3].map(|i| {
            let corner = choice / 3usize.pow(i) % 3;
            let triangle = &triangles[i as usize];
            (&triangle[corner], &triangle[(corner + 1) % 3])
        });
        let lines = edges.map(|(p, q)| BigLine::through_rational(p, q).expect("two corners"));
        let result = transversals(&lines);
        assert!(result.families.is_empty(), "the edges are in general position");
        let through_all = result
            .isolated
            .iter()
            .filter(|line| edges.iter().all(|(p, q)| meets_segment(line, p, q)));
        count += through_all.count();
    }
    count
}

/// What the coordinates are, and how many tangents they have.
fn counts() -> Vec<(String, usize)> {
    let mut counts = Vec::new();
    for decimals in [26, 25, 24, 20, 16, 12] {
        let shorter = triangles(|text| cut_off(text, decimals));
        counts.push((format!("{decimals} decimals"), count(&shorter)));
    }
    counts.push(("nearest doubles".to_owned(), count(&triangles(nearest_double))));
    counts
}

fn main() {
    println!("coordinates       lines tangent to four triangles");
    for (coordinates, count) in counts() {
        println!("{coordinates:<16}  {count}");
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_counts_are_the_published_ones() {
        let counts: Vec<usize> = super::counts().into_iter().map(|(_, count)| count).collect();
        assert_eq!(counts, [62, 60, 60, 60, 58, 58, 60]);
    }
}
