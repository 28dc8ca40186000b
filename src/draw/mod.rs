//! Pictures of floorplans and of what is seen in them, as SVG (after the figures of Teller and
//! Séquin 1991).
//!
//! Pictures are for people: coordinates are moved and scaled exactly and then rounded, to a
//! hundredth of a picture's unit, and nothing is read back from them. The same input gives the same
//! bytes on every machine: only sums, products, quotients and square roots of floats are used.
//!
//! [`Floor`] holds what every picture is drawn upon, [`Sheet`] is the paper with a title and a
//! legend; each picture is one function from the two, and of what it shows, to the text of a file.

mod cells;
mod eye;
mod floor;
mod frame;
mod matrix;
mod palette;
mod sectors;
mod sequence;
mod sheet;
mod splits;
mod svg;
mod tree;
mod tree_graph;
mod visibility;

pub use cells::draw_cells;
pub use eye::{EyeDrawing, draw_eye};
pub use floor::{Floor, Sizes};
pub use frame::{Frame, Ray};
pub use matrix::draw_matrix;
pub use sectors::{Shade, draw_level};
pub use sequence::{SequenceLine, draw_sequence};
pub use sheet::{DEFAULT_WIDTH, LEAST_WIDTH, Pen, Sample, Sheet, SheetOptions, Tip};
pub use splits::draw_splits;
pub use svg::{Place, Svg};
pub use tree::{TreeNode, draw_stab_tree};
pub use tree_graph::draw_tree_graph;
pub use visibility::{Sightline, draw_visibility};
