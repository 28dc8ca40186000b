//! From the numbers of a file to a validated portal graph.
//!
//! The grid is the lowest common denominator of all coordinates, or a declared one; vertices are
//! interned exactly, so that equal places are equal indices. Portals keep the file's order of
//! vertices, which is counter-clockwise as seen from the second cell named. Coordinates below
//! 2^39 grid units are worked on in 128 bits, any others as unbounded integers: the same code,
//! the same answers. Linear in the number of vertices.

use super::polygon::{self, Pieces};
use super::{CellId, Portal, PortalGraph, Repairs};
use crate::geom::BigPoint3;
use crate::num::{Int, Number};
use num_integer::Integer;
use num_traits::{One, Signed, ToPrimitive};
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
    /// The vertices, counter-clockwise as seen from the second cell.
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
    #[error("the common denominator of all coordinates exceeds {limit} bits")]
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
    /// Validates `raw` and brings it to the grid.
    ///
    /// # Errors
    /// The first portal that breaks a rule.
    pub fn from_raw(raw: RawGraph) -> Result<PortalGraph, SceneError> {
        check_cells(&raw)?;
        let denominator = grid(&raw)?;
        let small = denominator.to_i64().and_then(|grid| small_corners(&raw.portals, grid));
        let (vertices, shapes) = match small {
            Some(corners) => {
                let (vertices, shapes) = shape_all(&raw.portals, corners)?;
                (vertices.into_iter().map(|v| v.map(Int::from)).collect(), shapes)
            }
            None => shape_all(&raw.portals, big_corners(&raw.portals, &denominator))?,
        };
        let vertices = vertices.into_iter().map(|coordinates| BigPoint3 { coordinates }).collect();
        Ok(PortalGraph {
            denominator,
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

/// The lowest common denominator of all coordinates, or the declared one that all fit.
fn grid(raw: &RawGraph) -> Result<Int, SceneError> {
    if let Some(grid) = &raw.declared_grid {
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
        return Ok(grid.clone());
    }
    let mut common = Int::one();
    let mut small = 1i64;
    for (index, portal) in raw.portals.iter().enumerate() {
        for number in portal.vertices.iter().flatten() {
            match number {
                Number::Small(_, denominator) if small % denominator == 0 => continue,
                Number::Small(_, denominator) => common = common.lcm(&Int::from(*denominator)),
                Number::Big(ratio) => common = common.lcm(ratio.denom()),
            }
            // Where the common denominator outgrows 64 bits, `small` stays a divisor of it, which
            // is all that the test above needs.
            small = common.to_i64().unwrap_or(small);
            if common.bits() > MAX_GRID_BITS {
                let kind = SceneErrorKind::HugeGrid { limit: MAX_GRID_BITS };
                return Err(portal.error(index, kind));
            }
        }
    }
    Ok(common)
}

/// Room for the smallest number that is read, 1e-4096. Every coordinate is scaled by the common
/// denominator, so one without a limit would let a small file fill the memory.
const MAX_GRID_BITS: u64 = 1 << 14;

/// Below this magnitude every value that `polygon` and `order` compute fits in 128 bits: with
/// |c| < 2^39 a difference is below 2^40, a component of a cross product of differences below
/// 2^81, the sum of three such components times a difference below 2^123, and the vector area of
/// up to 2^40 triangles below 2^121.
const SMALL_LIMIT: i128 = 1 << 39;

fn small_corners(portals: &[RawPortal], grid: i64) -> Option<Vec<[i128; 3]>> {
    let mut corners = Vec::with_capacity(portals.iter().map(|portal| portal.vertices.len()).sum());
    for corner in portals.iter().flat_map(|portal| &portal.vertices) {
        let mut scaled = [0; 3];
        for (scaled, number) in scaled.iter_mut().zip(corner) {
            let Number::Small(numerator, denominator) = number else { return None };
            *scaled = i128::from(*numerator) * i128::from(grid / denominator);
            if scaled.abs() >= SMALL_LIMIT {
                return None;
            }
        }
        corners.push(scaled);
    }
    Some(corners)
}

fn big_corners(portals: &[RawPortal], grid: &Int) -> Vec<[Int; 3]> {
    let corners = portals.iter().flat_map(|portal| &portal.vertices);
    let scale = |number: &Number| (number.to_rational() * grid).to_integer();
    corners.map(|corner| [scale(&corner[0]), scale(&corner[1]), scale(&corner[2])]).collect()
}

/// The portals of a graph in the making.
struct Shapes {
    portals: Vec<Portal>,
    skew_portals: u32,
    repairs: Repairs,
}

/// Interns the corners (all portals' vertices in a row) and shapes every portal.
fn shape_all<T: Signed + Clone + PartialOrd + Eq + Hash>(
    raw: &[RawPortal],
    corners: Vec<[T; 3]>,
) -> Result<(Vec<[T; 3]>, Shapes), SceneError> {
    let mut vertices: Vec<[T; 3]> = Vec::new();
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
        let shape = polygon::shape(&vertices, loop_of_vertices, &mut shapes.repairs)
            .map_err(|kind| portal.error(index, kind))?;
        let [from, to] = portal.cells.map(CellId);
        let mut push = |vertices| {
            shapes.portals.push(Portal { from, to, vertices, source: index as u32 });
        };
        match shape {
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
