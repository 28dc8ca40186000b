//! Common brushes as half-spaces: boxes, wedges, prisms, pyramids, cylinders, spheres, hulls.

use super::expression::Half;
use super::hull::hull;
use super::turn::on_circle;
use crate::geom::vector::{cross, difference, dot};
use crate::num::{Int, Rational, Sign};
use num_traits::Zero;

/// Why a shape is no brush.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum BrushError {
    /// It holds no volume.
    #[error("the brush has no volume")]
    Flat,
    /// The vertices of a polygon do not run around a convex one.
    #[error("the polygon is not convex")]
    NotConvex,
    /// A radius that is zero or less.
    #[error("the radius is not positive")]
    Radius,
    /// More or fewer sides than there may be.
    #[error("expected {least} to {most} sides{}, got {got}", if *.even { ", an even number" } else { "" })]
    Sides {
        /// The least number.
        least: u32,
        /// The greatest number.
        most: u32,
        /// Whether it must be even.
        even: bool,
        /// The number given.
        got: u32,
    },
}

type Halves = Result<Vec<Half>, BrushError>;

fn half(axis: usize, sign: i32, offset: &Rational) -> Half {
    let mut normal = [(); 3].map(|()| Rational::zero());
    normal[axis] = Rational::from(Int::from(sign));
    Half { normal, offset: offset * Int::from(sign) }
}

/// The box with these opposite corners.
///
/// # Errors
/// [`BrushError::Flat`] unless the first corner is less on every axis.
pub fn cuboid(low: &[Rational; 3], high: &[Rational; 3]) -> Halves {
    if low.iter().zip(high).any(|(low, high)| low >= high) {
        return Err(BrushError::Flat);
    }
    let of_axis = |axis: usize| [half(axis, -1, &low[axis]), half(axis, 1, &high[axis])];
    Ok((0..3).flat_map(of_axis).collect())
}

/// The part of a box below the plane that rises from its lower edge at the least x to its upper
/// edge at the greatest x.
///
/// # Errors
/// [`BrushError::Flat`] as for the box.
pub fn wedge(low: &[Rational; 3], high: &[Rational; 3]) -> Halves {
    let mut halves = cuboid(low, high)?;
    let [length, _, height] = difference(high, low);
    let normal = [-height, Rational::zero(), length];
    let offset = dot(&normal, low);
    halves.push(Half { normal, offset });
    Ok(halves)
}

/// The prism over a convex polygon of the plane, from one height to another. Quadratic in the
/// polygon's vertices.
///
/// # Errors
/// A polygon that is not convex, or one without area; heights that do not rise.
pub fn prism(polygon: &[[Rational; 2]], heights: &[Rational; 2]) -> Halves {
    let [bottom, top] = heights;
    let edges = edges(polygon)?;
    if bottom >= top {
        return Err(BrushError::Flat);
    }
    let side = |[[px, py], [qx, qy]]: [&[Rational; 2]; 2]| {
        let normal = [qy - py, px - qx, Rational::zero()];
        let offset = &normal[0] * px + &normal[1] * py;
        Half { normal, offset }
    };
    let caps = [half(2, -1, bottom), half(2, 1, top)];
    Ok(edges.into_iter().map(side).chain(caps).collect())
}

/// The pyramid over a convex polygon at a height, up or down to its apex. Quadratic in the
/// polygon's vertices.
///
/// # Errors
/// A polygon that is not convex, or one without area; an apex at the polygon's height.
pub fn pyramid(polygon: &[[Rational; 2]], height: &Rational, apex: &[Rational; 3]) -> Halves {
    let edges = edges(polygon)?;
    let rise = Sign::of(&(&apex[2] - height));
    let base = match rise {
        Sign::Positive => half(2, -1, height),
        Sign::Negative => half(2, 1, height),
        // The apex is in the plane of the base.
        Sign::Zero => return Err(BrushError::Flat),
    };
    let at = |[x, y]: &[Rational; 2]| [x.clone(), y.clone(), height.clone()];
    let side = |[p, q]: [&[Rational; 2]; 2]| {
        let (p, q) = (at(p), at(q));
        // Outwards for a counter-clockwise base below its apex.
        let normal = cross(&difference(&q, &p), &difference(apex, &p));
        let normal = match rise {
            Sign::Positive => normal,
            // Zero has returned above.
            Sign::Negative | Sign::Zero => normal.map(|c| -c),
        };
        let offset = dot(&normal, &p);
        Half { normal, offset }
    };
    Ok(edges.into_iter().map(side).chain([base]).collect())
}

/// The edges of a convex polygon in counter-clockwise order, those without length left out.
fn edges(polygon: &[[Rational; 2]]) -> Result<Vec<[&[Rational; 2]; 2]>, BrushError> {
    let next = polygon.iter().cycle().skip(1);
    let mut edges: Vec<_> =
        polygon.iter().zip(next).filter(|(p, q)| p != q).map(|(p, q)| [p, q]).collect();
    let (mut left, mut right) = (false, false);
    for [p, q] in &edges {
        for r in polygon {
            let area = (&q[0] - &p[0]) * (&r[1] - &p[1]) - (&q[1] - &p[1]) * (&r[0] - &p[0]);
            match Sign::of(&area) {
                Sign::Positive => left = true,
                Sign::Negative => right = true,
                // On the edge's line: an end of it, or a vertex amid a straight side.
                Sign::Zero => {}
            }
        }
    }
    match (left, right) {
        (true, false) => Ok(edges),
        (false, true) => {
            edges.iter_mut().for_each(|edge| edge.reverse());
            Ok(edges)
        }
        (false, false) => Err(BrushError::Flat),
        (true, true) => Err(BrushError::NotConvex),
    }
}

/// How many sides a cylinder and a sphere may have.
const CYLINDER_SIDES: [u32; 2] = [3, 256];
const SPHERE_SIDES: [u32; 2] = [4, 32];

/// The prism over the hull of a regular polygon's vertices, whose offsets from the axis are
/// rounded to multiples of one over the grid, halves away from zero. The first vertex is at the
/// greatest x.
///
/// # Errors
/// A radius or a number of sides that is out of range; heights that do not rise, or a grid so
/// coarse that no volume is left.
pub fn cylinder(
    center: &[Rational; 2],
    radius: &Rational,
    heights: &[Rational; 2],
    sides: u32,
    grid: &Int,
) -> Halves {
    check_round(radius, sides, CYLINDER_SIDES, false)?;
    let [bottom, top] = heights;
    if bottom >= top {
        return Err(BrushError::Flat);
    }
    let points: Vec<[Rational; 3]> = (0..sides)
        .flat_map(|k| {
            let [x, y] = on_circle(k, sides).map(|c| rounded(&(c * radius), grid));
            let (x, y) = (x + &center[0], y + &center[1]);
            heights.iter().map(move |z| [x.clone(), y.clone(), z.clone()])
        })
        .collect();
    hull(&points)
}

/// The hull of points on a sphere's meridians, at equal steps from pole to pole, whose offsets
/// from the centre are rounded to multiples of one over the grid, halves away from zero. The
/// poles are at the least and the greatest z.
///
/// # Errors
/// A radius or a number of sides that is out of range; a grid so coarse that no volume is left.
pub fn sphere(center: &[Rational; 3], radius: &Rational, sides: u32, grid: &Int) -> Halves {
    check_round(radius, sides, SPHERE_SIDES, true)?;
    let at = |offset: [Rational; 3]| -> [Rational; 3] {
        std::array::from_fn(|i| rounded(&(&offset[i] * radius), grid) + &center[i])
    };
    let pole = |z: i32| at([Rational::zero(), Rational::zero(), Rational::from(Int::from(z))]);
    let mut points = vec![pole(-1), pole(1)];
    for step in 1..sides / 2 {
        // A quarter turn from the pole is the equator.
        let [z, out] = on_circle(step, sides);
        for k in 0..sides {
            let [x, y] = on_circle(k, sides).map(|c| c * &out);
            points.push(at([x, y, z.clone()]));
        }
    }
    hull(&points)
}

fn check_round(
    radius: &Rational,
    sides: u32,
    [least, most]: [u32; 2],
    even: bool,
) -> Result<(), BrushError> {
    match Sign::of(radius) {
        Sign::Positive => {}
        // A point, not a body.
        Sign::Zero | Sign::Negative => return Err(BrushError::Radius),
    }
    if !(least..=most).contains(&sides) || (even && sides % 2 == 1) {
        return Err(BrushError::Sides { least, most, even, got: sides });
    }
    Ok(())
}

/// The multiple of 1 / `grid` next to a number, halves away from zero.
fn rounded(value: &Rational, grid: &Int) -> Rational {
    (value * grid).round() / grid
}
