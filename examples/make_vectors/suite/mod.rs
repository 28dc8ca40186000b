//! The suite: families of cases, each built so that its answer is known beforehand.
//!
//! A family states the answer by its construction where it can; the engine's answer, which comes
//! with the witness or the certificate, has to be the same, or the suite is not written.

mod book;
mod eyes;
mod family;
mod four_lines;
mod notes;
mod number;
mod pairs;
mod plane;
mod scenes;
mod space;

use book::Book;
use family::Family;
use stabline::vectors::{Kind, VectorsFile};

/// Every file, in the order of their names.
pub fn files() -> Vec<VectorsFile> {
    let (plane, space) = (plane::families(), space::families());
    vec![
        eyes::file(),
        pairs::file(
            "graphs_2d",
            "Do two cells of a portal graph in the plane see each other?",
            &plane,
        ),
        pairs::file("graphs_3d", "Do two cells of a portal graph in space see each other?", &space),
        scenes::in_plane(&plane),
        scenes::in_space(&space),
        sequences(
            "sequences_2d",
            "Is there a line through segments of the plane, left to right?",
            &plane,
        ),
        sequences(
            "sequences_3d",
            "Is there a line through polygons of space, each from behind?",
            &space,
        ),
        four_lines::file(),
    ]
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
