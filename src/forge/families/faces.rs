//! Faces that coincide, share edges and vertices, or touch.

use super::{Family, PORTALS, Parameter, Settings};
use crate::forge::input::Input;
use crate::forge::shapes::{
    SQUARE, TRIANGLE, Vector, across, add, cross, lay_out, one_of, polygons, scale, sub, vector,
};
use crate::num::Random;
use crate::vectors::Kind;

const SPREAD: Parameter = Parameter {
    name: "spread",
    purpose: "how far apart portals lie, in units; 0 makes ties of everything",
    default: 2,
    range: [0, 1000],
};

pub(super) const COPLANAR: Family = Family {
    name: "coplanar",
    kind: Kind::Sequence,
    purpose: "portals in one plane, overlapping, side by side, or one over the other, crossed the \
              same way or against each other",
    from_map: false,
    parameters: &[PORTALS, SPREAD],
    make: coplanar,
};

pub(super) const COLLINEAR: Family = Family {
    name: "collinear",
    kind: Kind::Sequence,
    purpose: "vertices in the middle of straight sides, and edges of several portals on one line",
    from_map: false,
    parameters: &[PORTALS, SPREAD],
    make: collinear,
};

pub(super) const SHARED: Family = Family {
    name: "shared",
    kind: Kind::Sequence,
    purpose: "portals that share a vertex, or a whole edge, with the one before",
    from_map: false,
    parameters: &[PORTALS, SPREAD],
    make: shared,
};

pub(super) const TOUCH: Family = Family {
    name: "touch",
    kind: Kind::Sequence,
    purpose: "portals that touch in a point: a vertex on an edge or in the inside of another \
              (T-junctions), or edges that cross",
    from_map: false,
    parameters: &[PORTALS, SPREAD],
    make: touch,
};

pub(super) const DUPLICATE: Family = Family {
    name: "duplicate",
    kind: Kind::Sequence,
    purpose: "exact duplicates of portals, some turned around, some starting at another vertex",
    from_map: false,
    parameters: &[PORTALS, SPREAD],
    make: duplicate,
};

fn count(random: &mut Random, settings: &Settings) -> usize {
    let most = settings.get("portals");
    random.between(most.min(2), most) as usize
}

/// A sequence, each portal made from those before it.
fn sequence(
    random: &mut Random,
    settings: &Settings,
    next: fn(&mut Random, &[Vec<Vector>], i64) -> Vec<Vector>,
) -> Input {
    let (count, spread) = (count(random, settings), settings.get("spread"));
    let mut portals: Vec<Vec<Vector>> = Vec::new();
    while portals.len() < count {
        let portal = next(random, &portals, spread * portals.len() as i64);
        portals.push(portal);
    }
    Input::Sequence(polygons(&portals))
}

fn coplanar(random: &mut Random, settings: &Settings) -> Input {
    sequence(random, settings, |random, before, y| {
        let Some(last) = before.last().filter(|_| !random.one_in(3)) else {
            return across(random, y, 3);
        };
        let (u, v) = (sub(last[1], last[0]), sub(last[2], last[0]));
        let [i, j] = [(); 2].map(|()| random.between(-1, 1));
        let origin = add(last[0], add(scale(u, i), scale(v, j)));
        let (u, v) = (scale(u, random.between(1, 2)), scale(v, random.between(1, 2)));
        let corners: &[[i64; 2]] = if random.one_in(2) { &SQUARE } else { &TRIANGLE };
        let turned = if random.one_in(8) { -1 } else { 1 };
        lay_out([origin, u, v], corners, scale(cross(u, v), turned))
    })
}

fn collinear(random: &mut Random, settings: &Settings) -> Input {
    sequence(random, settings, |random, before, y| {
        let mut portal: Vec<Vector> =
            across(random, y / 2, 2).iter().map(|&p| scale(p, 2)).collect();
        if let Some(last) = before.last().filter(|_| random.one_in(2)) {
            // One edge on the line of an edge of the portal before.
            let edge = random.between(0, last.len() as i64 - 1) as usize;
            let (p, q) = (last[edge], last[(edge + 1) % last.len()]);
            let u = sub(q, p);
            let v = vector(random, 2).map(|c| 2 * c);
            if cross(u, v)[1] != 0 {
                let origin = add(p, scale(u, random.between(-1, 1)));
                portal = lay_out([origin, u, v], &SQUARE, [0, 1, 0]);
            }
        }
        // A vertex in the middle of some sides.
        let mut result = Vec::new();
        for (i, &p) in portal.iter().enumerate() {
            result.push(p);
            let sum = add(p, portal[(i + 1) % portal.len()]);
            if sum.iter().all(|c| c % 2 == 0) && random.one_in(2) {
                result.push(sum.map(|c| c / 2));
            }
        }
        result
    })
}

fn shared(random: &mut Random, settings: &Settings) -> Input {
    sequence(random, settings, |random, before, y| {
        let portal = across(random, y, 3);
        let Some(last) = before.last() else { return portal };
        let at = random.between(0, last.len() as i64 - 1) as usize;
        let (p, q) = (last[at], last[(at + 1) % last.len()]);
        let v = vector(random, 3);
        if random.one_in(2) && cross(sub(q, p), v)[1] != 0 {
            // The whole edge.
            let corners: &[[i64; 2]] = if random.one_in(2) { &SQUARE } else { &TRIANGLE };
            return lay_out([p, sub(q, p), v], corners, [0, 1, 0]);
        }
        let shift = sub(p, one_of(random, &portal));
        portal.into_iter().map(|vertex| add(vertex, shift)).collect()
    })
}

fn touch(random: &mut Random, settings: &Settings) -> Input {
    sequence(random, settings, |random, before, y| {
        // Even coordinates, so that middles lie on the grid.
        let portal: Vec<Vector> = across(random, y / 2, 2).iter().map(|&p| scale(p, 2)).collect();
        let Some(last) = before.last() else { return portal };
        let middle = |polygon: &[Vector], random: &mut Random| {
            let [a, b] = [(); 2].map(|()| one_of(random, polygon));
            add(a, b).map(|c| c.div_euclid(2))
        };
        let from = if random.one_in(3) { middle(&portal, random) } else { one_of(random, &portal) };
        let shift = sub(middle(last, random), from);
        portal.into_iter().map(|vertex| add(vertex, shift)).collect()
    })
}

fn duplicate(random: &mut Random, settings: &Settings) -> Input {
    sequence(random, settings, |random, before, y| {
        if before.is_empty() || random.one_in(3) {
            return across(random, y, 3);
        }
        let mut portal = one_of(random, before);
        let start = random.between(0, portal.len() as i64 - 1) as usize;
        portal.rotate_left(start);
        if random.one_in(4) {
            portal.reverse();
        }
        portal
    })
}
