//! Scenes of axial blocks.

use super::super::family::TRIPLE;
use super::super::number::{Polygon, Q, q, ratio};
use super::super::space::{square, whole};
use super::{Between, GAPS, Scene, across, along_z, block, corners, units};
use stabline::vectors::Class::Open;

/// Blocks that share a face in the middle of a wall.
pub(super) fn side_by_side() -> Vec<Scene> {
    let mut scenes = Vec::new();
    for (unit, name) in units(&[(1, 1), (1, 20), (1, 1_000_000_000_000)]) {
        for is_t in [false, true] {
            for critical in GAPS {
                let right = q(4) + &unit * q(critical.0);
                let (x, z) = ([right.clone(), q(8)], [q(2), q(3)]);
                let mut brushes = vec![block([q(0), q(4)], [q(0), q(8)], z.clone())];
                brushes.extend(match is_t {
                    false => vec![block(x, [q(0), q(8)], z)],
                    true => {
                        vec![block(x.clone(), [q(0), q(5)], z.clone()), block(x, [q(5), q(8)], z)]
                    }
                });
                let slit = |z: i64| vec![square(&q(z), [q(4), right.clone()], [q(0), q(8)])];
                let between = match critical.1 {
                    Open => Between::Openings(vec![slit(2), slit(3)]),
                    _ => across(ratio(5, 2)),
                };
                let what = match is_t {
                    false => "Two blocks side by side, their faces at x = 4",
                    true => "A block beside two that stand one on the other, faces at x = 4",
                };
                let comment = format!("{what}; the unit is {name}.");
                let flags: &[_] =
                    if is_t { &["CoincidentFaces", "TJunction"] } else { &["CoincidentFaces"] };
                scenes.push(along_z(comment, flags, brushes, [q(2), q(3)], between, critical));
            }
        }
    }
    scenes
}

/// In the plan, blocks fill the lower left and the upper right; near is the upper left and far the
/// lower right.
pub(super) fn diagonal() -> Vec<Scene> {
    let mut scenes = Vec::new();
    for (unit, name) in units(&[(1, 1), (1, 100), (1, 1_000_000_000)]) {
        for critical in GAPS {
            let (sign, class, how) = critical;
            let corner = q(4) + &unit * q(sign);
            let (whole_z, low) = ([q(0), q(4)], [q(0), q(4)]);
            let high = [corner.clone(), q(8)];
            let brushes =
                vec![block(low.clone(), low, whole_z.clone()), block(high.clone(), high, whole_z)];
            let least = q(4).min(corner.clone());
            let upright = |a: [&Q; 2], b: [&Q; 2]| -> Polygon {
                let at = |p: [&Q; 2], z: i64| vec![p[0].clone(), p[1].clone(), q(z)];
                vec![at(a, 0), at(b, 0), at(b, 4), at(a, 4)]
            };
            // Out of near through its right side, past both edges, through far's upper side.
            let (four, eight) = (q(4), q(8));
            let gates = vec![
                vec![upright([&four, &eight], [&four, &four]).into_iter().rev().collect()],
                vec![upright([&four, &four], [&corner, &corner])],
                vec![upright([&four, &four], [&eight, &four])],
            ];
            let between = match class {
                Open => Between::Openings(gates),
                _ => Between::Closed([1, -1, 0].map(q).to_vec(), q(0)),
            };
            scenes.push(Scene {
                comment: format!(
                    "Two blocks, diagonally, with edges at (4, 4); the view cells are in the other \
                     two quarters, and the unit is {name}. {how}"
                ),
                flags: vec!["Solids", "SharedEdge", if sign == 0 { "Flush" } else { "OneUnit" }],
                brushes,
                view: corners([0; 3], [8, 8, 4]),
                near: [[0, 4, 0].map(q).to_vec(), vec![least.clone(), q(8), q(4)]],
                far: [[4, 0, 0].map(q).to_vec(), vec![q(8), least, q(4)]],
                between,
                class,
            });
        }
    }
    scenes
}

/// Two quarters of each wall are blocks, those that the other wall's are not.
pub(super) fn chequered() -> Vec<Scene> {
    let mut scenes = Vec::new();
    let halves = [[0, 4], [4, 8]];
    for (unit, name) in units(&[(1, 1), (1, 10), (1, 10_000_000_000)]) {
        for critical in GAPS {
            let start = q(3) + &unit * q(critical.0);
            let walls = [[q(2), q(3)], [start.clone(), &start + q(1)]];
            let quarter = |z: &[Q; 2], i: usize, j: usize| {
                block(halves[i].map(q), halves[j].map(q), z.clone())
            };
            let mut brushes = vec![quarter(&walls[0], 0, 0), quarter(&walls[0], 1, 1)];
            brushes.extend([quarter(&walls[1], 0, 1), quarter(&walls[1], 1, 0)]);
            let open = |z: &Q, i: usize| vec![square(z, halves[i].map(q), halves[1].map(q))];
            let between = match critical.1 {
                // One way of four: past the edge between the upper quarters.
                Open => Between::Openings(vec![
                    open(&walls[0][0], 0),
                    open(&walls[0][1], 0),
                    open(&walls[1][0], 1),
                    open(&walls[1][1], 1),
                ]),
                _ => across(q(3)),
            };
            let comment = format!(
                "Two walls back to back, chequered: where the one is open the other is solid, and \
                 edges and corners meet. The unit is {name}."
            );
            let ends = [q(2), &start + q(1)];
            let flags = &["SharedEdge", "CornerTouch"];
            scenes.push(along_z(comment, flags, brushes, ends, between, critical));
        }
    }
    scenes
}

/// Half walls: solid on the right, on the left, on the right; their edges are in line.
pub(super) fn posts() -> Vec<Scene> {
    let mut scenes = Vec::new();
    for (unit, name) in units(&[(1, 1), (1, 1_000_000_000)]) {
        for layout in 0..5 {
            for critical in TRIPLE {
                let edge = q(4) - &unit * q(critical.0);
                let y = || [q(0), q(8)];
                let mut brushes = vec![
                    block([q(4), q(8)], y(), [2, 3].map(q)),
                    block([q(4), q(8)], y(), [8, 9].map(q)),
                ];
                let x = [q(0), edge.clone()];
                let middle = block(x.clone(), y(), [5, 6].map(q));
                let (flag, what, more) = match layout {
                    0 => ("HalfWall", "three blocks", vec![middle]),
                    1 => {
                        let half = ratio(11, 2);
                        let parts = vec![
                            block(x.clone(), y(), [q(5), half.clone()]),
                            block(x, y(), [half, q(6)]),
                        ];
                        ("CoincidentFaces", "the middle one of two blocks, face to face", parts)
                    }
                    2 => {
                        let inner = block([q(1), q(3)], [1, 7].map(q), [5, 6].map(q));
                        let deep = block([q(1), q(2)], [2, 3].map(q), [q(5), ratio(11, 2)]);
                        (
                            "Nested",
                            "the middle one with two more solids in it",
                            vec![middle, inner, deep],
                        )
                    }
                    3 => {
                        let bar = block([edge.clone(), q(8)], [3, 5].map(q), [5, 6].map(q));
                        (
                            "TwoWays",
                            "the middle one with a bar across what it leaves",
                            vec![middle, bar],
                        )
                    }
                    _ => {
                        let parts = vec![
                            block([q(0), q(3)], y(), [5, 6].map(q)),
                            block([q(2), edge.clone()], y(), [5, 6].map(q)),
                        ];
                        ("Overlap", "the middle one of two blocks that overlap", parts)
                    }
                };
                brushes.extend(more);
                let left = |z: i64| vec![whole(z, [0, 4], [0, 8])];
                let free = if flag == "TwoWays" { vec![[0, 3], [5, 8]] } else { vec![[0, 8]] };
                let right = |z: i64| -> Vec<Polygon> {
                    let window = |y: &[i64; 2]| square(&q(z), [edge.clone(), q(8)], y.map(q));
                    free.iter().map(window).collect()
                };
                let openings = vec![left(2), left(3), right(5), right(6), left(8), left(9)];
                let comment = format!(
                    "Half walls one unit thick, solid on the right, left, right, their edges in \
                     line: {what}. The unit is {name}."
                );
                let between = Between::Openings(openings);
                scenes.push(along_z(comment, &[flag], brushes, [q(2), q(9)], between, critical));
            }
        }
    }
    scenes
}

/// A solid stands in a door, which it fills but for a gap on one side.
pub(super) fn plugs() -> Vec<Scene> {
    let mut scenes = Vec::new();
    for (unit, name) in units(&[(1, 1), (1, 20), (1, 1_000_000_000_000)]) {
        for critical in GAPS {
            let right = q(6) - &unit * q(critical.0);
            let y = || [q(0), q(8)];
            let brushes = vec![
                block([q(0), q(2)], y(), [2, 3].map(q)),
                block([q(6), q(8)], y(), [2, 3].map(q)),
                block([q(2), right.clone()], y(), [ratio(9, 4), ratio(11, 4)]),
            ];
            let door = |z: i64| vec![whole(z, [2, 6], [0, 8])];
            let slit = |z: Q| vec![square(&z, [right.clone(), q(6)], [q(0), q(8)])];
            let between = match critical.1 {
                Open => {
                    Between::Openings(vec![door(2), slit(ratio(9, 4)), slit(ratio(11, 4)), door(3)])
                }
                _ => across(ratio(5, 2)),
            };
            let comment = format!("A door, and a thinner solid that fills it; the unit is {name}.");
            let flags = &["CoincidentFaces"];
            scenes.push(along_z(comment, flags, brushes, [q(2), q(3)], between, critical));
        }
    }
    scenes
}
