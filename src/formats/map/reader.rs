//! The reader: a token at a time, with what is open kept for the message of an end that comes
//! too soon.

use super::{MAX_FACES, MapBrush, MapEntity, MapError, MapErrorKind, MapFace, MapFile, MapFlags};
use crate::num::Number;

/// Reads a level's source.
///
/// # Errors
/// [`MapError`] names the line and the rule broken.
pub fn read(bytes: &[u8]) -> Result<MapFile, MapError> {
    // Some editors mark UTF-8 by three bytes.
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let mut reader = Reader { bytes, at: 0, line: 1, open: Vec::new() };
    let mut entities = Vec::new();
    while let Some(byte) = reader.peek() {
        if byte != b'{' {
            return Err(reader.expected("`{` of an entity"));
        }
        entities.push(reader.entity()?);
    }
    if entities.is_empty() {
        return Err(reader.error(MapErrorKind::Empty));
    }
    Ok(MapFile { entities })
}

/// How far the bytes have been read.
struct Reader<'a> {
    bytes: &'a [u8],
    at: usize,
    /// The line of `at`, counted from 1.
    line: usize,
    /// What has been opened and not closed, with its line.
    open: Vec<(&'static str, usize)>,
}

impl Reader<'_> {
    /// `{ pairs, brushes and patches in any order }`.
    fn entity(&mut self) -> Result<MapEntity, MapError> {
        let line = self.line;
        let mut entity =
            MapEntity { line, pairs: Vec::new(), brushes: Vec::new(), patches: Vec::new() };
        self.open_brace("entity");
        loop {
            match self.peek() {
                Some(b'"') => {
                    let key = self.quoted()?;
                    if self.peek() != Some(b'"') {
                        return Err(self.expected("the value of a key in quotation marks"));
                    }
                    entity.pairs.push((key, self.quoted()?));
                }
                Some(b'{') => self.brush_or_patch(&mut entity)?,
                Some(b'}') => {
                    self.close_brace();
                    return Ok(entity);
                }
                Some(_) | None => return Err(self.expected("a key in quotes, `{` or `}`")),
            }
        }
    }

    fn brush_or_patch(&mut self, entity: &mut MapEntity) -> Result<(), MapError> {
        let line = self.line;
        self.open_brace("brush");
        match self.peek() {
            Some(b'(' | b'}') => {
                let faces = self.faces()?;
                entity.brushes.push(MapBrush { line, faces });
                Ok(())
            }
            Some(byte) if byte.is_ascii_alphabetic() => {
                let name = self.word();
                let lower = name.to_ascii_lowercase();
                if lower.starts_with("patchdef") || lower.starts_with("patchterraindef") {
                    entity.patches.push((name, line));
                    return self.skip_patch();
                }
                if lower.starts_with("brushdef") {
                    return Err(self.error(MapErrorKind::Primitive(excerpt(&name))));
                }
                let expected = "`(` of a face, `}` or the name of a patch";
                let kind = MapErrorKind::Expected { expected, got: excerpt(&name) };
                Err(self.error(kind))
            }
            Some(_) | None => Err(self.expected("`(` of a face, `}` or the name of a patch")),
        }
    }

    /// The faces of a brush and its closing brace.
    fn faces(&mut self) -> Result<Vec<MapFace>, MapError> {
        let mut faces = Vec::new();
        loop {
            match self.peek() {
                Some(b'(') if faces.len() == MAX_FACES => {
                    return Err(self.error(MapErrorKind::TooManyFaces));
                }
                Some(b'(') => faces.push(self.face()?),
                Some(b'}') => {
                    self.close_brace();
                    return Ok(faces);
                }
                Some(_) | None => return Err(self.expected("`(` of a face, or `}`")),
            }
        }
    }

    fn face(&mut self) -> Result<MapFace, MapError> {
        let line = self.line;
        let points = [self.point(1)?, self.point(2)?, self.point(3)?];
        let texture = self.texture()?;
        self.alignment()?;
        let mut rest = Vec::new();
        while self.peek().is_some_and(|byte| !matches!(byte, b'(' | b'}')) {
            rest.push(self.number_read_over("a flag of the face, `(` or `}`")?);
        }
        // Three numbers are the flags of Quake 2 and 3; Hexen 2 has one number, others have more.
        let flags = match rest.as_slice() {
            [contents, surface, _] => match (flag(contents), flag(surface)) {
                (Some(contents), Some(surface)) => Some(MapFlags { contents, surface }),
                (None, _) | (_, None) => None,
            },
            _ => None,
        };
        Ok(MapFace { line, points, texture, flags })
    }

    /// `( x y z )`.
    fn point(&mut self, point: usize) -> Result<[Number; 3], MapError> {
        let opens = ["`(` of the first point", "`(` of the second point", "`(` of the third point"];
        self.punctuation(b'(', opens[point - 1])?;
        let mut numbers = Vec::with_capacity(3);
        while numbers.len() < 3 {
            let line = self.line_of_next();
            let got = self.bare_word("a coordinate")?;
            let number = Number::parse(&got).map_err(|source| {
                let got = excerpt(&got);
                MapError { line, kind: MapErrorKind::Coordinate { point, got, source } }
            })?;
            numbers.push(number);
        }
        self.punctuation(b')', "`)` after three coordinates")?;
        let [x, y, z] = numbers.try_into().unwrap_or_else(|_| unreachable!("three were read"));
        Ok([x, y, z])
    }

    /// A texture's name: up to the next blank, or in quotation marks.
    fn texture(&mut self) -> Result<String, MapError> {
        match self.peek() {
            Some(b'"') => self.quoted(),
            // A name may start with `{` or `[`, yet not be one of them alone.
            Some(b'(' | b')' | b'}') | None => Err(self.expected("a texture's name")),
            Some(_) => {
                let start = self.at;
                self.at += self.rest().iter().take_while(|byte| !is_blank(**byte)).count();
                let name = &self.bytes[start..self.at];
                if matches!(name, b"{" | b"[") {
                    self.at = start;
                    return Err(self.expected("a texture's name"));
                }
                Ok(String::from_utf8_lossy(name).into_owned())
            }
        }
    }

    /// How the texture is laid on, in either form.
    fn alignment(&mut self) -> Result<(), MapError> {
        let lone = if self.peek() == Some(b'[') {
            for _ in 0..2 {
                self.punctuation(b'[', "`[` of a texture axis")?;
                for _ in 0..4 {
                    self.number_read_over("a number of a texture axis")?;
                }
                self.punctuation(b']', "`]` after the four numbers of a texture axis")?;
            }
            3
        } else {
            5
        };
        for _ in 0..lone {
            self.number_read_over("a number of the texture's alignment")?;
        }
        Ok(())
    }

    /// A number that nothing depends on: `nan`, which some editors write there, is one too.
    fn number_read_over(&mut self, expected: &'static str) -> Result<String, MapError> {
        let (at, line) = (self.at, self.line);
        let word = self.bare_word(expected)?;
        let lower = word.trim_start_matches(['-', '+']).to_ascii_lowercase();
        let is_number = lower.starts_with(|c: char| c.is_ascii_digit() || c == '.')
            || lower.starts_with("nan")
            || lower.starts_with("inf");
        if !is_number {
            (self.at, self.line) = (at, line);
            return Err(self.expected(expected));
        }
        Ok(word)
    }

    /// A patch up to the brace that closes what holds it.
    fn skip_patch(&mut self) -> Result<(), MapError> {
        let mut depth = 1usize;
        while depth > 0 {
            match self.peek() {
                Some(b'{') => (self.at, depth) = (self.at + 1, depth + 1),
                Some(b'}') => (self.at, depth) = (self.at + 1, depth - 1),
                Some(b'"') => drop(self.quoted()?),
                Some(b'(' | b')' | b'[' | b']') => self.at += 1,
                Some(_) => drop(self.word()),
                None => return Err(self.expected("`}`")),
            }
        }
        self.open.pop();
        Ok(())
    }

    /// A text in quotation marks, which must end on its line.
    ///
    /// `\"` is a quotation mark inside of it, unless no other one follows on the line: then the
    /// backslash is the end of a path.
    fn quoted(&mut self) -> Result<String, MapError> {
        let rest = &self.bytes[self.at + 1..];
        let line = &rest[..rest.iter().position(|&byte| byte == b'\n').unwrap_or(rest.len())];
        let mut text = Vec::new();
        let mut at = 0;
        while at < line.len() {
            match line[at] {
                b'\\' if line.get(at + 1) == Some(&b'"') && line[at + 2..].contains(&b'"') => {
                    text.push(b'"');
                    at += 2;
                }
                b'"' => {
                    self.at += at + 2;
                    return Ok(String::from_utf8_lossy(&text).into_owned());
                }
                byte => {
                    text.push(byte);
                    at += 1;
                }
            }
        }
        Err(self.error(MapErrorKind::UnterminatedString))
    }

    fn bare_word(&mut self, expected: &'static str) -> Result<String, MapError> {
        match self.peek() {
            Some(b'(' | b')' | b'[' | b']' | b'{' | b'}' | b'"') | None => {
                Err(self.expected(expected))
            }
            Some(_) => Ok(self.word()),
        }
    }

    /// The bytes up to the next blank or punctuation mark.
    fn word(&mut self) -> String {
        let is_part =
            |byte: &&u8| !is_blank(**byte) && !matches!(byte, b'(' | b')' | b'[' | b']' | b'"');
        let start = self.at;
        self.at += self.rest().iter().take_while(is_part).count();
        String::from_utf8_lossy(&self.bytes[start..self.at]).into_owned()
    }

    fn punctuation(&mut self, mark: u8, expected: &'static str) -> Result<(), MapError> {
        if self.peek() != Some(mark) {
            return Err(self.expected(expected));
        }
        self.at += 1;
        Ok(())
    }

    fn open_brace(&mut self, what: &'static str) {
        self.open.push((what, self.line));
        self.at += 1;
    }

    fn close_brace(&mut self) {
        self.open.pop();
        self.at += 1;
    }

    /// The next byte that is neither a blank nor in a comment; `at` is moved to it.
    fn peek(&mut self) -> Option<u8> {
        loop {
            match self.rest() {
                [b'/', b'/', ..] => {
                    self.at += self.rest().iter().take_while(|&&byte| byte != b'\n').count();
                }
                [byte, ..] if is_blank(*byte) => {
                    self.line += usize::from(*byte == b'\n');
                    self.at += 1;
                }
                [byte, ..] => return Some(*byte),
                [] => return None,
            }
        }
    }

    fn line_of_next(&mut self) -> usize {
        self.peek();
        self.line
    }

    fn rest(&self) -> &[u8] {
        &self.bytes[self.at..]
    }

    fn error(&self, kind: MapErrorKind) -> MapError {
        MapError { line: self.line, kind }
    }

    /// Something else is due than what comes next.
    fn expected(&mut self, expected: &'static str) -> MapError {
        if self.peek().is_none() {
            let (what, opened) = self.open.last().copied().unwrap_or(("file", 1));
            return self.error(MapErrorKind::Ends { what, opened, expected });
        }
        let next = self.rest().iter().take_while(|&&byte| !is_blank(byte)).count();
        let got = excerpt(&String::from_utf8_lossy(&self.rest()[..next]));
        self.error(MapErrorKind::Expected { expected, got })
    }
}

/// A flag, which may be written with a sign where its highest bit is set.
fn flag(text: &str) -> Option<u32> {
    let value: i64 = text.parse().ok()?;
    i32::try_from(value).map(i32::cast_unsigned).or_else(|_| u32::try_from(value)).ok()
}

fn is_blank(byte: u8) -> bool {
    byte.is_ascii_whitespace() || byte == 0x0b
}

/// The start of a text, for a message.
fn excerpt(text: &str) -> String {
    let start: String = text.chars().take(24).flat_map(char::escape_debug).collect();
    if text.chars().count() > 24 { format!("{start}…") } else { start }
}
