//! NumPy arrays (`.npy`): two-dimensional arrays of bytes.
//!
//! Written as version 1.0, `|u1`, C order. Read in versions 1 to 3, `u1` or `b1`, C or Fortran
//! order. Linear in the size of the file; the shape must account for every byte of it, so that a
//! lying header costs nothing.

/// The first six bytes of every file.
const MAGIC: &[u8] = b"\x93NUMPY";

/// A matrix of bytes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NpyMatrix {
    /// The number of rows.
    pub rows: usize,
    /// The number of columns.
    pub columns: usize,
    /// The entries, row by row.
    pub entries: Vec<u8>,
}

/// What is wrong with an array file, and where.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("byte {offset}: {kind}")]
pub struct NpyError {
    /// The byte offset, counted from 0.
    pub offset: usize,
    /// The rule broken.
    pub kind: NpyErrorKind,
}

/// The rules of an array file.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NpyErrorKind {
    /// The file does not begin as every array does.
    #[error("not a NumPy array (the magic is missing)")]
    Magic,
    /// A version that does not exist.
    #[error("format version {0}, expected 1, 2 or 3")]
    Version(u8),
    /// The file ends inside its header.
    #[error("the file ends inside the header")]
    HeaderEnds,
    /// The header is not the dictionary it should be.
    #[error("expected {0} in the header")]
    Header(&'static str),
    /// Entries of another type.
    #[error("entries of type `{0}`, expected unsigned bytes (`|u1`) or truth values (`|b1`)")]
    Type(String),
    /// Not two-dimensional.
    #[error("an array of {0} dimensions, expected 2")]
    Dimensions(usize),
    /// The shape does not account for the bytes that follow.
    #[error("{rows} x {columns} entries expected, got {got} bytes")]
    Size {
        /// The number of rows.
        rows: u64,
        /// The number of columns.
        columns: u64,
        /// The number of bytes after the header.
        got: usize,
    },
}

impl NpyMatrix {
    /// Whether `bytes` begin as an array file does.
    pub fn is_npy(bytes: &[u8]) -> bool {
        bytes.starts_with(MAGIC)
    }

    /// Reads an array file.
    ///
    /// # Errors
    /// [`NpyError`] names the byte and the rule broken.
    pub fn read(bytes: &[u8]) -> Result<NpyMatrix, NpyError> {
        let fail = |offset, kind| Err(NpyError { offset, kind });
        if !NpyMatrix::is_npy(bytes) {
            return fail(0, NpyErrorKind::Magic);
        }
        let ends = NpyError { offset: bytes.len(), kind: NpyErrorKind::HeaderEnds };
        let version = *bytes.get(6).ok_or_else(|| ends.clone())?;
        let field = match version {
            1 => 2,
            2 | 3 => 4,
            _ => return fail(6, NpyErrorKind::Version(version)),
        };
        let length = bytes.get(8..8 + field).ok_or_else(|| ends.clone())?;
        let length = length.iter().rev().fold(0usize, |sum, &byte| sum << 8 | usize::from(byte));
        let start = 8 + field;
        let end = start.checked_add(length).filter(|&end| end <= bytes.len()).ok_or(ends)?;
        let header = Header::read(&bytes[start..end])
            .map_err(|(offset, kind)| NpyError { offset: start + offset, kind })?;
        let [rows, columns] = header.shape;
        let data = &bytes[end..];
        if rows.checked_mul(columns) != Some(data.len() as u64) {
            return fail(end, NpyErrorKind::Size { rows, columns, got: data.len() });
        }
        // No row, or no column: the other number is not bounded by the bytes.
        let (rows, columns) = (rows as usize, columns as usize);
        let entries = if header.fortran_order {
            let by_row = (0..rows).flat_map(|row| data.iter().skip(row).step_by(rows));
            if data.is_empty() { Vec::new() } else { by_row.copied().collect() }
        } else {
            data.to_vec()
        };
        Ok(NpyMatrix { rows, columns, entries })
    }

    /// The beginning of the file for a matrix of this shape, after which its entries follow row
    /// by row, a byte each.
    pub fn header(rows: usize, columns: usize) -> Vec<u8> {
        let text =
            format!("{{'descr': '|u1', 'fortran_order': False, 'shape': ({rows}, {columns}), }}");
        // The entries shall begin at a multiple of 64 bytes; a line end closes the header.
        let length = (MAGIC.len() + 4 + text.len() + 1).next_multiple_of(64) - MAGIC.len() - 4;
        let mut header = MAGIC.to_vec();
        header.extend_from_slice(&[1, 0]);
        header.extend_from_slice(&(length as u16).to_le_bytes());
        header.extend_from_slice(text.as_bytes());
        header.resize(MAGIC.len() + 4 + length - 1, b' ');
        header.push(b'\n');
        header
    }
}

/// The three entries of the header's dictionary.
struct Header {
    fortran_order: bool,
    shape: [u64; 2],
}

/// An offset into the header, and the rule broken there.
type HeaderError = (usize, NpyErrorKind);

impl Header {
    /// Reads a Python dictionary with the keys `descr`, `fortran_order` and `shape`, in any order.
    fn read(text: &[u8]) -> Result<Header, HeaderError> {
        let mut text = Cursor { text, offset: 0 };
        let (mut typed, mut fortran_order, mut shape) = (false, None, None);
        text.expect(b'{', "a dictionary")?;
        while !text.take(b'}') {
            let key = text.quoted("a key in quotes")?;
            text.expect(b':', "a colon after the key")?;
            match key {
                b"descr" => {
                    let at = text.offset;
                    let descr = text.quoted("a type in quotes")?;
                    if !matches!(descr, [b'|' | b'<' | b'>' | b'=', b'u' | b'b', b'1']) {
                        let descr = String::from_utf8_lossy(descr).into_owned();
                        return Err((at, NpyErrorKind::Type(descr)));
                    }
                    typed = true;
                }
                b"fortran_order" => fortran_order = Some(text.truth()?),
                b"shape" => shape = Some(text.shape()?),
                _ => return Err(text.error("only descr, fortran_order and shape")),
            }
            if !text.take(b',') {
                text.expect(b'}', "the end of the dictionary")?;
                break;
            }
        }
        text.skip_blanks();
        if text.offset < text.text.len() {
            return Err(text.error("nothing but blanks after the dictionary"));
        }
        match (typed, fortran_order, shape) {
            (true, Some(fortran_order), Some(shape)) => Ok(Header { fortran_order, shape }),
            _ => Err(text.error("all of descr, fortran_order and shape")),
        }
    }
}

struct Cursor<'a> {
    text: &'a [u8],
    offset: usize,
}

impl<'a> Cursor<'a> {
    fn error(&self, expected: &'static str) -> HeaderError {
        (self.offset, NpyErrorKind::Header(expected))
    }

    fn rest(&self) -> &'a [u8] {
        &self.text[self.offset..]
    }

    fn skip_blanks(&mut self) {
        self.offset += self.rest().iter().take_while(|byte| byte.is_ascii_whitespace()).count();
    }

    fn take(&mut self, byte: u8) -> bool {
        self.skip_blanks();
        let found = self.rest().first() == Some(&byte);
        self.offset += usize::from(found);
        found
    }

    fn expect(&mut self, byte: u8, expected: &'static str) -> Result<(), HeaderError> {
        if self.take(byte) { Ok(()) } else { Err(self.error(expected)) }
    }

    fn quoted(&mut self, expected: &'static str) -> Result<&'a [u8], HeaderError> {
        let quote = if self.take(b'\'') {
            b'\''
        } else if self.take(b'"') {
            b'"'
        } else {
            return Err(self.error(expected));
        };
        let rest = self.rest();
        match rest.iter().position(|&byte| byte == quote) {
            Some(length) => {
                self.offset += length + 1;
                Ok(&rest[..length])
            }
            None => Err(self.error("a closing quote")),
        }
    }

    fn truth(&mut self) -> Result<bool, HeaderError> {
        self.skip_blanks();
        for (word, value) in [("False", false), ("True", true)] {
            if self.rest().starts_with(word.as_bytes()) {
                self.offset += word.len();
                return Ok(value);
            }
        }
        Err(self.error("True or False"))
    }

    fn shape(&mut self) -> Result<[u64; 2], HeaderError> {
        self.expect(b'(', "a shape in parentheses")?;
        let start = self.offset;
        let (mut shape, mut dimensions) = ([0; 2], 0);
        while !self.take(b')') {
            let number = self.number()?;
            if let Some(slot) = shape.get_mut(dimensions) {
                *slot = number;
            }
            dimensions += 1;
            if !self.take(b',') {
                self.expect(b')', "the end of the shape")?;
                break;
            }
        }
        match dimensions {
            2 => Ok(shape),
            _ => Err((start, NpyErrorKind::Dimensions(dimensions))),
        }
    }

    fn number(&mut self) -> Result<u64, HeaderError> {
        self.skip_blanks();
        let digits = self.rest().iter().take_while(|byte| byte.is_ascii_digit()).count();
        let text = std::str::from_utf8(&self.rest()[..digits]).unwrap_or_default();
        let number = text.parse().map_err(|_| self.error("a number of 64 bits"))?;
        self.offset += digits;
        Ok(number)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file(version: u8, header: &str, data: &[u8]) -> Vec<u8> {
        let mut bytes = MAGIC.to_vec();
        bytes.extend_from_slice(&[version, 0]);
        let length = (header.len() as u32).to_le_bytes();
        bytes.extend_from_slice(if version == 1 { &length[..2] } else { &length });
        bytes.extend_from_slice(header.as_bytes());
        bytes.extend_from_slice(data);
        bytes
    }

    #[test]
    fn what_is_written_reads_back() {
        for (rows, columns) in [(0, 0), (1, 1), (2, 3), (300, 2)] {
            let entries: Vec<u8> = (0..rows * columns).map(|i| i as u8).collect();
            let mut bytes = NpyMatrix::header(rows, columns);
            assert_eq!(bytes.len() % 64, 0);
            bytes.extend_from_slice(&entries);
            assert_eq!(NpyMatrix::read(&bytes), Ok(NpyMatrix { rows, columns, entries }));
        }
    }

    #[test]
    fn every_version_and_order_is_read() {
        let row_by_row = NpyMatrix { rows: 2, columns: 3, entries: vec![1, 2, 3, 4, 5, 6] };
        for version in 1..=3 {
            let c = "{'descr': '|u1', 'fortran_order': False, 'shape': (2, 3), }\n";
            assert_eq!(
                NpyMatrix::read(&file(version, c, &[1, 2, 3, 4, 5, 6])),
                Ok(row_by_row.clone())
            );
            let fortran = "{\"shape\":(2,3),'fortran_order':True,'descr':'|b1'}";
            let read = NpyMatrix::read(&file(version, fortran, &[1, 4, 2, 5, 3, 6]));
            assert_eq!(read, Ok(row_by_row.clone()));
        }
    }

    #[test]
    fn a_broken_header_is_named() {
        let good = "{'descr': '|u1', 'fortran_order': False, 'shape': (1, 2), }";
        let cases = [
            (good.replace("|u1", "<f8"), "entries of type `<f8`"),
            (good.replace("(1, 2)", "(2,)"), "an array of 1 dimensions"),
            (good.replace("(1, 2)", "(1, 1, 2)"), "an array of 3 dimensions"),
            (good.replace("(1, 2)", "(1, 3)"), "1 x 3 entries expected, got 2 bytes"),
            (good.replace("(1, 2)", "(-1, 2)"), "a number of 64 bits"),
            (good.replace("(1, 2)", "(99999999999999999999, 2)"), "a number of 64 bits"),
            (
                good.replace("(1, 2)", "(18446744073709551615, 18446744073709551615)"),
                "entries expected, got 2 bytes",
            ),
            (good.replace("'shape'", "'form'"), "only descr, fortran_order and shape"),
            (good.replace("'shape': (1, 2), ", ""), "all of descr, fortran_order and shape"),
            (good.replace("False", "0"), "True or False"),
            (good.replace('}', ""), "a key in quotes"),
            (good.replace('{', ""), "a dictionary"),
            (format!("{good}x"), "nothing but blanks"),
        ];
        assert!(NpyMatrix::read(&file(1, good, &[0, 1])).is_ok());
        for (header, expected) in cases {
            let error = NpyMatrix::read(&file(1, &header, &[0, 1])).unwrap_err().to_string();
            assert!(error.contains(expected), "{header}: {error}");
        }
        let good = file(2, good, &[0, 1]);
        for end in 0..good.len() {
            assert!(NpyMatrix::read(&good[..end]).is_err(), "{end}");
        }
        let mut version = good.clone();
        version[6] = 4;
        assert!(NpyMatrix::read(&version).unwrap_err().to_string().contains("format version 4"));
    }
}
