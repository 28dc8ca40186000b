//! The twin for a moving point: from plane to plane, by what is around each position.
//!
//! The times at which the point crosses a plane of a solid or polygon that it meets cut its way
//! into points and open intervals, along each of which nothing changes. Around a position the
//! planes through it cut space into cones, found by linear systems; a cone is solid or free, and
//! two free cones hang together where they share a face that is no polygon. The point can be in
//! the bunches of free cones that it reaches from those before; where it reaches none, it stops.
//! Cost: for s stations and k planes through a position, s·k^2 cones, each a system of k vectors.

use super::linear::{Outcome, Quadratic, decide};
use crate::geom::vector::{cross, difference, dot};
use crate::geom::{BigPlane, RationalPoint3};
use crate::num::{Int, Rational, Sign};
use num_integer::Integer;
use num_traits::{One, Zero};

/// Something that a point meets.
struct Obstacle {
    /// A solid is on their negative sides; of a polygon, these are its plane and planes through its
    /// edges that point outward.
    planes: Vec<BigPlane>,
    /// Whether it is a polygon, in the first of the planes.
    flat: bool,
}

/// How far a point gets on the way between two points: the least time at which it cannot go on,
/// or 1. Solids are the negative sides of their planes, bounded or not; polygons are strictly
/// convex. `None` where it starts in no free space.
pub fn first_contact(
    solids: &[Vec<BigPlane>],
    polygons: &[Vec<RationalPoint3>],
    from: &RationalPoint3,
    to: &RationalPoint3,
) -> Option<Rational> {
    let solids = solids.iter().map(|planes| Obstacle { planes: planes.clone(), flat: false });
    let polygons = polygons.iter().map(|vertices| polygon(vertices));
    let (start, end) = (from.coordinates(), to.coordinates());
    let step = difference(&end, &start);
    let met: Vec<Obstacle> =
        solids.chain(polygons).filter(|obstacle| obstacle.is_met(&start, &step)).collect();
    let at = |time: &Rational| [0, 1, 2].map(|i| &start[i] + &step[i] * time);
    let mut here = Fan::around(&met, &at(&Rational::zero()));
    let mut reached: Vec<bool> = here.bunch.iter().map(Option::is_some).collect();
    if !reached.contains(&true) {
        return None;
    }
    let times = times(&met, &start, &step);
    for pair in times.windows(2) {
        let middle = (&pair[0] + &pair[1]) / Int::from(2);
        let between = Fan::around(&met, &at(&middle));
        let onward = between.reached_from(&here, &reached, &step);
        if !onward.contains(&true) {
            return Some(pair[0].clone());
        }
        here = Fan::around(&met, &at(&pair[1]));
        reached = here.reached_by(&between, &onward, &step);
    }
    Some(Rational::one())
}

/// A polygon's plane, and the planes through its edges at a right angle to it.
fn polygon(vertices: &[RationalPoint3]) -> Obstacle {
    let grid = RationalPoint3::common_denominator(vertices);
    let corners: Vec<[Int; 3]> = vertices.iter().map(|v| v.on_grid(&grid).coordinates).collect();
    let normal =
        cross(&difference(&corners[1], &corners[0]), &difference(&corners[2], &corners[0]));
    let through = |normal: [Int; 3], corner: &[Int; 3]| {
        let offset = dot(&normal, corner);
        BigPlane { normal: normal.map(|n| n * &grid), offset }
    };
    let edges = corners.iter().zip(corners.iter().cycle().skip(1));
    let edges = edges.map(|(a, b)| through(cross(&difference(b, a), &normal), a));
    let planes = std::iter::once(through(normal.clone(), &corners[0])).chain(edges).collect();
    Obstacle { planes, flat: true }
}

/// n·x - o.
fn height(plane: &BigPlane, point: &[Rational; 3]) -> Rational {
    rational_dot(&plane.normal, point) - &plane.offset
}

fn rational_dot(normal: &[Int; 3], vector: &[Rational; 3]) -> Rational {
    (0..3).map(|i| &vector[i] * &normal[i]).sum()
}

impl Obstacle {
    /// Whether the closed set contains the point.
    fn holds(&self, point: &[Rational; 3]) -> bool {
        self.planes.iter().enumerate().all(|(i, plane)| match Sign::of(&height(plane, point)) {
            Sign::Negative => i > 0 || !self.flat,
            // The boundary belongs to the set.
            Sign::Zero => true,
            Sign::Positive => false,
        })
    }

    /// Whether the closed segment meets the closed set.
    fn is_met(&self, start: &[Rational; 3], step: &[Rational; 3]) -> bool {
        let (mut low, mut high) = (Rational::zero(), Rational::one());
        for (i, plane) in self.planes.iter().enumerate() {
            let (rise, room) = (rational_dot(&plane.normal, step), -height(plane, start));
            let both = i == 0 && self.flat;
            match Sign::of(&rise) {
                // A segment along a plane is inside of it as its start is.
                Sign::Zero if room < Rational::zero() || (both && !room.is_zero()) => return false,
                Sign::Zero => continue,
                Sign::Positive | Sign::Negative => {}
            }
            let time = room / &rise;
            if both || rise < Rational::zero() {
                low = low.max(time.clone());
            }
            if both || rise > Rational::zero() {
                high = high.min(time);
            }
        }
        low <= high
    }
}

/// The times from 0 to 1 at which a plane is crossed, with both ends, ascending.
fn times(met: &[Obstacle], start: &[Rational; 3], step: &[Rational; 3]) -> Vec<Rational> {
    let mut times = vec![Rational::zero(), Rational::one()];
    for plane in met.iter().flat_map(|obstacle| &obstacle.planes) {
        let rise = rational_dot(&plane.normal, step);
        if !rise.is_zero() {
            let time = -height(plane, start) / rise;
            if Rational::zero() < time && time < Rational::one() {
                times.push(time);
            }
        }
    }
    times.sort_unstable();
    times.dedup();
    times
}

/// The cones around a position.
struct Fan {
    /// The normals of the planes through it, each plane once.
    normals: Vec<[Int; 3]>,
    /// For each cone its side of each plane: whether it is on the positive one.
    cones: Vec<Vec<bool>>,
    /// The bunch of each free cone, by its first cone.
    bunch: Vec<Option<usize>>,
}

/// An obstacle around a position: its planes through it, by index, each with whether its normal
/// is the opposite of the fan's.
struct Around {
    planes: Vec<(usize, bool)>,
    flat: bool,
}

impl Fan {
    fn around(met: &[Obstacle], point: &[Rational; 3]) -> Fan {
        let mut fan = Fan { normals: Vec::new(), cones: vec![Vec::new()], bunch: Vec::new() };
        let here: Vec<&Obstacle> = met.iter().filter(|obstacle| obstacle.holds(point)).collect();
        let around: Vec<Around> = here
            .iter()
            .map(|obstacle| {
                let through = obstacle.planes.iter().filter(|p| height(p, point).is_zero());
                let planes = through.map(|plane| fan.add(&plane.normal)).collect();
                Around { planes, flat: obstacle.flat }
            })
            .collect();
        let inside = |cone: &[bool], planes: &[(usize, bool)]| {
            planes.iter().all(|&(plane, flipped)| cone[plane] == flipped)
        };
        let solid = |cone: &Vec<bool>| around.iter().any(|o| !o.flat && inside(cone, &o.planes));
        let free: Vec<bool> = fan.cones.iter().map(|cone| !solid(cone)).collect();
        fan.bunch = (0..fan.cones.len()).map(|i| free[i].then_some(i)).collect();
        for (i, one) in fan.cones.iter().enumerate() {
            for (j, other) in fan.cones[..i].iter().enumerate() {
                let mut apart = (0..one.len()).filter(|&k| one[k] != other[k]);
                let (Some(plane), None) = (apart.next(), apart.next()) else { continue };
                let shut = around
                    .iter()
                    .any(|o| o.flat && o.planes[0].0 == plane && inside(one, &o.planes[1..]));
                if let (Some(a), Some(b), false) = (fan.bunch[i], fan.bunch[j], shut) {
                    fan.bunch.iter_mut().filter(|c| **c == Some(a)).for_each(|c| *c = Some(b));
                }
            }
        }
        fan
    }

    /// The index of a plane through the position, and whether its normal is the opposite of the
    /// one kept; a new plane cuts the cones.
    fn add(&mut self, normal: &[Int; 3]) -> (usize, bool) {
        let divisor = normal.iter().fold(Int::zero(), |divisor, c| divisor.gcd(c));
        let first = normal.iter().find(|c| !c.is_zero()).expect("a plane has a normal");
        let flipped = *first < Int::zero();
        let divisor = if flipped { -divisor } else { divisor };
        let normal = normal.each_ref().map(|c| c / &divisor);
        if let Some(known) = self.normals.iter().position(|known| *known == normal) {
            return (known, flipped);
        }
        self.normals.push(normal);
        let cut = self.cones.iter().flat_map(|cone| {
            [false, true].map(|side| cone.iter().copied().chain([side]).collect::<Vec<bool>>())
        });
        self.cones = cut.filter(|cone| self.exists(cone)).collect();
        (self.normals.len() - 1, flipped)
    }

    /// Whether some direction has these sides of the planes.
    fn exists(&self, cone: &[bool]) -> bool {
        let vector = |(normal, &positive): (&[Int; 3], &bool)| {
            normal.each_ref().map(|c| Quadratic::from(if positive { c.clone() } else { -c }))
        };
        let vectors: Vec<_> = self.normals.iter().zip(cone).map(vector).collect();
        matches!(decide(&[], &vectors, &Int::zero()), Outcome::Direction(_))
    }

    /// For a fan of an interval that follows a position: which of its cones are reached from
    /// there.
    fn reached_from(&self, before: &Fan, reached: &[bool], step: &[Rational; 3]) -> Vec<bool> {
        let hits = |i: usize| {
            (0..before.cones.len()).any(|j| reached[j] && before.holds(j, self, i, step, false))
        };
        self.spread((0..self.cones.len()).map(|i| self.bunch[i].is_some() && hits(i)).collect())
    }

    /// For a fan of a position that ends an interval: which of its cones are reached from there.
    fn reached_by(&self, before: &Fan, reached: &[bool], step: &[Rational; 3]) -> Vec<bool> {
        let hits = |i: usize| {
            (0..before.cones.len()).any(|j| reached[j] && self.holds(i, before, j, step, true))
        };
        self.spread((0..self.cones.len()).map(|i| self.bunch[i].is_some() && hits(i)).collect())
    }

    /// Whether a cone of a position goes on as a cone of the interval after it, or before it.
    fn holds(
        &self,
        cone: usize,
        interval: &Fan,
        part: usize,
        step: &[Rational; 3],
        before: bool,
    ) -> bool {
        self.normals.iter().zip(&self.cones[cone]).all(|(normal, &side)| {
            match Sign::of(&rational_dot(normal, step)) {
                Sign::Negative => side == before,
                // The plane contains the way; along the interval it may be no obstacle's any more.
                Sign::Zero => {
                    let known = interval.normals.iter().position(|other| other == normal);
                    known.is_none_or(|known| interval.cones[part][known] == side)
                }
                Sign::Positive => side != before,
            }
        })
    }

    /// All cones of the bunches of which one is reached.
    fn spread(&self, reached: Vec<bool>) -> Vec<bool> {
        let bunches =
            |i: usize| (0..reached.len()).any(|j| reached[j] && self.bunch[j] == self.bunch[i]);
        (0..reached.len()).map(|i| self.bunch[i].is_some() && bunches(i)).collect()
    }
}
