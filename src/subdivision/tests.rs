use super::{
    DivisionError, Face, Hint, Occluders, Options, Painted, Solid, Subdivision, Weights, build,
};
use crate::construct::{PolygonError, mean};
use crate::geom::{AxialBox, BigPlane, RationalPoint3};
use crate::num::{Int, Rational, Sign};
use crate::predicates::{VertexPlane, side_of_point};
use crate::report::Silent;

/// A plane n·x <= offset.
pub(crate) fn plane(normal: [i64; 3], offset: i64) -> BigPlane {
    BigPlane { normal: normal.map(Int::from), offset: Int::from(offset) }
}

/// An axial box.
pub(crate) fn cuboid(low: [i64; 3], high: [i64; 3]) -> Solid {
    let axis = |i: usize, sign: i64| std::array::from_fn(|j| if i == j { sign } else { 0 });
    (0..3).flat_map(|i| [plane(axis(i, 1), high[i]), plane(axis(i, -1), -low[i])]).collect()
}

/// Pseudo-random numbers (Marsaglia, Xorshift RNGs, 2003).
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Random {
        Random(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1)
    }

    /// From `low` to `high`, both included.
    pub(crate) fn within(&mut self, low: i64, high: i64) -> i64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        low + (self.0 % (high - low + 1) as u64) as i64
    }

    fn point(&mut self, denominator: i64) -> RationalPoint3 {
        let numerators =
            [(); 3].map(|()| Int::from(self.within(-2 * denominator, 9 * denominator)));
        RationalPoint3::new(numerators, Int::from(denominator))
    }
}

/// Boxes and boxes with cut corners on a grid so small that faces coincide, solids touch and
/// solids occur twice.
pub(crate) fn random_solids(random: &mut Random, count: usize) -> Vec<Solid> {
    let mut solids: Vec<Solid> = Vec::new();
    for _ in 0..count {
        if !solids.is_empty() && random.within(0, 9) == 0 {
            solids.push(solids[random.within(0, solids.len() as i64 - 1) as usize].clone());
            continue;
        }
        let low = [(); 3].map(|()| random.within(0, 5));
        let high = low.map(|low| low + random.within(1, 3));
        let mut solid = cuboid(low, high);
        for _ in 0..random.within(0, 2) {
            let normal = [(); 3].map(|()| random.within(-2, 2));
            if normal != [0; 3] {
                // Through a grid point of the box, so that it may touch in a vertex or an edge.
                let at = std::array::from_fn::<i64, 3, _>(|i| random.within(low[i], high[i]));
                solid.push(plane(normal, (0..3).map(|i| normal[i] * at[i]).sum()));
            }
        }
        solids.push(solid);
    }
    // One solid with volume for certain.
    solids.push(cuboid([2, 2, 2], [4, 5, 3]));
    solids
}

/// Negative: strictly inside; zero: on the boundary; positive: outside.
pub(crate) fn place(solid: &Solid, point: &RationalPoint3) -> Sign {
    let side = |plane: &BigPlane| side_of_point(&VertexPlane::new(plane.clone()), point);
    solid.iter().map(side).max().unwrap()
}

/// Polygons on the same small grid as the solids: axial rectangles and triangles anywhere.
pub(crate) fn random_polygons(random: &mut Random, count: usize) -> Vec<Vec<RationalPoint3>> {
    let mut polygons: Vec<Vec<RationalPoint3>> = Vec::new();
    while polygons.len() < count {
        let kind = random.within(0, 9);
        if kind == 0 && !polygons.is_empty() {
            polygons.push(polygons[random.within(0, polygons.len() as i64 - 1) as usize].clone());
            continue;
        }
        let corner = [(); 3].map(|()| random.within(0, 6));
        if kind < 6 {
            let axis = random.within(0, 2) as usize;
            let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
            let (width, height) = (random.within(1, 5), random.within(1, 5));
            let at = |right: i64, up: i64| {
                let mut point = corner;
                point[i] += right;
                point[j] += up;
                whole(point)
            };
            polygons.push(vec![at(0, 0), at(width, 0), at(width, height), at(0, height)]);
        } else {
            let triangle = [(); 3].map(|()| {
                let numerators = [(); 3].map(|()| Int::from(random.within(-2, 18)));
                RationalPoint3::new(numerators, Int::from([1, 2, 3][random.within(0, 2) as usize]))
            });
            let mut planes = crate::construct::PlaneSet::default();
            if crate::construct::polygon_of_points(&mut planes, &triangle).is_ok() {
                polygons.push(triangle.into());
            }
        }
    }
    polygons
}

/// A world of both, sometimes with a view that cuts through it.
pub(crate) fn random_occluders(random: &mut Random) -> Occluders {
    let solids = match random.within(0, 3) {
        0 => Vec::new(),
        _ => {
            let count = random.within(0, 5) as usize;
            random_solids(random, count)
        }
    };
    let count = random.within(i64::from(solids.is_empty()), 6) as usize;
    let third = |n: i64| Rational::new(Int::from(n), Int::from(3));
    let view = (random.within(0, 2) == 0).then(|| AxialBox {
        low: [(); 3].map(|()| third(random.within(-3, 9))),
        high: [(); 3].map(|()| third(random.within(10, 30))),
    });
    Occluders { solids, polygons: random_polygons(random, count), hints: Vec::new(), view }
}

pub(crate) fn whole(point: [i64; 3]) -> RationalPoint3 {
    RationalPoint3::new(point.map(Int::from), Int::from(1))
}

pub(crate) fn around_solids(solids: &[Solid]) -> Occluders {
    Occluders { solids: solids.to_vec(), ..Occluders::default() }
}

fn divide(solids: &[Solid]) -> Subdivision {
    build(&around_solids(solids), &Options::default(), &Silent).unwrap()
}

fn volume_of_bounds(subdivision: &Subdivision) -> Rational {
    subdivision.bounds.polyhedron(&subdivision.planes).volume()
}

#[test]
fn leaves_tile_the_box_and_are_what_they_say() {
    for seed in 1..120 {
        let random = &mut Random::new(seed);
        let count = random.within(1, 12) as usize;
        let solids = random_solids(random, count);
        let subdivision = divide(&solids);
        let sum: Rational = subdivision.leaves.iter().map(|leaf| leaf.cell.volume()).sum();
        assert_eq!(sum, volume_of_bounds(&subdivision), "seed {seed}");
        for leaf in subdivision.leaf_ids() {
            let point = subdivision.leaf(leaf).cell.inner_point();
            assert_eq!(subdivision.locate(&point), [leaf], "seed {seed}");
            let covered = solids
                .iter()
                .enumerate()
                .any(|(i, s)| !subdivision.flat.contains(&i) && place(s, &point) != Sign::Positive);
            assert_eq!(subdivision.leaf(leaf).solid, covered, "seed {seed} {leaf:?}");
            assert!(subdivision.leaf(leaf).cell.volume() > Rational::from(Int::ZERO));
        }
    }
}

#[test]
fn random_points_lie_in_one_leaf_or_between_leaves() {
    let (mut single, mut shared) = (0, 0);
    for seed in 1..60 {
        let random = &mut Random::new(seed);
        let solids = random_solids(random, 8);
        let subdivision = divide(&solids);
        for round in 0..60 {
            let denominator = [1, 2, 7, 1000][round % 4];
            let point = random.point(denominator);
            let leaves = subdivision.locate(&point);
            assert!(!leaves.is_empty());
            if let [leaf] = leaves[..] {
                let strictly = subdivision.leaf(leaf).cell.faces().iter().all(|face| {
                    let plane = subdivision.planes.get(face.support());
                    side_of_point(plane, &point) == Sign::Negative
                });
                assert!(strictly, "seed {seed}: a point between leaves lies in one only");
                single += 1;
            } else {
                shared += 1;
            }
            let places: Vec<Sign> = solids.iter().map(|solid| place(solid, &point)).collect();
            let solid = leaves.iter().map(|&leaf| subdivision.leaf(leaf).solid);
            if places.contains(&Sign::Negative) {
                assert!(solid.clone().all(|solid| solid), "seed {seed}");
            }
            if places.iter().all(|&place| place == Sign::Positive) {
                assert!(solid.clone().all(|solid| !solid), "seed {seed}");
            }
        }
    }
    assert!(single > 500 && shared > 100, "{single} {shared}");
}

#[test]
fn the_tree_does_not_depend_on_the_weights_being_sane() {
    let solids = random_solids(&mut Random::new(7), 10);
    let volume = |solid: bool, options: &Options| -> Rational {
        let subdivision = build(&around_solids(&solids), options, &Silent).unwrap();
        let leaves = subdivision.leaves.iter().filter(|leaf| leaf.solid == solid);
        leaves.map(|leaf| leaf.cell.volume()).sum()
    };
    let usual = Options::default();
    let weights = Weights { coplanar: -3, cut: -1, imbalance: 0, axial: -9 };
    let odd = Options { samples: 1, weights, ..usual.clone() };
    assert_eq!(volume(true, &usual), volume(true, &odd));
    assert_eq!(volume(false, &usual), volume(false, &odd));
}

#[test]
fn touching_and_repeated_boxes_leave_no_trace_of_their_common_faces() {
    // Two halves of a cube, and the cube once more.
    let solids = [cuboid([0; 3], [2, 4, 4]), cuboid([2, 0, 0], [4; 3]), cuboid([0; 3], [4; 3])];
    let subdivision = divide(&solids);
    let solid: Vec<_> = subdivision.leaves.iter().filter(|leaf| leaf.solid).collect();
    assert_eq!(solid.len(), 1);
    assert_eq!(solid[0].cell.volume(), Rational::from(Int::from(64)));
    assert_eq!(subdivision.leaves.len(), 7);
}

#[test]
fn hints_split_empty_leaves_only() {
    let solids = [cuboid([0; 3], [4; 3])];
    // The face x <= 2 of the hint splits, the others do not.
    let hint = Hint {
        planes: cuboid([-9, -9, -9], [2, 9, 9]),
        splits: vec![true, false, false, false, false, false],
    };
    let plain = divide(&solids);
    let options = Options { margin: Int::from(1), ..Options::default() };
    let occluders = Occluders { hints: vec![hint], ..around_solids(&solids) };
    let hinted = build(&occluders, &options, &Silent).unwrap();
    assert!(hinted.leaves.len() > plain.leaves.len());
    assert_eq!(hinted.leaves.iter().filter(|leaf| leaf.solid).count(), 1);
    let sum: Rational = hinted.leaves.iter().map(|leaf| leaf.cell.volume()).sum();
    assert_eq!(sum, Rational::from(Int::from(216)));
}

#[test]
fn large_and_skew_planes_take_the_same_way() {
    // Coefficients far past 128 bits, and meets that are no integers.
    let far = Int::from(3) << 90u32;
    let scale = |solid: Solid| -> Solid {
        let grow = |plane: BigPlane| BigPlane { offset: plane.offset * &far, ..plane };
        solid.into_iter().map(grow).collect()
    };
    let mut wedge = cuboid([0; 3], [3; 3]);
    wedge.push(plane([3, 5, 7], 11));
    let solids = [wedge, cuboid([1, 1, 0], [2, 4, 1])].map(scale);
    let subdivision = divide(&solids);
    let sum: Rational = subdivision.leaves.iter().map(|leaf| leaf.cell.volume()).sum();
    assert_eq!(sum, volume_of_bounds(&subdivision));
    for leaf in &subdivision.leaves {
        let point = mean(leaf.cell.faces().iter().flat_map(|face| face.points()));
        let covered = solids.iter().any(|solid| place(solid, &point) != Sign::Positive);
        assert_eq!(leaf.solid, covered);
    }
}

#[test]
fn what_is_no_solid_is_left_out_or_refused() {
    let whole = cuboid([0; 3], [4; 3]);
    let flat = cuboid([1, 1, 1], [1, 2, 2]);
    let inverted = cuboid([3; 3], [2; 3]);
    let subdivision = divide(&[flat.clone(), whole.clone(), inverted]);
    assert_eq!(subdivision.flat, [0, 2]);
    let refused =
        |solids: &[Solid]| build(&around_solids(solids), &Options::default(), &Silent).unwrap_err();
    assert_eq!(refused(&[flat]), DivisionError::NothingToDivide);
    assert_eq!(refused(&[]), DivisionError::NothingToDivide);
    let open = whole[1..].to_vec();
    assert_eq!(refused(&[whole.clone(), open]), DivisionError::Unbounded { solid: 1 });
    let mut odd = whole;
    odd.push(plane([0; 3], 1));
    assert_eq!(refused(&[odd]), DivisionError::NoNormal { solid: 0, plane: 6 });
}

#[test]
fn solids_and_polygons_keep_every_law() {
    let (mut inside, mut between) = (0, 0);
    for seed in 1..150 {
        let random = &mut Random::new(seed);
        let occluders = random_occluders(random);
        let subdivision = build(&occluders, &Options::default(), &Silent).unwrap();
        let checked = subdivision.check(&occluders, false, 20, seed);
        let checked = checked.unwrap_or_else(|violation| panic!("seed {seed}: {violation}"));
        inside += checked.inside;
        between += checked.between;
        let thin = subdivision.nodes.iter().flat_map(|node| &node.faces).filter(|face| face.thin);
        assert!(
            occluders.polygons.is_empty()
                || !occluders.solids.is_empty()
                || thin.count() > 0
                || occluders.view.is_some()
        );
    }
    assert!(inside > 1000 && between > 100, "{inside} {between}");
}

#[test]
fn a_view_alone_is_one_empty_leaf_and_a_view_in_a_solid_a_solid_one() {
    let third = Rational::new(Int::from(1), Int::from(3));
    let view = Some(AxialBox {
        low: [(); 3].map(|()| third.clone()),
        high: [(); 3].map(|()| &third + Rational::from(Int::from(1))),
    });
    let alone = Occluders { view, ..Occluders::default() };
    let leaves = |occluders: &Occluders| {
        let subdivision = build(occluders, &Options::default(), &Silent).unwrap();
        subdivision.check(occluders, false, 20, 1).unwrap();
        assert_eq!(subdivision.leaves.len(), 1);
        assert_eq!(volume_of_bounds(&subdivision), Rational::from(Int::from(1)));
        subdivision.leaves[0].solid
    };
    assert!(!leaves(&alone));
    // Two solids whose common face is in the view, and a polygon inside of them.
    let solids = vec![cuboid([0; 3], [1, 2, 2]), cuboid([1, 0, 0], [2; 3])];
    let corners = [[0, 0, 1], [2, 0, 1], [2, 2, 1], [0, 2, 1]].map(whole);
    let buried = Occluders { solids, polygons: vec![corners.into()], ..alone.clone() };
    assert!(leaves(&buried));
    // Far away from the view.
    assert!(!leaves(&Occluders { solids: vec![cuboid([5; 3], [6; 3])], ..alone }));
}

#[test]
fn what_is_no_polygon_or_no_view_is_refused() {
    let refused = |points: &[[i64; 3]]| {
        let polygons = vec![points.iter().map(|&p| whole(p)).collect()];
        let occluders = Occluders { polygons, ..Occluders::default() };
        build(&occluders, &Options::default(), &Silent).unwrap_err()
    };
    let wrong = |error| DivisionError::Polygon { polygon: 0, error };
    assert_eq!(refused(&[[0, 0, 0], [1, 0, 0]]), wrong(PolygonError::Few(2)));
    let skew = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 1]];
    assert_eq!(refused(&skew), wrong(PolygonError::NotPlanar(3)));
    let straight = [[0, 0, 0], [1, 0, 0], [2, 0, 0], [0, 1, 0]];
    assert_eq!(refused(&straight), wrong(PolygonError::NotConvex(1)));
    let twice = [[0, 0, 0], [2, 0, 0], [2, 2, 0], [2, 2, 0]];
    assert!(matches!(refused(&twice), DivisionError::Polygon { .. }));
    // Round twice: each turn is convex, the whole is not.
    let star = [[0, 0, 0], [4, 1, 0], [0, 2, 0], [3, -1, 0], [3, 3, 0]];
    assert!(matches!(refused(&star), DivisionError::Polygon { .. }));
    let zero = Rational::from(Int::ZERO);
    let view =
        AxialBox { low: [(); 3].map(|()| zero.clone()), high: [(); 3].map(|()| zero.clone()) };
    let flat = Occluders { view: Some(view), ..Occluders::default() };
    assert_eq!(build(&flat, &Options::default(), &Silent).unwrap_err(), DivisionError::FlatView);
}

#[test]
fn every_round_keeps_the_laws() {
    let half = Rational::new(Int::from(1), Int::from(2));
    let options = Options {
        obscuration: Some(half.clone()),
        largest_volume: Some(Rational::new(Int::from(1), Int::from(30))),
        largest_aspect: Some(Rational::from(Int::from(4))),
        margin: Int::from(2),
        ..Options::default()
    };
    for seed in 1..40 {
        let occluders = random_occluders(&mut Random::new(seed));
        let plain = build(&occluders, &Options::default(), &Silent).unwrap();
        let subdivision = build(&occluders, &options, &Silent).unwrap();
        subdivision.check(&occluders, false, 10, seed).unwrap();
        let whole = volume_of_bounds(&subdivision);
        for leaf in subdivision.leaves.iter().filter(|leaf| !leaf.solid) {
            assert!(leaf.cell.volume() * Int::from(30) <= whole, "seed {seed}");
        }
        assert!(subdivision.leaves.len() > plain.leaves.len() / 2);
    }
}

#[test]
fn a_long_free_cell_falls_into_cells_of_the_aspect_asked_for() {
    let axis = |length: i64| Rational::from(Int::from(length));
    let view = AxialBox { low: [axis(0), axis(0), axis(0)], high: [axis(16), axis(2), axis(2)] };
    let occluders = Occluders { view: Some(view), ..Occluders::default() };
    let options = Options { largest_aspect: Some(axis(2)), ..Options::default() };
    let subdivision = build(&occluders, &options, &Silent).unwrap();
    subdivision.check(&occluders, false, 50, 3).unwrap();
    assert_eq!(subdivision.leaves.len(), 4);
}

#[test]
fn neighbours_and_the_faces_of_leaves_cover_every_face_of_every_cell() {
    for seed in 1..40 {
        let occluders = random_occluders(&mut Random::new(seed));
        let subdivision = build(&occluders, &Options::default(), &Silent).unwrap();
        let ends = subdivision.bounds.planes();
        let faces = subdivision.faces_of_leaves();
        let zero = || Rational::from(Int::ZERO);
        for leaf in subdivision.leaf_ids() {
            let neighbours = subdivision.neighbours(leaf);
            for face in subdivision.leaf(leaf).cell.faces() {
                if ends.contains(&face.support()) {
                    continue;
                }
                let along =
                    |area: [Rational; 3]| area.into_iter().map(|c| &c * &c).sum::<Rational>();
                let sum = neighbours
                    .iter()
                    .filter(|other| other.shared.support() == face.support())
                    .fold([zero(), zero(), zero()], |sum, other| {
                        let area = other.shared.doubled_area();
                        std::array::from_fn(|i| &sum[i] + &area[i])
                    });
                assert_eq!(along(sum), along(face.doubled_area()), "seed {seed} {leaf:?}");
            }
            for other in &neighbours {
                let back = subdivision.neighbours(other.leaf);
                assert!(back.iter().any(|back| back.leaf == leaf), "seed {seed} {leaf:?}");
                // Between solid and empty the whole boundary is occluded.
                let kinds = (subdivision.leaf(leaf).solid, subdivision.leaf(other.leaf).solid);
                if kinds == (false, true) {
                    let inner = mean(other.shared.points().into_iter());
                    let covered = faces[leaf.0 as usize].iter().any(|face| {
                        let cuts = face.polygon.cuts().map(|cut| subdivision.planes.get(cut));
                        face.polygon.support() == other.shared.support().flipped()
                            && cuts.map(|cut| side_of_point(cut, &inner)).max()
                                != Some(Sign::Positive)
                    });
                    assert!(covered, "seed {seed} {leaf:?}");
                }
            }
        }
    }
}

/// Whether a segment meets a polygon strictly between its ends and not in its plane. The edges of
/// the polygon count where the end is not seen edge-on.
fn meets(
    subdivision: &Subdivision,
    face: &Face,
    eye: &RationalPoint3,
    end: &RationalPoint3,
    edge_on: bool,
) -> bool {
    let plane = subdivision.planes.get(face.polygon.support());
    let value = |point: &RationalPoint3| -> Rational {
        let normal = plane.plane().normal.iter();
        let sum: Rational = normal.zip(point.coordinates()).map(|(n, c)| c * n).sum();
        sum - Rational::from(plane.plane().offset.clone())
    };
    let (a, b) = (value(eye), value(end));
    if Sign::of(&(&a * &b)) != Sign::Negative {
        return false;
    }
    let share = &a / (&a - &b);
    let (from, to) = (eye.coordinates(), end.coordinates());
    let at =
        RationalPoint3::from(&std::array::from_fn(|i| &from[i] + &share * (&to[i] - &from[i])));
    let cuts = face.polygon.cuts().map(|cut| subdivision.planes.get(cut));
    let place = cuts.map(|cut| side_of_point(cut, &at)).max().unwrap();
    place == Sign::Negative || place == Sign::Zero && !edge_on
}

#[test]
fn what_is_nearer_to_an_eye_is_painted_later() {
    let (mut pairs, mut in_planes) = (0, 0);
    for seed in 1..60 {
        let random = &mut Random::new(seed);
        let occluders = random_occluders(random);
        let subdivision = build(&occluders, &Options::default(), &Silent).unwrap();
        for round in 0..4 {
            let eye = random.point([1, 1, 2, 1000][round]);
            let order = subdivision.back_to_front(&eye);
            let leaves = order.iter().filter(|painted| matches!(painted, Painted::Leaf(_)));
            assert_eq!(leaves.count(), subdivision.leaves.len());
            let faces: Vec<&Face> = order
                .iter()
                .filter_map(|painted| match *painted {
                    Painted::Face { node, face } => {
                        Some(&subdivision.nodes[node as usize].faces[face as usize])
                    }
                    Painted::Leaf(_) => None,
                })
                .collect();
            let all: usize = subdivision.nodes.iter().map(|node| node.faces.len()).sum();
            assert_eq!(faces.len(), all);
            for (place, face) in faces.iter().enumerate() {
                let inner = mean(face.polygon.points().into_iter());
                let plane = subdivision.planes.get(face.polygon.support());
                let edge_on = side_of_point(plane, &eye) == Sign::Zero;
                in_planes += usize::from(edge_on);
                let nearer = |other: &Face| meets(&subdivision, other, &eye, &inner, edge_on);
                for before in &faces[..place] {
                    assert!(!nearer(before), "seed {seed}");
                }
                pairs += faces[place + 1..].iter().filter(|later| nearer(later)).count();
            }
        }
    }
    assert!(pairs > 1000 && in_planes > 100, "{pairs} {in_planes}");
}
