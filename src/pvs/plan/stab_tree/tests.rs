use super::super::tests::{cells, plan};
use super::*;
use crate::num::Rational;
use crate::num::{Int, Sign};
use crate::oracle::{Door, Flat, Random, flat_pairs};
use crate::predicates::{PlanPoint, turn_of_points};
use crate::report::Silent;
use crate::scene::plan::PlanPortal;
use std::sync::atomic::{AtomicU32, Ordering::Relaxed};

/// Random walls: general or axial, on grids so small that nearly everything touches, or larger.
pub(in super::super) fn walls(random: &mut Random, round: usize) -> Vec<[[i64; 2]; 2]> {
    let size = [2, 3, 4, 9][round % 4];
    let count = random.between(1, if size > 4 { 7 } else { 5 });
    let mut walls = Vec::new();
    while walls.len() < count as usize {
        let mut ends = [(); 2].map(|()| [(); 2].map(|()| random.between(0, size)));
        if (round / 4).is_multiple_of(2) {
            let axis = random.between(0, 1) as usize;
            ends[1][axis] = ends[0][axis];
        }
        if ends[0] != ends[1] {
            walls.push(ends);
        }
    }
    walls
}

pub(in super::super) fn flat(graph: &PlanGraph) -> Flat {
    let point = |&end: &u32| graph.points.get(end).coordinates();
    let door = |portal: &PlanPortal| Door {
        cells: [portal.from, portal.to].map(|cell| cell.0 as usize),
        ends: [portal.left, portal.right].each_ref().map(point),
    };
    Flat {
        cells: graph.polygons.iter().map(|cell| cell.iter().map(point).collect()).collect(),
        doors: graph.portals.iter().map(door).collect(),
    }
}

fn all_cells(graph: &PlanGraph) -> Vec<CellId> {
    (0..graph.cells.len() as u32).map(CellId).collect()
}

fn trees(graph: &PlanGraph, wants_lines: bool) -> Vec<PlanStabTree> {
    let sources = all_cells(graph);
    plan_stab_trees(graph, &graph.crossings(), &sources, wants_lines, &Silent).unwrap()
}

/// The portals of each node's sequence, sorted.
fn sequences(nodes: impl IntoIterator<Item = (Option<u32>, u32)>) -> Vec<Vec<u32>> {
    let mut all: Vec<Vec<u32>> = Vec::new();
    for (parent, portal) in nodes {
        let mut sequence = parent.map_or(Vec::new(), |parent| all[parent as usize].clone());
        sequence.push(portal);
        all.push(sequence);
    }
    all.sort();
    all
}

#[test]
fn trees_see_the_cells_that_the_twin_sees() {
    let mut random = Random::new(23);
    let mut counts = [0; 2];
    for round in 0..160 {
        let walls = walls(&mut random, round);
        let graph = cells(&plan(&walls)).graph;
        if graph.cells.len() > 16 {
            continue;
        }
        let expected = flat_pairs(&flat(&graph));
        for (tree, expected) in trees(&graph, false).iter().zip(expected) {
            let seen = tree.cells();
            for cell in all_cells(&graph) {
                let is_seen = seen.contains(&cell);
                counts[usize::from(is_seen)] += 1;
                let label = format!("{:?} and {cell:?} of {walls:?}", tree.source);
                assert_eq!(is_seen, expected[cell.0 as usize], "{label}");
            }
        }
    }
    assert!(counts.iter().all(|&count| count > 300), "{counts:?}");
}

#[test]
fn trees_in_space_have_the_same_sequences() {
    let mut random = Random::new(29);
    for round in 0..60 {
        let walls = walls(&mut random, round);
        let graph = cells(&plan(&walls)).graph;
        let space = graph.in_space();
        let expected = crate::pvs::stab_trees(&space, &all_cells(&graph), &Silent).unwrap();
        for (tree, expected) in trees(&graph, false).iter().zip(expected) {
            let nodes = tree.nodes.iter().map(|node| (node.parent, node.portal));
            let others = expected.nodes.iter().map(|node| (node.parent, node.portal));
            assert_eq!(sequences(nodes), sequences(others), "{:?} of {walls:?}", tree.source);
        }
    }
}

#[test]
fn ends_beyond_the_others_need_not_be_looked_for_elsewhere() {
    let mut random = Random::new(31);
    for round in 0..400 {
        let graph = cells(&plan(&walls(&mut random, round))).graph;
        let (crossings, n) = (graph.crossings(), graph.cells.len());
        let [mut beyond, mut anywhere] = [Place::Beyond, Place::Anywhere]
            .map(|place| Walk::new(&graph.points, &crossings, n, place));
        for source in all_cells(&graph) {
            let mut paths = [Vec::new(), Vec::new()];
            for (walk, paths) in [&mut beyond, &mut anywhere].into_iter().zip(&mut paths) {
                walk.from(source, None, &Silent, &mut |path| paths.push(path.to_vec())).unwrap();
            }
            assert_eq!(paths[0], paths[1], "{source:?} of round {round}");
        }
    }
}

#[test]
fn lines_pass_their_sequences_and_sizes_are_those_of_the_trees() {
    let mut random = Random::new(37);
    for round in 0..60 {
        let graph = cells(&plan(&walls(&mut random, round))).graph;
        let (crossings, sources) = (graph.crossings(), all_cells(&graph));
        let sizes = plan_tree_sizes(&graph, &crossings, &sources, &Silent).unwrap();
        for (tree, size) in trees(&graph, true).iter().zip(sizes) {
            assert_eq!(tree.lines.len(), tree.nodes.len());
            let entered = tree.cells().len() as u32 - 1;
            assert_eq!((tree.source, entered), (size.source, size.cells));
            assert_eq!(tree.nodes.len() as u64, size.nodes);
            let mut depths: Vec<u32> = Vec::new();
            for (number, node) in tree.nodes.iter().enumerate() {
                depths.push(1 + node.parent.map_or(0, |parent| depths[parent as usize]));
                check_line(&graph, tree, number as u32);
            }
            assert_eq!(depths.iter().max().copied().unwrap_or(0), size.depth);
        }
    }
}

/// The node's line has its portals' ends on the right sides, and leads from the source.
fn check_line(graph: &PlanGraph, tree: &PlanStabTree, node: u32) {
    let grid = Rational::from(graph.grid.clone());
    let [from, to] = tree.lines[node as usize].each_ref().map(|point| {
        PlanPoint::from_coordinates(&point.each_ref().map(|c| c.to_rational() * &grid))
    });
    let mut next = Some(node);
    while let Some(number) = next {
        let node = &tree.nodes[number as usize];
        let before = node.parent.map_or(tree.source, |parent| tree.nodes[parent as usize].cell);
        let portal = graph.portals[node.portal as usize];
        let [left, right] = match portal.to == node.cell {
            true => [portal.left, portal.right],
            false => [portal.right, portal.left],
        };
        let cells = [portal.from, portal.to];
        assert!(before != node.cell && cells.contains(&before) && cells.contains(&node.cell));
        let side = |end| turn_of_points(&from, &to, graph.points.get(end));
        assert_eq!([side(left), side(right)], [Sign::Positive, Sign::Negative]);
        next = node.parent;
    }
}

/// Square rooms in a row, all open to each other.
fn corridor(length: i64) -> PlanGraph {
    let mut graph = PlanGraph { grid: Int::from(1), ..PlanGraph::default() };
    let ends: Vec<[u32; 2]> = (0..=length)
        .map(|x| [0, 1].map(|y| graph.points.insert(PlanPoint::integer([x, y].map(Int::from)))))
        .collect();
    for pair in ends.windows(2) {
        let [[a, d], [b, c]] = [pair[0], pair[1]];
        graph.cells.push(graph.polygons.len().to_string());
        graph.polygons.push(vec![a, b, c, d]);
    }
    for cell in 1..length as u32 {
        let [right, left] = ends[cell as usize];
        graph.portals.push(PlanPortal { from: CellId(cell - 1), to: CellId(cell), left, right });
    }
    graph
}

#[test]
fn a_corridor_of_ten_thousand_rooms_is_no_deep_recursion() {
    let graph = corridor(10_000);
    let crossings = graph.crossings();
    let sources = [CellId(0), CellId(5000)];
    let sizes = plan_tree_sizes(&graph, &crossings, &sources, &Silent).unwrap();
    let expected = |source, depth| PlanTreeSize { source, nodes: 9999, depth, cells: 9999 };
    assert_eq!(sizes, [expected(CellId(0), 9999), expected(CellId(5000), 5000)]);
}

/// Interrupts at the n-th question.
struct Impatient(AtomicU32);

impl Progress for Impatient {
    fn begin(&self, _: &str, _: u64) {}
    fn advance(&self, _: u64) {}
    fn is_interrupted(&self) -> bool {
        self.0.fetch_add(1, Relaxed) >= 3
    }
}

#[test]
fn an_interrupt_ends_the_search() {
    let graph = corridor(10_000);
    let impatient = Impatient(AtomicU32::new(0));
    let crossings = graph.crossings();
    assert_eq!(plan_tree_sizes(&graph, &crossings, &[CellId(0)], &impatient), None);
    assert!(impatient.0.load(Relaxed) < 6);
}
