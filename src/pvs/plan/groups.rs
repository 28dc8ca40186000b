//! What pairs are asked about: cells, or sets of them.

use crate::scene::CellId;

/// Sets of cells, numbered: each cell is in one or in none.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Groups {
    /// How many there are.
    count: u32,
    /// Of each cell; `count` for none.
    of_cell: Vec<u32>,
    /// Whether each cell is a group of its own.
    pub(super) are_cells: bool,
}

impl Groups {
    /// Each cell by itself.
    pub fn cells(count: usize) -> Groups {
        Groups { count: count as u32, of_cell: (0..count as u32).collect(), are_cells: true }
    }

    /// `count` groups, and the one of each cell.
    ///
    /// # Panics
    /// If a cell names a group beyond them.
    pub fn new(count: usize, of_cell: Vec<Option<u32>>) -> Groups {
        let count = count as u32;
        let of_cell = of_cell.into_iter().map(|group| group.unwrap_or(count)).collect::<Vec<_>>();
        assert!(of_cell.iter().all(|&group| group <= count), "a group beyond the last");
        Groups { count, of_cell, are_cells: false }
    }

    /// How many there are.
    pub fn count(&self) -> usize {
        self.count as usize
    }

    /// The group of a cell.
    #[inline]
    pub fn of(&self, cell: CellId) -> Option<u32> {
        Some(self.of_cell[cell.0 as usize]).filter(|&group| group < self.count)
    }
}
