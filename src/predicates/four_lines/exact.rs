//! The transversals of four lines in integers.

use super::Sides;
use super::algebra::{
    PAIRS, Vector, adjugate, combination, conjugates, discriminant, first_not_zero, opposite,
    products, side, through_point_and_in_plane,
};
use crate::geom::Line;
use crate::num::{Int, Int320, Sign, sign_of_surd};
use crate::predicates::TransversalCount;
use crate::predicates::counters::Stage;
use crate::predicates::lines4::TRANSVERSAL_COUNT;
use crate::predicates::ring::Ring;
use num_traits::Zero;

/// The largest grid on which edges parallel to the axes have transversals in `i128`.
///
/// With directions ±1 and moments up to C, planes of two parallel edges have normals up to 2C and
/// offsets up to 2C², their meets with a third weights up to 2C and positions up to 6C², so that
/// the line of two such points has a direction below 24C³ and a moment below 72C⁴; and a double
/// transversal is 4·(3·4C²·2C)·C = 96C⁴. Against a direction 2C and a moment 2C²: below
/// 3(96 + 192)C⁵, less than 2^(5b+10).
pub const NARROW_BITS: u32 = 23;

/// The largest grid on which rational transversals are held in 320 bits: those of the
/// discriminant, below 2^(12b+23). Against that, two lines through a point or in a plane have
/// 2^(10b+13) in their coordinates and 2^(11b+17) with a fifth line, a double one 2^(11b+19) and
/// 2^(12b+22): `docs/predicates.md` derives them.
pub const FIXED_BITS: u32 = TRANSVERSAL_COUNT.largest_grid(320);

/// What meets four lines, with coordinates of one kind of number.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Solution<T> {
    None,
    Family,
    One(Vector<T>),
    Two([Vector<T>; 2]),
    /// Two lines over Q(√D), and neither D nor the product of any two lines is zero.
    Conjugate,
}

impl<T> Solution<T> {
    pub fn count(&self) -> TransversalCount {
        match self {
            Solution::None => TransversalCount::None,
            Solution::Family => TransversalCount::Family,
            Solution::One(_) => TransversalCount::One,
            Solution::Two(_) | Solution::Conjugate => TransversalCount::Two,
        }
    }
}

/// The transversals, directed and in order.
pub fn solve<T: Ring>(lines: &[Vector<T>; 4]) -> Solution<T> {
    let s = products(lines);
    let opposites = opposite(&s);
    let Some(pair) = s.iter().position(|s| s.sign() == Sign::Zero) else {
        return match discriminant(&opposites).sign() {
            Sign::Negative => Solution::None,
            Sign::Zero => degenerate(lines, &s, &opposites),
            Sign::Positive => Solution::Conjugate,
        };
    };
    // One of a, b and c is zero, and D the square of the others' difference.
    let [a, b, c] = &opposites;
    let difference = match PAIRS[pair.min(5 - pair)][1] {
        1 => b.minus(c),
        2 => c.minus(a),
        _ => a.minus(b),
    };
    let order = difference.sign();
    if order == Sign::Zero {
        return degenerate(lines, &s, &opposites);
    }
    let [i, j] = PAIRS[pair].map(|i| &lines[i]);
    let [k, l] = PAIRS[5 - pair].map(|i| &lines[i]);
    let [through_point, in_plane] = through_point_and_in_plane([i, j], [k, l]).map(directed);
    Solution::Two(match order {
        Sign::Positive => [through_point, in_plane],
        Sign::Negative | Sign::Zero => [in_plane, through_point],
    })
}

/// What meets the lines where D = 0.
///
/// A symmetric matrix has rank three or more iff some principal 3x3 minor is not zero; those of S
/// are 2·S_ij·S_ik·S_jk. Where there is none, the lines' span has a radical of dimension two, on
/// which all vectors are lines: infinitely many transversals. Otherwise the adjugate of S has rank
/// one, and its rows that are not zero hold the radical's coordinates: the one vector of the span
/// that all four lines meet. If that sum is zero, the fourth line depends on the three, and the
/// other ruling of their surface meets all.
fn degenerate<T: Ring>(lines: &[Vector<T>; 4], s: &[T; 6], opposites: &[T; 3]) -> Solution<T> {
    let skew = |i: usize| {
        // The other three lines are, each to each.
        let mut others = (0..6).filter(|&pair| !PAIRS[pair].contains(&i));
        others.all(|pair| s[pair].sign() != Sign::Zero)
    };
    let Some(i) = (0..4).find(|&i| skew(i)) else {
        return Solution::Family;
    };
    let radical = combination(lines, &adjugate(s, opposites)[i]);
    match first_not_zero(&radical) {
        Some(_) => Solution::One(directed(radical)),
        None => Solution::Family,
    }
}

/// The line with its first coordinate that is not zero positive.
pub fn directed<T: Ring>(line: Vector<T>) -> Vector<T> {
    match line.iter().map(T::sign).find(|&sign| sign != Sign::Zero) {
        Some(Sign::Negative) => line.map(|x| x.minus(&x).minus(&x)),
        Some(Sign::Positive | Sign::Zero) | None => line,
    }
}

/// The transversals of four lines, ready to be passed by others.
#[derive(Debug)]
pub enum Exact {
    /// Of edges parallel to the axes, on grids up to [`NARROW_BITS`].
    Narrow(Solution<i128>),
    /// On grids up to [`FIXED_BITS`].
    Fixed(Box<Solution<Int320>>),
    Big(Box<Solution<Int>>),
    /// H ± √D·W.
    Conjugate(Box<Conjugates>),
}

#[derive(Debug)]
pub struct Conjugates {
    h: Vector<Int>,
    w: Vector<Int>,
    d: Int,
}

impl Exact {
    /// The transversals of any lines.
    pub fn of_lines(lines: [&Line; 4], bits: u32) -> Exact {
        if bits <= FIXED_BITS {
            match solve(&lines.map(|line| wide(line))) {
                Solution::Conjugate => {}
                solution => return Exact::Fixed(Box::new(solution)),
            }
        }
        Exact::of_vectors(&lines.map(|line| big(line)))
    }

    fn of_vectors(lines: &[Vector<Int>; 4]) -> Exact {
        match solve(lines) {
            Solution::Conjugate => conjugate(lines),
            solution => Exact::Big(Box::new(solution)),
        }
    }

    /// What decides sides.
    pub fn stage(&self) -> Stage {
        match self {
            Exact::Narrow(_) | Exact::Fixed(_) => Stage::Fixed,
            Exact::Big(_) | Exact::Conjugate(_) => Stage::Big,
        }
    }

    /// How many there are.
    pub fn count(&self) -> TransversalCount {
        match self {
            Exact::Narrow(solution) => solution.count(),
            Exact::Fixed(solution) => solution.count(),
            Exact::Big(solution) => solution.count(),
            Exact::Conjugate(_) => TransversalCount::Two,
        }
    }

    /// How a line passes each transversal; whether they are a family.
    pub fn sides(&self, line: &Line) -> Sides {
        match self {
            Exact::Narrow(solution) => sides_of(solution, &narrow(line)),
            Exact::Fixed(solution) => sides_of(solution, &wide(line)),
            Exact::Big(solution) => sides_of(solution, &big(line)),
            Exact::Conjugate(lines) => {
                let line = big(line);
                let (a, b) = (side(&lines.h, &line), side(&lines.w, &line));
                let first = sign_of_surd(&a, &b, &lines.d);
                Sides::Two([first, sign_of_surd(&a, &-b, &lines.d)])
            }
        }
    }
}

#[inline(always)]
fn sides_of<T: Ring>(solution: &Solution<T>, line: &Vector<T>) -> Sides {
    match solution {
        Solution::None | Solution::Conjugate => Sides::None,
        Solution::Family => Sides::Family,
        Solution::One(only) => Sides::One(side(only, line).sign()),
        Solution::Two(lines) => Sides::Two(lines.each_ref().map(|l| side(l, line).sign())),
    }
}

/// H ± √D·W for the first unit vector f that gives both, with f·L > 0; where the root is a whole
/// number, one f for each of them.
fn conjugate(lines: &[Vector<Int>; 4]) -> Exact {
    let s = products(lines);
    let opposites = opposite(&s);
    let d = discriminant(&opposites);
    let root = d.sqrt();
    let square = &root * &root == d;
    // Lines at infinity first, and their sides are the coordinates of directions; so the first
    // that gives anything gives the first coordinate that is not zero.
    let mut candidates =
        [3, 4, 5, 0, 1, 2].map(|column| (column, conjugates(lines, &s, &opposites, column)));
    if square {
        let line = |root: &Int| {
            let sums = candidates.iter().map(|(_, [h, w])| -> Vector<Int> {
                std::array::from_fn(|k| &h[k] + root * &w[k])
            });
            let mut lines = sums.filter(|sum| sum.iter().any(|x| !x.is_zero()));
            // Both transversals are not zero, so neither meets all of a basis.
            directed(lines.next().unwrap_or_default())
        };
        return Exact::Big(Box::new(Solution::Two([line(&root), line(&-&root)])));
    }
    let of_both = |(column, [h, _]): &(usize, [Vector<Int>; 2])| !h[(column + 3) % 6].is_zero();
    let chosen = candidates.iter().position(of_both).unwrap_or_default();
    let (column, [h, w]) = std::mem::take(&mut candidates[chosen]);
    let reversed = h[(column + 3) % 6] < Int::zero();
    let turn = |v: Vector<Int>| if reversed { v.map(|x| -x) } else { v };
    Exact::Conjugate(Box::new(Conjugates { h: turn(h), w: turn(w), d }))
}

pub fn narrow(line: &Line) -> Vector<i128> {
    let ([a, b, c], [d, e, f]) = (line.direction().map(i128::from), line.moment());
    [a, b, c, d, e, f]
}

fn wide(line: &Line) -> Vector<Int320> {
    narrow(line).map(Int320::from)
}

fn big(line: &Line) -> Vector<Int> {
    narrow(line).map(Int::from)
}
