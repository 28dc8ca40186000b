//! Plans of Doom levels.
//!
//! A sightline is stopped by a linedef without a sidedef on one of its sides, and by no other:
//! floors and ceilings move. So the linedefs that have two sides are segments that do not occlude,
//! and all others are walls, whatever lies behind them. `docs/formats/wad.md` states the policy for
//! each of the things in real levels that should not be; a [`DoomOddity`] names one of them.

mod oddity;

use super::{Plan, PlanError, RawPlan, RawSegment};
use crate::formats::wad::{DoomMap, Linedef};
use crate::num::Sign;
use crate::predicates::compare_coordinates;

pub use oddity::{AreaClaim, DoomOddity};

/// A level as a plan.
///
/// Invariant: a segment's source is the number of its linedef, and it runs as the linedef does.
#[derive(Clone, Debug)]
pub struct DoomPlan {
    /// The plan: every linedef of positive length.
    pub plan: Plan,
    /// What each linedef says about its two sides.
    pub lines: Vec<LineSides>,
    /// The number of sectors.
    pub sectors: usize,
    /// What should not be, as far as it can be told from the linedefs alone.
    pub oddities: Vec<DoomOddity>,
}

/// The sectors on the two sides of a linedef; none where there is no sidedef.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LineSides {
    /// The sector on its right.
    pub front: Option<u32>,
    /// The sector on its left.
    pub back: Option<u32>,
}

impl LineSides {
    fn of(map: &DoomMap, line: &Linedef) -> LineSides {
        let sector = |side: Option<u32>| side.map(|side| map.sidedefs[side as usize]);
        LineSides { front: sector(line.front), back: sector(line.back) }
    }

    /// Whether it stops sightlines.
    pub fn is_wall(&self) -> bool {
        self.front.is_none() || self.back.is_none()
    }

    /// Whether both sides are one sector's, so that it bounds nothing.
    pub fn is_self_referencing(&self) -> bool {
        self.front.is_some() && self.front == self.back
    }
}

/// The plan of a level.
///
/// Time: O(n lg n) and the pairs of lines whose boxes overlap, for n linedefs.
///
/// # Errors
/// A level without a linedef of positive length, and coordinates without a common grid of a sane
/// size.
pub fn plan_of_map(map: &DoomMap) -> Result<DoomPlan, PlanError> {
    let lines: Vec<LineSides> = map.linedefs.iter().map(|line| LineSides::of(map, line)).collect();
    let segment = |(line, sides): (&Linedef, &LineSides)| RawSegment {
        ends: [line.start, line.end].map(|end| map.vertices[end as usize].clone()),
        is_opaque: sides.is_wall(),
    };
    let segments = map.linedefs.iter().zip(&lines).map(segment).collect();
    let plan = Plan::from_raw(&RawPlan { segments, ..RawPlan::default() }).map_err(|error| {
        PlanError { place: error.place.replace("segments", "linedefs"), ..error }
    })?;
    let zero_length = plan.repairs.zero_length.iter().map(|&line| DoomOddity::ZeroLength { line });
    let mut oddities: Vec<DoomOddity> = zero_length.collect();
    for (number, (line, sides)) in map.linedefs.iter().zip(&lines).enumerate() {
        let number = number as u32;
        if line.front.is_none() {
            oddities.push(DoomOddity::NoFront { line: number });
        }
        let says_two_sided = line.is_flagged_two_sided;
        if says_two_sided == sides.is_wall() {
            oddities.push(DoomOddity::Flag { line: number, says_two_sided });
        }
        if let Some(sector) = sides.front.filter(|_| sides.is_self_referencing()) {
            oddities.push(DoomOddity::SelfReferencing { line: number, sector });
        }
    }
    oddities.extend(meetings(&plan));
    oddities.sort();
    Ok(DoomPlan { plan, lines, sectors: map.sectors, oddities })
}

/// The pairs of segments that have more in common than an end of both.
fn meetings(plan: &Plan) -> Vec<DoomOddity> {
    let ranks = [0, 1].map(|axis| ranks(plan, axis));
    // The least and greatest rank along each axis, by least rank along the first.
    let mut boxes: Vec<([[u32; 2]; 2], usize)> = plan
        .segments
        .iter()
        .map(|segment| {
            ranks.each_ref().map(|ranks| {
                let [p, q] = segment.ends.map(|end| ranks[end as usize]);
                [p.min(q), p.max(q)]
            })
        })
        .zip(0..)
        .collect();
    boxes.sort_unstable();
    let mut found = Vec::new();
    for (at, &([x, y], one)) in boxes.iter().enumerate() {
        let near = boxes[at + 1..].iter().take_while(|([other, _], _)| other[0] <= x[1]);
        for &([_, other_y], other) in near {
            if other_y[0] <= y[1] && y[0] <= other_y[1] {
                found.extend(meeting(plan, one.min(other), one.max(other)));
            }
        }
    }
    found
}

/// The place of each point in the order along an axis; equal coordinates have one place.
fn ranks(plan: &Plan, axis: usize) -> Vec<u32> {
    let points = &plan.points;
    let compare = |&p: &u32, &q: &u32| compare_coordinates(axis, points.get(p), points.get(q));
    let mut order: Vec<u32> = (0..points.len() as u32).collect();
    order.sort_unstable_by(compare);
    let mut ranks = vec![0; order.len()];
    let mut rank = 0;
    for pair in order.windows(2) {
        rank += u32::from(compare(&pair[0], &pair[1]).is_lt());
        ranks[pair[1] as usize] = rank;
    }
    ranks
}

/// What two segments have in common, if it is more than an end of both.
fn meeting(plan: &Plan, first: usize, second: usize) -> Option<DoomOddity> {
    let points = &plan.points;
    let [one, other] = [first, second].map(|index| &plan.segments[index]);
    let ([a, b], [c, d]) = (one.ends, other.ends);
    let of_other = [c, d].map(|end| points.turn(a, b, end));
    let of_one = [a, b].map(|end| points.turn(c, d, end));
    let lines = [one.source, other.source];
    let apart = |[p, q]: [Sign; 2]| p != Sign::Zero && p == -q;
    if of_other == [Sign::Zero; 2] {
        let along = |p: u32, q: u32| points.compare_along([a, b], p, q).is_lt();
        let (low, high) = if along(c, d) { (c, d) } else { (d, c) };
        return (along(low, b) && along(a, high)).then_some(DoomOddity::Overlap { lines });
    }
    match (apart(of_other), apart(of_one)) {
        (true, true) => Some(DoomOddity::Crossing { lines }),
        // An end of one on the line of the other, whose ends are on both sides of it.
        (false, true) if of_other.contains(&Sign::Zero) => Some(DoomOddity::Touching { lines }),
        (true, false) if of_one.contains(&Sign::Zero) => {
            Some(DoomOddity::Touching { lines: [lines[1], lines[0]] })
        }
        _ => None,
    }
}
