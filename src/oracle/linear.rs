//! Homogeneous linear systems in three unknowns, decided exactly, with a reason either way.
//!
//! Given weak vectors w_j and strict vectors s_i, either some direction x has w_j·x >= 0 and
//! s_i·x > 0 for all of them, or (Motzkin 1936) some combination Σ λ_j w_j + Σ μ_i s_i = 0 has
//! λ, μ >= 0 and a μ_i > 0. Phase one of the simplex method on the latter, with Bland's rule, so
//! that it ends on degenerate systems too; its dual solution is the direction.
//!
//! Numbers are p + q√d with integers p, q and one d >= 0 for the whole system: a vector may depend
//! on a root of a quadratic. The inverse of the basis is kept as its adjugate and determinant, so
//! that everything stays an integer (Bareiss 1968).
//!
//! Complexity: a pivot costs O(n) products for n vectors; the number of pivots is small in
//! practice and finite always.

use crate::num::{Int, Sign, sign_of_surd};
use num_traits::{One, Zero};

/// p + q√d, where d is known from the context.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Quadratic {
    pub(super) p: Int,
    pub(super) q: Int,
}

/// A vector of R^3.
pub(super) type Vector = [Quadratic; 3];

impl From<Int> for Quadratic {
    fn from(p: Int) -> Quadratic {
        Quadratic { p, q: Int::zero() }
    }
}

/// What became of a system.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Outcome {
    /// This direction satisfies all.
    Direction(Vector),
    /// A combination of just these vectors, with positive weights, is zero. The vectors with these
    /// indices (weak ones first, then the strict ones) have one linear relation up to scale.
    Relation(Vec<usize>),
}

/// Decides the system of `weak` and `strict` vectors over Z[√d].
pub(super) fn decide(weak: &[Vector], strict: &[Vector], d: &Int) -> Outcome {
    Simplex { weak, strict, d }.run()
}

struct Simplex<'a> {
    weak: &'a [Vector],
    strict: &'a [Vector],
    d: &'a Int,
}

/// Four columns, the adjugate of their matrix and its determinant, which is positive.
struct Basis {
    columns: [usize; 4],
    adjugate: [[Quadratic; 4]; 4],
    determinant: Quadratic,
}

impl Simplex<'_> {
    fn run(&self) -> Outcome {
        let total = self.weak.len() + self.strict.len();
        let unit = |i: usize| [0, 1, 2, 3].map(|j| Quadratic::from(Int::from(u8::from(i == j))));
        let mut basis = Basis {
            columns: [0, 1, 2, 3].map(|i| total + i),
            adjugate: [0, 1, 2, 3].map(unit),
            determinant: Quadratic::from(Int::one()),
        };
        loop {
            let dual = self.dual(&basis, total);
            match self.sign(&dual[3]) {
                Sign::Positive => {}
                // The artificial columns are at level zero: the others combine to zero.
                Sign::Zero | Sign::Negative => return self.relation(&basis, total),
            }
            let Some(entering) = (0..total).find(|&j| self.price(&dual, j) == Sign::Positive)
            else {
                let [x, y, z, _] = dual;
                return Outcome::Direction([x, y, z].map(|c| Quadratic { p: -c.p, q: -c.q }));
            };
            self.pivot(&mut basis, entering);
        }
    }

    /// The dual solution of phase one, times the basis's determinant.
    fn dual(&self, basis: &Basis, total: usize) -> [Quadratic; 4] {
        let mut sum = [(); 4].map(|()| Quadratic::from(Int::zero()));
        for (row, &column) in basis.adjugate.iter().zip(&basis.columns) {
            if column >= total {
                for (s, c) in sum.iter_mut().zip(row) {
                    s.p += &c.p;
                    s.q += &c.q;
                }
            }
        }
        sum
    }

    fn relation(&self, basis: &Basis, total: usize) -> Outcome {
        let mut support: Vec<usize> = (0..4)
            .filter(|&i| basis.columns[i] < total)
            .filter(|&i| self.sign(&basis.adjugate[i][3]) == Sign::Positive)
            .map(|i| basis.columns[i])
            .collect();
        support.sort_unstable();
        Outcome::Relation(support)
    }

    /// Column j of the system: the vector, then 1 for a strict one.
    fn column(&self, j: usize) -> (&Vector, bool) {
        match j.checked_sub(self.weak.len()) {
            None => (&self.weak[j], false),
            Some(i) => (&self.strict[i], true),
        }
    }

    fn product_with_column(&self, row: &[Quadratic; 4], j: usize) -> Quadratic {
        let (vector, strict) = self.column(j);
        let mut sum = if strict { row[3].clone() } else { Quadratic::from(Int::zero()) };
        for (a, b) in row.iter().zip(vector) {
            let product = self.mul(a, b);
            sum.p += product.p;
            sum.q += product.q;
        }
        sum
    }

    fn price(&self, dual: &[Quadratic; 4], j: usize) -> Sign {
        self.sign(&self.product_with_column(dual, j))
    }

    fn pivot(&self, basis: &mut Basis, entering: usize) {
        let step = [0, 1, 2, 3].map(|i| self.product_with_column(&basis.adjugate[i], entering));
        let mut leaving: Option<usize> = None;
        for i in 0..4 {
            if self.sign(&step[i]) != Sign::Positive {
                continue;
            }
            let better = leaving.is_none_or(|k| {
                let ours = self.mul(&basis.adjugate[i][3], &step[k]);
                let theirs = self.mul(&basis.adjugate[k][3], &step[i]);
                match self.sign(&difference(&ours, &theirs)) {
                    Sign::Negative => true,
                    // A tie: Bland's rule takes the lower column, so that no basis comes again.
                    Sign::Zero => basis.columns[i] < basis.columns[k],
                    Sign::Positive => false,
                }
            });
            if better {
                leaving = Some(i);
            }
        }
        // The cost of phase one is bounded below, so some column always leaves.
        let Some(leaving) = leaving else { unreachable!("phase one is bounded") };
        let pivot_row = basis.adjugate[leaving].clone();
        for (i, row) in basis.adjugate.iter_mut().enumerate() {
            if i == leaving {
                continue;
            }
            for (entry, pivot_entry) in row.iter_mut().zip(&pivot_row) {
                let minuend = self.mul(entry, &step[leaving]);
                let subtrahend = self.mul(pivot_entry, &step[i]);
                *entry = self.exact_quotient(difference(&minuend, &subtrahend), &basis.determinant);
            }
        }
        basis.columns[leaving] = entering;
        basis.determinant = step[leaving].clone();
    }

    fn sign(&self, x: &Quadratic) -> Sign {
        if x.q.is_zero() { Sign::of(&x.p) } else { sign_of_surd(&x.p, &x.q, self.d) }
    }

    fn mul(&self, x: &Quadratic, y: &Quadratic) -> Quadratic {
        if x.q.is_zero() && y.q.is_zero() {
            return Quadratic::from(&x.p * &y.p);
        }
        Quadratic { p: &x.p * &y.p + &x.q * &y.q * self.d, q: &x.p * &y.q + &x.q * &y.p }
    }

    /// x / y where the quotient is known to lie in Z[√d].
    fn exact_quotient(&self, x: Quadratic, y: &Quadratic) -> Quadratic {
        if y.q.is_zero() {
            return Quadratic { p: x.p / &y.p, q: x.q / &y.p };
        }
        let conjugate = Quadratic { p: y.p.clone(), q: -&y.q };
        let norm = &y.p * &y.p - &y.q * &y.q * self.d;
        let product = self.mul(&x, &conjugate);
        Quadratic { p: product.p / &norm, q: product.q / &norm }
    }
}

fn difference(x: &Quadratic, y: &Quadratic) -> Quadratic {
    Quadratic { p: &x.p - &y.p, q: &x.q - &y.q }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn vector(v: [i64; 3]) -> Vector {
        v.map(|c| Quadratic::from(Int::from(c)))
    }

    fn run(weak: &[[i64; 3]], strict: &[[i64; 3]]) -> Outcome {
        let weak: Vec<Vector> = weak.iter().map(|&v| vector(v)).collect();
        let strict: Vec<Vector> = strict.iter().map(|&v| vector(v)).collect();
        decide(&weak, &strict, &Int::zero())
    }

    #[test]
    fn a_satisfiable_system_gets_a_direction() {
        let weak = [[1, 0, 0], [0, 1, 0], [-1, -1, 3]];
        let strict = [[0, 0, 1], [1, 1, -1]];
        let Outcome::Direction(x) = run(&weak, &strict) else { panic!("satisfiable") };
        let dot = |v: [i64; 3]| -> Int { (0..3).map(|i| &x[i].p * v[i]).sum() };
        assert!(weak.iter().all(|&v| dot(v) >= Int::zero()));
        assert!(strict.iter().all(|&v| dot(v) > Int::zero()));
    }

    #[test]
    fn an_unsatisfiable_system_gets_a_relation() {
        assert_eq!(run(&[], &[[1, 2, 3], [-2, -4, -6]]), Outcome::Relation(vec![0, 1]));
        assert_eq!(run(&[], &[[0, 0, 0]]), Outcome::Relation(vec![0]));
        let around = [[1, 0, 0], [-1, 1, 0], [0, -1, 1], [0, 0, -1]];
        assert_eq!(run(&around[..3], &around[3..]), Outcome::Relation(vec![0, 1, 2, 3]));
        // Without the strict vector the weak ones force x = 0 but exclude nothing.
        assert!(matches!(run(&around, &[]), Outcome::Direction(_)));
    }

    #[test]
    fn roots_may_occur_in_the_vectors() {
        // (1, √2, 0) and (-√2, -2, 0) are opposite only because √2·√2 = 2.
        let q = |p: i64, q: i64| Quadratic { p: Int::from(p), q: Int::from(q) };
        let zero = || q(0, 0);
        let strict = [[q(1, 0), q(0, 1), zero()], [q(0, -1), q(-2, 0), zero()]];
        assert_eq!(decide(&[], &strict, &Int::from(2)), Outcome::Relation(vec![0, 1]));
        assert!(matches!(decide(&[], &strict, &Int::from(3)), Outcome::Direction(_)));
    }
}
