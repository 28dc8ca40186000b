//! The distinct lines of a plan.

use crate::num::Int;
use crate::predicates::{PlanPoint, PlanPoints, compare_coordinates};
use crate::scene::plan::Plan;
use num_integer::Integer;
use num_traits::{Signed, ToPrimitive};
use rustc_hash::FxHashMap;
use std::cmp::Ordering;

/// Distinct lines, each directed: horizontal ones to greater x, all others to smaller y, so that
/// the left side of an axial line is the one of greater coordinates (the high child of §2.3).
#[derive(Clone, Debug, Default)]
pub struct PlanLines {
    /// Two points of each, in its direction.
    through: Vec<[u32; 2]>,
    numbers: FxHashMap<Key, u32>,
}

/// The coefficients a : b : c in lowest terms, the first that is not zero positive; short wherever
/// that fits.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
enum Key {
    Short([i128; 3]),
    Long(Box<[Int; 3]>),
}

impl PlanLines {
    /// The lines of the segments, and of the box's four edges; and the number of each segment's.
    pub fn of(plan: &Plan) -> (PlanLines, Vec<u32>, [u32; 4]) {
        let mut lines = PlanLines::default();
        let segments = plan.segments.iter().map(|s| lines.insert(s.ends, &plan.points)).collect();
        let side = |i: usize| [plan.bounds[i], plan.bounds[(i + 1) % 4]];
        let sides = [0, 1, 2, 3].map(|i| lines.insert(side(i), &plan.points));
        (lines, segments, sides)
    }

    /// Two points of a line, in its direction.
    #[inline]
    pub fn through(&self, line: u32) -> [u32; 2] {
        self.through[line as usize]
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.through.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.through.is_empty()
    }

    fn insert(&mut self, ends: [u32; 2], points: &PlanPoints) -> u32 {
        let [p, q] = ends.map(|end| points.get(end));
        let number = self.through.len() as u32;
        *self.numbers.entry(key(p, q)).or_insert_with(|| {
            self.through.push(if is_forward(p, q) { ends } else { [ends[1], ends[0]] });
            number
        })
    }
}

/// Whether a line is directed from `p` to `q`.
fn is_forward(p: &PlanPoint, q: &PlanPoint) -> bool {
    match compare_coordinates(1, p, q) {
        Ordering::Less => false,
        Ordering::Equal => compare_coordinates(0, p, q) == Ordering::Less,
        Ordering::Greater => true,
    }
}

fn key(p: &PlanPoint, q: &PlanPoint) -> Key {
    if let (Some([px, py]), Some([qx, qy])) = (p.small_integers(), q.small_integers()) {
        // Below 2^62, 2^62 and 2^123.
        let [a, b] = [py - qy, qx - px].map(i128::from);
        let c = i128::from(px) * i128::from(qy) - i128::from(py) * i128::from(qx);
        let divisor = a.gcd(&b).gcd(&c) * if (a, b) < (0, 0) { -1 } else { 1 };
        return Key::Short([a / divisor, b / divisor, c / divisor]);
    }
    let (p, q) = (p.numbers(), q.numbers());
    let [a, b, c] = [(1, 2), (2, 0), (0, 1)].map(|(i, j)| &p[i] * &q[j] - &p[j] * &q[i]);
    let mut divisor = a.gcd(&b).gcd(&c);
    if a.is_negative() || (a == Int::ZERO && b.is_negative()) {
        divisor = -divisor;
    }
    let reduced = [a, b, c].map(|n| n / &divisor);
    match reduced.each_ref().map(Int::to_i128) {
        [Some(a), Some(b), Some(c)] => Key::Short([a, b, c]),
        _ => Key::Long(Box::new(reduced)),
    }
}
