//! The point of least norm in the convex hull of vectors of R^6 (Wolfe 1976).
//!
//! Let the vectors be the half-spaces of a portal sequence: x is inside iff `x · v > 0` for each.
//! A point x of the hull with positive norm and least is itself inside all of them, with the
//! widest margin; if the hull contains the origin, the vectors that combine to it (seven at most)
//! are a proposal for Gordan's certificate that no x is inside.

/// A half-space of R^6 through the origin: `x · v > 0`.
pub(crate) type Half = [f64; 6];

/// What the search for the least point came to.
#[derive(Clone, Debug)]
pub(crate) enum Outcome {
    /// Strictly inside all half-spaces, as far as floats can tell.
    Inside(Half),
    /// The indices of half-spaces that seem to exclude each other.
    Excluded(Vec<u32>),
}

/// The state of a search; it may be continued when half-spaces are added.
#[derive(Clone, Copy, Default, Debug)]
pub(crate) struct NormPoint {
    corral: Corral,
}

/// Affinely independent vectors whose hull's least point is the current one, with weights.
#[derive(Clone, Copy, Default, Debug)]
struct Corral {
    members: [(u32, f64); 7],
    count: usize,
}

impl Corral {
    fn members(&self) -> &[(u32, f64)] {
        &self.members[..self.count]
    }

    fn weights(&mut self) -> impl Iterator<Item = &mut f64> {
        self.members[..self.count].iter_mut().map(|member| &mut member.1)
    }

    /// Requires: fewer than seven members.
    fn push(&mut self, index: u32, weight: f64) {
        self.members[self.count] = (index, weight);
        self.count += 1;
    }

    fn remove(&mut self, place: usize) {
        self.members[place..self.count].rotate_left(1);
        self.count -= 1;
    }
}

const ROUNDS: usize = 60;

/// Below this norm a point is taken for the origin: a few roundings of vectors of norm one.
const NOTHING: f64 = 1e-14;

pub(crate) fn dot(a: &Half, b: &Half) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3] + a[4] * b[4] + a[5] * b[5]
}

fn subtract(a: &mut Half, factor: f64, b: &Half) {
    for (a, b) in a.iter_mut().zip(b) {
        *a -= factor * b;
    }
}

impl NormPoint {
    /// Searches the least point of the hull of `halves` (each of norm one), from where the last
    /// call with fewer of them ended. `widest` asks for the least point itself; otherwise the
    /// search ends at the first point that is inside.
    pub fn search(&mut self, halves: &[Half], widest: bool) -> Outcome {
        // The half-spaces may have been scaled since: the corral keeps its members only.
        let equal = 1.0 / self.corral.count as f64;
        self.corral.weights().for_each(|weight| *weight = equal);
        let mut columns = Orthogonal::default();
        let mut x = match self.settle(halves, &mut columns) {
            Some(x) => x,
            None => {
                self.corral = Corral::default();
                self.corral.push(0, 1.0);
                halves[0]
            }
        };
        for _ in 0..ROUNDS {
            let norm2 = dot(&x, &x);
            if norm2 < NOTHING * NOTHING {
                return self.excluded();
            }
            let (least, value) = least(halves, &x);
            if value > 0.0 && (!widest || value > norm2 * 0.98) {
                return Outcome::Inside(x);
            }
            if value >= norm2 * (1.0 - 1e-9)
                || self.corral.count == self.corral.members.len()
                || self.corral.members().iter().any(|member| member.0 == least)
            {
                break;
            }
            self.corral.push(least, 0.0);
            match self.settle(halves, &mut columns) {
                Some(next) => x = next,
                None => break,
            }
        }
        let (_, value) = least(halves, &x);
        if value > 0.0 { Outcome::Inside(x) } else { self.excluded() }
    }

    fn excluded(&self) -> Outcome {
        Outcome::Excluded(self.corral.members().iter().map(|member| member.0).collect())
    }

    /// Moves the weights to the least point of the corral's hull, dropping what gets no weight.
    fn settle(&mut self, halves: &[Half], columns: &mut Orthogonal) -> Option<Half> {
        while self.corral.count > 0 {
            let (target, x) = columns.affine_least(halves, self.corral.members())?;
            let mut step = 1.0f64;
            let mut blocking = None;
            for (i, (&(_, now), &then)) in self.corral.members().iter().zip(&target).enumerate() {
                if then <= 1e-14 {
                    let reach = now / (now - then);
                    if blocking.is_none() || reach < step {
                        step = reach.clamp(0.0, 1.0);
                        blocking = Some(i);
                    }
                }
            }
            for (now, then) in self.corral.weights().zip(&target) {
                *now += step * (then - *now);
            }
            match blocking {
                None => return Some(x),
                Some(i) => {
                    self.corral.remove(i);
                }
            }
        }
        None
    }
}

fn least(halves: &[Half], x: &Half) -> (u32, f64) {
    let mut best = (0, f64::INFINITY);
    for (i, half) in halves.iter().enumerate() {
        let value = dot(x, half);
        if value < best.1 {
            best = (i as u32, value);
        }
    }
    best
}

/// The differences of a corral's members from its first, orthogonalised (twice, which keeps the
/// result orthogonal to full precision: thin cones have least points of norm 1e-10).
///
/// A column depends on the members before it only, so what is known of a corral's first members
/// serves however the others change.
#[derive(Default)]
struct Orthogonal {
    /// The members whose columns are known.
    members: [u32; 7],
    known: usize,
    /// Column `i` belongs to member `i + 1`.
    q: [Half; 6],
    r: [[f64; 6]; 6],
}

impl Orthogonal {
    /// Brings the columns up to date; `false` if the members are not affinely independent.
    fn update(&mut self, halves: &[Half], corral: &[(u32, f64)]) -> bool {
        let kept = self.members[..self.known].iter().zip(corral);
        self.known = kept.take_while(|(known, member)| **known == member.0).count();
        let base = halves[corral[0].0 as usize];
        for i in self.known..corral.len() {
            self.members[i] = corral[i].0;
            if i > 0 {
                let mut column = halves[corral[i].0 as usize];
                subtract(&mut column, 1.0, &base);
                let length = self.orthogonalise(i - 1, &mut column);
                if length < NOTHING {
                    return false;
                }
                self.q[i - 1] = column.map(|c| c / length);
            }
            self.known = i + 1;
        }
        true
    }

    /// Makes `column` orthogonal to the columns before `place`; its length then.
    fn orthogonalise(&mut self, place: usize, column: &mut Half) -> f64 {
        let mut along = [0.0; 6];
        for _ in 0..2 {
            for (q, along) in self.q[..place].iter().zip(&mut along) {
                let more = dot(q, column);
                *along += more;
                subtract(column, more, q);
            }
        }
        along[place] = dot(column, column).sqrt();
        for (row, along) in self.r.iter_mut().zip(along) {
            row[place] = along;
        }
        along[place]
    }

    /// The least point of the affine hull of the corral, and its weights.
    fn affine_least(&mut self, halves: &[Half], corral: &[(u32, f64)]) -> Option<([f64; 7], Half)> {
        if !self.update(halves, corral) {
            return None;
        }
        let columns = corral.len() - 1;
        let mut x = halves[corral[0].0 as usize];
        let mut right = [0.0f64; 6];
        for _ in 0..2 {
            for (q, right) in self.q[..columns].iter().zip(&mut right) {
                let along = dot(q, &x);
                *right -= along;
                subtract(&mut x, along, q);
            }
        }
        let mut weights = [0.0f64; 7];
        for i in (0..columns).rev() {
            let rest: f64 = (i + 1..columns).map(|k| self.r[i][k] * weights[k + 1]).sum();
            weights[i + 1] = (right[i] - rest) / self.r[i][i];
        }
        weights[0] = 1.0 - weights[1..=columns].iter().sum::<f64>();
        Some((weights, x))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn unit(i: usize, sign: f64) -> Half {
        let mut v = [0.0; 6];
        v[i] = sign;
        v
    }

    #[test]
    fn an_orthant_is_inside_and_opposites_exclude() {
        let mut halves: Vec<Half> = (0..6).map(|i| unit(i, 1.0)).collect();
        let mut search = NormPoint::default();
        match search.search(&halves, true) {
            Outcome::Inside(x) => assert!(halves.iter().all(|h| dot(h, &x) > 0.0)),
            Outcome::Excluded(_) => panic!("the orthant has an inside"),
        }
        halves.push(unit(2, -1.0));
        match search.search(&halves, true) {
            Outcome::Inside(_) => panic!("opposite half-spaces have no common inside"),
            Outcome::Excluded(set) => {
                let mut set = set;
                set.sort_unstable();
                assert_eq!(set, [2, 6]);
            }
        }
    }
}
