//! Why there are no more lines through four lines than those that are stated, or infinitely many.
//!
//! The Plücker vectors x with side(x, l) = 0 for the four lines l, if these are independent, are
//! α r + β s for two vectors r and s, and a line is where Q = Q(r) α² + side(r, s) αβ + Q(s) β² is
//! zero. If that is not zero for all α and β, it has at most two roots. So three lines that meet
//! all four are as good as infinitely many.

use super::four_lines::Line;
use super::number::{Q, q, value, values};
use num_integer::Integer;
use serde_json::{Value, json};
use stabline::geom::BigLine;
use stabline::num::{Int, Rational};
use stabline::stab::transversals::{Family, ProjectivePlane, ProjectivePoint, Transversals};

type Vector = [Q; 3];

/// The field of the certificate that says it, by its name.
///
/// # Panics
/// If neither four independent lines nor a family is given.
pub fn reason(lines: &[Line], found: &Transversals) -> (&'static str, Value) {
    if let Some(family) = found.families.first() {
        let lines = three_of(family);
        return ("three", lines.iter().map(|line| values(line)).collect());
    }
    let [r, s] = &null_space(lines)[..] else { panic!("{} lines are dependent", lines.len()) };
    let form = [&side(r, r) / q(2), side(r, s), &side(s, s) / q(2)];
    let numbers = |of: &[Q]| of.iter().map(value).collect::<Vec<_>>();
    ("quadratic", json!({ "vectors": [numbers(r), numbers(s)], "form": numbers(&form) }))
}

fn side(x: &[Q; 6], y: &[Q; 6]) -> Q {
    (0..6).map(|i| &x[i] * &y[(i + 3) % 6]).sum()
}

/// A basis of the vectors that have no side with any of the lines, in lowest terms.
fn null_space(lines: &[Line]) -> Vec<[Q; 6]> {
    let mut rows: Vec<[Q; 6]> = lines.iter().map(row).collect();
    let mut pivots = Vec::new();
    for column in 0..6 {
        let at = pivots.len();
        let Some(found) = (at..rows.len()).find(|&i| rows[i][column] != q(0)) else { continue };
        rows.swap(at, found);
        let pivot = rows[at].clone();
        for (i, row) in rows.iter_mut().enumerate() {
            let factor = &row[column] / &pivot[column];
            for (c, p) in row.iter_mut().zip(&pivot) {
                match i == at {
                    true => *c = p / &pivot[column],
                    false => *c -= &factor * p,
                }
            }
        }
        pivots.push(column);
    }
    let free = (0..6).filter(|column| !pivots.contains(column));
    let vector = |free: usize| {
        let mut vector: [Q; 6] = std::array::from_fn(|i| q(i64::from(i == free)));
        pivots.iter().zip(&rows).for_each(|(&pivot, row)| vector[pivot] = -row[free].clone());
        let common = vector.iter().fold(Int::from(1), |common, c| common.lcm(c.denom()));
        vector.map(|c| c * Rational::from(common.clone()))
    };
    free.map(vector).collect()
}

/// What has to be zero of (direction, moment): the line's moment and direction.
fn row([p, q]: &Line) -> [Q; 6] {
    let d: Vec<Q> = (0..3).map(|i| &q[i] - &p[i]).collect();
    let cross = |i: usize, j: usize| &p[i] * &q[j] - &p[j] * &q[i];
    [cross(1, 2), cross(2, 0), cross(0, 1), d[0].clone(), d[1].clone(), d[2].clone()]
}

fn cross(a: &Vector, b: &Vector) -> Vector {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| &a[i] * &b[j] - &a[j] * &b[i])
}

fn plus(a: &Vector, b: &Vector) -> Vector {
    [0, 1, 2].map(|i| &a[i] + &b[i])
}

fn whole(vector: &[Int; 3]) -> Vector {
    vector.clone().map(Q::from)
}

fn axes() -> [Vector; 3] {
    [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map(|axis| axis.map(q))
}

/// Two directions that span the plane across a vector.
fn across(n: &Vector) -> [Vector; 2] {
    let turned = axes().map(|axis| cross(n, &axis));
    let u = turned.into_iter().find(|u| u.iter().any(|c| *c != q(0)));
    let u = u.expect("the vector is not zero");
    let v = cross(n, &u);
    [u, v]
}

fn through(p: &Vector, direction: &Vector) -> Line {
    [p.to_vec(), plus(p, direction).to_vec()]
}

fn points(line: &BigLine) -> [Vector; 2] {
    let (d, m) = (whole(&line.direction), whole(&line.moment));
    let square: Q = d.iter().map(|c| c * c).sum();
    let foot = cross(&d, &m).map(|c| c / &square);
    let next = plus(&foot, &d);
    [foot, next]
}

/// A point of a plane, the nearest to the origin.
fn foot(plane: &ProjectivePlane) -> Vector {
    let n = whole(&plane.normal);
    let square: Q = n.iter().map(|c| c * c).sum();
    n.map(|c| c * Q::from(plane.offset.clone()) / &square)
}

fn finite(point: &ProjectivePoint) -> Option<Vector> {
    let weight = Q::from(point.weight.clone());
    (weight != q(0)).then(|| whole(&point.position).map(|c| c / &weight))
}

/// Three different lines of a family.
fn three_of(family: &Family) -> [Line; 3] {
    match family {
        Family::Pencil { center, plane } => {
            let n = whole(&plane.normal);
            match finite(center) {
                Some(center) => {
                    let [u, v] = across(&n);
                    let sum = plus(&u, &v);
                    [u, v, sum].map(|direction| through(&center, &direction))
                }
                None => {
                    let direction = whole(&center.position);
                    let step = cross(&n, &direction);
                    let start = foot(plane);
                    let next = plus(&start, &step);
                    let last = plus(&next, &step);
                    [start, next, last].map(|p| through(&p, &direction))
                }
            }
        }
        Family::Regulus { lines, .. } => {
            lines.each_ref().map(|line| points(line).map(|p| p.to_vec()))
        }
        Family::Bundle { center } => match finite(center) {
            Some(center) => axes().map(|direction| through(&center, &direction)),
            None => {
                let direction = whole(&center.position);
                let [u, v] = across(&direction);
                [[0, 0, 0].map(q), u, v].map(|p| through(&p, &direction))
            }
        },
        Family::PlaneField { plane } => {
            let ([u, v], p) = (across(&whole(&plane.normal)), foot(plane));
            [through(&p, &u), through(&p, &v), through(&plus(&p, &u), &v)]
        }
        Family::Congruence { axes } => {
            let [a, b] = axes.each_ref().map(points);
            [(0, 0), (1, 1), (0, 1)].map(|(i, j)| [a[i].to_vec(), b[j].to_vec()])
        }
        Family::Complex { axis } => {
            let [p, _] = points(axis);
            axes().map(|direction| through(&p, &direction))
        }
    }
}
