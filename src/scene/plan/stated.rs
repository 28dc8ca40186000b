//! From the numbers of a file to a plan on one grid.

use crate::num::{Int, Number, Rational, Sign};
use crate::predicates::{PlanPoint, PlanPoints, compare_coordinates, turn_of_points};
use num_integer::Integer;
use num_traits::ToPrimitive;

/// A segment as a file states it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RawSegment {
    /// Its ends, in world units.
    pub ends: [[Number; 2]; 2],
    /// Whether it occludes; otherwise it splits cells and is nothing else.
    pub is_opaque: bool,
}

/// A floorplan as a file states it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct RawPlan {
    /// The segments, in the order of the file: what results call by number.
    pub segments: Vec<RawSegment>,
    /// The box to be divided, its corners of least and of greatest coordinates; else that around
    /// all segments.
    pub view: Option<[[Number; 2]; 2]>,
    /// Grid units in one world unit, where declared.
    pub declared_grid: Option<Int>,
    /// Points that mark the inside.
    pub inside: Vec<[Number; 2]>,
    /// Detail objects and regions: a name and the corners of a convex polygon, in order.
    pub objects: Vec<(String, Vec<[Number; 2]>)>,
}

/// A segment of a plan.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PlanSegment {
    /// Its ends, by their number in [`Plan::points`]; distinct.
    pub ends: [u32; 2],
    /// Whether it occludes.
    pub is_opaque: bool,
    /// Its number in the input.
    pub source: u32,
}

/// Something in a plan that is seen and does not occlude: a convex polygon.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlanObject {
    /// What it is called.
    pub name: String,
    /// Its corners, counter-clockwise, in grid units.
    pub polygon: Vec<PlanPoint>,
}

impl PlanObject {
    /// Its corners in world units, of which one has `grid` grid units.
    pub fn in_world(&self, grid: &Int) -> Vec<[Rational; 2]> {
        self.polygon.iter().map(|corner| corner.coordinates().map(|c| c / grid)).collect()
    }
}

/// What was repaired, none of which changes what can be seen.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct PlanRepairs {
    /// Segments with one end, left out.
    pub zero_length: Vec<u32>,
}

/// A floorplan on one grid.
#[derive(Clone, Debug)]
pub struct Plan {
    /// Grid units in one world unit.
    pub grid: Int,
    /// The ends of segments and the corners of the box, in grid units.
    pub points: PlanPoints,
    /// The segments. They may cross, touch and overlap.
    pub segments: Vec<PlanSegment>,
    /// The corners of the box to be divided, counter-clockwise from the least.
    pub bounds: [u32; 4],
    /// Whether the box is stated, and not the one around all segments.
    pub has_view: bool,
    /// Points that mark the inside, in grid units.
    pub inside: Vec<PlanPoint>,
    /// What may be seen in it.
    pub objects: Vec<PlanObject>,
    /// What was repaired.
    pub repairs: PlanRepairs,
}

/// Which part of a floorplan breaks a rule.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{place}: {kind}")]
pub struct PlanError {
    /// The part, as the file calls it: `segments[3]`.
    pub place: String,
    /// The rule broken.
    pub kind: PlanErrorKind,
}

/// The rules of a floorplan.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum PlanErrorKind {
    /// Nothing is stated.
    #[error("no segment of positive length, expected one or more")]
    NoSegment,
    /// A box without area.
    #[error("the first corner of the box must be below the second in x and in y")]
    EmptyView,
    /// An object that is no convex polygon.
    #[error("expected three or more corners of a convex polygon, in order")]
    NotConvex,
    /// A portal between a cell and itself.
    #[error("joins a cell with itself, expected two cells")]
    SameCell,
    /// A portal of no length.
    #[error("both ends are one point")]
    OneEnd,
    /// A coordinate off the declared grid.
    #[error("coordinate {got} is not a multiple of the declared grid unit 1/{grid}")]
    OffGrid {
        /// The coordinate.
        got: Number,
        /// The declared number of grid units in one world unit.
        grid: Int,
    },
    /// Denominators without a common multiple of a sane size.
    #[error("the common denominator of the coordinates exceeds {limit} bits")]
    HugeGrid {
        /// The limit.
        limit: u64,
    },
}

/// Room for the smallest number that is read, 1e-4096.
const MAX_GRID_BITS: u64 = 1 << 14;

impl Plan {
    /// Puts a stated floorplan on its grid.
    ///
    /// # Errors
    /// The first part that breaks a rule.
    pub fn from_raw(raw: &RawPlan) -> Result<Plan, PlanError> {
        let grid = grid_of(raw)?;
        let mut points = PlanPoints::default();
        let scale = Scale::of(&grid);
        let mut repairs = PlanRepairs::default();
        let mut segments = Vec::with_capacity(raw.segments.len());
        for (source, segment) in raw.segments.iter().enumerate() {
            let ends = segment.ends.each_ref().map(|end| points.insert(scale.point(end)));
            let source = source as u32;
            if ends[0] == ends[1] {
                repairs.zero_length.push(source);
            } else {
                segments.push(PlanSegment { ends, is_opaque: segment.is_opaque, source });
            }
        }
        if segments.is_empty() {
            return Err(PlanError { place: "segments".to_owned(), kind: PlanErrorKind::NoSegment });
        }
        let corners = match &raw.view {
            Some(view) => {
                let [low, high] = view.each_ref().map(|corner| scale.point(corner).coordinates());
                if low[0] >= high[0] || low[1] >= high[1] {
                    return Err(PlanError { place: "view".into(), kind: PlanErrorKind::EmptyView });
                }
                [low, high]
            }
            None => box_around(&points),
        };
        let [[x0, y0], [x1, y1]] = corners;
        let bounds = [[&x0, &y0], [&x1, &y0], [&x1, &y1], [&x0, &y1]]
            .map(|corner| points.insert(PlanPoint::from_coordinates(&corner.map(Clone::clone))));
        let inside = raw.inside.iter().map(|point| scale.point(point)).collect();
        let mut objects = Vec::with_capacity(raw.objects.len());
        for (index, (name, corners)) in raw.objects.iter().enumerate() {
            let polygon = corners.iter().map(|corner| scale.point(corner)).collect();
            let polygon = convex(polygon).ok_or_else(|| PlanError {
                place: format!("objects[{index}]"),
                kind: PlanErrorKind::NotConvex,
            })?;
            objects.push(PlanObject { name: name.clone(), polygon });
        }
        let has_view = raw.view.is_some();
        Ok(Plan { grid, points, segments, bounds, has_view, inside, objects, repairs })
    }
}

/// The lowest common denominator of everything that is stated, or the declared one.
fn grid_of(raw: &RawPlan) -> Result<Int, PlanError> {
    let segments = raw.segments.iter().enumerate();
    let segments = segments.flat_map(|(i, s)| s.ends.iter().map(move |end| ("segments", i, end)));
    let view = raw.view.iter().flatten().map(|corner| ("view", 0, corner));
    let inside = raw.inside.iter().enumerate().map(|(i, point)| ("inside", i, point));
    let objects = raw.objects.iter().enumerate();
    let objects = objects.flat_map(|(i, (_, all))| all.iter().map(move |p| ("objects", i, p)));
    common_grid(raw.declared_grid.as_ref(), segments.chain(view).chain(inside).chain(objects))
}

/// The lowest common denominator of points, each with the field and the index that state it, or
/// the declared one.
pub(super) fn common_grid<'a>(
    declared: Option<&Int>,
    points: impl Iterator<Item = (&'static str, usize, &'a [Number; 2])>,
) -> Result<Int, PlanError> {
    let mut common = declared.cloned().unwrap_or_else(|| Int::from(1));
    for (field, index, point) in points {
        let error = |kind| PlanError { place: format!("{field}[{index}]"), kind };
        for number in point {
            let fits = match number {
                Number::Small(_, 1) => true,
                Number::Small(_, q) => common.is_multiple_of(&Int::from(*q)),
                Number::Big(ratio) => common.is_multiple_of(ratio.denom()),
            };
            if fits {
                continue;
            }
            if let Some(grid) = declared {
                let (got, grid) = (number.clone(), grid.clone());
                return Err(error(PlanErrorKind::OffGrid { got, grid }));
            }
            common = common.lcm(number.to_rational().denom());
            if common.bits() > MAX_GRID_BITS {
                return Err(error(PlanErrorKind::HugeGrid { limit: MAX_GRID_BITS }));
            }
        }
    }
    Ok(common)
}

/// From world units to grid units.
pub(super) struct Scale {
    grid: Rational,
    /// The same, where it fits.
    short: Option<i64>,
}

impl Scale {
    pub(super) fn of(grid: &Int) -> Scale {
        Scale { grid: Rational::from(grid.clone()), short: grid.to_i64() }
    }

    pub(super) fn point(&self, point: &[Number; 2]) -> PlanPoint {
        let short = |number: &Number| match (number, self.short) {
            (Number::Small(p, q), Some(grid)) if grid % q == 0 => p.checked_mul(grid / q),
            _ => None,
        };
        if let [Some(x), Some(y)] = point.each_ref().map(short) {
            return PlanPoint::integer([x.into(), y.into()]);
        }
        PlanPoint::from_coordinates(&point.each_ref().map(|c| c.to_rational() * &self.grid))
    }
}

/// The corners of the box around all points; where that has no area, a unit wider on either side.
fn box_around(points: &PlanPoints) -> [[Rational; 2]; 2] {
    let all = || (0..points.len() as u32).map(|number| points.get(number));
    let mut corners = [[0, 1], [0, 1]].map(|axes| axes.map(|_| Rational::default()));
    for axis in [0, 1] {
        let least = all().min_by(|a, b| compare_coordinates(axis, a, b));
        let most = all().max_by(|a, b| compare_coordinates(axis, a, b));
        let (Some(least), Some(most)) = (least, most) else { unreachable!("a plan has segments") };
        corners[0][axis] = least.coordinates()[axis].clone();
        corners[1][axis] = most.coordinates()[axis].clone();
        if corners[0][axis] == corners[1][axis] {
            corners[0][axis] -= Rational::from(Int::from(1));
            corners[1][axis] += Rational::from(Int::from(1));
        }
    }
    corners
}

/// The polygon with its corners counter-clockwise; `None` unless it is strictly convex.
fn convex(mut polygon: Vec<PlanPoint>) -> Option<Vec<PlanPoint>> {
    let n = polygon.len();
    if n < 3 {
        return None;
    }
    if turn_of_points(&polygon[0], &polygon[1], &polygon[2]) == Sign::Negative {
        polygon.reverse();
    }
    // Every corner to the left of every edge: convex, and around once.
    let edges = (0..n).map(|i| (i, (i + 1) % n));
    let is_left = |(i, j): (usize, usize)| {
        (0..n)
            .filter(|&k| k != i && k != j)
            .all(|k| turn_of_points(&polygon[i], &polygon[j], &polygon[k]) == Sign::Positive)
    };
    edges.into_iter().all(is_left).then_some(polygon)
}
