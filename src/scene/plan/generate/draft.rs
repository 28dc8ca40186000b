//! A building on the drawing board: walls with gaps, and rooms that may be divided.

use super::DOOR;
use crate::num::Random;
use std::collections::BinaryHeap;

/// A wall, parallel to an axis.
#[derive(Clone, Debug)]
pub(super) struct Wall {
    /// In which it has one coordinate, and that coordinate.
    pub(super) dimension: usize,
    pub(super) at: i64,
    /// Where it starts and ends in the other dimension.
    pub(super) span: [i64; 2],
    /// Its windows and doors, ascending, apart from each other and from the ends.
    pub(super) gaps: Vec<[i64; 2]>,
}

impl Wall {
    /// The segments that it consists of.
    pub(super) fn pieces(&self) -> Vec<[[i64; 2]; 2]> {
        let [start, end] = self.span;
        let starts = std::iter::once(start).chain(self.gaps.iter().map(|gap| gap[1]));
        let ends = self.gaps.iter().map(|gap| gap[0]).chain([end]);
        let point = |along: i64| match self.dimension {
            0 => [self.at, along],
            _ => [along, self.at],
        };
        starts.zip(ends).map(|(from, to)| [point(from), point(to)]).collect()
    }

    fn faces(&self) -> usize {
        self.gaps.len() + 1
    }
}

/// By dimension, and by low and high side: the gaps in what bounds a room.
type Sides = [[Vec<[i64; 2]>; 2]; 2];

/// A rectangle between walls. Ordered by area, then by age.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Room {
    area: i64,
    number: usize,
    extents: [[i64; 2]; 2],
    sides: Sides,
}

/// The least width of a room.
const LEAST: i64 = 14;
/// One wall between rooms in so many has its door in the middle.
const MIDDLE: i64 = 8;
/// One in so many of the rooms with such an area stays as it is, as a great hall.
const GREAT: i64 = 3;
const GREAT_AREA: std::ops::Range<i64> = 6_000..11_000;
/// How often a place for a wall is drawn before a room stays undivided.
const DRAWS: usize = 12;

/// The drawing board.
pub(super) struct Draft {
    random: Random,
    pub(super) walls: Vec<Wall>,
    rooms: BinaryHeap<Room>,
    /// What is not divided any more.
    finished: Vec<Room>,
    /// How many rooms there have been.
    made: usize,
}

impl Draft {
    pub(super) fn new(random: Random) -> Draft {
        let rooms = BinaryHeap::new();
        Draft { random, walls: Vec::new(), rooms, finished: Vec::new(), made: 0 }
    }

    fn within(&mut self, [low, high]: [i64; 2]) -> i64 {
        self.random.between(low, high)
    }

    /// Makes gaps of a width in a wall, so far from each other.
    pub(super) fn pierce(&mut self, wall: &mut Wall, pitch: [i64; 2], width: i64) {
        let [start, end] = wall.span;
        let mut at = start + self.within(pitch) / 2;
        while at + width + 4 < end {
            wall.gaps.push([at, at + width]);
            at += self.within(pitch).max(width + 4);
        }
    }

    /// A length in strips of about equal width, with ways of drawn widths between them.
    pub(super) fn strips(&mut self, length: i64, strip: i64, way: [i64; 2]) -> Vec<[i64; 2]> {
        let middle = (way[0] + way[1]) / 2;
        let count = ((length + middle + strip / 2) / (strip + middle)).max(1);
        let mut strips = Vec::new();
        let mut start = 0;
        for i in 1..=count {
            let end = length * i / count;
            if i == count {
                strips.push([start, length]);
                break;
            }
            let jitter = self.random.between(-strip / 4, strip / 4);
            let width = self.within(way);
            strips.push([start, end + jitter - width / 2]);
            start = end + jitter - width / 2 + width;
        }
        strips
    }

    /// The gaps of an outer wall, which are among the first walls.
    pub(super) fn gaps_of_outer(&self, dimension: usize, at: i64) -> Vec<[i64; 2]> {
        let wall = self.walls.iter().find(|wall| (wall.dimension, wall.at) == (dimension, at));
        wall.map(|wall| wall.gaps.clone()).unwrap_or_default()
    }

    pub(super) fn add_room(&mut self, extents: [[i64; 2]; 2], mut sides: Sides) {
        let [width, depth] = extents.map(|[low, high]| high - low);
        let (area, number) = (width * depth, self.made);
        self.made += 1;
        // What lies elsewhere in a long wall does not matter.
        for (dimension, pair) in sides.iter_mut().enumerate() {
            let [low, high] = extents[1 - dimension];
            pair.iter_mut().for_each(|gaps| gaps.retain(|gap| gap[1] > low && gap[0] < high));
        }
        self.rooms.push(Room { area, number, extents, sides });
    }

    /// Divides rooms, the largest first, until there are so many faces.
    pub(super) fn divide_rooms(&mut self, faces: usize) {
        let mut count: usize = self.walls.iter().map(Wall::faces).sum();
        while count < faces {
            let Some(room) = self.rooms.pop() else { return };
            let is_great = GREAT_AREA.contains(&room.area) && self.random.one_in(GREAT);
            match (!is_great).then(|| self.place_of_wall(&room)).flatten() {
                Some((dimension, at)) => {
                    let wall = self.wall_across(&room, dimension, at, faces - count > 1);
                    count += wall.faces();
                    self.walls.push(wall);
                }
                None => self.finished.push(room),
            }
        }
    }

    /// Where a wall may divide a room: about the middle of its longer side, and off all gaps.
    fn place_of_wall(&mut self, room: &Room) -> Option<(usize, i64)> {
        let [width, depth] = room.extents.map(|[low, high]| high - low);
        let longer = usize::from(depth > width);
        for dimension in [longer, 1 - longer] {
            let [low, high] = room.extents[dimension];
            let margin = LEAST.max((high - low) * 3 / 10);
            if high - low < 2 * margin {
                continue;
            }
            for _ in 0..DRAWS {
                let at = self.random.between(low + margin, high - margin);
                // It ends on the sides of the other dimension.
                let mut gaps = room.sides[1 - dimension].iter().flatten();
                if gaps.all(|gap| at < gap[0] - 1 || at > gap[1] + 1) {
                    return Some((dimension, at));
                }
            }
        }
        None
    }

    /// A wall across a room, with a door; the room becomes two.
    fn wall_across(&mut self, room: &Room, dimension: usize, at: i64, may_break: bool) -> Wall {
        let [low, high] = room.extents[1 - dimension];
        let mut wall = Wall { dimension, at, span: [low, high], gaps: Vec::new() };
        let door = if may_break && high - low > 3 * DOOR && self.random.one_in(MIDDLE) {
            let start = self.random.between(low + DOOR / 2, high - DOOR - DOOR / 2);
            wall.gaps.push([start, start + DOOR]);
            [start, start + DOOR]
        } else if self.random.one_in(2) {
            wall.span[0] += DOOR;
            [low, low + DOOR]
        } else {
            wall.span[1] -= DOOR;
            [high - DOOR, high]
        };
        for side in [0, 1] {
            let (mut extents, mut sides) = (room.extents, room.sides.clone());
            extents[dimension][1 - side] = at;
            sides[dimension][1 - side] = vec![door];
            self.add_room(extents, sides);
        }
        wall
    }

    /// At most so many screens: oblique segments from a wall into a room.
    pub(super) fn screens(&mut self, count: usize) -> Vec<[[i64; 2]; 2]> {
        let mut rooms = std::mem::take(&mut self.rooms).into_sorted_vec();
        rooms.append(&mut self.finished);
        let mut screens = Vec::with_capacity(count);
        for room in rooms.iter().rev().cycle().take(count) {
            let [x, y] = room.extents;
            let from = match self.random.one_in(2) {
                true => [x[self.random.between(0, 1) as usize], self.within(y)],
                false => [self.within(x), y[self.random.between(0, 1) as usize]],
            };
            let mut inner = |[low, high]: [i64; 2]| self.random.between(low + 3, high - 3);
            let to = [inner(x), inner(y)];
            screens.push([from, to]);
        }
        screens
    }
}
