//! Boolean operations on convex brushes, exact.
//!
//! An [`Expression`] stands for a regularised set: the closure of the points that it holds in
//! their inside, so that faces where brushes touch or coincide neither join nor divide anything
//! by accident. [`evaluate`] divides a box around all brushes by their planes (Naylor, Amanatides
//! and Thibault, Merging BSP trees yields polyhedral set operations, 1990) until the expression
//! has one value in each cell: a brush that holds a cell or misses it is decided there, and an
//! expression often before all of its brushes are.
//!
//! Boxes around brushes, by the ranks of their ends, come first: axial planes tell apart what is
//! spread out, and planes of brushes divide only what is left.
//!
//! Invariants: every face of the boundary lies in a plane of a brush; other axial planes may cut
//! it; no vertex is rounded; the result is a function of the expression. Complexity: in each cell
//! O(m log m), m the number of brushes that are undecided in it, and, where a brush is no box,
//! O(m) signs for each plane weighed. Where brushes are spread out or crowded evenly, time grows
//! about as their number does.

mod boundary;
mod brush;
mod divide;
mod ends;
mod expression;
mod formula;
mod hull;
mod input;
mod measure;
#[cfg(test)]
mod tests;
mod turn;

pub use brush::{BrushError, cuboid, cylinder, prism, pyramid, sphere, wedge};
pub use divide::{Child, Node, Tree};
pub use expression::{Expression, Half, Transform};
pub use hull::hull;
pub use input::{MAX_BRUSHES, MAX_DEPTH, NodeError, NodeRule, Placed};

use crate::construct::{Boxed, Limits, PlaneId, PlaneSet, Polygon, Polyhedron, SolidError};
use crate::geom::AxialBox;
use crate::num::{Int, Rational};
use divide::{Brush, divide};
use ends::Ends;
use formula::{Flat, flatten};

/// What an expression comes to.
#[derive(Clone, Debug)]
pub struct Body {
    /// The planes of everything below.
    pub planes: PlaneSet,
    /// The division of space.
    pub tree: Tree,
    /// Convex cells that tile it.
    pub cells: Vec<Polyhedron>,
    /// Its boundary, as convex polygons that point outwards and overlap in edges at most.
    pub boundary: Vec<Polygon>,
    /// The brushes without volume, in the order of the expression: they hold nothing.
    pub flat: Vec<usize>,
}

/// Why an expression has no value.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum CsgError {
    /// A half-space without a direction.
    #[error("brush {brush}: the normal of plane {plane} is zero")]
    NoNormal {
        /// The brush, counted from 0 in the order of the expression.
        brush: usize,
        /// The plane, counted from 0.
        plane: usize,
    },
    /// A brush without an end.
    #[error("brush {brush}: the planes leave it unbounded")]
    UnboundedBrush {
        /// The brush, counted from 0 in the order of the expression.
        brush: usize,
    },
    /// A complement that nothing bounds.
    #[error("the expression is unbounded: intersect its complement with a brush")]
    Unbounded,
}

/// The value of an expression.
///
/// # Errors
/// [`CsgError`] names the brush.
pub fn evaluate(expression: &Expression) -> Result<Body, CsgError> {
    let Flat { brushes, formula } = flatten(expression);
    let mut planes = PlaneSet::default();
    let mut ids = Vec::with_capacity(brushes.len());
    for (brush, half_spaces) in brushes.iter().enumerate() {
        let interned = planes.intern_all(half_spaces);
        ids.push(interned.map_err(|plane| CsgError::NoNormal { brush, plane })?);
    }
    let limits = Limits::new(&mut planes);
    let mut solids = Vec::with_capacity(ids.len());
    for (brush, half_spaces) in ids.iter().enumerate() {
        solids.push(match limits.cut_out(&planes, half_spaces) {
            Ok(solid) => Some(solid),
            Err(SolidError::Flat) => None,
            Err(SolidError::Unbounded) => return Err(CsgError::UnboundedBrush { brush }),
        });
    }
    let flat = (0..solids.len()).filter(|&brush| solids[brush].is_none()).collect();
    let boxes: Vec<AxialBox> =
        solids.iter().flatten().map(|Boxed { solid, .. }| ends::around(&planes, solid)).collect();
    let whole = around_all(&boxes);
    let (ends, ranks) = Ends::new(&mut planes, &whole, &boxes);
    let mut ranks = ranks.into_iter();
    let brush = |(solid, half_spaces): (Option<Boxed>, Vec<PlaneId>)| {
        let Boxed { solid, .. } = solid?;
        let (around, is_box) = (ranks.next()?, ends::is_box(&planes, &solid));
        Some(Brush { planes: half_spaces, solid, around, is_box })
    };
    let brushes: Vec<Option<Brush>> = solids.into_iter().zip(ids).map(brush).collect();
    let (tree, cells) = divide(&planes, &ends, &brushes, formula);
    let limits = ends.bounds(&ends.whole()).planes();
    let is_limit = |face: &Polygon| limits.contains(&face.support());
    if cells.iter().any(|cell| cell.solid.faces().iter().any(is_limit)) {
        return Err(CsgError::Unbounded);
    }
    let boundary = boundary::of(&planes, &tree, &cells);
    let cells = cells.into_iter().map(|cell| cell.solid).collect();
    Ok(Body { planes, tree, cells, boundary, flat })
}

/// A box with some room around others, or any if there are none.
fn around_all(boxes: &[AxialBox]) -> AxialBox {
    let one = || Rational::from(Int::from(1));
    let low = |i: usize| boxes.iter().map(|around| &around.low[i]).min().map(|low| low - one());
    let high = |i: usize| boxes.iter().map(|around| &around.high[i]).max().map(|high| high + one());
    AxialBox {
        low: [0, 1, 2].map(|i| low(i).unwrap_or_else(|| -one())),
        high: [0, 1, 2].map(|i| high(i).unwrap_or_else(one)),
    }
}

impl CsgError {
    /// The brush that it is about, counted from 0 in the order of the expression.
    pub fn brush(&self) -> Option<usize> {
        match self {
            CsgError::NoNormal { brush, .. } | CsgError::UnboundedBrush { brush } => Some(*brush),
            CsgError::Unbounded => None,
        }
    }
}

impl Body {
    /// Its volume.
    pub fn volume(&self) -> Rational {
        measure::volume(&self.planes, &self.boundary)
    }

    /// The area of its boundary, if that is rational.
    pub fn surface_area(&self) -> Option<Rational> {
        measure::area(&self.planes, &self.boundary)
    }
}
