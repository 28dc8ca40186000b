//! Expressions over brushes by number, and what is left of them where brushes are decided.

use super::expression::{Expression, Half};
use crate::geom::BigPlane;
use crate::num::{Int, Rational};
use num_integer::Integer;

/// An expression over brushes by number.
#[derive(Clone)]
pub(super) enum Formula {
    Brush(usize),
    Any(Vec<Formula>),
    All(Vec<Formula>),
    Not(Box<Formula>),
}

/// An expression's brushes with integer planes, and the expression over them.
pub(super) struct Flat {
    pub brushes: Vec<Vec<BigPlane>>,
    pub formula: Formula,
}

impl Formula {
    /// What is left where `decide` tells the brushes that hold and those that miss: a value, or a
    /// formula of undecided brushes. Asks for no brush that does not matter any more.
    pub(super) fn simplified(
        &self,
        decide: &mut impl FnMut(usize) -> Option<bool>,
    ) -> Result<bool, Formula> {
        match self {
            Formula::Brush(brush) => decide(*brush).ok_or(Formula::Brush(*brush)),
            Formula::Any(of) => left(of, true, decide).map_err(|of| joined(of, Formula::Any)),
            Formula::All(of) => left(of, false, decide).map_err(|of| joined(of, Formula::All)),
            Formula::Not(of) => match of.simplified(decide) {
                Ok(value) => Ok(!value),
                Err(of) => Err(Formula::Not(Box::new(of))),
            },
        }
    }

    /// Appends its brushes.
    pub(super) fn brushes(&self, all: &mut Vec<usize>) {
        match self {
            Formula::Brush(brush) => all.push(*brush),
            Formula::Any(of) | Formula::All(of) => of.iter().for_each(|part| part.brushes(all)),
            Formula::Not(of) => of.brushes(all),
        }
    }
}

/// `decisive` if one part is that, its opposite if all are, else the parts that are undecided.
fn left(
    of: &[Formula],
    decisive: bool,
    decide: &mut impl FnMut(usize) -> Option<bool>,
) -> Result<bool, Vec<Formula>> {
    let mut undecided = Vec::new();
    for part in of {
        match part.simplified(decide) {
            Ok(value) if value == decisive => return Ok(decisive),
            Ok(_) => {}
            Err(part) => undecided.push(part),
        }
    }
    if undecided.is_empty() { Ok(!decisive) } else { Err(undecided) }
}

fn joined(mut of: Vec<Formula>, join: impl FnOnce(Vec<Formula>) -> Formula) -> Formula {
    match of.len() {
        1 => of.remove(0),
        _ => join(of),
    }
}

pub(super) fn flatten(expression: &Expression) -> Flat {
    let mut brushes = Vec::new();
    let formula = numbered(expression, &mut brushes);
    Flat { brushes, formula }
}

fn numbered(expression: &Expression, brushes: &mut Vec<Vec<BigPlane>>) -> Formula {
    match expression {
        Expression::Brush(halves) => {
            brushes.push(halves.iter().map(integer_plane).collect());
            Formula::Brush(brushes.len() - 1)
        }
        Expression::Union(of) => Formula::Any(of.iter().map(|e| numbered(e, brushes)).collect()),
        Expression::Intersection(of) => {
            Formula::All(of.iter().map(|e| numbered(e, brushes)).collect())
        }
        Expression::Difference(from, of) => {
            let from = numbered(from, brushes);
            let of = Formula::Any(of.iter().map(|e| numbered(e, brushes)).collect());
            Formula::All(vec![from, Formula::Not(Box::new(of))])
        }
        Expression::Complement(of) => Formula::Not(Box::new(numbered(of, brushes))),
    }
}

fn integer_plane(half: &Half) -> BigPlane {
    let all = || half.normal.iter().chain([&half.offset]);
    let scale = all().fold(Int::from(1), |lcm, c| lcm.lcm(c.denom()));
    let whole = |c: &Rational| (c * &scale).to_integer();
    BigPlane { normal: half.normal.each_ref().map(whole), offset: whole(&half.offset) }
}
