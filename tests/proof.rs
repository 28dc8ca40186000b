//! Every proof that is made is accepted by the checker, which shares nothing with the prover.

mod support;

use stabline::report::graph_text;
use stabline::scene::{self, PortalGraph};
use stabline::verify::{Verified, verify};
use support::graphs::{Family, Graph};
use support::proofs::proof;

/// What the checker says of a graph's proof.
fn checked(graph: &PortalGraph, with_grazing: bool, name: &str) -> Verified {
    let text = proof(graph, with_grazing);
    assert!(text.contains(&graph_text(graph)), "{name}: the proof states its graph");
    let verified = verify(text.as_bytes());
    let verified = verified.unwrap_or_else(|flaw| {
        panic!("{name}: {flaw}: {:?}", text.lines().nth(flaw.0 as usize - 1))
    });
    let cells = graph.cells.len();
    assert_eq!(verified.pairs.iter().sum::<usize>(), cells * (cells - 1) / 2, "{name}");
    assert_eq!(verified.pairs[3], 0, "{name}: nothing is undecided");
    verified
}

fn read(path: &std::path::Path) -> PortalGraph {
    let bytes = std::fs::read(path).expect("a scene that is there");
    scene::read_graph(&path.display().to_string(), &bytes).expect("a graph")
}

#[test]
fn scenes() {
    for path in support::scenes("scenes/pvs") {
        let graph = read(&path);
        let name = path.display().to_string();
        let open = checked(&graph, false, &name);
        let classified = checked(&graph, true, &name);
        assert_eq!(open.pairs[2], classified.pairs[2], "{name}");
        assert_eq!(open.pairs[0], classified.pairs[0] + classified.pairs[1], "{name}");
        if name.contains("_grazing") {
            assert!(classified.pairs[1] > 0, "{name}");
        }
    }
}

#[test]
fn random_graphs() {
    for family in Family::ALL {
        let mut total = Verified::default();
        for seed in 0..60 {
            let graph = Graph::random(family, 9000 + seed).validated();
            let verified = checked(&graph, graph.portals.len() < 8, &format!("{family:?} {seed}"));
            total.pairs.iter_mut().zip(verified.pairs).for_each(|(sum, n)| *sum += n);
            total.nodes.iter_mut().zip(verified.nodes).for_each(|(sum, n)| *sum += n);
        }
        println!("{family:?}: {total:?}");
        assert!(total.pairs[0] > 0 && total.pairs[2] > 0, "{family:?}");
    }
}

#[test]
fn real_maps() {
    let Some(maps) = support::maps() else {
        println!("skipped: the shared maps are not here");
        return;
    };
    for (name, nodes) in [("lqdm1", 5000), ("lq_e0m1", 5000)] {
        let graph = read(&maps.join(name).join(format!("{name}.prt")));
        let verified = checked(&graph, false, name);
        println!("{name}: {verified:?}");
        assert!(verified.nodes[0] > nodes, "{name}");
    }
}

#[test]
fn the_checker_can_be_read_in_one_sitting() {
    let sources = support::scenes("src/verify");
    let lines = |path: &std::path::PathBuf| std::fs::read_to_string(path).unwrap().lines().count();
    let total: usize = sources.iter().map(lines).sum();
    assert!(total < 600, "{total} lines");
    for path in &sources {
        let text = std::fs::read_to_string(path).unwrap();
        assert!(!text.contains("crate::"), "{}: nothing of the engine", path.display());
    }
}
