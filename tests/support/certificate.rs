//! An independent check of certificates: big rationals only, and nothing of the engine.

use num_traits::{Signed, Zero};
use stabline::geom::BigPoint3;
use stabline::num::Rational;
use stabline::stab::{Certificate, Condition, Factor, QuadricProof};

type Vector = [Rational; 6];

/// Why a certificate does not show that a sequence is not open, or that it does. `ordered` allows
/// conditions on the order of consecutive portals.
pub fn check(
    portals: &[Vec<BigPoint3>],
    ordered: bool,
    certificate: &Certificate,
) -> Result<(), String> {
    let checker = Checker { portals, ordered };
    match certificate {
        Certificate::Gordan(terms) => {
            let terms =
                terms.iter().map(|t| (Factor::Condition(t.condition), t.weight.clone().into()));
            checker.vanishes(&terms.collect::<Vec<_>>(), &[])
        }
        Certificate::Quadric(proof) => checker.refutes(proof, &mut Vec::new()),
    }
}

struct Checker<'a> {
    portals: &'a [Vec<BigPoint3>],
    ordered: bool,
}

impl Checker<'_> {
    /// Whether the proof refutes the part that the planes' positive sides leave.
    fn refutes(&self, proof: &QuadricProof, planes: &mut Vec<Vector>) -> Result<(), String> {
        match proof {
            QuadricProof::Identity { multiple, products } => {
                let multiple = Rational::from(multiple.clone());
                if multiple.is_zero() {
                    return Err("the multiple is zero".to_owned());
                }
                // The symmetric matrix of Σ weight side(x, a) side(x, b), twice.
                let mut sum: [Vector; 6] = std::array::from_fn(|_| zero());
                let mut strict = false;
                for product in products {
                    let weight = positive(product.weight.clone().into())?;
                    let [a, b] = product.factors.map(|factor| self.form(factor, planes));
                    let (a, b) = (a?, b?);
                    for i in 0..6 {
                        for j in 0..6 {
                            sum[i][j] += &weight * (&a[i] * &b[j] + &a[j] * &b[i]);
                        }
                    }
                    strict |= product.factors.iter().all(|f| matches!(f, Factor::Condition(_)));
                }
                // That of multiple · d·m.
                let klein = |i: usize, j: usize| match (i + 3) % 6 == j {
                    true => multiple.clone(),
                    false => Rational::zero(),
                };
                let holds = (0..6).all(|i| (0..6).all(|j| sum[i][j] == klein(i, j)));
                match (holds, strict) {
                    (true, true) => Ok(()),
                    (true, false) => Err("no product is of two conditions".to_owned()),
                    (false, _) => Err("the identity does not hold".to_owned()),
                }
            }
            QuadricProof::Linear { terms } => {
                let terms: Vec<_> = terms.iter().map(|(f, w)| (*f, w.clone().into())).collect();
                self.vanishes(&terms, planes)
            }
            QuadricProof::Split { plane, positive, negative } => {
                let plane = plane.clone().map(Rational::from);
                for (half, side) in [(positive, plane.clone()), (negative, plane.map(|c| -c))] {
                    planes.push(side);
                    self.refutes(half, planes)?;
                    planes.pop();
                }
                Ok(())
            }
        }
    }

    /// Whether the weighted sum of the factors is the zero form.
    fn vanishes(&self, terms: &[(Factor, Rational)], planes: &[Vector]) -> Result<(), String> {
        let mut sum = zero();
        for (factor, weight) in terms {
            let (form, weight) = (self.form(*factor, planes)?, positive(weight.clone())?);
            sum.iter_mut().zip(&form).for_each(|(sum, c)| *sum += &weight * c);
        }
        if !terms.iter().any(|(factor, _)| matches!(factor, Factor::Condition(_))) {
            return Err("no term is a condition".to_owned());
        }
        match sum.iter().all(Zero::is_zero) {
            true => Ok(()),
            false => Err("the sum is not zero".to_owned()),
        }
    }

    /// The coefficients of side(·, factor) on (direction, moment).
    fn form(&self, factor: Factor, planes: &[Vector]) -> Result<Vector, String> {
        let vector = match factor {
            Factor::Condition(condition) => self.vector(condition)?,
            Factor::Split(depth) => {
                planes.get(depth).cloned().ok_or(format!("there is no split {depth}"))?
            }
        };
        let [dx, dy, dz, mx, my, mz] = vector;
        Ok([mx, my, mz, dx, dy, dz])
    }

    fn vector(&self, condition: Condition) -> Result<Vector, String> {
        let missing = || format!("there is no {condition:?}");
        match condition {
            Condition::Edge(name) => {
                let portal = self.portals.get(name.portal).ok_or_else(missing)?;
                let p = point(portal.get(name.edge).ok_or_else(missing)?);
                let q = point(&portal[(name.edge + 1) % portal.len()]);
                let ([dx, dy, dz], [mx, my, mz]) = (minus(&q, &p), cross(&p, &q));
                Ok([dx, dy, dz, mx, my, mz])
            }
            Condition::Order { portal } => {
                if !self.ordered || portal == 0 || portal >= self.portals.len() {
                    return Err(missing());
                }
                let [(n, c), (m, d)] = [portal - 1, portal].map(|i| plane(&self.portals[i]));
                let [dx, dy, dz] = cross(&n, &m);
                let moment = |i: usize| &d * &n[i] - &c * &m[i];
                Ok([dx, dy, dz, moment(0), moment(1), moment(2)])
            }
        }
    }
}

/// A portal's plane: its primitive integer normal and the offset.
fn plane(portal: &[BigPoint3]) -> ([Rational; 3], Rational) {
    let points: Vec<[Rational; 3]> = portal.iter().map(point).collect();
    let mut area = [(); 3].map(|()| Rational::zero());
    for i in 1..points.len() - 1 {
        let part = cross(&minus(&points[i], &points[0]), &minus(&points[i + 1], &points[0]));
        area.iter_mut().zip(part).for_each(|(sum, c)| *sum += c);
    }
    // Of integers: Euclid's algorithm.
    let mut content = Rational::zero();
    for c in &area {
        let (mut a, mut b) = (content, c.abs());
        while !b.is_zero() {
            let rest = &a - (&a / &b).floor() * &b;
            (a, b) = (b, rest);
        }
        content = a;
    }
    let normal = area.map(|c| c / &content);
    let offset = (0..3).map(|i| &normal[i] * &points[0][i]).sum();
    (normal, offset)
}

fn point(p: &BigPoint3) -> [Rational; 3] {
    p.coordinates.clone().map(Rational::from)
}

fn minus(p: &[Rational; 3], q: &[Rational; 3]) -> [Rational; 3] {
    [0, 1, 2].map(|i| &p[i] - &q[i])
}

fn cross(p: &[Rational; 3], q: &[Rational; 3]) -> [Rational; 3] {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| &p[i] * &q[j] - &p[j] * &q[i])
}

fn zero() -> Vector {
    std::array::from_fn(|_| Rational::zero())
}

fn positive(weight: Rational) -> Result<Rational, String> {
    match weight.is_positive() {
        true => Ok(weight),
        false => Err(format!("the weight {weight} is not positive")),
    }
}
