//! Sightlines of Doom levels, checked against every linedef by a brute-force argument of their own.

use stabline::formats::wad::DoomMap;
use stabline::num::{Number, Rational};
use stabline::portal::plan::PlanCells;
use stabline::pvs::plan::PlanSight;
use stabline::scene::plan::DoomPlan;
use std::cmp::Ordering;

type Point = [Rational; 2];

/// What a line meets: how far along it, and the sectors behind and ahead of the linedef.
struct Hit {
    at: Rational,
    behind: Option<u32>,
    ahead: Option<u32>,
}

/// Asserts that a line joins its two sectors: from where it leaves the one to where it enters the
/// other it meets no wall, and linedefs next to these places name the sectors. A linedef with one
/// sector on both sides may name an area of its own, or may be passed over; of an area with several
/// claims only one is named, so `unclosed` sectors are not asked for.
pub fn assert_joins(
    map: &DoomMap,
    doom: &DoomPlan,
    cells: &PlanCells,
    unclosed: &[u32],
    sight: &PlanSight,
) {
    let point = |point: &[Number; 2]| point.each_ref().map(Number::to_rational);
    let [from, to] = sight.line.each_ref().map(point);
    let ends = |portal: u32| {
        let portal = &cells.graph.portals[portal as usize];
        [portal.left, portal.right].map(|end| point(&cells.graph.world(end)))
    };
    let place = |portal: Option<&u32>| {
        let [left, right] = ends(*portal.expect("a line crosses a portal"));
        crossing(&from, &to, &left, &right).expect("the line crosses its portals").0
    };
    let (start, end) = (place(sight.portals.first()), place(sight.portals.last()));
    assert!(start <= end, "portals in order");
    let mut hits = hits(map, doom, &from, &to);
    hits.sort_by(|one, other| one.at.cmp(&other.at));
    for hit in hits.iter().filter(|hit| start <= hit.at && hit.at <= end) {
        assert!(hit.behind.is_some() && hit.ahead.is_some(), "no wall between: {sight:?}");
    }
    // The linedefs next to a place: the very next, and the next that bounds something.
    let bounds = |hit: &&Hit| hit.behind != hit.ahead;
    let before = || hits.iter().skip_while(|hit| hit.at < start);
    let after = || hits.iter().rev().skip_while(|hit| hit.at > end);
    let is = |named: Option<u32>, sector: u32| named == Some(sector) || unclosed.contains(&sector);
    let is_from = |hit: &Hit| is(hit.behind, sight.from);
    let is_to = |hit: &Hit| is(hit.ahead, sight.to);
    let starts = before().next().is_some_and(is_from) || before().find(bounds).is_some_and(is_from);
    let ends = after().next().is_some_and(is_to) || after().find(bounds).is_some_and(is_to);
    assert!(starts && ends, "the sectors at the ends: {sight:?}");
}

/// Every linedef that the line meets.
fn hits(map: &DoomMap, doom: &DoomPlan, from: &Point, to: &Point) -> Vec<Hit> {
    let corner = |vertex: u32| map.vertices[vertex as usize].each_ref().map(Number::to_rational);
    let lines = map.linedefs.iter().zip(&doom.lines);
    let hit = lines.filter_map(|(line, sides)| {
        let (start, end) = (corner(line.start), corner(line.end));
        let (at, is_to_left) = crossing(from, to, &start, &end)?;
        // A linedef that runs to the line's left has its front, its right, ahead.
        let (behind, ahead) = match is_to_left {
            true => (sides.back, sides.front),
            false => (sides.front, sides.back),
        };
        Some(Hit { at, behind, ahead })
    });
    hit.collect()
}

/// Where the line from `p` to `q` meets a segment, in multiples of the way from `p` to `q`, and
/// whether the segment runs from its right to its left; `None` if it does not meet it, or lies
/// along it.
fn crossing(p: &Point, q: &Point, start: &Point, end: &Point) -> Option<(Rational, bool)> {
    let zero = Rational::from(stabline::num::Int::from(0));
    let minus = |a: &Point, b: &Point| [&a[0] - &b[0], &a[1] - &b[1]];
    let cross = |a: &Point, b: &Point| &a[0] * &b[1] - &a[1] * &b[0];
    let along = minus(q, p);
    let [of_start, of_end] = [start, end].map(|corner| cross(&along, &minus(corner, p)));
    let sides = [&of_start, &of_end].map(|side| side.cmp(&zero));
    if sides[0] == sides[1] {
        return None;
    }
    let segment = minus(end, start);
    let at = cross(&minus(start, p), &segment) / cross(&along, &segment);
    Some((at, sides[0].then(sides[1].reverse()) == Ordering::Less))
}
