//! Wavefront `.obj`: vertices and faces, coordinates exactly as written.
//!
//! The readers at hand round decimals to floats, so that a wall at 0.1 would stand elsewhere than
//! one at 1/10 of another file. This one reads `v`, `f`, `o` and `g` (`docs/formats/obj.md`) and
//! nothing else. Linear in the size of the file.

use crate::num::{DecimalError, Number};
use std::borrow::Cow;

/// What a `.obj` states.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ObjFile {
    /// The vertices, in the file's order.
    pub vertices: Vec<[Number; 3]>,
    /// The faces, in the file's order.
    pub faces: Vec<ObjFace>,
}

/// A face.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ObjFace {
    /// Indices into [`ObjFile::vertices`], three or more.
    pub corners: Vec<u32>,
    /// What `o` or `g` named last, empty where neither did.
    pub name: String,
    /// Its line in the file, counted from 1.
    pub line: usize,
}

/// Why a text is not a `.obj`, and where.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("line {line}: {kind}")]
pub struct ObjError {
    /// The line, counted from 1.
    pub line: usize,
    /// The rule broken.
    pub kind: ObjErrorKind,
}

/// The rules of `.obj` files.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ObjErrorKind {
    /// A byte 0: not a text.
    #[error("a zero byte, expected a text")]
    NotText,
    /// Fewer than three numbers.
    #[error("a vertex of {0} numbers, expected three or more")]
    ShortVertex(usize),
    /// Something that is no number.
    #[error("coordinate `{text}`: {error}")]
    Coordinate {
        /// The start of it.
        text: String,
        /// Why it is none.
        error: DecimalError,
    },
    /// Fewer than three corners.
    #[error("a face of {0} corners, expected three or more")]
    ShortFace(usize),
    /// Something that is no corner.
    #[error("corner `{0}`: expected an index, or indices between slashes")]
    Corner(String),
    /// An index that names no vertex.
    #[error("corner {got}: there are {vertices} vertices, counted from 1")]
    MissingVertex {
        /// The index.
        got: i64,
        /// The number of vertices it may count.
        vertices: usize,
    },
}

/// Reads a `.obj`.
///
/// # Errors
/// [`ObjError`] names the line and the rule broken.
pub fn read(bytes: &[u8]) -> Result<ObjFile, ObjError> {
    let mut file = ObjFile::default();
    let mut name = String::new();
    for (line, text) in statements(bytes) {
        let error = |kind| ObjError { line, kind };
        if text.contains(&0) {
            return Err(error(ObjErrorKind::NotText));
        }
        let text = String::from_utf8_lossy(&text);
        let mut words = text.split_ascii_whitespace();
        match words.next() {
            Some("v") => file.vertices.push(vertex(words).map_err(error)?),
            Some("f") => {
                let corners = corners(words, file.vertices.len()).map_err(error)?;
                file.faces.push(ObjFace { corners, name: name.clone(), line });
            }
            Some("o" | "g") => name = words.collect::<Vec<_>>().join(" "),
            Some(_) | None => {}
        }
    }
    // Indices may name vertices further down.
    let vertices = file.vertices.len();
    for face in &file.faces {
        if let Some(&past) = face.corners.iter().find(|&&corner| corner as usize >= vertices) {
            let kind = ObjErrorKind::MissingVertex { got: i64::from(past) + 1, vertices };
            return Err(ObjError { line: face.line, kind });
        }
    }
    Ok(file)
}

/// The lines without comments, those that end in `\` joined with the next, each with the number of
/// its first.
fn statements(bytes: &[u8]) -> impl Iterator<Item = (usize, Cow<'_, [u8]>)> {
    let mut lines = bytes.split(|&byte| byte == b'\n').zip(1..);
    std::iter::from_fn(move || {
        let (text, line) = lines.next()?;
        let mut statement = Cow::Borrowed(uncommented(text));
        while let Some(before) = statement.strip_suffix(b"\\") {
            let mut joined = before.to_vec();
            joined.push(b' ');
            if let Some((next, _)) = lines.next() {
                joined.extend_from_slice(uncommented(next));
            }
            statement = Cow::Owned(joined);
        }
        Some((line, statement))
    })
}

fn uncommented(line: &[u8]) -> &[u8] {
    line.split(|&byte| byte == b'#').next().unwrap_or_default().trim_ascii_end()
}

fn excerpt(text: &str) -> String {
    text.escape_debug().take(32).collect()
}

fn vertex<'t>(words: impl Iterator<Item = &'t str>) -> Result<[Number; 3], ObjErrorKind> {
    // A weight or a colour may follow.
    let read = |text: &str| {
        Number::parse(text).map_err(|error| ObjErrorKind::Coordinate { text: excerpt(text), error })
    };
    let numbers = words.take(3).map(read).collect::<Result<Vec<_>, _>>()?;
    numbers.try_into().map_err(|short: Vec<_>| ObjErrorKind::ShortVertex(short.len()))
}

/// The corners of a face, counted from 0; those counted from the end of the vertices so far are
/// checked, others not.
fn corners<'t>(
    words: impl Iterator<Item = &'t str>,
    vertices: usize,
) -> Result<Vec<u32>, ObjErrorKind> {
    let corner = |text: &str| {
        let mut parts = text.split('/');
        let index = parts.next().and_then(|part| part.parse::<i64>().ok());
        let others = parts.all(|part| part.is_empty() || part.parse::<i64>().is_ok());
        let malformed = || ObjErrorKind::Corner(excerpt(text));
        let got = index.filter(|_| others).ok_or_else(malformed)?;
        let place = match got {
            1.. => got - 1,
            _ => got + vertices as i64,
        };
        let missing = ObjErrorKind::MissingVertex { got, vertices };
        if got == 0 { Err(missing) } else { u32::try_from(place).map_err(|_| missing) }
    };
    let corners = words.map(corner).collect::<Result<Vec<_>, _>>()?;
    if corners.len() < 3 { Err(ObjErrorKind::ShortFace(corners.len())) } else { Ok(corners) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn message(text: &str) -> String {
        read(text.as_bytes()).unwrap_err().to_string()
    }

    #[test]
    fn every_form_of_face_is_read() {
        let text = "# a comment\no left wall\nv 0 0 0 1\nv 0.1 1e-3 -2 # near\nv 1/3 0 0\r\n\
                    f 1 2 3\nvt 0 0\nvn 0 0 1\ng a \\\n b\nf -3/1 -2//1 -1/1/1\nf 4 \\\n 1 2\n\
                    usemtl x\nl 1 2\nv 5 5 5";
        let file = read(text.as_bytes()).unwrap();
        let number = |text| Number::parse(text).unwrap();
        assert_eq!(file.vertices[1], ["0.1", "1e-3", "-2"].map(number));
        assert_eq!((file.vertices.len(), &file.vertices[2][0]), (4, &Number::Small(1, 3)));
        let faces: Vec<_> =
            file.faces.iter().map(|f| (f.corners.as_slice(), f.name.as_str(), f.line)).collect();
        assert_eq!(
            faces,
            [
                (&[0, 1, 2][..], "left wall", 6),
                (&[0, 1, 2][..], "a b", 11),
                (&[3, 0, 1][..], "a b", 12)
            ]
        );
    }

    #[test]
    fn errors_name_the_line_and_the_rule() {
        let vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
        for (text, expected) in [
            ("v 1 2", "line 1: a vertex of 2 numbers, expected three or more"),
            ("\n\nv 1 nan 2", "line 3: coordinate `nan`: not a decimal number or a ratio"),
            ("v 1e9999 0 0", "line 1: coordinate `1e9999`: the exponent is larger than 4096"),
            ("v 0 0 0\0", "line 1: a zero byte"),
        ] {
            assert!(message(text).starts_with(expected), "{}", message(text));
        }
        for (face, expected) in [
            ("f 1 2", "line 4: a face of 2 corners, expected three or more"),
            ("f 1 2 4", "line 4: corner 4: there are 3 vertices, counted from 1"),
            ("f 1 2 0", "line 4: corner 0: there are 3 vertices, counted from 1"),
            ("f 1 2 -4", "line 4: corner -4: there are 3 vertices, counted from 1"),
            ("f 1 2 9999999999", "line 4: corner 9999999999: there are 3 vertices"),
            ("f 1 2 x", "line 4: corner `x`: expected an index, or indices between slashes"),
            ("f 1 2 3/x", "line 4: corner `3/x`: expected an index"),
        ] {
            let got = message(&format!("{vertices}{face}"));
            assert!(got.starts_with(expected), "{got}");
        }
    }
}
