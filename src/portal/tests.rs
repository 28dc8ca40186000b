use super::{Cells, Portal, enumerate, flood};
use crate::construct::{Polygon, mean};
use crate::geom::RationalPoint3;
use crate::num::{Int, Rational, Sign};
use crate::predicates::side_of_point;
use crate::subdivision::tests::{Random, cuboid, place, random_solids};
use crate::subdivision::{LeafId, Options, Solid, Subdivision, build};
use std::collections::BTreeMap;

fn divide(solids: &[Solid]) -> (Subdivision, Vec<Portal>) {
    let subdivision = build(solids, &[], &Options::default()).unwrap();
    let portals = enumerate(&subdivision);
    (subdivision, portals)
}

fn point(coordinates: [i64; 3]) -> RationalPoint3 {
    RationalPoint3::new(coordinates.map(Int::from), Int::from(1))
}

/// All pairs of empty leaves with a common polygon, face by face: the twin of the tree's way.
fn common_faces(subdivision: &Subdivision) -> BTreeMap<(LeafId, LeafId), [Rational; 3]> {
    let mut common = BTreeMap::new();
    let empty = || subdivision.leaf_ids().filter(|&leaf| !subdivision.leaf(leaf).solid);
    for from in empty() {
        for to in empty() {
            let (a, b) = (&subdivision.leaf(from).cell, &subdivision.leaf(to).cell);
            for face in a.faces() {
                let support = face.support();
                let touches = b.faces().iter().any(|other| other.support() == support.flipped());
                if !touches || support.undirected() != support {
                    continue;
                }
                let others = b.faces().iter().map(Polygon::support);
                let planes = &subdivision.planes;
                let shared = others
                    .filter(|plane| *plane != support.flipped())
                    .try_fold(face.clone(), |rest, plane| rest.inside(planes, plane));
                if let Some(shared) = shared {
                    let twice = common.insert((from, to), shared.doubled_area());
                    assert_eq!(twice, None, "two leaves share two faces");
                }
            }
        }
    }
    common
}

#[test]
fn portals_are_the_common_faces_of_empty_leaves() {
    for seed in 1..40 {
        let random = &mut Random::new(seed);
        let count = random.within(1, 7) as usize;
        let (subdivision, portals) = divide(&random_solids(random, count));
        let found: BTreeMap<_, _> = portals
            .iter()
            .map(|portal| ((portal.from, portal.to), portal.polygon.doubled_area()))
            .collect();
        assert_eq!(found.len(), portals.len(), "seed {seed}");
        assert_eq!(found, common_faces(&subdivision), "seed {seed}");
    }
}

#[test]
fn portals_lie_between_their_leaves_and_in_no_solid() {
    for seed in 1..60 {
        let random = &mut Random::new(seed);
        let solids = random_solids(random, 9);
        let (subdivision, portals) = divide(&solids);
        for portal in &portals {
            let center = mean(portal.polygon.points().into_iter());
            let mut leaves = [portal.from, portal.to];
            leaves.sort_unstable();
            assert_eq!(subdivision.locate(&center), leaves, "seed {seed}");
            for (index, solid) in solids.iter().enumerate() {
                let flat = subdivision.flat.contains(&index);
                assert!(flat || place(solid, &center) == Sign::Positive, "seed {seed}");
            }
            let support = subdivision.planes.get(portal.polygon.support());
            let beyond = subdivision.leaf(portal.to).cell.inner_point();
            assert_eq!(side_of_point(support, &beyond), Sign::Positive);
            let normal = support.plane().normal.clone();
            let along: Rational =
                portal.polygon.doubled_area().iter().zip(normal).map(|(a, n)| a * n).sum();
            assert!(along > Rational::from(Int::ZERO), "seed {seed}: not counter-clockwise");
        }
    }
}

/// Six walls around the inside from 0 to 8, each one unit thick.
fn room() -> Vec<Solid> {
    let walls = [
        ([-1, -1, -1], [0, 9, 9]),
        ([8, -1, -1], [9, 9, 9]),
        ([0, -1, -1], [8, 0, 9]),
        ([0, 8, -1], [8, 9, 9]),
        ([0, 0, -1], [8, 8, 0]),
        ([0, 0, 8], [8, 8, 9]),
    ];
    walls.map(|(low, high)| cuboid(low, high)).into()
}

#[test]
fn a_closed_room_keeps_the_flood_inside() {
    let (subdivision, portals) = divide(&room());
    let points = [point([4, 4, 4]), point([8, 4, 4]), point([100; 3])];
    let flood = flood(&subdivision, &portals, &points);
    assert_eq!(flood.leak, None);
    // The second point touches the inside from a wall, the third is far away.
    assert_eq!(flood.buried, [2]);
    let inside = subdivision.leaf_ids().filter(|leaf| flood.inside[leaf.0 as usize]);
    let volume: Rational = inside.map(|leaf| subdivision.leaf(leaf).cell.volume()).sum();
    assert_eq!(volume, Rational::from(Int::from(512)));
}

#[test]
fn a_hole_in_the_wall_is_a_leak_with_a_way_through_it() {
    // The last wall goes; in its stead two that leave a slit from x = 3 to x = 4.
    let mut solids = room();
    solids.pop();
    solids.push(cuboid([0, 0, 8], [3, 8, 9]));
    solids.push(cuboid([4, 0, 8], [8, 8, 9]));
    let (subdivision, portals) = divide(&solids);
    let flood = flood(&subdivision, &portals, &[point([-1, 4, 4]), point([4, 4, 4])]);
    let leak = flood.leak.unwrap();
    assert_eq!(leak.path.len(), leak.leaves.len() + 1);
    assert!(subdivision.touches_bounds(*leak.leaves.last().unwrap()));
    for (pair, leaf) in leak.path.windows(2).zip(&leak.leaves) {
        for end in pair {
            assert!(subdivision.locate(end).contains(leaf));
        }
    }
}

#[test]
fn a_sealed_point_does_not_leak_through_an_edge() {
    // Boxes that touch along edges only: the gap has no area.
    let mut solids = room();
    solids.push(cuboid([9, -1, -1], [10, 9, 9]));
    let (subdivision, portals) = divide(&solids);
    assert_eq!(flood(&subdivision, &portals, &[point([4, 4, 4])]).leak, None);
}

#[test]
fn filling_keeps_what_is_reached_and_nothing_else() {
    // A room with two boxes in it and rubble around it.
    let mut solids = room();
    solids.push(cuboid([2, 2, 0], [3, 4, 3]));
    solids.push(cuboid([5, 1, 2], [6, 7, 8]));
    solids.push(cuboid([12, 3, 3], [14, 6, 5]));
    solids.push(cuboid([9, 3, 11], [14, 6, 12]));
    let (subdivision, portals) = divide(&solids);
    let start = [point([1, 1, 1])];
    let first = flood(&subdivision, &portals, &start);
    let filled = subdivision.filled(&first.inside, &Options::default());
    let portals = enumerate(&filled);
    let second = flood(&filled, &portals, &start);
    assert_eq!(second.leak, None);
    for leaf in filled.leaf_ids() {
        assert_eq!(second.inside[leaf.0 as usize], !filled.leaf(leaf).solid);
    }
    let volume = |of: &Subdivision, kept: &[bool]| -> Rational {
        let leaves = of.leaf_ids().filter(|leaf| kept[leaf.0 as usize]);
        leaves.map(|leaf| of.leaf(leaf).cell.volume()).sum()
    };
    let free = 512 - 6 - 36;
    assert_eq!(volume(&filled, &second.inside), Rational::from(Int::from(free)));
    assert_eq!(volume(&subdivision, &first.inside), Rational::from(Int::from(free)));
    assert_eq!(
        volume(&filled, &vec![true; filled.leaves.len()]),
        volume(&subdivision, &vec![true; subdivision.leaves.len()])
    );
    let cells = Cells::of(&filled, &portals, &second.inside);
    assert_eq!(cells.portals.len(), portals.len());
    assert!(cells.portals.iter().all(|portal| portal.from != portal.to));
    let nothing = subdivision.filled(&vec![false; subdivision.leaves.len()], &Options::default());
    assert!(nothing.leaves.iter().all(|leaf| leaf.solid));
}
