//! Every scene of cell-to-cell visibility: the twin's verdicts against snapshots, and the engine
//! against the twin.
//!
//! The twin walks all sequences that enter no cell twice and judges each by the definition
//! (`oracle::classify`), without filters, cones or bounds.

mod support;

use stabline::geom::RationalPoint3;
use stabline::oracle::{Truth, classify, on_common_grid};
use stabline::pvs::{Options, assemble, compute};
use stabline::report::{Silent, Verdict};
use stabline::scene::{CellId, PortalGraph, read_graph};
use std::fmt::Write;
use std::path::Path;
use support::{root, scenes};

/// What the twin says of a pair, the better the greater.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Sight {
    Blocked,
    Grazing,
    Open,
}

struct Twin<'a> {
    graph: &'a PortalGraph,
    sequence: Vec<Vec<RationalPoint3>>,
    entered: Vec<bool>,
    sights: Vec<Sight>,
}

impl Twin<'_> {
    fn sights(graph: &PortalGraph, source: CellId) -> Vec<Sight> {
        let cells = graph.cells.len();
        let mut twin = Twin {
            graph,
            sequence: Vec::new(),
            entered: vec![false; cells],
            sights: vec![Sight::Blocked; cells],
        };
        twin.enter(source, Sight::Open);
        twin.sights
    }

    fn enter(&mut self, cell: CellId, sight: Sight) {
        let index = cell.0 as usize;
        self.sights[index] = self.sights[index].max(sight);
        self.entered[index] = true;
        for portal in &self.graph.portals {
            let mut corners: Vec<RationalPoint3> = self.graph.corners(portal).cloned().collect();
            let next = if portal.from == cell {
                portal.to
            } else if portal.to == cell {
                corners.reverse();
                portal.from
            } else {
                continue;
            };
            if self.entered[next.0 as usize] {
                continue;
            }
            self.sequence.push(corners);
            let sequence: Vec<&[RationalPoint3]> =
                self.sequence.iter().map(Vec::as_slice).collect();
            match classify(&on_common_grid(&sequence).1) {
                Truth::Open(_) => self.enter(next, Sight::Open),
                Truth::Grazing(_) => self.enter(next, Sight::Grazing),
                // More portals let no more lines through.
                Truth::Blocked => {}
            }
            self.sequence.pop();
        }
        self.entered[index] = false;
    }
}

fn graph(path: &Path) -> PortalGraph {
    read_graph(&path.to_string_lossy(), &std::fs::read(path).unwrap()).unwrap()
}

fn about(path: &Path) -> String {
    let scene: serde_json::Value = serde_json::from_slice(&std::fs::read(path).unwrap()).unwrap();
    scene["about"].as_str().unwrap().to_owned()
}

#[test]
fn scenes_match_their_snapshots_and_the_engine_agrees() {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(root().join("snapshots/pvs"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    for path in scenes("scenes/pvs") {
        let graph = graph(&path);
        let rows = compute(&graph, &Options::default(), Vec::new(), &|_| {}, &Silent).rows;
        let matrix = assemble(&graph, &rows);
        let mut text =
            format!("cells {}, skew portals {}\n", graph.cells.len(), graph.skew_portals);
        for (a, from) in graph.cells.iter().enumerate() {
            for (b, &sight) in Twin::sights(&graph, CellId(a as u32)).iter().enumerate() {
                let to = &graph.cells[b];
                let expected = if sight == Sight::Open { Verdict::Open } else { Verdict::NotOpen };
                assert_eq!(matrix.get(a, b), expected, "{}: {from} -> {to}", path.display());
                if a < b {
                    let verdict = match sight {
                        Sight::Open => "open",
                        Sight::Grazing => "grazing",
                        Sight::Blocked => "blocked",
                    };
                    writeln!(text, "{from} - {to}: {verdict}").unwrap();
                }
            }
        }
        settings.set_description(about(&path));
        let name = path.file_stem().unwrap().to_str().unwrap().to_owned();
        settings.bind(|| insta::assert_snapshot!(name, text));
    }
}
