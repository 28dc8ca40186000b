//! From the numbers of a file to a validated portal graph.
//!
//! Vertices are interned exactly, so that equal places are equal indices. Portals keep the file's
//! order of vertices, which is counter-clockwise as seen from the second cell named. Where all
//! coordinates have a common denominator and are below 2^39 in its units, they are worked on in
//! 128 bits; otherwise each portal on the grid of its own denominators, as unbounded integers: the
//! same code, the same answers. Linear in the number of vertices.

use super::polygon::{self, Pieces};
use super::{CellId, Portal, PortalGraph, Repairs};
use crate::geom::RationalPoint3;
use crate::num::{Int, Number};
use num_integer::Integer;
use rustc_hash::FxHashMap;
use std::hash::Hash;

/// A portal graph as a file states it, not yet validated.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct RawGraph {
    /// The names of the cells.
    pub cells: Vec<String>,
    /// The portals.
    pub portals: Vec<RawPortal>,
    /// The cell of each leaf.
    pub leaf_to_cell: Vec<u32>,
    /// Grid units in one world unit, where the file declares them.
    pub declared_grid: Option<Int>,
}

/// A polygon between two cells, not yet validated.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RawPortal {
    /// The cell that the normal leaves, and the one that it enters.
    pub cells: [u32; 2],
    /// The vertices, counter-clockwise as seen from the second cell, in world units (a
    /// [`RationalPoint3`] converts into this form).
    pub vertices: Vec<[Number; 3]>,
    /// The line of the file, where the format has one portal a line.
    pub line: Option<usize>,
}

/// Which portal breaks a rule of scenes.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("portal {portal}: {kind}")]
pub struct SceneError {
    /// The portal, counted from 0.
    pub portal: usize,
    /// Its line, where the format has one portal a line.
    pub line: Option<usize>,
    /// The rule broken.
    pub kind: SceneErrorKind,
}

/// The rules of a portal graph.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SceneErrorKind {
    /// A cell number past the last cell.
    #[error("names cell {got}, but there are {cells} cells, counted from 0")]
    MissingCell {
        /// The number named.
        got: u32,
        /// The number of cells.
        cells: usize,
    },
    /// Both sides are the same cell.
    #[error("joins cell {0} with itself, expected two cells")]
    SameCell(u32),
    /// Fewer than three vertices once repeated ones are dropped.
    #[error("{0} distinct vertices in a row, expected three or more")]
    TooFewVertices(usize),
    /// The polygon encloses no area.
    #[error("the polygon has zero area")]
    ZeroArea,
    /// The polygon is not convex, and its outline crosses or touches itself, as it looks along the
    /// axis of its largest area.
    #[error("not convex, and its outline crosses or touches itself, so that no triangles tile it")]
    NotSimple,
    /// Coordinates with so many different denominators that no grid of a sane size holds them.
    #[error("the common denominator of the portal's coordinates exceeds {limit} bits")]
    HugeGrid {
        /// The limit.
        limit: u64,
    },
    /// A coordinate that is not a multiple of the declared grid unit.
    #[error(
        "vertex {vertex}: coordinate {got} is not a multiple of the declared grid unit 1/{grid}"
    )]
    OffGrid {
        /// The vertex, counted from 0.
        vertex: usize,
        /// The coordinate.
        got: Number,
        /// The declared number of grid units in one world unit.
        grid: Int,
    },
}

impl PortalGraph {
    /// Validates `raw`.
    ///
    /// # Errors
    /// The first portal that breaks a rule.
    pub fn from_raw(raw: RawGraph) -> Result<PortalGraph, SceneError> {
        check_cells(&raw)?;
        check_grid(&raw)?;
        let (vertices, shapes) = match small_corners(&raw.portals) {
            Some((grid, corners)) => {
                let (vertices, shapes) = shape_all(&raw.portals, corners, polygon::shape)?;
                let grid = Int::from(grid);
                let point = |v: [i128; 3]| RationalPoint3::new(v.map(Int::from), grid.clone());
                (vertices.into_iter().map(point).collect(), shapes)
            }
            None => shape_all(&raw.portals, rational_corners(&raw.portals), shape_alone)?,
        };
        Ok(PortalGraph {
            vertices,
            portals: shapes.portals,
            cells: raw.cells,
            leaf_to_cell: raw.leaf_to_cell.into_iter().map(CellId).collect(),
            skew_portals: shapes.skew_portals,
            repairs: shapes.repairs,
        })
    }
}

fn check_cells(raw: &RawGraph) -> Result<(), SceneError> {
    let cells = raw.cells.len();
    for (index, portal) in raw.portals.iter().enumerate() {
        for got in portal.cells {
            if got as usize >= cells {
                return Err(portal.error(index, SceneErrorKind::MissingCell { got, cells }));
            }
        }
        if portal.cells[0] == portal.cells[1] {
            return Err(portal.error(index, SceneErrorKind::SameCell(portal.cells[0])));
        }
    }
    Ok(())
}

impl RawPortal {
    fn error(&self, portal: usize, kind: SceneErrorKind) -> SceneError {
        SceneError { portal, line: self.line, kind }
    }
}

/// Whether all coordinates are multiples of the declared unit, if there is one.
fn check_grid(raw: &RawGraph) -> Result<(), SceneError> {
    let Some(grid) = &raw.declared_grid else { return Ok(()) };
    for (index, portal) in raw.portals.iter().enumerate() {
        for (vertex, corner) in portal.vertices.iter().enumerate() {
            for number in corner {
                if !grid.is_multiple_of(number.to_rational().denom()) {
                    let (got, grid) = (number.clone(), grid.clone());
                    let kind = SceneErrorKind::OffGrid { vertex, got, grid };
                    return Err(portal.error(index, kind));
                }
            }
        }
    }
    Ok(())
}

/// Room for the smallest number that is read, 1e-4096. A portal's coordinates are scaled by their
/// common denominator, so one without a limit would let a small file fill the memory.
const MAX_GRID_BITS: u64 = 1 << 14;

/// Below this magnitude every value that `polygon` and `order` compute fits in 128 bits: with
/// |c| < 2^39 a difference is below 2^40, a component of a cross product of differences below
/// 2^81, the sum of three such components times a difference below 2^123, and the vector area of
/// up to 2^40 triangles below 2^121.
const SMALL_LIMIT: i128 = 1 << 39;

/// The common denominator of all corners, and the corners in its units, if all of them are small.
fn small_corners(portals: &[RawPortal]) -> Option<(i64, Vec<[i128; 3]>)> {
    let corners = || portals.iter().flat_map(|portal| &portal.vertices);
    let mut grid = 1i64;
    for number in corners().flatten() {
        let Number::Small(_, denominator) = number else { return None };
        if grid % denominator != 0 {
            grid = grid.checked_mul(denominator / grid.gcd(denominator))?;
        }
    }
    let mut small = Vec::with_capacity(portals.iter().map(|portal| portal.vertices.len()).sum());
    for corner in corners() {
        let mut scaled = [0; 3];
        for (scaled, number) in scaled.iter_mut().zip(corner) {
            let Number::Small(numerator, denominator) = number else { return None };
            *scaled = i128::from(*numerator) * i128::from(grid / denominator);
            if scaled.abs() >= SMALL_LIMIT {
                return None;
            }
        }
        small.push(scaled);
    }
    Some((grid, small))
}

fn rational_corners(portals: &[RawPortal]) -> Vec<RationalPoint3> {
    let corners = portals.iter().flat_map(|portal| &portal.vertices);
    corners.map(|corner| (&corner.each_ref().map(Number::to_rational)).into()).collect()
}

/// Shapes a polygon on the grid of its own denominators.
pub(super) fn shape_alone(
    vertices: &[RationalPoint3],
    corners: Vec<u32>,
    repairs: &mut Repairs,
) -> Result<Pieces, SceneErrorKind> {
    let mut distinct = corners.clone();
    distinct.sort_unstable();
    distinct.dedup();
    let points = || distinct.iter().map(|&corner| &vertices[corner as usize]);
    let grid = points().try_fold(Int::from(1), |common, point| {
        Some(point.common_with(common)).filter(|common| common.bits() <= MAX_GRID_BITS)
    });
    let grid = grid.ok_or(SceneErrorKind::HugeGrid { limit: MAX_GRID_BITS })?;
    let scaled: Vec<[Int; 3]> = points().map(|point| point.on_grid(&grid).coordinates).collect();
    let place = |corner| distinct.partition_point(|&other| other < corner) as u32;
    let pieces = polygon::shape(&scaled, corners.into_iter().map(place).collect(), repairs)?;
    let corner = |place: u32| distinct[place as usize];
    let triangles = |all: Vec<[u32; 3]>| all.into_iter().map(|t| t.map(corner)).collect();
    Ok(match pieces {
        Pieces::Convex(polygon) => Pieces::Convex(polygon.into_iter().map(corner).collect()),
        Pieces::Skew(all) => Pieces::Skew(triangles(all)),
        Pieces::Dented(all) => Pieces::Dented(triangles(all)),
    })
}

/// The portals of a graph in the making.
struct Shapes {
    portals: Vec<Portal>,
    skew_portals: u32,
    repairs: Repairs,
}

/// Interns the corners (all portals' vertices in a row) and shapes every portal by `shape`, which
/// takes the vertices so far, and the portal's by their indices.
fn shape_all<Corner: Clone + Eq + Hash>(
    raw: &[RawPortal],
    corners: Vec<Corner>,
    shape: impl Fn(&[Corner], Vec<u32>, &mut Repairs) -> Result<Pieces, SceneErrorKind>,
) -> Result<(Vec<Corner>, Shapes), SceneError> {
    let mut vertices: Vec<Corner> = Vec::new();
    let mut indices = FxHashMap::default();
    let mut shapes = Shapes {
        portals: Vec::with_capacity(raw.len()),
        skew_portals: 0,
        repairs: Repairs::default(),
    };
    let mut corners = corners.into_iter();
    for (index, portal) in raw.iter().enumerate() {
        let mut loop_of_vertices = Vec::with_capacity(portal.vertices.len());
        for corner in corners.by_ref().take(portal.vertices.len()) {
            let next = vertices.len() as u32;
            loop_of_vertices.push(*indices.entry(corner).or_insert_with_key(|corner| {
                vertices.push(corner.clone());
                next
            }));
        }
        let pieces = shape(&vertices, loop_of_vertices, &mut shapes.repairs)
            .map_err(|kind| portal.error(index, kind))?;
        let [from, to] = portal.cells.map(CellId);
        let mut push = |vertices| {
            shapes.portals.push(Portal { from, to, vertices, source: index as u32 });
        };
        match pieces {
            Pieces::Convex(polygon) => push(polygon),
            Pieces::Skew(triangles) => {
                triangles.into_iter().for_each(|triangle| push(triangle.to_vec()));
                shapes.skew_portals += 1;
            }
            Pieces::Dented(triangles) => {
                triangles.into_iter().for_each(|triangle| push(triangle.to_vec()));
                shapes.repairs.dented_portals += 1;
            }
        }
    }
    Ok((vertices, shapes))
}
