//! Quadric certificates: why no line is strictly inside a sequence though some vector of R^6 is.

use super::{cross, minus};
use crate::forge::input::Polygon;
use crate::num::{Int, Rational};
use num_traits::{Signed, Zero};

/// A linear form of R^6 that is positive, or not negative, on what is refuted.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Form {
    /// The side of an edge, by its portal and its number; positive.
    Edge(usize, usize),
    /// The side of the enclosing split of this depth, turned so that it is not negative.
    Split(usize),
}

/// Why no line is positive on all edges and on its side of the enclosing splits.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Refutation {
    /// The weighted products of forms sum to a multiple of d·m, which is zero on lines.
    Identity {
        /// Not zero.
        multiple: Int,
        /// Positive weights; at least one product is of two edges.
        products: Vec<([Form; 2], Int)>,
    },
    /// The weighted forms sum to zero.
    Linear {
        /// Positive weights; at least one form is an edge's.
        terms: Vec<(Form, Int)>,
    },
    /// Both halves of a split are refuted.
    Split {
        /// Direction and moment.
        plane: [Int; 6],
        /// Where the side of the plane is not negative, and where it is not positive.
        halves: Box<[Refutation; 2]>,
    },
}

/// A vector a of R^6, as the form a_d·m + a_m·d of (d, m).
type Vector = [Rational; 6];

/// Whether the refutation holds for a sequence, in multiples 1 / `unit` of the world's unit.
pub fn refutes(proof: &Refutation, portals: &[Polygon], unit: &Int) -> bool {
    holds(proof, portals, unit, &mut Vec::new())
}

fn holds(proof: &Refutation, portals: &[Polygon], unit: &Int, splits: &mut Vec<Vector>) -> bool {
    match proof {
        Refutation::Identity { multiple, products } => {
            // side(x, a) side(x, b) as a matrix M of the form x M x, symmetric twice over.
            let mut sum: [Vector; 6] = std::array::from_fn(|_| zero());
            let mut has_edges = false;
            for (forms, weight) in products {
                let [Some(a), Some(b)] =
                    forms.each_ref().map(|form| vector(form, portals, unit, splits))
                else {
                    return false;
                };
                has_edges |= forms.iter().all(|form| matches!(form, Form::Edge(..)));
                // The coefficient of x_i in side(x, a) is a_(i+3).
                for (i, row) in sum.iter_mut().enumerate() {
                    for (j, entry) in row.iter_mut().enumerate() {
                        let (p, q) = ((i + 3) % 6, (j + 3) % 6);
                        *entry += (&a[p] * &b[q] + &a[q] * &b[p]) * weight;
                    }
                }
            }
            // Q(x) = d·m: its doubled matrix has ones where i and j are three apart.
            let expected = |i: usize, j: usize| match i % 3 == j % 3 && i != j {
                true => Rational::from(multiple.clone()),
                false => Rational::zero(),
            };
            let equal = (0..6).all(|i| (0..6).all(|j| sum[i][j] == expected(i, j)));
            equal && has_edges && !multiple.is_zero() && all_positive(products)
        }
        Refutation::Linear { terms } => {
            let mut sum = zero();
            for (form, weight) in terms {
                let Some(a) = vector(form, portals, unit, splits) else { return false };
                for (entry, a) in sum.iter_mut().zip(&a) {
                    *entry += a * weight;
                }
            }
            let has_edge = terms.iter().any(|(form, _)| matches!(form, Form::Edge(..)));
            has_edge && all_positive(terms) && sum.iter().all(Zero::is_zero)
        }
        Refutation::Split { plane, halves } => {
            let plane = plane.each_ref().map(|c| Rational::from(c.clone()));
            let turned = plane.each_ref().map(|c| -c);
            [plane, turned].into_iter().zip(halves.iter()).all(|(side, half)| {
                splits.push(side);
                let holds = holds(half, portals, unit, splits);
                splits.pop();
                holds
            })
        }
    }
}

fn zero() -> Vector {
    std::array::from_fn(|_| Rational::zero())
}

fn all_positive<T>(weighted: &[(T, Int)]) -> bool {
    weighted.iter().all(|(_, weight)| weight.is_positive())
}

/// The vector of a form; `None` if there is no such edge or split.
fn vector(form: &Form, portals: &[Polygon], unit: &Int, splits: &[Vector]) -> Option<Vector> {
    match *form {
        Form::Split(depth) => splits.get(depth).cloned(),
        Form::Edge(portal, edge) => {
            let polygon = portals.get(portal).filter(|polygon| edge < polygon.len())?;
            let at = |k: usize| [0, 1, 2].map(|i| &polygon[k % polygon.len()][i] * unit);
            let (p, q) = (at(edge), at(edge + 1));
            let direction = minus(&q, &p);
            let [mx, my, mz] = cross(&p, &direction);
            let [dx, dy, dz] = direction;
            Some([dx, dy, dz, mx, my, mz])
        }
    }
}
