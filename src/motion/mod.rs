//! First contact: how far a point, or an axial box, gets on a straight move through the cells.
//!
//! Definitions. A move takes a point from one position to another; at the time t in [0, 1] it is
//! at p(t) = from + t (to - from). A *point* may be in closed cells, and passes from one cell to
//! another only while it is in a closed portal between them. A *box* is carried by the point; its
//! inside may meet neither the inside of a solid nor a polygon. The first contact is the least
//! time after which this fails at once; a move without one is free. `docs/motion.md` has every
//! borderline case.
//!
//! Algorithm (Carr 2004, on moves through the graph, made exact). All sets that matter are convex,
//! so that a straight move is in each of them for one interval of time, with rational ends
//! (`path`). A point's way is the search for the earliest entry into each cell through the closed
//! portals (`point`). A box is held against the bodies near the cells that it may come to, which a
//! flood through the portals near its way finds (`carried`), by the supporting half-spaces of their
//! Minkowski sum (`body`).
//!
//! Complexity of a move: O((c + g) log g) comparisons and O(f) half-spaces, for the c cells on the
//! way, their g portals and the f faces of both; a box pays for the bodies near these cells too.

mod body;
mod carried;
mod describe;
mod path;
mod point;
mod space;

pub use space::Space;

use crate::geom::{AxialBox, RationalPoint3};
use crate::num::{Int, Rational};
use crate::scene::CellId;

/// A straight move.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Move {
    /// Where the point is at the time 0.
    pub from: RationalPoint3,
    /// Where it is at the time 1.
    pub to: RationalPoint3,
    /// The box that the point carries along: its corners as seen from the point. Without one the
    /// point moves alone.
    pub body: Option<AxialBox>,
}

/// How far a move gets.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Walk {
    /// The time of the first contact; 1 where the move is free.
    pub time: Rational,
    /// Where the point is then.
    pub point: RationalPoint3,
    /// What is hit, by obstacle; empty iff the move is free.
    pub hits: Vec<Hit>,
    /// The closed cells that the point is in on its way, or the middle of the box, by the time of
    /// entering, then by number. On a boundary it is in several.
    pub stays: Vec<Stay>,
}

/// A contact with one plane of one obstacle: what the mover is on, on the positive side.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Hit {
    /// What is hit.
    pub obstacle: Obstacle,
    /// The normal of the plane, out of the obstacle and against the move, without a common divisor.
    pub normal: [Int; 3],
    /// The value of normal · x on the plane, which supports the obstacle.
    pub offset: Rational,
    /// What touches what.
    pub touch: Touch,
}

/// Something that blocks a move. In order: solids, polygons, the end of the world.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Obstacle {
    /// A solid of the world, by index.
    Solid(usize),
    /// A polygon of the world, by index.
    Polygon(usize),
    /// The boundary of the box that the cells divide.
    Bounds,
}

/// What of a mover touches what of an obstacle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Touch {
    /// A face of the obstacle is touched.
    Face,
    /// A face of the moving box touches an edge or a vertex of the obstacle.
    BoxFace,
    /// An edge of the moving box touches an edge of the obstacle, crosswise.
    Edges,
}

/// A cell on the way.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Stay {
    /// The cell.
    pub cell: CellId,
    /// When it is entered.
    pub enter: Rational,
    /// When it is left for good, or the way ends.
    pub leave: Rational,
}

/// Why a move cannot begin.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum MoveError {
    /// The point, or the middle of the box, is in no closed cell.
    #[error("{}: it is in no cell{}", tuple(.point), match .solid {
        Some(_) => ", but in a solid",
        None => ", but out of reach or out of bounds",
    })]
    Nowhere {
        /// Where it is.
        point: Box<RationalPoint3>,
        /// The first solid that contains it, where one does.
        solid: Option<Obstacle>,
    },
    /// The box overlaps something at the start.
    #[error("the box overlaps something at the start")]
    Overlap {
        /// What it overlaps.
        obstacle: Obstacle,
    },
    /// The box has no inside.
    #[error("the box has no volume: its low corner must be below the high one on every axis")]
    NoVolume,
}

impl Space<'_> {
    /// The first contact of a move, and the cells on the way.
    ///
    /// ```
    /// # use stabline::geom::{BigPlane, RationalPoint3};
    /// # use stabline::motion::{Move, Space};
    /// # use stabline::num::{Int, Rational};
    /// # use stabline::portal::cells_of_world;
    /// # use stabline::scene::world::{Inside, Place, World, WorldSolid};
    /// # let half_space = |axis: usize, sign: i32, offset: i32| BigPlane {
    /// #     normal: std::array::from_fn(|i| Int::from(if i == axis { sign } else { 0 })),
    /// #     offset: Int::from(offset),
    /// # };
    /// # let sides = [(0, -1, -4), (0, 1, 8), (1, -1, 0), (1, 1, 8), (2, -1, 0), (2, 1, 8)];
    /// # let planes = sides.map(|(axis, sign, offset)| half_space(axis, sign, offset)).into();
    /// # let place = Place { name: "wall".into(), line: None };
    /// # let world = World {
    /// #     solids: vec![WorldSolid { planes, place }],
    /// #     polygons: vec![],
    /// #     hints: vec![],
    /// #     objects: vec![],
    /// #     inside: Inside::Everywhere,
    /// #     view: None,
    /// # };
    /// # let point = |x: i32| RationalPoint3::new([x, 2, 2].map(Int::from), Int::from(1));
    /// // A world with one solid, from x = 4 on.
    /// let cells = cells_of_world(&world, &Default::default())?;
    /// let space = Space::new(&world, &cells);
    /// let motion = Move { from: point(1), to: point(7), body: None };
    /// let walk = space.first_contact(&motion)?;
    /// assert_eq!(walk.time, Rational::new(1.into(), 2.into()));
    /// assert_eq!(walk.point, point(4));
    /// assert_eq!(walk.hits[0].normal, [-1, 0, 0].map(Int::from));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// The start is in no cell, or the box overlaps something there or has no volume.
    pub fn first_contact(&self, motion: &Move) -> Result<Walk, MoveError> {
        match &motion.body {
            None => self.walk_point(&motion.from, &motion.to),
            Some(body) if body.has_volume() => self.walk_box(motion, body),
            Some(_) => Err(MoveError::NoVolume),
        }
    }
}

/// A point as messages show it.
fn tuple(point: &RationalPoint3) -> String {
    let [x, y, z] = point.coordinates();
    format!("({x} {y} {z})")
}
