//! Our own answer to an input, held to the definitions: what the engine gives as evidence is
//! checked by [`super::check`] before the answer counts.

mod joined;
mod quadric;
mod scene;
mod vector;

pub use scene::{occluders_of, regions_of};
pub use vector::test_of;

use super::check;
use super::input::{Door, Graph, Input, Point, Polygon};
use crate::geom::{BigLine, BigPoint2, BigPoint3, RationalPoint3};
use crate::num::{Int, Number, Rational, Surd};
use crate::pvs;
use crate::pvs::plan::{Groups, classify_plan_grazing};
use crate::report::{Matrix, ProvedGrazing, Silent, Verdict};
use crate::scene::plan::{PlanInput, read_plan};
use crate::scene::{PortalGraph, RawGraph, RawPortal};
use crate::stab::hourglass::{End, EndTerm, Hourglass, PlaneVerdict};
use crate::stab::transversals::transversals;
use crate::stab::{Certificate, Condition, Portal3, StabLine, Stabber, Term, Witness};
use crate::vectors::{Answer, Class, LineCount};
use num_integer::Integer;
use num_traits::One;

/// What the engine says, and what it says it with.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// The answer.
    pub answer: Answer,
    /// The evidence in words, for a digest.
    pub evidence: String,
}

/// Why there is no answer.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Fault {
    /// The input breaks a rule of its format: no question of ours.
    #[error("the input is refused: {0}")]
    Refused(String),
    /// The engine's evidence does not show what it should: a defect.
    #[error("the evidence does not hold: {0}")]
    Evidence(String),
}

/// The engine's answer, its evidence held.
///
/// # Errors
/// [`Fault`].
pub fn find(input: &Input) -> Result<Finding, Fault> {
    match input {
        Input::Sequence(portals) if input.dimension() == 2 => in_plane(portals),
        Input::Sequence(portals) => in_space(portals),
        Input::Lines(lines) => of_lines(lines),
        Input::Graph(graph) => of_pair(graph),
        Input::Scene(found) => scene::find(found, input),
    }
}

/// Whether the input is valid.
pub fn accepts(input: &Input) -> bool {
    let are_distinct = |ends: &Polygon| ends.len() == 2 && ends[0] != ends[1];
    match input {
        Input::Sequence(portals) if input.dimension() == 2 => portals.iter().all(are_distinct),
        Input::Sequence(portals) => on_grid(portals).is_ok(),
        Input::Lines(lines) => lines.iter().all(are_distinct),
        Input::Graph(graph) => {
            let flat = |door: &Door| door.polygon.len() == 2 && !are_distinct(&door.polygon);
            !graph.doors.iter().any(flat) && portal_graph(graph).is_ok()
        }
        Input::Scene(_) => scene::accepts(input),
    }
}

fn refused(what: impl std::fmt::Display) -> Fault {
    Fault::Refused(what.to_string())
}

fn holds(fact: bool, what: &str) -> Result<(), Fault> {
    if fact { Ok(()) } else { Err(Fault::Evidence(what.to_owned())) }
}

/// Segments of the plane on the grid of their lowest common denominator, and that.
pub(super) fn on_plane_grid(segments: &[Polygon]) -> (Int, Vec<[BigPoint2; 2]>) {
    let all = segments.iter().flatten().flatten();
    let unit = all.fold(Int::one(), |common, c| common.lcm(c.denom()));
    let end = |p: &Point| BigPoint2 { coordinates: [0, 1].map(|i| (&p[i] * &unit).to_integer()) };
    let segments = segments.iter().map(|ends| [end(&ends[0]), end(&ends[1])]).collect();
    (unit, segments)
}

/// A polygon in space as points.
pub(super) fn points3(polygon: &Polygon) -> Vec<RationalPoint3> {
    let point = |p: &Point| RationalPoint3::from(&[0, 1, 2].map(|i| p[i].clone()));
    polygon.iter().map(point).collect()
}

fn in_plane(segments: &[Polygon]) -> Result<Finding, Fault> {
    let (unit, on_grid) = on_plane_grid(segments);
    let mut hourglass = Hourglass::new();
    for [left, right] in on_grid {
        if left == right {
            return Err(refused("a segment's two ends are one point"));
        }
        hourglass.push_big(left, right);
    }
    let cancels = |certificate: &[EndTerm]| {
        let side = |end| match end {
            End::Left => 0,
            End::Right => 1,
        };
        let terms: Vec<(usize, usize, Int)> =
            certificate.iter().map(|t| (t.portal, side(t.end), t.weight.clone())).collect();
        holds(check::ends_cancel(&terms, segments), "the ends do not cancel")
    };
    let class = match &hourglass.verdict() {
        PlaneVerdict::Open(witness) => {
            let line = witness.points.clone().map(|p| p.map(|c| c / &unit));
            holds(check::passes(&line, segments), "the witness does not pass")?;
            Class::Open
        }
        PlaneVerdict::Grazing { touching_line, certificate } => {
            let ratio = |c: &Int| Rational::new(c.clone(), unit.clone());
            let line = touching_line.each_ref().map(|p| p.coordinates.each_ref().map(ratio));
            holds(check::touches_between(&line, segments), "the touching line misses")?;
            cancels(certificate)?;
            Class::Grazing
        }
        PlaneVerdict::Blocked { certificate } => {
            cancels(certificate)?;
            Class::Blocked
        }
    };
    Ok(Finding { answer: Answer::Class(class), evidence: format!("{:?}", hourglass.verdict()) })
}

/// A sequence on its grid: the unit, and the portals.
fn on_grid(portals: &[Polygon]) -> Result<(Int, Vec<Portal3>), Fault> {
    let points: Vec<Vec<RationalPoint3>> = portals.iter().map(points3).collect();
    let unit = RationalPoint3::common_denominator(points.iter().flatten());
    let portals = points.iter().map(|polygon| {
        let vertices: Vec<BigPoint3> = polygon.iter().map(|p| p.on_grid(&unit)).collect();
        Portal3::new(&vertices).map_err(refused)
    });
    let portals = portals.collect::<Result<Vec<Portal3>, Fault>>()?;
    Ok((unit, portals))
}

fn in_space(polygons: &[Polygon]) -> Result<Finding, Fault> {
    let (unit, portals) = on_grid(polygons)?;
    let mut stabber = Stabber::new();
    portals.iter().for_each(|portal| stabber.push(portal, false));
    let verdict = stabber.verdict();
    let class = match &verdict {
        crate::stab::Verdict::Open { witness } => {
            let Witness { points } = witness.as_ref();
            let line = points.clone().map(|p| p.map(|c| c / &unit));
            holds(check::passes(&line, polygons), "the witness does not pass")?;
            Class::Open
        }
        crate::stab::Verdict::Grazing { touching_line, certificate } => {
            let StabLine { points } = touching_line.as_ref();
            let scale = Surd::from(unit.clone());
            let line = points.each_ref().map(|p| p.each_ref().map(|c| c / &scale));
            holds(check::touches(&line, polygons), "the touching line misses")?;
            hold_certificate(certificate, polygons, &unit)?;
            Class::Grazing
        }
        crate::stab::Verdict::Blocked { certificate } => {
            hold_certificate(certificate, polygons, &unit)?;
            Class::Blocked
        }
    };
    Ok(Finding { answer: Answer::Class(class), evidence: format!("{verdict:?}") })
}

fn hold_certificate(
    certificate: &Certificate,
    polygons: &[Polygon],
    unit: &Int,
) -> Result<(), Fault> {
    match certificate {
        Certificate::Gordan(terms) => {
            let term = |term: &Term| match term.condition {
                Condition::Edge(name) => Some((name.portal, name.edge, term.weight.clone())),
                Condition::Order { .. } => None,
            };
            let terms: Option<Vec<_>> = terms.iter().map(term).collect();
            let cancel = terms.is_some_and(|terms| check::edges_cancel(&terms, polygons));
            holds(cancel, "the edges do not cancel")
        }
        Certificate::Quadric(proof) => {
            let proof = quadric::proof_of(proof)
                .ok_or_else(|| Fault::Evidence("an order where none was asked".to_owned()))?;
            holds(check::refutes(&proof, polygons, unit), "the quadric certificate does not hold")
        }
    }
}

fn of_lines(lines: &[Polygon]) -> Result<Finding, Fault> {
    let line = |ends: &Polygon| {
        let point = |p: &Vec<Rational>| [0, 1, 2].map(|i| p[i].clone());
        BigLine::through_rational(&point(&ends[0]), &point(&ends[1]))
            .ok_or_else(|| refused("a line's two points are one"))
    };
    let given = lines.iter().map(line).collect::<Result<Vec<BigLine>, Fault>>()?;
    let found = transversals(&given);
    for isolated in &found.isolated {
        let meets = |line| check::meets([&isolated.direction, &isolated.moment], line);
        holds(lines.iter().all(meets), "a line misses one of the four")?;
    }
    let count = match (found.families.is_empty(), found.isolated.len()) {
        (false, _) => LineCount::Family,
        (true, 0) => LineCount::None,
        (true, 1) => LineCount::One,
        (true, _) => LineCount::Two,
    };
    Ok(Finding { answer: Answer::Lines(count), evidence: format!("{found:?}") })
}

/// The graph as the search takes it; one of the plane gets a height of 1.
///
/// # Errors
/// [`Fault::Refused`].
pub fn portal_graph(graph: &Graph) -> Result<PortalGraph, Fault> {
    let portals = graph.doors.iter().map(|door| RawPortal {
        cells: door.cells.map(|cell| cell as u32),
        vertices: raised(&door.polygon)
            .iter()
            .map(|p| [0, 1, 2].map(|i| p[i].clone().into()))
            .collect(),
        line: None,
    });
    let portals: Vec<RawPortal> = portals.collect();
    PortalGraph::from_raw(RawGraph {
        cells: (0..graph.cells).map(|cell| cell.to_string()).collect(),
        portals,
        leaf_to_cell: (0..graph.cells as u32).collect(),
        declared_grid: None,
    })
    .map_err(refused)
}

/// A polygon in space; a segment, left end and right end, as a wall of height 1 on it.
pub fn raised(polygon: &Polygon) -> Polygon {
    match polygon.as_slice() {
        [left, right] => {
            let at = |end: &Vec<Rational>, z: i64| -> Vec<Rational> {
                let z = Rational::from(Int::from(z));
                vec![end[0].clone(), end[1].clone(), z]
            };
            vec![at(right, 0), at(left, 0), at(left, 1), at(right, 1)]
        }
        polygon => polygon.to_vec(),
    }
}

/// Which cells see which, every line held, and the rows of the search with the lines.
///
/// # Errors
/// [`Fault`].
pub fn pvs_of(graph: &Graph) -> Result<(PortalGraph, Matrix, Vec<pvs::Row>), Fault> {
    let built = portal_graph(graph)?;
    let options = pvs::Options::default();
    let finished = pvs::compute(&built, &options, Vec::new(), &|_| {}, &Silent);
    let matrix = pvs::assemble(&built, &finished.rows);
    let witnesses = pvs::witnesses(&finished.rows);
    holds(matrix.asymmetric_pairs() == 0, "the matrix is not symmetric")?;
    let planar = built.skew_portals == 0 && built.repairs.dented_portals == 0;
    let doors: Vec<Door> = graph
        .doors
        .iter()
        .map(|door| Door { cells: door.cells, polygon: raised(&door.polygon) })
        .collect();
    let mut open = 0;
    for witness in &witnesses {
        let chain: Vec<usize> = witness.portals.iter().map(|&portal| portal as usize).collect();
        let number = |c: &Number| c.to_rational();
        let line = witness.line.in_space().each_ref().map(|p| p.each_ref().map(number));
        let ends = [witness.from as usize, witness.to as usize];
        // Of a polygon that was cut up, a line passes one of the pieces.
        if planar {
            check::leads(&doors, &chain, ends, &line).map_err(Fault::Evidence)?;
        }
        holds(matrix.get(ends[0], ends[1]) == Verdict::Open, "a witness of a pair not open")?;
        open += 2;
    }
    let counted = matrix.counts().open as usize;
    holds(counted == open + graph.cells, "an open pair without a witness")?;
    Ok((built, matrix, finished.rows))
}

/// Splits the pairs of `matrix` that are not open into grazing and blocked; the touching lines.
///
/// Those of a graph of the plane lie in it: at its portals of height 1 others may stand upright.
///
/// # Errors
/// [`Fault::Refused`].
pub fn classify_grazing(
    graph: &Graph,
    built: &PortalGraph,
    matrix: &mut Matrix,
) -> Result<Vec<ProvedGrazing>, Fault> {
    let uninterrupted = "nothing interrupts in silence";
    let input = Input::Graph(graph.clone());
    if input.dimension() == 3 {
        return Ok(pvs::classify_grazing(built, matrix, None, &Silent).expect(uninterrupted));
    }
    let text = input.document().to_string();
    let PlanInput::Graph(flat) = read_plan("case.json", text.as_bytes()).map_err(refused)? else {
        return Err(refused("no portal graph"));
    };
    let (crossings, groups) = (flat.crossings(), Groups::cells(flat.cells.len()));
    let touches = classify_plan_grazing(&flat, &crossings, &groups, matrix, &Silent);
    let touches = touches.expect(uninterrupted);
    Ok(touches.iter().map(|touch| touch.in_space(&flat, &crossings)).collect())
}

fn of_pair(graph: &Graph) -> Result<Finding, Fault> {
    let (built, mut matrix, rows) = pvs_of(graph)?;
    if matrix.get(graph.from, graph.to) != Verdict::Open {
        classify_grazing(graph, &built, &mut matrix)?;
    }
    let class = class_of(matrix.get(graph.from, graph.to));
    Ok(Finding { answer: Answer::Class(class), evidence: format!("{matrix:?} {rows:?}") })
}

/// A verdict of a classified matrix.
fn class_of(verdict: Verdict) -> Class {
    match verdict {
        Verdict::Open => Class::Open,
        Verdict::Grazing => Class::Grazing,
        Verdict::NotOpen => Class::Blocked,
        Verdict::Undecided => unreachable!("there is no budget"),
    }
}
