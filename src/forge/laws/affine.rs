//! Maps of space: they keep lines, planes, and what lies on which side.

use crate::forge::input::{Input, Point};
use crate::forge::shapes::{one_of, whole};
use crate::num::{Int, Random, Rational};

/// A shift of a few units, or a far one.
pub(super) fn translated(input: &Input, random: &mut Random) -> Vec<Input> {
    let shift: Vec<Rational> = (0..3)
        .map(|_| match random.between(0, 2) {
            0 => Rational::from(Int::from(random.between(-9, 9))),
            1 => Rational::new(Int::from(random.between(-99, 99)), Int::from(7)),
            _ => Rational::from(Int::from(1) << random.between(20, 60)),
        })
        .collect();
    vec![input.mapped(|p: &Point| p.iter().zip(&shift).map(|(c, s)| c + s).collect())]
}

/// A positive factor for all coordinates.
pub(super) fn scaled(input: &Input, random: &mut Random) -> Vec<Input> {
    let (p, q) = one_of(random, &[(1, 3), (127, 5000), (64, 1), (1, 1024), (7, 11), (3, 1)]);
    let factor = Rational::new(Int::from(p), Int::from(q));
    vec![input.mapped(|point: &Point| point.iter().map(|c| c * &factor).collect())]
}

/// One coordinate with the other sign; polygons turned over, so that they are crossed as before.
pub(super) fn mirrored(input: &Input, random: &mut Random) -> Vec<Input> {
    let axis = random.between(0, input.dimension() as i64 - 1) as usize;
    let mut input = input.mapped(|point: &Point| {
        let mut point = point.clone();
        point[axis] = -&point[axis];
        point
    });
    turn_over(&mut input);
    vec![input]
}

/// The next axis in the place of each; in the plane by a quarter turn.
pub(super) fn turned(input: &Input, _: &mut Random) -> Vec<Input> {
    vec![input.mapped(|point: &Point| match point.as_slice() {
        [x, y] => vec![-y, x.clone()],
        _ => [1, 2, 0].iter().map(|&i| point[i].clone()).collect(),
    })]
}

/// A multiple of one coordinate added to another. (Boxes do not stay boxes.)
pub(super) fn sheared(input: &Input, random: &mut Random) -> Vec<Input> {
    let dimension = input.dimension() as i64;
    let (axis, step) = (random.between(0, dimension - 1), random.between(1, dimension - 1));
    let (to, from) = (axis as usize, ((axis + step) % dimension) as usize);
    let factor = whole(random.between(-3, 3));
    vec![input.mapped(|point: &Point| {
        let mut point = point.clone();
        point[to] = &point[to] + &factor * &point[from];
        point
    })]
}

/// Reverses what has an orientation.
fn turn_over(input: &mut Input) {
    match input {
        Input::Sequence(polygons) => polygons.iter_mut().for_each(|p| p.reverse()),
        Input::Graph(graph) => graph.doors.iter_mut().for_each(|door| door.polygon.reverse()),
        Input::Lines(_) | Input::Scene(_) => {}
    }
}
