//! Does a cone contain a line in its interior? The signs of the Klein quadric on its rays and
//! edges.
//!
//! Real lines are the `x` of R^6 with Q(x) = d · m = 0. A full-dimensional cone of a portal
//! sequence has a line in its interior iff Q takes both strict signs on it; and by the theorem in
//! `docs/formats/stab.md`, where the cone has no lineality, both signs then occur on its rays and
//! edges already. With G_ij = side(r_i, r_j), Q(r_i) = G_ii / 2, and the edge between rays i and
//! j, none of them negative, reaches the negative side iff G_ij < 0 and G_ij² > G_ii G_jj.
//!
//! Any two rays span a part of the cone, whether they are adjacent or not. So the test may look at
//! more pairs than the edges, and a sign found on such a pair is found rightly.

use super::cone::{Cone, dot};
use super::engine::unbounded;
use super::mask::Mask;
use super::ring::Ring;
use crate::num::{Int, Sign};

/// A vector of the cone, or of two rays' span, in unbounded integers.
pub(super) type Vector = [Int; 6];

/// side(x, y) = d_x · m_y + m_x · d_y.
pub(super) fn side(x: &Vector, y: &Vector) -> Int {
    (0..6).map(|i| &x[i] * &y[(i + 3) % 6]).sum()
}

/// Q(x) = d_x · m_x.
pub(super) fn quadric(x: &Vector) -> Int {
    (0..3).map(|i| &x[i] * &x[i + 3]).sum()
}

/// Vectors of the cone on which Q is positive and negative, where there are such.
#[derive(Clone, Debug, Default)]
pub(super) struct BothSigns {
    pub(super) positive: Option<Vector>,
    pub(super) negative: Option<Vector>,
}

impl BothSigns {
    pub(super) fn found(&self) -> bool {
        self.positive.is_some() && self.negative.is_some()
    }

    /// The place of the sign, if it was not found yet.
    fn missing(&mut self, sign: Sign) -> Option<&mut Option<Vector>> {
        let place = match sign {
            Sign::Positive => &mut self.positive,
            Sign::Negative => &mut self.negative,
            // A line on the cone's boundary: it speaks for neither side.
            Sign::Zero => return None,
        };
        place.is_none().then_some(place)
    }
}

/// Rule 3 of the mathematics: the strict signs of Q on the rays and edges of a pointed cone.
pub(super) fn signs_on_edges<R: Ring>(cone: &Cone<R>) -> BothSigns {
    let rays = cone.rays();
    let mut signs = BothSigns::default();
    let mut squares = Vec::with_capacity(rays.len());
    for ray in rays {
        let square = R::side(&ray.vector, &ray.vector);
        if let Some(place) = signs.missing(R::sign_of(&square)) {
            *place = Some(unbounded(&ray.vector));
        }
        squares.push(square);
    }
    for i in 0..rays.len() {
        for j in i + 1..rays.len() {
            if signs.found() {
                return signs;
            }
            // Adjacent rays share four rows; whether the others are adjacent does not matter.
            if rays[i].tight.common(&rays[j].tight) >= 4 {
                let rs = R::side(&rays[i].vector, &rays[j].vector);
                // Where the rays meet (zero), Q on the edge is a sum of its values on them.
                let Some(place) = signs.missing(R::sign_of(&rs)) else { continue };
                if R::square_exceeds(&rs, &squares[i], &squares[j]) {
                    let ends = [unbounded(&rays[i].vector), unbounded(&rays[j].vector)];
                    *place = Some(extremum(&ends));
                }
            }
        }
    }
    signs
}

/// A point between two rays where Q has the wanted sign, if there is one and neither ray has it.
pub(super) fn extremum_of_sign([r, s]: [&Vector; 2], wanted: Sign) -> Option<Vector> {
    let rs = side(r, s);
    let found = Sign::of(&rs) == wanted && &rs * &rs > side(r, r) * side(s, s);
    found.then(|| extremum(&[r.clone(), s.clone()]))
}

/// The point between r and s where Q is extremal, or beyond it where r and s are lines: there Q
/// has the sign of G_rs. Requires: G_rs² > G_rr G_ss, and no square of the sign of G_rs.
fn extremum([r, s]: &[Vector; 2]) -> Vector {
    // Q(u r + v s) = (rr u² + 2 rs u v + ss v²) / 2 with rr, ss of the sign opposite to rs or 0.
    let size = |x: &Vector, y: &Vector| Int::from(side(x, y).magnitude().clone());
    let (rr, ss, rs) = (size(r, r), size(s, s), size(r, s));
    // With ss ≠ 0, u = |ss| and v = |rs|: 2|rs|·|rs||ss| - |rr||ss|² - |ss||rs|² =
    // |ss| (rs² - rr ss) > 0. With ss = 0, any u/v below 2|rs|/|rr| does.
    let (u, v) = if ss != Int::ZERO { (ss, rs) } else { (rs, rr + 1) };
    std::array::from_fn(|i| &u * &r[i] + &v * &s[i])
}

/// Rule 5: with order half-spaces, a sign may hide in a 3-face whose edges all lack it, behind
/// three pairwise skew rows. Looks there, for rows that are lines, `ordered` saying which belong to
/// no polygon.
pub(super) fn signs_behind_triples(
    signs: &mut BothSigns,
    rays: &RaySides,
    rows: &[(Vector, bool)],
) {
    for a in 0..rows.len() {
        for b in a + 1..rows.len() {
            for c in b + 1..rows.len() {
                let triple = [a, b, c];
                if triple.iter().any(|&row| rows[row].1) && rays.may_hide(triple, signs) {
                    look_behind(signs, triple.map(|row| &rows[row].0), rows);
                }
            }
        }
    }
}

/// The rays of a cone by what the search behind triples asks of them.
pub(super) struct RaySides {
    /// For each ray, the rows that it is tight on, by the order in which they were pushed.
    tight: Vec<Mask>,
    /// For each ray, the signs of its side products with the rays before it.
    sides: Vec<Vec<Sign>>,
}

impl RaySides {
    pub(super) fn of<R: Ring>(cone: &Cone<R>) -> RaySides {
        let rays = cone.rays();
        let side = |i: usize, j: usize| R::sign_of(&R::side(&rays[i].vector, &rays[j].vector));
        RaySides {
            tight: rays.iter().map(|ray| ray.tight.clone()).collect(),
            sides: (0..rays.len()).map(|i| (0..i).map(|j| side(i, j)).collect()).collect(),
        }
    }

    /// Whether the face of the cone on which three rows are tight might hide a missing sign. Such a
    /// face has at least three rays. On it Q is a sum of products G_ij t_i t_j, t >= 0, of its
    /// rays; so two of these have a side product of that sign.
    fn may_hide(&self, triple: [usize; 3], signs: &BothSigns) -> bool {
        let is_on_face = |ray: &usize| triple.iter().all(|&row| self.tight[*ray].contains(row));
        let face: Vec<usize> = (0..self.tight.len()).filter(is_on_face).collect();
        let is_missing = |sign: Sign| match sign {
            Sign::Positive => signs.positive.is_none(),
            Sign::Negative => signs.negative.is_none(),
            // Rays that meet add nothing to either side.
            Sign::Zero => false,
        };
        let mut pairs =
            face.iter().enumerate().flat_map(|(n, &i)| face[..n].iter().map(move |&j| (i, j)));
        face.len() >= 3 && pairs.any(|(i, j)| is_missing(self.sides[i][j]))
    }
}

fn look_behind(signs: &mut BothSigns, triple: [&Vector; 3], rows: &[(Vector, bool)]) {
    let [a, b, c] = triple;
    // Rows are lines with direction and moment exchanged, which leaves side products alone.
    let product = side(a, b) * side(b, c) * side(c, a);
    let wanted = match Sign::of(&product) {
        Sign::Positive if signs.negative.is_none() => Sign::Negative,
        Sign::Negative if signs.positive.is_none() => Sign::Positive,
        // Two of the rows meet, so they bound no regulus.
        Sign::Positive | Sign::Negative | Sign::Zero => return,
    };
    if let Some(x) = complement_vector(triple, wanted) {
        for x in [x.clone(), x.map(|c| -c)] {
            if rows.iter().all(|(row, _)| Sign::of(&pairing(row, &x)) != Sign::Negative)
                && let Some(place) = signs.missing(wanted)
            {
                *place = Some(x);
            }
        }
    }
}

/// row · x.
fn pairing(row: &Vector, x: &Vector) -> Int {
    dot::<Int>(x, row)
}

/// A vector on which Q has the wanted sign in the common zero of three rows.
fn complement_vector(rows: [&Vector; 3], wanted: Sign) -> Option<Vector> {
    let basis = null_space(rows)?;
    let mut tried: Vec<Vector> = basis.to_vec();
    // Orthogonalise with respect to Q (Lagrange's reduction): the signs of the squares are then
    // the signature, so one of the three has the wanted sign if any vector has.
    let [u, v, w] = basis;
    for (x, y, z) in [(&u, &v, &w), (&v, &w, &u), (&w, &u, &v)] {
        let combined = |p: &Vector, q: &Vector, k: i32| -> Vector {
            std::array::from_fn(|i| &p[i] + &q[i] * k)
        };
        tried.extend([combined(x, y, 1), combined(x, y, -1)]);
        let xx = side(x, x);
        if xx == Int::ZERO {
            continue;
        }
        let off = |y: &Vector| -> Vector {
            let xy = side(x, y);
            std::array::from_fn(|i| &xx * &y[i] - &xy * &x[i])
        };
        let (y, z) = (off(y), off(z));
        tried.extend([combined(&y, &z, 1), combined(&y, &z, -1)]);
        let yy = side(&y, &y);
        let yz = side(&y, &z);
        tried.push(std::array::from_fn(|i| &yy * &z[i] - &yz * &y[i]));
        tried.extend([y, z]);
    }
    tried.into_iter().find(|x| Sign::of(&quadric(x)) == wanted)
}

/// A basis of the common zero of three independent rows.
fn null_space(rows: [&Vector; 3]) -> Option<[Vector; 3]> {
    use super::wedge::Wedge;
    let start = rows.into_iter().try_fold(Wedge::<Int>::empty(), |w, row| w.extended(row))?;
    let unit = |i: usize| -> Vector { std::array::from_fn(|j| Int::from(u8::from(i == j))) };
    // Coordinates that complete the rows to a basis; holding two of the three at zero leaves one
    // direction of the null space.
    let mut product = start.clone();
    let mut free = Vec::new();
    for axis in 0..6 {
        if product.grade() < 5
            && let Some(longer) = product.extended(&unit(axis))
        {
            product = longer;
            free.push(axis);
        }
    }
    let vector = product.orthogonal();
    let last = (0..6).find(|&axis| vector[axis] != Int::ZERO)?;
    free.push(last);
    let direction = |skip: usize| -> Option<Vector> {
        let held = free.iter().enumerate().filter(|&(k, _)| k != skip).map(|(_, &axis)| axis);
        let mut product = start.clone();
        for axis in held {
            product = product.extended(&unit(axis))?;
        }
        Some(product.orthogonal())
    };
    Some([direction(0)?, direction(1)?, direction(2)?])
}
