//! Why a sequence is not open: weighted sums of sides, and of products of two sides.

use super::{Point, Q, Vector, edges, ensure, number, zero};
use serde_json::Value;
use stabline::num::Int;

/// The vectors of a portal's edges as proofs scale them: by the vertices' denominators.
fn scaled_edges(portal: &[Point]) -> Vec<Vector> {
    let denominator = |p: &Point| {
        let lcm =
            p.iter().fold(Int::from(1), |common, c| num_integer::lcm(common, c.denom().clone()));
        Q::from(lcm)
    };
    let count = portal.len();
    let scale = |i: usize| denominator(&portal[i]) * denominator(&portal[(i + 1) % count]);
    edges(portal).into_iter().enumerate().map(|(i, edge)| edge.map(|c| c * scale(i))).collect()
}

pub fn check_reason(portals: &[Vec<Point>], reason: &Value) -> Result<(), String> {
    if let Some(text) = reason["refutation"].as_str() {
        let sides = portals.iter().map(|portal| scaled_edges(portal)).collect();
        let mut refutation = Refutation { sides, splits: Vec::new(), words: text.split(' ') };
        refutation.check()?;
        return ensure(refutation.words.next().is_none(), "more than a refutation");
    }
    // In the plane: weighted ends, right ones counted negative, sum to zero with their weights.
    let mut sum = [zero(), zero(), zero()];
    let terms = reason["terms"].as_array().ok_or("neither a refutation nor terms")?;
    for term in terms {
        let portal = &portals[term["portal"].as_u64().ok_or("no portal")? as usize];
        let (end, turn) = if term["end"] == "left" { (&portal[0], 1) } else { (&portal[1], -1) };
        let weight = number(&term["weight"]);
        ensure(weight > zero(), "a weight is not positive")?;
        let weight = weight * Q::from(Int::from(turn));
        sum[0] += &weight * &end[0];
        sum[1] += &weight * &end[1];
        sum[2] += weight;
    }
    ensure(!terms.is_empty() && sum.iter().all(|c| *c == zero()), "the weighted sum is not zero")
}

/// A refutation of `docs/formats/proof.md`.
struct Refutation<'a> {
    sides: Vec<Vec<Vector>>,
    splits: Vec<Vector>,
    words: std::str::Split<'a, char>,
}

impl Refutation<'_> {
    fn word(&mut self) -> Result<&str, String> {
        self.words.next().ok_or_else(|| "the refutation ends early".to_owned())
    }

    fn integer(&mut self) -> Result<Q, String> {
        let parsed = self.word()?.parse::<Int>();
        parsed.map(Q::from).map_err(|error| error.to_string())
    }

    fn factor(&mut self) -> Result<(Vector, bool), String> {
        let word = self.word()?.to_owned();
        let number = |text: &str| text.parse::<usize>().map_err(|error| error.to_string());
        if let Some(split) = word.strip_prefix('h') {
            let plane = self.splits.get(number(split)?).ok_or("no such split")?;
            return Ok((plane.clone(), false));
        }
        let (portal, edge) = word.split_once('.').ok_or("no factor")?;
        let edges = self.sides.get(number(portal)?).ok_or("no such portal")?;
        Ok((edges.get(number(edge)?).ok_or("no such edge")?.clone(), true))
    }

    fn check(&mut self) -> Result<(), String> {
        let kind = self.word()?.to_owned();
        if kind == "s" {
            let mut plane: Vector = std::array::from_fn(|_| zero());
            for c in &mut plane {
                *c = self.integer()?;
            }
            for half in [plane.clone(), plane.map(|c| -c)] {
                self.splits.push(half);
                self.check()?;
                self.splits.pop();
            }
            return Ok(());
        }
        let multiple = if kind == "i" { self.integer()? } else { zero() };
        let count = self.integer()?;
        let mut sum: [Vector; 6] = std::array::from_fn(|_| std::array::from_fn(|_| zero()));
        let mut line: Vector = std::array::from_fn(|_| zero());
        let (mut is_strict, mut done) = (false, zero());
        while done < count {
            done += Q::from(Int::from(1));
            let (f, f_strict) = self.factor()?;
            if kind == "l" {
                let weight = self.integer()?;
                ensure(weight > zero(), "a weight is not positive")?;
                line.iter_mut().zip(&f).for_each(|(sum, c)| *sum += &weight * c);
                is_strict |= f_strict;
                continue;
            }
            let (g, g_strict) = self.factor()?;
            let weight = self.integer()?;
            ensure(weight > zero(), "a weight is not positive")?;
            is_strict |= f_strict && g_strict;
            for (a, b) in (0..36).map(|at| (at / 6, at % 6)) {
                sum[a.min(b)][a.max(b)] += &weight * &f[(a + 3) % 6] * &g[(b + 3) % 6];
            }
        }
        (0..3).for_each(|i| sum[i][i + 3] -= &multiple);
        ensure(is_strict && (kind == "l") == (multiple == zero()), "nothing strict takes part")?;
        ensure(sum.iter().flatten().chain(&line).all(|c| *c == zero()), "the sum is another")
    }
}
