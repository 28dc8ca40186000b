//! How large the coordinates of a scene are, and what follows from it for every predicate.
//!
//! A scene on a grid of `b` bits (|coordinate| <= 2^b) has predicates whose values are bounded by
//! a power of two that depends on b alone. [`Range`] states that power once for each predicate;
//! from it follow the widest grid that each integer type decides, and `docs/predicates.md` prints
//! the same table (a test keeps the two in step). [`Budget`] carries b, and the float error
//! bounds that follow from it, to the predicates.

use crate::geom::{Line, Plane, Point3};

/// The bound of a predicate's value, and of every partial result on the way: less than
/// 2^(slope·b + constant) on a grid of b bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Range {
    /// The predicate's name.
    pub predicate: &'static str,
    /// The degree in the coordinates of the input points.
    pub degree: u32,
    /// The value has fewer than `slope·b + constant` bits …
    pub slope: u32,
    /// … and a sign.
    pub constant: u32,
}

impl Range {
    /// The largest b whose values fit a signed integer of `width` bits.
    pub const fn largest_grid(&self, width: u32) -> u32 {
        (width - 1 - self.constant) / self.slope
    }
}

// On a grid of b bits let C = 2^b bound the coordinates and D = 2^(b+1) their differences.

/// (b-a) x (c-a), two products of differences: 2D² as a partial result, D² as a value.
pub const ORIENT2D: Range = Range { predicate: "orient2d", degree: 2, slope: 2, constant: 3 };

/// Three products of a minor (2D²) and a difference: 6D³ = 2^(3b+5.6).
pub const ORIENT3D: Range = Range { predicate: "orient3d", degree: 3, slope: 3, constant: 6 };

/// n·v and the offset n·a, each 3·2D²·C, and their difference: 12D²C = 2^(3b+5.6).
pub const SIDE_OF_PLANE: Range =
    Range { predicate: "side_of_plane", degree: 3, slope: 3, constant: 6 };

/// Six products of a direction (D) and a moment (2C²): 12DC² = 2^(3b+4.6).
pub const SIDE_OF_LINES: Range =
    Range { predicate: "side_of_lines", degree: 3, slope: 3, constant: 5 };

/// With N = 2D² = 2^(2b+3) for normals and O = 3NC = 2^(3b+4.6) for offsets: directions of meets
/// are below 2N² = 2^(4b+7), moments below 2NO = 2^(5b+8.6), six products of them below
/// 2^(9b+18.2).
pub const SIDE_OF_MEETS: Range =
    Range { predicate: "side_of_meets", degree: 9, slope: 9, constant: 19 };

/// The side of two meets, and the determinant of three normals below 3·2N²·N = 2^(6b+11.6).
pub const VERTEX_SIDE_OF_PLANE: Range =
    Range { predicate: "vertex_side_of_plane", degree: 9, slope: 9, constant: 19 };

/// Three products of differences: 3D² = 2^(2b+3.6).
pub const COMPARE_ALONG_LINE: Range =
    Range { predicate: "compare_along_line", degree: 2, slope: 2, constant: 4 };

/// n·d is below 3ND = 2^(3b+5.6), offset - n·p below 6NC = 2^(3b+5.6); two products of them:
/// 2^(6b+12.2).
pub const COMPARE_CROSSINGS: Range =
    Range { predicate: "compare_crossings", degree: 6, slope: 6, constant: 13 };

/// With S = 2^(3b+4.6) for side products, a, b and c are below S² = 2^(6b+9.2), a-b-c below
/// 2^(6b+10.8), its square below 2^(12b+21.6), 4bc below 2^(12b+20.4), and D below 2^(12b+22.1).
pub const TRANSVERSAL_COUNT: Range =
    Range { predicate: "transversal_count", degree: 12, slope: 12, constant: 23 };

/// 44 products of five side products: 2^(15b+23) · 2^5.5.
pub const SIDE_OF_TRANSVERSALS: Range =
    Range { predicate: "side_of_transversals", degree: 15, slope: 15, constant: 29 };

/// α² - β²D for the side α + β√D of a line H + √D·W (`four_lines::algebra`), with f at infinity:
/// where all such f gave nothing, both transversals would be at infinity, so meet, and D = 0.
/// The adjugate of S is below 3S³ = 2^(9b+15.4); four products of it and a direction 2^(10b+18.4);
/// with four lines that is 2^(11b+21.4) for the direction of H, 2^(12b+21.4) for its moment and
/// D more, 2^(12b+22.8); α is below 2^(13b+25.9) and α² below 2^(26b+51.8). With M = 2C², minors
/// of four lines are below 24D³M = 2^(5b+8.6) and 24D²M² = 2^(6b+8.6), β below 2^(7b+12.2), and
/// β²D below 2^(26b+46.5).
pub const SIDES_OF_EACH: Range =
    Range { predicate: "sides_of_each", degree: 26, slope: 26, constant: 53 };

/// All of them, in the order of the table in `docs/predicates.md`.
pub const RANGES: [Range; 11] = [
    ORIENT2D,
    ORIENT3D,
    SIDE_OF_PLANE,
    SIDE_OF_LINES,
    SIDE_OF_MEETS,
    VERTEX_SIDE_OF_PLANE,
    COMPARE_ALONG_LINE,
    COMPARE_CROSSINGS,
    TRANSVERSAL_COUNT,
    SIDE_OF_TRANSVERSALS,
    SIDES_OF_EACH,
];

/// 2^-53: the relative error of one float operation.
pub(super) const U: f64 = f64::EPSILON / 2.0;

/// The size of a scene's coordinates, computed once for a scene.
///
/// The sign that a predicate returns does not depend on its budget, as long as the points are
/// within it: that is every predicate's requirement (a `debug_assert`). A tight budget is a
/// faster one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Budget {
    bits: u32,
    filters: bool,
    /// The error of `orient3d`'s float stage.
    pub(super) orient3d_error: f64,
    /// Whether `side_of_lines` is exact in floats, and may use them.
    pub(super) exact_lines: bool,
    /// The error of `side_of_lines`' float stage beyond [`SPLIT_BITS`].
    pub(super) side_of_lines_error: f64,
    /// 2^-bits, which brings moments to the size of directions.
    pub(super) moment_scale: f64,
}

impl Budget {
    /// Holds for every [`Point3`].
    pub const FULL: Budget = Budget::for_bits(53);

    /// For coordinates of magnitude up to 2^bits; more than 53 is taken for 53.
    pub const fn for_bits(bits: u32) -> Budget {
        let bits = if bits < 53 { bits } else { 53 };
        let coordinate = (1u64 << bits) as f64;
        let difference = 2.0 * coordinate;
        Budget {
            bits,
            filters: true,
            orient3d_error: orient3d_error(difference),
            exact_lines: bits <= SPLIT_BITS,
            side_of_lines_error: side_of_lines_error(difference, coordinate),
            moment_scale: 1.0 / coordinate,
        }
    }

    /// The least budget that holds for all of the points.
    pub fn of_points<'a>(points: impl IntoIterator<Item = &'a Point3>) -> Budget {
        let magnitudes = points.into_iter().flat_map(|p| p.integers()).map(i64::unsigned_abs);
        let largest = magnitudes.max().unwrap_or(0);
        Budget::for_bits(u64::BITS - largest.saturating_sub(1).leading_zeros())
    }

    /// The same, with the float stages switched off: what is left are integers. Signs are the
    /// same, and tests check that they are.
    pub const fn without_filters(self) -> Budget {
        Budget { filters: false, exact_lines: false, ..self }
    }

    /// The bits: every coordinate is at most 2^bits in magnitude.
    #[inline]
    pub const fn bits(&self) -> u32 {
        self.bits
    }

    /// Whether the float stages are on.
    #[inline]
    pub const fn filters(&self) -> bool {
        self.filters
    }

    /// Whether the point is within the budget.
    pub fn holds(&self, point: &Point3) -> bool {
        point.integers().iter().all(|c| c.unsigned_abs() <= 1 << self.bits)
    }

    /// Whether a line can be one through points within the budget.
    pub(super) fn holds_line(&self, line: &Line) -> bool {
        let bits = self.bits;
        line.direction().iter().all(|d| d.unsigned_abs() <= 2 << bits)
            && line.moment().iter().all(|m| m.unsigned_abs() <= 2 << (2 * bits))
    }

    /// Whether a plane can be one through points within the budget. (That normals and offsets are
    /// within these bounds is shown in `meets`.)
    pub(super) fn holds_plane(&self, plane: &Plane) -> bool {
        // A plane holds 40 bits, whatever the budget.
        let bits = self.bits.min(40);
        plane.normal().iter().all(|n| n.unsigned_abs() <= 4 << (2 * bits))
            && plane.offset().unsigned_abs() <= 4 << (3 * bits)
    }
}

/// The float stage of `orient3d` on integer points evaluates ((b-a) x (c-a))·(d-a).
///
/// Differences are exact for b <= 52 and in error by uD at b = 53. A coordinate of the product
/// (two products of differences, and their difference) is then in error by 2·2uD² from its
/// factors, 2uD² from its products and 2uD² from their difference, to first order; times three
/// coordinates of d-a that is 24uD³. The factor d-a adds 3·2D²·uD = 6uD³, the last dot product's
/// products 3·u·2D³ and its sums u(4+6)D³: 46uD³ in all, and 48 with the higher orders. Integers
/// do not underflow.
const fn orient3d_error(difference: f64) -> f64 {
    48.0 * U * difference * difference * difference
}

/// The largest grid on which `side_of_lines` is exact in floats.
///
/// The moments m = h + l of a [`Line`](crate::geom::Line) are split at 2^25, and the value is S_h +
/// S_l with S_h = d·h' + h·d' and S_l = d·l' + l·d'. At 24 bits directions are at most 2^25 and
/// moments at most 2^49, both parts of them floats. So S_h and all its partial sums are multiples
/// of 2^25 of at most 6·2^25·2^49 = 2^51.6 such units, S_l and its partial sums integers of at most
/// 6·2^25·2^24 = 2^51.6: exact, both. Their one rounded sum has the sign of the true one, zero
/// included.
pub(super) const SPLIT_BITS: u32 = 24;

/// Beyond that: let D bound directions and M = 2C² moments, both held exactly, and high parts be
/// at most M + 2^24. Each of the six products of S_h is in error by uDM; the sums of three by
/// u(2+3)DM, twice, and their sum by 6uDM: 22uDM. S_l, at most 2^-25 of that size, adds nothing
/// to the first digits of it, and the sum S_h + S_l another 6uDM: 28uDM, and 30 with the higher
/// orders. (Lines hold up to 38 bits, whatever the budget.)
const fn side_of_lines_error(difference: f64, coordinate: f64) -> f64 {
    30.0 * U * difference * 2.0 * coordinate * coordinate
}

/// The largest grid whose values, where the float stage leaves them open, are told apart by their
/// remainders modulo 2^64: an open value is at most 2e in magnitude, e being that stage's error,
/// and e <= 48u·2^(3b+3) = 2^(3b-44.4), so that 2e < 2^63 for b <= 35.
pub(super) const RESIDUE_BITS: u32 = 35;
