//! A rational line through portals that some line is known to pass.

use crate::geom::BigPoint2;
use crate::num::{Int, Number, Rational, Sign};
use crate::predicates::{PlanPoint, turn_of_points};
use crate::scene::plan::{Crossing, PlanGraph};
use crate::stab::hourglass::{Hourglass, PlaneVerdict};
use num_integer::Integer;

/// Parts of a portal at which simple lines are tried.
const FRACTIONS: [(i64, i64); 7] = [(1, 2), (1, 3), (2, 3), (1, 4), (3, 4), (1, 8), (7, 8)];

/// Two points of a line that passes all portals strictly between their ends, in world units.
///
/// # Panics
/// If no line does.
pub(super) fn line(graph: &PlanGraph, ways: &[Crossing]) -> [[Number; 2]; 2] {
    let points = simple(graph, ways).unwrap_or_else(|| inner(graph, ways));
    let grid = Rational::from(graph.grid.clone());
    points.map(|point| point.map(|c| Number::from(c / &grid)))
}

/// A line through simple parts of the first and the last portal.
fn simple(graph: &PlanGraph, ways: &[Crossing]) -> Option<[[Rational; 2]; 2]> {
    let (first, last) = (ways.first()?, ways.last()?);
    let ends =
        |way: &Crossing| [way.left, way.right].map(|end| graph.points.get(end).coordinates());
    let part = |way: &Crossing, (p, q): (i64, i64)| {
        let t = Rational::new(p.into(), q.into());
        let [a, b] = ends(way);
        [0, 1].map(|i| &a[i] + &t * (&b[i] - &a[i]))
    };
    if ways.len() == 1 {
        let [l, r] = ends(first);
        let middle = part(first, (1, 2));
        let beyond = [&middle[0] + (&l[1] - &r[1]), &middle[1] - (&l[0] - &r[0])];
        return Some([middle, beyond]);
    }
    for f in FRACTIONS {
        let start = part(first, f);
        let from = PlanPoint::from_coordinates(&start);
        for l in FRACTIONS {
            let end = part(last, l);
            let to = PlanPoint::from_coordinates(&end);
            if from != to && passes(graph, ways, &from, &to) {
                return Some([start, end]);
            }
        }
    }
    None
}

fn passes(graph: &PlanGraph, ways: &[Crossing], from: &PlanPoint, to: &PlanPoint) -> bool {
    ways.iter().all(|way| {
        turn_of_points(from, to, graph.points.get(way.left)) == Sign::Positive
            && turn_of_points(from, to, graph.points.get(way.right)) == Sign::Negative
    })
}

/// The line that the hourglass of the portals gives.
fn inner(graph: &PlanGraph, ways: &[Crossing]) -> [[Rational; 2]; 2] {
    let ends = ways.iter().flat_map(|way| [way.left, way.right]);
    let numbers: Vec<[Int; 3]> = ends.map(|end| graph.points.get(end).numbers()).collect();
    let common = numbers.iter().fold(Int::from(1), |common, [_, _, w]| common.lcm(w));
    let scaled = |[x, y, w]: &[Int; 3]| {
        let factor = &common / w;
        BigPoint2 { coordinates: [x * &factor, y * &factor] }
    };
    let mut hourglass = Hourglass::new();
    for pair in numbers.chunks(2) {
        hourglass.push_big(scaled(&pair[0]), scaled(&pair[1]));
    }
    let PlaneVerdict::Open(witness) = hourglass.verdict() else {
        unreachable!("a line passes these portals");
    };
    let common = Rational::from(common);
    witness.points.map(|point| point.map(|c| c / &common))
}
