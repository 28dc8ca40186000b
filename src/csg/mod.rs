//! Boolean operations on convex brushes, exact.
//!
//! An [`Expression`] stands for a regularised set: the closure of the points that it holds in
//! their inside, so that faces where brushes touch or coincide neither join nor divide anything
//! by accident. [`evaluate`] divides a box around all brushes by their planes (Naylor, Amanatides
//! and Thibault, Merging BSP trees yields polyhedral set operations, 1990) until the expression
//! has one value in each cell: a brush that holds a cell or misses it is known there, and an
//! expression is often known before all of its brushes are.
//!
//! Invariants: every plane is one of the brushes' own; no vertex is rounded; the result is a
//! function of the expression. Complexity: with n brushes, O(n) signs a cell and level of the tree.

mod boundary;
mod brush;
mod expression;
mod hull;
mod input;
#[cfg(test)]
mod tests;
mod turn;

pub use brush::{BrushError, cuboid, cylinder, prism, pyramid, sphere, wedge};
pub use expression::{Expression, Half, Transform};
pub use hull::hull;
pub use input::{MAX_BRUSHES, MAX_DEPTH, NodeError, NodeRule, Placed};

use crate::construct::{
    Bounds, Boxed, IntegerBox, Limits, PlaneId, PlaneSet, Polygon, Polyhedron, SolidError,
};
use crate::num::{Int, Rational};
use expression::{Flat, flatten};

/// What an expression comes to.
#[derive(Clone, Debug)]
pub struct Body {
    /// The planes of everything below.
    pub planes: PlaneSet,
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
    /// No brush with volume.
    #[error("no brush of the expression has volume")]
    NoBrush,
}

/// A tree of splitting planes.
enum Tree {
    Split { plane: PlaneId, children: Box<[Tree; 2]> },
    Inside,
    Outside,
}

/// A brush with volume.
struct Brush {
    planes: Vec<PlaneId>,
    solid: Polyhedron,
}

/// How many planes are weighed for a split.
const CANDIDATES: usize = 8;

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
    let boxes = solids.iter().flatten().map(|body| &body.around);
    let around = IntegerBox::of_all(boxes, &Int::from(1)).ok_or(CsgError::NoBrush)?;
    let bounds = Bounds::new(&mut planes, &around);
    // A brush without volume holds nothing.
    let known = solids.iter().map(|solid| solid.is_none().then_some(false)).collect();
    let flat = (0..solids.len()).filter(|&brush| solids[brush].is_none()).collect();
    let brushes: Vec<Option<Brush>> = (solids.into_iter().zip(ids))
        .map(|(solid, planes)| solid.map(|Boxed { solid, .. }| Brush { planes, solid }))
        .collect();
    let mut division = Division {
        planes: &planes,
        bounds: &bounds,
        brushes: &brushes,
        formula,
        cells: Vec::new(),
    };
    let tree = division.divide(bounds.polyhedron(&planes), known);
    let cells = division.cells;
    let is_at_bounds = |cell: &Polyhedron| {
        cell.faces().iter().any(|face| bounds.planes().contains(&face.support()))
    };
    if cells.iter().any(is_at_bounds) {
        return Err(CsgError::Unbounded);
    }
    let boundary = boundary::of(&planes, &tree, &cells);
    Ok(Body { planes, cells, boundary, flat })
}

impl Body {
    /// Its volume.
    pub fn volume(&self) -> Rational {
        self.cells.iter().map(Polyhedron::volume).sum()
    }

    /// The area of its boundary, if that is rational.
    pub fn surface_area(&self) -> Option<Rational> {
        self.boundary.iter().map(boundary::area).sum()
    }
}

/// The division of the box.
struct Division<'a> {
    planes: &'a PlaneSet,
    bounds: &'a Bounds,
    brushes: &'a [Option<Brush>],
    formula: expression::Formula,
    /// The cells inside.
    cells: Vec<Polyhedron>,
}

impl Division<'_> {
    fn divide(&mut self, cell: Polyhedron, mut known: Vec<Option<bool>>) -> Tree {
        self.settle(&cell, &mut known);
        match self.formula.value(&known) {
            Some(true) => {
                self.cells.push(cell);
                Tree::Inside
            }
            Some(false) => Tree::Outside,
            None => {
                let plane = self.choose(&cell, &known);
                let section = cell.section(self.planes, self.bounds, plane);
                let [front, back] = cell.split(self.planes, &section);
                let front = self.divide(front, known.clone());
                let back = self.divide(back, known);
                Tree::Split { plane, children: Box::new([front, back]) }
            }
        }
    }

    /// Notes the brushes that hold the cell or miss it.
    fn settle(&self, cell: &Polyhedron, known: &mut [Option<bool>]) {
        for (known, brush) in known.iter_mut().zip(self.brushes) {
            let Some(brush) = brush.as_ref().filter(|_| known.is_none()) else { continue };
            let mut holds = true;
            for &plane in &brush.planes {
                let extent = cell.extent(self.planes, plane);
                if !extent.back {
                    *known = Some(false);
                }
                holds &= !extent.front;
            }
            if holds && known.is_none() {
                *known = Some(true);
            }
        }
    }

    /// Of some planes that cross the cell, the one that leaves most brushes to one side, evenly.
    fn choose(&self, cell: &Polyhedron, known: &[Option<bool>]) -> PlaneId {
        let open: Vec<&Brush> = (self.brushes.iter().zip(known))
            .filter(|(_, known)| known.is_none())
            .filter_map(|(brush, _)| brush.as_ref())
            .collect();
        let crosses = |plane: &PlaneId| {
            let extent = cell.extent(self.planes, *plane);
            extent.front && extent.back
        };
        let step = open.len().div_ceil(CANDIDATES);
        let sampled = open.iter().step_by(step);
        let candidates =
            sampled.flat_map(|brush| brush.planes.iter().copied().filter(crosses).take(2));
        candidates
            .min_by_key(|&plane| {
                let (mut front, mut back, mut both) = (0usize, 0usize, 0usize);
                for brush in &open {
                    let extent = brush.solid.extent(self.planes, plane);
                    match (extent.front, extent.back) {
                        (true, true) => both += 1,
                        (true, false) => front += 1,
                        (false, _) => back += 1,
                    }
                }
                front.abs_diff(back) + 2 * both
            })
            .expect("a brush that neither holds nor misses a cell has a plane across it")
    }
}
