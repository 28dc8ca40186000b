//! The k-D tree against §2.3 taken literally.

use super::laws::check_laws;
use super::naive::Tree;
use super::*;
use crate::scene::plan::{FloorplanOptions, generate_floorplan};

fn divided(plan: &Plan, threshold: i64) -> PlanTree {
    divide(plan, &kd(threshold), &Silent).unwrap()
}

/// The tree as splits and leaves, low child first, in one list.
fn shape(tree: &PlanTree) -> Vec<[i64; 4]> {
    let integers = |point: u32| tree.points.get(point).small_integers().unwrap();
    let (mut shape, mut stack) = (Vec::new(), vec![tree.root]);
    while let Some(branch) = stack.pop() {
        match branch {
            Branch::Node(node) => {
                let PlanNode { line, left, right } = tree.nodes[node as usize];
                let [p, q] = tree.lines.through(line).map(integers);
                let dimension = usize::from(p[0] != q[0]);
                shape.push([-1, -1, dimension as i64, p[dimension]]);
                stack.extend([left, right]);
            }
            Branch::Leaf(leaf) => {
                let corners: Vec<_> =
                    tree.leaves[leaf as usize].polygon.iter().map(|&p| integers(p)).collect();
                assert_eq!(corners.len(), 4);
                let range = |d: usize| {
                    let all = corners.iter().map(|corner| corner[d]);
                    (all.clone().min().unwrap(), all.max().unwrap())
                };
                let ((x0, x1), (y0, y1)) = (range(0), range(1));
                shape.push([x0, y0, x1, y1]);
            }
        }
    }
    shape
}

/// The same of the literal tree, and what is left inside of its leaves.
fn naive_shape(tree: &Tree) -> (Vec<[i64; 4]>, Vec<u32>) {
    let (mut shape, mut left) = (Vec::new(), Vec::new());
    let mut stack = vec![tree];
    while let Some(tree) = stack.pop() {
        match tree {
            Tree::Split { dimension, at, children } => {
                shape.push([-1, -1, *dimension as i64, *at]);
                let [low, high] = children.as_ref();
                stack.extend([high, low]);
            }
            Tree::Leaf { extents: [[x0, x1], [y0, y1]], left_inside } => {
                shape.push([*x0, *y0, *x1, *y1]);
                left.extend(left_inside.iter().map(|&face| face as u32));
            }
        }
    }
    left.sort_unstable();
    left.dedup();
    (shape, left)
}

#[test]
fn the_tree_is_that_of_the_paper_taken_literally() {
    let mut splits = 0;
    for seed in 0..400 {
        let random = &mut Random::new(seed);
        let count = random.between(1, 40);
        let reach = [4, 12, 60][random.between(0, 2) as usize];
        let segments = axial(random, count, reach);
        let view = match random.one_in(3) {
            true => [[reach / 4; 2], [reach - 1; 2]],
            false => [[-1; 2], [reach + 2; 2]],
        };
        let plan = plan_in(&segments, Some(view));
        let [low, high] = view;
        for threshold in [0, 1, reach / 2, 2 * reach] {
            let tree = divided(&plan, threshold);
            let extents = [[low[0], high[0]], [low[1], high[1]]];
            let naive = super::naive::tree(&segments, extents, threshold);
            let (expected, left) = naive_shape(&naive);
            assert_eq!(shape(&tree), expected, "seed {seed}, threshold {threshold}");
            assert_eq!(tree.left_inside, left, "seed {seed}, threshold {threshold}");
            splits += tree.nodes.len();
        }
        if seed % 8 == 0 {
            let tree = divided(&plan, 0);
            assert!(tree.left_inside.is_empty());
            check_laws(&plan, &tree);
        }
    }
    assert!(splits > 10_000, "{splits}");
}

#[test]
fn faces_are_classified_as_the_paper_says() {
    let cell = Extents([[0, 10], [0, 6]]);
    let class = |dimension, at, span| classify(&AxialFace { dimension, at, span }, &cell);
    let vertical = |x, span| class(0, x, span);
    let horizontal = |y, span| class(1, y, span);
    use FaceClass::{Covering, Disjoint, Incident, Spanning};
    let cases = [
        // From edge to edge, exactly and beyond.
        (vertical(5, [0, 6]), Spanning),
        (vertical(5, [-3, 9]), Spanning),
        (horizontal(3, [0, 10]), Spanning),
        // Inside, from one edge, and from outside across one edge.
        (vertical(5, [1, 5]), Incident),
        (vertical(5, [0, 5]), Incident),
        (vertical(5, [-9, 1]), Incident),
        (horizontal(3, [9, 20]), Incident),
        // On the boundary: all of an edge, more, a part, up to a corner, both edges of a dimension.
        (vertical(0, [0, 6]), Covering),
        (vertical(10, [-1, 7]), Covering),
        (vertical(0, [2, 3]), Covering),
        (horizontal(6, [-4, 1]), Covering),
        (horizontal(0, [9, 30]), Covering),
        // On the line of an edge, as far as its corner or not that far.
        (vertical(0, [6, 8]), Disjoint),
        (vertical(10, [-5, 0]), Disjoint),
        (horizontal(6, [11, 12]), Disjoint),
        // From outside: ends on an edge, ends on a corner, ends before.
        (vertical(5, [6, 9]), Disjoint),
        (vertical(5, [-2, 0]), Disjoint),
        (horizontal(3, [10, 11]), Disjoint),
        (horizontal(3, [-7, -1]), Disjoint),
        // Beside.
        (vertical(-1, [0, 6]), Disjoint),
        (vertical(11, [-9, 9]), Disjoint),
        (horizontal(7, [0, 10]), Disjoint),
    ];
    for (number, (class, expected)) in cases.into_iter().enumerate() {
        assert_eq!(class, expected, "case {number}");
    }
}

#[test]
fn the_median_spanning_face_splits_whatever_the_threshold() {
    let across = [3, 4, 9].map(|x| [[x, 0], [x, 10]]);
    let walls = [across.as_slice(), &[[[0, 0], [0, 10]], [[20, 2], [15, 2]]]].concat();
    let tree = divided(&plan(&walls), 100);
    assert_eq!(shape(&tree)[0], [-1, -1, 0, 4]);
    assert_eq!(tree.leaves.len(), 4);
    // The short one ends inside, and no line of 5 units splits.
    assert_eq!(tree.left_inside, [4]);
    assert_eq!(divided(&plan(&walls), 5).left_inside, [4]);
    assert!(divided(&plan(&walls), 4).left_inside.is_empty());
}

#[test]
fn the_threshold_is_a_ratio_of_world_units() {
    let half = |text: &str| Number::parse(text).unwrap();
    let segment = |[x, y, z, w]: [&str; 4]| RawSegment {
        ends: [[half(x), half(y)], [half(z), half(w)]],
        is_opaque: true,
    };
    let segments = vec![segment(["0", "0", "1", "0"]), segment(["1/2", "0", "1/2", "1/3"])];
    let view = Some([["0", "0"], ["1", "1"]].map(|corner| corner.map(half)));
    let plan = Plan::from_raw(&RawPlan { segments, view, ..RawPlan::default() }).unwrap();
    let left = |p: i64, q: i64| {
        let threshold = Rational::new(p.into(), q.into());
        divide(&plan, &PlanMethod::Kd { threshold }, &Silent).unwrap().left_inside
    };
    assert_eq!(left(1, 3), [1]);
    assert!(left(33, 100).is_empty());
    assert_eq!(left(34, 100), [1]);
}

#[test]
fn a_slanted_segment_is_named() {
    let walls = plan(&[[[0, 0], [0, 0]], [[0, 0], [9, 0]], [[1, 1], [3, 2]]]);
    let error = divide(&walls, &kd(0), &Silent).unwrap_err();
    assert_eq!(error, PlanDivisionError::NotAxial { segment: 2 });
    assert!(error.to_string().starts_with("segments[2]: "), "{error}");
}

#[test]
fn far_coordinates_are_ranked_exactly() {
    let far = 1 << 59;
    let moved = |walls: &[Ends]| -> Vec<Ends> {
        walls.iter().map(|ends| ends.map(|end| end.map(|c| c + far))).collect()
    };
    for seed in 0..20 {
        let walls = axial(&mut Random::new(seed), 30, 9);
        let near = shape(&divided(&plan(&walls), 0));
        let away = shape(&divided(&plan(&moved(&walls)), 0));
        let back = |[a, b, c, d]: [i64; 4]| match a {
            -1 => [a, b, c, d - far],
            _ => [a, b, c, d].map(|c| c - far),
        };
        assert_eq!(away.into_iter().map(back).collect::<Vec<_>>(), near, "seed {seed}");
    }
}

#[test]
fn a_building_of_a_thousand_faces_has_about_seven_hundred_cells() {
    for seed in 1..4 {
        let options = FloorplanOptions { faces: 1000, seed, is_general: false };
        let plan = Plan::from_raw(&generate_floorplan(&options)).unwrap();
        let tree = divided(&plan, 0);
        assert!((600..800).contains(&tree.leaves.len()), "{} cells", tree.leaves.len());
        assert!(tree.depth() < 40, "depth {}", tree.depth());
    }
}
