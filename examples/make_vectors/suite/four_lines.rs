//! Four lines. Three are rulings x = a, z = a y of the saddle z = x y, for a = 0, 1, 2; what meets
//! them is a ruling y = b, z = b x of the other family. So the lines that meet a fourth one too are
//! where it meets the saddle: a quadratic equation.

use super::book::Book;
use super::line_proof;
use super::number::{Point, Q, moved, power, q, ratio, tenth, values};
use serde_json::{Value, json};
use stabline::formats::lines::LinesFile;
use stabline::report::TransversalsReport;
use stabline::stab::transversals::transversals;
use stabline::vectors::LineCount::{self, Family, None, One, Two};
use stabline::vectors::{Kind, Test, VectorsFile};

/// A line by two points.
pub type Line = [Point; 2];

/// All cases.
pub fn file() -> VectorsFile {
    let mut book = Book::new("transversals", "How many lines at a finite place meet four lines?");
    near_double(&mut book);
    on_grid(&mut book);
    special(&mut book);
    book.finish()
}

fn ruling(a: i64) -> Line {
    [vec![q(a), q(0), q(0)], vec![q(a), q(1), q(a)]]
}

fn on_saddle(fourth: Line) -> Vec<Line> {
    vec![ruling(0), ruling(1), ruling(2), fourth]
}

/// A line and the number of rulings that meet it.
fn count(p: &[Q; 3], d: &[Q; 3]) -> LineCount {
    let zero = q(0);
    let a = -(&d[0] * &d[1]);
    let b = &d[2] - &p[0] * &d[1] - &p[1] * &d[0];
    let c = &p[2] - &p[0] * &p[1];
    match (d[0] == zero, d[1] == zero) {
        (false, false) => match (&b * &b - &a * &c * q(4)).cmp(&zero) {
            std::cmp::Ordering::Less => None,
            std::cmp::Ordering::Equal => One,
            std::cmp::Ordering::Greater => Two,
        },
        // One where it meets the saddle, and one parallel to it.
        (false, true) if b != zero => Two,
        (false, true) => One,
        // The other is at infinity.
        (true, _) if b != zero => One,
        (true, _) if c != zero => None,
        (true, _) => Family,
    }
}

/// Lines that touch the saddle, and those a little off.
fn near_double(book: &mut Book) {
    book.group(Kind::Transversals, "A fourth line that touches the saddle, but for one unit.");
    for (x, y, dx, dy) in
        [(0, 0, 1, 1), (3, 5, 1, -1), (2, 7, 3, 2), (-4, 9, -2, 5), (50, 60, 7, 11)]
    {
        for (unit, name) in
            [(q(1), "1"), (tenth(1), "0.1"), (tenth(6), "1e-6"), (tenth(20), "1e-20")]
        {
            for sign in [1, 0, -1] {
                let height = q(x * y) + &unit * q(sign);
                let p = [q(x), q(y), height];
                let d = [q(dx), q(dy), q(x * dy + y * dx)];
                let how = match sign {
                    0 => "in which it touches: one double line".to_owned(),
                    1 => format!("but {name} higher"),
                    _ => format!("but {name} lower"),
                };
                let comment =
                    format!("The fourth line lies in the tangent plane of ({x}, {y}), {how}.");
                let flags: &[&str] = if sign == 0 {
                    &["DoubleTransversal", "NearRegulus"]
                } else {
                    &["NearRegulus", "OneUnit"]
                };
                add(book, &comment, flags, &p, &d);
            }
        }
    }
}

/// All small directions: rational and irrational roots, roots at infinity, families.
fn on_grid(book: &mut Book) {
    book.group(Kind::Transversals, "Lines of small coordinates against the saddle.");
    for (index, [px, py, pz]) in
        [[0, 0, 0], [0, 0, 1], [1, 2, 2], [1, 1, 3], [3, 0, -2]].into_iter().enumerate()
    {
        for d in [
            [1, 1, 0],
            [1, -1, 0],
            [1, 0, 0],
            [0, 1, 0],
            [0, 0, 1],
            [1, 2, 3],
            [0, 1, 1],
            [1, 0, 2],
            [2, 1, -3],
            [0, 1, 3],
        ] {
            if (px == 0 || px == 1) && d[0] == 0 && d[2] == px * d[1] && pz == px * py {
                // The same line as one of the three: a family in any case.
                continue;
            }
            let p = [px, py, pz].map(q);
            let comment =
                format!("A line through ({px}, {py}, {pz}) along ({}, {}, {}).", d[0], d[1], d[2]);
            let flags: &[&str] = match index {
                _ if d[0] * d[1] == 0 => &["AtInfinity"],
                _ => &["Plain"],
            };
            add(book, &comment, flags, &p, &d.map(q));
        }
    }
}

fn add(book: &mut Book, comment: &str, flags: &[&str], p: &[Q; 3], d: &[Q; 3]) {
    let end: Point = p.iter().zip(d).map(|(p, d)| p + d).collect();
    let truth = count(p, d);
    let lines = on_saddle([p.to_vec(), end]);
    of_lines(book, comment, flags, &lines, truth);
    let number = u64::from(book.count());
    if number % 3 == 0 {
        let by = [power(40), -power(39), power(38)];
        let far: Vec<Line> = lines
            .iter()
            .map(|line| {
                let moved = moved(&[line.to_vec()], &by).remove(0);
                [moved[0].clone(), moved[1].clone()]
            })
            .collect();
        let flags: Vec<&str> = flags.iter().copied().chain(["FarFromOrigin"]).collect();
        of_lines(book, &format!("2^40 units away: {comment}"), &flags, &far, truth);
    }
    if number % 3 == 1 {
        let mut other = lines.clone();
        other.reverse();
        let mix =
            |p: &Point| vec![&p[0] * q(2) + &p[1], &p[1] + &p[2] * q(3), &p[2] - &p[0] + q(5)];
        let other: Vec<Line> = other.iter().map(|line| line.each_ref().map(mix)).collect();
        of_lines(book, &format!("Sheared, in the other order: {comment}"), flags, &other, truth);
    }
}

/// Concurrent, coplanar, equal and parallel lines.
fn special_lines() -> Vec<(&'static str, Vec<Line>, LineCount)> {
    let line = |a: [i64; 3], b: [i64; 3]| [a.map(q).to_vec(), b.map(q).to_vec()];
    let [x, y, z] = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map(|axis| line([0, 0, 0], axis));
    let off = line([5, 1, 2], [7, 4, 3]);
    vec![
        (
            "The three axes, and a line that misses the origin: all lines from the origin to it.",
            vec![x.clone(), y.clone(), z.clone(), off.clone()],
            Family,
        ),
        (
            "Four lines through one point.",
            vec![x.clone(), y.clone(), z.clone(), line([0, 0, 0], [1, 1, 1])],
            Family,
        ),
        (
            "Four lines of one plane.",
            vec![x.clone(), y.clone(), line([3, 0, 0], [0, 4, 0]), line([1, 1, 0], [2, 5, 0])],
            Family,
        ),
        (
            "Three lines of one plane, and one that crosses it: all lines of the plane through that point.",
            vec![x.clone(), y.clone(), line([3, 0, 0], [0, 4, 0]), line([7, 7, -1], [7, 8, 2])],
            Family,
        ),
        (
            "Three lines of one plane, and one parallel to it: the plane's lines in that direction.",
            vec![x.clone(), y.clone(), line([3, 0, 0], [0, 4, 0]), line([0, 0, 5], [1, 1, 5])],
            Family,
        ),
        (
            "The same line twice, and two more: a family.",
            vec![x.clone(), x.clone(), line([0, 0, 1], [0, 1, 1]), line([0, 3, 4], [5, 1, 7])],
            Family,
        ),
        ("The same line four times.", vec![x.clone(), x.clone(), x.clone(), x.clone()], Family),
        (
            "Four parallel lines, not of one plane: they meet in a point at infinity, and so do the lines parallel to them.",
            vec![
                z.clone(),
                line([1, 0, 0], [1, 0, 1]),
                line([0, 1, 0], [0, 1, 1]),
                line([1, 3, 0], [1, 3, 1]),
            ],
            Family,
        ),
        (
            "Two crossing pairs: the line through both meets, and the line in both planes.",
            vec![x.clone(), y.clone(), line([3, 3, 5], [4, 3, 5]), line([3, 3, 5], [3, 4, 6])],
            Two,
        ),
        (
            "Two crossing pairs in parallel planes: the line through both meets; the planes' line is at infinity.",
            vec![x.clone(), y.clone(), line([3, 3, 5], [4, 3, 5]), line([3, 3, 5], [3, 4, 5])],
            One,
        ),
        (
            "Two crossing pairs, the second's meet in the first's plane: the lines of that plane through it.",
            vec![x.clone(), y.clone(), line([0, 2, 0], [1, 2, 1]), line([0, 2, 0], [3, 3, 3])],
            Family,
        ),
    ]
}

fn special(book: &mut Book) {
    book.group(Kind::Transversals, "Concurrent, coplanar, equal and parallel lines.");
    for (comment, lines, truth) in special_lines() {
        of_lines(book, comment, &["SpecialLines"], &lines, truth);
        let by = [power(20), power(19), -power(20)];
        let far: Vec<Line> = lines
            .iter()
            .map(|line| {
                let moved = moved(&[line.to_vec()], &by).remove(0);
                [moved[0].clone(), moved[1].clone()]
            })
            .collect();
        let moved = format!("2^20 units away: {comment}");
        of_lines(book, &moved, &["SpecialLines", "FarFromOrigin"], &far, truth);
        let half = |p: &Point| {
            vec![&p[0] * ratio(127, 5000), &p[1] * ratio(127, 5000), &p[2] * ratio(127, 5000)]
        };
        let metres: Vec<Line> = lines.iter().map(|line| line.each_ref().map(half)).collect();
        let comment = format!("Scaled by 0.0254: {comment}");
        of_lines(book, &comment, &["SpecialLines", "UnitScale"], &metres, truth);
    }
}

fn of_lines(book: &mut Book, comment: &str, flags: &[&str], lines: &[Line], truth: LineCount) {
    let all: Vec<Value> = lines.iter().map(|line| values(line)).collect();
    let input = json!({ "format": "stabline-lines/1", "lines": all });
    let file = LinesFile::read(input.to_string().as_bytes()).and_then(|file| file.lines());
    let found = transversals(&file.unwrap_or_else(|error| panic!("{error}: {input}")));
    let report = TransversalsReport::new(&found).to_json();
    let mut certificate: Value = serde_json::from_str(&report).expect("it is JSON");
    let (name, reason) = line_proof::reason(lines, &found);
    certificate[name] = reason;
    let test = Test {
        input: Some(input),
        transversals: Some(truth),
        certificate: Some(certificate),
        ..Test::default()
    };
    book.test(comment, flags, test);
}
