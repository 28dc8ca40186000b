//! The derived ranges at their extremes: brute force over the corners of the box.

use super::*;

/// The bound of a range on a grid of `bits`.
fn limit(range: &Range, bits: u32) -> Int {
    Int::from(1) << (range.slope * bits + range.constant)
}

/// Every point whose coordinates are all ±2^bits.
fn corners(bits: u32) -> Vec<Point3> {
    let c = 1i64 << bits;
    let sign = |i: u32, k: u32| if i >> k & 1 == 0 { -c } else { c };
    (0..8).map(|i| Point3::new(sign(i, 0), sign(i, 1), sign(i, 2)).unwrap()).collect()
}

#[test]
fn values_of_four_corners_stay_within_their_ranges() {
    for bits in [0, 16, 24, 33, 40, 53] {
        let mut largest = [const { Int::ZERO }; 4];
        let corners = corners(bits);
        for n in 0..4096usize {
            let p: [Point3; 4] = std::array::from_fn(|i| corners[n >> (3 * i) & 7]);
            let [a, b, c, d] = &big(p).map(|p| p.coordinates);
            let (x, y) = (difference(b, a), difference(d, c));
            let (m, n) = (cross(a, b), cross(c, d));
            let values = [
                x[0].clone() * (&c[1] - &a[1]) - &x[1] * (&c[0] - &a[0]),
                determinant(a, b, c, d),
                dot(&x, &n) + dot(&m, &y),
                dot(&x, &y),
            ];
            for (largest, value) in largest.iter_mut().zip(values) {
                *largest = value.abs().max(largest.clone());
            }
        }
        let ranges = [ORIENT2D, ORIENT3D, SIDE_OF_LINES, COMPARE_ALONG_LINE];
        for (range, largest) in ranges.iter().zip(&largest) {
            assert!(*largest < limit(range, bits), "{} at {bits} bits", range.predicate);
            // The constants are not wasteful either: within four bits of what occurs.
            assert!(*largest > limit(range, bits) >> 4, "{} at {bits} bits", range.predicate);
        }
        // The values are known: the largest triangle and tetrahedron of a square and a cube.
        let edge = Int::from(1) << (bits + 1);
        assert_eq!(largest[0], edge.pow(2));
        assert_eq!(largest[1], edge.pow(3) * 2);
    }
}

#[test]
fn planes_of_three_corners_stay_within_their_ranges() {
    for bits in [0, 16, 24, 33, 40] {
        let corners = corners(bits);
        for n in 0..512usize {
            let [a, b, c] = std::array::from_fn(|i| corners[n >> (3 * i) & 7]);
            let plane = Plane::through(&a, &b, &c).unwrap();
            // Affine in every coordinate, so extreme at corners: this proves the true maxima.
            assert!(plane.normal().iter().all(|n| n.abs() <= 1 << (2 * bits + 2)));
            assert!(plane.offset().abs() <= 1 << (3 * bits + 2));
            let large = BigPlane::from(plane);
            for v in &corners {
                let [v] = big([*v]);
                let value = dot(&large.normal, &v.coordinates) - &large.offset;
                assert!(value.abs() < limit(&SIDE_OF_PLANE, bits));
            }
        }
    }
}

/// The planes' true extremes are below the bounds of their parts; the widths must hold even for
/// what the bounds allow, so the widest grid of each width is tried at its corners in a build
/// that checks every overflow.
#[test]
fn meets_of_corner_planes_stay_within_their_ranges() {
    let mut random = Random(1);
    for bits in [0, 24, 25, 26, 33, 34, 40] {
        let budget = Budget::for_bits(bits);
        let corners = corners(bits);
        for _ in 0..3000 {
            let p: [Point3; 12] = [(); 12].map(|()| corners[random.within(0, 7) as usize]);
            check_planes(&p, &budget);
            let (_, [e, f, g, h]) = &planes(&p);
            let value = meets::side_of_meets_big_value([e, f], [g, h]);
            assert!(value.abs() < limit(&SIDE_OF_MEETS, bits));
            let normals = dot(&cross(&e.normal, &f.normal), &g.normal);
            assert!(normals.abs() < Int::from(1) << (6 * bits + 12));
            let [q, r] = &big([p[0], p[1]]).map(|p| p.coordinates);
            let d = difference(r, q);
            let rise = |plane: &BigPlane| &plane.offset - dot(&plane.normal, q);
            let run = |plane: &BigPlane| dot(&plane.normal, &d);
            let value = rise(g) * run(h) - rise(h) * run(g);
            assert!(value.abs() < limit(&COMPARE_CROSSINGS, bits));
        }
    }
}

#[test]
fn the_widest_grids_of_each_width_are_as_documented() {
    let widest = |width: u32| RANGES.map(|range| range.largest_grid(width));
    assert_eq!(widest(64), [30, 19, 19, 19, 4, 4, 29, 8, 3, 2, 0]);
    assert_eq!(widest(128), [62, 40, 40, 40, 12, 12, 61, 19, 8, 6, 2]);
    assert_eq!(widest(256), [126, 83, 83, 83, 26, 26, 125, 40, 19, 15, 7]);
    assert_eq!(widest(320), [158, 104, 104, 104, 33, 33, 157, 51, 24, 19, 10]);
}

#[test]
fn budgets_hold_their_points() {
    let point = |x: i64| Point3::new(x, 0, -1).unwrap();
    for (x, bits) in [(0, 0), (1, 0), (2, 1), (3, 2), (4, 2), (5, 3), (1 << 53, 53)] {
        let budget = Budget::of_points(&[point(x)]);
        assert_eq!(budget.bits(), bits);
        assert!(budget.holds(&point(x)) && budget.holds(&point(-x)));
    }
    assert_eq!(Budget::for_bits(99).bits(), 53);
    assert!(!Budget::for_bits(3).holds(&point(9)));
}
