//! The transversals of four lines in integers.

use super::Sides;
use super::algebra::{
    PAIRS, Products, Vector, adjugate, combination, conjugates, discriminant, first_not_zero,
    opposite, products, side, through_point_and_in_plane,
};
use crate::geom::{BigLine, Line};
use crate::num::{Int, Int320, Sign, sign_of_surd};
use crate::predicates::TransversalCount;
use crate::predicates::budget::TRANSVERSAL_COUNT;
use crate::predicates::counters::Stage;
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

/// The largest grid on which rational transversals are held in 320 bits: as for the discriminant,
/// below 2^(12b+23). With D = 2C for directions and M = 2C² for moments:
///
/// The plane of two parallel lines has a normal below 2DM = 2^(3b+3) and an offset below 2M² =
/// 2^(4b+3); a third line crosses it in a point of weight below 2^(4b+5.6) and position below
/// 2^(5b+5.6); two of them have a line below 2^(9b+12.2) and 2^(10b+12.2) (direction and moment),
/// and a side product below 2^(11b+15.8). The planes of two lines that cross, and the lines through
/// their point at infinity if they are parallel, are smaller. The point of two lines that cross has
/// a weight below 2D² = 2^(2b+3) and a position below 3DM = 2^(3b+3.6); its plane with a third line
/// a normal below 2^(4b+6.1) and an offset below 2^(5b+6.2); two such planes meet in a line below
/// 2^(8b+13.2) and 2^(9b+13.3), side product 2^(10b+16.9). A double transversal, four products of
/// the adjugate of S, below 2^(9b+15.4), and of a line, is below 2^(10b+18.4) and 2^(11b+18.4), its
/// side products below 2^(12b+22).
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

/// The transversals, directed and in order; `wide` are the numbers that hold them.
#[inline(always)]
pub fn solve<T: Ring, W: Ring>(
    lines: &[Vector<T>; 4],
    wide: impl Fn(T) -> W + Copy,
) -> Solution<W> {
    let s = products(lines);
    let opposites = opposite(&s);
    let degenerate = || {
        let lines = lines.each_ref().map(|line| line.clone().map(wide));
        degenerate(&lines, &s.clone().map(wide), &opposites.clone().map(wide))
    };
    let Some((pair, order)) = coplanar_pair(&s, &opposites) else {
        return match discriminant(&opposites.clone().map(wide)).sign() {
            Sign::Negative => Solution::None,
            Sign::Zero => degenerate(),
            Sign::Positive => Solution::Conjugate,
        };
    };
    let [i, j] = PAIRS[pair].map(|i| &lines[i]);
    let [k, l] = PAIRS[5 - pair].map(|i| &lines[i]);
    let rational = || through_point_and_in_plane([i, j], [k, l], wide).map(directed);
    match order {
        Sign::Positive => Solution::Two(rational()),
        Sign::Negative => {
            let [through_point, in_plane] = rational();
            Solution::Two([in_plane, through_point])
        }
        Sign::Zero => degenerate(),
    }
}

/// A pair of coplanar lines, and the sign of b - c, c - a or a - b where a, b or c is their
/// product with that of the other two: D is its square. With that difference for √D, H + √D·W is
/// the line through the common point: so the two alone have an order.
#[inline(always)]
fn coplanar_pair<T: Ring>(s: &Products<T>, [a, b, c]: &[T; 3]) -> Option<(usize, Sign)> {
    let pair = s.iter().position(|s| s.sign() == Sign::Zero)?;
    let difference = match pair {
        0 | 5 => b.minus(c),
        1 | 4 => c.minus(a),
        _ => a.minus(b),
    };
    Some((pair, difference.sign()))
}

/// How many lines meet four edges parallel to the axes, on grids up to [`NARROW_BITS`]: products
/// are at most 2C, and their products 4C².
pub fn count_axial(lines: [&Line; 4]) -> TransversalCount {
    let lines = lines.map(axial);
    let s = products(&lines);
    let opposites = opposite(&s);
    match coplanar_pair(&s, &opposites) {
        Some((_, Sign::Positive | Sign::Negative)) => TransversalCount::Two,
        // Two of the four are parallel, so there is a pair.
        Some((_, Sign::Zero)) | None => {
            let lines = lines.map(|line| line.map(i128::from));
            degenerate(&lines, &s.map(i128::from), &opposites.map(i128::from)).count()
        }
    }
}

/// How many lines meet four whose discriminant is zero.
pub fn count_degenerate(lines: [&Line; 4], bits: u32) -> TransversalCount {
    fn count<T: Ring>(lines: &[Vector<T>; 4]) -> TransversalCount {
        let s = products(lines);
        degenerate(lines, &s, &opposite(&s)).count()
    }
    if bits <= FIXED_BITS { count(&lines.map(wide)) } else { count(&lines.map(big)) }
}

/// What meets the lines where D = 0.
///
/// A symmetric matrix has rank three or more iff some principal 3x3 minor is not zero; those of S
/// are 2·S_ij·S_ik·S_jk. Where there is none, the lines' span has a radical of dimension two, on
/// which all vectors are lines: infinitely many transversals. Otherwise the adjugate of S has rank
/// one, and its rows that are not zero hold the radical's coordinates: the one vector of the span
/// that all four lines meet. If that sum is zero, the fourth line depends on the three, and the
/// other ruling of their surface meets all.
fn degenerate<T: Ring>(lines: &[Vector<T>; 4], s: &Products<T>, opposites: &[T; 3]) -> Solution<T> {
    let Some(i) = outside_of_skew_triple(s) else {
        return Solution::Family;
    };
    let radical = combination(lines, &adjugate(s, opposites)[i]);
    match first_not_zero(&radical) {
        Some(_) => Solution::One(directed(radical)),
        None => Solution::Family,
    }
}

/// Whether some three lines are pairwise skew.
#[inline(always)]
pub fn has_skew_triple<T: Ring>(s: &Products<T>) -> bool {
    outside_of_skew_triple(s).is_some()
}

/// A line whose removal leaves three that are pairwise skew.
#[inline(always)]
fn outside_of_skew_triple<T: Ring>(s: &Products<T>) -> Option<usize> {
    let skew = s.each_ref().map(|s| s.sign() != Sign::Zero);
    // The pairs of the other three, as places in `PAIRS`.
    let others = [[3, 4, 5], [1, 2, 5], [0, 2, 4], [0, 1, 3]];
    others.iter().position(|&[i, j, k]| skew[i] & skew[j] & skew[k])
}

/// The line with its first coordinate that is not zero positive.
pub fn directed<T: Ring>(line: Vector<T>) -> Vector<T> {
    match line.iter().map(T::sign).find(|&sign| sign != Sign::Zero) {
        Some(Sign::Negative) => line.map(|x| x.minus(&x).minus(&x)),
        Some(Sign::Positive | Sign::Zero) | None => line,
    }
}

/// How many lines meet four, in unbounded integers.
pub fn count_big(lines: [BigLine; 4]) -> TransversalCount {
    let vectors = lines.map(|line| {
        let ([a, b, c], [d, e, f]) = (line.direction, line.moment);
        [a, b, c, d, e, f]
    });
    solve(&vectors, |x| x).count()
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
            match solve(&lines.map(wide), |x| x) {
                Solution::Conjugate => {}
                solution => return Exact::Fixed(Box::new(solution)),
            }
        }
        Exact::of_vectors(&lines.map(big))
    }

    fn of_vectors(lines: &[Vector<Int>; 4]) -> Exact {
        match solve(lines, |x| x) {
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
            Exact::Narrow(solution) => sides_of(solution, &short(line).map(i128::from)),
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
/// number, for the first f that gives each.
fn conjugate(lines: &[Vector<Int>; 4]) -> Exact {
    let s = products(lines);
    let opposites = opposite(&s);
    let d = discriminant(&opposites);
    // Lines at infinity first, and their sides are the coordinates of directions; so the first
    // that gives anything gives the first coordinate that is not zero.
    let candidates = || {
        [3, 4, 5, 0, 1, 2]
            .into_iter()
            .map(|column| (column, conjugates(lines, &s, &opposites, column)))
    };
    let root = d.sqrt();
    if &root * &root == d {
        let line = |root: &Int| {
            let sums = candidates().map(|(_, [h, w])| -> Vector<Int> {
                std::array::from_fn(|k| &h[k] + root * &w[k])
            });
            // Neither transversal meets all of a basis, so that the other is zero throughout.
            directed(
                sums.into_iter().find(|sum| sum.iter().any(|x| !x.is_zero())).unwrap_or_default(),
            )
        };
        return Exact::Big(Box::new(Solution::Two([line(&root), line(&-&root)])));
    }
    let along = |(column, [h, _]): &(usize, [Vector<Int>; 2])| Sign::of(&h[(column + 3) % 6]);
    let chosen = candidates().find(|candidate| along(candidate) != Sign::Zero);
    let reversed = chosen.as_ref().map(along) == Some(Sign::Negative);
    let (_, [h, w]) = chosen.unwrap_or_default();
    let turn = |v: Vector<Int>| if reversed { v.map(|x| -x) } else { v };
    Exact::Conjugate(Box::new(Conjugates { h: turn(h), w: turn(w), d }))
}

/// Whether a line is parallel to an axis.
#[inline(always)]
pub fn is_axial(line: &Line) -> bool {
    let [[x, _], [y, _], [z, _]] = *line.paired_direction();
    u8::from(x != 0.0) + u8::from(y != 0.0) + u8::from(z != 0.0) == 1
}

/// The Plücker vector of a line parallel to an axis, scaled to a direction of length one. The
/// moment of points up to 2^23 is below 2^48, its parts' sum exact, and so is the quotient: the
/// moment is the product of an integer point and the direction.
#[inline(always)]
pub fn axial(line: &Line) -> Vector<i64> {
    let direction = line.paired_direction().map(|[d, _]| d);
    let length = direction.iter().map(|d| d.abs()).sum::<f64>();
    let [a, b, c] = direction.map(|d| (d / length) as i64);
    let moment = line.split_moment().map(|[high, low]| (high + low) / length);
    let [d, e, f] = moment.map(|m| m as i64);
    [a, b, c, d, e, f]
}

/// The coordinates of a line through points of up to 2^[`NARROW_BITS`]: the moment's parts have an
/// exact sum.
#[inline(always)]
fn short(line: &Line) -> Vector<i64> {
    let [a, b, c] = line.paired_direction().map(|[d, _]| d as i64);
    let [d, e, f] = line.split_moment().map(|[high, low]| (high + low) as i64);
    [a, b, c, d, e, f]
}

fn long(line: &Line) -> Vector<i128> {
    let ([a, b, c], [d, e, f]) = (line.direction().map(i128::from), line.moment());
    [a, b, c, d, e, f]
}

fn wide(line: &Line) -> Vector<Int320> {
    long(line).map(Int320::from)
}

fn big(line: &Line) -> Vector<Int> {
    long(line).map(Int::from)
}
