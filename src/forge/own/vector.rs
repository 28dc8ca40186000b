//! An answer with its evidence, as a test vector.

use super::joined::{Joined, Shown};
use super::scene::joined_of;
use super::{Fault, classify_grazing, find, on_grid, points3, pvs_of, refused};
use crate::forge::input::{Graph, Input, Polygon, Scene};
use crate::formats::lines::LinesFile;
use crate::formats::sequence::{SequenceFile, SequencePoints};
use crate::geom::RationalPoint3;
use crate::report::{StabReport, TransversalsReport, Verdict, refutation_text};
use crate::stab::hourglass::Hourglass;
use crate::stab::transversals::transversals;
use crate::stab::{Stabber, Verdict as StabVerdict};
use crate::vectors::{Answer, Class, Test};
use serde_json::{Value, json};

/// What is true of an input with what shows it, without its number, comment and flags.
///
/// # Errors
/// [`Fault`].
pub fn test_of(input: &Input) -> Result<Test, Fault> {
    match input {
        Input::Sequence(portals) => sequence(input, portals),
        Input::Lines(_) => lines(input),
        Input::Graph(of) => graph(of, input),
        Input::Scene(of) => scene(of, input),
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
                    let vertices: Vec<Vec<RationalPoint3>> = polygons.iter().map(points3).collect();
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

fn graph(graph: &Graph, input: &Input) -> Result<Test, Fault> {
    let (built, mut matrix, rows) = pvs_of(graph)?;
    let mut grazing = Vec::new();
    if matrix.get(graph.from, graph.to) != Verdict::Open {
        grazing = classify_grazing(graph, &built, &mut matrix)?;
    }
    let (from, to) = (vec![graph.from], vec![graph.to]);
    let joined = Joined { built, matrix, rows, grazing, from, to };
    let test = pair(&joined, input, [graph.from, graph.to].map(|cell| cell.to_string()))?;
    Ok(match &test.class {
        // A cell and itself: any line passes no portals.
        Some(Class::Open) if graph.from == graph.to => {
            let axes = input.dimension();
            let points = [0, 1].map(|c| vec![c.to_string(); axes]);
            Test { portals: Some(Vec::new()), witness: Some(json!(points)), ..test }
        }
        _ => test,
    })
}

fn scene(scene: &Scene, input: &Input) -> Result<Test, Fault> {
    let (joined, inner) = joined_of(scene, input)?;
    let test = pair(&joined, input, ["from", "to"].map(str::to_owned))?;
    // The portals are those of a division of this program's making, as is the proof.
    let sides = json!({"from": joined.from, "to": joined.to});
    let certificate = test.certificate.map(|mut certificate| {
        certificate["cells"] = sides;
        certificate
    });
    let witness = test.witness.or(inner);
    Ok(Test { portals: None, certificate, witness, ..test })
}

/// The answer to a pair with what shows it, but for an open pair of a cell and itself.
fn pair(joined: &Joined, input: &Input, [from, to]: [String; 2]) -> Result<Test, Fault> {
    let class = joined.class();
    let mut test = Test { from: Some(from), to: Some(to), class: Some(class), ..Test::default() };
    let axes = input.dimension();
    let shown = match class {
        Class::Open => joined.sightline(axes),
        Class::Grazing => joined.touching_line(axes),
        Class::Blocked => None,
    };
    if let Some(Shown { portals, line }) = shown {
        test.portals = Some(portals);
        match class {
            Class::Open => test.witness = Some(line),
            Class::Grazing | Class::Blocked => test.touching_line = Some(line),
        }
    }
    if class != Class::Open {
        test.certificate = Some(json!({ "proof": joined.proof(&input.document())? }));
    }
    Ok(test)
}
