//! Two sets of cells of a graph, and what shows that they see each other, or do not.

use super::{Fault, class_of, refused};
use crate::num::{Number, Rational, Surd};
use crate::pvs::{self, Found, Row};
use crate::report::{
    InputId, Matrix, PairWitness, ProofHead, ProvedGrazing, PvsReport, Silent, surd_value,
};
use crate::scene::PortalGraph;
use crate::stab::StabLine;
use crate::vectors::Class;
use serde_json::Value;

/// A graph that was searched and classified, and the cells on either side of a question.
pub(super) struct Joined {
    pub(super) built: PortalGraph,
    pub(super) matrix: Matrix,
    pub(super) rows: Vec<Row>,
    pub(super) grazing: Vec<ProvedGrazing>,
    pub(super) from: Vec<usize>,
    pub(super) to: Vec<usize>,
}

/// A line, and the portals that it meets, by their numbers in the input.
pub(super) struct Shown {
    pub(super) portals: Vec<u32>,
    /// Two points, in its direction, as JSON.
    pub(super) line: Value,
}

impl Joined {
    /// The greatest class of a cell of the one side and one of the other.
    pub(super) fn class(&self) -> Class {
        best(&self.matrix, &self.from, &self.to)
    }

    /// Whether a pair of cells is one of those asked about, and reversed.
    fn asks(&self, from: u32, to: u32) -> Option<bool> {
        let is =
            |a: u32, b: u32| self.from.contains(&(a as usize)) && self.to.contains(&(b as usize));
        if is(from, to) { Some(false) } else { is(to, from).then_some(true) }
    }

    /// The sightline of an open pair of different cells; with `axes` coordinates.
    pub(super) fn sightline(&self, axes: usize) -> Option<Shown> {
        let witnesses = pvs::witnesses(&self.rows);
        let found = |w: PairWitness| self.asks(w.from, w.to).map(|is_reversed| (w, is_reversed));
        let (PairWitness { mut portals, line, .. }, is_reversed) =
            witnesses.into_iter().find_map(found)?;
        let number = |c: &Number| Value::from(c.to_string());
        let point = |p: &[Number; 3]| p[..axes].iter().map(number).collect();
        let mut line: Vec<Value> = line.in_space().iter().map(point).collect();
        if is_reversed {
            portals.reverse();
            line.reverse();
        }
        Some(Shown { portals, line: line.into() })
    }

    /// The touching line of a grazing pair; with `axes` coordinates.
    pub(super) fn touching_line(&self, axes: usize) -> Option<Shown> {
        let (pair, is_reversed) = self.grazing.iter().find_map(|pair| {
            let is_reversed = self.asks(pair.source.0, pair.target.0)?;
            Some((pair, is_reversed))
        })?;
        let source = |&portal: &u32| self.built.portals[portal as usize / 2].source;
        let mut portals: Vec<u32> = pair.portals.iter().map(source).collect();
        let mut line = line_of(pair).points;
        if is_reversed {
            portals.reverse();
            line.reverse();
        }
        let point = |p: &[Surd; 3]| -> Value { p[..axes].iter().map(surd_value).collect() };
        Some(Shown { portals, line: line.iter().map(point).collect() })
    }

    /// The lines of the proof.
    pub(super) fn proof(&self, document: &Value) -> Result<Vec<String>, Fault> {
        let found = Found { matrix: &self.matrix, rows: &self.rows, grazing: &self.grazing };
        let input = InputId::new("input", document.to_string().as_bytes());
        let head = ProofHead { program: &PvsReport::this_program(), input: &input };
        let text = pvs::write_proof(Vec::new(), &head, &self.built, &found, &Silent);
        let text = text.map_err(refused)?.unwrap_or_default();
        Ok(String::from_utf8_lossy(&text).lines().map(str::to_owned).collect())
    }
}

/// The greatest class of a pair of cells.
pub(super) fn best(matrix: &Matrix, from: &[usize], to: &[usize]) -> Class {
    let pairs = from.iter().flat_map(|&a| to.iter().map(move |&b| (a, b)));
    pairs.map(|(a, b)| class_of(matrix.get(a, b))).max().unwrap_or(Class::Blocked)
}

/// The line by two points.
fn line_of(pair: &ProvedGrazing) -> StabLine {
    let [rational, root] = &pair.line;
    let part = |i: usize| {
        let [a, b] = [rational, root].map(|v| Rational::from(v[i].clone()));
        Surd::new(a, b, pair.radicand.clone())
    };
    let [direction, moment] = [0, 3].map(|first| [0, 1, 2].map(|i| part(first + i)));
    StabLine::near_origin(&direction, &moment)
}
