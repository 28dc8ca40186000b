//! The sectors of a Doom level's leaves.
//!
//! An *area* is what can be reached without crossing a linedef: leaves joined across boundaries on
//! which none lies. Its sectors are those that the sidedefs facing it name. A linedef with one
//! sector on both sides bounds nothing; it counts where nothing else does, so that an area drawn
//! with such lines alone, inside another, is a part of their sector. Linear in the boundaries, up
//! to the inverse of Ackermann's function.

use super::plan::{Boundary, PlanCells};
use crate::scene::plan::{AreaClaim, DoomOddity, DoomPlan};
use std::collections::BTreeMap;

/// Which leaves are parts of which sectors.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DoomAreas {
    /// The area of each leaf.
    pub of_leaf: Vec<u32>,
    /// The sectors of each area, ascending: one as a rule, none in the void.
    pub sectors: Vec<Vec<u32>>,
    /// What of the level should not be, all of it, in the order of its kinds.
    pub oddities: Vec<DoomOddity>,
}

/// What the sidedefs that face an area say.
#[derive(Clone, Debug, Default)]
struct Claims {
    /// Sectors, and the void, each with the first line that says so.
    strong: BTreeMap<Option<u32>, u32>,
    /// Sectors of lines that have them on both sides.
    weak: BTreeMap<Option<u32>, u32>,
}

impl DoomAreas {
    /// The areas of a level that is divided into cells.
    pub fn of(doom: &DoomPlan, cells: &PlanCells) -> DoomAreas {
        let of_leaf = areas(cells);
        let count = of_leaf.iter().max().map_or(0, |last| *last as usize + 1);
        let mut claims = vec![Claims::default(); count];
        for boundary in &cells.boundaries {
            for (leaf, is_left) in [(boundary.left, true), (boundary.right, false)] {
                if let Some(leaf) = leaf {
                    let area = of_leaf[leaf as usize] as usize;
                    claim(doom, cells, boundary, is_left, &mut claims[area]);
                }
            }
        }
        let mut oddities = doom.oddities.clone();
        let mut sectors = Vec::with_capacity(count);
        for Claims { strong, weak } in claims {
            let claims = if strong.is_empty() { weak } else { strong };
            sectors.push(claims.keys().copied().flatten().collect());
            if claims.len() > 1 {
                let claims = claims.into_iter().map(|(sector, line)| AreaClaim { sector, line });
                oddities.push(DoomOddity::Unclosed { claims: claims.collect() });
            }
        }
        let mut is_bare = vec![true; doom.sectors];
        sectors.iter().flatten().for_each(|&sector| is_bare[sector as usize] = false);
        let bare = (0..).zip(is_bare).filter(|(_, is_bare)| *is_bare);
        oddities.extend(bare.map(|(sector, _)| DoomOddity::NoArea { sector }));
        oddities.sort();
        DoomAreas { of_leaf, sectors, oddities }
    }

    /// The sectors that are not closed: parts of areas that are parts of others, or of the void.
    pub fn unclosed(&self) -> Vec<u32> {
        let oddities = self.oddities.iter();
        let unclosed = oddities.filter(|oddity| matches!(oddity, DoomOddity::Unclosed { .. }));
        unclosed.flat_map(DoomOddity::sectors).collect()
    }

    /// The sectors that a leaf is a part of.
    ///
    /// # Panics
    /// If there is no such leaf.
    pub fn sectors_of_leaf(&self, leaf: u32) -> &[u32] {
        &self.sectors[self.of_leaf[leaf as usize] as usize]
    }
}

/// The area of each leaf, by ascending number of its first leaf.
fn areas(cells: &PlanCells) -> Vec<u32> {
    let mut parents: Vec<u32> = (0..cells.tree.leaves.len() as u32).collect();
    fn top(parents: &mut [u32], mut leaf: u32) -> u32 {
        while parents[leaf as usize] != leaf {
            let above = parents[parents[leaf as usize] as usize];
            parents[leaf as usize] = above;
            leaf = above;
        }
        leaf
    }
    for boundary in cells.boundaries.iter().filter(|boundary| boundary.segments.is_empty()) {
        if let (Some(left), Some(right)) = (boundary.left, boundary.right) {
            let (left, right) = (top(&mut parents, left), top(&mut parents, right));
            parents[left.max(right) as usize] = left.min(right);
        }
    }
    // A top is the least of its leaves, and so is numbered before the others.
    let mut areas = vec![0; parents.len()];
    let mut count = 0;
    for leaf in 0..parents.len() as u32 {
        let first = top(&mut parents, leaf);
        if first == leaf {
            areas[leaf as usize] = count;
            count += 1;
        } else {
            areas[leaf as usize] = areas[first as usize];
        }
    }
    areas
}

/// What the linedefs on a piece of boundary say about what lies on its left, or on its right.
fn claim(
    doom: &DoomPlan,
    cells: &PlanCells,
    boundary: &Boundary,
    is_left: bool,
    claims: &mut Claims,
) {
    let mut void: Option<u32> = None;
    let mut is_sector = false;
    for &index in &boundary.segments {
        let segment = &doom.plan.segments[index as usize];
        let [start, end] = segment.ends;
        let is_along = cells.tree.points.compare_along(boundary.ends, start, end).is_lt();
        let sides = doom.lines[segment.source as usize];
        // The front of a linedef is on its right.
        let (faced, other) = match is_along == is_left {
            true => (sides.back, sides.front),
            false => (sides.front, sides.back),
        };
        let claim = |claims: &mut BTreeMap<_, _>| {
            let line = claims.entry(faced).or_insert(segment.source);
            *line = segment.source.min(*line);
        };
        match faced {
            Some(_) if sides.is_self_referencing() => claim(&mut claims.weak),
            Some(_) => {
                claim(&mut claims.strong);
                is_sector = true;
            }
            // A line without any sidedef says nothing.
            None if other.is_none() => {}
            None => void = Some(void.map_or(segment.source, |first| first.min(segment.source))),
        }
    }
    // Of lines back to back each has the other's sector where it has no side itself.
    if let Some(line) = void.filter(|_| !is_sector) {
        let first = claims.strong.entry(None).or_insert(line);
        *first = line.min(*first);
    }
}
