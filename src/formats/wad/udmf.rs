//! Maps as text, the Universal Doom Map Format.
//!
//! ```text
//! namespace = "zdoom";                 // an assignment
//! vertex { x = -64.5; y = 128; }       /* a block of assignments */
//! linedef { v1 = 0; v2 = 1; sidefront = 0; sideback = 1; twosided = true; }
//! sidedef { sector = 0; }   sector { }
//! ```
//!
//! Names are in any case. Blocks and fields that visibility does not depend on are read over; of a
//! field given twice the last value counts.

use super::archive::MapLumps;
use super::{DoomMap, Linedef, MAX_SECTORS, MapForm, WadError, WadErrorKind, WadPlace};
use crate::num::Number;

/// Reads a map.
///
/// # Errors
/// [`WadError`] names the line and the rule broken.
pub(super) fn read(lumps: &MapLumps<'_, '_>, text: &[u8]) -> Result<DoomMap, WadError> {
    let mut reader = Reader { text, at: 0, line: 1 };
    let mut blocks = Blocks::default();
    let at_line = |line| WadPlace::Line { map: lumps.name.to_owned(), line };
    if let Err(kind) = reader.read(&mut blocks) {
        return Err(WadError { place: at_line(reader.line), kind });
    }
    if blocks.sectors > MAX_SECTORS {
        return Err(lumps.error(WadErrorKind::TooManySectors { got: blocks.sectors }));
    }
    let (sidedefs, sidedef_lines): (Vec<u32>, Vec<usize>) = blocks.sidedefs.into_iter().unzip();
    let map = DoomMap {
        name: lumps.name.to_owned(),
        form: MapForm::Udmf,
        vertices: blocks.vertices,
        linedefs: blocks.linedefs,
        sidedefs,
        sectors: blocks.sectors,
        reject: lumps.find("REJECT").map(<[u8]>::to_vec),
    };
    map.check_indices(|lump, record| {
        at_line(match lump {
            "SIDEDEFS" => sidedef_lines[record],
            _ => map.linedefs[record].line.unwrap_or(0),
        })
    })?;
    Ok(map)
}

/// What the blocks say.
#[derive(Default)]
struct Blocks {
    vertices: Vec<[Number; 2]>,
    linedefs: Vec<Linedef>,
    /// Each with its line.
    sidedefs: Vec<(u32, usize)>,
    sectors: usize,
}

/// A piece of the text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Token<'a> {
    /// A name, a number, `true` or `false`.
    Word(&'a str),
    /// What stands in quotation marks.
    Text,
    /// One of `{}=;`.
    Mark(u8),
}

impl Token<'_> {
    fn describe(token: Option<Token<'_>>) -> String {
        match token {
            Some(Token::Word(word)) => format!("`{}`", excerpt(word)),
            Some(Token::Text) => "a text in quotation marks".to_owned(),
            Some(Token::Mark(mark)) => format!("`{}`", char::from(mark)),
            None => "the end of the text".to_owned(),
        }
    }
}

fn excerpt(text: &str) -> String {
    text.escape_debug().take(32).collect()
}

struct Reader<'a> {
    text: &'a [u8],
    at: usize,
    /// The line at `at`, counted from 1.
    line: usize,
}

impl<'a> Reader<'a> {
    /// Reads all blocks; an error is of the line that the reader has come to.
    fn read(&mut self, blocks: &mut Blocks) -> Result<(), WadErrorKind> {
        while let Some(token) = self.token()? {
            let Token::Word(name) = token else {
                return Err(expected("the name of a block or a field", Some(token)));
            };
            let line = self.line;
            match self.token()? {
                Some(Token::Mark(b'=')) => {
                    self.value()?;
                }
                Some(Token::Mark(b'{')) => match name.to_ascii_lowercase().as_str() {
                    "vertex" => blocks.vertices.push(self.vertex(line)?),
                    "linedef" => blocks.linedefs.push(self.linedef(line)?),
                    "sidedef" => blocks.sidedefs.push((self.sidedef(line)?, line)),
                    "sector" => {
                        self.fields(|_, _| Ok(()))?;
                        blocks.sectors += 1;
                    }
                    _ => self.fields(|_, _| Ok(()))?,
                },
                other => return Err(expected("`{` or `=`", other)),
            }
        }
        Ok(())
    }

    fn vertex(&mut self, line: usize) -> Result<[Number; 2], WadErrorKind> {
        let (mut x, mut y) = (None, None);
        self.fields(|name, value| {
            match name {
                "x" => x = Some(coordinate("x", value)?),
                "y" => y = Some(coordinate("y", value)?),
                _ => {}
            }
            Ok(())
        })?;
        let x = self.required(x, "vertex", "x", line)?;
        Ok([x, self.required(y, "vertex", "y", line)?])
    }

    fn linedef(&mut self, line: usize) -> Result<Linedef, WadErrorKind> {
        let (mut start, mut end, mut front, mut back) = (None, None, None, None);
        let mut is_flagged_two_sided = false;
        self.fields(|name, value| {
            match name {
                "v1" => start = Some(index("v1", value)?),
                "v2" => end = Some(index("v2", value)?),
                "sidefront" => front = side("sidefront", value)?,
                "sideback" => back = side("sideback", value)?,
                "twosided" => {
                    is_flagged_two_sided =
                        matches!(value, Token::Word(word) if word.eq_ignore_ascii_case("true"));
                }
                _ => {}
            }
            Ok(())
        })?;
        let start = self.required(start, "linedef", "v1", line)?;
        let end = self.required(end, "linedef", "v2", line)?;
        Ok(Linedef { start, end, is_flagged_two_sided, front, back, line: Some(line) })
    }

    fn sidedef(&mut self, line: usize) -> Result<u32, WadErrorKind> {
        let mut sector = None;
        self.fields(|name, value| {
            if name == "sector" {
                sector = Some(index("sector", value)?);
            }
            Ok(())
        })?;
        self.required(sector, "sidedef", "sector", line)
    }

    /// What the block that begins at `line` must have said.
    fn required<T>(
        &mut self,
        value: Option<T>,
        block: &'static str,
        field: &'static str,
        line: usize,
    ) -> Result<T, WadErrorKind> {
        value.ok_or_else(|| {
            self.line = line;
            WadErrorKind::MissingField { block, field }
        })
    }

    /// The assignments of a block and its closing brace, each given to `take` with its name in
    /// lower case.
    fn fields(
        &mut self,
        mut take: impl FnMut(&str, Token<'a>) -> Result<(), WadErrorKind>,
    ) -> Result<(), WadErrorKind> {
        loop {
            match self.token()? {
                Some(Token::Mark(b'}')) => return Ok(()),
                Some(Token::Word(name)) => {
                    match self.token()? {
                        Some(Token::Mark(b'=')) => {}
                        other => return Err(expected("`=`", other)),
                    }
                    let value = self.value()?;
                    take(&name.to_ascii_lowercase(), value)?;
                }
                other => return Err(expected("a field or `}`", other)),
            }
        }
    }

    /// A value and its semicolon.
    fn value(&mut self) -> Result<Token<'a>, WadErrorKind> {
        let value = match self.token()? {
            Some(value @ (Token::Word(_) | Token::Text)) => value,
            other => return Err(expected("a value", other)),
        };
        match self.token()? {
            Some(Token::Mark(b';')) => Ok(value),
            other => Err(expected("`;`", other)),
        }
    }

    fn token(&mut self) -> Result<Option<Token<'a>>, WadErrorKind> {
        self.skip_blanks()?;
        let rest = &self.text[self.at..];
        let Some(&first) = rest.first() else { return Ok(None) };
        match first {
            b'{' | b'}' | b'=' | b';' => {
                self.at += 1;
                Ok(Some(Token::Mark(first)))
            }
            b'"' => {
                self.at += 1;
                self.skip_text()?;
                Ok(Some(Token::Text))
            }
            _ => {
                let ends = |at: &usize| match rest[*at] {
                    b'/' => matches!(rest.get(at + 1), Some(b'/' | b'*')),
                    byte => !byte.is_ascii_graphic() || b"{}();\"'=".contains(&byte),
                };
                let length = (0..rest.len()).find(ends).unwrap_or(rest.len());
                let word = std::str::from_utf8(&rest[..length]).unwrap_or_default();
                if word.is_empty() {
                    return Err(WadErrorKind::NotText(first));
                }
                self.at += length;
                Ok(Some(Token::Word(word)))
            }
        }
    }

    /// Goes past blanks and comments.
    fn skip_blanks(&mut self) -> Result<(), WadErrorKind> {
        loop {
            let rest = &self.text[self.at..];
            if rest.starts_with(b"//") {
                self.at += rest.iter().take_while(|&&byte| byte != b'\n').count();
            } else if rest.starts_with(b"/*") {
                let Some(length) = rest[2..].windows(2).position(|pair| pair == b"*/") else {
                    return Err(expected("`*/`", None));
                };
                self.line += rest[..2 + length].iter().filter(|&&byte| byte == b'\n').count();
                self.at += length + 4;
            } else if rest.first().is_some_and(|byte| byte.is_ascii_whitespace() || *byte == 0xb) {
                self.line += usize::from(rest[0] == b'\n');
                self.at += 1;
            } else {
                return Ok(());
            }
        }
    }

    /// Goes past a text and its closing quotation mark; `\` keeps one from closing it.
    fn skip_text(&mut self) -> Result<(), WadErrorKind> {
        while let Some(&byte) = self.text.get(self.at) {
            self.at += 1;
            match byte {
                b'"' => return Ok(()),
                b'\\' if matches!(self.text.get(self.at), Some(b'"' | b'\\')) => self.at += 1,
                b'\n' => self.line += 1,
                _ => {}
            }
        }
        Err(expected("a quotation mark", None))
    }
}

fn expected(expected: &'static str, got: Option<Token<'_>>) -> WadErrorKind {
    WadErrorKind::Expected { expected, got: Token::describe(got) }
}

fn coordinate(field: &'static str, value: Token<'_>) -> Result<Number, WadErrorKind> {
    match value {
        Token::Word(word) => Number::parse(word).map_err(|source| {
            let got = excerpt(word);
            WadErrorKind::Coordinate { field, got, source }
        }),
        other => Err(expected("a number", Some(other))),
    }
}

fn index(field: &'static str, value: Token<'_>) -> Result<u32, WadErrorKind> {
    let Token::Word(word) = value else { return Err(expected("an index", Some(value))) };
    let number = match word.strip_prefix("0x").or_else(|| word.strip_prefix("0X")) {
        Some(digits) => u32::from_str_radix(digits, 16),
        None => word.parse(),
    };
    number.map_err(|_| WadErrorKind::Index { field, got: excerpt(word) })
}

/// The index of a sidedef; -1 is none.
fn side(field: &'static str, value: Token<'_>) -> Result<Option<u32>, WadErrorKind> {
    match value {
        Token::Word("-1") => Ok(None),
        value => index(field, value).map(Some),
    }
}
