//! The transversals of four lines as polynomials in their coordinates, for every kind of number.
//!
//! Lines are vectors (direction, moment) of R^6, and x·y is their side product. Let S be the Gram
//! matrix of the four lines, D its determinant, ω(f, e) = det(l1, l2, l3, l4, f, e), and for a
//! vector f let H(f)·e be the 5x5 determinant of S bordered by f and e, and W(f)·e = ω(f, e).
//! H(f) is f's projection onto the lines' complement, D times; W(f) is there too, perpendicular to
//! f, and since the side product has the determinant -1, W·W = -H(f)·f while H·H = D·(H(f)·f). So
//!
//! ```text
//!     (H ± √D·W)·(H ± √D·W) = H·H + D·W·W = 0:
//! ```
//!
//! both are transversals: each in a scale that is the other's side of f, and zero where the other
//! meets f.

use crate::num::Sign;
use crate::predicates::ring::{Ring, cross, difference, dot};

/// Direction and moment.
pub type Vector<T> = [T; 6];

/// The side products of four lines: S12, S13, S14, S23, S24, S34.
pub type Products<T> = [T; 6];

/// The two lines of each product, in that order; counted from the end, the other two.
pub const PAIRS: [[usize; 2]; 6] = [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]];

/// x·y.
#[inline(always)]
pub fn side<T: Ring>(x: &Vector<T>, y: &Vector<T>) -> T {
    let term = |i: usize| x[i].times(&y[i + 3]).plus(&x[i + 3].times(&y[i]));
    term(0).plus(&term(1)).plus(&term(2))
}

/// All side products.
#[inline(always)]
pub fn products<T: Ring>(lines: &[Vector<T>; 4]) -> Products<T> {
    PAIRS.map(|[i, j]| side(&lines[i], &lines[j]))
}

/// a = S12·S34, b = S13·S24 and c = S14·S23, on which D depends.
#[inline(always)]
pub fn opposite<T: Ring>(s: &Products<T>) -> [T; 3] {
    [s[0].times(&s[5]), s[1].times(&s[4]), s[2].times(&s[3])]
}

/// D = (a-b-c)² - 4bc.
#[inline(always)]
pub fn discriminant<T: Ring>([a, b, c]: &[T; 3]) -> T {
    let (difference, twice) = (a.minus(b).minus(c), b.plus(b));
    difference.times(&difference).minus(&twice.times(&c.plus(c)))
}

/// The adjugate of S.
#[inline(always)]
pub fn adjugate<T: Ring>(s: &Products<T>, [a, b, c]: &[T; 3]) -> [[T; 4]; 4] {
    let [ta, tb, tc] = [a.minus(b).minus(c), b.minus(a).minus(c), c.minus(a).minus(b)];
    let [s12, s13, s14, s23, s24, s34] = s;
    let (a12, a34) = (s34.times(&ta), s12.times(&ta));
    let (a13, a24) = (s24.times(&tb), s13.times(&tb));
    let (a14, a23) = (s23.times(&tc), s14.times(&tc));
    let twice = |x: &T, y: &T, z: &T| x.plus(x).times(y).times(z);
    [
        [twice(s23, s24, s34), a12.clone(), a13.clone(), a14.clone()],
        [a12, twice(s13, s14, s34), a23.clone(), a24.clone()],
        [a13, a23, twice(s12, s14, s24), a34.clone()],
        [a14, a24, a34, twice(s12, s13, s23)],
    ]
}

/// Σ h_i·l_i.
#[inline(always)]
pub fn combination<T: Ring>(lines: &[Vector<T>; 4], h: &[T; 4]) -> Vector<T> {
    std::array::from_fn(|k| {
        let term = |i: usize| h[i].times(&lines[i][k]);
        term(0).plus(&term(1)).plus(&term(2).plus(&term(3)))
    })
}

/// H(f) and W(f), where f is zero but for a one at `column`.
#[inline(always)]
pub fn conjugates<T: Ring>(
    lines: &[Vector<T>; 4],
    s: &Products<T>,
    opposite: &[T; 3],
    column: usize,
) -> [Vector<T>; 2] {
    let f = lines.each_ref().map(|line| line[(column + 3) % 6].clone());
    let h = adjugate(s, opposite).map(|row| {
        let term = |i: usize| row[i].times(&f[i]);
        term(0).plus(&term(1)).plus(&term(2).plus(&term(3)))
    });
    let zero = || f[0].minus(&f[0]);
    let mut projected = combination(lines, &h).map(|x| zero().minus(&x));
    projected[column] = projected[column].plus(&discriminant(opposite));
    // The row f takes its column out of the determinant, and changes the sign in odd ones.
    let kept: [usize; 5] = std::array::from_fn(|k| if k < column { k } else { k + 1 });
    let mut perpendicular = std::array::from_fn(|_| zero());
    for (minor, k) in signed_minors(lines, kept).into_iter().zip(kept) {
        perpendicular[(k + 3) % 6] =
            if column.is_multiple_of(2) { minor } else { zero().minus(&minor) };
    }
    [projected, perpendicular]
}

/// The cofactors of a fifth row under four lines, in five of their columns: 4x4 minors, each from
/// the 2x2 minors of the first two lines and of the last two.
#[inline(always)]
fn signed_minors<T: Ring>(lines: &[Vector<T>; 4], kept: [usize; 5]) -> [T; 5] {
    let two = |x: &Vector<T>, y: &Vector<T>, i: usize, j: usize| {
        let (i, j) = (kept[i], kept[j]);
        x[i].times(&y[j]).minus(&x[j].times(&y[i]))
    };
    // Columns i < j at place TWO[i] + j.
    const TWO: [usize; 4] = [0, 3, 5, 6];
    let all = |x: &Vector<T>, y: &Vector<T>| {
        let columns =
            [[0, 1], [0, 2], [0, 3], [0, 4], [1, 2], [1, 3], [1, 4], [2, 3], [2, 4], [3, 4]];
        columns.map(|[i, j]| two(x, y, i, j))
    };
    let [l1, l2, l3, l4] = lines;
    let (p, q) = (all(l1, l2), all(l3, l4));
    let four = |[i, j, k, l]: [usize; 4], positive: bool| {
        let pair = |a: usize, b: usize, c: usize, d: usize| {
            let (ab, cd) = (TWO[a] + b - 1, TWO[c] + d - 1);
            p[ab].times(&q[cd]).plus(&p[cd].times(&q[ab]))
        };
        let (outer, inner) = (pair(i, j, k, l).plus(&pair(i, l, j, k)), pair(i, k, j, l));
        if positive { outer.minus(&inner) } else { inner.minus(&outer) }
    };
    [
        four([1, 2, 3, 4], true),
        four([0, 2, 3, 4], false),
        four([0, 1, 3, 4], true),
        four([0, 1, 2, 4], false),
        four([0, 1, 2, 3], true),
    ]
}

/// Both transversals of two coplanar lines, and of two others, where there are no more: the one
/// through the point that the first two share, and the one in their plane.
///
/// The plane of a point (x, w) and a line (d, m) is (w·m - x×d)·y = x·m; the meet of n·y = o and
/// n'·y = o' is (n×n', o'·n - o·n'); a line (d, m) crosses n·y = o in (o·d + n×m, n·d); and two
/// points (x, w), (x', w') have the line (w·x' - w'·x, x×x'). Only the last step, and its result,
/// takes `wide` numbers.
#[inline(always)]
pub fn through_point_and_in_plane<T: Ring, W: Ring>(
    coplanar: [&Vector<T>; 2],
    others: [&Vector<T>; 2],
    wide: impl Fn(T) -> W + Copy,
) -> [Vector<W>; 2] {
    let ((x, w), (n, o)) = point_and_plane(coplanar);
    let planes = others.map(|line| {
        let (d, m) = parts(line);
        let normal = difference(&[0, 1, 2].map(|i| m[i].times(&w)), &cross(&x, &d));
        (normal.map(wide), wide(dot(&x, &m)))
    });
    let points = others.map(|line| {
        let (d, m) = parts(line);
        let turned = cross(&n, &m);
        let x: [T; 3] = std::array::from_fn(|i| o.times(&d[i]).plus(&turned[i]));
        (x.map(wide), wide(dot(&n, &d)))
    });
    let mixed = |u: &W, a: &[W; 3], v: &W, b: &[W; 3]| -> [W; 3] {
        std::array::from_fn(|i| u.times(&a[i]).minus(&v.times(&b[i])))
    };
    let [(n, o), (n2, o2)] = &planes;
    let [(x, w), (x2, w2)] = &points;
    [joined(cross(n, n2), mixed(o2, n, o, n2)), joined(mixed(w, x2, w2, x), cross(x, x2))]
}

/// The common point (x, w) and the common plane n·y = o of two coplanar lines that are not one.
///
/// Where the directions are not parallel, n = d×d' and o = d'·m; and with R = e_k at infinity,
/// n_k ≠ 0, the plane of R and the second line is (-e_k×d')·y = m'_k, which the first line crosses
/// in (m'_k·d - (e_k×d')×m, n_k). Parallel lines share the point (d, 0); with d_k ≠ 0, the first
/// contains the point e_k×m / d_k, and the plane is (d_k·m' - d'_k·m)·y = (m×m')_k.
#[inline(always)]
fn point_and_plane<T: Ring>([first, second]: [&Vector<T>; 2]) -> (([T; 3], T), ([T; 3], T)) {
    let ((d, m), (e, n)) = (parts(first), parts(second));
    let zero = || d[0].minus(&d[0]);
    let normal = cross(&d, &e);
    let Some(k) = first_not_zero(&normal) else {
        // Four lines of which one is nothing have a family of transversals.
        let k = first_not_zero(&d).unwrap_or_default();
        let normal = std::array::from_fn(|i| d[k].times(&n[i]).minus(&e[k].times(&m[i])));
        let [offset, weight] = [cross(&m, &n)[k].clone(), zero()];
        return ((d, weight), (normal, offset));
    };
    // -e_k × d'.
    let mut turned = [zero(), zero(), zero()];
    turned[(k + 1) % 3] = e[(k + 2) % 3].clone();
    turned[(k + 2) % 3] = zero().minus(&e[(k + 1) % 3]);
    let aside = cross(&turned, &m);
    let x = std::array::from_fn(|i| n[k].times(&d[i]).plus(&aside[i]));
    let (weight, offset) = (normal[k].clone(), dot(&e, &m));
    ((x, weight), (normal, offset))
}

/// The place of the first number that is not zero.
#[inline(always)]
pub fn first_not_zero<T: Ring>(numbers: &[T]) -> Option<usize> {
    numbers.iter().position(|x| x.sign() != Sign::Zero)
}

#[inline(always)]
fn parts<T: Ring>([a, b, c, d, e, f]: &Vector<T>) -> ([T; 3], [T; 3]) {
    ([a, b, c].map(T::clone), [d, e, f].map(T::clone))
}

#[inline(always)]
fn joined<T>([a, b, c]: [T; 3], [d, e, f]: [T; 3]) -> Vector<T> {
    [a, b, c, d, e, f]
}
