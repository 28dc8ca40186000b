//! The twin for four lines: how many lines meet them, point by point of one of them.
//!
//! Let P run along a line `l`, in homogeneous coordinates, P = s·A + t·B. The lines through P that
//! meet another line m are those of the plane of P and m, whose coordinates are linear in (s, t);
//! so the one line through P that meets m and n has coordinates that are quadratic in (s, t), and
//! it meets the fourth line where a quadratic form f vanishes. Take for `l` a line that does not
//! itself meet all others: then different P have different lines, f = 0 everywhere means infinitely
//! many, and else each root has one line or, where the planes of P with the others are all the
//! same, a pencil. If all lines meet each other they are concurrent or coplanar. No Plücker space,
//! no null spaces, no quadric.

use crate::num::{Int, Rational, Sign};
use num_integer::Integer;
use num_traits::{One, Signed, Zero};

/// How many lines at a finite place meet four lines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeetingLines {
    /// No line.
    None,
    /// One, perhaps a double one.
    One,
    /// Two.
    Two,
    /// Infinitely many.
    Family,
}

/// A point or a plane in homogeneous coordinates.
type Four = [Int; 4];

/// Counts the lines that meet four lines, each given by two distinct points.
pub fn meeting_lines(lines: &[[[Rational; 3]; 2]; 4]) -> MeetingLines {
    let lines: Vec<[Four; 2]> = lines.iter().map(|ends| ends.each_ref().map(homogeneous)).collect();
    let misses_one = |&i: &usize| lines.iter().any(|m| !determinant(&lines[i], m).is_zero());
    let Some(base) = (0..4).find(misses_one) else { return MeetingLines::Family };
    let [a, b] = &lines[base];
    let others: Vec<&[Four; 2]> = (0..4).filter(|&i| i != base).map(|i| &lines[i]).collect();
    // The planes of A and of B with each of the others.
    let planes: Vec<[Four; 2]> =
        others.iter().map(|[p, q]| [plane(a, p, q), plane(b, p, q)]).collect();
    let [p, q] = others[2];
    // Where the planes u and v meet, the line with points p, q is met iff u(p) v(q) = u(q) v(p).
    let form = |u: &Four, v: &Four| dot(u, p) * dot(v, q) - dot(u, q) * dot(v, p);
    let [u, v] = [&planes[0], &planes[1]];
    let (c0, c2) = (form(&u[0], &v[0]), form(&u[1], &v[1]));
    let c1 = form(&u[0], &v[1]) + form(&u[1], &v[0]);
    if [&c0, &c1, &c2].iter().all(|c| c.is_zero()) {
        return MeetingLines::Family;
    }
    let discriminant = &c1 * &c1 - Int::from(4) * &c0 * &c2;
    let root = match Sign::of(&discriminant) {
        Sign::Negative => return MeetingLines::None,
        Sign::Zero | Sign::Positive => discriminant.sqrt(),
    };
    if &root * &root != discriminant {
        // At irrational points no two of the planes are the same, and P is not at infinity.
        return MeetingLines::Two;
    }
    let mut count = 0;
    for (s, t) in roots(&c0, &c1, &c2, &root) {
        let at: Vec<Four> =
            planes.iter().map(|[a, b]| std::array::from_fn(|i| &a[i] * &s + &b[i] * &t)).collect();
        match line_of(&at) {
            None => return MeetingLines::Family,
            Some(is_finite) => count += usize::from(is_finite),
        }
    }
    [MeetingLines::None, MeetingLines::One, MeetingLines::Two][count]
}

/// The distinct zeros (s : t) of c0 s² + c1 s t + c2 t², whose discriminant has this root.
fn roots(c0: &Int, c1: &Int, c2: &Int, root: &Int) -> Vec<(Int, Int)> {
    let two = Int::from(2);
    let pairs = if c0.is_zero() {
        // t (c1 s + c2 t).
        vec![(Int::one(), Int::zero()), (-c2, c1.clone())]
    } else {
        vec![(-c1 + root, &two * c0), (-c1 - root, &two * c0)]
    };
    let mut distinct: Vec<(Int, Int)> = Vec::new();
    for (s, t) in pairs.into_iter().filter(|(s, t)| !s.is_zero() || !t.is_zero()) {
        if distinct.iter().all(|(x, y)| x * &t != y * &s) {
            distinct.push((s, t));
        }
    }
    distinct
}

/// Whether the one line of all planes is at a finite place; `None` if the planes are one.
fn line_of(planes: &[Four]) -> Option<bool> {
    let pairs = (0..planes.len()).flat_map(|i| (0..i).map(move |j| (i, j)));
    let mut differ = false;
    for (u, v) in pairs.map(|(i, j)| (&planes[i], &planes[j])) {
        let minor = |i: usize, j: usize| &u[i] * &v[j] - &u[j] * &v[i];
        // The direction of the meet is the cross product of the normals.
        if [(0, 1), (0, 2), (1, 2)].iter().any(|&(i, j)| !minor(i, j).is_zero()) {
            return Some(true);
        }
        differ |= (0..3).any(|i| !minor(i, 3).is_zero());
    }
    differ.then_some(false)
}

fn homogeneous(point: &[Rational; 3]) -> Four {
    let weight = point.iter().fold(Int::one(), |common, c| common.lcm(c.denom()));
    let scaled = |c: &Rational| c.numer() * (&weight / c.denom());
    let [x, y, z] = point.each_ref().map(scaled);
    debug_assert!(weight.is_positive());
    [x, y, z, weight]
}

fn dot(a: &Four, b: &Four) -> Int {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The plane through three points: the cofactors of their matrix.
fn plane(a: &Four, b: &Four, c: &Four) -> Four {
    let minor = |i: usize, j: usize, k: usize| {
        &a[i] * (&b[j] * &c[k] - &b[k] * &c[j]) - &a[j] * (&b[i] * &c[k] - &b[k] * &c[i])
            + &a[k] * (&b[i] * &c[j] - &b[j] * &c[i])
    };
    [minor(1, 2, 3), -minor(0, 2, 3), minor(0, 1, 3), -minor(0, 1, 2)]
}

fn determinant([a, b]: &[Four; 2], [c, d]: &[Four; 2]) -> Int {
    dot(&plane(a, b, c), d)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn count(lines: [[[i64; 3]; 2]; 4]) -> MeetingLines {
        meeting_lines(&lines.map(|ends| ends.map(|p| p.map(|c| Rational::from(Int::from(c))))))
    }

    const X: [[i64; 3]; 2] = [[0, 0, 0], [1, 0, 0]];
    const Y: [[i64; 3]; 2] = [[0, 0, 0], [0, 1, 0]];
    const Z: [[i64; 3]; 2] = [[0, 0, 0], [0, 0, 1]];

    #[test]
    fn known_answers() {
        let ruled = [X, [[0, 1, 0], [1, 1, 1]], [[0, 2, 0], [1, 2, 2]]];
        let with = |fourth| count([ruled[0], ruled[1], ruled[2], fourth]);
        assert_eq!(with([[0, 0, 2], [1, 1, 2]]), MeetingLines::Two);
        assert_eq!(with([[0, 0, -2], [1, 1, -2]]), MeetingLines::None);
        assert_eq!(with([[0, 0, 0], [1, 1, 0]]), MeetingLines::One);
        // Once at a finite place, and once at infinity.
        assert_eq!(with([[3, 4, 0], [3, 4, 1]]), MeetingLines::One);
        assert_eq!(with([[0, 5, 0], [1, 5, 5]]), MeetingLines::Family);
        assert_eq!(count([X, Y, Z, [[3, 4, 5], [4, 4, 6]]]), MeetingLines::Family);
        assert_eq!(count([X, Y, Z, [[0, 0, 0], [1, 1, 1]]]), MeetingLines::Family);
        assert_eq!(count([X, X, X, X]), MeetingLines::Family);
        // Two lines that meet, and two others: the line through the point and the one in the plane.
        let far = [[3, 4, 5], [4, 4, 6]];
        assert_eq!(count([X, Y, far, [[1, 7, 2], [2, 9, -1]]]), MeetingLines::Two);
    }
}
