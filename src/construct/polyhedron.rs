//! Convex polyhedra: the polygons of their faces, from half-spaces, split by planes.

use super::polygon::Extent;
use super::{Bounds, PlaneId, PlaneSet, Polygon, Split};
use crate::geom::RationalPoint3;
use crate::geom::vector::determinant;
use crate::num::{Int, Rational, Sign};
use crate::predicates::side_of_point;
use num_integer::Integer;

/// A bounded convex polyhedron with volume: its faces, their supports pointing outwards.
#[derive(Clone, Debug)]
pub struct Polyhedron {
    faces: Vec<Polygon>,
}

/// Why half-spaces make no solid.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SolidError {
    /// They have no inner point in common.
    #[error("the planes enclose no volume")]
    Flat,
    /// Their intersection reaches past every box.
    #[error("the planes leave the solid unbounded")]
    Unbounded,
}

impl Polyhedron {
    pub(super) fn new(faces: Vec<Polygon>) -> Polyhedron {
        Polyhedron { faces }
    }

    /// The part of a box on the negative side of all planes; `None` where that has no volume.
    ///
    /// Planes that touch it in less than a polygon leave no trace.
    pub fn of_half_spaces(
        planes: &PlaneSet,
        bounds: &Bounds,
        half_spaces: &[PlaneId],
    ) -> Option<Polyhedron> {
        let mut all: Vec<PlaneId> = half_spaces.to_vec();
        all.extend(bounds.planes());
        let mut distinct = Vec::with_capacity(all.len());
        for plane in all {
            if distinct.contains(&plane.flipped()) {
                return None;
            }
            if !distinct.contains(&plane) {
                distinct.push(plane);
            }
        }
        let face = |&support: &PlaneId| {
            let others = distinct.iter().filter(|&&other| other != support);
            others.fold(bounds.section(planes, support), |polygon, &other| {
                polygon?.inside(planes, other)
            })
        };
        let faces: Vec<Polygon> = distinct.iter().filter_map(face).collect();
        // A flat intersection with an area would have its plane in both directions.
        (!faces.is_empty()).then_some(Polyhedron { faces })
    }

    /// The faces, outwards.
    pub fn faces(&self) -> &[Polygon] {
        &self.faces
    }

    /// On which sides of a plane it has inner points.
    pub fn extent(&self, planes: &PlaneSet, plane: PlaneId) -> Extent {
        let mut extent = Extent::default();
        for face in &self.faces {
            let of_face = face.extent(planes, plane);
            extent.front |= of_face.front;
            extent.back |= of_face.back;
            if extent.front && extent.back {
                break;
            }
        }
        extent
    }

    /// Its section with a plane that has inner points of it on both sides, within a box that
    /// contains it.
    ///
    /// # Panics
    /// If the plane does not cross it.
    pub fn section(&self, planes: &PlaneSet, bounds: &Bounds, plane: PlaneId) -> Polygon {
        let whole = bounds.section(planes, plane);
        self.faces
            .iter()
            .fold(whole, |polygon, face| polygon?.inside(planes, face.support()))
            .expect("a plane through inner points cuts a polygon")
    }

    /// The parts on the positive and on the negative side of a plane, whose section is given.
    pub fn split(&self, planes: &PlaneSet, section: &Polygon) -> [Polyhedron; 2] {
        let plane = section.support();
        let (mut front, mut back) = (Vec::new(), Vec::new());
        for face in &self.faces {
            match face.split(planes, plane) {
                Split::Front => front.push(face.clone()),
                Split::Back => back.push(face.clone()),
                Split::On => unreachable!("the plane crosses the polyhedron"),
                Split::Both(positive, negative) => {
                    front.push(positive);
                    back.push(negative);
                }
            }
        }
        front.push(section.flipped());
        back.push(section.clone());
        [Polyhedron { faces: front }, Polyhedron { faces: back }]
    }

    /// What of it is on the negative side of a plane, within a box that contains it; `None` where
    /// that has no volume.
    pub fn inside(self, planes: &PlaneSet, bounds: &Bounds, plane: PlaneId) -> Option<Polyhedron> {
        let extent = self.extent(planes, plane);
        match (extent.front, extent.back) {
            (_, false) => None,
            (false, true) => Some(self),
            (true, true) => {
                let section = self.section(planes, bounds, plane);
                let [_, back] = self.split(planes, &section);
                Some(back)
            }
        }
    }

    /// Its volume.
    pub fn volume(&self) -> Rational {
        // The faces' fans, as signed pyramids over the origin: det[a, b, c] is six volumes.
        let six: Rational = self.faces.iter().map(pyramids).sum();
        six / Int::from(6)
    }

    /// A point inside: the mean of its faces' vertices.
    pub fn inner_point(&self) -> RationalPoint3 {
        mean(self.faces.iter().flat_map(Polygon::points))
    }

    /// A point inside with short coordinates: the multiples of 1, 1/2, 1/4 … nearest to the mean
    /// of its vertices, the first that are inside.
    pub fn short_inner_point(&self, planes: &PlaneSet) -> RationalPoint3 {
        let mean = self.inner_point();
        let two = Int::from(2);
        let mut grid = Int::from(1);
        loop {
            let rounded = mean.numerators().each_ref().map(|c| {
                Integer::div_floor(
                    &(c * &grid * &two + mean.denominator()),
                    &(&two * mean.denominator()),
                )
            });
            let point = RationalPoint3::new(rounded, grid.clone());
            if self.faces.iter().all(|face| {
                // A point on the boundary is not inside.
                side_of_point(planes.get(face.support()), &point) == Sign::Negative
            }) {
                return point;
            }
            grid *= 2;
        }
    }
}

/// The mean of one or more points.
pub fn mean(points: impl Iterator<Item = RationalPoint3>) -> RationalPoint3 {
    let zero = || Rational::from(Int::ZERO);
    let (mut sum, mut count) = ([zero(), zero(), zero()], 0);
    for point in points {
        let point = point.coordinates();
        sum = std::array::from_fn(|i| &sum[i] + &point[i]);
        count += 1;
    }
    RationalPoint3::from(&sum.map(|c| c / Int::from(count)))
}

fn pyramids(face: &Polygon) -> Rational {
    let points = face.points();
    let grid = RationalPoint3::common_denominator(&points);
    let points: Vec<_> = points.iter().map(|p| p.on_grid(&grid).coordinates).collect();
    let fan = points.windows(2).skip(1);
    let six = fan.map(|pair| determinant([&points[0], &pair[0], &pair[1]])).sum();
    Rational::new(six, grid.pow(3))
}
