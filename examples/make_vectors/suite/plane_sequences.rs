//! Sequences of segments in the plane. Lines run towards positive y; a gate is the segment from
//! its left end to its right end.

use super::book::Book;
use super::number::{Polygon, Q, moved, power, q, ratio, reversed, scaled, tenth};
use stabline::vectors::{
    Class::{self, Blocked, Grazing, Open},
    Kind, VectorsFile,
};

/// The gate at height y from x = a to x = b.
fn gate(y: &Q, a: Q, b: Q) -> Polygon {
    vec![vec![a, y.clone()], vec![b, y.clone()]]
}

/// Each critical sequence in three: with something left, exactly flush, with something lacking.
fn triple() -> [(i64, Class, &'static str); 3] {
    [
        (1, Open, "and leaves a way through"),
        (0, Grazing, "exactly: a line only touches"),
        (-1, Blocked, "and leaves no line at all"),
    ]
}

/// The file.
pub fn file() -> VectorsFile {
    let mut book = Book::new(
        "sequences_2d",
        "Is there a line through segments of the plane, in this order of directions?",
    );
    slits(&mut book);
    book.finish()
}

/// Three walls with slits; the middle one is moved by its width, more or less.
fn slits(book: &mut Book) {
    book.group(Kind::Sequence, "Slits in three walls, the middle one moved by about its width.");
    for k in 1..=20 {
        let width = tenth(k);
        for (more, class, how) in triple() {
            let move_by = &width * ratio(1000 - more, 1000);
            let [low, high] = [q(0), width.clone()];
            let portals = [
                gate(&q(0), low.clone(), high.clone()),
                gate(&q(10), move_by.clone(), &move_by + &width),
                gate(&q(20), low, high),
            ];
            let comment = format!(
                "Slits of 1e-{k} at y = 0, 10, 20. Halfway, lines between the outer ones have the \
                 same width; the middle slit is moved by that width {how}."
            );
            let mut flags = vec!["Slit"];
            flags.push(if class == Grazing { "Flush" } else { "OneUnit" });
            book.sequence(&comment, &flags, &portals, class);
            if k % 5 == 0 {
                let far = moved(&portals, &[power(40), -power(20)]);
                flags.push("FarFromOrigin");
                book.sequence(&format!("The same far away. {comment}"), &flags, &far, class);
                let metres = scaled(&reversed(&portals), &ratio(127, 5000));
                flags.pop();
                flags.push("UnitScale");
                let comment = format!("The same in metres, backwards. {comment}");
                book.sequence(&comment, &flags, &metres, class);
            }
        }
    }
}
