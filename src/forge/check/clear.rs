//! Whether nothing stands between two points: segments and closed convex sets.

use super::{cross, dot, edges, minus};
use crate::forge::input::{Point, Polygon};
use crate::num::{Int, Rational};
use num_traits::{Signed, Zero};

/// The half-space of the points with normal · x <= offset.
pub struct HalfSpace {
    normal: [Rational; 3],
    offset: Rational,
}

impl HalfSpace {
    fn through(normal: [Rational; 3], point: &[Rational]) -> HalfSpace {
        let offset = (0..3).map(|i| &normal[i] * &point[i]).sum();
        HalfSpace { normal, offset }
    }

    fn flipped(&self) -> HalfSpace {
        HalfSpace { normal: self.normal.each_ref().map(|c| -c), offset: -&self.offset }
    }

    /// Positive outside.
    fn height(&self, point: &[Rational; 3]) -> Rational {
        dot(&self.normal, point) - &self.offset
    }
}

/// A closed convex polygon as half-spaces: both sides of its plane, and those of its edges.
pub fn half_spaces_of_polygon(polygon: &Polygon) -> Vec<HalfSpace> {
    let arm = |i: usize| minus(&polygon[i], &polygon[0]);
    let normals = (1..polygon.len() - 1).map(|i| cross(&arm(i), &arm(i + 1)));
    let Some(normal) = normals.into_iter().find(|n| n.iter().any(|c| !c.is_zero())) else {
        return Vec::new();
    };
    let edge = |(p, q): (&Point, &Point)| HalfSpace::through(cross(&minus(q, p), &normal), p);
    let mut all: Vec<HalfSpace> = edges(polygon).map(edge).collect();
    let plane = HalfSpace::through(normal, &polygon[0]);
    all.push(plane.flipped());
    all.push(plane);
    all
}

/// The hull of points as half-spaces: the planes of three points that have all on one side.
pub fn half_spaces_of_hull(points: &[Point]) -> Vec<HalfSpace> {
    let count = points.len();
    let triples = (0..count).flat_map(|i| (0..i).flat_map(move |j| (0..j).map(move |k| (i, j, k))));
    let mut all = Vec::new();
    for (i, j, k) in triples {
        let normal = cross(&minus(&points[j], &points[i]), &minus(&points[k], &points[i]));
        if normal.iter().all(Zero::is_zero) {
            continue;
        }
        let plane = HalfSpace::through(normal, &points[i]);
        for plane in [plane.flipped(), plane] {
            let is_outside =
                |p: &Point| plane.height(&[0, 1, 2].map(|i| p[i].clone())).is_positive();
            if !points.iter().any(is_outside) {
                all.push(plane);
            }
        }
    }
    all
}

/// The part of the line p + t·(q - p), for t in a range, in the closed set; `None` if it is empty.
pub fn part_within(
    [p, q]: [&[Rational; 3]; 2],
    set: &[HalfSpace],
    range: Option<[Rational; 2]>,
) -> Option<[Option<Rational>; 2]> {
    let [mut low, mut high] = range.map_or([None, None], |range| range.map(Some));
    for half in set {
        let (start, end) = (half.height(p), half.height(q));
        let rise = &end - &start;
        if rise.is_zero() {
            if start.is_positive() {
                return None;
            }
            continue;
        }
        let at = -start / &rise;
        if rise.is_positive() {
            high = Some(high.map_or(at.clone(), |high| high.min(at)));
        } else {
            low = Some(low.map_or(at.clone(), |low| low.max(at)));
        }
        if let (Some(low), Some(high)) = (&low, &high)
            && low > high
        {
            return None;
        }
    }
    Some([low, high])
}

/// Whether the closed segment from `p` to `q` meets none of the closed convex sets.
pub fn is_clear(p: &[Rational; 3], q: &[Rational; 3], occluders: &[Vec<HalfSpace>]) -> bool {
    let whole = || Some([0, 1].map(|t| Rational::from(Int::from(t))));
    occluders.iter().all(|set| part_within([p, q], set, whole()).is_none())
}

/// Whether the line shows that two convex regions see each other: one of the stretches between what
/// occludes, on the whole line, has points inside of both.
pub fn shows(
    line: [&[Rational; 3]; 2],
    regions: [&[HalfSpace]; 2],
    occluders: &[Vec<HalfSpace>],
) -> bool {
    let [Some(from), Some(to)] = regions.map(|region| part_within(line, region, None)) else {
        return false;
    };
    // What is bounded has two ends on a line; `None` is first as a low end.
    let mut shut: Vec<[Option<Rational>; 2]> =
        occluders.iter().filter_map(|set| part_within(line, set, None)).collect();
    shut.sort();
    let mut low = None;
    for [start, end] in shut {
        if share([&low, &start], [&from, &to]) {
            return true;
        }
        low = low.max(end);
    }
    share([&low, &None], [&from, &to])
}

/// Whether an open stretch of a line has points inside of both others; ends that are `None` are at
/// infinity.
fn share([low, high]: [&Option<Rational>; 2], others: [&[Option<Rational>; 2]; 2]) -> bool {
    let meets = |[start, end]: &[Option<Rational>; 2]| {
        let first = low.as_ref().max(start.as_ref());
        let last = [high, end].into_iter().flatten().min();
        first.zip(last).is_none_or(|(first, last)| first < last)
    };
    others.into_iter().all(meets)
}
