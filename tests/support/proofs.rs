//! Proofs as text, of any graph.

use stabline::pvs::{self, Found, Options};
use stabline::report::{InputId, ProofHead, Silent};
use stabline::scene::PortalGraph;

/// The proof of a graph's PVS, with grazing classified or not.
pub fn proof(graph: &PortalGraph, with_grazing: bool) -> String {
    let finished = pvs::compute(graph, &Options::default(), Vec::new(), &|_| {}, &Silent);
    let mut matrix = pvs::assemble(graph, &finished.rows);
    let mut grazing = Vec::new();
    if with_grazing {
        grazing = pvs::classify_grazing(graph, &mut matrix, None, &Silent).expect("no interrupt");
    }
    let found = Found { matrix: &matrix, rows: &finished.rows, grazing: &grazing };
    let input = InputId { name: "a graph".to_owned(), blake3: "0".repeat(64) };
    let head = ProofHead { program: "stabline 0.1.0", input: &input };
    let text = pvs::write_proof(Vec::new(), &head, graph, &found, &Silent);
    let text = text.expect("memory takes any text").expect("no interrupt");
    String::from_utf8(text).expect("a proof is text")
}
