//! The twins' answer to an input: by brute force, with nothing of the engine. Feature `oracle`.

use super::input::{Graph, Input, Polygon};
use super::own::{Fault, on_plane_grid, points3, portal_graph};
use crate::geom::RationalPoint3;
use crate::oracle::{
    Gate, MeetingLines, PlaneGate, PlaneTruth, Truth, classify, classify_2d, classify_pairs_2d,
    meeting_lines, on_common_grid, open_pairs, touched_pairs,
};
use crate::vectors::{Answer, Class, LineCount};

/// What the twin of the input's kind says; `None` of scenes, whose cells only the engine makes.
///
/// The input must be one that [`accepts`](super::accepts) takes. Complexity: exponential in a
/// graph's portals, and a high power of a sequence's edges.
///
/// # Errors
/// [`Fault::Refused`] for a graph that is none.
pub fn answer(input: &Input) -> Result<Option<Answer>, Fault> {
    Ok(Some(match input {
        Input::Sequence(segments) if input.dimension() == 2 => {
            Answer::Class(match classify_2d(&on_plane_grid(segments).1) {
                PlaneTruth::Open => Class::Open,
                PlaneTruth::Grazing => Class::Grazing,
                PlaneTruth::Blocked => Class::Blocked,
            })
        }
        Input::Sequence(portals) => {
            let portals: Vec<Vec<RationalPoint3>> = portals.iter().map(points3).collect();
            let portals: Vec<&[RationalPoint3]> = portals.iter().map(Vec::as_slice).collect();
            Answer::Class(match classify(&on_common_grid(&portals).1) {
                Truth::Open(_) => Class::Open,
                Truth::Grazing(_) => Class::Grazing,
                Truth::Blocked => Class::Blocked,
            })
        }
        Input::Lines(lines) => {
            let ends = |k: usize| [0, 1].map(|end| [0, 1, 2].map(|i| lines[k][end][i].clone()));
            Answer::Lines(match meeting_lines(&[0, 1, 2, 3].map(ends)) {
                MeetingLines::None => LineCount::None,
                MeetingLines::One => LineCount::One,
                MeetingLines::Two => LineCount::Two,
                MeetingLines::Family => LineCount::Family,
            })
        }
        Input::Graph(graph) => {
            let open = open_cells(graph)?[graph.from][graph.to];
            Answer::Class(class_of_pair(graph, open)?)
        }
        Input::Scene(_) => return Ok(None),
    }))
}

/// Whether each ordered pair of a graph's cells is open, row by row.
///
/// Complexity: exponential in the portals.
///
/// # Errors
/// [`Fault::Refused`].
pub fn open_cells(graph: &Graph) -> Result<Vec<Vec<bool>>, Fault> {
    Ok(open_pairs(graph.cells, &gates(graph)?))
}

/// The class of the pair that a graph asks about, of which it is known whether it is open.
///
/// Complexity: exponential in the portals.
///
/// # Errors
/// [`Fault::Refused`].
pub fn class_of_pair(graph: &Graph, is_open: bool) -> Result<Class, Fault> {
    if is_open {
        return Ok(Class::Open);
    }
    let is_touched = match Input::Graph(graph.clone()).dimension() {
        2 => {
            let segments: Vec<Polygon> = graph.doors.iter().map(|d| d.polygon.clone()).collect();
            let gates: Vec<PlaneGate> = graph
                .doors
                .iter()
                .zip(on_plane_grid(&segments).1)
                .map(|(door, ends)| PlaneGate { from: door.cells[0], to: door.cells[1], ends })
                .collect();
            let pairs = classify_pairs_2d(graph.cells, &gates);
            pairs[graph.from][graph.to] != PlaneTruth::Blocked
        }
        _ => touched_pairs(graph.cells, &gates(graph)?)[graph.from][graph.to],
    };
    Ok(if is_touched { Class::Grazing } else { Class::Blocked })
}

/// The portals as the twin takes them: what is skew in pieces, what is of the plane raised.
fn gates(graph: &Graph) -> Result<Vec<Gate>, Fault> {
    let built = portal_graph(graph)?;
    let gate = |portal: &crate::scene::Portal| Gate {
        from: portal.from.0 as usize,
        to: portal.to.0 as usize,
        vertices: built.corners(portal).cloned().collect(),
    };
    Ok(built.portals.iter().map(gate).collect())
}
