//! The suite: families of cases, each built so that its answer is known beforehand.
//!
//! A family states the answer by its construction where it can; the engine's answer, which comes
//! with the witness or the certificate, has to be the same, or the suite is not written.

mod book;
mod eyes;
mod family;
mod four_lines;
mod line_proof;
mod notes;
mod number;
mod pairs;
mod plane;
mod quadric;
mod scenes;
mod solids;
mod space;

use book::Book;
use family::Family;
use stabline::vectors::{Kind, VectorsFile};

/// Every file, in order.
pub const NAMES: [&str; 8] = [
    "eyes",
    "graphs_2d",
    "graphs_3d",
    "scenes_2d",
    "scenes_3d",
    "sequences_2d",
    "sequences_3d",
    "transversals",
];

/// The file of this name.
///
/// # Panics
/// If an answer is another than the construction says, and for another name.
pub fn file(name: &str) -> VectorsFile {
    let in_graph = |place: &str| format!("Do two cells of a portal graph {place} see each other?");
    let (plane, space) = (plane::families, space::families);
    match name {
        "eyes" => eyes::file(),
        "graphs_2d" => pairs::file(name, &in_graph("in the plane"), &plane()),
        "graphs_3d" => pairs::file(name, &in_graph("in space"), &space()),
        "scenes_2d" => scenes::in_plane(&plane()),
        "scenes_3d" => scenes::in_space(&space()),
        "sequences_2d" => {
            sequences(name, "Is there a line through segments, between their ends?", &plane())
        }
        "sequences_3d" => {
            sequences(name, "Is there a line through polygons, each from behind?", &space())
        }
        "transversals" => four_lines::file(),
        other => panic!("no file {other}"),
    }
}

fn sequences(name: &str, about: &str, families: &[Family]) -> VectorsFile {
    let mut book = Book::new(name, about);
    for family in families {
        book.group(Kind::Sequence, family.about);
        for case in &family.cases {
            book.sequence(case);
        }
    }
    book.finish()
}
