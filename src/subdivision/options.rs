//! How to divide space: the parameters of the rounds.

use crate::num::{Int, Rational};

/// How to divide space.
///
/// A cell with faces in it is split by the plane of one of them, in two rounds (Teller 1992,
/// sections 5.2.1 and 8.2.1): *obscuration*, while some plane's faces cover enough of the cell's
/// section, then *cleaving*, a score of integer [`Weights`]. Empty cells without faces are split
/// further by the rounds of *volume* and *aspect*, where these are asked for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Options {
    /// How far the box reaches past the occluders, in world units, at least 1; a stated view is
    /// taken as it is.
    pub margin: Int,
    /// Obscuration: the least share of a cell's section that a plane's faces cover where they
    /// split first, most covered first; 1 is all of it. `None` leaves the round out.
    pub obscuration: Option<Rational>,
    /// Cleaving: the plane of the highest score splits.
    pub weights: Weights,
    /// The most candidates to weigh in one cell, at least 1; where there are more, they are taken
    /// at equal steps.
    pub samples: usize,
    /// Volume: empty cells larger than this share of the box are split. `None` leaves the round
    /// out.
    pub largest_volume: Option<Rational>,
    /// Aspect: empty cells are split whose longest extent along an axis is more than this many
    /// times their shortest. `None` leaves the round out.
    pub largest_aspect: Option<Rational>,
    /// What becomes a portal of what two leaves share.
    pub portals: PortalShape,
}

/// The terms of a plane's score.
///
/// A large charge for cuts and a small one for imbalance is minimum cleaving with a bias to the
/// median; the charge for imbalance is what a smaller tree is traded for a balanced one (Carr
/// 2004, section on compiling BSP trees).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Weights {
    /// Reward for each face in the plane.
    pub coplanar: i64,
    /// Charge for each face that is cut.
    pub cut: i64,
    /// Charge for each face that one side has more than the other.
    pub imbalance: i64,
    /// Reward for an axial plane.
    pub axial: i64,
}

/// What becomes a portal of what two leaves share, where polygons lie between them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum PortalShape {
    /// The convex pieces that are left of it as they come.
    Exact,
    /// The pieces, joined where the union of two is convex.
    #[default]
    Merged,
    /// One portal, the convex hull of all that is left: conservative, as it may run across
    /// occluders, so that more is seen than there is.
    Hull,
}

impl Default for Options {
    fn default() -> Options {
        Options {
            margin: Int::from(64),
            obscuration: None,
            weights: Weights::default(),
            samples: 64,
            largest_volume: None,
            largest_aspect: None,
            portals: PortalShape::default(),
        }
    }
}

/// The best of some dozen settings on six real levels: fewest cells and portals in sum, and on
/// each of them fewer than with equal weights.
impl Default for Weights {
    fn default() -> Weights {
        Weights { coplanar: 10, cut: 20, imbalance: 1, axial: 5 }
    }
}
