//! Compiled levels (`.bsp`): their potentially visible sets, read and written.
//!
//! Only the lumps that visibility needs are looked at; the rest is carried along as bytes. Rows
//! and columns of the matrix are the leafs (in Quake 2 and 3 the clusters) in the order of the
//! level's portal file, so Quake's leaf i+1 is row i.
//!
//! ```text
//! Quake 29, GoldSrc 30, BSP2, 2PSB   lump 4: a row for each leaf at its visofs, run-length coded
//! Quake 2 (IBSP 38)                  lump 3: the number of clusters, for each the offsets of its
//!                                    visible and its audible row, run-length coded
//! Quake 3 (IBSP 46)                  lump 16: the number of clusters, bytes a row, plain rows
//! ```
//!
//! Run-length code: a zero byte is followed by the number of zero bytes that it stands for. Bit i
//! of a row, counted from the lowest bit of its first byte, is row or cluster i. Time and memory
//! are linear in the file plus the square of the number of leafs.

mod layout;
mod read;
#[cfg(test)]
mod tests;
mod tree;
mod write;

pub use layout::BspFormat;
pub use tree::{LevelChild, LevelNode, LevelTree};
pub use write::write_visibility;

/// A square matrix of bits.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BitMatrix {
    size: usize,
    row_bytes: usize,
    /// Invariant: `size` rows of `row_bytes` bytes, the bits past `size` zero.
    bits: Vec<u8>,
}

impl BitMatrix {
    /// A matrix of `size` rows, all bits zero.
    pub fn new(size: usize) -> BitMatrix {
        let row_bytes = size.div_ceil(8);
        BitMatrix { size, row_bytes, bits: vec![0; size * row_bytes] }
    }

    /// The number of rows and of columns.
    pub fn size(&self) -> usize {
        self.size
    }

    /// The bytes of a row.
    ///
    /// # Panics
    /// If there is no such row.
    pub fn row(&self, row: usize) -> &[u8] {
        &self.bits[row * self.row_bytes..][..self.row_bytes]
    }

    /// Whether a bit is set.
    ///
    /// # Panics
    /// If there is no such bit.
    pub fn get(&self, row: usize, column: usize) -> bool {
        assert!(column < self.size, "column {column} of {}", self.size);
        self.row(row)[column / 8] >> (column % 8) & 1 == 1
    }

    /// Sets a bit.
    ///
    /// # Panics
    /// If there is no such bit.
    pub fn set(&mut self, row: usize, column: usize) {
        assert!(column < self.size, "column {column} of {}", self.size);
        self.bits[row * self.row_bytes + column / 8] |= 1 << (column % 8);
    }

    /// Overwrites a row, its bits past the last column left out.
    fn set_row(&mut self, row: usize, bytes: &[u8]) {
        let used = if self.size.is_multiple_of(8) { 0xff } else { (1u8 << (self.size % 8)) - 1 };
        let target = &mut self.bits[row * self.row_bytes..][..self.row_bytes];
        target.copy_from_slice(bytes);
        if let Some(last) = target.last_mut() {
            *last &= used;
        }
    }
}

/// What a level says about visibility.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Visibility {
    /// The format of the level.
    pub format: BspFormat,
    /// Which leafs (clusters) each leaf (cluster) may see.
    pub matrix: BitMatrix,
    /// Leafs without a row of their own: a game lets them see everything, and so does `matrix`.
    pub rows_missing: usize,
}

/// What is wrong with a level file, and where.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("byte {offset}: {kind}")]
pub struct BspError {
    /// The byte offset, counted from 0.
    pub offset: usize,
    /// The rule broken.
    pub kind: BspErrorKind,
}

/// The rules of a level file.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum BspErrorKind {
    /// Not a format that is known.
    #[error("not a level of a known format (Quake 29, GoldSrc 30, BSP2, 2PSB, IBSP 38 or 46)")]
    UnknownFormat,
    /// The file ends inside its list of lumps.
    #[error("the file ends inside its list of lumps")]
    HeaderEnds,
    /// A lump that reaches past the end of the file, or has a negative place.
    #[error("lump {lump} ({what}) lies at {offset} with {length} bytes, the file has {file}")]
    LumpOutside {
        /// The lump's number.
        lump: usize,
        /// What it holds.
        what: &'static str,
        /// Its offset, as stated.
        offset: i32,
        /// Its length, as stated.
        length: i32,
        /// The size of the file.
        file: usize,
    },
    /// A lump whose length is no whole number of records, or too short for what it must hold.
    #[error("the lump of {what} has {got} bytes, expected {expected}")]
    LumpLength {
        /// What the lump holds.
        what: &'static str,
        /// Its length.
        got: usize,
        /// What is due.
        expected: String,
    },
    /// A count that is negative or beyond what is read.
    #[error("{got} leafs or clusters with visibility, expected 1 to {limit}")]
    Count {
        /// The count stated.
        got: i64,
        /// The largest that the file has room for.
        limit: usize,
    },
    /// The level has no visibility data.
    #[error("the level has no visibility data")]
    NoVisibility,
    /// A row that begins outside its lump.
    #[error(
        "the row of leaf or cluster {leaf} begins at {start}, the visibility data has {length}"
    )]
    RowOutside {
        /// The row.
        leaf: usize,
        /// Its offset in the lump.
        start: i64,
        /// The length of the lump.
        length: usize,
    },
    /// A row that runs over its end, or out of the lump.
    #[error("the row of leaf or cluster {leaf} does not end after {expected} bytes")]
    RowLength {
        /// The row.
        leaf: usize,
        /// The number of bytes due.
        expected: usize,
    },
    /// The matrix to be written belongs to another level.
    #[error("the level has {expected} leafs with visibility, the result has {got}")]
    OtherLevel {
        /// The level's number of rows.
        expected: usize,
        /// The matrix's.
        got: usize,
    },
    /// The visibility data shares bytes with another lump and cannot be replaced.
    #[error("the visibility data overlaps lump {0}")]
    Overlap(usize),
    /// What was written would not be what a game reads.
    #[error("the level's lumps overlap, so that visibility written into it would not read back")]
    NotReadBack,
    /// A format whose tree is not read.
    #[error("the tree of a level of {0} is not read, expected one of Quake or GoldSrc")]
    NoTree(BspFormat),
    /// A plane with a coefficient that is infinite or no number.
    #[error("a plane with a coefficient that is not finite")]
    NotFinite,
    /// A node with a plane that does not exist.
    #[error("node {node} has plane {plane}, which does not exist")]
    NodePlane {
        /// The node.
        node: usize,
        /// The number of its plane.
        plane: i32,
    },
    /// A child that does not exist, or a node before its parent.
    #[error(
        "a child {child}, expected a leaf (-1 - its number) or a node from {first} below {nodes}"
    )]
    NodeChild {
        /// The child, as stated.
        child: i32,
        /// The least node that it may be.
        first: usize,
        /// The number of nodes.
        nodes: usize,
    },
    /// The level would outgrow its 31-bit offsets.
    #[error("the level would have {0} bytes, more than its format can address")]
    TooLarge(usize),
}
