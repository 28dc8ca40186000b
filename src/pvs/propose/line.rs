//! Lines that might stab a sequence: from a point of its cone in R^6 to the Klein quadric.
//!
//! A point x of the cone is a line only if `Q(x) = d · m = 0`. With another point y of the cone,
//! Q(x + t y) is a parabola in t; where it has a positive root the point there is a line of the
//! cone. To find such a y, ask the least-point search for the cone cut by `side(x, y)` having the
//! sign that Q(x) lacks; if the parabola still has no root, go on from its extremum.

use super::norm::{Half, NormPoint, Outcome, dot};

/// A proposed line: a point and a direction, in the frame of the half-spaces.
pub(crate) type LineSearch = ([f64; 3], [f64; 3]);

const ROUNDS: usize = 24;

fn swapped(x: &Half) -> Half {
    [x[3], x[4], x[5], x[0], x[1], x[2]]
}

/// Q(x) = d · m.
fn quadric(x: &Half) -> f64 {
    x[0] * x[3] + x[1] * x[4] + x[2] * x[5]
}

/// Proposes a line near `x` that is on the positive side of all `halves`; failing that, the
/// indices of the half-spaces that keep it off the quadric.
///
/// A half-space is an edge as (moment, direction), a line x as (direction, moment).
pub(crate) fn propose_line(halves: &mut Vec<Half>, x: Half) -> Result<LineSearch, Vec<u32>> {
    let count = halves.len();
    let line = search(halves, x);
    halves.truncate(count);
    line
}

fn search(halves: &mut Vec<Half>, mut x: Half) -> Result<LineSearch, Vec<u32>> {
    let count = halves.len();
    let mut weight: Half = [0.0; 6];
    for half in halves.iter() {
        for (w, h) in weight.iter_mut().zip(half) {
            *w += h;
        }
    }
    let mut goal = 0.0;
    let mut blocking = Vec::new();
    for _ in 0..ROUNDS {
        if let Some(line) = on_quadric(&halves[..count], &x) {
            return Ok(line);
        }
        let q = quadric(&x);
        let polar = swapped(&x);
        let level = goal * 2.0 * q.abs() / dot(&weight, &x);
        let mut cut = [0.0; 6];
        for ((c, p), w) in cut.iter_mut().zip(&polar).zip(&weight) {
            *c = level * w - q.signum() * p;
        }
        let norm = dot(&cut, &cut).sqrt();
        halves.truncate(count);
        halves.push(cut.map(|c| c / norm));
        let y = match NormPoint::default().search(halves, true) {
            Outcome::Inside(y) => y,
            Outcome::Excluded(set) => {
                blocking = set.iter().map(|s| s.0).filter(|&i| (i as usize) < count).collect();
                goal = 0.5 * (1.0 + goal);
                if goal > 0.99 {
                    return Err(blocking);
                }
                continue;
            }
        };
        // Q(x + t y) = q + b t + a t^2
        let (a, b) = (quadric(&y), dot(&y, &polar));
        match crossing(q, b, a) {
            Some(t) => {
                for (x, y) in x.iter_mut().zip(&y) {
                    *x += t * y;
                }
            }
            None => x = y,
        }
        let norm = dot(&x, &x).sqrt();
        x = x.map(|c| c / norm);
    }
    on_quadric(&halves[..count], &x).ok_or(blocking)
}

/// A positive root of q + b t + a t^2.
fn crossing(q: f64, b: f64, a: f64) -> Option<f64> {
    let discriminant = b * b - 4.0 * a * q;
    if !(discriminant >= 0.0) {
        return None;
    }
    let s = -0.5 * (b + discriminant.sqrt().copysign(b));
    [q / s, s / a].into_iter().filter(|t| t.is_finite() && *t > 0.0).min_by(f64::total_cmp)
}

/// The line of x with its moment made orthogonal to its direction, if it is inside.
fn on_quadric(halves: &[Half], x: &Half) -> Option<LineSearch> {
    let d = glam::DVec3::new(x[0], x[1], x[2]);
    let m = glam::DVec3::new(x[3], x[4], x[5]);
    let m = m - d * (d.dot(m) / d.length_squared());
    let line = [d.x, d.y, d.z, m.x, m.y, m.z];
    let inside = halves.iter().all(|h| dot(h, &line) > 0.0);
    let foot = d.cross(m) / d.length_squared();
    (inside && foot.is_finite()).then(|| (foot.to_array(), d.to_array()))
}
