//! Neighbour finding: what lies across each piece of a leaf's boundary (Teller and Séquin 1991,
//! §2.2).

use super::{Boundary, PlanCells};

/// What lies across a piece of a leaf's boundary, wall or portal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Neighbour {
    /// The piece, by its index in [`PlanCells::boundaries`].
    pub boundary: u32,
    /// The leaf on the other side; none outside of the box.
    pub leaf: Option<u32>,
}

/// The neighbours of all leaves.
#[derive(Clone, Debug)]
pub struct Neighbours {
    starts: Vec<u32>,
    all: Vec<Neighbour>,
}

impl Neighbours {
    /// What lies around a leaf, line by line and in the direction of each line; a leaf across a
    /// wall is told as one across a portal is ([`PlanCells::is_opaque`] tells them apart). What
    /// touches in a point only is no neighbour.
    ///
    /// # Panics
    /// If there is no such leaf.
    pub fn of(&self, leaf: u32) -> &[Neighbour] {
        let [start, end] = [0, 1].map(|i| self.starts[leaf as usize + i] as usize);
        &self.all[start..end]
    }
}

impl PlanCells {
    /// The neighbours of all leaves: O(pieces) for all, and each answer is a slice.
    pub fn neighbours(&self) -> Neighbours {
        let mut starts = vec![0u32; self.tree.leaves.len() + 1];
        for Boundary { left, right, .. } in &self.boundaries {
            for leaf in [left, right].into_iter().flatten() {
                starts[*leaf as usize + 1] += 1;
            }
        }
        for leaf in 1..starts.len() {
            starts[leaf] += starts[leaf - 1];
        }
        let mut next = starts.clone();
        let nothing = Neighbour { boundary: 0, leaf: None };
        let mut all = vec![nothing; starts.last().map_or(0, |&end| end as usize)];
        for (number, Boundary { left, right, .. }) in self.boundaries.iter().enumerate() {
            for (own, other) in [(left, right), (right, left)] {
                if let Some(own) = own {
                    let at = &mut next[*own as usize];
                    all[*at as usize] = Neighbour { boundary: number as u32, leaf: *other };
                    *at += 1;
                }
            }
        }
        Neighbours { starts, all }
    }
}
