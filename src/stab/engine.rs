//! One cone type for every range of coordinates: the narrowest arithmetic that is proved to hold.
//!
//! Rows tell their own range (`ring`), so the choice is made from the sequence at hand, not from
//! the scene. A push that leaves the range of the current width converts the cone to the next one
//! that serves; a search that pops returns to the narrower cone of the level before.

use super::cone::{Cone, Push};
use super::line::ExactLine;
use super::mask::Mask;
use super::quadric::{BothSigns, RaySides, Vector, signs_on_edges};
use super::ring::Ring;
use super::stabber::ConeShape;
use crate::num::{Int, Int192, Int256, Int320};

/// A cone in one of the arithmetics.
#[derive(Clone, Debug)]
pub(super) enum Engine {
    Bits128(Cone<i128>),
    Bits192(Cone<Int192>),
    Bits256(Cone<Int256>),
    Bits320(Cone<Int320>),
    Unbounded(Cone<Int>),
}

/// Evaluates an expression with the cone, whatever its arithmetic.
macro_rules! each {
    ($engine:expr, $cone:ident => $value:expr) => {
        match $engine {
            Engine::Bits128($cone) => $value,
            Engine::Bits192($cone) => $value,
            Engine::Bits256($cone) => $value,
            Engine::Bits320($cone) => $value,
            Engine::Unbounded($cone) => $value,
        }
    };
}

/// Evaluates an expression with `$ring` standing for the narrowest arithmetic that serves a range.
macro_rules! in_range {
    ($range:expr, $ring:ident => $value:expr) => {{
        use $crate::num::{Int192, Int256, Int320};
        let range: Range = $range;
        if range.fits::<i128>() {
            type $ring = i128;
            $value
        } else if range.fits::<Int192>() {
            type $ring = Int192;
            $value
        } else if range.fits::<Int256>() {
            type $ring = Int256;
            $value
        } else if range.fits::<Int320>() {
            type $ring = Int320;
            $value
        } else {
            type $ring = Int;
            $value
        }
    }};
}
pub(super) use in_range;

/// The range of some rows: bits of their moments and of their directions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Range {
    moment: u64,
    direction: u64,
}

impl Range {
    /// The range of these rows and of another range.
    pub(super) fn with<'a>(self, rows: impl Iterator<Item = &'a Vector>) -> Range {
        // Unit vectors take part in solving for rays, so no range is below one bit.
        let start = Range { moment: self.moment.max(1), direction: self.direction.max(1) };
        rows.fold(start, |range, row| {
            let bits = |part: &[Int]| part.iter().map(Int::bits).max().unwrap_or(0);
            Range {
                moment: range.moment.max(bits(&row[..3])),
                direction: range.direction.max(bits(&row[3..])),
            }
        })
    }

    /// Whether the arithmetic serves the range.
    pub(super) fn fits<R: Ring>(self) -> bool {
        // Entries of rows are 64 bits wide in all fixed widths.
        R::BUDGET.is_none_or(|budget| {
            3 * (self.moment + self.direction) <= budget && self.moment.max(self.direction) <= 63
        })
    }
}

impl Engine {
    /// All of R^6.
    pub(super) fn everything() -> Engine {
        Engine::Bits128(Cone::everything())
    }

    /// A copy of the cone, in the narrowest arithmetic from its own up that serves the range.
    pub(super) fn widened_for(&self, range: Range) -> Engine {
        let serves = match self {
            Engine::Bits128(_) => range.fits::<i128>(),
            Engine::Bits192(_) => range.fits::<Int192>(),
            Engine::Bits256(_) => range.fits::<Int256>(),
            Engine::Bits320(_) => range.fits::<Int320>(),
            Engine::Unbounded(_) => true,
        };
        if serves {
            return self.clone();
        }
        if range.fits::<Int192>() {
            Engine::Bits192(each!(self, cone => cone.converted()))
        } else if range.fits::<Int256>() {
            Engine::Bits256(each!(self, cone => cone.converted()))
        } else if range.fits::<Int320>() {
            Engine::Bits320(each!(self, cone => cone.converted()))
        } else {
            Engine::Unbounded(each!(self, cone => cone.converted()))
        }
    }

    /// Intersects the cone with `row · x >= 0`. Requires: the row is in the range served.
    pub(super) fn push(&mut self, row: &Vector) -> Push {
        each!(self, cone => push(cone, row))
    }

    /// Whether the cone contains a line and its opposite.
    pub(super) fn has_lineality(&self) -> bool {
        each!(self, cone => !cone.lineality().is_empty())
    }

    /// The strict signs of the quadric on rays and edges.
    pub(super) fn signs(&self) -> BothSigns {
        each!(self, cone => signs_on_edges(cone))
    }

    /// The extreme rays, modulo the lineality space.
    pub(super) fn rays(&self) -> Vec<Vector> {
        each!(self, cone => cone.rays().iter().map(|ray| unbounded(&ray.vector)).collect())
    }

    /// How many of the rows pushed are kept, the others being implied by them.
    pub(super) fn row_count(&self) -> usize {
        each!(self, cone => cone.row_count())
    }

    /// For each ray, the kept rows that it is tight on.
    pub(super) fn tight_rows(&self) -> Vec<Mask> {
        each!(self, cone => cone.rays().iter().map(|ray| ray.tight.clone()).collect())
    }

    /// What the search behind triples asks of the rays.
    pub(super) fn ray_sides(&self) -> RaySides {
        each!(self, cone => RaySides::of(cone))
    }

    /// A basis of the lineality space.
    pub(super) fn lineality(&self) -> Vec<Vector> {
        each!(self, cone => cone.lineality().iter().map(unbounded).collect())
    }

    /// How large the cone is.
    pub(super) fn shape(&self) -> ConeShape {
        let (rays, faces) = (self.rays(), self.faces());
        let crossings = faces.iter().map(|&[i, j]| ExactLine::between(&rays[i], &rays[j]).len());
        ConeShape {
            rays: rays.len(),
            faces: faces.len(),
            crossings: crossings.sum(),
            lineality: self.lineality().len(),
            bits: rays.iter().flatten().map(Int::bits).max().unwrap_or(0),
            bytes: each!(self, cone => cone.bytes()),
        }
    }

    /// The pairs of rays that span the 2-faces.
    pub(super) fn faces(&self) -> Vec<[usize; 2]> {
        fn pairs<R: Ring>(cone: &Cone<R>) -> Vec<[usize; 2]> {
            let count = cone.rays().len();
            let all = (0..count).flat_map(|i| (i + 1..count).map(move |j| [i, j]));
            let blocks = cone.blocks();
            all.filter(|&[i, j]| cone.face_between(i, j, &blocks).is_some()).collect()
        }
        each!(self, cone => pairs(cone))
    }
}

fn push<R: Ring>(cone: &mut Cone<R>, row: &Vector) -> Push {
    let narrow = |c: &Int| R::narrow(c).expect("the row is in the range of the arithmetic");
    cone.push(&row.each_ref().map(narrow))
}

/// A vector in unbounded integers.
pub(super) fn unbounded<R: Ring>(vector: &[R; 6]) -> Vector {
    vector.each_ref().map(R::to_int)
}
