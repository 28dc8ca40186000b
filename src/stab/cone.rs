//! The cone of a portal sequence, by the double description method.
//!
//! The lines that pass a sequence's edges on the right side satisfy `a_k · x >= 0` with one row
//! `a_k` of Z^6 an edge. The cone of all such `x` in R^6, whether they are lines or not, is kept
//! both by its rows and by its generators: extreme rays, and a basis of its lineality space (the
//! `x` with `a_k · x = 0` for all k) while there is one. One more half-space keeps the rays on its
//! side and adds one ray for each 2-face that it cuts (Motzkin, Raiffa, Thompson and Thrall 1953;
//! Fukuda and Prodon, "Double description method revisited", 1996).
//!
//! **Adjacency.** Two extreme rays span a 2-face iff no third ray is tight on every row on which
//! both are: exact and combinatorial, right for degenerate cones too (Fukuda and Prodon,
//! proposition 7), which are the normal case in architecture.
//!
//! **Rays by Cramer's rule.** A ray is never combined from others, which would double its length
//! each time and call for a greatest common divisor. It is solved anew from independent rows that
//! are tight on it, at most five, so its length is bounded by the grid alone. While the lineality
//! space has dimension k, rays are fixed modulo it by holding k coordinates at zero.
//!
//! **Invariants.** `base` names 6 - k independent rows; coordinates `free` and the rows of `base`
//! together determine a vector, and `lineality[j]` is zero on `base` and on every free coordinate
//! but `free[j]`. A ray's `basis` names 5 - k independent rows that are tight on it; its `tight`
//! holds exactly the kept rows that vanish on it.
//!
//! **Complexity.** With r rays, a push costs O(r) products, O(r³) set operations at worst, and one
//! system of five equations a new ray.

use super::mask::Mask;
use super::ring::Ring;
use super::wedge::Wedge;
use crate::num::Sign;

/// What a half-space did to the cone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Push {
    /// The cone still has points strictly inside the half-space (and inside all the others, if it
    /// had such points before).
    Strict,
    /// No point of the cone is strictly inside the half-space.
    Flat,
}

/// An extreme ray, modulo the lineality space.
#[derive(Clone, Debug)]
pub(super) struct Ray<R> {
    pub(super) vector: [R; 6],
    pub(super) tight: Mask,
    basis: Basis,
}

/// Up to five rows.
#[derive(Clone, Copy, Debug, Default)]
struct Basis {
    rows: [u32; 5],
    len: usize,
}

impl Basis {
    fn push(&mut self, row: usize) {
        self.rows[self.len] = u32::try_from(row).expect("a cone has fewer than 2^32 rows");
        self.len += 1;
    }

    fn rows(&self) -> impl Iterator<Item = usize> + '_ {
        self.rows[..self.len].iter().map(|&row| row as usize)
    }
}

/// A polyhedral cone in R^6, given by half-spaces through the origin.
#[derive(Clone, Debug)]
pub(super) struct Cone<R: Ring> {
    /// The half-spaces that cut the cone when they were pushed; the others are implied.
    rows: Vec<[R::Narrow; 6]>,
    /// Invariant: at most five while there are rays to come; all six once the cone is pointed.
    base: Vec<usize>,
    free: Vec<usize>,
    lineality: Vec<[R; 6]>,
    rays: Vec<Ray<R>>,
}

impl<R: Ring> Cone<R> {
    /// All of R^6.
    pub(super) fn everything() -> Cone<R> {
        let unit = |i: usize| std::array::from_fn(|j| if i == j { R::one() } else { R::zero() });
        Cone {
            rows: Vec::new(),
            base: Vec::new(),
            free: (0..6).collect(),
            lineality: (0..6).map(unit).collect(),
            rays: Vec::new(),
        }
    }

    /// The extreme rays, modulo the lineality space.
    pub(super) fn rays(&self) -> &[Ray<R>] {
        &self.rays
    }

    /// A basis of the lineality space.
    pub(super) fn lineality(&self) -> &[[R; 6]] {
        &self.lineality
    }

    /// How many half-spaces are kept.
    pub(super) fn row_count(&self) -> usize {
        self.rows.len()
    }

    /// Bytes kept for rows and rays, digits of unbounded integers not counted.
    pub(super) fn bytes(&self) -> usize {
        size_of::<Self>() + size_of_val(self.rows.as_slice()) + size_of_val(self.rays.as_slice())
    }

    /// The same cone in another arithmetic. Requires: its rows and rays fit there.
    pub(super) fn converted<S: Ring>(&self) -> Cone<S> {
        let wide = |v: &[R; 6]| v.each_ref().map(|c| S::from_int(&c.to_int()).expect("a ray fits"));
        let narrow = |c: &R::Narrow| S::narrow(&R::narrow_to_int(c)).expect("a row fits");
        let ray = |ray: &Ray<R>| Ray {
            vector: wide(&ray.vector),
            tight: ray.tight.clone(),
            basis: ray.basis,
        };
        Cone {
            rows: self.rows.iter().map(|row| row.each_ref().map(narrow)).collect(),
            base: self.base.clone(),
            free: self.free.clone(),
            lineality: self.lineality.iter().map(wide).collect(),
            rays: self.rays.iter().map(ray).collect(),
        }
    }

    /// Intersects the cone with the half-space `row · x >= 0`.
    pub(super) fn push(&mut self, row: &[R::Narrow; 6]) -> Push {
        let escaping = self.lineality.iter().position(|line| !dot(line, row).is_zero());
        if let Some(index) = escaping {
            self.bound_lineality(index, row);
            return Push::Strict;
        }
        let signs: Vec<Sign> = self.rays.iter().map(|ray| dot(&ray.vector, row).sign()).collect();
        let strict = if signs.contains(&Sign::Positive) { Push::Strict } else { Push::Flat };
        if signs.contains(&Sign::Negative) {
            self.cut(row, &signs);
        }
        strict
    }

    /// Turns one line of the lineality space into a ray.
    fn bound_lineality(&mut self, index: usize, row: &[R::Narrow; 6]) {
        let bit = self.rows.len();
        let mut line = self.lineality.remove(index);
        self.free.remove(index);
        if dot(&line, row).sign() == Sign::Negative {
            negate(&mut line);
        }
        self.rows.push(row.clone());
        for at in 0..self.rays.len() {
            let mut ray = self.rays[at].clone();
            ray.basis.push(bit);
            // Modulo the old lineality space the ray stays what it was, so the rows on which it
            // was positive tell which of the two opposite solutions it is.
            let witness = (0..bit).find(|&row| !ray.tight.contains(row));
            let witness = witness.expect("an extreme ray is positive on some row");
            ray.vector = self.solved(ray.basis.rows(), &self.free, witness);
            ray.tight.insert(bit);
            self.rays[at] = ray;
        }
        let mut basis = Basis::default();
        self.base.iter().for_each(|&row| basis.push(row));
        self.rays.push(Ray { vector: line, tight: Mask::first(bit), basis });
        self.base.push(bit);
        self.lineality = (0..self.free.len())
            .map(|j| {
                let mut others = self.free.clone();
                others.remove(j);
                self.product(self.base.iter().copied(), &others).orthogonal()
            })
            .collect();
    }

    /// Keeps the rays that are not negative and adds one on every 2-face that changes sign.
    fn cut(&mut self, row: &[R::Narrow; 6], signs: &[Sign]) {
        let bit = self.rows.len();
        self.rows.push(row.clone());
        let blocks = self.blocks();
        let of = |sign: Sign| (0..signs.len()).filter(move |&i| signs[i] == sign);
        let mut fresh = Vec::new();
        for i in of(Sign::Positive) {
            for j in of(Sign::Negative) {
                if let Some(common) = self.face_between(i, j, &blocks) {
                    fresh.push(self.crossing(i, j, &common, bit));
                }
            }
        }
        let mut index = 0;
        self.rays.retain_mut(|ray| {
            let sign = signs[index];
            index += 1;
            match sign {
                Sign::Positive => true,
                // The ray lies on the new plane: it stays extreme, and tight on one row more.
                Sign::Zero => {
                    ray.tight.insert(bit);
                    true
                }
                Sign::Negative => false,
            }
        });
        self.rays.append(&mut fresh);
    }

    /// The rows on which both rays are tight, where the rays span a 2-face. `blocks` are the rays'
    /// tight rows ([`Cone::blocks`]).
    pub(super) fn face_between(&self, i: usize, j: usize, blocks: &[u128]) -> Option<Mask> {
        // A 2-face, modulo the lineality space, is the zero of 4 - k independent rows.
        let (first, second) = (&self.rays[i].tight, &self.rays[j].tight);
        let needed = 4usize.saturating_sub(self.lineality.len());
        let tight_on_both = match (blocks.get(i), blocks.get(j)) {
            (Some(first), Some(second)) => {
                let common = first & second;
                if (common.count_ones() as usize) < needed {
                    return None;
                }
                blocks.iter().filter(|&&block| common & !block == 0).take(3).count()
            }
            _ => {
                let common = first.intersection(second);
                if common.len() < needed {
                    return None;
                }
                self.rays.iter().filter(|ray| common.is_subset_of(&ray.tight)).take(3).count()
            }
        };
        // The two rays themselves, and no third one.
        (tight_on_both == 2).then(|| first.intersection(second))
    }

    /// The tight rows of each ray, side by side; empty where there are more than 128 rows.
    pub(super) fn blocks(&self) -> Vec<u128> {
        self.rays.iter().map(|ray| ray.tight.one_block()).collect::<Option<_>>().unwrap_or_default()
    }

    /// The ray in which row `bit` cuts the 2-face between rays `i` (positive) and `j` (negative).
    fn crossing(&self, i: usize, j: usize, common: &Mask, bit: usize) -> Ray<R> {
        let needed = 4 - self.lineality.len();
        // Rows of the two bases come first: those of one ray are independent by themselves.
        let shared = || self.rays[i].basis.rows().filter(|&row| common.contains(row));
        let rest = common.members().filter(|&row| shared().all(|other| other != row));
        let start = self.product(std::iter::empty(), &self.free);
        let mut product = start.extended(&self.rows[bit]).expect("the row is not in the lineality");
        let mut basis = Basis::default();
        basis.push(bit);
        for row in shared().chain(rest) {
            if basis.len > needed {
                break;
            }
            if let Some(longer) = product.extended(&self.rows[row]) {
                product = longer;
                basis.push(row);
            }
        }
        // A row that the negative ray is tight on, and the positive one is not, is positive inside
        // the 2-face.
        let mut inside = self.rays[j].tight.members();
        let witness = inside.find(|&r| !self.rays[i].tight.contains(r));
        let witness = witness.expect("two extreme rays are tight on different rows");
        let mut vector = product.orthogonal();
        self.orient(&mut vector, witness);
        let mut tight = common.clone();
        tight.insert(bit);
        Ray { vector, tight, basis }
    }

    /// The exterior product of some rows and of the unit vectors of some coordinates.
    fn product(&self, rows: impl Iterator<Item = usize>, free: &[usize]) -> Wedge<R> {
        let unit = |i: usize| std::array::from_fn(|j| R::zero_or_one(i == j));
        let units = free.iter().map(|&i| unit(i));
        let rows = rows.map(|row| self.rows[row].clone());
        let product = units.chain(rows).try_fold(Wedge::empty(), |w, row| w.extended(&row));
        product.expect("a basis is independent of its rows and of the free coordinates")
    }

    /// The vector that vanishes on `rows` and `free` and is positive on row `witness`.
    fn solved(&self, rows: impl Iterator<Item = usize>, free: &[usize], witness: usize) -> [R; 6] {
        let mut vector = self.product(rows, free).orthogonal();
        self.orient(&mut vector, witness);
        vector
    }

    fn orient(&self, vector: &mut [R; 6], witness: usize) {
        match dot(vector, &self.rows[witness]).sign() {
            Sign::Positive => {}
            Sign::Negative => negate(vector),
            Sign::Zero => unreachable!("a ray's witness row does not vanish on it"),
        }
    }
}

/// `row · vector`.
pub(super) fn dot<R: Ring>(vector: &[R; 6], row: &[R::Narrow; 6]) -> R {
    let mut sum = R::zero();
    for (coordinate, entry) in vector.iter().zip(row) {
        sum.add_product(coordinate, entry);
    }
    sum
}

fn negate<R: Ring>(vector: &mut [R; 6]) {
    for coordinate in vector {
        *coordinate = coordinate.negated();
    }
}
