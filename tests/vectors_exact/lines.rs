//! Four lines: those that meet them do, and there are no more, or infinitely many.

use super::{
    Q, Vector, ensure, join, number, point, root_of, side, sign, surd_join, surd_point, zero,
};
use serde_json::Value;
use stabline::vectors::{LineCount, Test};

/// x + y√d.
struct Line {
    parts: [Vector; 2],
    d: Q,
}

impl Line {
    fn meets(&self, given: &[Vector]) -> bool {
        given
            .iter()
            .all(|line| sign(&self.parts.each_ref().map(|part| side(part, line)), &self.d) == 0)
    }

    /// Whether no multiple of one is the other; both are over the same root.
    fn differs(&self, other: &Line) -> bool {
        let d = (&self.d).max(&other.d);
        let minor = |i: usize, j: usize| {
            let product = |i: usize, j: usize| {
                let ([a, b], [e, f]) = (&self.parts, &other.parts);
                [&a[i] * &e[j] + &b[i] * &f[j] * d, &a[i] * &f[j] + &b[i] * &e[j]]
            };
            let (forth, back) = (product(i, j), product(j, i));
            sign(&[&forth[0] - &back[0], &forth[1] - &back[1]], d)
        };
        (0..6).any(|i| (0..i).any(|j| minor(i, j) != 0))
    }
}

/// Checks the lines, and the reason for their number.
pub fn check(test: &Test) -> Result<(), String> {
    let input = test.input.as_ref().ok_or("no lines")?;
    let given: Vec<Vector> = list(&input["lines"])?.iter().map(through).collect();
    let proof = test.certificate.as_ref().ok_or("no certificate")?;
    if test.transversals == Some(LineCount::Family) {
        let three: Vec<Line> = list(&proof["three"])?
            .iter()
            .map(|line| Line { parts: [through(line), zeros()], d: zero() })
            .collect();
        ensure(three.len() == 3, "not three lines")?;
        ensure(three.iter().all(|line| is_finite(line) && line.meets(&given)), "one misses")?;
        return ensure((0..3).all(|i| three[i].differs(&three[(i + 1) % 3])), "one line twice");
    }
    let (finite, infinite) = (list(&proof["lines"])?, list(&proof["at_infinity"])?);
    let told = [LineCount::None, LineCount::One, LineCount::Two].get(finite.len()).copied();
    ensure(told == test.transversals, "another number of lines")?;
    let mut all: Vec<Line> = finite.iter().map(|line| surd_line(&line["points"])).collect();
    ensure(all.iter().all(is_finite), "a line has no direction")?;
    all.extend(infinite.iter().map(|line| at_infinity(&line["normal"])));
    ensure(all.iter().all(|line| line.meets(&given)), "a line misses")?;
    ensure(all.len() < 2 || all[0].differs(&all[1]), "one line twice")?;
    let multiplicities =
        finite.iter().chain(infinite).map(|line| line["multiplicity"].as_u64()).collect::<Vec<_>>();
    let expected: &[Option<u64>] = match quadratic(&given, &proof["quadratic"])? {
        -1 => &[],
        0 => &[Some(2)],
        _ => &[Some(1), Some(1)],
    };
    ensure(multiplicities == expected, "the quadratic equation has another number of roots")
}

/// The sign of its discriminant, after all of it was checked.
fn quadratic(given: &[Vector], told: &Value) -> Result<i32, String> {
    let vectors: Vec<Vector> = list(&told["vectors"])?
        .iter()
        .map(|vector| point(vector).try_into().map_err(|_| "not six numbers".to_owned()))
        .collect::<Result<_, String>>()?;
    let [r, s] = &vectors[..] else { return Err("not two vectors".to_owned()) };
    let [c2, c1, c0] = &point(&told["form"])[..] else { return Err("not three numbers".into()) };
    let is_null = |x: &Vector| given.iter().all(|line| side(x, line) == zero());
    ensure(is_null(r) && is_null(s), "a vector has a side")?;
    ensure(rank(vectors.clone()) == 2 && rank(given.to_vec()) == 4, "vectors are dependent")?;
    let two = number(&Value::from(2));
    let form = [side(r, r) / &two, side(r, s), side(s, s) / &two];
    ensure(form == [c2.clone(), c1.clone(), c0.clone()], "another form")?;
    ensure(form.iter().any(|c| *c != zero()), "the form is zero")?;
    Ok(sign(&[c1 * c1 - c2 * c0 * &two * &two, zero()], &zero()))
}

fn rank(mut rows: Vec<Vector>) -> usize {
    let mut rank = 0;
    for column in 0..6 {
        let Some(at) = (rank..rows.len()).find(|&i| rows[i][column] != zero()) else { continue };
        rows.swap(rank, at);
        let pivot = rows[rank].clone();
        for row in &mut rows[rank + 1..] {
            let factor = &row[column] / &pivot[column];
            row.iter_mut().zip(&pivot).for_each(|(c, p)| *c -= &factor * p);
        }
        rank += 1;
    }
    rank
}

fn list(value: &Value) -> Result<&Vec<Value>, String> {
    value.as_array().ok_or_else(|| "a list is lacking".to_owned())
}

fn zeros() -> Vector {
    std::array::from_fn(|_| zero())
}

fn through(points: &Value) -> Vector {
    join(&point(&points[0]), &point(&points[1]))
}

fn surd_line(points: &Value) -> Line {
    let ([p, u], [q, v]) = (surd_point(&points[0]), surd_point(&points[1]));
    let d = root_of(points);
    Line { parts: surd_join([&p, &u], [&q, &v], &d), d }
}

fn at_infinity(normal: &Value) -> Line {
    let d = root_of(&Value::Array(vec![normal.clone()]));
    let part = |part: Vec<Q>| -> Vector {
        std::array::from_fn(|i| if i < 3 { zero() } else { part[i - 3].clone() })
    };
    Line { parts: surd_point(normal).map(part), d }
}

fn is_finite(line: &Line) -> bool {
    let part = |i: usize| [line.parts[0][i].clone(), line.parts[1][i].clone()];
    (0..3).any(|i| sign(&part(i), &line.d) != 0)
}
