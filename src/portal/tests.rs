use super::{Cells, Portal, check, enumerate, flood};
use crate::construct::{Polygon, mean, minus, polygon_of_points};
use crate::geom::RationalPoint3;
use crate::num::{Int, Rational, Sign};
use crate::predicates::side_of_point;
use crate::report::Silent;
use crate::subdivision::tests::{
    Random, around_solids, cuboid, place, random_occluders, random_solids, whole as point,
};
use crate::subdivision::{LeafId, Occluders, Options, PortalShape, Solid, Subdivision, build};
use std::collections::BTreeMap;

fn divide(solids: &[Solid]) -> (Subdivision, Vec<Portal>) {
    let mut subdivision = build(&around_solids(solids), &Options::default(), &Silent).unwrap();
    let portals = enumerate(&mut subdivision, PortalShape::default());
    (subdivision, portals)
}

/// The doubled areas of what all pairs of empty leaves share, face by face, less the polygons
/// themselves: the twin of the tree's way.
fn common_faces(
    subdivision: &Subdivision,
    occluders: &Occluders,
) -> BTreeMap<(LeafId, LeafId), [Rational; 3]> {
    let mut planes = subdivision.planes.clone();
    let thin: Vec<Polygon> = (occluders.polygons.iter())
        .map(|points| polygon_of_points(&mut planes, points).unwrap())
        .collect();
    let planes = &planes;
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
                let shared = others
                    .filter(|plane| *plane != support.flipped())
                    .try_fold(face.clone(), |rest, plane| rest.inside(planes, plane));
                let coplanar = thin.iter().filter(|p| p.support().undirected() == support);
                let pieces =
                    coplanar.fold(shared.into_iter().collect(), |pieces: Vec<_>, other| {
                        pieces.into_iter().flat_map(|piece| minus(planes, piece, other)).collect()
                    });
                if !pieces.is_empty() {
                    let twice = common.insert((from, to), area(&pieces));
                    assert_eq!(twice, None, "two leaves share two faces");
                }
            }
        }
    }
    common
}

/// The sum of the doubled areas of polygons that look the same way.
fn area<'a>(polygons: impl IntoIterator<Item = &'a Polygon>) -> [Rational; 3] {
    let zero = [(); 3].map(|()| Rational::from(Int::ZERO));
    polygons
        .into_iter()
        .map(Polygon::doubled_area)
        .fold(zero, |sum, area| std::array::from_fn(|i| &sum[i] + &area[i]))
}

fn areas(portals: &[Portal]) -> BTreeMap<(LeafId, LeafId), [Rational; 3]> {
    let mut pairs: BTreeMap<_, Vec<&Polygon>> = BTreeMap::new();
    for portal in portals {
        pairs.entry((portal.from, portal.to)).or_default().push(&portal.polygon);
    }
    pairs.into_iter().map(|(pair, polygons)| (pair, area(polygons))).collect()
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
        assert_eq!(found, common_faces(&subdivision, &around_solids(&[])), "seed {seed}");
    }
}

#[test]
fn portals_are_what_thin_polygons_leave_of_the_common_faces() {
    let (mut several, mut merged_away, mut wider) = (0, 0, 0);
    for seed in 1..150 {
        let occluders = random_occluders(&mut Random::new(seed));
        let mut subdivision = build(&occluders, &Options::default(), &Silent).unwrap();
        let exact = enumerate(&mut subdivision, PortalShape::Exact);
        let merged = enumerate(&mut subdivision, PortalShape::Merged);
        let common = common_faces(&subdivision, &occluders);
        assert_eq!(areas(&exact), common, "seed {seed}");
        assert_eq!(areas(&merged), common, "seed {seed}");
        for portals in [&exact, &merged] {
            check(&subdivision, portals, &occluders, false)
                .unwrap_or_else(|violation| panic!("seed {seed}: {violation}"));
        }
        let hulls = enumerate(&mut subdivision, PortalShape::Hull);
        check(&subdivision, &hulls, &occluders, true).unwrap();
        let square = |area: &[Rational; 3]| area.iter().map(|c| c * c).sum::<Rational>();
        let hull_areas = areas(&hulls);
        assert_eq!(hull_areas.len(), hulls.len(), "seed {seed}: one for each pair of leaves");
        assert!(hull_areas.keys().eq(common.keys()));
        for (pair, area) in &hull_areas {
            assert!(square(area) >= square(&common[pair]), "seed {seed} {pair:?}");
            wider += usize::from(*area != common[pair]);
        }
        several += merged.len() - hulls.len();
        merged_away += exact.len() - merged.len();
    }
    assert!(several > 20 && merged_away > 20 && wider > 20, "{several} {merged_away} {wider}");
}

#[test]
fn a_window_in_a_thin_wall_joins_two_cells() {
    // A wall across the view in four pieces, round a window: one portal. With a bar in it, two,
    // whose hull is the window again.
    let third = |n: i64| Rational::new(Int::from(n), Int::from(3));
    let view = crate::geom::AxialBox {
        low: [third(0), third(0), third(0)],
        high: [third(18), third(19), third(20)],
    };
    let wall = |low: [i64; 2], high: [i64; 2]| -> Vec<RationalPoint3> {
        let corners = [[low[0], low[1]], [high[0], low[1]], [high[0], high[1]], [low[0], high[1]]];
        corners.map(|[y, z]| point([3, y, z])).into()
    };
    let mut polygons = vec![
        wall([0, 0], [2, 9]),
        wall([4, -1], [9, 9]),
        wall([2, 0], [4, 1]),
        wall([1, 4], [5, 7]),
    ];
    let count = |polygons: &[Vec<RationalPoint3>], shape: PortalShape| {
        let occluders = Occluders {
            polygons: polygons.to_vec(),
            view: Some(view.clone()),
            ..Occluders::default()
        };
        let mut subdivision = build(&occluders, &Options::default(), &Silent).unwrap();
        assert_eq!(subdivision.leaves.len(), 2);
        let portals = enumerate(&mut subdivision, shape);
        check(&subdivision, &portals, &occluders, false).unwrap_or_else(|violation| {
            assert_eq!(shape, PortalShape::Hull, "{violation}");
        });
        let twice = area(portals.iter().map(|portal| &portal.polygon));
        (portals.len(), twice[0].to_integer())
    };
    assert_eq!(count(&polygons, PortalShape::Merged), (1, Int::from(12)));
    polygons.push(wall([2, 2], [4, 3]));
    assert_eq!(count(&polygons, PortalShape::Merged), (2, Int::from(8)));
    assert_eq!(count(&polygons, PortalShape::Hull), (1, Int::from(12)));
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
    let mut filled = subdivision.filled(&first.inside, &Options::default(), &Silent).unwrap();
    let portals = enumerate(&mut filled, PortalShape::default());
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
    let nothing = vec![false; subdivision.leaves.len()];
    let nothing = subdivision.filled(&nothing, &Options::default(), &Silent).unwrap();
    assert!(nothing.leaves.iter().all(|leaf| leaf.solid));
}

#[test]
fn filling_makes_a_thin_wall_the_boundary_of_what_is_reached() {
    for seed in 1..120 {
        let random = &mut Random::new(seed);
        let occluders = random_occluders(random);
        let mut subdivision = build(&occluders, &Options::default(), &Silent).unwrap();
        let portals = enumerate(&mut subdivision, PortalShape::Exact);
        let start = [point([(); 3].map(|()| random.within(0, 4)))];
        let first = flood(&subdivision, &portals, &start);
        let mut filled = subdivision.filled(&first.inside, &Options::default(), &Silent).unwrap();
        filled.check(&occluders, true, 10, seed).unwrap();
        let portals = enumerate(&mut filled, PortalShape::Merged);
        check(&filled, &portals, &occluders, false)
            .unwrap_or_else(|violation| panic!("seed {seed}: {violation}"));
        let volume = |of: &Subdivision, kept: &dyn Fn(LeafId) -> bool| -> Rational {
            let leaves = of.leaf_ids().filter(|&leaf| kept(leaf));
            leaves.map(|leaf| of.leaf(leaf).cell.volume()).sum()
        };
        let reached = volume(&subdivision, &|leaf| first.inside[leaf.0 as usize]);
        assert_eq!(volume(&filled, &|leaf| !filled.leaf(leaf).solid), reached, "seed {seed}");
        let second = flood(&filled, &portals, &start);
        assert_eq!(volume(&filled, &|leaf| second.inside[leaf.0 as usize]), reached);
    }
}
