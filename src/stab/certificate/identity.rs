//! A multiple of the Klein form as a combination of products of a part's facets.
//!
//! With weights c >= 0 and the sign s of the form Q on the part, `s Q = Σ c_ij a_i a_j` is a system
//! of 21 equations. Products of other rows are combinations of products of facets, so facets are
//! enough. The bilinear forms of both sides agree on any two rays r, t of the part, where each a_i
//! is not negative:
//! 1. where `s side(r, t) < 0` for some two rays, there is no combination;
//! 2. where `side(r, t) = 0`, no product has a weight of which one factor is positive on r and the
//!    other on t.

use super::linear::{Solution, solve, solve_nonnegative};
use super::part::{Part, Shape};
use super::{Factor, Product, QuadricProof, in_lowest_terms};
use crate::num::{Int, Rational, Sign};
use crate::stab::propose::{Pairs, basic_products};
use crate::stab::quadric::Vector;
use num_traits::{Signed, Zero};

/// The identity that refutes the part, where floats see that there is one.
pub(super) fn identity(part: &Part, shape: &Shape<'_>) -> Option<QuadricProof> {
    if is_hopeless(shape) {
        return None;
    }
    let allowed = allowed_products(shape);
    let basis = basic_products(&Pairs::new(&shape.values, &shape.sides), &allowed)?;
    let chosen: Vec<[usize; 2]> = basis.into_iter().map(|at| allowed[at]).collect();
    let solution = solve(&system(shape, &chosen), &klein_form(shape.sign));
    match solution.filter(|s| s.values.iter().all(|(_, weight)| weight.is_positive())) {
        Some(solution) => named(part, shape, &solution, &chosen),
        // The case is critical, and floats did not see which products it needs.
        None => exact_identity(part, shape),
    }
}

/// The identity that refutes the part, where there is one.
pub(super) fn exact_identity(part: &Part, shape: &Shape<'_>) -> Option<QuadricProof> {
    if is_hopeless(shape) {
        return None;
    }
    let allowed = allowed_products(shape);
    let solution = solve_nonnegative(&system(shape, &allowed), &klein_form(shape.sign))?;
    named(part, shape, &solution, &allowed)
}

/// Whether two rays have a side product of the sign that the form lacks on the part.
fn is_hopeless(shape: &Shape<'_>) -> bool {
    shape.sides.iter().flatten().any(Int::is_negative)
}

/// The coefficients of the products, each a column.
fn system(shape: &Shape<'_>, pairs: &[[usize; 2]]) -> Vec<Vec<Int>> {
    let column = |&[i, j]: &[usize; 2]| product(&shape.facets[i].form, &shape.facets[j].form);
    pairs.iter().map(column).collect()
}

/// The pairs of facets whose products may have weights.
fn allowed_products(shape: &Shape<'_>) -> Vec<[usize; 2]> {
    let count = shape.facets.len();
    let positive_on = |ray: usize| (0..count).filter(move |&i| !shape.values[i][ray].is_zero());
    let positive: Vec<Vec<usize>> =
        (0..shape.rays.len()).map(|ray| positive_on(ray).collect()).collect();
    let mut forbidden = vec![false; count * count];
    for (k, sides) in shape.sides.iter().enumerate() {
        for l in (0..=k).filter(|&l| sides[l].is_zero()) {
            for &i in &positive[k] {
                for &j in &positive[l] {
                    forbidden[i.max(j) * count + i.min(j)] = true;
                }
            }
        }
    }
    let pairs = (0..count).flat_map(|j| (0..=j).map(move |i| [i, j]));
    pairs.filter(|[i, j]| !forbidden[j * count + i]).collect()
}

/// The coefficients of a quadratic form, by pairs of coordinates.
fn product(a: &Vector, b: &Vector) -> Vec<Int> {
    let coefficient = |(i, j): (usize, usize)| match i == j {
        true => &a[i] * &b[i],
        false => &a[i] * &b[j] + &a[j] * &b[i],
    };
    coordinates().map(coefficient).collect()
}

/// The coefficients of Q or, for a negative sign, of -Q.
fn klein_form(sign: Sign) -> Vec<Int> {
    let unit = Int::from(if sign == Sign::Negative { -1 } else { 1 });
    coordinates().map(|(i, j)| if i + 3 == j { unit.clone() } else { Int::zero() }).collect()
}

fn coordinates() -> impl Iterator<Item = (usize, usize)> {
    (0..6).flat_map(|i| (i..6).map(move |j| (i, j)))
}

/// The identity with the whole factors.
fn named(
    part: &Part,
    shape: &Shape<'_>,
    solution: &Solution,
    pairs: &[[usize; 2]],
) -> Option<QuadricProof> {
    let unit = part.frame().unit();
    let signed =
        if shape.sign == Sign::Negative { -&solution.divisor } else { solution.divisor.clone() };
    let mut numbers = vec![Rational::new(signed, unit.clone())];
    let mut factors = Vec::new();
    for (at, weight) in &solution.values {
        let rows = pairs[*at].map(|facet| shape.facets[facet]);
        let [i, j] = rows.map(|row| &row.content);
        numbers.push(Rational::new(weight.clone(), i * j));
        let mut both = rows.map(|row| row.factor);
        both.sort();
        factors.push(both);
    }
    let mut numbers = in_lowest_terms(&numbers).into_iter();
    let multiple = numbers.next()?;
    let mut products: Vec<Product> = factors
        .into_iter()
        .zip(numbers)
        .map(|(factors, weight)| Product { factors, weight })
        .collect();
    products.sort_by_key(|product| product.factors);
    // A product of conditions is positive on a line strictly inside, and no term is negative.
    let strict =
        |product: &Product| product.factors.iter().all(|f| matches!(f, Factor::Condition(_)));
    products.iter().any(strict).then_some(QuadricProof::Identity { multiple, products })
}
