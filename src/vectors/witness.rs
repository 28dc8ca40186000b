//! The line that a program shows for its own `open`, and whether it is one.

use super::{Answer, AnswerError, Case, Class, Kind};
use crate::formats::json::read_exact;
use crate::num::{Int, Number, Rational};
use num_traits::{Signed, Zero};
use serde::Deserialize;
use serde_json::{Value, json};

/// A line that is said to be strictly inside every portal of a sequence.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Witness {
    /// Two of its points, in its direction.
    pub points: [Vec<Rational>; 2],
    /// Of two cells of a graph: the portals that it passes from the one to the other, by number.
    pub portals: Vec<usize>,
}

impl Witness {
    /// The witness beside an answer, where it is looked at: beside the `open` of a sequence, and
    /// of a graph if `portals` is there too.
    ///
    /// # Errors
    /// [`AnswerError::Value`] for something else than two points, or than a list of numbers.
    pub fn read(kind: Kind, answer: &Answer, text: &str) -> Result<Option<Witness>, AnswerError> {
        let said = read_exact(text).map_err(|error| AnswerError::Json(error.to_string()))?;
        let given = |field: &str| said.get(field).filter(|value| !value.is_null());
        let portals = given("portals");
        let (Some(witness), Answer::Class(Class::Open)) = (given("witness"), answer) else {
            return Ok(None);
        };
        let numbers = match (kind, portals) {
            (Kind::Sequence, _) => Vec::new(),
            (Kind::Graph, Some(portals)) => {
                let wrong = |_| wrong("portals", portals, "a list of portals' numbers");
                Vec::<usize>::deserialize(portals).map_err(wrong)?
            }
            (Kind::Graph | Kind::Scene | Kind::Eye | Kind::Transversals, _) => return Ok(None),
        };
        let points = points(witness).and_then(|points| <[_; 2]>::try_from(points).ok());
        let points = points.ok_or_else(|| wrong("witness", witness, "two points"))?;
        Ok(Some(Witness { points, portals: numbers }))
    }

    /// An answer as JSON, with the points of the line that is shown for it, if one is.
    pub fn beside(answer: &Answer, witness: Option<&Witness>) -> Value {
        let mut value = answer.to_value();
        if let Some(witness) = witness {
            let point = |p: &Vec<Rational>| p.iter().map(ToString::to_string).collect::<Vec<_>>();
            value["witness"] = json!(witness.points.each_ref().map(point));
        }
        value
    }

    /// Whether it proves the case's sequence open, or its two cells.
    ///
    /// Complexity: linear in the number of edges; exact, by the sides' definition.
    pub fn proves(&self, case: &Case) -> bool {
        let gates = match case.kind {
            Kind::Sequence => case.input.get("portals").and_then(polygons),
            Kind::Graph => self.gates(case),
            Kind::Scene | Kind::Eye | Kind::Transversals => None,
        };
        let line = self.points.each_ref().map(Vec::as_slice);
        gates.is_some_and(|gates| gates.iter().all(|gate| passes(line, gate)))
    }

    /// The polygons of its portals, each turned the way it is crossed; `None` if they do not lead
    /// from the one cell to the other.
    fn gates(&self, case: &Case) -> Option<Vec<Polygon>> {
        let mut cell = case.from.as_deref()?;
        let mut gates = Vec::new();
        for &number in &self.portals {
            let portal = case.input.get("portals")?.get(number)?;
            let shape = portal.get("polygon").or_else(|| portal.get("segment"))?;
            let mut gate = points(shape)?;
            let [from, to] = ["from", "to"].map(|end| portal.get(end).and_then(Value::as_str));
            if from == Some(cell) {
                cell = to?;
            } else if to == Some(cell) {
                gate.reverse();
                cell = from?;
            } else {
                return None;
            }
            gates.push(gate);
        }
        (Some(cell) == case.to.as_deref()).then_some(gates)
    }
}

/// Whether the line from one point to another is strictly inside a gate, in its direction: to the
/// right of a segment's left end and to the left of its right end; in space with a positive side on
/// every edge of a polygon. A vertex said twice makes no edge.
pub fn passes([p, q]: [&[Rational]; 2], gate: &[Vec<Rational>]) -> bool {
    let axes = p.len();
    if q.len() != axes || gate.iter().any(|vertex| vertex.len() != axes) {
        return false;
    }
    let arm =
        |end: &[Rational]| -> Vec<Rational> { end.iter().zip(p).map(|(end, p)| end - p).collect() };
    let d = arm(q);
    match (axes, gate) {
        (2, [left, right]) => {
            let turn = |end: &[Rational]| {
                let arm = arm(end);
                &d[0] * &arm[1] - &d[1] * &arm[0]
            };
            turn(left).is_positive() && turn(right).is_negative()
        }
        (3, _) => gate.iter().zip(gate.iter().cycle().skip(1)).all(|(from, to)| {
            if from == to {
                return true;
            }
            let (u, v) = (arm(from), arm(to));
            let axes = [(0, 1, 2), (1, 2, 0), (2, 0, 1)];
            let side = axes.map(|(i, j, k)| &d[i] * (&u[j] * &v[k] - &u[k] * &v[j]));
            side.into_iter().fold(Rational::zero(), |sum, c| sum + c).is_positive()
        }),
        _ => false,
    }
}

type Polygon = Vec<Vec<Rational>>;

fn wrong(field: &'static str, got: &Value, expected: &'static str) -> AnswerError {
    AnswerError::Value { field, got: got.to_string(), expected }
}

/// Numbers as any reader of JSON keeps them: whole ones, or strings.
fn number(value: &Value) -> Option<Rational> {
    let text = match value {
        Value::String(text) => text.clone(),
        Value::Number(number) => number.to_string(),
        Value::Null | Value::Bool(_) | Value::Array(_) | Value::Object(_) => return None,
    };
    Number::parse(&text).ok().map(|number| number.to_rational())
}

fn points(value: &Value) -> Option<Polygon> {
    let point = |point: &Value| point.as_array()?.iter().map(number).collect();
    value.as_array()?.iter().map(point).collect()
}

fn polygons(value: &Value) -> Option<Vec<Polygon>> {
    value.as_array()?.iter().map(points).collect()
}

/// The points of a grid in the units of its file.
pub(super) fn on_grid<const N: usize>(points: &[[Rational; N]; 2], denominator: &Int) -> Witness {
    let point = |p: &[Rational; N]| p.iter().map(|c| c / denominator).collect();
    Witness { points: points.each_ref().map(point), portals: Vec::new() }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(kind: Kind, text: &str) -> Result<Option<Witness>, AnswerError> {
        Witness::read(kind, &Answer::read(kind, text).expect("an answer"), text)
    }

    fn case(kind: Kind, portals: Value) -> Case {
        let ends = [Some("a".to_owned()), Some("c".to_owned())];
        let [from, to] = ends.map(|end| end.filter(|_| kind == Kind::Graph));
        let input = json!({ "portals": portals });
        Case { tc_id: 1, kind, input, from, to, comment: String::new(), flags: Vec::new() }
    }

    fn proves(case: &Case, text: &str) -> bool {
        let witness = read(case.kind, text).expect("it is read");
        witness.expect("it is looked at").proves(case)
    }

    #[test]
    fn a_line_strictly_inside_in_its_direction_proves_a_sequence() {
        let square = json!([[0, 0, 0], [2, 0, 0], [2, 2, 0], ["4/2", 2, 0], [0, 2, 0]]);
        let triangle = json!([["0", 0, 5], ["3/2", 0, 5], [0, 3, 5]]);
        let case = case(Kind::Sequence, json!([square, triangle]));
        let line = |p: &str| format!(r#"{{"class": "open", "witness": {p}}}"#);
        assert!(proves(&case, &line(r#"[["1/2", 1, 0], ["0.5", "1", 9]]"#)));
        for bad in [
            r#"[["1/2", 1, 9], ["1/2", 1, 0]]"#,
            r#"[[0, 1, 0], [0, 1, 9]]"#,
            r#"[["7/4", 1, 0], ["7/4", 1, 9]]"#,
            r#"[["1/2", 1, 0], ["1/2", 1, 0]]"#,
            r#"[["1/2", 1], ["1/2", 9]]"#,
        ] {
            assert!(!proves(&case, &line(bad)), "{bad}");
        }
        assert!(read(Kind::Sequence, &line("[[1, 1, 0]]")).is_err());
        assert!(read(Kind::Sequence, &line(r#"[["one", 1, 0], [1, 1, 9]]"#)).is_err());
        assert_eq!(read(Kind::Sequence, &line("null")), Ok(None));
        assert_eq!(read(Kind::Sequence, r#"{"class": "blocked", "witness": 1}"#), Ok(None));
        assert_eq!(read(Kind::Scene, &line("[[1, 1, 0], [1, 1, 9]]")), Ok(None));
    }

    #[test]
    fn in_a_graph_the_portals_have_to_lead_from_cell_to_cell() {
        let portals = json!([
            {"from": "a", "to": "b", "segment": [[0, 0], [2, 0]]},
            {"from": "c", "to": "b", "segment": [[2, 5], [0, 5]]},
        ]);
        let case = case(Kind::Graph, portals);
        let said = |portals: &str, x: i32| {
            format!(r#"{{"class": "open", "portals": {portals}, "witness": [[{x}, 0], [{x}, 5]]}}"#)
        };
        assert!(proves(&case, &said("[0, 1]", 1)));
        for (portals, x) in [("[0, 1]", 2), ("[0]", 1), ("[1, 0]", 1), ("[0, 7]", 1), ("[]", 1)] {
            assert!(!proves(&case, &said(portals, x)), "{portals} {x}");
        }
        assert_eq!(
            read(Kind::Graph, r#"{"class": "open", "witness": [[1, 0], [1, 5]]}"#),
            Ok(None)
        );
        assert!(read(Kind::Graph, &said("[-1]", 1)).is_err());
    }
}
