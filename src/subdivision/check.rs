//! The laws of a subdivision, checked on demand.
//!
//! None of them is taken from the tree's construction: volumes are summed, points are held against
//! the cells' and the solids' own planes.

use super::{LeafId, Occluders, Subdivision};
use crate::geom::RationalPoint3;
use crate::num::{Int, Rational, Sign};
use crate::predicates::{VertexPlane, side_of_point};

/// What was checked.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Checked {
    /// Leaves whose volumes were added up and whose kind was held against the solids.
    pub leaves: usize,
    /// Random points that lie inside one leaf.
    pub inside: usize,
    /// Random points that lie between leaves.
    pub between: usize,
}

/// A law that does not hold: an error of this program.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Violation {
    /// The leaves do not tile the box.
    #[error("the leaves' volumes add up to {leaves}, the box has {whole}")]
    Volume {
        /// The sum.
        leaves: Rational,
        /// The volume of the box.
        whole: Rational,
    },
    /// A leaf that is solid or empty against the solids.
    #[error("{leaf:?} is {}, but its point {point:?} is not", if *solid { "solid" } else { "empty" })]
    Kind {
        /// The leaf.
        leaf: LeafId,
        /// What it says that it is.
        solid: bool,
        /// A point inside it.
        point: RationalPoint3,
    },
    /// A point that is not where the tree says.
    #[error("the point {point:?} is located in {found:?}, and strictly inside of {strictly:?}")]
    Point {
        /// The point.
        point: RationalPoint3,
        /// The leaves that the tree names.
        found: Vec<LeafId>,
        /// Those whose planes all have it strictly inside.
        strictly: Vec<LeafId>,
    },
}

impl Subdivision {
    /// Checks that the leaves' volumes add up to that of the box, that each leaf's kind agrees
    /// with the solids, and that each of `samples` pseudo-random points of the box is strictly
    /// inside the one leaf that [`Subdivision::locate`] finds, or in the boundary of all that it
    /// finds. In a `filled` subdivision a leaf may be solid without a solid.
    ///
    /// Cost: exact volumes of all leaves; for each leaf all solids; for each point all leaves.
    ///
    /// # Errors
    /// The first law that does not hold.
    pub fn check(
        &self,
        occluders: &Occluders,
        filled: bool,
        samples: usize,
        seed: u64,
    ) -> Result<Checked, Box<Violation>> {
        let leaves: Rational = self.leaves.iter().map(|leaf| leaf.cell.volume()).sum();
        let whole = self.bounds.polyhedron(&self.planes).volume();
        if leaves != whole {
            return Err(Box::new(Violation::Volume { leaves, whole }));
        }
        let solids: Vec<Vec<VertexPlane>> = (occluders.solids.iter().enumerate())
            .filter(|(index, _)| !self.flat.contains(index))
            .map(|(_, solid)| solid.iter().cloned().map(VertexPlane::new).collect())
            .collect();
        for leaf in self.leaf_ids() {
            let solid = self.leaf(leaf).solid;
            let point = self.leaf(leaf).cell.inner_point();
            let covered = solids.iter().any(|planes| {
                // A point of an open leaf is in a solid's boundary only where solids touch.
                planes.iter().all(|plane| side_of_point(plane, &point) != Sign::Positive)
            });
            if covered && !solid || solid && !covered && !filled {
                return Err(Box::new(Violation::Kind { leaf, solid, point }));
            }
        }
        let mut checked = Checked { leaves: self.leaves.len(), ..Checked::default() };
        let mut random = Random(seed | 1);
        for _ in 0..samples {
            let point = self.random_point(&mut random);
            match self.check_point(point)? {
                true => checked.inside += 1,
                false => checked.between += 1,
            }
        }
        Ok(checked)
    }

    /// Whether a point of the box is inside one leaf; otherwise it is between leaves.
    fn check_point(&self, point: RationalPoint3) -> Result<bool, Box<Violation>> {
        let found = self.locate(&point);
        let place = |leaf: LeafId| {
            let faces = self.leaf(leaf).cell.faces().iter();
            let sides = faces.map(|f| side_of_point(self.planes.get(f.support()), &point));
            sides.max().expect("a cell has faces")
        };
        let (mut strictly, mut touched) = (Vec::new(), Vec::new());
        for leaf in self.leaf_ids() {
            match place(leaf) {
                Sign::Negative => strictly.push(leaf),
                // In the leaf's boundary.
                Sign::Zero => touched.push(leaf),
                Sign::Positive => {}
            }
        }
        let inside = strictly.len() == 1 && touched.is_empty() && found == strictly;
        let between = strictly.is_empty() && !touched.is_empty() && found == touched;
        if inside || between {
            return Ok(inside);
        }
        Err(Box::new(Violation::Point { point, found, strictly }))
    }

    /// A point of the box: each coordinate a random share of its extent; few of the denominators
    /// are large, so that points between leaves occur.
    fn random_point(&self, random: &mut Random) -> RationalPoint3 {
        let corners = self.bounds.corners(&self.planes);
        let denominator = [4, 64, 1024, 1_000_003][random.below(4) as usize];
        let coordinates = std::array::from_fn(|i| {
            let share =
                Rational::new(Int::from(random.below(denominator + 1)), Int::from(denominator));
            &corners.low[i] + share * (&corners.high[i] - &corners.low[i])
        });
        RationalPoint3::from(&coordinates)
    }
}

/// Pseudo-random numbers (Marsaglia, Xorshift RNGs, 2003).
struct Random(u64);

impl Random {
    fn below(&mut self, end: u64) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 16) % end
    }
}
