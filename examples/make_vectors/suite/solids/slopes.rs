//! Scenes of solids with slanted faces.

use super::super::number::{Q, q, ratio};
use super::super::space::square;
use super::{Between, Brush, GAPS, Scene, across, along_z, block, units};
use stabline::vectors::Class::Open;

/// Two blocks meet in the plane m · (x, y) = c, whose corners are on no grid of the walls'.
pub(super) fn slanted() -> Vec<Scene> {
    let mut scenes = Vec::new();
    let planes = [([7, 3], ratio(124, 3)), ([5, -2], ratio(55, 7)), ([3, 1], ratio(50, 3))];
    for (index, (m, level)) in planes.into_iter().enumerate() {
        for (unit, name) in units(&[(1, 1), (1, 1_000_000_000)]) {
            for critical in GAPS {
                let upper = &level + &unit * q(critical.0);
                let x = |level: &Q, y: i64| (level - q(m[1] * y)) / q(m[0]);
                let part = |level: &Q, is_low: bool| match index {
                    1 => hull(&[x(level, 0), x(level, 8)], if is_low { 0 } else { 8 }),
                    _ => half(m, level, if is_low { 1 } else { -1 }),
                };
                let brushes = vec![part(&level, true), part(&upper, false)];
                let slit = |z: i64| {
                    let at = |level: &Q, y: i64| vec![x(level, y), q(y), q(z)];
                    vec![vec![at(&level, 0), at(&upper, 0), at(&upper, 8), at(&level, 8)]]
                };
                let between = match critical.1 {
                    Open => Between::Openings(vec![slit(2), slit(3)]),
                    _ => across(ratio(5, 2)),
                };
                let comment = format!(
                    "Two blocks that meet in the plane {} x + {} y = {level}; the unit is {name} on \
                     the right of that.",
                    m[0], m[1]
                );
                let flags = &["CoincidentFaces", "OffGrid"];
                scenes.push(along_z(comment, flags, brushes, [q(2), q(3)], between, critical));
            }
        }
    }
    scenes
}

/// The part of a wall where `sign` times m · (x, y) is at most that of the level, by its planes.
fn half(m: [i64; 2], level: &Q, sign: i64) -> Brush {
    let axes = [([1, 0, 0], 8), ([-1, 0, 0], 0), ([0, 1, 0], 8), ([0, -1, 0], 0)];
    let walls = [([0, 0, 1], 3), ([0, 0, -1], -2)];
    let faces = axes.into_iter().chain(walls).map(|(n, c)| (n.map(q).to_vec(), q(c)));
    let slope = ([m[0] * sign, m[1] * sign, 0].map(q).to_vec(), level * q(sign));
    Brush::Planes(faces.chain([slope]).collect())
}

/// The part of a wall between x = `side` and the line through (x0, 0) and (x1, 8), by its corners.
fn hull(ends: &[Q; 2], side: i64) -> Brush {
    let corner = |x: &Q, y: i64, z: i64| vec![x.clone(), q(y), q(z)];
    let at = |z: i64| {
        [(&ends[0], 0), (&ends[1], 8), (&q(side), 0), (&q(side), 8)].map(|(x, y)| corner(x, y, z))
    };
    Brush::Points([at(2), at(3)].concat())
}

/// A ridge along x at (y, z) = (4, 4), and over it a block or another ridge.
pub(super) fn wedges() -> Vec<Scene> {
    let mut scenes = Vec::new();
    for (unit, name) in units(&[(1, 1), (1, 1_000_000_000)]) {
        for is_block in [true, false] {
            for critical in GAPS {
                let over = q(4) + &unit * q(critical.0);
                let ridge = |base: i64, edge: &Q| {
                    let end = |x: i64| {
                        [(q(base), 2), (q(base), 6), (edge.clone(), 4)]
                            .map(|(y, z)| vec![q(x), y, q(z)])
                    };
                    Brush::Points([end(0), end(8)].concat())
                };
                let upper = match is_block {
                    true => block([q(0), q(8)], [over.clone(), q(8)], [2, 6].map(q)),
                    false => ridge(8, &over),
                };
                let brushes = vec![ridge(0, &q(4)), upper];
                let height = if is_block { over.clone() } else { q(8) };
                let gate = |z: i64| vec![square(&q(z), [q(0), q(8)], [q(0), height.clone()])];
                let slit = vec![square(&q(4), [q(0), q(8)], [q(4), over.clone()])];
                let between = match critical.1 {
                    Open => Between::Openings(vec![gate(2), slit, gate(6)]),
                    _ => across(q(4)),
                };
                let (what, flag) = match is_block {
                    true => ("and the face of a block", "EdgeOnFace"),
                    false => ("and another's", "SharedEdge"),
                };
                let comment = format!("The edge of a wedge {what}; the unit is {name}.");
                scenes.push(along_z(comment, &[flag], brushes, [q(2), q(6)], between, critical));
            }
        }
    }
    scenes
}
