//! Weights with which the vectors of some conditions sum to zero.
//!
//! A search in floats proposes at most seven conditions, whose only dependency is solved for
//! exactly; where that does not do, the simplex method finds a basic solution of `Σ λ_k a_k = 0,
//! Σ λ_k = 1`.

use super::linear::{Solution, solve, solve_nonnegative};
use super::{Condition, Term, edge_vector, in_lowest_terms, order_vector};
use crate::num::{Int, Rational};
use crate::stab::extremal::EdgeName;
use crate::stab::propose::excluding;
use crate::stab::quadric::Vector;
use crate::stab::sequence::Portal3;
use num_traits::{One, Signed, Zero};

/// Weights of few conditions that floats point at; `None` says nothing.
pub(super) fn proposed(portals: &[&Portal3], orders: &[bool]) -> Option<Vec<Term>> {
    let order = |index: usize| order_vector(portals, orders, index);
    let mut chosen: Vec<(Condition, Vector)> = excluding(portals, &order)?
        .into_iter()
        .map(|condition| match condition {
            Condition::Edge(EdgeName { portal, edge }) => {
                Some((condition, edge_vector(portals[portal], edge)))
            }
            Condition::Order { portal } => Some((condition, order(portal)?)),
        })
        .collect::<Option<_>>()?;
    chosen.sort_by_key(|(condition, _)| *condition);
    let (_, last) = chosen.last()?;
    let columns: Vec<Vec<Int>> =
        chosen[..chosen.len() - 1].iter().map(|(_, v)| v.to_vec()).collect();
    let Solution { mut values, divisor } = solve(&columns, &last.each_ref().map(|c| -c))?;
    if values.iter().any(|(_, weight)| weight.is_negative()) {
        return None;
    }
    values.push((columns.len(), divisor));
    Some(terms(&chosen, values))
}

/// Requires: the conditions exclude each other.
pub(super) fn exact(conditions: &[(Condition, Vector)]) -> Vec<Term> {
    let column = |(_, vector): &(Condition, Vector)| -> Vec<Int> {
        vector.iter().cloned().chain(std::iter::once(Int::one())).collect()
    };
    let columns: Vec<Vec<Int>> = conditions.iter().map(column).collect();
    let mut right = vec![Int::zero(); 7];
    right[6] = Int::one();
    let solution = solve_nonnegative(&columns, &right);
    let solution = solution.expect("conditions that no vector satisfies have a dependency");
    terms(conditions, solution.values)
}

fn terms(conditions: &[(Condition, Vector)], values: Vec<(usize, Int)>) -> Vec<Term> {
    let (places, weights): (Vec<usize>, Vec<Rational>) =
        values.into_iter().map(|(at, weight)| (at, Rational::from(weight))).unzip();
    let named = places.iter().map(|&at| conditions[at].0).zip(in_lowest_terms(&weights));
    named.map(|(condition, weight)| Term { condition, weight }).collect()
}
