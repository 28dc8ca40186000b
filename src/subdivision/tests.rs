use super::{DivisionError, Options, Solid, Subdivision, build};
use crate::construct::mean;
use crate::geom::{BigPlane, RationalPoint3};
use crate::num::{Int, Rational, Sign};
use crate::predicates::{VertexPlane, side_of_point};

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

fn divide(solids: &[Solid]) -> Subdivision {
    build(solids, &[], &Options::default()).unwrap()
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
        let subdivision = build(&solids, &[], options).unwrap();
        let leaves = subdivision.leaves.iter().filter(|leaf| leaf.solid == solid);
        leaves.map(|leaf| leaf.cell.volume()).sum()
    };
    let usual = Options::default();
    let odd =
        Options { samples: 1, coplanar: -3, cut: -1, imbalance: 0, axial: -9, ..usual.clone() };
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
    let hint = (cuboid([-9, -9, -9], [2, 9, 9]), vec![true, false, false, false, false, false]);
    let plain = divide(&solids);
    let options = Options { margin: Int::from(1), ..Options::default() };
    let hinted = build(&solids, std::slice::from_ref(&hint), &options).unwrap();
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
    let refused = |solids: &[Solid]| build(solids, &[], &Options::default()).unwrap_err();
    assert_eq!(refused(&[flat]), DivisionError::NoSolid);
    assert_eq!(refused(&[]), DivisionError::NoSolid);
    let open = whole[1..].to_vec();
    assert_eq!(refused(&[whole.clone(), open]), DivisionError::Unbounded { solid: 1 });
    let mut odd = whole;
    odd.push(plane([0; 3], 1));
    assert_eq!(refused(&[odd]), DivisionError::NoNormal { solid: 0, plane: 6 });
}
