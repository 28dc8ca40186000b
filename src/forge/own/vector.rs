//! An answer with its evidence, as a test vector.

use super::{Fault, classify_grazing, find, on_grid, pvs_of, refused};
use crate::forge::input::{Graph, Input, Polygon};
use crate::formats::lines::LinesFile;
use crate::formats::sequence::{SequenceFile, SequencePoints};
use crate::geom::RationalPoint3;
use crate::num::Number;
use crate::pvs::{self, Found};
use crate::report::{
    InputId, ProofHead, PvsReport, Silent, StabReport, TransversalsReport, Verdict, refutation_text,
};
use crate::stab::hourglass::Hourglass;
use crate::stab::transversals::transversals;
use crate::stab::{Stabber, Verdict as StabVerdict};
use crate::vectors::{Answer, Class, Test};
use serde_json::{Value, json};

/// What is true of an input with what shows it, without its number, comment and flags. `None` for
/// what has no such evidence of one piece: scenes, whose cells are of this program's making, and
/// two cells of a graph that are grazing.
///
/// # Errors
/// [`Fault`].
pub fn test_of(input: &Input) -> Result<Option<Test>, Fault> {
    match input {
        Input::Sequence(portals) => sequence(input, portals).map(Some),
        Input::Lines(_) => lines(input).map(Some),
        Input::Graph(graph) => pair(graph, input),
        Input::Scene(_) => Ok(None),
    }
}

fn sequence(input: &Input, polygons: &[Polygon]) -> Result<Test, Fault> {
    let document = input.document();
    let file = SequenceFile::read(document.to_string().as_bytes()).map_err(refused)?;
    let (report, certificate) = match file.points().map_err(refused)? {
        SequencePoints::Plane { denominator, portals } => {
            let mut hourglass = Hourglass::new();
            portals.into_iter().for_each(|[left, right]| hourglass.push_big(left, right));
            (StabReport::of_plane(&hourglass.verdict(), &denominator), None)
        }
        SequencePoints::Space { .. } => {
            let (unit, portals) = on_grid(polygons)?;
            let mut stabber = Stabber::new();
            portals.iter().for_each(|portal| stabber.push(portal, false));
            let verdict = stabber.verdict();
            let reason = match &verdict {
                StabVerdict::Open { .. } => None,
                StabVerdict::Grazing { certificate, .. } | StabVerdict::Blocked { certificate } => {
                    let point = |p: &Vec<_>| {
                        RationalPoint3::from(&[0, 1, 2].map(|i: usize| {
                            let c: &crate::num::Rational = &p[i];
                            c.clone()
                        }))
                    };
                    let vertices: Vec<Vec<RationalPoint3>> =
                        polygons.iter().map(|p| p.iter().map(point).collect()).collect();
                    let vertices = vertices.iter().map(|portal| portal.iter().collect()).collect();
                    Some(json!({"refutation": refutation_text(certificate, vertices, &unit)}))
                }
            };
            (StabReport::new(&verdict, &[], &unit, false), reason)
        }
    };
    let report: Value = serde_json::from_str(&report.to_json()).map_err(refused)?;
    let field = |name: &str| report.get(name).filter(|value| !value.is_null()).cloned();
    let Answer::Class(class) = find(input)?.answer else { return Err(refused("no verdict")) };
    Ok(Test {
        input: Some(document),
        class: Some(class),
        witness: field("witness"),
        touching_line: field("touching_line"),
        certificate: certificate.or_else(|| field("certificate")),
        ..Test::default()
    })
}

fn lines(input: &Input) -> Result<Test, Fault> {
    let document = input.document();
    let file = LinesFile::read(document.to_string().as_bytes()).map_err(refused)?;
    let report = TransversalsReport::new(&transversals(&file.lines().map_err(refused)?));
    let Answer::Lines(count) = find(input)?.answer else { return Err(refused("no count")) };
    Ok(Test {
        input: Some(document),
        transversals: Some(count),
        certificate: Some(serde_json::from_str(&report.to_json()).map_err(refused)?),
        ..Test::default()
    })
}

fn pair(graph: &Graph, input: &Input) -> Result<Option<Test>, Fault> {
    let Answer::Class(class) = find(input)?.answer else { return Ok(None) };
    let ends = [graph.from, graph.to].map(|cell| Some(cell.to_string()));
    let [from, to] = ends;
    let test = Test { from, to, class: Some(class), ..Test::default() };
    let (built, matrix, rows) = pvs_of(graph)?;
    Ok(match class {
        Class::Grazing => None,
        Class::Open => {
            let (low, high) = (graph.from.min(graph.to) as u32, graph.from.max(graph.to) as u32);
            let witnesses = pvs::witnesses(&rows);
            let Some(found) = witnesses.into_iter().find(|w| (w.from, w.to) == (low, high)) else {
                // A cell and itself.
                return Ok(None);
            };
            let mut portals = found.portals.clone();
            let number = |c: &Number| Value::from(c.to_string());
            let mut line: Vec<Value> =
                found.line.in_space().iter().map(|p| p.iter().map(number).collect()).collect();
            if graph.from as u32 == high {
                portals.reverse();
                line.reverse();
            }
            Some(Test { portals: Some(portals), witness: Some(line.into()), ..test })
        }
        Class::Blocked => {
            let mut matrix = matrix.clone();
            let grazing = classify_grazing(graph, &built, &mut matrix)?;
            let found = Found { matrix: &matrix, rows: &rows, grazing: &grazing };
            let head = InputId::new("input", input.document().to_string().as_bytes());
            let program = PvsReport::this_program();
            let head = ProofHead { program: &program, input: &head };
            debug_assert_eq!(matrix.get(graph.from, graph.to), Verdict::NotOpen);
            let text = pvs::write_proof(Vec::new(), &head, &built, &found, &Silent);
            let text = text.map_err(refused)?.unwrap_or_default();
            let text = String::from_utf8_lossy(&text);
            let lines: Vec<&str> = text.lines().collect();
            Some(Test { certificate: Some(json!({ "proof": lines })), ..test })
        }
    })
}
