//! Which cell is the source of which pairs.

use super::arena::Arena;
use super::bits::Bits;
use rayon::prelude::*;

/// A source cell and the cells whose visibility from it its row has to settle.
pub(crate) struct Source {
    pub cell: u32,
    pub wanted: Bits,
}

impl Source {
    /// How many pairs it has to settle.
    pub fn work(&self) -> u64 {
        u64::from(self.wanted.count())
    }
}

/// All cells as sources, in the order of work: those that want fewer cells first. `wanted` must be
/// symmetric; each of its pairs goes to the cell that comes first.
pub(crate) fn share_out(arena: &Arena, wanted: impl Fn(u32) -> Bits + Sync) -> Vec<Source> {
    let source = |cell| Source { cell, wanted: wanted(cell) };
    let mut sources: Vec<Source> = (0..arena.cells()).into_par_iter().map(source).collect();
    sources.sort_by_cached_key(|source| (source.work(), source.cell));
    let mut earlier = arena.no_cells();
    for source in &mut sources {
        source.wanted.subtract(&earlier);
        earlier.insert(source.cell);
    }
    sources
}
