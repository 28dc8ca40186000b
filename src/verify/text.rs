//! Lines, fields and numbers of the text, and its seal.

use super::exact::Four;
use num_bigint::BigInt;
use num_traits::Signed;
use sha2::{Digest, Sha256};
use std::io::BufRead;

/// What does not hold, in words; `verify` adds the line.
pub type Checked<T> = Result<T, String>;

/// Nothing, or what does not hold.
pub fn ensure(holds: bool, what: &str) -> Checked<()> {
    if holds { Ok(()) } else { Err(what.to_owned()) }
}

/// The lines of a proof, one after the other.
pub struct Reader<R> {
    pub input: R,
    pub line: String,
    /// The number of the current line, from 1.
    pub number: u64,
    /// Of all lines before the current one.
    pub hash: Sha256,
}

impl<R: BufRead> Reader<R> {
    /// The next line; there must be one.
    pub fn next(&mut self) -> Checked<Fields<'_>> {
        self.hash.update(&self.line);
        self.line.clear();
        self.number += 1;
        self.input.read_line(&mut self.line).map_err(|error| format!("cannot read: {error}"))?;
        let line = self.line.strip_suffix('\n').ok_or("the text ends before its time")?;
        Ok(Fields { rest: line })
    }

    /// The current line, the seal of all lines before it, after which nothing may follow.
    pub fn seal(&mut self) -> Checked<()> {
        let digest = std::mem::take(&mut self.hash).finalize();
        let digits: String = digest.iter().map(|byte| format!("{byte:02x}")).collect();
        ensure(self.line == format!("sha256 {digits}\n"), "the text is not what was sealed")?;
        let rest = self.input.fill_buf().map_err(|error| format!("cannot read: {error}"))?;
        ensure(rest.is_empty(), "the text goes on after its hash")
    }
}

/// The fields of a line that are still to be read.
pub struct Fields<'a> {
    pub rest: &'a str,
}

impl<'a> Fields<'a> {
    /// The next field, which stays; empty at the end.
    pub fn peek(&self) -> &'a str {
        self.rest.split(' ').next().unwrap_or("")
    }

    pub fn take(&mut self) -> Checked<&'a str> {
        let field = self.peek();
        ensure(!field.is_empty(), "expected one more field")?;
        let rest = self.rest[field.len()..].strip_prefix(' ');
        ensure(rest != Some(""), "a space at the end")?;
        self.rest = rest.unwrap_or("");
        Ok(field)
    }

    pub fn word(&mut self, word: &str) -> Checked<()> {
        ensure(self.take()? == word, &format!("expected {word:?}"))
    }

    pub fn end(&self) -> Checked<()> {
        ensure(self.rest.is_empty(), "more fields than expected")
    }

    /// An integer, written in the one way there is.
    pub fn integer(&mut self) -> Checked<BigInt> {
        let field = self.take()?;
        let number = field.parse().ok().filter(|number: &BigInt| number.to_string() == field);
        number.ok_or_else(|| format!("{field:?} is no integer"))
    }

    pub fn integers<const N: usize>(&mut self) -> Checked<[BigInt; N]> {
        let mut integers = std::array::from_fn(|_| BigInt::ZERO);
        for integer in &mut integers {
            *integer = self.integer()?;
        }
        Ok(integers)
    }

    pub fn positive(&mut self) -> Checked<BigInt> {
        let number = self.integer()?;
        ensure(number.is_positive(), "expected a positive number").map(|()| number)
    }

    /// X, Y, Z and W.
    pub fn point(&mut self) -> Checked<Four> {
        let [x, y, z] = self.integers()?;
        Ok([x, y, z, self.positive()?])
    }

    /// A number from 0 to below `end`.
    pub fn index(&mut self, end: usize) -> Checked<usize> {
        let index = usize::try_from(self.integer()?).ok().filter(|&index| index < end);
        index.ok_or_else(|| format!("expected a number from 0 to below {end}"))
    }

    /// Such numbers up to the next word, or the end of the line.
    pub fn indices(&mut self, end: usize) -> Checked<Vec<usize>> {
        let mut indices = Vec::new();
        while self.peek().starts_with(|first: char| first.is_ascii_digit()) {
            indices.push(self.index(end)?);
        }
        Ok(indices)
    }
}
