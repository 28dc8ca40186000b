//! A straight motion against half-spaces: when it is in all of them.
//!
//! Everything that a move can meet (a cell, a portal, a wall grown by the moving box) is a convex
//! set given by half-spaces n·x <= o, and the position depends linearly on the time: each
//! half-space is one inequality in one unknown, and a set is an interval of time.

use crate::geom::{AxialBox, BigPlane, RationalPoint3};
use crate::num::{Int, Rational, Sign};
use std::cmp::Ordering;

/// A moment of a move: a ratio that is compared without being reduced.
///
/// Invariant: the denominator is positive.
#[derive(Clone, Debug)]
pub(super) struct Moment {
    numerator: Int,
    denominator: Int,
}

impl Moment {
    /// When a move begins.
    pub(super) fn start() -> Moment {
        Moment { numerator: Int::from(0), denominator: Int::from(1) }
    }

    /// When a move ends.
    pub(super) fn end() -> Moment {
        Moment { numerator: Int::from(1), denominator: Int::from(1) }
    }
}

impl From<&Moment> for Rational {
    fn from(moment: &Moment) -> Rational {
        Rational::new(moment.numerator.clone(), moment.denominator.clone())
    }
}

impl Ord for Moment {
    fn cmp(&self, other: &Moment) -> Ordering {
        if self.denominator == other.denominator {
            return self.numerator.cmp(&other.numerator);
        }
        let ours = &self.numerator * &other.denominator;
        ours.cmp(&(&other.numerator * &self.denominator))
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
    /// How many of its units are one world unit.
    grid: Int,
    from: [Int; 3],
    /// From the start to the end.
    step: [Int; 3],
    /// The box's corners as seen from the point.
    low: [Int; 3],
    high: [Int; 3],
}

/// What a half-space asks of the time: `rise · t <= room`.
struct Limit {
    rise: Int,
    room: Int,
}

impl Path {
    /// The motion of a point.
    pub(super) fn of_point(from: &RationalPoint3, to: &RationalPoint3) -> Path {
        let grid = RationalPoint3::common_denominator([from, to]);
        let [start, end] = [from, to].map(|point| point.on_grid(&grid).coordinates);
        let step = std::array::from_fn(|i| &end[i] - &start[i]);
        let zero = || [Int::ZERO, Int::ZERO, Int::ZERO];
        Path { grid, from: start, step, low: zero(), high: zero() }
    }

    /// The motion of a box, whose corners are given as seen from the point.
    pub(super) fn of_box(from: &RationalPoint3, to: &RationalPoint3, body: &AxialBox) -> Path {
        let corners = [&body.low, &body.high].map(RationalPoint3::from);
        let grid = RationalPoint3::common_denominator([from, to, &corners[0], &corners[1]]);
        let [from, to] = [from, to].map(|point| point.on_grid(&grid).coordinates);
        let [low, high] = corners.map(|corner| corner.on_grid(&grid).coordinates);
        let step = std::array::from_fn(|i| &to[i] - &from[i]);
        Path { grid, from, step, low, high }
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
            let Limit { rise, room } = self.limit(plane);
            match Sign::of(&rise) {
                Sign::Negative => {
                    let moment = Moment { numerator: -room, denominator: -rise };
                    if moment > low {
                        low = moment;
                    }
                }
                // Along the plane: in the half-space always or never; a motion inside of the
                // plane touches it all the time.
                Sign::Zero => match Sign::of(&room) {
                    Sign::Negative => return None,
                    Sign::Zero if strict => return None,
                    Sign::Zero | Sign::Positive => continue,
                },
                Sign::Positive => {
                    let moment = Moment { numerator: room, denominator: rise };
                    if moment < high {
                        high = moment;
                    }
                }
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
        let Limit { rise, room } = self.limit(plane);
        match Sign::of(&rise) {
            Sign::Negative => is_at(rise, room, moment),
            // It is inside all the time, or never.
            Sign::Zero => false,
            Sign::Positive => false,
        }
    }

    /// Whether it leaves the half-space at just this moment.
    pub(super) fn leaves(&self, plane: &BigPlane, moment: &Moment) -> bool {
        let Limit { rise, room } = self.limit(plane);
        match Sign::of(&rise) {
            Sign::Negative => false,
            // It is inside all the time, or never.
            Sign::Zero => false,
            Sign::Positive => is_at(rise, room, moment),
        }
    }

    /// Where the point is at a moment.
    pub(super) fn at(&self, moment: &Moment) -> RationalPoint3 {
        let Moment { numerator, denominator } = moment;
        let coordinate = |i: usize| &self.from[i] * denominator + &self.step[i] * numerator;
        RationalPoint3::new([0, 1, 2].map(coordinate), &self.grid * denominator)
    }

    /// The box keeps in the half-space grown by itself as long as its corner that reaches furthest
    /// against the normal is in the half-space.
    fn limit(&self, plane: &BigPlane) -> Limit {
        let BigPlane { normal, offset } = plane;
        let (mut rise, mut room) = (Int::ZERO, offset * &self.grid);
        for (i, n) in normal.iter().enumerate() {
            let corner = match Sign::of(n) {
                Sign::Negative => &self.high[i],
                // The plane is parallel to the axis.
                Sign::Zero => continue,
                Sign::Positive => &self.low[i],
            };
            rise += n * &self.step[i];
            room -= n * (&self.from[i] + corner);
        }
        Limit { rise, room }
    }
}

/// Whether `rise · moment = room`.
fn is_at(rise: Int, room: Int, moment: &Moment) -> bool {
    rise * &moment.numerator == room * &moment.denominator
}
