//! The part of a cell in a wedge, as a convex polygon with exact corners.
//!
//! Every corner is the eye, a corner of the cell, or the meet of a ray with an edge of the cell,
//! so that degrees do not grow with the number of portals (Teller and Séquin 1991, figure 10).

use super::cone::{Wedge, turn};
use crate::num::{Int, Rational, Sign, sum};
use crate::predicates::PlanPoint;
use crate::scene::CellId;
use std::cmp::Ordering;

/// What is seen of a cell through one sequence: the cell's part in a wedge.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlanRegion {
    /// The cell.
    pub cell: CellId,
    /// The sequence: portals, from the eye's cell on; none for a cell that holds the eye.
    pub portals: Vec<u32>,
    /// A convex polygon with an inside, counter-clockwise, in grid units.
    pub polygon: Vec<PlanPoint>,
}

impl PlanRegion {
    /// Twice the area, in square grid units.
    pub fn doubled_area(&self) -> Rational {
        doubled_area(&self.polygon)
    }
}

/// Twice the area of a polygon whose corners run counter-clockwise.
pub(super) fn doubled_area(polygon: &[PlanPoint]) -> Rational {
    let numbers: Vec<[Int; 3]> = polygon.iter().map(PlanPoint::numbers).collect();
    let after = numbers.iter().cycle().skip(1);
    let terms = numbers
        .iter()
        .zip(after)
        .map(|([px, py, pw], [qx, qy, qw])| Rational::new(px * qy - py * qx, pw * qw));
    sum(terms)
}

/// A side of a wedge as an edge from `a` to `b` meets it.
struct Side<'a> {
    ray: &'a PlanPoint,
    /// On which side of it the ends are.
    from: Sign,
    to: Sign,
}

impl Side<'_> {
    /// Where the edge crosses the ray's line between its ends, if it does.
    fn meet(&self, eye: &PlanPoint, [a, b]: [&PlanPoint; 2]) -> Option<PlanPoint> {
        match (self.from, self.to) {
            (Sign::Positive, Sign::Negative) | (Sign::Negative, Sign::Positive) => {
                let meet = PlanPoint::meet(eye, self.ray, a, b);
                Some(meet.expect("an edge that crosses a line is not parallel to it"))
            }
            // An end on the line is a corner already.
            (Sign::Zero, _) | (_, Sign::Zero) => None,
            (Sign::Positive, Sign::Positive) | (Sign::Negative, Sign::Negative) => None,
        }
    }
}

/// The part in a wedge of a convex polygon all of which lies within half a turn around its inside:
/// that of a cell entered through a portal. Corners that the wedge's rays touch belong to it.
pub(super) fn part_behind(eye: &PlanPoint, wedge: Wedge, polygon: &[&PlanPoint]) -> Vec<PlanPoint> {
    let sides = |point: &PlanPoint| [turn(eye, wedge.right, point), turn(eye, wedge.left, point)];
    let signs: Vec<[Sign; 2]> = polygon.iter().map(|corner| sides(corner)).collect();
    let mut part = Vec::with_capacity(polygon.len() + 2);
    for (i, corner) in polygon.iter().enumerate() {
        let next = (i + 1) % polygon.len();
        if signs[i][0] != Sign::Negative && signs[i][1] != Sign::Positive {
            part.push((*corner).clone());
        }
        let edge = [*corner, polygon[next]];
        let [right, left] = [(wedge.right, 0), (wedge.left, 1)].map(|(ray, side)| {
            Side { ray, from: signs[i][side], to: signs[next][side] }.meet(eye, edge)
        });
        // A far edge runs counter-clockwise around the eye, past the right ray first.
        match signs[i][0] {
            Sign::Negative => part.extend(right.into_iter().chain(left)),
            // A near edge runs clockwise; one from the right ray itself meets the left one only.
            Sign::Positive | Sign::Zero => part.extend(left.into_iter().chain(right)),
        }
    }
    part
}

/// The part in a wedge of a closed convex polygon that holds the eye; `None` if it has no inside.
pub(super) fn part_around(
    eye: &PlanPoint,
    wedge: Wedge,
    polygon: &[&PlanPoint],
) -> Option<Vec<PlanPoint>> {
    let edge = |i: usize| -> [&PlanPoint; 2] { [polygon[i], polygon[(i + 1) % polygon.len()]] };
    // What of each edge lies in the wedge. An edge through the eye is seen under no angle.
    let mut seen: Vec<(usize, Wedge)> = (0..polygon.len())
        .filter_map(|i| {
            let [a, b] = edge(i);
            Some((i, Wedge::between(eye, a, b)?.meet(eye, wedge)?))
        })
        .collect();
    // All within half a turn.
    seen.sort_by(|(_, one), (_, other)| match turn(eye, one.right, other.right) {
        Sign::Positive => Ordering::Less,
        Sign::Zero => Ordering::Equal,
        Sign::Negative => Ordering::Greater,
    });
    let on = |ray: &PlanPoint, [a, b]: [&PlanPoint; 2]| match ray == a || ray == b {
        true => ray.clone(),
        false => PlanPoint::meet(eye, ray, a, b).expect("a ray that meets an edge crosses it"),
    };
    let &(first, Wedge { right, .. }) = seen.first()?;
    let mut part = vec![eye.clone(), on(right, edge(first))];
    part.extend(seen.iter().map(|(i, wedge)| on(wedge.left, edge(*i))));
    Some(part)
}
