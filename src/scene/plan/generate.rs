//! Floorplans of buildings that never were, for measurements and for tests.
//!
//! A building is a rectangle. Halls run through it from front to back, corridors between the
//! halls; what is left are blocks, which walls divide into rooms, always the largest room first.
//! Outer walls have windows and the walls along corridors have doors: gaps. A wall between two
//! rooms has a door in the middle or, more often, ends a door's width short of the next wall. Of
//! rooms of the size of a hall one in three stays one. Rooms meet in T-junctions, and walls of
//! neighbouring rooms are seldom in line.
//!
//! With 1000 faces the k-D tree has about 700 cells, and the mean stab tree about 16 vertices, as
//! that of Teller and Séquin 1991, §5; the sizes above were chosen to this end.
//!
//! The general kind has screens that run obliquely into rooms, and the whole building is turned by
//! the angle of the triangle with sides 3, 4 and 5, so that it stays on the grid of integers.
//!
//! A function of the options: everything is drawn from [`Random`]. O(n lg n).

mod draft;
#[cfg(test)]
mod tests;

use super::{RawPlan, RawSegment};
use crate::num::{Number, Random};
use draft::{Draft, Wall};

/// What building to make up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FloorplanOptions {
    /// How many segments to aim at. Exactly so many are made unless the number is too small for
    /// outer walls and windows (below some 16) or rooms become too small to divide.
    pub faces: usize,
    /// Another number is another building.
    pub seed: u64,
    /// With oblique walls, and turned as a whole; else all walls are parallel to an axis.
    pub is_general: bool,
}

/// A building's area for each of its faces. A unit may be thought of as a decimetre.
const AREA_PER_FACE: i64 = 700;
/// The share of its depth in the sum of width and depth, of 17.
const DEPTH_SHARE: i64 = 7;
/// About how long and how deep a block is.
const BLOCK: [i64; 2] = [420, 116];
/// The width of halls and corridors.
const HALL: [i64; 2] = [30, 44];
const CORRIDOR: [i64; 2] = [16, 26];
/// From one window or door in a long wall to the next, and their width.
const PITCH: [i64; 2] = [36, 72];
const WINDOW: i64 = 14;
/// The width of a door.
const DOOR: i64 = 9;
/// One face in so many is oblique, in the general kind.
const OBLIQUE: usize = 5;

/// Makes up a floorplan, in world units that are whole numbers.
pub fn generate_floorplan(options: &FloorplanOptions) -> RawPlan {
    let mut draft = Draft::new(Random::new(options.seed));
    lay_out(&mut draft, options.faces as i64);
    let oblique = if options.is_general { options.faces / OBLIQUE } else { 0 };
    draft.divide_rooms(options.faces - oblique);
    let mut ends: Vec<[[i64; 2]; 2]> = draft.walls.iter().flat_map(Wall::pieces).collect();
    if options.is_general {
        ends.extend(draft.screens(options.faces.saturating_sub(ends.len())));
        for end in ends.iter_mut().flatten() {
            let [x, y] = *end;
            *end = [4 * x - 3 * y, 3 * x + 4 * y];
        }
    }
    let number = |end: [i64; 2]| end.map(|c| Number::Small(c, 1));
    let segment = |ends: [[i64; 2]; 2]| RawSegment { ends: ends.map(number), is_opaque: true };
    RawPlan { segments: ends.into_iter().map(segment).collect(), ..RawPlan::default() }
}

/// Outer walls, halls and corridors, and the blocks between them.
fn lay_out(draft: &mut Draft, faces: i64) {
    let area = faces * AREA_PER_FACE;
    let width = (area * (17 - DEPTH_SHARE) / DEPTH_SHARE).isqrt().max(60);
    let depth = (area / width).max(40);
    for dimension in [0, 1] {
        let (ends, at) = if dimension == 0 { (depth, width) } else { (width, depth) };
        for at in [0, at] {
            let mut wall = Wall { dimension, at, span: [0, ends], gaps: Vec::new() };
            draft.pierce(&mut wall, PITCH, WINDOW);
            draft.walls.push(wall);
        }
    }
    for [left, right] in draft.strips(width, BLOCK[0], HALL) {
        for [front, back] in draft.strips(depth, BLOCK[1], CORRIDOR) {
            let mut sides = [[Vec::new(), Vec::new()], [Vec::new(), Vec::new()]];
            for dimension in [0, 1] {
                let (ats, span, end) = match dimension {
                    0 => ([left, right], [front, back], width),
                    _ => ([front, back], [left, right], depth),
                };
                for (side, at) in ats.into_iter().enumerate() {
                    // An outer wall has windows, in which no other wall may end.
                    if at == 0 || at == end {
                        sides[dimension][side] = draft.gaps_of_outer(dimension, at);
                        continue;
                    }
                    let mut wall = Wall { dimension, at, span, gaps: Vec::new() };
                    if dimension == 1 {
                        draft.pierce(&mut wall, PITCH, DOOR);
                    }
                    sides[dimension][side] = wall.gaps.clone();
                    draft.walls.push(wall);
                }
            }
            draft.add_room([[left, right], [front, back]], sides);
        }
    }
}
