//! Eyes in a real level, where the shared maps are at hand: the culls never miss a cell. Prints how
//! many queries a second each cull answers.

mod support;

use stabline::eye::{Answer, Cull, EyeGraph, LocateError, Query};
use stabline::geom::RationalPoint3;
use stabline::num::Int;
use stabline::scene::{CellId, PortalGraph, read_graph};
use std::time::Instant;
use support::maps;

/// The mean of the vertices of a cell's portals, to a sixteenth, as an editor would put it.
fn inside(graph: &PortalGraph, cell: CellId) -> Option<RationalPoint3> {
    let near = graph.portals.iter().filter(|p| p.from == cell || p.to == cell);
    let vertices: Vec<_> = near
        .flat_map(|portal| &portal.vertices)
        .map(|&vertex| &graph.vertices[vertex as usize])
        .collect();
    let count = Int::from(vertices.len());
    let sixteenths = |v: &RationalPoint3, i: usize| &v.numerators()[i] * 16 / v.denominator();
    let mean = |i: usize| vertices.iter().map(|v| sixteenths(v, i)).sum::<Int>() / &count;
    (!vertices.is_empty()).then(|| RationalPoint3::new([0, 1, 2].map(mean), Int::from(16)))
}

#[test]
fn eyes_in_a_real_level() {
    let Some(maps) = maps() else { return };
    let bytes = std::fs::read(maps.join("lq_e1m2/lq_e1m2.prt")).unwrap();
    let graph = read_graph("lq_e1m2.prt", &bytes).unwrap();
    let eyes = EyeGraph::new(&graph);
    let cells = (0..graph.cells.len() as u32).step_by(3).map(CellId);
    let places: Vec<_> = cells.filter_map(|cell| Some((cell, inside(&graph, cell)?))).collect();
    let run = |cull: Cull| -> Vec<Option<Answer>> {
        let start = Instant::now();
        let look = |(cell, eye): &(CellId, RationalPoint3)| {
            let query = Query { eye, frustum: None, cell: Some(*cell), regions: false };
            match eyes.look(&query, cull) {
                Ok(answer) => Some(answer),
                Err(LocateError::NotInCell { .. }) => None,
                Err(error) => panic!("{cell:?}: {error}"),
            }
        };
        let answers: Vec<_> = places.iter().map(look).collect();
        let found = answers.iter().flatten();
        let (cells, sequences) = found.fold((0, 0), |(cells, sequences), answer| {
            (cells + answer.cells.len(), sequences + answer.sequences)
        });
        let rate = places.len() as f64 / start.elapsed().as_secs_f64();
        println!("{cull:?}: {rate:.0} queries/s, {cells} cells, {sequences} sequences");
        answers
    };
    let exact = run(Cull::Exact);
    let refused = exact.iter().filter(|answer| answer.is_none()).count();
    println!("{} eyes, {refused} not in their cell", places.len());
    for cull in [Cull::Float, Cull::Portals, Cull::Flood] {
        for (one, other) in exact.iter().zip(run(cull)) {
            let (Some(one), Some(other)) = (one, other) else { continue };
            let reached = |cell| other.cells.iter().any(|reached| reached.cell == cell);
            assert!(one.cells.iter().all(|seen| reached(seen.cell)), "{cull:?}");
        }
    }
    assert!(refused * 10 < places.len(), "{refused} eyes are not in their cell");
}
