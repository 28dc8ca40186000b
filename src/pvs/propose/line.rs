//! Lines that might stab a sequence: from a point of its cone in R^6 to the Klein quadric.
//!
//! A point x of the cone is a line only if `Q(x) = d · m = 0`. With another point y of the cone,
//! Q(x + t y) is a parabola in t; where it has a positive root the point there is a line of the
//! cone. Such a y is looked for where the linear form side(x, ·) is small or of the sign that Q(x)
//! lacks: the least-point search gets one more half-space, `side(x, y) < goal · 2 Q(x)` relative
//! to a fixed positive form, with a goal of 0 at first and nearer to 1 (which x itself meets)
//! after each failure.

use crate::stab::propose::{Half, NormPoint, Outcome, dot};
use glam::DVec3;

/// A proposed line, in the frame of the half-spaces: a point of it, and its direction.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FrameLine {
    pub foot: DVec3,
    pub direction: DVec3,
}

impl FrameLine {
    /// Direction and moment.
    pub fn bivector(&self) -> Half {
        let (d, m) = (self.direction, self.foot.cross(self.direction));
        [d.x, d.y, d.z, m.x, m.y, m.z]
    }
}

/// Searches for y, successful or not.
const ROUNDS: usize = 24;

/// Where the goal is given up.
const LAST_GOAL: f64 = 0.99;

fn swapped(x: &Half) -> Half {
    [x[3], x[4], x[5], x[0], x[1], x[2]]
}

/// Q(x) = d · m.
fn quadric(x: &Half) -> f64 {
    x[0] * x[3] + x[1] * x[4] + x[2] * x[5]
}

fn unit(x: Half) -> Half {
    let norm = dot(&x, &x).sqrt();
    x.map(|c| c / norm)
}

/// Proposes a line near `x` that is on the positive side of all `halves`; failing that, the
/// indices of the half-spaces that seem to keep it off the quadric.
///
/// A half-space is an edge as (moment, direction), a line x as (direction, moment). `halves` is
/// left as it was.
pub(crate) fn propose_line(halves: &mut Vec<Half>, x: Half) -> Result<FrameLine, Vec<u32>> {
    let count = halves.len();
    let line = search(halves, x);
    halves.truncate(count);
    line
}

fn search(halves: &mut Vec<Half>, mut x: Half) -> Result<FrameLine, Vec<u32>> {
    let count = halves.len();
    let positive: Half = std::array::from_fn(|i| halves.iter().map(|half| half[i]).sum());
    let mut goal = 0.0;
    let mut blocking = Vec::new();
    for _ in 0..ROUNDS {
        if let Some(line) = on_quadric(&halves[..count], &x) {
            return Ok(line);
        }
        let q = quadric(&x);
        let polar = swapped(&x);
        let level = goal * 2.0 * q.abs() / dot(&positive, &x);
        let cut = std::array::from_fn(|i| level * positive[i] - q.signum() * polar[i]);
        halves.truncate(count);
        halves.push(unit(cut));
        match NormPoint::default().search(halves, true) {
            Outcome::Inside(y) => {
                let step = crossing(q, dot(&y, &polar), quadric(&y));
                x = unit(match step {
                    Some(t) => std::array::from_fn(|i| x[i] + t * y[i]),
                    None => y,
                });
            }
            Outcome::Excluded(indices) => {
                blocking = indices.into_iter().filter(|&i| (i as usize) < count).collect();
                goal = 0.5 * (1.0 + goal);
                if goal > LAST_GOAL {
                    return Err(blocking);
                }
            }
        }
    }
    on_quadric(&halves[..count], &x).ok_or(blocking)
}

/// The line that a cone seems to have between a point strictly inside it and one of two points of
/// it on which the quadric is positive and negative.
pub(crate) fn line_between(inside: Half, [positive, negative]: [Half; 2]) -> Option<FrameLine> {
    let inside = unit(inside);
    let q = quadric(&inside);
    let end = unit(if q > 0.0 { negative } else { positive });
    // The end may lie on the cone's boundary: a point near it does not.
    let near = |share: f64| std::array::from_fn(|i| end[i] + share * inside[i]);
    let shares = std::iter::successors(Some(1.0), |share| Some(share / 4.0)).take(SHARES);
    let end = shares.map(near).find(|x| quadric(x) * q < 0.0)?;
    let t = crossing(q, dot(&end, &swapped(&inside)), quadric(&end))?;
    on_quadric(&[], &std::array::from_fn(|i| inside[i] + t * end[i]))
}

/// How near an end is approached.
const SHARES: usize = 16;

/// The least positive root of q + b t + a t².
fn crossing(q: f64, b: f64, a: f64) -> Option<f64> {
    let discriminant = b * b - 4.0 * a * q;
    if discriminant.is_nan() || discriminant < 0.0 {
        return None;
    }
    let s = -0.5 * (b + discriminant.sqrt().copysign(b));
    [q / s, s / a].into_iter().filter(|t| t.is_finite() && *t > 0.0).min_by(f64::total_cmp)
}

/// The line of x with its moment made orthogonal to its direction, if it is inside.
fn on_quadric(halves: &[Half], x: &Half) -> Option<FrameLine> {
    let direction = DVec3::new(x[0], x[1], x[2]);
    let moment = DVec3::new(x[3], x[4], x[5]);
    let moment = moment - direction * (direction.dot(moment) / direction.length_squared());
    let line = FrameLine { foot: direction.cross(moment) / direction.length_squared(), direction };
    let bivector = line.bivector();
    let inside = line.foot.is_finite() && halves.iter().all(|half| dot(half, &bivector) > 0.0);
    inside.then_some(line)
}
