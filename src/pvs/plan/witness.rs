//! A rational line through portals that some line is known to pass.

use super::propose::{Part, parts};
use crate::geom::BigPoint2;
use crate::num::{Int, Number, Rational, Sign};
use crate::predicates::{PlanPoint, turn_of_points};
use crate::scene::plan::{Crossing, PlanGraph};
use crate::stab::hourglass::{Hourglass, PlaneVerdict};
use num_integer::Integer;

/// Two points of a line in its direction, in grid units.
#[derive(Clone, Debug)]
pub(super) struct Through([PlanPoint; 2]);

/// Where the ends of portals are, by number.
type Points<'a> = &'a dyn Fn(u32) -> &'a PlanPoint;

impl Through {
    /// Whether the line passes a portal strictly between its ends.
    pub(super) fn passes(&self, points: Points, way: &Crossing) -> bool {
        let Through([from, to]) = self;
        turn_of_points(from, to, points(way.left)) == Sign::Positive
            && turn_of_points(from, to, points(way.right)) == Sign::Negative
    }

    pub(super) fn in_world(&self, grid: &Int) -> [[Number; 2]; 2] {
        let world = |c: Rational| Number::from(c / grid);
        self.0.each_ref().map(|point| point.coordinates().map(world))
    }
}

/// Two points of a line that passes all portals strictly between their ends, in world units.
///
/// # Panics
/// If no line does.
pub(super) fn line(graph: &PlanGraph, ways: &[Crossing]) -> [[Number; 2]; 2] {
    through(&|end| graph.points.get(end), ways).in_world(&graph.grid)
}

/// The same, in grid units.
///
/// # Panics
/// If no line does.
pub(super) fn through(points: Points, ways: &[Crossing]) -> Through {
    simple(points, ways).unwrap_or_else(|| inner(points, ways))
}

/// A line through simple parts of the first and the last portal: halves, thirds, and parts that
/// floats propose.
fn simple(points: Points, ways: &[Crossing]) -> Option<Through> {
    let (first, last) = (ways.first()?, ways.last()?);
    let ends = |way: &Crossing| [way.left, way.right].map(|end| points(end).coordinates());
    let part = |way: &Crossing, Part(p, q): Part| {
        let t = Rational::new(p.into(), q.into());
        let [a, b] = ends(way);
        PlanPoint::from_coordinates(&[0, 1].map(|i| &a[i] + &t * (&b[i] - &a[i])))
    };
    if ways.len() == 1 {
        let [l, r] = ends(first);
        let middle = part(first, Part(1, 2));
        let [x, y] = middle.coordinates();
        let beyond = [x + (&l[1] - &r[1]), y - (&l[0] - &r[0])];
        return Some(Through([middle, PlanPoint::from_coordinates(&beyond)]));
    }
    let floats = |way: &Crossing| [points(way.left).floats(), points(way.right).floats()];
    let gates: Vec<_> = ways.iter().map(floats).collect();
    parts(&gates).find_map(|[start, end]| {
        let line = Through([part(first, start), part(last, end)]);
        ways.iter().all(|way| line.passes(points, way)).then_some(line)
    })
}

/// The line that the hourglass of the portals gives.
fn inner(points: Points, ways: &[Crossing]) -> Through {
    let ends = ways.iter().flat_map(|way| [way.left, way.right]);
    let numbers: Vec<[Int; 3]> = ends.map(|end| points(end).numbers()).collect();
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
    let scaled_back = |point: [Rational; 2]| point.map(|c| c / &common);
    Through(witness.points.map(|point| PlanPoint::from_coordinates(&scaled_back(point))))
}
