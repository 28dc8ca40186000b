//! Level sources (`.map`): entities, each a list of key and value pairs and of brushes.
//!
//! A brush is the intersection of half-spaces. Each of its faces gives one by three points, which
//! run clockwise as seen from outside the brush, followed by a texture and how it is laid on:
//!
//! ```text
//! { "classname" "worldspawn"
//!   { ( x y z ) ( x y z ) ( x y z ) TEXTURE shift shift rotation scale scale [flags…]
//!     ( x y z ) ( x y z ) ( x y z ) TEXTURE [ x y z w ] [ x y z w ] rotation scale scale … } }
//! ```
//!
//! The first form is the standard one, the second Valve's 220; they may be mixed. `//` starts a
//! comment. Coordinates are decimals and kept exactly; how a texture is laid on is read over,
//! since nothing that is seen through depends on it. Linear in the size of the file.

mod reader;

use crate::num::{DecimalError, Number};

pub use reader::read;

/// The most faces that one brush may have: no editor makes brushes of more than some hundreds.
pub const MAX_FACES: usize = 1024;

/// A level's source.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MapFile {
    /// The entities, in the file's order; one at least.
    pub entities: Vec<MapEntity>,
}

/// An entity.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MapEntity {
    /// The line of its opening brace, counted from 1.
    pub line: usize,
    /// Its keys and values, in the file's order; bytes that are not UTF-8 are replaced.
    pub pairs: Vec<(String, String)>,
    /// Its brushes, in the file's order.
    pub brushes: Vec<MapBrush>,
    /// Its curved surfaces, which are read over: the name of each and the line of its brace.
    pub patches: Vec<(String, usize)>,
}

/// A brush as the file states it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MapBrush {
    /// The line of its opening brace, counted from 1.
    pub line: usize,
    /// Its faces, in the file's order; at most [`MAX_FACES`], perhaps none.
    pub faces: Vec<MapFace>,
}

/// A face of a brush as the file states it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MapFace {
    /// The line of its first point, counted from 1.
    pub line: usize,
    /// Three points of its plane, clockwise as seen from outside the brush.
    pub points: [[Number; 3]; 3],
    /// The texture's name.
    pub texture: String,
    /// The flags of Quake 2 and 3, where the face ends with three numbers.
    pub flags: Option<MapFlags>,
}

/// What Quake 2 and 3 say of a face besides its texture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MapFlags {
    /// What the brush is filled with.
    pub contents: u32,
    /// What its surface is.
    pub surface: u32,
}

impl MapEntity {
    /// The value of the first pair with this key.
    pub fn value(&self, key: &str) -> Option<&str> {
        self.pairs.iter().find(|(k, _)| k == key).map(|(_, value)| value.as_str())
    }
}

/// What is wrong with a level's source, and where.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("line {line}: {kind}")]
pub struct MapError {
    /// The line, counted from 1; the last one where the file ends too soon.
    pub line: usize,
    /// The rule broken.
    pub kind: MapErrorKind,
}

/// The rules of a level's source.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum MapErrorKind {
    /// The file holds nothing but blanks and comments.
    #[error("no entity, expected `{{`")]
    Empty,
    /// Something else is due.
    #[error("expected {expected}, got `{got}`")]
    Expected {
        /// What is due.
        expected: &'static str,
        /// What stands there.
        got: String,
    },
    /// The file ends inside braces.
    #[error("the file ends in the {what} that line {opened} opens, expected {expected}")]
    Ends {
        /// What is not closed.
        what: &'static str,
        /// The line of its opening brace.
        opened: usize,
        /// What is due.
        expected: &'static str,
    },
    /// A key or value without its second quotation mark on the same line.
    #[error("a text in quotation marks does not end on its line, expected `\"`")]
    UnterminatedString,
    /// A coordinate that is not a number.
    #[error("point {point} of a face: coordinate `{got}`: {source}")]
    Coordinate {
        /// Which of the three points, counted from 1.
        point: usize,
        /// What stands there.
        got: String,
        /// What is wrong with it.
        source: DecimalError,
    },
    /// A brush in a form that is not read.
    #[error("`{0}` is not read, expected a brush in the standard or the Valve 220 form")]
    Primitive(String),
    /// More faces than any editor makes.
    #[error("a brush of more than {limit} faces", limit = MAX_FACES)]
    TooManyFaces,
}
