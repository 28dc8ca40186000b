//! What holds of every subdivision, checked in rationals without the crate's predicates.

use super::*;
use num_traits::{Signed, Zero};

type Point = [Rational; 2];

/// Twice the area of the triangle, positive if it turns left.
fn turn(a: &Point, b: &Point, c: &Point) -> Rational {
    (&b[0] - &a[0]) * (&c[1] - &a[1]) - (&b[1] - &a[1]) * (&c[0] - &a[0])
}

fn corners(tree: &PlanTree, leaf: &PlanLeaf) -> Vec<Point> {
    leaf.polygon.iter().map(|&corner| tree.points.get(corner).coordinates()).collect()
}

/// Checks that the leaves are convex and tile the box, that their edges lie on their lines, that
/// no segment but those listed meets an inside, and that points are found in their leaves.
pub(super) fn check_laws(plan: &Plan, tree: &PlanTree) {
    let mut area = Rational::default();
    let mut is_inside = vec![false; plan.segments.len()];
    for (number, leaf) in tree.leaves.iter().enumerate() {
        let polygon = corners(tree, leaf);
        check_polygon(tree, leaf, &polygon);
        for i in 2..polygon.len() {
            area += turn(&polygon[0], &polygon[i - 1], &polygon[i]);
        }
        for (segment, is_inside) in plan.segments.iter().zip(&mut is_inside) {
            let ends = segment.ends.map(|end| plan.points.get(end).coordinates());
            *is_inside |= meets_inside(&ends, &polygon);
        }
        check_locate(tree, number as u32, &polygon);
    }
    let [low, high] = [0, 2].map(|i| plan.points.get(plan.bounds[i]).coordinates());
    let whole = (&high[0] - &low[0]) * (&high[1] - &low[1]);
    assert_eq!(area, whole * Rational::from(Int::from(2)), "the leaves tile the box");
    let inside: Vec<u32> =
        (0..plan.segments.len() as u32).filter(|&i| is_inside[i as usize]).collect();
    assert_eq!(inside, tree.left_inside, "no segment is in a leaf but those listed");
}

fn check_polygon(tree: &PlanTree, leaf: &PlanLeaf, polygon: &[Point]) {
    let n = polygon.len();
    assert!(n >= 3);
    for i in 0..n {
        let [p, q, r] = [0, 1, 2].map(|k| &polygon[(i + k) % n]);
        assert!(turn(p, q, r).is_positive(), "strictly convex, counter-clockwise");
        let EdgeLine { line, is_left } = leaf.edges[i];
        let [a, b] = tree.lines.through(line).map(|end| tree.points.get(end).coordinates());
        assert!(turn(&a, &b, p).is_zero() && turn(&a, &b, q).is_zero(), "on its line");
        assert_eq!(turn(&a, &b, r).is_positive(), is_left);
    }
}

/// Whether a segment meets the inside of a convex polygon: by clipping it, as a range of its
/// parameter from 0 to 1.
pub(super) fn meets_inside([p, q]: &[Point; 2], polygon: &[Point]) -> bool {
    let one = Rational::from(Int::from(1));
    let (mut low, mut high) = (Rational::default(), one);
    for (i, a) in polygon.iter().enumerate() {
        let b = &polygon[(i + 1) % polygon.len()];
        let (at_p, at_q) = (turn(a, b, p), turn(a, b, q));
        let slope = &at_q - &at_p;
        if slope.is_zero() {
            if !at_p.is_positive() {
                return false;
            }
            continue;
        }
        let root = -&at_p / &slope;
        if slope.is_positive() {
            low = low.max(root);
        } else {
            high = high.min(root);
        }
    }
    low < high
}

/// Every point of the inside is found in the leaf; a corner is found in a leaf that it touches.
fn check_locate(tree: &PlanTree, number: u32, polygon: &[Point]) {
    let count = Rational::from(Int::from(polygon.len() as i64));
    let sum = |d: usize| polygon.iter().map(|p| &p[d]).sum::<Rational>() / &count;
    let middle = [sum(0), sum(1)];
    assert_eq!(tree.locate(&PlanPoint::from_coordinates(&middle)), number);
    for (i, corner) in polygon.iter().enumerate() {
        let next = &polygon[(i + 1) % polygon.len()];
        let half = Rational::new(1.into(), 2.into());
        let on_edge = [0, 1].map(|d| (&corner[d] + &next[d]) * &half);
        for point in [corner, &on_edge] {
            check_boundary(tree, point);
        }
    }
}

/// A point on split lines is found on the left side of each of them that the search meets, the
/// greater one where it is axial.
fn check_boundary(tree: &PlanTree, point: &Point) {
    let found = tree.locate(&PlanPoint::from_coordinates(point));
    let leaf = &tree.leaves[found as usize];
    let polygon = corners(tree, leaf);
    for (i, edge) in leaf.edges.iter().enumerate() {
        let side = turn(&polygon[i], &polygon[(i + 1) % polygon.len()], point);
        assert!(!side.is_negative(), "a point is found in a leaf that it touches");
        // On an edge to whose line's right the leaf lies, only at the end of the box.
        if side.is_zero() && !edge.is_left {
            assert!(is_on_box(tree, edge.line), "half-open: the line belongs to its left side");
        }
    }
}

/// Whether no node splits along the line: it is then one of the box's.
fn is_on_box(tree: &PlanTree, line: u32) -> bool {
    tree.nodes.iter().all(|node| node.line != line)
}
