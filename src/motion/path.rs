//! A straight motion against half-spaces: when it is in all of them.
//!
//! Everything that a move can meet (a cell, a portal, a wall grown by the moving box) is a convex
//! set given by half-spaces n·x <= o, and the position depends linearly on the time: each
//! half-space is one inequality in one unknown, and a set is an interval of time.

use crate::geom::{AxialBox, BigPlane, RationalPoint3};
use crate::num::{Int, Int256, Rational, Sign};
use num_traits::ToPrimitive;
use std::cmp::Ordering;

/// Two integers: in fixed width while they fit.
#[derive(Clone, Debug)]
enum Pair {
    /// Each is below 2^127 in magnitude.
    Fixed([i128; 2]),
    Big(Box<[Int; 2]>),
}

impl Pair {
    fn signs(&self) -> [Sign; 2] {
        match self {
            Pair::Fixed(pair) => pair.each_ref().map(Sign::of),
            Pair::Big(pair) => pair.each_ref().map(Sign::of),
        }
    }

    fn negated(self) -> Pair {
        match self {
            Pair::Fixed(pair) => Pair::Fixed(pair.map(|integer| -integer)),
            Pair::Big(pair) => Pair::Big(Box::new(pair.map(|integer| -integer))),
        }
    }

    fn to_big(&self) -> [Int; 2] {
        match self {
            Pair::Fixed(pair) => pair.map(Int::from),
            Pair::Big(pair) => (**pair).clone(),
        }
    }
}

/// A moment of a move: a ratio that is compared without being reduced.
///
/// Invariant: the second integer, its denominator, is positive.
#[derive(Clone, Debug)]
pub(super) struct Moment(Pair);

impl Moment {
    /// When a move begins.
    pub(super) fn start() -> Moment {
        Moment(Pair::Fixed([0, 1]))
    }

    /// When a move ends.
    pub(super) fn end() -> Moment {
        Moment(Pair::Fixed([1, 1]))
    }
}

impl From<&Moment> for Rational {
    fn from(moment: &Moment) -> Rational {
        let [numerator, denominator] = moment.0.to_big();
        Rational::new(numerator, denominator)
    }
}

impl Ord for Moment {
    fn cmp(&self, other: &Moment) -> Ordering {
        if let (Pair::Fixed([a, b]), Pair::Fixed([c, d])) = (&self.0, &other.0) {
            if b == d {
                return a.cmp(c);
            }
            return Int256::product(*a, *d).cmp(&Int256::product(*c, *b));
        }
        let ([a, b], [c, d]) = (self.0.to_big(), other.0.to_big());
        (a * d).cmp(&(c * b))
    }
}

impl PartialOrd for Moment {
    fn partial_cmp(&self, other: &Moment) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Moment {
    fn eq(&self, other: &Moment) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Moment {}

/// A part of a move: from one moment to another, which is not earlier.
#[derive(Clone, Debug)]
pub(super) struct Span {
    pub(super) low: Moment,
    pub(super) high: Moment,
}

/// A straight motion of a point, or of a box that the point carries along.
#[derive(Clone, Debug)]
pub(super) struct Path {
    exact: Line<Int>,
    /// The same, where all its integers are below 2^61 in magnitude.
    fixed: Option<Line<i128>>,
    /// Where the point starts, in the line's units.
    from: [Int; 3],
}

/// The integers of a path.
#[derive(Clone, Debug)]
struct Line<T> {
    /// How many of its units are one world unit.
    grid: T,
    /// From the start to the end.
    step: [T; 3],
    /// The corner of least coordinates at the start: the point itself where it moves alone.
    low: [T; 3],
    /// The corner of greatest coordinates at the start.
    high: [T; 3],
}

/// What a half-space asks of the time: `room >= rise · t`, as (room, rise).
struct Limit(Pair);

impl Limit {
    /// When it holds with equality; the rise is not zero.
    fn moment(self) -> Moment {
        match self.0.signs()[1] {
            Sign::Negative => Moment(self.0.negated()),
            Sign::Zero => unreachable!("a motion along a plane does not cross it"),
            Sign::Positive => Moment(self.0),
        }
    }
}

impl Path {
    /// The motion of a point.
    pub(super) fn of_point(from: &RationalPoint3, to: &RationalPoint3) -> Path {
        let grid = RationalPoint3::common_denominator([from, to]);
        let [from, to] = [from, to].map(|point| point.on_grid(&grid).coordinates);
        let step = std::array::from_fn(|i| &to[i] - &from[i]);
        Path::new(Line { grid, step, low: from.clone(), high: from.clone() }, from)
    }

    /// The motion of a box, whose corners are given as seen from the point.
    pub(super) fn of_box(from: &RationalPoint3, to: &RationalPoint3, body: &AxialBox) -> Path {
        let corners = [&body.low, &body.high].map(RationalPoint3::from);
        let grid = RationalPoint3::common_denominator([from, to, &corners[0], &corners[1]]);
        let [from, to] = [from, to].map(|point| point.on_grid(&grid).coordinates);
        let step = std::array::from_fn(|i| &to[i] - &from[i]);
        let [low, high] = corners.map(|corner| {
            let corner = corner.on_grid(&grid).coordinates;
            std::array::from_fn(|i| &from[i] + &corner[i])
        });
        Path::new(Line { grid, step, low, high }, from)
    }

    fn new(exact: Line<Int>, from: [Int; 3]) -> Path {
        let fixed = |integer: &Int| integer.to_i128().filter(|i| i.unsigned_abs() < 1 << 61);
        let all = |[x, y, z]: &[Int; 3]| Some([fixed(x)?, fixed(y)?, fixed(z)?]);
        let Line { grid, step, low, high } = &exact;
        let fixed = || {
            Some(Line { grid: fixed(grid)?, step: all(step)?, low: all(low)?, high: all(high)? })
        };
        Path { fixed: fixed(), exact, from }
    }

    /// When the point is in the closed intersection of half-spaces, or the closed box touches it
    /// as far as these half-spaces tell.
    pub(super) fn within<'a>(
        &self,
        half_spaces: impl IntoIterator<Item = &'a BigPlane>,
    ) -> Option<Span> {
        self.clip(half_spaces, false)
    }

    /// When the box's inside meets a convex set, of which the supporting half-spaces are given
    /// that bound its sum with any box.
    pub(super) fn overlap<'a>(
        &self,
        half_spaces: impl IntoIterator<Item = &'a BigPlane>,
    ) -> Option<Span> {
        self.clip(half_spaces, true)
    }

    fn clip<'a>(
        &self,
        half_spaces: impl IntoIterator<Item = &'a BigPlane>,
        strict: bool,
    ) -> Option<Span> {
        let (mut low, mut high) = (Moment::start(), Moment::end());
        for plane in half_spaces {
            let limit = self.limit(plane);
            match limit.0.signs() {
                [_, Sign::Negative] => low = low.max(limit.moment()),
                // Along the plane: in the half-space always or never; a motion inside of the
                // plane touches it all the time.
                [Sign::Negative, Sign::Zero] => return None,
                [Sign::Zero, Sign::Zero] if strict => return None,
                [Sign::Zero | Sign::Positive, Sign::Zero] => continue,
                [_, Sign::Positive] => high = high.min(limit.moment()),
            }
            match low.cmp(&high) {
                Ordering::Less => {}
                Ordering::Equal if strict => return None,
                Ordering::Equal => {}
                Ordering::Greater => return None,
            }
        }
        Some(Span { low, high })
    }

    /// Whether it enters the half-space at just this moment.
    pub(super) fn enters(&self, plane: &BigPlane, moment: &Moment) -> bool {
        self.crosses(plane, moment, Sign::Negative)
    }

    /// Whether it leaves the half-space at just this moment.
    pub(super) fn leaves(&self, plane: &BigPlane, moment: &Moment) -> bool {
        self.crosses(plane, moment, Sign::Positive)
    }

    /// Whether it reaches the plane at just this moment, and rises or falls against it as told.
    fn crosses(&self, plane: &BigPlane, moment: &Moment, rise: Sign) -> bool {
        let limit = self.limit(plane);
        limit.0.signs()[1] == rise && limit.moment() == *moment
    }

    /// Where the point is at a moment.
    pub(super) fn at(&self, moment: &Moment) -> RationalPoint3 {
        let [numerator, denominator] = moment.0.to_big();
        let Line { grid, step, .. } = &self.exact;
        let coordinate = |i: usize| &self.from[i] * &denominator + &step[i] * &numerator;
        RationalPoint3::new([0, 1, 2].map(coordinate), grid * &denominator)
    }

    /// The box keeps in the half-space grown by itself as long as its corner that reaches furthest
    /// against the normal is in the half-space.
    fn limit(&self, plane: &BigPlane) -> Limit {
        let [a, b, c] = &plane.normal;
        if let Some(line) = &self.fixed {
            // Four products below 2^63 · 2^61 each: their sum is at most 2^126.
            let fixed = |integer: &Int| integer.to_i64().map(i128::from);
            let normal = || Some([fixed(a)?, fixed(b)?, fixed(c)?]);
            if let (Some(normal), Some(offset)) = (normal(), fixed(&plane.offset)) {
                let (mut room, mut rise) = (offset * line.grid, 0);
                for (i, n) in normal.into_iter().enumerate() {
                    rise += n * line.step[i];
                    room -= n * if n < 0 { line.high[i] } else { line.low[i] };
                }
                return Limit(Pair::Fixed([room, rise]));
            }
        }
        let line = &self.exact;
        let (mut room, mut rise) = (&plane.offset * &line.grid, Int::ZERO);
        for (i, n) in plane.normal.iter().enumerate() {
            rise += n * &line.step[i];
            room -= n * if *n < Int::ZERO { &line.high[i] } else { &line.low[i] };
        }
        Limit(Pair::Big(Box::new([room, rise])))
    }
}
