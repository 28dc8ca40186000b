//! Segments in the plane.

use super::{Family, PORTALS, Parameter, Settings};
use crate::forge::input::Input;
use crate::forge::shapes::polygons;
use crate::num::Random;
use crate::vectors::Kind;

pub(super) const GATES: Family = Family {
    name: "gates",
    kind: Kind::Sequence,
    purpose: "sequences of segments in the plane: ends shared, on one line, crossed, doubled, turned \
              around, on a grid so small that ties are the rule",
    from_map: false,
    parameters: &[
        Parameter { default: 6, ..PORTALS },
        Parameter {
            name: "reach",
            purpose: "the greatest coordinate across",
            default: 3,
            range: [1, 1 << 50],
        },
    ],
    make: gates,
};

fn gates(random: &mut Random, settings: &Settings) -> Input {
    let most = settings.get("portals");
    let count = random.between(most.min(2), most) as usize;
    let reach = settings.get("reach");
    let step = random.between(0, 2);
    let mut gates: Vec<Vec<[i64; 2]>> = Vec::new();
    while gates.len() < count {
        let y = step * gates.len() as i64;
        let mut left = [random.between(-reach, 1), y + random.between(-1, 1)];
        let mut right = [random.between(-1, reach), y + random.between(-1, 1)];
        if let Some(last) = gates.last() {
            let (a, b) = (last[0], last[1]);
            match random.between(0, 8) {
                0 => left = a,
                1 => right = b,
                // On the line of the one before, beside it, or the same.
                2 => (left, right) = (b, [2 * b[0] - a[0], 2 * b[1] - a[1]]),
                3 => (left, right) = (a, b),
                4 if random.one_in(4) => (left, right) = (b, a),
                // An end on a line through two ends before.
                5 => left = [2 * a[0] - b[0], 2 * a[1] - b[1]],
                _ => {}
            }
        }
        if left != right {
            gates.push(vec![left, right]);
        }
    }
    Input::Sequence(polygons(&gates))
}
