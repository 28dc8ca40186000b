//! Lines that might stab a sequence: from a point of its cone in R^6 to the Klein quadric.
//!
//! A point x of the cone is a line only if `Q(x) = d · m = 0`. With another point y of the cone,
//! Q(x + t y) is a parabola in t; where it has a positive root the point there is a line of the
//! cone. To find such a y, ask the least-point search for the cone cut by `side(x, y)` having the
//! sign that Q(x) lacks; if the parabola still has no root, go on from its extremum.

use super::norm::{Half, NormPoint, Outcome, dot};

/// A proposed line: a point and a direction, in the frame of the half-spaces.
pub(crate) type LineSearch = ([f64; 3], [f64; 3]);

const ROUNDS: usize = 8;

fn swapped(x: &Half) -> Half {
    [x[3], x[4], x[5], x[0], x[1], x[2]]
}

/// Q(x) = d · m.
fn quadric(x: &Half) -> f64 {
    x[0] * x[3] + x[1] * x[4] + x[2] * x[5]
}

/// Proposes a line near `x` that is on the positive side of all `halves`.
///
/// A half-space is an edge as (moment, direction), a line x as (direction, moment).
pub(crate) fn propose_line(halves: &mut Vec<Half>, x: Half) -> Option<LineSearch> {
    let count = halves.len();
    let line = search(halves, x);
    halves.truncate(count);
    line
}

fn search(halves: &mut Vec<Half>, mut x: Half) -> Option<LineSearch> {
    let count = halves.len();
    for _ in 0..ROUNDS {
        if let Some(line) = on_quadric(&halves[..count], &x) {
            return Some(line);
        }
        let q = quadric(&x);
        let polar = swapped(&x);
        let scale = -q.signum() / dot(&polar, &polar).sqrt();
        halves.truncate(count);
        halves.push(polar.map(|c| c * scale));
        let Outcome::Inside(y) = NormPoint::default().search(halves, true) else { return None };
        // Q(x + t y) = q + b t + a t^2
        let (a, b) = (quadric(&y), dot(&y, &polar));
        let disc = b * b - 4.0 * a * q;
        let t = if disc >= 0.0 { 2.0 * q / (-b - disc.sqrt().copysign(b)) } else { -b / (2.0 * a) };
        let t =
            if disc >= 0.0 && !(t > 0.0) { -(b + disc.sqrt().copysign(b)) / (2.0 * a) } else { t };
        for (x, y) in x.iter_mut().zip(&y) {
            *x += t * y;
        }
        let norm = dot(&x, &x).sqrt();
        x = x.map(|c| c / norm);
    }
    None
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
