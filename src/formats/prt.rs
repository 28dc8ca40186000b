//! Portal files (`.prt`): the cells of a level and the convex polygons between them.
//!
//! Five dialects are read; what they share is one line a portal,
//! `npts cellA cellB (x y z ) (x y z ) …`, whose vertices turn so that (w1-w0) x (w2-w1) points
//! from `cellA` into `cellB`.
//!
//! ```text
//! PRT1        magic, leafs, portals
//! PRT2        magic, leafs, clusters, portals; after the portals a line a cluster: its leafs, -1
//! PRT1-AM     magic, clusters, portals, leafs; after the portals a line a leaf: its cluster
//! PRT1 (Q3)   magic, clusters, portals, solid faces; a flag number after a portal's cells;
//!             after the portals a line a solid face: npts leaf (x y z ) …
//! no magic    leafs, portals, and perhaps a line a leaf with the number of its own sub-leafs
//! ```
//!
//! Coordinates are decimals and are kept exactly. Linear in the size of the file; a lying count
//! costs nothing, since nothing is reserved beyond what the bytes can hold.

mod reader;
#[cfg(test)]
mod tests;
mod writer;

use crate::num::{DecimalError, Number};

pub use reader::read;
pub use writer::{PrtWriteError, write};

/// Which of the dialects a file is written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dialect {
    /// `PRT1` with leafs and portals.
    Prt1,
    /// `PRT2`: portals between clusters, leafs listed by cluster.
    Prt2,
    /// `PRT1-AM`: portals between clusters, one cluster number a leaf.
    Prt1Am,
    /// `PRT1` with a third number, flags a portal, and solid faces.
    Quake3,
    /// No magic: the first line is the number of leafs.
    Headless,
}

/// One portal as the file states it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PrtPortal {
    /// The line of the file, counted from 1.
    pub line: usize,
    /// The cells on its two sides, the normal pointing from the first into the second.
    pub cells: [u32; 2],
    /// The vertices in the file's order.
    pub vertices: Vec<[Number; 3]>,
}

/// A portal file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PrtFile {
    /// The dialect it is written in.
    pub dialect: Dialect,
    /// How many cells the portals join: clusters where the dialect has them, else leafs.
    pub cells: u32,
    /// The portals, in the file's order.
    pub portals: Vec<PrtPortal>,
    /// The cell of each leaf; the identity where the dialect has no clusters.
    pub leaf_to_cell: Vec<u32>,
}

/// What is wrong with a portal file, and where.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("line {line}: {kind}")]
pub struct PrtError {
    /// The line, counted from 1; one past the last line where the file ends too soon.
    pub line: usize,
    /// The rule broken.
    pub kind: PrtErrorKind,
}

/// The rules of a portal file.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum PrtErrorKind {
    /// The file has no line that is not blank.
    #[error("the file is empty, expected PRT1, PRT2, PRT1-AM or a number of leafs")]
    Empty,
    /// A byte that is not ASCII.
    #[error("not a text of ASCII characters")]
    NotText,
    /// The first line is neither a known magic nor a number.
    #[error("expected PRT1, PRT2, PRT1-AM or a number of leafs, got `{0}`")]
    Magic(String),
    /// The file ends where something is due.
    #[error("the file ends, expected {0}")]
    Ends(&'static str),
    /// A whole number is due.
    #[error("expected {what}, got `{got}`")]
    NotACount {
        /// What the number is.
        what: &'static str,
        /// What stands there.
        got: String,
    },
    /// A header line with more than its number.
    #[error("expected a line with {0} alone")]
    LoneNumber(&'static str),
    /// More cells or leafs than any level has.
    #[error("{what} is {got}, at most {limit} can be read")]
    TooMany {
        /// What is counted.
        what: &'static str,
        /// The count.
        got: u64,
        /// The limit.
        limit: u32,
    },
    /// A portal names a cell that the header does not have.
    #[error("portal names cell {got}, but there are {cells} cells, counted from 0")]
    MissingCell {
        /// The cell named.
        got: u64,
        /// The number of cells.
        cells: u32,
    },
    /// A portal with fewer than three vertices.
    #[error("portal with {0} vertices, expected three or more")]
    TooFewVertices(u64),
    /// The number of vertices on the line differs from the one it states.
    #[error("expected {expected} vertices `(x y z )`, got {got}")]
    VertexCount {
        /// The number stated.
        expected: u64,
        /// The number found.
        got: usize,
    },
    /// A vertex that is not `(x y z )`.
    #[error("expected `{expected}` in vertex {vertex}, got `{got}`")]
    Vertex {
        /// The vertex, counted from 0.
        vertex: usize,
        /// What is due.
        expected: &'static str,
        /// What stands there.
        got: String,
    },
    /// A coordinate that is not a number.
    #[error("vertex {vertex}: coordinate `{got}`: {source}")]
    Coordinate {
        /// The vertex, counted from 0.
        vertex: usize,
        /// What stands there.
        got: String,
        /// What is wrong with it.
        source: DecimalError,
    },
    /// A cluster line names a leaf that the header does not have.
    #[error("cluster names leaf {got}, but there are {leafs} leafs, counted from 0")]
    MissingLeaf {
        /// The leaf named.
        got: u64,
        /// The number of leafs.
        leafs: u32,
    },
    /// A leaf in two clusters.
    #[error("leaf {leaf} is listed by cluster {first} and by cluster {second}")]
    LeafTwice {
        /// The leaf.
        leaf: u32,
        /// The cluster that listed it first.
        first: u32,
        /// The cluster of this line.
        second: u32,
    },
    /// A leaf in no cluster.
    #[error("leaf {0} is in no cluster")]
    LeafWithoutCluster(u32),
    /// A cluster line that does not end with -1, or goes on after it.
    #[error("expected the cluster's leafs to end with -1 at the end of the line")]
    ClusterEnd,
    /// Text after the last line that the header announces.
    #[error("expected the end of the file after {after}, got `{got}`")]
    Trailing {
        /// What ends the file.
        after: &'static str,
        /// The text.
        got: String,
    },
}
